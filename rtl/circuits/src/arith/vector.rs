//! Vectors of three components.

use super::normalise::shifted;
use crate::rows::alike;
use imogene_hdl::{Bits, Bundle, Int, Value, bundles, module, net, ports};

alike! {
    /// A vector.
    Vector(width): [Int(width); 3] {
        x, "component x";
        y, "component y";
        z, "component z";
    }
}

bundles! {
    /// A vector in full words.
    #[derive(Copy)]
    Full {
        vector: Vector as "shifted", "the vector";
        places: Bits as "places", "how far it was shifted";
    }
}

/// Zeros at most above the leading one of the square of a vector in full words: its longest component is at least half
/// of what a word takes, and three squares are added.
pub(super) const SQUARE_ZEROS: u32 = 3;

/// Shifts a vector to the left until its longest component fills its word, by `N - 2` places at most; the zero vector
/// stays. Latency [`NORMALISED`](super::NORMALISED).
pub fn vector_normaliser(at: &str, vector: Vector) -> Full {
    module("vector_normaliser", at, vector, |vector| {
        let parts = vector.parts();
        let width = vector.x.width();
        // The bits that a component needs below its sign: those that differ from the sign.
        let needed = parts.map(|part| {
            let bits = part.slice(width - 2, 0);
            part.is_negative().select(!bits, bits)
        });
        net! { let magnitude = needed[0] | needed[1] | needed[2] | Bits::new(1, width - 1); }
        let full = shifted(parts.map(Int::bits).to_vec(), Some(magnitude), width - 2);
        Full {
            vector: Vector::of([0, 1, 2].map(|index| full.words[index].int())),
            places: full.places,
        }
    })
}

/// Latency of a scalar product: a register before the products, the products, one behind them, the sum of two, the sum
/// of all.
pub const SCALAR_PRODUCT: u32 = 5;

/// The scalar product of two vectors, with two bits more than a product of components. Latency [`SCALAR_PRODUCT`].
pub fn scalar_product(at: &str, a: Vector, b: Vector) -> Int {
    module("scalar_product", at, ports!(a, b), |(a, b)| {
        let (a, b) = (a.registered(), b.registered());
        net! {
            let product_x = (a.x * b.x).delay(2);
            let product_y = (a.y * b.y).delay(2);
            let product_z = (a.z * b.z).delay(2);
        }
        let wide = |product: Int| product.extend(product.width() + 2);
        net! {
            let kept_z = product_z.reg();
            let sum_xy = (wide(product_x) + wide(product_y)).reg();
        }
        ("product", (sum_xy + wide(kept_z)).reg())
    })
}
