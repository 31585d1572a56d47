//! Random numbers for the trial: the same from the same seed in every build (SplitMix64 of Steele, Lea and Flood,
//! 2014).

use imogene_golden::object::quadric::ScreenBox;
use rayon::prelude::*;
use std::ops::Range;

/// What `tried` makes of `cases` cases, piece by piece of so many, on all threads; `piece_done` is called after each
/// with the number of cases in it. In the order of the cases, so that sums are the same in every run.
pub(crate) fn in_pieces<T: Send>(
    cases: u64,
    piece: u64,
    piece_done: impl Fn(u64) + Sync,
    tried: impl Fn(Range<u64>) -> T + Sync,
) -> Vec<T> {
    let pieces = (0..cases.div_ceil(piece)).into_par_iter();
    let one = |number: u64| {
        let range = number * piece..cases.min((number + 1) * piece);
        let count = range.end - range.start;
        let found = tried(range);
        piece_done(count);
        found
    };
    pieces.map(one).collect()
}

/// The state of a generator.
pub struct Random(u64);

impl Random {
    /// The generator of one case: seeds and numbers of cases are spread over all states.
    pub fn of_case(seed: u64, case: u64) -> Random {
        let mut random = Random(seed);
        Random(random.bits() ^ case.wrapping_mul(0x9e37_79b9_7f4a_7c15))
    }

    /// 64 random bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `limit`, which is at least 1.
    pub fn below(&mut self, limit: u64) -> u64 {
        ((u128::from(self.bits()) * u128::from(limit)) >> 64) as u64
    }

    /// A number between `low` and `high`, both included.
    pub fn between(&mut self, low: i64, high: i64) -> i64 {
        low + self.below((high - low + 1) as u64) as i64
    }

    /// A place of a box.
    pub fn place(&mut self, reach: &ScreenBox) -> (i64, i64) {
        let x = self.between(reach.x0, reach.x1);
        (x, self.between(reach.y0, reach.y1))
    }

    /// A number in 0 .. 1.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// A number in -1 .. 1.
    pub fn signed(&mut self) -> f64 {
        2.0 * self.unit() - 1.0
    }

    /// True once in `n`.
    pub fn one_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }

    /// A positive number of at most `most`, all magnitudes down to `most / 2^bits` alike.
    pub fn magnitude(&mut self, most: f64, bits: u32) -> f64 {
        most * (-self.unit() * f64::from(bits)).exp2()
    }
}
