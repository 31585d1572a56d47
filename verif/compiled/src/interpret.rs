//! The steps of a line one by one: for processors without AVX2, and the check of what the others run.

use crate::functions::Function;
use crate::layout::MOST_LANES;
use crate::line::{Step, Value};

/// What a function works on.
pub(crate) struct Work<'a> {
    pub(crate) words: &'a mut [u64],
    pub(crate) given: &'a mut [u64],
    /// The inputs of each lane.
    pub(crate) rows: &'a [&'a [i64]; MOST_LANES],
}

/// Runs a function for the block that begins at this word.
pub(crate) fn run(functions: &[Function], index: usize, begin: usize, work: &mut Work<'_>) {
    let function = &functions[index];
    let steps = &function.line.steps;
    let of_four = function.line.of_four();
    let mut values: Vec<[u64; MOST_LANES]> = Vec::with_capacity(steps.len());
    while let Some(step) = steps.get(values.len()) {
        let lanes = match of_four[values.len()] {
            true => 4,
            false => function.lanes.count(),
        };
        let top = |value: Value| values[value.0 as usize][..lanes].iter().max();
        match *step {
            Step::OnlyIf(which, end) if top(which).is_some_and(|word| word >> 63 == 0) => {
                // Of what is left out only constants are read behind it.
                values.extend(steps[values.len()..end].iter().map(|step| match step {
                    Step::Constant(words) => in_lanes(*words),
                    _ => [0; MOST_LANES],
                }));
            }
            _ => values.push(run_step(step, &values, begin, lanes, work)),
        }
    }
    for step in steps {
        if let Step::Call(part, place) = *step {
            run(functions, part, begin + place, work);
        }
    }
}

/// A constant in every lane; in more than four it is the same in each.
fn in_lanes(words: [u64; 4]) -> [u64; MOST_LANES] {
    std::array::from_fn(|lane| words[lane % 4])
}

fn run_step(
    step: &Step,
    values: &[[u64; MOST_LANES]],
    begin: usize,
    lanes: usize,
    work: &mut Work<'_>,
) -> [u64; MOST_LANES] {
    if let Step::Constant(words) = *step {
        return in_lanes(words);
    }
    let mut result = [0; MOST_LANES];
    for (lane, result) in result.iter_mut().enumerate().take(lanes) {
        let get = |value: Value| values[value.0 as usize][lane];
        let first = |value: Value| values[value.0 as usize][0];
        let begin = begin + lane;
        let words = &mut *work.words;
        match *step {
            Step::Load(place) | Step::LoadFour(place) => *result = words[begin + place],
            Step::Input(index) => *result = work.rows[lane][index] as u64,
            Step::Gather(lanes) => *result = first(lanes[lane]),
            Step::Patch(word, _) if lane == 0 => *result = first(word),
            Step::Patch(_, others) => *result = get(others),
            Step::Two(how, a, b) => *result = how.of(get(a), get(b)),
            Step::Left(a, count) => *result = get(a) << count,
            Step::Right(a, count) => *result = get(a) >> count,
            Step::Select(which, a, _) if get(which) >> 63 == 1 => *result = get(a),
            Step::Select(_, _, b) => *result = get(b),
            Step::Read(place, at) => *result = words[begin + place + get(at) as usize],
            Step::Store(value, place) => words[begin + place] = get(value),
            Step::Write(place, at, value) => words[begin + place + get(at) as usize] = get(value),
            Step::Give(value, place) => work.given[place * lanes + lane] = get(value),
            Step::Constant(_) | Step::OnlyIf(..) | Step::Call(..) => {}
        }
    }
    result
}
