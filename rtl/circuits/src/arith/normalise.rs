//! Words shifted until one of them has its first bit set.

use imogene_hdl::{Bits, Bundle, Value, bundles};

/// Latency of words that are shifted until one has its first bit set.
pub const NORMALISED: u32 = 6;
/// Bits of a number of places.
const PLACES: u32 = 6;

bundles! {
    /// Words on their way to the left.
    Shifted {
        words: Vec<Bits> as "shifted", "the words";
        magnitude: Vec<Bits> as "magnitude", "the word whose first bit counts; none if it is the first one";
        places: Bits as "places", "how far they were shifted";
    }
}

impl Shifted {
    /// The word whose first bit counts.
    fn leading(&self) -> Bits {
        *self.magnitude.first().unwrap_or(&self.words[0])
    }

    /// Shifted to the left by so many places.
    fn left(&self, count: u32) -> Self {
        let left = |words: &[Bits]| words.iter().map(|word| word.left(count)).collect();
        Self {
            words: left(&self.words),
            magnitude: left(&self.magnitude),
            places: self.places | Bits::new(u64::from(count), PLACES),
        }
    }
}

fn unshifted(words: Vec<Bits>, magnitude: Option<Bits>) -> Shifted {
    Shifted {
        words,
        magnitude: magnitude.into_iter().collect(),
        places: Bits::new(0, PLACES),
    }
}

/// Shifts words to the left until the first bit of the magnitude is set, or of the first word where there is none;
/// above the leading one stand at most so many zeros. Latency [`NORMALISED`]: a register stands behind each shift, of
/// few shifts more around them.
///
/// Whether to shift is found a clock ahead, for the wires to all bits; of words without a register before the first
/// shift that one alone is found late.
pub(super) fn shifted(words: Vec<Bits>, magnitude: Option<Bits>, zeros: u32) -> Shifted {
    let width = magnitude.unwrap_or(words[0]).width();
    let shifts = (zeros + 1).next_power_of_two().ilog2();
    let free = |magnitude: Bits, count: u32| magnitude.slice(width - 1, width - count).is(0);
    let mut now = unshifted(words, magnitude);
    let name = |count: u32| format!("is_free_{count}");
    let first = 1 << (shifts - 1);
    let mut is_free = free(now.leading(), first).named(&name(first));
    if shifts < NORMALISED {
        is_free = is_free.reg().named(&format!("kept_free_{first}"));
        now = now.delayed(1);
    }
    for shift in (0..shifts).rev() {
        let (count, left) = (1 << shift, now.left(1 << shift));
        let [leading, left_leading] = [&now, &left].map(Shifted::leading);
        now = is_free.select(left, now);
        if shift == 0 {
            now.magnitude.clear();
        } else {
            let next = count / 2;
            let next_free = is_free.select(free(left_leading, next), free(leading, next));
            is_free = next_free.reg().named(&name(next));
        }
        now = now.delayed(1);
    }
    now.delayed((NORMALISED - shifts).saturating_sub(1))
}

/// The same with registers behind the shifts by these powers of two: the longer ones are first, each where as many bits
/// are free.
pub(crate) fn shifted_by(words: Vec<Bits>, magnitude: Option<Bits>, kept: &[u32]) -> Shifted {
    let width = magnitude.unwrap_or(words[0]).width();
    let shifts = width.next_power_of_two().ilog2();
    let mut now = unshifted(words, magnitude);
    for shift in (0..shifts).rev() {
        let count = 1 << shift;
        let is_free = now.leading().slice(width - 1, width - count).is(0);
        let next = now.left(count);
        now = is_free.named(&format!("is_free_{count}")).select(next, now);
        if shift == 0 {
            now.magnitude.clear();
        }
        if kept.contains(&shift) {
            now = now.delayed(1);
        }
    }
    now
}
