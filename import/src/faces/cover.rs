//! Terms: sets of sides that together say exactly which pieces a face has.
//!
//! A machine that draws a quadric with cut planes knows AND alone; a face is therefore a union of terms, each the AND
//! of some sides. A term loses every side without which it still takes no piece that the face lacks.

use super::vector::{Vector, distance};
use std::cmp::Reverse;
use std::collections::BTreeSet;

/// A point of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sample {
    /// Bit k: it is on the positive side of separator k.
    pub sides: u128,
    /// It belongs to the face.
    pub inside: bool,
    /// The point.
    pub point: Vector,
}

/// The AND of sides: those of `mask`, each as in `sides`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Term {
    /// Bit k: separator k matters.
    pub mask: u128,
    /// Bit k: the positive side of it.
    pub sides: u128,
}

impl Term {
    /// Whether it takes a piece.
    pub fn takes(&self, sides: u128) -> bool {
        (sides ^ self.sides) & self.mask == 0
    }

    /// How many sides it has.
    pub fn count(&self) -> u32 {
        self.mask.count_ones()
    }

    /// The separators it has, with their side.
    pub fn literals(self) -> impl Iterator<Item = (usize, bool)> {
        (0..128)
            .filter(move |k| self.mask >> k & 1 == 1)
            .map(move |k| (k, self.sides >> k & 1 == 1))
    }
}

/// Two samples that have the same sides, one in the face and one not.
pub type Conflict = [Sample; 2];

/// Most conflicts that are resolved at once.
const MAX_CONFLICTS: usize = 8;
/// Most patterns from which a term is grown.
const MAX_SEEDS: usize = 400;

/// Terms that take every piece of the face and no other. Separators of a lower rank are dropped first.
///
/// With `fits`, which says whether a term is one object, a term that does not fit is not taken where others do: those
/// others keep planes of a low rank and drop edges, and so are parts of the term.
pub fn cover(
    samples: &[Sample],
    ranks: &[u8],
    fits: Option<&dyn Fn(&Term) -> bool>,
) -> Result<Vec<Term>, Vec<Conflict>> {
    let kept: BTreeSet<u128> = sides(samples, true);
    let lost: Vec<u128> = sides(samples, false).into_iter().collect();
    let both = lost.iter().filter(|side| kept.contains(side));
    let first = both.take(MAX_CONFLICTS);
    let conflicts: Vec<Conflict> = first.map(|s| nearest_conflict(samples, *s)).collect();
    if !conflicts.is_empty() {
        return Err(conflicts);
    }
    // For parts of a term: its conics go first as before, then its edges, so that the planes that take it apart stay.
    let of_part = |rank: &u8| if *rank == 0 { 0 } else { u8::MAX - rank };
    let parts: Vec<u8> = ranks.iter().map(of_part).collect();
    let mut candidates = candidates(&kept, &lost, ranks);
    if let Some(fits) = fits {
        candidates.extend(self::candidates(&kept, &lost, &parts));
        candidates.retain(fits);
    }
    let mut open = kept;
    let mut terms = vec![];
    while !open.is_empty() {
        let taken = |term: &Term| open.iter().filter(|side| term.takes(**side)).count();
        let rank = |term: &Term| (taken(term), Reverse(term.count()));
        let best = candidates.iter().copied().max_by_key(rank);
        let best = best.filter(|term| taken(term) > 0).unwrap_or_else(|| {
            let seed = *open.first().expect("not empty");
            let whole = shortened(seed, &lost, ranks, false);
            match fits {
                Some(fits) if !fits(&whole) => shortened(seed, &lost, &parts, false),
                _ => whole,
            }
        });
        open.retain(|side| !best.takes(*side));
        terms.push(best);
    }
    Ok(terms)
}

fn sides(samples: &[Sample], inside: bool) -> BTreeSet<u128> {
    let own = samples.iter().filter(|sample| sample.inside == inside);
    own.map(|sample| sample.sides).collect()
}

fn candidates(kept: &BTreeSet<u128>, lost: &[u128], ranks: &[u8]) -> Vec<Term> {
    let mut all = BTreeSet::new();
    for seed in kept.iter().step_by(kept.len().div_ceil(MAX_SEEDS).max(1)) {
        for backwards in [false, true] {
            all.insert(shortened(*seed, lost, ranks, backwards));
        }
    }
    all.into_iter().collect()
}

/// The term of all sides of a piece, less those that are not needed.
fn shortened(seed: u128, lost: &[u128], ranks: &[u8], backwards: bool) -> Term {
    let separators = ranks.len();
    let all = u128::MAX.checked_shr(128 - separators as u32);
    let (mask, sides) = (all.unwrap_or(0), seed);
    let mut term = Term { mask, sides };
    let mut order: Vec<usize> = (0..separators).collect();
    if backwards {
        order.reverse();
    }
    order.sort_by_key(|k| ranks[*k]);
    for k in order {
        let mask = term.mask & !(1 << k);
        let shorter = Term { mask, ..term };
        if !lost.iter().any(|side| shorter.takes(*side)) {
            term = shorter;
        }
    }
    term.sides &= term.mask;
    term
}

fn nearest_conflict(samples: &[Sample], sides: u128) -> Conflict {
    let of = |inside: bool| {
        let own = samples.iter().copied();
        own.filter(move |s| s.sides == sides && s.inside == inside)
            .take(200)
    };
    let pairs = of(true).flat_map(|inside| of(false).map(move |outside| [inside, outside]));
    let apart = |[p, q]: &Conflict| distance(p.point, q.point);
    let nearest = pairs.min_by(|p, q| apart(p).total_cmp(&apart(q)));
    nearest.expect("both have these sides")
}
