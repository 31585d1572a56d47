//! Golden integer models, exact references and scene preparation of imogene.
//!
//! The golden model ([`unit`](mod@unit), [`object`], [`machine`]) is written from the specification in `docs/architecture.md` and equals the
//! hardware bit for bit and clock for clock. The exact reference ([`exact`]) solves each pixel in big integers by another
//! route and is the truth that both are measured against. [`prepare`] turns a [`scene`] into the integer words that
//! golden model and hardware are loaded with.

pub mod animation;
pub mod check;
pub mod compare;
pub mod detail;
pub mod evaluate;
pub mod exact;
pub mod fit;
pub mod format;
pub mod machine;
pub mod metrics;
pub mod object;
pub mod picture;
pub mod prepare;
pub mod rational;
pub mod scene;
pub mod slots;
pub mod sweep;
pub mod text;
pub mod trade;
pub mod unit;
pub mod widths;
