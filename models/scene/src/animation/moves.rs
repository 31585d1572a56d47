//! Parts of actions after some of the frames of an image, and what they add to a placement, kept short.

use crate::image::MoveFrame;
use crate::step::{Rotation, Scale, Step};
use imogene_algebra::rational::{from_decimal, integer, to_f64};

/// `done` of `steps` equal parts, `0 < done <= steps`; all of them are what is written, unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Parts that are done.
    pub done: u32,
    /// Parts of the whole.
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

/// What actions add to the placement of one element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moves {
    /// In its own frame: before the placement that is written.
    own: Vec<Step>,
    /// In the frame of its group: after it.
    parent: Vec<Step>,
}

impl Moves {
    /// Adds a step, in one with the last one in its frame where the sum of both is one step.
    pub fn add(&mut self, step: Step, frame: MoveFrame) {
        let last = match frame {
            MoveFrame::Parent => self.parent.last_mut(),
            MoveFrame::Own => self.own.first_mut(),
        };
        match (last, frame) {
            (Some(last), _) if let Some(sum) = sum(last, &step) => *last = sum,
            (_, MoveFrame::Parent) => self.parent.push(step),
            (_, MoveFrame::Own) => self.own.insert(0, step),
        }
    }

    /// Steps that are not one.
    pub fn count(&self) -> usize {
        self.own.len() + self.parent.len()
    }

    /// The whole placement.
    pub fn around(&self, place: &[Step]) -> Vec<Step> {
        let all = self.own.iter().chain(place).chain(&self.parent);
        all.cloned().collect()
    }
}

/// Two steps as one: turns about the same axis by the sum of their angles, displacements by theirs where it is a number
/// that can be written.
///
/// Without the first the entries of a placement would grow by the digits of a sine at every turn of a long animation.
fn sum(one: &Step, other: &Step) -> Option<Step> {
    let exact = |a: f64, b: f64| from_decimal(a) + from_decimal(b);
    match (one, other) {
        (Step::Rotate(a), Step::Rotate(b)) if a.axis == b.axis => Some(Step::Rotate(Rotation {
            axis: a.axis,
            degrees: to_f64(&exact(a.degrees, b.degrees)),
        })),
        (Step::Translate(a), Step::Translate(b)) => {
            let sums: [_; 3] = std::array::from_fn(|k| exact(a[k], b[k]));
            let rounded = sums.each_ref().map(to_f64);
            let kept = sums.iter().zip(rounded).all(|(s, r)| from_decimal(r) == *s);
            kept.then_some(Step::Translate(rounded))
        }
        _ => None,
    }
}
