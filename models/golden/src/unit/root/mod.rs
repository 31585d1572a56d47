//! The family of square root networks: floor root and remainder of a radicand, or a bounded approximation (source:
//! 2.3.3, 4.1.2, B.10).
//!
//! Every member takes a radicand `X` of `2 K` bits and gives a root of `K` bits. The exact ones are the digit
//! recurrences [`restoring_root`], [`non_restoring`] and [`iterative`]; others give fewer digits of the exact root, or
//! start from a [`polynomial`] and approach the root by corrections.

mod fast;
pub mod iterative;
mod method;
pub mod non_restoring;
pub mod polynomial;
mod restoring;

pub use fast::fast_root;
pub use method::{Method, RootResult, root};
pub use polynomial::root_length;
pub use restoring::{Root, restoring_root};
