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
