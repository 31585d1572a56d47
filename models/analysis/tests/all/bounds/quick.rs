use imogene_analysis::bounds::quick::near_zero;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{ExactForms, NeededWidths, PreparedQuadric, RoundingBounds, forms};
use proptest::prelude::*;

proptest! {
    /// No open pixel is passed over, wherever the roots lie.
    #[test]
    fn every_open_pixel_is_among_the_candidates(
        v in proptest::array::uniform6(-40i128..40), scale in 0u32..24, e2 in 0.0f64..3000.0, x0 in 0i64..600, y0 in 0i64..400
    ) {
        let unit = 1i128 << scale;
        let about = Quadratic::new([v[0] * unit, v[1] * unit, v[2] * unit, v[3] * unit, v[4] * unit, v[5] * unit]);
        let window = ScreenBox::of([x0, x0 + 20], [y0, y0 + 14]);
        let words = imogene_golden::object::quadric::QuadricWords {
            class: Class::Side,
            screen_box: window,
            f1: Default::default(),
            f2: about.from_zone(-x0 - 9, -y0 - 7),
            normal: Default::default(),
            planes: vec![],
        };
        let object = PreparedQuadric {
            name: "any".into(),
            words,
            exact: ExactForms { f1: forms::LinearForm::zero(), f2: forms::QuadraticForm::zero(), planes: vec![] },
            anchor: Anchor::ORIGIN,
            bounds: RoundingBounds { f2: e2, ..RoundingBounds::of_format(&Format::BASE) },
            needed: NeededWidths::default(),
            notes: vec![],
        };
        for y in window.y0..=window.y1 {
            let candidates = near_zero(&object, &Format::BASE, y);
            for x in window.x0..=window.x1 {
                let open = object.words.f2_at(x, y, &Format::BASE).abs() as f64 <= e2;
                let found = candidates.iter().any(|[low, high]| (*low..=*high).contains(&x));
                prop_assert!(!open || found, "({x}, {y})");
            }
        }
    }
}
