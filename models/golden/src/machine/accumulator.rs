//! Mean of several passes over a picture.

/// A pixel of a pass.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PassPixel {
    /// Which pixel.
    pub address: usize,
    /// It is of the first pass.
    pub first: bool,
    /// It is of the last pass.
    pub last: bool,
    /// Red, green, blue.
    pub colour: [u8; 3],
}

/// The sums of all pixels.
#[derive(Clone, Debug)]
pub struct Accumulator {
    sums: Vec<[u32; 3]>,
}

/// Clocks from a pixel of the last pass to its mean.
pub const LATENCY: usize = 4;

impl Accumulator {
    /// Sums for so many pixels.
    pub fn new(pixels: usize) -> Self {
        Accumulator {
            sums: vec![[0; 3]; pixels],
        }
    }

    /// Adds a pixel; its mean over `passes` passes if it is of the last one, rounded to the nearest, halves up.
    pub fn add(&mut self, pixel: &PassPixel, passes: u32) -> Option<[u8; 3]> {
        let sums = &mut self.sums[pixel.address];
        if pixel.first {
            *sums = [0; 3];
        }
        for (sum, value) in sums.iter_mut().zip(pixel.colour) {
            *sum += u32::from(value);
        }
        let mean = |sum: u32| ((sum + passes / 2) / passes) as u8;
        pixel.last.then(|| sums.map(mean))
    }
}
