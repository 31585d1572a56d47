use imogene_import::faces::Sample;
use imogene_import::faces::cover::{Term, cover};
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
    let [inside, outside] = cover(&samples, &[0; 3], None).unwrap_err()[0];
    assert!(inside.inside && !outside.inside && inside.sides == 5);
}

#[test]
fn a_whole_surface_needs_no_side() {
    let terms = cover(&[sample((0, true)), sample((1, true))], &[0], None).unwrap();
    assert_eq!(terms.len(), 1);
    assert_eq!(terms[0].count(), 0);
}
