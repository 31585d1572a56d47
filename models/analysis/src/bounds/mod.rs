//! The check of a prepared scene: what it needs, what can go wrong, and how far the golden picture can be from the
//! true one.
//!
//! Every bound is derived, not sampled: from the rounding bounds of the coefficients
//! ([`imogene_prepare::RoundingBounds`]) and the integers at each pixel, or the truth itself. [`depth_bound`] and
//! [`normal_bound`] hold at every pixel at which golden and true picture see the same face; the pixels at which they
//! might not are counted and can be listed ([`Jury`]), whatever processor draws them.

pub mod accumulators;
mod check;
mod contour;
pub mod depth;
pub mod headroom;
mod jury;
mod kind;
mod light;
mod needs;
mod normal;
mod object;
pub mod outline;
pub mod quick;
mod report;
pub mod silhouette;
mod truth;
mod verdict;

pub use accumulators::{
    Accumulators, Increments, LinearIncrements, QuadraticIncrements, accumulators,
};
pub use check::{CheckReport, SceneBounds, Summary, Widths, check, undecided_pixels};
pub use depth::{DepthTerms, depth_bound, depth_terms, face_bound, worst_case};
pub use jury::Jury;
pub use kind::quadric_kind;
pub use needs::{ExactGuards, MachineNeeds, exact_guards, machine_needs};
pub use normal::{constant_normal_bound, normal_bound, quadric_sine};
pub use quick::{Failing, failing};
pub use report::{
    Detail, ObjectBounds, ObjectReport, PartsBounds, PartsReport, QuadricReport, Shows, Undecided,
};
pub use silhouette::displacement_at;
pub use truth::interval;
