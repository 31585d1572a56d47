//! The words of a scene that are sent again and again.

/// What a sequencer shows after a clock.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sequenced {
    /// A word is offered.
    pub valid: bool,
    /// The address of the memory.
    pub address: u16,
}

/// The sequencer: a word is read in one clock and offered until it is taken.
#[derive(Clone, Debug, Default)]
pub struct SceneSequencer {
    offered: bool,
    address: u16,
}

impl SceneSequencer {
    /// One clock: whether the word is the last of the memory, and whether the machine takes it.
    pub fn clock(&mut self, last: bool, ready: bool) -> Sequenced {
        if !self.offered {
            self.offered = true;
        } else if ready {
            self.offered = false;
            self.address = if last { 0 } else { (self.address + 1) % 4096 };
        }
        Sequenced {
            valid: self.offered,
            address: self.address,
        }
    }
}
