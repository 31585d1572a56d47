//! The words of any object processor, and the slots of a golden machine that has processors of every kind.

use super::curved_facet::CurvedFacetWords;
use super::cylinder::CylinderWords;
use super::facet::FacetWords;
use super::first_generation::FirstGenerationWords;
use super::line;
use super::polyhedron::PolyhedronWords;
use super::quadric::{ObjectPixel, QuadricWords, ScreenBox};
use super::quotient::QuotientWords;
use super::running::RunningProcessor;
use super::sphere::SphereWords;
use crate::format::Format;
use serde::Serialize;

/// Coefficient words of one object processor, which say what processor it is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum ProcessorWords {
    /// Quadric processor of the second generation.
    Quadric(QuadricWords),
    /// Patch processor.
    Patch(QuadricWords),
    /// Quadric processor of the first generation.
    FirstGeneration(FirstGenerationWords),
    /// Polyhedron processor.
    Polyhedron(PolyhedronWords),
    /// Facet processor.
    Facet(FacetWords),
    /// Sphere processor.
    Sphere(SphereWords),
    /// Cylinder processor.
    Cylinder(CylinderWords),
    /// Processor of non-planar facets.
    CurvedFacet(CurvedFacetWords),
    /// Processor of a quadric that the eye lies on.
    Quotient(QuotientWords),
}

/// A processor of a machine and the object of the scene that it draws a part of.
///
/// Slots are in the order of the objects; an object of several parts has as many slots, one after the other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slot {
    /// Index of the object in the scene: the id of its pixels.
    pub object: usize,
    /// Words of the processor.
    pub words: ProcessorWords,
}

impl ProcessorWords {
    /// Where the object can be on the screen.
    pub fn screen_box(&self) -> &ScreenBox {
        match self {
            Self::Quadric(words) | Self::Patch(words) => &words.screen_box,
            Self::FirstGeneration(words) => &words.screen_box,
            Self::Polyhedron(words) => &words.screen_box,
            Self::Facet(words) => &words.screen_box,
            Self::Sphere(words) => &words.screen_box,
            Self::Cylinder(words) => &words.screen_box,
            Self::CurvedFacet(words) => &words.screen_box,
            Self::Quotient(words) => &words.screen_box,
        }
    }

    /// The words for a zone of the screen.
    pub fn for_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> ProcessorWords {
        match self {
            Self::Quadric(words) => Self::Quadric(words.for_zone(x0, y0, width, height)),
            Self::Patch(words) => Self::Patch(words.for_zone(x0, y0, width, height)),
            Self::FirstGeneration(words) => {
                Self::FirstGeneration(words.for_zone(x0, y0, width, height))
            }
            Self::Polyhedron(words) => Self::Polyhedron(words.for_zone(x0, y0, width, height)),
            Self::Facet(words) => Self::Facet(words.for_zone(x0, y0, width, height)),
            Self::Sphere(words) => Self::Sphere(words.for_zone(x0, y0, width, height)),
            Self::Cylinder(words) => Self::Cylinder(words.for_zone(x0, y0, width, height)),
            Self::CurvedFacet(words) => Self::CurvedFacet(words.for_zone(x0, y0, width, height)),
            Self::Quotient(words) => Self::Quotient(words.for_zone(x0, y0, width, height)),
        }
    }

    /// The words on the lines `first, first + step, first + 2 step, ..` alone, which are counted 0, 1, 2, ..
    pub fn every_line(&self, step: i64, first: i64) -> ProcessorWords {
        match self {
            Self::Quadric(words) => Self::Quadric(words.every_line(step, first)),
            Self::Patch(words) => Self::Patch(words.every_line(step, first)),
            Self::FirstGeneration(words) => Self::FirstGeneration(words.every_line(step, first)),
            Self::Polyhedron(words) => Self::Polyhedron(words.every_line(step, first)),
            Self::Facet(words) => Self::Facet(words.every_line(step, first)),
            Self::Sphere(words) => Self::Sphere(words.every_line(step, first)),
            Self::Cylinder(words) => Self::Cylinder(words.every_line(step, first)),
            Self::CurvedFacet(words) => Self::CurvedFacet(words.every_line(step, first)),
            Self::Quotient(words) => Self::Quotient(words.every_line(step, first)),
        }
    }

    /// Calls `sink(x, pixel)` for every pixel of line `y` at which the object is present, left to right.
    pub fn for_each_present(
        &self,
        format: &Format,
        y: i64,
        mut sink: impl FnMut(i64, ObjectPixel),
    ) {
        if let Self::Quadric(words) = self {
            return line::for_each_present(words, format, y, sink);
        }
        let window = self.screen_box();
        if window.is_empty() || !(window.y0..=window.y1).contains(&y) {
            return;
        }
        // A zone of one line, which begins at the first column of the box.
        let line = self.for_zone(window.x0, y, window.x1 - window.x0 + 1, 1);
        let mut processor = RunningProcessor::zone_start(&line, format);
        for x in window.x0..=window.x1 {
            let pixel = processor.pixel();
            if pixel.zf < format.z_max() {
                sink(x, pixel);
            }
        }
    }
}
