//! Any object processor, running over a zone.

use super::curved_facet::CurvedFacetProcessor;
use super::cylinder::CylinderProcessor;
use super::facet::FacetProcessor;
use super::first_generation::FirstGenerationProcessor;
use super::patch::PatchProcessor;
use super::polyhedron::PolyhedronProcessor;
use super::quadric::{ObjectPixel, QuadricProcessor};
use super::quotient::QuotientProcessor;
use super::slot::ProcessorWords;
use super::sphere::SphereProcessor;
use crate::format::Format;

/// A processor between two pixels: the registers of all its elementary processors.
#[derive(Clone, Debug)]
pub enum RunningProcessor {
    /// Quadric processor of the second generation.
    Quadric(QuadricProcessor),
    /// Patch processor.
    Patch(PatchProcessor),
    /// Quadric processor of the first generation.
    FirstGeneration(Box<FirstGenerationProcessor>),
    /// Polyhedron processor.
    Polyhedron(PolyhedronProcessor),
    /// Facet processor.
    Facet(FacetProcessor),
    /// Sphere processor.
    Sphere(Box<SphereProcessor>),
    /// Cylinder processor.
    Cylinder(Box<CylinderProcessor>),
    /// Processor of non-planar facets.
    CurvedFacet(CurvedFacetProcessor),
    /// Quotient processor.
    Quotient(Box<QuotientProcessor>),
}

impl RunningProcessor {
    /// Zone start: all elementary processors load their words; the next pixel is (0, 0) of the zone.
    pub fn zone_start(words: &ProcessorWords, format: &Format) -> RunningProcessor {
        match words {
            ProcessorWords::Quadric(words) => {
                Self::Quadric(QuadricProcessor::zone_start(words, format))
            }
            ProcessorWords::Patch(words) => Self::Patch(PatchProcessor::zone_start(words, format)),
            ProcessorWords::FirstGeneration(words) => Self::FirstGeneration(Box::new(
                FirstGenerationProcessor::zone_start(words, format),
            )),
            ProcessorWords::Polyhedron(words) => {
                Self::Polyhedron(PolyhedronProcessor::zone_start(words, format))
            }
            ProcessorWords::Facet(words) => Self::Facet(FacetProcessor::zone_start(words, format)),
            ProcessorWords::Sphere(words) => {
                Self::Sphere(Box::new(SphereProcessor::zone_start(words, format)))
            }
            ProcessorWords::Cylinder(words) => {
                Self::Cylinder(Box::new(CylinderProcessor::zone_start(words, format)))
            }
            ProcessorWords::CurvedFacet(words) => {
                Self::CurvedFacet(CurvedFacetProcessor::zone_start(words, format))
            }
            ProcessorWords::Quotient(words) => {
                Self::Quotient(Box::new(QuotientProcessor::zone_start(words, format)))
            }
        }
    }

    /// Line step: the next pixel is the first of the next line.
    pub fn line_step(&mut self) {
        match self {
            Self::Quadric(processor) => processor.line_step(),
            Self::Patch(processor) => processor.line_step(),
            Self::FirstGeneration(processor) => processor.line_step(),
            Self::Polyhedron(processor) => processor.line_step(),
            Self::Facet(processor) => processor.line_step(),
            Self::Sphere(processor) => processor.line_step(),
            Self::Cylinder(processor) => processor.line_step(),
            Self::CurvedFacet(processor) => processor.line_step(),
            Self::Quotient(processor) => processor.line_step(),
        }
    }

    /// What the processor hands on for the next pixel of the line.
    pub fn pixel(&mut self) -> ObjectPixel {
        match self {
            Self::Quadric(processor) => processor.pixel(),
            Self::Patch(processor) => processor.pixel(),
            Self::FirstGeneration(processor) => processor.pixel(),
            Self::Polyhedron(processor) => processor.pixel().front(),
            Self::Facet(processor) => processor.pixel(),
            Self::Sphere(processor) => processor.pixel(),
            Self::Cylinder(processor) => processor.pixel(),
            Self::CurvedFacet(processor) => processor.pixel(),
            Self::Quotient(processor) => processor.pixel(),
        }
    }
}
