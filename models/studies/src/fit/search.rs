//! The search: for each depth word that can meet the budget, the fewest bits everywhere else.
//!
//! Errors fall with every bit, so each number is found by halving an interval: the least depth word at which the budget
//! is met with all guard bits, then, for that depth word and some more, the shortest normal, the most digits of the
//! root left out, the fewest guard bits of f2, and of f1. What is found is drawn and compared in full; where errors do
//! not fall evenly the result may be a bit more than the least, but never less than what the budget asks for.

use super::FitError;
use super::budget::Budget;
use super::estimate;
use super::frames::{Drawn, Frames, MOST_GUARDS};
use crate::kit::words::widest;
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::slots::required_of_quadric;
use rayon::prelude::*;

const DEPTHS: (u32, u32) = (8, 30);
/// Depth words beyond the least that meets the budget: a longer word can need fewer guard bits.
const MORE_DEPTHS: u32 = 3;
const NORMALS: (u32, u32) = (10, 16);

/// What was found.
pub enum Outcome {
    /// Machines that meet the budget, the one that should be smallest first.
    Fits(Vec<Drawn>),
    /// None does; the most exact machine, with what it reaches of every limit.
    Unreachable(Box<Drawn>),
}

/// Searches; `tried` is called once for each set of words that was drawn, from any thread.
/// Fails if the budget is empty, or no machine can draw a frame.
pub fn search(
    frames: &Frames,
    budget: &Budget,
    tried: impl Fn() + Sync,
) -> Result<Outcome, FitError> {
    budget.check()?;
    let search = Search {
        frames,
        budget,
        tried: &tried,
    };
    if !search.fits(&most_exact(DEPTHS.1))? {
        return search.unreachable();
    }
    let least = search.least(DEPTHS, most_exact)?;
    let depths = (least..=(least + MORE_DEPTHS).min(DEPTHS.1)).into_par_iter();
    let found = depths.map(|depth| search.fewest(depth).transpose());
    let mut found: Vec<Drawn> = found.flatten_iter().collect::<Result<_, FitError>>()?;
    let cells = |drawn: &Drawn| {
        let each = drawn.prepared[0].quadrics().map(|(_, object)| {
            let required = required_of_quadric(&object.words);
            let slot = object.needed.slot(required, &drawn.widths);
            estimate::of_slot(&drawn.widths, &slot)
        });
        // Where there are none, the words alone count.
        each.sum::<f64>() + f64::from(drawn.widths.depth)
    };
    found.sort_by(|a, b| cells(a).total_cmp(&cells(b)));
    Ok(Outcome::Fits(found))
}

/// True if the most exact machine meets the budget.
pub(super) fn is_possible(frames: &Frames, budget: &Budget) -> Result<bool, FitError> {
    let drawn = frames.draw(&most_exact(DEPTHS.1), budget)?;
    Ok(drawn.is_some_and(|drawn| drawn.fits()))
}

struct Search<'a> {
    frames: &'a Frames,
    budget: &'a Budget,
    tried: &'a (dyn Fn() + Sync),
}

fn most_exact(depth: u32) -> MachineWords {
    // The second-degree processor has at most 64 bits, and the root as many as the depth unless the scene needs fewer.
    let guard_quadratic = MOST_GUARDS.1.min(64 - 2 * depth.min(32));
    widest(depth, NORMALS.1, (MOST_GUARDS.0, guard_quadratic), 0)
}

impl Search<'_> {
    fn draw(&self, words: &MachineWords) -> Result<Option<Drawn>, FitError> {
        let drawn = self.frames.draw(words, self.budget)?;
        (self.tried)();
        Ok(drawn)
    }

    fn fits(&self, words: &MachineWords) -> Result<bool, FitError> {
        Ok(self.draw(words)?.is_some_and(|drawn| drawn.fits()))
    }

    /// The least number in a range that fits, if the greatest does.
    fn least(&self, range: (u32, u32), of: impl Fn(u32) -> MachineWords) -> Result<u32, FitError> {
        let (mut low, mut high) = range;
        while low < high {
            let middle = (low + high) / 2;
            match self.fits(&of(middle))? {
                true => high = middle,
                false => low = middle + 1,
            }
        }
        Ok(high)
    }

    /// The fewest bits with a depth word, if it meets the budget at all.
    fn fewest(&self, depth: u32) -> Result<Option<Drawn>, FitError> {
        let mut words = most_exact(depth);
        if !self.fits(&words)? {
            return Ok(None);
        }
        let most = Format::MAX_DROPPED_ROWS.min(depth / 2);
        let (linear, quadratic) = (words.guard_linear, words.guard_quadratic);
        let mut shorten = |range, set: &dyn Fn(&mut MachineWords, u32)| {
            let least = self.least(range, |bits| {
                let mut changed = words;
                set(&mut changed, bits);
                changed
            })?;
            set(&mut words, least);
            Ok::<(), FitError>(())
        };
        shorten(NORMALS, &|words, bits| words.normal = bits)?;
        shorten((0, most), &|words, kept| words.dropped_rows = most - kept)?;
        shorten((0, quadratic), &|words, bits| words.guard_quadratic = bits)?;
        shorten((0, linear), &|words, bits| words.guard_linear = bits)?;
        Ok(self.draw(&words)?.filter(Drawn::fits))
    }

    fn unreachable(&self) -> Result<Outcome, FitError> {
        let mut nearest = None;
        // The longest words may leave no room for guard bits; of all depth words the one that breaks the fewest limits
        // counts.
        for depth in (DEPTHS.0..=DEPTHS.1).rev() {
            let Some(drawn) = self.draw(&most_exact(depth))? else {
                continue;
            };
            let broken = drawn.items.iter().filter(|item| !item.holds()).count();
            if nearest.as_ref().is_none_or(|(least, _)| broken < *least) {
                nearest = Some((broken, drawn));
            }
            if depth <= Format::BASE.depth {
                break;
            }
        }
        let (_, drawn) = nearest.expect("the words of the base format were drawn");
        Ok(Outcome::Unreachable(Box::new(drawn)))
    }
}
