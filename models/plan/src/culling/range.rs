//! Values of an expression on a rectangle of pixels: the least and the greatest, exactly.

use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;

/// The least and the greatest of some values, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// Least.
    pub low: i128,
    /// Greatest.
    pub high: i128,
}

impl Range {
    /// One value.
    pub const fn one(value: i128) -> Range {
        Range {
            low: value,
            high: value,
        }
    }

    /// This range and a value.
    pub fn with(self, value: i128) -> Range {
        Range {
            low: self.low.min(value),
            high: self.high.max(value),
        }
    }

    /// Of a first-degree expression on a window that is not empty: it is least and greatest at corners.
    pub fn of_linear(form: &Linear, window: &ScreenBox) -> Range {
        let at = |x: i64, y: i64| form.a * i128::from(x) + form.b * i128::from(y) + form.c;
        Range::one(at(window.x0, window.y0))
            .with(at(window.x1, window.y0))
            .with(at(window.x0, window.y1))
            .with(at(window.x1, window.y1))
    }

    /// Of a second-degree expression on the pixels of a window that is not empty, line by line: on a line it is least and greatest at an end or at a pixel
    /// beside its vertex.
    pub fn of_quadratic(form: &Quadratic, window: &ScreenBox) -> Range {
        let lines = (window.y0..=window.y1).map(|y| Range::of_line(form, window, y.into()));
        let join = |p: Range, q: Range| p.with(q.low).with(q.high);
        lines.reduce(join).expect("a window of at least one line")
    }

    fn of_line(form: &Quadratic, window: &ScreenBox, y: i128) -> Range {
        let slope = form.c * y + form.d;
        let constant = (form.b * y + form.e) * y + form.f;
        let at = |x: i128| (form.a * x + slope) * x + constant;
        let (x0, x1) = (i128::from(window.x0), i128::from(window.x1));
        let ends = Range::one(at(x0)).with(at(x1));
        if form.a == 0 {
            return ends;
        }
        let vertex = (-slope).div_euclid(2 * form.a);
        let beside = |x: i128| at(x.clamp(x0, x1));
        // Division by a negative number rounds up here, so the pixels on both sides are asked.
        ends.with(beside(vertex - 1))
            .with(beside(vertex))
            .with(beside(vertex + 1))
    }

    /// Bits of a two's complement word that holds all values.
    pub const fn bits(&self) -> u32 {
        let most = bits(self.low);
        let other = bits(self.high);
        if most > other { most } else { other }
    }

    /// Does a word of `width` bits hold all values? Then a register of that width has the true value at every pixel.
    pub const fn fits(&self, width: u32) -> bool {
        self.bits() <= width
    }
}

/// Bits of a two's complement word that holds a value, at least 1.
pub const fn bits(value: i128) -> u32 {
    let magnitude = if value < 0 { !value } else { value };
    129 - magnitude.leading_zeros()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn bits_of_the_ends_of_words() {
        let cases = [
            (0, 1),
            (-1, 1),
            (1, 2),
            (-2, 2),
            (127, 8),
            (-128, 8),
            (128, 9),
            (-129, 9),
        ];
        for (value, wanted) in cases {
            assert_eq!(bits(value), wanted, "{value}");
        }
    }

    proptest! {
        #[test]
        fn ranges_are_those_of_all_pixels(
            q in proptest::array::uniform6(-60i64..=60), corner in [-20i64..20, -20i64..20], size in [0i64..9, 0i64..9]
        ) {
            let window = ScreenBox { x0: corner[0], x1: corner[0] + size[0], y0: corner[1], y1: corner[1] + size[1] };
            let [a, b, c, d, e, f] = q.map(i128::from);
            let form = Quadratic { a, b, c, d: 7 * d, e: 7 * e, f };
            let linear = Linear::new(a, b, c);
            let pixels: Vec<(i64, i64)> = (window.y0..=window.y1).flat_map(|y| (window.x0..=window.x1).map(move |x| (x, y))).collect();
            let values = |of: &dyn Fn(i64, i64) -> i128| {
                let values: Vec<i128> = pixels.iter().map(|&(x, y)| of(x, y)).collect();
                Range { low: *values.iter().min().unwrap(), high: *values.iter().max().unwrap() }
            };
            prop_assert_eq!(Range::of_quadratic(&form, &window), values(&|x, y| form.wrapped_at(x, y, 127)));
            prop_assert_eq!(Range::of_linear(&linear, &window), values(&|x, y| linear.wrapped_at(x, y, 127)));
        }
    }
}
