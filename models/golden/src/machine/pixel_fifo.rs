//! Queue between a pipeline that cannot stall and a receiver that can.

use std::collections::VecDeque;

/// What the queue shows after a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FifoOutput {
    /// A pixel that is started now finds a place.
    pub room: bool,
    /// The oldest pixel and whether it ends its packet.
    pub word: Option<(u32, bool)>,
}

/// The queue: a pixel is promised its place when it is started, waits from its push on, and can be seen three clocks
/// after it, once those before it are taken.
#[derive(Clone, Debug)]
pub struct PixelFifo {
    places: usize,
    promised: usize,
    waiting: VecDeque<(u32, bool)>,
    /// The oldest that waits was read.
    is_read: bool,
    seen: Option<(u32, bool)>,
}

impl PixelFifo {
    /// A queue of so many places.
    pub fn new(places: usize) -> Self {
        PixelFifo {
            places,
            promised: 0,
            waiting: VecDeque::new(),
            is_read: false,
            seen: None,
        }
    }

    /// What is there before the next edge.
    pub fn output(&self) -> FifoOutput {
        FifoOutput {
            room: self.promised < self.places,
            word: self.seen,
        }
    }

    /// One clock; what is there after the edge.
    /// Panics when a pixel is started without room or pushed without having been started.
    pub fn clock(&mut self, started: bool, push: Option<(u32, bool)>, ready: bool) -> FifoOutput {
        assert!(!started || self.output().room, "started without room");
        if ready && self.seen.take().is_some() {
            self.promised -= 1;
        }
        if self.seen.is_none() && self.is_read {
            self.seen = self.waiting.pop_front();
        }
        self.is_read = !self.waiting.is_empty();
        self.promised += usize::from(started);
        self.waiting.extend(push);
        let waiting = self.waiting.len() + usize::from(self.seen.is_some());
        assert!(
            waiting <= self.promised,
            "pushed without having been started"
        );
        self.output()
    }
}
