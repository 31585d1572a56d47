//! Terms: sets of sides that together say exactly which pieces a face has.
//!
//! A machine that draws a quadric with cut planes knows AND alone; a face is therefore a union of terms, each the AND
//! of some sides. A term is shortened as long as it takes no piece that the face lacks, so that it has no side it does
//! not need.

use super::arrangement::Sample;
use super::vector::distance;
use std::cmp::Reverse;
use std::collections::BTreeSet;

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

    pub fn len(&self) -> u32 {
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
#[derive(Clone, Copy, Debug)]
pub struct Conflict {
    pub inside: Sample,
    pub outside: Sample,
}

/// Most conflicts that are resolved at once.
const MAX_CONFLICTS: usize = 8;
/// Most patterns from which a term is grown.
const MAX_SEEDS: usize = 400;

/// Whether a term is one object.
pub type Fits<'a> = &'a dyn Fn(&Term) -> bool;

/// Terms that take every piece of the face and no other. `ranks` has one number for each separator: those of the lower
/// rank are dropped first.
///
/// With `fits` a term that does not fit is not taken where others do: those others keep planes of a low rank and drop
/// edges, and so are parts of the term.
pub fn cover(
    samples: &[Sample],
    ranks: &[u8],
    fits: Option<Fits>,
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
        let rank = |term: &Term| (taken(term), Reverse(term.len()));
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
    let step = kept.len().div_ceil(MAX_SEEDS).max(1);
    let mut all = BTreeSet::new();
    for seed in kept.iter().step_by(step) {
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
    let mut term = Term {
        mask: all.unwrap_or(0),
        sides: seed,
    };
    let mut order: Vec<usize> = (0..separators).collect();
    if backwards {
        order.reverse();
    }
    order.sort_by_key(|k| ranks[*k]);
    for k in order {
        let shorter = Term {
            mask: term.mask & !(1 << k),
            ..term
        };
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
    let pairs =
        of(true).flat_map(|inside| of(false).map(move |outside| Conflict { inside, outside }));
    let apart = |pair: &Conflict| distance(pair.inside.point, pair.outside.point);
    let nearest = pairs.min_by(|p, q| apart(p).total_cmp(&apart(q)));
    nearest.expect("both have these sides")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn sample((sides, inside): (u128, bool)) -> Sample {
        Sample {
            sides,
            inside,
            point: [0.0; 3],
        }
    }

    proptest! {
        /// Whatever the set of pieces: the terms take these and no other, and no term can lose a side.
        #[test]
        fn terms_take_what_the_face_has(table in proptest::collection::vec(any::<bool>(), 64)) {
            let samples: Vec<Sample> =
                table.iter().enumerate().map(|(k, inside)| sample((k as u128, *inside))).collect();
            let terms = cover(&samples, &[0; 6], None).unwrap();
            for s in &samples {
                prop_assert_eq!(terms.iter().any(|t| t.takes(s.sides)), s.inside);
            }
            for term in &terms {
                for (k, _) in term.literals() {
                    let shorter = Term { mask: term.mask & !(1 << k), ..*term };
                    prop_assert!(samples.iter().any(|s| !s.inside && shorter.takes(s.sides)));
                }
            }
        }
    }

    #[test]
    fn a_piece_on_both_sides_is_a_conflict() {
        let samples = [sample((5, true)), sample((5, false)), sample((1, true))];
        let conflict = cover(&samples, &[0; 3], None).unwrap_err()[0];
        assert!(conflict.inside.inside && !conflict.outside.inside && conflict.inside.sides == 5);
    }

    #[test]
    fn a_whole_surface_needs_no_side() {
        let terms = cover(&[sample((0, true)), sample((1, true))], &[0], None).unwrap();
        assert_eq!(terms.len(), 1);
        assert_eq!(terms[0].len(), 0);
    }
}
