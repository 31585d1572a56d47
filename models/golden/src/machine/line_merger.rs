//! The lines of graphics modules that draw side by side, one after the other.

use std::collections::VecDeque;

/// What leaves on a clock.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Leaving {
    /// Neighbours of a line, the leftmost first.
    pub pixels: Vec<u32>,
    /// The first of a frame is among them.
    pub first: bool,
    /// The last of the line is among them.
    pub last: bool,
}

/// The lines of all modules that came at once.
#[derive(Clone, Debug)]
struct Group {
    lines: Vec<Vec<u32>>,
    first: bool,
}

/// Two groups of lines at most: one fills while the other is read.
#[derive(Clone, Debug)]
pub struct LineMerger {
    modules: usize,
    filling: Group,
    /// Those that are whole, with what is left of their lines.
    whole: VecDeque<VecDeque<Leaving>>,
    /// The next that leaves was read.
    is_read: bool,
    /// Behind the memories, and at the output.
    kept: Option<Leaving>,
    seen: Option<Leaving>,
}

impl LineMerger {
    /// Of so many modules.
    pub fn new(modules: usize) -> Self {
        LineMerger {
            modules,
            filling: Group::new(modules),
            whole: VecDeque::new(),
            is_read: false,
            kept: None,
            seen: None,
        }
    }

    /// True if pixels that come on the next clock are taken.
    pub fn is_ready(&self) -> bool {
        self.whole.len() < 2
    }

    /// What leaves.
    pub fn leaving(&self) -> Option<&Leaving> {
        self.seen.as_ref()
    }

    /// One clock: pixels of each module, with whether they are the first of a frame and the last of their lines, and
    /// whether the receiver takes what leaves.
    pub fn clock(&mut self, coming: Option<(&[u32], bool, bool)>, ready: bool) {
        let coming = coming.filter(|_| self.is_ready());
        if ready {
            self.seen = None;
        }
        if self.seen.is_none() {
            self.seen = self.kept.take();
        }
        if self.kept.is_none() && self.is_read {
            let oldest = self.whole.front_mut().expect("a group that was read");
            self.kept = oldest.pop_front();
            if oldest.is_empty() {
                self.whole.pop_front();
            }
        }
        if let Some((pixels, first, last)) = coming {
            self.fill(pixels, first, last);
        }
        self.is_read = !self.whole.is_empty();
    }

    fn fill(&mut self, pixels: &[u32], first: bool, last: bool) {
        self.filling.first |= first;
        let each = pixels.chunks(pixels.len() / self.modules);
        for (line, own) in self.filling.lines.iter_mut().zip(each) {
            line.extend(own);
        }
        if last {
            let whole = std::mem::replace(&mut self.filling, Group::new(self.modules));
            self.whole.push_back(whole.leaving(pixels.len()));
        }
    }
}

impl Group {
    fn new(modules: usize) -> Group {
        Group {
            lines: vec![vec![]; modules],
            first: false,
        }
    }

    /// Line by line, so many pixels at once.
    fn leaving(self, at_once: usize) -> VecDeque<Leaving> {
        let mut leaving = VecDeque::new();
        for line in &self.lines {
            let count = line.len() / at_once;
            for (place, pixels) in line.chunks(at_once).enumerate() {
                leaving.push_back(Leaving {
                    pixels: pixels.to_vec(),
                    first: self.first && leaving.is_empty(),
                    last: place + 1 == count,
                });
            }
        }
        leaving
    }
}
