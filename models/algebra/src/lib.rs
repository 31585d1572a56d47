//! Exact rationals, vectors and matrices, and what is computed with them.
//!
//! ```
//! use imogene_algebra::matrix::image;
//! use imogene_algebra::rational::{fraction, from_decimal, from_f64_exact, integer, round_half_up};
//! use imogene_algebra::vector::square;
//!
//! // A decimal is what is written, not the binary fraction beside it.
//! let tenth = from_decimal(0.1);
//! assert_eq!(tenth, fraction(1, 10));
//! assert_ne!(tenth, from_f64_exact(0.1));
//!
//! // Turned by an angle of the triangle with sides 3, 4 and 5, a vector keeps its length: 0.1^2 + 2^2 = 4.01.
//! let (cos, sin) = (fraction(3, 5), fraction(4, 5));
//! let turn = [[cos.clone(), -&sin], [sin, cos]];
//! let turned = image(&turn, &[tenth, integer(2)]);
//! assert_eq!(square(&turned), from_decimal(4.01));
//! assert_eq!(round_half_up(&fraction(-5, 2)), (-2).into());
//! ```

pub mod matrix;
pub mod rational;
pub mod vector;
pub mod whole;
