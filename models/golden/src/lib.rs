//! Golden integer models of the units, object processors and machines of imogene.
//!
//! Each is written from the specification in `docs/architecture.md` and equals the hardware bit for bit and clock for
//! clock: [`unit`](mod@unit) has one file per unit, [`object`] the processors made of them, [`machine`] what stands
//! between the processors and the picture. [`format`](mod@format) has the widths of all words.

pub mod format;
pub mod machine;
pub mod object;
pub mod slots;
#[cfg(test)]
mod testing;
pub mod unit;
pub mod widths;
