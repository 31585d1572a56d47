//! How far a golden picture is from the truth, measured at every pixel.
//!
//! The [`Truth`] of a scene is solved once in exact integers and given in words of the base format with a fraction; a
//! [`Drawing`] is what the golden model draws in any format. [`measure`] compares the two. `docs/trade.md` defines
//! every figure.

mod drawing;
pub mod map;
mod pixel;
mod spread;
mod tally;
pub mod toggles;
mod truth;

pub use drawing::{Drawing, ZoneScene};
pub use pixel::{Back, Golden, PixelError, SameFace, cracks, pixel_errors};
pub use spread::{Class, Spread, histogram};
pub use tally::{Metrics, measure};
pub use truth::Truth;
