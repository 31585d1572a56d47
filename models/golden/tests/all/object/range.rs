use crate::common::*;
use imogene_golden::object::range::{Range, bits};

#[test]
fn bits_of_the_ends_of_words() {
    let ends = [0, -1, 1, -2, 127, -128, 128, -129];
    assert_eq!(ends.map(bits), [1, 1, 2, 2, 8, 8, 9, 9]);
}

proptest! {
    #[test]
    fn ranges_are_those_of_all_pixels(
        q in proptest::array::uniform6(-60i64..=60), corner in [-20i64..20, -20i64..20], size in [0i64..9, 0i64..9]
    ) {
        let window = ScreenBox::of([corner[0], corner[0] + size[0]], [corner[1], corner[1] + size[1]]);
        let [a, b, c, d, e, f] = q.map(i128::from);
        let form = Quadratic::new([a, b, c, 7 * d, 7 * e, f]);
        let linear = Linear::new(a, b, c);
        let line = |y| (window.x0..=window.x1).map(move |x| (x, y));
        let pixels: Vec<(i64, i64)> = (window.y0..=window.y1).flat_map(line).collect();
        let values = |of: &dyn Fn(i64, i64) -> i128| {
            let values = || pixels.iter().map(|&(x, y)| of(x, y));
            Range { low: values().min().unwrap(), high: values().max().unwrap() }
        };
        let dropped = values(&|x, y| form.wrapped_at(x, y, 127) >> 2);
        prop_assert_eq!(Range::of_quadratic(&form, &window).dropped(2), dropped);
        prop_assert_eq!(Range::of_linear(&linear, &window), values(&|x, y| linear.wrapped_at(x, y, 127)));
    }
}
