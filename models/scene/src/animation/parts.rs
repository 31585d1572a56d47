//! The part of an action that has been done after some of the frames of its image.

use crate::{Rotation, Scale, Step};
use imogene_algebra::rational::{from_decimal, integer, to_f64};

/// `done` of `steps` equal parts, `0 < done <= steps`; all of them are what is written, unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part {
    pub done: u32,
    pub steps: u32,
}

impl Part {
    /// The whole.
    pub const WHOLE: Part = Part { done: 1, steps: 1 };

    fn is_whole(self) -> bool {
        self.done == self.steps
    }

    /// The part of the way from one value to another: the nearest `f64` to the exact one.
    pub fn between(self, from: f64, to: f64) -> f64 {
        if self.is_whole() {
            return to;
        }
        let [done, steps] = [self.done, self.steps].map(|n| integer(i64::from(n)));
        let [from, to] = [from, to].map(from_decimal);
        to_f64(&(&from + (to - &from) * done / steps))
    }

    /// The part of a step: displacements and angles grow by equal amounts, factors by equal ratios.
    pub fn of_step(self, step: &Step) -> Step {
        if self.is_whole() {
            return step.clone();
        }
        let power = f64::from(self.done) / f64::from(self.steps);
        match step {
            Step::Translate(offset) => {
                Step::Translate(offset.map(|value| self.between(0.0, value)))
            }
            Step::Rotate(rotation) => Step::Rotate(Rotation {
                axis: rotation.axis,
                degrees: self.between(0.0, rotation.degrees),
            }),
            Step::Scale(Scale::Uniform(factor)) => Step::Scale(Scale::Uniform(factor.powf(power))),
            Step::Scale(Scale::PerAxis(factors)) => {
                Step::Scale(Scale::PerAxis(factors.map(|factor| factor.powf(power))))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_decimals_where_the_way_is_one() {
        let third = Part { done: 3, steps: 10 };
        let step = third.of_step(&Step::Translate([1.0, -2.0, 0.5]));
        assert_eq!(step, Step::Translate([0.3, -0.6, 0.15]));
        assert_eq!(third.between(1.0, 0.0), 0.7);
    }

    #[test]
    fn factors_grow_by_equal_ratios() {
        let half = Part { done: 1, steps: 2 };
        let step = half.of_step(&Step::Scale(Scale::PerAxis([4.0, 1.0, 0.25])));
        assert_eq!(step, Step::Scale(Scale::PerAxis([2.0, 1.0, 0.5])));
    }

    #[test]
    fn the_whole_is_what_is_written() {
        // 1.1 ^ 1.0 and 0.1 * 3 / 3 could come back as a neighbour.
        let step = Step::Scale(Scale::Uniform(1.1));
        let all = Part { done: 7, steps: 7 };
        assert_eq!(all.of_step(&step), step);
        assert_eq!(all.between(0.3, 0.1), 0.1);
    }
}
