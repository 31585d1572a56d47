//! Widths of an object.

use imogene_contract::MachineWords;
use imogene_contract::words::{NORMAL, NORMAL_PART, denominator, depth_sum, quadratic};

/// Widths of the words of an object.
#[derive(Clone, Copy, Debug)]
pub struct Widths {
    /// Depths.
    pub depth: u32,
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
    /// Those of an object in the words of a machine or of a slot.
    pub fn of(words: &MachineWords) -> Widths {
        Widths {
            depth: words.depth,
            linear: depth_sum(words.depth) + words.guard_linear,
            quadratic: quadratic(words.root) + words.guard_quadratic,
            gradient: words.normal + NORMAL_PART - NORMAL,
            normal: words.normal,
            plane: words.plane,
        }
    }

    /// The denominator of a quotient.
    pub fn denominator(&self) -> u32 {
        denominator(self.plane, self.depth)
    }

    /// Its numerator.
    pub fn numerator(&self) -> u32 {
        self.depth + self.denominator()
    }

    /// Bits of a load bus: those of the widest word, and of a word of the screen box.
    pub fn bus(&self) -> u32 {
        let words = [self.linear, self.quadratic, self.plane, self.gradient];
        words.into_iter().fold(24, u32::max)
    }
}
