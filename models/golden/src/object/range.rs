//! Values of an expression on a rectangle of pixels: the least and the greatest, exactly.

use super::screen_box::ScreenBox;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;

/// The least and the greatest of some values, both included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Range {
    /// Least.
    pub low: i128,
    /// Greatest.
    pub high: i128,
}

impl Range {
    /// Of no value.
    pub const NONE: Range = Range::between(i128::MAX, i128::MIN);

    const fn between(low: i128, high: i128) -> Range {
        Range { low, high }
    }

    /// This range and a value.
    pub fn with(self, value: i128) -> Range {
        self.merged(Range::between(value, value))
    }

    /// The least range around two.
    pub fn merged(self, other: Range) -> Range {
        Range::between(self.low.min(other.low), self.high.max(other.high))
    }

    /// Of the values without guard bits: a shift keeps the order.
    pub const fn dropped(self, guards: u32) -> Range {
        Range::between(self.low >> guards, self.high >> guards)
    }

    /// Of a first-degree expression on a window that is not empty: it is least and greatest at corners.
    pub fn of_linear(form: &Linear, window: &ScreenBox) -> Range {
        let line = |y: i64| {
            [window.x0, window.x1].map(|x| form.a * i128::from(x) + form.b * i128::from(y) + form.c)
        };
        let corners = [line(window.y0), line(window.y1)];
        corners.into_iter().flatten().collect()
    }

    /// Of a second-degree expression on the pixels of a window that is not empty, line by line.
    pub fn of_quadratic(form: &Quadratic, window: &ScreenBox) -> Range {
        let line = |y: i64| {
            let y = i128::from(y);
            let (slope, constant) = (form.c * y + form.d, (form.b * y + form.e) * y + form.f);
            Range::of_parabola([form.a, slope, constant], window.x0, window.x1)
        };
        let lines = (window.y0..=window.y1).map(line);
        lines.fold(Range::NONE, Range::merged)
    }

    /// Of `a t^2 + b t + c` at the integers from `first` to `last`: it is extreme at an end, or beside its vertex.
    pub fn of_parabola([a, b, c]: [i128; 3], first: i64, last: i64) -> Range {
        let (first, last) = (i128::from(first), i128::from(last));
        let vertex = (a != 0).then(|| (-b).div_euclid(2 * a));
        // Division by a negative number rounds up here, so the integers on both sides are asked.
        let beside = vertex.into_iter().flat_map(|t| [t - 1, t, t + 1]);
        let inside = beside.filter(|t| (first..=last).contains(t));
        let all = [first, last].into_iter().chain(inside);
        all.map(|t| (a * t + b) * t + c).collect()
    }

    /// Bits of a two's complement word that holds all values.
    pub const fn bits(&self) -> u32 {
        let (low, high) = (bits(self.low), bits(self.high));
        if low > high { low } else { high }
    }

    /// Does a word of `width` bits hold all values? Then a register of that width has the true value at every pixel.
    pub const fn fits(&self, width: u32) -> bool {
        self.bits() <= width
    }
}

impl FromIterator<i128> for Range {
    fn from_iter<T: IntoIterator<Item = i128>>(values: T) -> Range {
        values.into_iter().fold(Range::NONE, Range::with)
    }
}

/// Bits of a two's complement word that holds a value, at least 1.
pub const fn bits(value: i128) -> u32 {
    let magnitude = if value < 0 { !value } else { value };
    129 - magnitude.leading_zeros()
}
