//! Arithmetic on single words.

mod square_root;

pub use square_root::{Root, square_root};
