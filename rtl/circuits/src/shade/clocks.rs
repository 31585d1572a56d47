//! Clocks at which a result of the shading processor is there, after its pixel is in registers. Section 8.3 of the
//! architecture.

use crate::arith::{
    LOGARITHM, LOGARITHM_OF_SUM, NORMALISED, POWER_OF_TWO, PRODUCT, SCALAR_PRODUCT,
};

/// Line of sight, normal and vectors to the lights in full words.
pub(super) const VECTORS: u32 = PRODUCT + 1 + NORMALISED;
/// Scalar products.
pub(super) const PRODUCTS: u32 = VECTORS + SCALAR_PRODUCT;
/// Logarithms of scalar products.
pub(super) const LOGARITHMS: u32 = PRODUCTS + LOGARITHM;
/// What the highlight loses, without its exponent: behind the cosine, its logarithm, a sum and a clamp.
pub(super) const HIGHLIGHT: u32 = LOGARITHMS + PRODUCT + 3;
/// Attenuation, and exponent times highlight, which is there earlier.
pub(super) const LOSS: u32 = LOGARITHMS + 5 + LOGARITHM_OF_SUM;
/// Factors of the lights.
pub(super) const FACTORS: u32 = LOSS + 2 + POWER_OF_TWO;
