//! Widths of an object.

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
