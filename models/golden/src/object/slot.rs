//! The words of any object processor, and the slots of a golden machine that has processors of every kind.

use super::curved_facet::CurvedFacetWords;
use super::cylinder::CylinderWords;
use super::facet::FacetWords;
use super::first_generation::FirstGenerationWords;
use super::line;
use super::member::MemberWords;
use super::patch;
use super::polyhedron::PolyhedronWords;
use super::quadric::QuadricWords;
use super::quotient::QuotientWords;
use super::screen_box::ScreenBox;
use super::sphere::SphereWords;
use super::words::{Object, ObjectPixel, Parts, Words};
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
    /// Quadric processor of an object of a solid.
    Member(Box<MemberWords>),
}

/// A processor of a machine and the object of the scene that it draws a part of.
///
/// Slots are in the order of the objects; an object of several parts has as many slots, one after the other. Those of
/// transparent objects are the last, in the order of their blends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Slot {
    /// Index of the object in the scene: the id of its pixels.
    pub object: usize,
    /// Words of the processor.
    pub words: ProcessorWords,
    /// Of a transparent object, its part of what is seen, in 255ths.
    pub weight: Option<u8>,
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
            Self::Member(words) => &words.own().screen_box,
        }
    }

    /// Calls `sink(x, pixel)` for every pixel of line `y` at which the object is present, left to right.
    pub fn for_each_present(&self, format: &Format, y: i64, sink: impl FnMut(i64, ObjectPixel)) {
        let mut sink = sink;
        if let Self::Quadric(words) = self {
            return line::for_each_present(words, format, y, sink);
        }
        let window = self.screen_box();
        if window.is_empty() || !(window.y0..=window.y1).contains(&y) {
            return;
        }
        for x in window.x0..=window.x1 {
            let pixel = self.at(x, y, format);
            if pixel.zf < format.z_max() {
                sink(x, pixel);
            }
        }
    }
}

impl Words for ProcessorWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        match self {
            Self::Quadric(words) | Self::Patch(words) => words.parts_mut(),
            Self::FirstGeneration(words) => words.parts_mut(),
            Self::Polyhedron(words) => words.parts_mut(),
            Self::Facet(words) => words.parts_mut(),
            Self::Sphere(words) => words.parts_mut(),
            Self::Cylinder(words) => words.parts_mut(),
            Self::CurvedFacet(words) => words.parts_mut(),
            Self::Quotient(words) => words.parts_mut(),
            Self::Member(words) => words.parts_mut(),
        }
    }
}

impl Object for ProcessorWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        match self {
            Self::Quadric(words) => words.at(x, y, format),
            Self::Patch(words) => patch::at(words, x, y, format),
            Self::FirstGeneration(words) => words.at(x, y, format),
            Self::Polyhedron(words) => words.at(x, y, format),
            Self::Facet(words) => words.at(x, y, format),
            Self::Sphere(words) => words.at(x, y, format),
            Self::Cylinder(words) => words.at(x, y, format),
            Self::CurvedFacet(words) => words.at(x, y, format),
            Self::Quotient(words) => words.at(x, y, format),
            Self::Member(words) => words.at(x, y, format),
        }
    }
}
