//! Words of a DVI channel, and their bits (DVI 1.0, section 3).

/// Words of the blanking, by vsync in bit 1 and hsync in bit 0.
pub const CONTROL: [u16; 4] = [0x354, 0x0ab, 0x154, 0x2ab];

/// What a channel sends in a clock of the pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sent {
    /// A level.
    Level(u8),
    /// Two bits of control.
    Control(u8),
}

/// Ones less zeros among the low bits of a word.
fn balance(word: u16, bits: u32) -> i32 {
    2 * (word & ((1 << bits) - 1)).count_ones() as i32 - bits as i32
}

/// Places among the low bits of a word where a bit differs from the one below it.
pub fn transitions(word: u16, bits: u32) -> u32 {
    ((word ^ word >> 1) & ((1 << (bits - 1)) - 1)).count_ones()
}

/// The level as a chain: its bit 0, then each bit against the one before it in the chain, by XOR or XNOR.
fn chain(level: u8, xnor: bool) -> u16 {
    let mut word = u16::from(level & 1);
    for place in 1..8 {
        let differs = (word >> (place - 1) ^ u16::from(level) >> place) & 1;
        word |= (differs ^ u16::from(xnor)) << place;
    }
    word
}

/// The sender of one channel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct TmdsEncoder {
    /// Ones less zeros of all words since the last word of control.
    pub disparity: i32,
}

impl TmdsEncoder {
    /// The next word.
    ///
    /// Of the two chains the one with fewer transitions is sent: they have seven places between them, so there is no
    /// tie. Bit 8 says that it is of XOR. It is turned over, which bit 9 says, where that brings ones and zeros nearer
    /// to each other; where neither way does, bit 9 is the opposite of bit 8.
    pub fn word(&mut self, sent: Sent) -> u16 {
        let level = match sent {
            Sent::Level(level) => level,
            Sent::Control(pair) => {
                self.disparity = 0;
                return CONTROL[usize::from(pair & 3)];
            }
        };
        let chains = [false, true].map(|xnor| (transitions(chain(level, xnor), 8), xnor));
        let (_, xnor) = chains.into_iter().min().expect("two chains");
        let body = chain(level, xnor);
        let turned = match self.disparity.signum() * balance(body, 8).signum() {
            0 => xnor,
            sign => sign > 0,
        };
        let body = if turned { body ^ 0xff } else { body };
        let word = u16::from(turned) << 9 | u16::from(!xnor) << 8 | body;
        self.disparity += balance(word, 10);
        word
    }
}

/// What each word means; none of a word that is never sent.
pub fn meaning(word: u16) -> Option<Sent> {
    static TABLE: std::sync::OnceLock<Vec<Option<Sent>>> = std::sync::OnceLock::new();
    let table = TABLE.get_or_init(|| {
        let mut table = vec![None; 1 << 10];
        for pair in 0..4 {
            table[usize::from(CONTROL[usize::from(pair)])] = Some(Sent::Control(pair));
        }
        for level in 0..=255 {
            // One that leans to ones, one that leans to zeros, and one that does neither.
            for disparity in [-2, 0, 2] {
                let word = TmdsEncoder { disparity }.word(Sent::Level(level));
                table[usize::from(word)] = Some(Sent::Level(level));
            }
        }
        table
    });
    table.get(usize::from(word)).copied().flatten()
}

/// The sender of the bits of a channel, two at a time.
#[derive(Clone, Debug, Default)]
pub struct TmdsSerialiser {
    turns: [bool; 4],
    word: u16,
    sent: u32,
    /// Pairs on their way to the pin.
    leaving: [u16; 2],
}

impl TmdsSerialiser {
    /// One clock of five in a pixel: the pair that is sent, zeros before the first word, with which `turn` is high. The
    /// last pair of a word is sent until another word follows. A pair takes two clocks to its pin.
    pub fn clock(&mut self, turn: bool, word: u16) -> u16 {
        self.sent += 1;
        if self.turns[2] != self.turns[3] {
            (self.word, self.sent) = (word, 0);
        }
        self.turns.rotate_right(1);
        self.turns[0] = turn;
        let pair = self.word >> (2 * self.sent.min(4)) & 3;
        self.leaving.rotate_right(1);
        std::mem::replace(&mut self.leaving[0], pair)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    /// Every state that any sequence of levels leads to.
    fn states() -> Vec<TmdsEncoder> {
        let mut found = HashSet::from([TmdsEncoder::default()]);
        let mut open = vec![TmdsEncoder::default()];
        while let Some(state) = open.pop() {
            for level in 0..=255 {
                let mut next = state;
                next.word(Sent::Level(level));
                if found.insert(next) {
                    open.push(next);
                }
            }
        }
        found.into_iter().collect()
    }

    /// The decoder of the standard: figure 3-6.
    fn decoded(word: u16) -> u8 {
        let body = if word >> 9 & 1 == 1 { !word } else { word } & 0xff;
        let differs = body ^ body << 1;
        let level = if word >> 8 & 1 == 1 {
            differs
        } else {
            !differs
        };
        (level & 0xfe | body & 1) as u8
    }

    #[test]
    fn every_level_is_decoded_from_every_state_and_the_disparity_is_bounded() {
        let states = states();
        assert!(states.iter().all(|state| state.disparity.abs() <= 8));
        assert!(states.len() > 5, "{states:?}");
        for state in states {
            for level in 0..=255 {
                let word = state.clone().word(Sent::Level(level));
                assert_eq!(decoded(word), level);
                assert_eq!(meaning(word), Some(Sent::Level(level)));
                // Eight bits of a chain have at most three transitions, the marks at most two more.
                assert!(transitions(word, 8) <= 3 && transitions(word, 10) <= 5);
                assert!(!CONTROL.contains(&word));
            }
        }
    }

    /// A receiver finds the words by the many transitions of the blanking.
    #[test]
    fn words_of_control_have_more_transitions_than_those_of_levels() {
        for (pair, word) in CONTROL.into_iter().enumerate() {
            assert!(transitions(word, 10) >= 7);
            assert_eq!(meaning(word), Some(Sent::Control(pair as u8)));
        }
    }

    #[test]
    fn words_that_nobody_sends_mean_nothing() {
        let known = (0..1 << 10).filter(|&word| meaning(word).is_some());
        // 460 words of levels, as published, and four of control.
        assert_eq!(known.count(), 464);
    }

    /// Published words: black, white and a level of the middle, at the beginning of a line.
    #[test]
    fn the_first_words_of_a_line() {
        let word = |level| TmdsEncoder::default().word(Sent::Level(level));
        assert_eq!(word(0x00), 0x100);
        assert_eq!(word(0xff), 0x200);
        assert_eq!(word(0x10), 0x1f0);
    }
}
