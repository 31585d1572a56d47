//! Golden integer models of the units, object processors and machines of imogene.
//!
//! Each is written from the specification in `docs/architecture.md` and equals the hardware bit for bit and clock for
//! clock: [`unit`](mod@unit) has one file per unit, [`object`] the processors made of them, [`machine`] what stands
//! between the processors and the picture. [`format`](mod@format) has the widths of all words.
//!
//! ```
//! use imogene_golden::unit::pe1::{Linear, Pe1};
//!
//! // 3 x - 5 y + 7 on three lines of four pixels, by additions alone.
//! let mut pe1 = Pe1::object_start(&Linear::new(3, -5, 7), 24);
//! for y in 0..3 {
//!     for x in 0..4 {
//!         assert_eq!(pe1.pixel(), 3 * x - 5 * y + 7);
//!     }
//!     pe1.line_step();
//! }
//!
//! // As in the hardware, what leaves the word at one end comes back at the other.
//! let greatest = (1 << 23) - 1;
//! let mut pe1 = Pe1::object_start(&Linear::new(1, 0, greatest), 24);
//! assert_eq!([pe1.pixel(), pe1.pixel()], [greatest, -greatest - 1]);
//! ```

pub mod format;
pub mod machine;
pub mod object;
pub mod slots;
pub mod unit;
pub mod widths;
