//! The normal of a face.

use crate::rows::alike;

alike! {
    /// A normal.
    Normal(width): [Int(width); 3] {
        nx, "normal x";
        ny, "normal y";
        nz, "normal z";
    }
}
