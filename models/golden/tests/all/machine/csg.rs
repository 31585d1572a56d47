//! The front of a product against a scan of all places.

use crate::common::choices;
use imogene_golden::machine::csg::{Extent, Front, front, latency, skew};

/// Far end of the small scale of levels.
const FAR: i64 = 7;

fn extent((zf, zb): (i64, i64)) -> Extent {
    Extent { zf, zb }
}

fn depth(intersected: &[Extent], subtracted: &[Extent]) -> Option<i64> {
    Some(front(intersected, subtracted, FAR)?.depth)
}

/// Places on the line of sight: `2 z` is the point at depth z, `2 z + 1` all that lies between it and the next.
fn holds(extent: &Extent, place: i64) -> bool {
    extent.zf < FAR && (2 * extent.zf..=2 * extent.zb).contains(&place)
}

/// Every interval on levels 0 to `levels - 1`, sheets too, and an absent object.
fn intervals(levels: i64) -> Vec<(i64, i64)> {
    let mut list = vec![(FAR, 0)];
    for zf in 0..levels {
        list.extend((zf..levels).map(|zb| (zf, zb)));
    }
    list
}

/// The first level that is in, or that has something in just behind it, of all levels.
fn scan(intersected: &[Extent], subtracted: &[Extent]) -> Option<i64> {
    let contains = |place: i64| {
        let at = |extent: &Extent| holds(extent, place);
        intersected.iter().all(at) && !subtracted.iter().any(at)
    };
    (0..FAR).find(|z| contains(2 * z) || contains(2 * z + 1))
}

/// Calls `visit` with every choice of one interval for each object.
fn for_each_choice(objects: usize, levels: i64, mut visit: impl FnMut(&[Extent])) {
    let list: Vec<Extent> = intervals(levels).into_iter().map(extent).collect();
    choices(&list, objects as u32).for_each(|choice| visit(&choice));
}

/// The candidates are enough: the front of the intersection and the backs of what is taken away, each tested against
/// all others.
fn candidates(intersected: &[Extent], subtracted: &[Extent]) -> Option<i64> {
    let front = intersected.iter().map(|p| p.zf).max()?;
    let back = intersected.iter().map(|p| p.zb).min()?;
    let is_free = |z: i64| !subtracted.iter().any(|p| p.zf <= z && z < p.zb);
    let touches = |p: &Extent| p.zf <= front && front == p.zb;
    let is_sheet_free = front < back || !subtracted.iter().any(touches);
    let is_front_seen = front < FAR && front <= back && is_free(front) && is_sheet_free;
    let backs = subtracted.iter().filter(|p| p.zf < p.zb).map(|p| p.zb);
    let backs = backs.filter(|&z| front < z && z < back && is_free(z));
    let fronts = is_front_seen.then_some(front).into_iter();
    fronts.chain(backs).min()
}

#[test]
fn the_front_is_the_first_candidate_that_survives() {
    for (count, subtracted, levels) in [
        (1, 0, 5),
        (1, 1, 5),
        (2, 1, 5),
        (1, 2, 5),
        (2, 2, 4),
        (1, 3, 4),
    ] {
        for_each_choice(count + subtracted, levels, |choice| {
            let (intersected, subtracted) = choice.split_at(count);
            let expected = scan(intersected, subtracted);
            assert_eq!(candidates(intersected, subtracted), expected, "{choice:?}");
            assert_eq!(depth(intersected, subtracted), expected, "{choice:?}");
        });
    }
}

/// One chain of cells that move the front behind what covers it.
fn moved(front: i64, subtracted: &[Extent]) -> i64 {
    let cell = |z, p: &Extent| if p.zf <= z && z < p.zb { p.zb } else { z };
    subtracted.iter().fold(front, cell)
}

/// Objects taken away may uncover each other in a cascade: a chain needs them sorted, and no order is right on all
/// pixels.
#[test]
fn a_chain_of_cells_is_not_enough() {
    let solid = [extent((0, 6))];
    let [near, far] = [extent((0, 3)), extent((3, 5))];
    for order in [[near, far], [far, near]] {
        assert_eq!(depth(&solid, &order), Some(5));
    }
    assert_eq!(moved(0, &[near, far]), 5);
    assert_eq!(moved(0, &[far, near]), 3);
    // As many passes as objects are: each but the last moves the front for good.
    for_each_choice(3, 5, |choice| {
        let front = (0..3).fold(0, |front, _| moved(front, choice));
        assert_eq!(depth(&solid, choice), Some(front));
    });
}

#[test]
fn faces_and_ties() {
    let seen = |depth, object| Some(Front { depth, object });
    type Case<'a> = (&'a [(i64, i64)], &'a [(i64, i64)], Option<Front>);
    let cases: [Case; 8] = [
        // Of two fronts, or two backs, at one depth the first.
        (&[(2, 5), (2, 6)], &[], seen(2, 0)),
        (&[(1, 5), (2, 6)], &[], seen(2, 1)),
        (&[(0, 6)], &[(0, 3), (0, 3)], seen(3, 1)),
        // What ends where the solid begins takes nothing away, and what ends where the solid ends leaves nothing.
        (&[(3, 6)], &[(0, 3)], seen(3, 0)),
        (&[(0, 6)], &[(0, 6)], None),
        // A solid of no thickness is there, unless something touches it; of no thickness, nothing is taken away.
        (&[(4, 4)], &[], seen(4, 0)),
        (&[(4, 4)], &[(0, 4)], None),
        (&[(0, 6)], &[(0, 0)], seen(0, 0)),
    ];
    for (intersected, subtracted, expected) in cases {
        let [intersected, subtracted]: [Vec<Extent>; 2] =
            [intersected, subtracted].map(|list| list.iter().copied().map(extent).collect());
        assert_eq!(front(&intersected, &subtracted, FAR), expected);
    }
}

#[test]
fn latency_counts_the_two_trees_and_the_candidates() {
    let shapes = [(1, 0), (1, 1), (2, 2), (3, 2)];
    assert_eq!(shapes.map(|(i, s)| latency(i, s)), [2, 3, 5, 6]);
    assert_eq!([1, 2, 3, 4, 5].map(skew), [0, 1, 2, 2, 3]);
}
