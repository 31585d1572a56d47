//! The steps that actions add to a placement, kept short.

use crate::{MoveFrame, Rotation, Step};
use imogene_algebra::rational::{from_decimal, to_f64};

/// What actions add to the placement of one element.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Moves {
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
    pub fn len(&self) -> usize {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Axis;

    fn turn(axis: Axis, degrees: f64) -> Step {
        Step::Rotate(Rotation { axis, degrees })
    }

    #[test]
    fn turns_about_one_axis_are_one_turn() {
        let mut moves = Moves::default();
        for degrees in [10.1, 20.2] {
            moves.add(turn(Axis::Z, degrees), MoveFrame::Own);
            moves.add(turn(Axis::X, degrees), MoveFrame::Parent);
        }
        moves.add(Step::Translate([0.1, 0.0, 0.0]), MoveFrame::Parent);
        moves.add(Step::Translate([0.2, 0.0, 0.0]), MoveFrame::Parent);
        let place = [Step::Translate([1.0; 3])];
        let wanted = [
            turn(Axis::Z, 30.3),
            place[0].clone(),
            turn(Axis::X, 30.3),
            Step::Translate([0.3, 0.0, 0.0]),
        ];
        assert_eq!(moves.around(&place), wanted);
    }

    #[test]
    fn displacements_whose_sum_has_too_many_digits_stay_two() {
        let mut moves = Moves::default();
        for offset in [1e12, 1e-12] {
            moves.add(Step::Translate([offset, 0.0, 0.0]), MoveFrame::Parent);
        }
        assert_eq!(moves.len(), 2);
    }

    #[test]
    fn a_later_step_in_its_own_frame_comes_first() {
        let mut moves = Moves::default();
        moves.add(turn(Axis::Z, 90.0), MoveFrame::Own);
        moves.add(Step::Translate([1.0, 0.0, 0.0]), MoveFrame::Own);
        let wanted = [Step::Translate([1.0, 0.0, 0.0]), turn(Axis::Z, 90.0)];
        assert_eq!(moves.around(&[]), wanted);
    }
}
