//! Two frames: one is shown while the other arrives.

use std::collections::VecDeque;

/// A pixel that comes in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Arriving {
    /// Its place, line by line.
    pub place: usize,
    /// Its colour, 24 bits.
    pub colour: u32,
    /// It is the last one of its frame.
    pub last: bool,
}

/// What the store shows after a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StoreOutput {
    /// A pixel that comes is taken.
    pub ready: bool,
    /// The colour of the pixel that was asked for 3 clocks before.
    pub colour: Option<u32>,
    /// Another frame is shown from now on.
    pub swapped: bool,
}

/// The store. A frame is shown or filled, never both, so nothing depends on when a pixel reaches its memory.
#[derive(Clone, Debug)]
pub struct FrameStore {
    shown: Vec<u32>,
    filled: Vec<u32>,
    is_whole: bool,
    asked: VecDeque<Option<u32>>,
}

/// Clocks from the request of a pixel to its colour.
pub const LATENCY: usize = 5;

impl FrameStore {
    /// Two black frames of so many pixels.
    pub fn new(pixels: usize) -> Self {
        FrameStore {
            shown: vec![0; pixels],
            filled: vec![0; pixels],
            is_whole: false,
            asked: VecDeque::from([None; LATENCY - 1]),
        }
    }

    /// One clock; what is there after the edge.
    pub fn clock(
        &mut self,
        arriving: Option<Arriving>,
        retrace: bool,
        asked: Option<usize>,
    ) -> StoreOutput {
        self.asked.push_back(asked.map(|place| self.shown[place]));
        let swapped = retrace && self.is_whole;
        if let Some(pixel) = arriving.filter(|_| !self.is_whole) {
            self.filled[pixel.place] = pixel.colour;
            self.is_whole = pixel.last;
        }
        if swapped {
            std::mem::swap(&mut self.shown, &mut self.filled);
            self.is_whole = false;
        }
        StoreOutput {
            ready: !self.is_whole,
            colour: self.asked.pop_front().flatten(),
            swapped,
        }
    }
}
