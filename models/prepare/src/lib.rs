//! Preparation: from a framed scene to the coefficient words that the golden model and the hardware are loaded with.
//!
//! Exact rationals all the way, rounded once ([`rounding`]); every accumulator is proven to hold its value on the
//! object's screen box, or the object is refused by name ([`error`]).

mod again;
pub mod animator;
mod cell;
mod context;
mod curved_facet;
mod enclosure;
pub mod error;
pub mod extent;
mod first_generation;
pub mod forms;
mod framing;
mod known;
mod ledger;
mod located;
pub mod memory;
mod mesh;
mod object;
mod paraboloids;
pub mod perspective;
mod planes;
mod polyhedron;
mod prepared;
mod projected;
mod quotient;
mod range;
pub mod rounding;
mod run;
pub mod screen_box;
mod seams;
pub mod shader;
mod unseen;
pub mod volume;
mod witness;

pub use again::{Kept, Reuse, prepare_again};
pub use context::Options;
pub use framing::Framing;
pub use prepared::{
    ExactForms, Missing, NeededWidths, NeededWord, PreparedObject, PreparedParts, PreparedQuadric,
    PreparedScene, RoundingBounds,
};
pub use run::{prepare, prepare_for_roots, prepare_reporting, prepare_with, refused, steps};
pub use unseen::Seen;
