//! The family of square root networks: floor root and remainder of a radicand, or a bounded approximation (source:
//! 2.3.3, 4.1.2, B.10).
//!
//! Every member takes a radicand `X` of `2 K` bits and gives a root of `K` bits. The exact ones are the digit
//! recurrences [`restoring_root`], the non-restoring one and [`iterative`]; others give fewer digits of the exact root,
//! or start from a [`polynomial`] and approach the root by corrections.

mod exact;
pub mod iterative;
mod method;
pub mod polynomial;

pub use exact::{Root, fast_root, restoring_root};
pub use method::{Method, RootResult, root};
pub use polynomial::root_length;
