//! Plane of one bit per pixel over a picture.

use std::collections::VecDeque;

/// What the host puts over pictures.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OverlayPlane {
    /// Bits of 32 pixels each, line by line, the first pixel in bit 0.
    pub words: Vec<u32>,
    /// Colour of the set pixels.
    pub colour: [u8; 3],
}

impl OverlayPlane {
    /// The plane of pixels that are set or not, line by line.
    pub fn new(pixels: &[bool], colour: [u8; 3]) -> OverlayPlane {
        let word = |bits: &[bool]| {
            let places = bits.iter().enumerate();
            places.fold(0, |word, (place, &bit)| word | u32::from(bit) << place)
        };
        OverlayPlane {
            words: pixels.chunks(32).map(word).collect(),
            colour,
        }
    }

    /// The colour over a pixel, counted line by line; none where it is not set.
    pub fn colour_at(&self, place: usize) -> Option<[u8; 3]> {
        let word = self.words.get(place / 32)?;
        (word >> (place % 32) & 1 == 1).then_some(self.colour)
    }

    /// A picture with the plane over it; red, green, blue of every pixel, line by line.
    pub fn over(&self, picture: &[u8]) -> Vec<u8> {
        let pixels = picture.chunks_exact(3).enumerate();
        let shown = |(place, pixel): (usize, &[u8])| {
            self.colour_at(place)
                .unwrap_or([pixel[0], pixel[1], pixel[2]])
        };
        pixels.flat_map(shown).collect()
    }
}

/// A pixel that comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Covered {
    /// Its place, line by line.
    pub place: usize,
    /// Red, green, blue.
    pub colour: [u8; 3],
}

/// Clocks from a pixel to the pixel with the plane over it.
pub const LATENCY: usize = 6;
/// Of these, those before its word is read.
const BEFORE: usize = 2;

/// The plane and the pixels on their way, the last one first: with its bit from the clock on in which its word is read.
#[derive(Clone, Debug)]
pub struct Overlay {
    plane: Vec<u32>,
    coming: VecDeque<Option<Covered>>,
    read: VecDeque<Option<(Covered, bool)>>,
}

impl Overlay {
    /// An empty plane of so many words.
    pub fn new(words: usize) -> Self {
        Overlay {
            plane: vec![0; words],
            coming: VecDeque::from([None; BEFORE]),
            read: VecDeque::from([None; LATENCY - BEFORE - 1]),
        }
    }

    /// One clock; the pixel that is there after the edge. `shown` is the colour of the set pixels, if the plane is
    /// shown.
    pub fn clock(
        &mut self,
        write: Option<(usize, u32)>,
        shown: Option<[u8; 3]>,
        pixel: Option<Covered>,
    ) -> Option<[u8; 3]> {
        let leaving = self.read.pop_front().flatten().map(|(pixel, is_set)| {
            let over = shown.filter(|_| is_set);
            over.unwrap_or(pixel.colour)
        });
        if let Some((address, word)) = write {
            self.plane[address] = word;
        }
        self.coming.push_back(pixel);
        let now = self.coming.pop_front().flatten();
        let read = now.map(|pixel| (pixel, self.bit(pixel.place)));
        self.read.push_back(read);
        leaving
    }

    /// The bit of a pixel; pixels beyond the plane begin it again.
    fn bit(&self, place: usize) -> bool {
        self.plane[place / 32 % self.plane.len()] >> (place % 32) & 1 == 1
    }
}
