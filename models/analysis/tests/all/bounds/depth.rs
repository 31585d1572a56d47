use imogene_analysis::bounds::depth::{depth_terms, face_bound, root_error, worst_case};
use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR};
use imogene_prepare::RoundingBounds;
use proptest::prelude::*;

fn of_f2(f2: f64, guards: u32) -> RoundingBounds {
    let format = Format::BASE.with_guards(2, guards).unwrap();
    RoundingBounds {
        f2,
        ..RoundingBounds::of_format(&format)
    }
}

proptest! {
    /// For a true f2 anywhere within the bound, the integer root is within `root_error`, and the error through the
    /// root within its term.
    #[test]
    fn root_error_covers_every_true_radicand(
        wide in 0i64..1 << 47, narrow in 0i64..1000, small in any::<bool>(), e2 in 0.0f64..1e6, part in -1.0f64..=1.0, guards in 0u32..8, low in 0.0f64..1.0, rows in 0u32..6
    ) {
        let f2 = if small { narrow } else { wide };
        let error = if small { e2 / 1000.0 } else { e2 };
        let bounds = RoundingBounds { dropped_rows: rows, ..of_f2(error, guards) };
        let kept = f2 as f64 + low * bounds.dropped_f2;
        let truth = kept + part * bounds.f2;
        prop_assume!(truth >= 0.0);
        let off = (bounds.root_of(f2) as f64 - truth.sqrt()).abs();
        prop_assert!(off <= root_error(f2, &bounds) + 1e-6);
        let through = (kept.sqrt() - truth.sqrt()).abs();
        prop_assert!(through <= depth_terms(&bounds, f2).quadratic + 1e-6);
    }

    #[test]
    fn the_face_bound_is_at_most_the_sum_of_its_terms(f2 in 0i64..1 << 47, e1 in 0.0f64..1e3, e2 in 0.0f64..1e6, guards in 0u32..8, rows in 0u32..6) {
        let bounds = RoundingBounds { f1: e1, dropped_rows: rows, ..of_f2(e2, guards) };
        let terms = depth_terms(&bounds, f2);
        for face in [FACE_NEAR, FACE_FAR] {
            let bound = face_bound(&bounds, face, f2);
            prop_assert!(bound <= terms.sum() + 1e-6, "{bound} beyond {terms:?}");
            prop_assert!(bound <= worst_case(&bounds) + 1e-6);
        }
    }
}

#[test]
fn an_exact_radicand_leaves_only_the_floor() {
    assert!(root_error(16, &of_f2(0.0, 0)) < 1e-9);
    assert!(root_error(24, &of_f2(0.0, 0)) < 0.9);
    assert!(root_error(0, &of_f2(100.0, 0)) >= 10.0);
}
