use imogene_algebra::rational::integer;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::forms::QuadraticForm;
use proptest::prelude::*;

fn form(v: [i64; 6]) -> QuadraticForm {
    QuadraticForm::of_array(v.map(integer))
}

proptest! {
    #[test]
    fn range_holds_every_pixel_and_is_attained_nearby(
        v in proptest::array::uniform6(-9i64..9), w in 1i64..12, h in 1i64..12, x0 in -9i64..9, y0 in -9i64..9
    ) {
        let q = form(v);
        let window = ScreenBox { x0, x1: x0 + w, y0, y1: y0 + h };
        let (least, greatest) = q.range_on(&window);
        for x in x0..=x0 + w {
            for y in y0..=y0 + h {
                let value = q.at(&integer(x), &integer(y));
                prop_assert!(least <= value && value <= greatest);
            }
        }
    }

    #[test]
    fn translation_moves_the_origin(
        v in proptest::array::uniform6(-9i64..9), dx in -9i64..9, dy in -9i64..9, x in -9i64..9, y in -9i64..9
    ) {
        let q = form(v);
        let moved = q.about(&integer(dx), &integer(dy));
        prop_assert_eq!(moved.at(&integer(x), &integer(y)), q.at(&integer(x + dx), &integer(y + dy)));
    }
}
