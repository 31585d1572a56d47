//! The words of a scene that are sent again and again.

/// What a sequencer hears of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Word {
    /// The last one of the memory.
    pub last: bool,
    /// The last one of an image.
    pub ends: bool,
}

/// What a sequencer shows after a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequenced {
    /// A word is offered.
    pub valid: bool,
    /// The address of the memory.
    pub address: u16,
}

/// The sequencer: a word is read in one clock and offered until it is taken; an image is sent `stays` times more.
#[derive(Clone, Debug, Default)]
pub struct SceneSequencer {
    offered: bool,
    address: u16,
    /// Where the image begins, and how often it was sent again.
    image: u16,
    stayed: u8,
}

impl SceneSequencer {
    /// One clock: the word that is offered, and whether the machine takes it.
    pub fn clock(&mut self, word: Word, stays: u8, ready: bool) -> Sequenced {
        if !self.offered {
            self.offered = true;
        } else if ready {
            self.offered = false;
            self.take(word, stays);
        }
        Sequenced {
            valid: self.offered,
            address: self.address,
        }
    }

    fn take(&mut self, word: Word, stays: u8) {
        let next = (self.address + 1) % 4096;
        let following = if word.last { 0 } else { next };
        self.address = following;
        if !word.ends {
            return;
        }
        if self.stayed == stays {
            (self.image, self.stayed) = (following, 0);
        } else {
            self.address = self.image;
            self.stayed = self.stayed.wrapping_add(1);
        }
    }
}
