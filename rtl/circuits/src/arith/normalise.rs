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

/// Shifts words to the left until the first bit of the magnitude is set, or of the first word where there is none.
/// Latency [`NORMALISED`]: a register stands behind each shift, of short words more behind the last one.
pub(super) fn shifted(words: Vec<Bits>, magnitude: Option<Bits>) -> Shifted {
    let width = magnitude.unwrap_or(words[0]).width();
    let shifts = width.next_power_of_two().ilog2();
    shifted_by(words, magnitude, &[5, 4, 3, 2, 1, 0]).delayed(NORMALISED.saturating_sub(shifts))
}

/// The same with registers behind the shifts by these powers of two: the longer ones are first, each where as many bits
/// are free.
pub(crate) fn shifted_by(words: Vec<Bits>, magnitude: Option<Bits>, kept: &[u32]) -> Shifted {
    let width = magnitude.unwrap_or(words[0]).width();
    let shifts = width.next_power_of_two().ilog2();
    let mut now = Shifted {
        words,
        magnitude: magnitude.into_iter().collect(),
        places: Bits::new(0, PLACES),
    };
    for shift in (0..shifts).rev() {
        let count = 1 << shift;
        let leading = now.magnitude.first().unwrap_or(&now.words[0]);
        let is_free = leading.slice(width - 1, width - count).is(0);
        let left = |words: &[Bits]| words.iter().map(|word| word.left(count)).collect();
        let next = Shifted {
            words: left(&now.words),
            magnitude: left(&now.magnitude),
            places: now.places | Bits::new(u64::from(count), PLACES),
        };
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
