//! Arithmetic on single words and on vectors.

mod fifteenth;
mod logarithm;
mod network;
mod normalise;
mod product;
mod quotient;
mod reciprocal;
mod root_correction;
mod root_length;
mod root_rows;
mod segment_curve;
mod square;
mod square_root;
mod square_root_iterative;
mod square_root_leading;
mod square_root_linear;
mod square_root_non_restoring;
mod square_root_quadratic;
mod vector;

pub use logarithm::{
    LOGARITHM, LOGARITHM_OF_SUM, POWER_OF_TWO, logarithm, logarithm_of_square, logarithm_of_sum,
    power_of_two,
};
pub use network::Network;
pub use normalise::NORMALISED;
pub(crate) use normalise::shifted_by;
pub use product::{PRODUCT, product, product_latency};
pub(crate) use quotient::{quotient, quotient_clocks};
pub use reciprocal::reciprocal;
pub use square_root::{Root, square_root, square_root_rows};
pub use square_root_iterative::{Iterative, square_root_iterative};
pub use square_root_leading::square_root_leading;
pub use square_root_linear::square_root_linear;
pub use square_root_non_restoring::square_root_non_restoring;
pub use square_root_quadratic::square_root_quadratic;
pub use vector::{Full, SCALAR_PRODUCT, Vector, scalar_product, vector_normaliser};

/// What the radicand of every square root carries.
const RADICAND: &str = "number to take the root of";
