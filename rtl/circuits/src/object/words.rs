//! Coefficient words of an object.

use super::half_space::HalfSpace;
use super::normal::Normal;
use super::screen_box::ScreenBox;
use super::widths::Widths;
use crate::raster::{Linear, Quadratic};
use crate::rows::alike;
use imogene_hdl::{Bits, bundles};

alike! {
    /// Factors of the root in the normal.
    Factors(width): [Int(width); 3] {
        kx, "factor of the root in normal x";
        ky, "factor of the root in normal y";
        kz, "factor of the root in normal z";
    }
}

bundles! {
    /// Words of the normal of a quadric.
    #[derive(Copy)]
    Gradients(widths: Widths) {
        gx: Linear(widths.gradient) as "gx", "linear part of normal x";
        gy: Linear(widths.gradient) as "gy", "linear part of normal y";
        gz: Linear(widths.gradient) as "gz", "linear part of normal z";
        /// Factors of the root.
        factors: Factors(widths.normal) as "";
    }

    /// Words of a quadric.
    #[derive(Copy)]
    Quadric(widths: Widths) {
        f1: Linear(widths.linear) as "f1", "linear part of the depth";
        f2: Quadratic(widths.quadratic) as "f2", "quadratic under the root";
        /// Words of its normal.
        gradients: Gradients(widths) as "";
        /// Where it may be.
        screen_box: ScreenBox() as "";
        shift: Bits(5) as "shift", "places the root is shifted right for the normal";
    }

    /// A cut plane.
    #[derive(Copy)]
    Plane(widths: Widths) {
        /// What it cuts.
        half_space: HalfSpace(widths) as "";
        /// Its normal.
        normal: Normal(widths.normal) as "";
    }

    /// All words of an object.
    Words(widths: Widths, planes: u32) {
        /// The quadric itself.
        quadric: Quadric(widths) as "";
        object_class: Bits(2) as "object_class", "class of the object: 0 side, 1 front, 2 patch, 3 prism";
        planes: [Plane(widths); planes] as "plane", "plane #";
    }
}
