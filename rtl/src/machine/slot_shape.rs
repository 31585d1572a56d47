//! What a slot of a beam machine holds.

use serde::{Deserialize, Serialize};

/// Shape of the quadric processor of a slot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub struct SlotShape {
    /// Cut planes, 0 to 12.
    pub planes: usize,
    /// With half B, for objects of class front.
    pub two_volumes: bool,
}

impl SlotShape {
    /// A processor for every class of object.
    pub const fn full(planes: usize) -> Self {
        Self {
            planes,
            two_volumes: true,
        }
    }

    /// Clocks by which processors of the same words differ: one for each plane, one for the merge.
    pub const fn clocks(&self) -> usize {
        self.planes + self.two_volumes as usize
    }
}
