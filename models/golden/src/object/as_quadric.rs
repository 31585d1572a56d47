//! One type of processor for everything: the words of other object and volume processors as those of a quadric
//! processor, exactly.
//!
//! A time-shared machine has processors of one type, which must take whatever object comes next. Each conversion gives
//! the same front depth, the same normal and the same presence at every pixel; back depth and face number too, but for
//! a facet, whose one face (number 2) becomes the faces 0 and 1 of a patch.

use super::facet::FacetWords;
use super::paraboloid::plane_guard;
use super::polyhedron::PolyhedronWords;
use super::quadric::{PlaneWords, QuadricWords};
use super::slot::ProcessorWords;
use super::volume::{VolumeQuadric, VolumeWords};
use crate::format::Format;
use crate::unit::cut_plane::PlaneKind;
use crate::unit::depth_interval::Class;
use crate::unit::normal::NormalWords;
use crate::unit::pe1::Linear;
use thiserror::Error;

/// Why words have no equal on a quadric processor.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum AsQuadricError {
    /// The processor computes something that a quadric processor cannot.
    #[error(
        "{0} cannot be drawn by a quadric processor; accepted are quadrics, patches, polyhedra and flat facets"
    )]
    Processor(&'static str),
    /// The chain is shorter than the planes of an object, or the sides of a facet.
    #[error("needs {0} planes; the processor has {1}")]
    Planes(usize, usize),
    /// Fewer guard bits of f1 than keep the depth of a facet at every pixel.
    #[error("the depth of a facet needs {0} guard bits of f1; the format has {1}")]
    GuardBits(u32, u32),
    /// Facets have no words of their own widths.
    #[error(
        "the words of a facet follow from the depth word; of other widths only g1 and g2 are accepted"
    )]
    Fitted,
}

impl ProcessorWords {
    /// The words with which a quadric processor of `planes` cut planes draws the object.
    pub fn on_quadric_processor(
        &self,
        format: &Format,
        planes: usize,
    ) -> Result<QuadricWords, AsQuadricError> {
        let other = |name| Err(AsQuadricError::Processor(name));
        let words = match self {
            Self::Quadric(words) => words.clone(),
            Self::Patch(words) => QuadricWords {
                class: Class::Patch,
                ..words.clone()
            },
            Self::Polyhedron(words) => polyhedron(words),
            Self::Facet(words) => facet(words, format)?,
            Self::Member(words) => words.own().clone(),
            Self::FirstGeneration(_) => return other("a quadric of the first generation"),
            Self::Sphere(_) => return other("a sphere by a paraboloid"),
            Self::Cylinder(_) => return other("a cylinder by a parabolic cylinder"),
            Self::CurvedFacet(_) => return other("a curved facet"),
            Self::Quotient(_) => return other("a quadric that the viewer lies on"),
        };
        fits(words.planes.len(), planes)?;
        Ok(words)
    }
}

impl VolumeWords {
    /// The words with which a volume processor that has a quadric and `planes` planes answers for the volume: planes
    /// alone are cut out of a quadric that is everywhere.
    pub fn on_quadric_processor(&self, planes: usize) -> Result<VolumeWords, AsQuadricError> {
        fits(self.planes.len(), planes)?;
        Ok(VolumeWords {
            quadric: self.quadric.or(Some(VolumeQuadric::EVERYWHERE)),
            ..self.clone()
        })
    }
}

fn fits(needed: usize, available: usize) -> Result<(), AsQuadricError> {
    if needed > available {
        return Err(AsQuadricError::Planes(needed, available));
    }
    Ok(())
}

/// The whole line of sight, cut by the faces: the chain finds what the polyhedron's trees find.
fn polyhedron(words: &PolyhedronWords) -> QuadricWords {
    QuadricWords {
        class: Class::Prism,
        screen_box: words.screen_box,
        planes: words.planes.clone(),
        ..QuadricWords::default()
    }
}

/// A patch whose root is 0 and whose sides are half-planes of the screen. The root takes no part in the normal, so the
/// linear parts are all of it.
fn facet(words: &FacetWords, format: &Format) -> Result<QuadricWords, AsQuadricError> {
    if !format.follows_depth_word() {
        return Err(AsQuadricError::Fitted);
    }
    let side = |edge: &Linear| PlaneWords::new(PlaneKind::Perpendicular, *edge, [0; 3]);
    Ok(QuadricWords {
        class: Class::Patch,
        screen_box: words.screen_box,
        f1: depth_of_facet(&words.depth, format)?,
        normal: NormalWords {
            g: words.normal,
            ..NormalWords::default()
        },
        planes: words.edges.iter().map(side).collect(),
        ..QuadricWords::default()
    })
}

/// A facet's depth in the units of f1. Both drop their places below a depth word downwards, so the last places may be
/// missing from f1 if they are zero in both increments: then the constant's take no part in any value.
fn depth_of_facet(depth: &Linear, format: &Format) -> Result<Linear, AsQuadricError> {
    let (places, available) = (plane_guard(format), format.guard_linear);
    let Linear { a, b, c } = *depth;
    if available >= places {
        let more = available - places;
        return Ok(Linear::new(a << more, b << more, c << more));
    }
    let zeros = (a | b).trailing_zeros().min(places);
    let needed = places - zeros;
    if needed > available {
        return Err(AsQuadricError::GuardBits(needed, available));
    }
    let less = places - available;
    Ok(Linear::new(a >> less, b >> less, c >> less))
}
