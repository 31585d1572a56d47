//! What the pins of three DVI channels say.

use crate::screen::Tick;
use imogene_golden::machine::tmds::{Sent, TmdsEncoder, meaning, transitions};
use thiserror::Error;

/// Bits of a word.
const WORD: usize = 10;
/// Names of the channels, in the order of the bits of a sample.
const NAMES: [&str; 3] = ["blue", "green", "red"];

/// Channels that carry no words of DVI.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum TmdsError {
    /// The clock channel does not rise.
    #[error("the clock channel never rises")]
    NoClock,
    /// The clock channel is not five ones and five zeros.
    #[error(
        "the clock channel is {1:010b} in word {0}, bit 0 first; five ones and five zeros are sent"
    )]
    Clock(usize, u16),
    /// A word of a channel that no level and no pair of control bits makes.
    #[error("the {0} channel has {2:010b} in word {1}, which means nothing")]
    Word(&'static str, usize, u16),
    /// A word of a level that would not balance ones and zeros.
    #[error("the {0} channel has {2:010b} in word {1}; {3:010b} balances ones and zeros")]
    Balance(&'static str, usize, u16, u16),
    /// Channels that do not show a pixel in the same clock, or control bits where there are none.
    #[error("the channels disagree in word {0}: {1}")]
    Apart(usize, &'static str),
}

/// What was found on the channels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Channels {
    /// Words of each channel.
    pub words: usize,
    /// The greatest difference of ones and zeros since a word of control.
    pub disparity: i32,
    /// The most transitions in a word of a level.
    pub transitions: u32,
}

/// Reads samples of the pins, two for each clock of the pairs: bits 0, 1, 2 are the blue, green and red channels, bit 3
/// their clock.
///
/// A word begins where the clock rises. Every word from the first one of control on has to be the one that balances
/// ones and zeros.
#[derive(Default)]
pub struct Decoder {
    before: Option<u8>,
    /// Samples of the word that has begun; none before the clock rises.
    word: Option<Vec<u8>>,
    count: usize,
    senders: [TmdsEncoder; 3],
    sync: u8,
    is_started: bool,
    found: Channels,
}

impl Decoder {
    /// The next sample, and the clock of the pixels that it ends. Fails when the channels carry no words of DVI.
    pub fn see(&mut self, sample: u8) -> Result<Option<Tick>, TmdsError> {
        if self.word.is_none() {
            let rises = sample & 8 != 0 && self.before.is_some_and(|before| before & 8 == 0);
            self.before = Some(sample);
            self.word = rises.then(Vec::new);
        }
        let Some(samples) = &mut self.word else {
            return Ok(None);
        };
        samples.push(sample);
        if samples.len() < WORD {
            return Ok(None);
        }
        let word = self.count;
        let clock = bits(samples, 3);
        if clock != 0b00000_11111 {
            return Err(TmdsError::Clock(word, clock));
        }
        let words = [0, 1, 2].map(|channel| bits(samples, channel));
        samples.clear();
        self.count += 1;
        self.take(word, words)
    }

    /// What was found, after all samples. Fails when no word began.
    pub fn found(self) -> Result<Channels, TmdsError> {
        self.word.map(|_| self.found).ok_or(TmdsError::NoClock)
    }

    fn take(&mut self, word: usize, words: [u16; 3]) -> Result<Option<Tick>, TmdsError> {
        if !self.is_started {
            // Before the first word the registers of the encoders are empty.
            let is_control = |&word: &u16| matches!(meaning(word), Some(Sent::Control(_)));
            self.is_started = words.iter().all(is_control);
        }
        if !self.is_started {
            return Ok(None);
        }
        let mut sent = [Sent::Control(0); 3];
        for (channel, found) in words.into_iter().enumerate() {
            sent[channel] = self.one(channel, word, found)?;
        }
        self.found.words += 1;
        let tick = match sent {
            [Sent::Level(blue), Sent::Level(green), Sent::Level(red)] => Some([red, green, blue]),
            [Sent::Control(sync), Sent::Control(0), Sent::Control(0)] => {
                self.sync = sync;
                None
            }
            [Sent::Control(_), Sent::Control(_), Sent::Control(_)] => {
                return Err(TmdsError::Apart(word, "control bits on green or red"));
            }
            _ => {
                return Err(TmdsError::Apart(word, "some show a pixel and some do not"));
            }
        };
        Ok(Some(Tick {
            hsync: self.sync & 1 == 1,
            vsync: self.sync & 2 == 2,
            de: Some(tick.is_some()),
            colour: tick.unwrap_or_default(),
        }))
    }

    /// What a word of a channel means.
    fn one(&mut self, channel: usize, word: usize, found: u16) -> Result<Sent, TmdsError> {
        let (name, sender) = (NAMES[channel], &mut self.senders[channel]);
        let sent = meaning(found).ok_or(TmdsError::Word(name, word, found))?;
        let wanted = sender.word(sent);
        if wanted != found {
            return Err(TmdsError::Balance(name, word, found, wanted));
        }
        self.found.disparity = self.found.disparity.max(sender.disparity.abs());
        if let Sent::Level(_) = sent {
            self.found.transitions = self.found.transitions.max(transitions(found, 10));
        }
        Ok(sent)
    }
}

fn bits(samples: &[u8], channel: u32) -> u16 {
    let bit = |word, sample: &u8| word << 1 | u16::from(sample >> channel & 1);
    samples.iter().rev().fold(0, bit)
}
