//! The normal unit: one of the possible normals, computed once from the number of the visible face
//! (source: 2.4.2; the sign error of its Exp. 9-11 cannot occur because the factor K_k carries its own sign).

use super::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE};
use super::pe1::Linear;
use crate::format::{Format, wrap64};
use serde::{Deserialize, Serialize};

/// Coefficients of the quadric's normal: `N_k = g_k(x, y) -+ K_k r`, minus on the near face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct NormalWords {
    /// Normal on the polar plane, three first-degree expressions of 24 bits in the base format.
    pub g: [Linear; 3],
    /// Change of the normal along the ray, three factors of 16 bits in the base format.
    pub k: [i16; 3],
    /// The root is shifted right by this much to one bit less than a component has.
    pub shift: u8,
}

impl NormalWords {
    /// The linear parts at a pixel of the zone.
    pub fn linear_at(&self, x: i64, y: i64, format: &Format) -> [i64; 3] {
        let width = format.normal_linear;
        self.g.each_ref().map(|g| g.wrapped_at(x, y, width) as i64)
    }
}

/// Width of g in the base format.
pub const LINEAR_WIDTH: u32 = 24;

/// Normal of the near end's cap, towards the viewer, in the base format.
pub const NEAR_END_NORMAL: [i16; 3] = [0, 0, -32767];

/// The normal of the face `number` at a pixel where the linear parts are `g` and the root is `root`.
#[inline]
pub fn select(
    number: u8,
    present: bool,
    g: [i64; 3],
    root: i64,
    words: &NormalWords,
    planes: &[[i16; 3]],
    format: &Format,
) -> [i16; 3] {
    match number {
        _ if !present => [0; 3],
        FACE_NEAR | FACE_FAR => {
            let shifted = (root >> words.shift) & i64::from(format.greatest_normal());
            std::array::from_fn(|k| {
                let product = i64::from(words.k[k]) * shifted;
                let is_near = number == FACE_NEAR;
                let change = if is_near { -product } else { product } >> format.product_fraction();
                let sum = wrap64(g[k] + change, format.normal_linear);
                (sum >> Format::NORMAL_FRACTION) as i16
            })
        }
        FACE_NEAR_END => [0, 0, -format.greatest_normal()],
        _ => {
            let plane = planes.get(usize::from(number - FACE_PLANE));
            plane.copied().unwrap_or([0; 3])
        }
    }
}
