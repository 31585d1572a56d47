//! Coefficient words of an object.

use crate::raster::{Linear, Quadratic};
use imogene_hdl::{bundle, bundles};

bundle! {
    /// Factors of the root in the normal.
    Factors(width) {
        kx: Int(width), "factor of the root in normal x";
        ky: Int(width), "factor of the root in normal y";
        kz: Int(width), "factor of the root in normal z";
    }

    /// Screen box and class.
    Place() {
        box_x0: Bits(12), "first column of the screen box";
        box_x1: Bits(12), "last column of the screen box";
        box_y0: Bits(12), "first line of the screen box";
        box_y1: Bits(12), "last line of the screen box";
        object_class: Bits(2), "class of the object";
        shift: Bits(5), "places the root is shifted for the normal";
    }

    /// A cut plane.
    Plane(width, normal) {
        kind: Bits(2), "kind of the plane";
        a: Int(width), "increment along the line";
        b: Int(width), "increment from line to line";
        c: Int(width), "value of the first pixel";
        nx: Int(normal), "normal x";
        ny: Int(normal), "normal y";
        nz: Int(normal), "normal z";
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

bundles! {
    /// All words of an object.
    Words {
        f1: Linear as "f1", "linear part of the depth";
        f2: Quadratic as "f2", "square of the root";
        gx: Linear as "gx", "normal x";
        gy: Linear as "gy", "normal y";
        gz: Linear as "gz", "normal z";
        factors: Factors as "", "factors of the root in the normal";
        place: Place as "", "screen box and class";
        planes: Vec<Plane> as "plane", "cut planes";
    }
}

impl Words {
    /// Words from outside of the design, with so many planes.
    pub fn input(widths: Widths, planes: usize) -> Words {
        let gradient = || Linear::input(widths.gradient);
        Words {
            f1: Linear::input(widths.linear),
            f2: Quadratic::input(widths.quadratic),
            gx: gradient(),
            gy: gradient(),
            gz: gradient(),
            factors: Factors::input(widths.normal),
            place: Place::input(),
            planes: (0..planes)
                .map(|_| Plane::input(widths.plane, widths.normal))
                .collect(),
        }
    }
}
