//! Solids along one line of sight: the tree itself, point by point, without its normal form.

use super::ray::Hit;
use super::real::SurdReal;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_scene::Tree;
use std::collections::BTreeMap;

/// An object where a line of sight enters it and where it leaves it.
pub(super) type Interval = [Hit; 2];

/// The first point of a solid behind which the line is within, with its object: the nearest face behind which the tree
/// contains the line. Of two faces there a front goes first, then the smaller index.
pub(super) fn first_point(tree: &Tree, met: &BTreeMap<usize, Interval>) -> Option<(usize, Hit)> {
    let is_within = |w: &SurdReal| {
        let inside = |object: usize| {
            met.get(&object)
                .is_some_and(|[front, back]| front.w <= *w && *w < back.w)
        };
        tree.contains(&inside)
    };
    let front = |(&id, [front, _]): (&usize, &Interval)| (id, front.clone());
    let back = |(&id, [_, back]): (&usize, &Interval)| {
        let turned = Hit {
            is_back: true,
            number: match back.number {
                // Seen from behind, the far root is the near one.
                FACE_NEAR => FACE_FAR,
                FACE_FAR => FACE_NEAR,
                number => number,
            },
            ..back.clone()
        };
        (id, turned)
    };
    let faces = met.iter().map(front).chain(met.iter().map(back));
    let seen = faces.filter(|(_, hit)| is_within(&hit.w));
    // Of equal ones the first stays.
    seen.reduce(|best, face| if face.1.w < best.1.w { face } else { best })
}
