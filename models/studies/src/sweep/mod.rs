//! Sweeps: families of scenes in which one number goes to its extreme, each step measured against the exact picture.
//!
//! A sweep is a list of scenes built in memory from exact decimals. Every step is prepared, or refused with the message
//! that a user would see; what is drawn by the golden model is compared at every pixel with the exact reference, and
//! the error stands beside the bound that was proven before a pixel was drawn. Three rules hold at every step, or the
//! sweep fails: no error exceeds its bound; every pixel that shows another face than the truth was announced as
//! undecided; and where the format gives out the scene is refused.

mod contour;
mod families;
mod family;
pub mod grid;
pub mod measure;
mod naive;
mod plot;
mod record;
pub mod truth;

pub use families::{ALL, UnknownSweep, find, names};
pub use family::Sweep;
pub use measure::{Bounds, Figures, Observed, Ratios};
pub use plot::plot;
pub use record::Axis;
pub use record::{GivesOut, Notice, Record, SweepResult, section};
