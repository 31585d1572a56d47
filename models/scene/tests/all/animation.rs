use imogene_scene::animation::{Moves, Part};
use imogene_scene::{Axis, MoveFrame, Rotation, Scale, Step};

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
    assert_eq!(moves.count(), 2);
}

#[test]
fn a_later_step_in_its_own_frame_comes_first() {
    let mut moves = Moves::default();
    moves.add(turn(Axis::Z, 90.0), MoveFrame::Own);
    moves.add(Step::Translate([1.0, 0.0, 0.0]), MoveFrame::Own);
    let wanted = [Step::Translate([1.0, 0.0, 0.0]), turn(Axis::Z, 90.0)];
    assert_eq!(moves.around(&[]), wanted);
}

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
