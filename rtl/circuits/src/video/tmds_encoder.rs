//! Words of a DVI channel.

use imogene_hdl::{Bits, Int, Value, bundle, join, module, net};

/// Bits of a word on a channel.
pub const SYMBOL: u32 = 10;
/// Bits of a level.
const LEVEL: u32 = super::LEVEL;
/// Bits of a count of bits, and of half a disparity.
const COUNT: u32 = 4;

bundle! {
    /// What a channel is given.
    Channel() {
        de: Bits(1), "a pixel is shown";
        level: Bits(LEVEL), "level of its colour";
        control: Bits(2), "what is sent where no pixel is shown: on the blue channel vsync in bit 1 and hsync in bit 0";
    }
}

/// Makes of a level the word of ten bits that a DVI channel sends, with few transitions and as many ones as zeros in
/// the long run; of two bits of control one of four words that no level has.
///
/// Latency 3, one word per clock. DVI 1.0, section 3.2, figure 3-5. The disparity is half of that of the figure: the
/// ones of a word of even length less its zeros are even.
pub fn tmds_encoder(at: &str, channel: Channel) -> Bits {
    module("tmds_encoder", at, channel, |channel| {
        net! {
            let ones = count(channel.level);
            let is_half = ones.is(4);
            let is_most = Bits::new(4, COUNT).less(ones);
            let inverts = is_most | (is_half & !channel.level.bit(0));
            let chain = chained(channel.level, inverts);
            let short = join([!inverts, chain]).reg();
            let chain_ones = count(short.low(LEVEL));
            let excess = chain_ones.int() - Int::new(4, COUNT);
            let mark = short.top().extend(COUNT).int();
            // What the word adds to the disparity as it is, and turned over.
            let plain_step = (excess + mark - Int::new(1, COUNT)).reg();
            let turned_step = (mark - excess).reg();
            let is_balanced = excess.is(0).reg();
            let is_short = excess.is_negative().reg();
            let kept = short.reg();
            let de = channel.de.delay(2);
            let control = channel.control.delay(2);
            let disparity = Int::register(COUNT);
            let is_xor = kept.top();
            let is_even = disparity.is(0) | is_balanced;
            let grows = disparity.is_negative().equals(is_short);
            let turned = is_even.select(!is_xor, grows);
            let sent = kept.low(LEVEL) ^ spread(turned);
            let next_disparity = disparity + turned.select(turned_step, plain_step);
            let level_word = join([turned, is_xor, sent]);
            let word = de.select(level_word, control_word(control)).reg();
        }
        disparity.load(de.select(next_disparity, Int::new(0, COUNT)));
        ("word", word, "what is sent, bit 0 first")
    })
}

/// So many copies of a bit as a level has.
fn spread(bit: Bits) -> Bits {
    join([bit; LEVEL as usize])
}

/// Ones in a level.
fn count(word: Bits) -> Bits {
    let width = word.width();
    if width == 1 {
        return word.extend(COUNT);
    }
    count(word.low(width / 2)) + count(word.high(width - width / 2))
}

/// Each bit against the one before it in the result; the result of the first is the bit itself.
fn chained(level: Bits, inverts: Bits) -> Bits {
    let mut before = level.bit(0);
    let mut word = before;
    for index in 1..LEVEL {
        before = before ^ level.bit(index) ^ inverts;
        word = join([before, word]);
    }
    word
}

/// The words of the blanking.
fn control_word(control: Bits) -> Bits {
    let word = |value: u64| Bits::new(value, SYMBOL);
    let low = |one: u64, other: u64| control.bit(0).select(word(one), word(other));
    let upper = low(0b10_1010_1011, 0b01_0101_0100);
    control
        .bit(1)
        .select(upper, low(0b00_1010_1011, 0b11_0101_0100))
}
