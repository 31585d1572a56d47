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
    fn object(&self) -> &dyn Object {
        match self {
            Self::Quadric(words) | Self::Patch(words) => words,
            Self::FirstGeneration(words) => words,
            Self::Polyhedron(words) => words,
            Self::Facet(words) => words,
            Self::Sphere(words) => words,
            Self::Cylinder(words) => words,
            Self::CurvedFacet(words) => words,
            Self::Quotient(words) => words,
            Self::Member(words) => &**words,
        }
    }

    fn words_mut(&mut self) -> &mut dyn Words {
        match self {
            Self::Quadric(words) | Self::Patch(words) => words,
            Self::FirstGeneration(words) => words,
            Self::Polyhedron(words) => words,
            Self::Facet(words) => words,
            Self::Sphere(words) => words,
            Self::Cylinder(words) => words,
            Self::CurvedFacet(words) => words,
            Self::Quotient(words) => words,
            Self::Member(words) => &mut **words,
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
    fn screen_box(&self) -> &ScreenBox {
        self.object().screen_box()
    }

    fn parts_mut(&mut self) -> Parts<'_> {
        self.words_mut().parts_mut()
    }
}

impl Object for ProcessorWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        match self {
            Self::Patch(words) => patch::at(words, x, y, format),
            _ => self.object().at(x, y, format),
        }
    }
}
