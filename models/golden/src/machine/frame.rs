//! A frame: what the machine has decided at every pixel, before shading.

/// Depth, object, face and normal of every pixel, row-major.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// Pixels per line.
    pub width: usize,
    /// Lines.
    pub height: usize,
    /// Depth word; the format's `z_max` where nothing is seen.
    pub depth: Vec<i64>,
    /// Index of the visible object, -1 for the background.
    pub id: Vec<i32>,
    /// Number of the visible face.
    pub number: Vec<u8>,
    /// Normal of the visible face.
    pub normal: Vec<[i16; 3]>,
    /// Transparent objects, in the order in which they are blended over the others.
    pub layers: Vec<FrameLayer>,
}

/// A transparent object at every pixel, whether another hides it or not.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FrameLayer {
    /// Index of the object.
    pub object: usize,
    /// Its part of what is seen, in 255ths.
    pub weight: u8,
    /// Depth word; `z_max` where it is absent.
    pub depth: Vec<i64>,
    /// Normal of its face.
    pub normal: Vec<[i16; 3]>,
}

impl Frame {
    /// A frame of background.
    pub fn background(width: usize, height: usize, z_max: i64) -> Frame {
        let pixels = width * height;
        Frame {
            width,
            height,
            depth: vec![z_max; pixels],
            id: vec![-1; pixels],
            number: vec![0; pixels],
            normal: vec![[0; 3]; pixels],
            layers: vec![],
        }
    }

    /// Shows at a pixel what another frame of the same size does, but for its layers.
    pub fn take(&mut self, index: usize, other: &Frame) {
        self.depth[index] = other.depth[index];
        self.id[index] = other.id[index];
        self.number[index] = other.number[index];
        self.normal[index] = other.normal[index];
    }

    /// Number of pixels at which an object is seen.
    pub fn covered(&self) -> usize {
        self.id.iter().filter(|&&id| id >= 0).count()
    }
}
