//! The normal of a face.

use crate::rows::alike;
use imogene_hdl::{Int, bundle};

bundle! {
    /// A normal.
    Normal(width) {
        nx: Int(width), "normal x";
        ny: Int(width), "normal y";
        nz: Int(width), "normal z";
    }
}

alike! {
    Normal: [Int; 3] { nx ny nz }
}
