//! Coefficient words of an object.

use super::{Normal, ScreenBox};
use crate::raster::{Linear, Quadratic};
use imogene_hdl::{Bits, Value, bundle, bundles};

bundle! {
    /// Factors of the root in the normal.
    Factors(width) {
        kx: Int(width), "factor of the root in normal x";
        ky: Int(width), "factor of the root in normal y";
        kz: Int(width), "factor of the root in normal z";
    }
}

/// Widths of the words of an object.
#[derive(Clone, Copy, Debug)]
pub struct Widths {
    /// f1.
    pub linear: u32,
    /// f2.
    pub quadratic: u32,
    /// Gradients.
    pub gradient: u32,
    /// Normals and factors.
    pub normal: u32,
    /// Planes.
    pub plane: u32,
}

impl Widths {
    /// Bits of a load bus: those of the widest word, and of a word of the screen box.
    pub fn bus(&self) -> u32 {
        let words = [self.linear, self.quadratic, self.plane, self.gradient];
        words.into_iter().fold(24, u32::max)
    }
}

bundles! {
    /// Words of the normal of a quadric.
    #[derive(Copy)]
    Gradients {
        gx: Linear as "gx", "linear part of normal x";
        gy: Linear as "gy", "linear part of normal y";
        gz: Linear as "gz", "linear part of normal z";
        /// Factors of the root.
        factors: Factors as "";
    }

    /// Words of a quadric.
    #[derive(Copy)]
    Quadric {
        f1: Linear as "f1", "linear part of the depth";
        f2: Quadratic as "f2", "quadratic under the root";
        /// Words of its normal.
        gradients: Gradients as "";
        /// Where it may be.
        screen_box: ScreenBox as "";
        shift: Bits as "shift", "places the root is shifted right for the normal";
    }

    /// A cut plane.
    #[derive(Copy)]
    Plane {
        kind: Bits as "kind",
            "kind: 0 none, 1 front (keeps z >= zp), 2 back (keeps z <= zp), 3 perpendicular (keeps zp >= 0)";
        linear: Linear as "", "depth zp";
        /// Its normal.
        normal: Normal as "";
    }

    /// All words of an object.
    Words {
        /// The quadric itself.
        quadric: Quadric as "";
        object_class: Bits as "object_class", "class of the object: 0 side, 1 front, 2 patch, 3 prism";
        planes: Vec<Plane> as "plane", "plane #";
    }
}

impl Quadric {
    /// Words from outside of the design.
    pub fn input(widths: Widths) -> Quadric {
        let gradient = || Linear::input(widths.gradient);
        Quadric {
            f1: Linear::input(widths.linear),
            f2: Quadratic::input(widths.quadratic),
            gradients: Gradients {
                gx: gradient(),
                gy: gradient(),
                gz: gradient(),
                factors: Factors::input(widths.normal),
            },
            screen_box: ScreenBox::input(),
            shift: Bits::input(5),
        }
    }
}

impl Plane {
    /// Words from outside of the design.
    pub fn input(widths: Widths) -> Plane {
        Plane {
            kind: Bits::input(2),
            linear: Linear::input(widths.plane),
            normal: Normal::input(widths.normal),
        }
    }
}

impl Words {
    /// Words from outside of the design, with so many planes.
    pub fn input(widths: Widths, planes: usize) -> Words {
        Words {
            quadric: Quadric::input(widths),
            object_class: Bits::input(2),
            planes: (0..planes).map(|_| Plane::input(widths)).collect(),
        }
    }
}
