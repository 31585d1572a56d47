//! The steps of a line one by one: for processors without AVX2, and the check of what the others run.

use crate::functions::Function;
use crate::line::{Step, Value};
use crate::size::blended;

/// What a function works on.
pub(crate) struct Work<'a> {
    pub(crate) words: &'a mut [u64],
    pub(crate) given: &'a mut [u64],
    /// The inputs of each lane, or those of all.
    pub(crate) rows: &'a [&'a [i64]],
}

/// Runs a function for the block that begins at this word.
pub(crate) fn run(functions: &[Function], index: usize, begin: usize, work: &mut Work<'_>) {
    let function = &functions[index];
    let steps = &function.line.steps;
    let of_four = function.line.of_four();
    let mut values: Vec<[u64; 4]> = Vec::with_capacity(steps.len());
    while let Some(step) = steps.get(values.len()) {
        let lanes = match of_four[values.len()] {
            true => 4,
            false => function.lanes.count(),
        };
        let is_zero = |value: Value| {
            let words = &values[value.0 as usize][..lanes];
            words.iter().all(|words| value.1.tops(*words) == 0)
        };
        match *step {
            Step::OnlyIf(which, end) if is_zero(which) => {
                // Of what is left out only constants are read behind it.
                values.extend(steps[values.len()..end].iter().map(|step| match step {
                    Step::Constant(_, words) => *words,
                    _ => [0; 4],
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

fn run_step(
    step: &Step,
    values: &[[u64; 4]],
    begin: usize,
    lanes: usize,
    work: &mut Work<'_>,
) -> [u64; 4] {
    match *step {
        Step::Constant(_, words) => return words,
        Step::Shuffle(how, a, b) => return how.of(values[a.0 as usize], values[b.0 as usize]),
        _ => {}
    }
    let mut result = [0; 4];
    for (lane, result) in result.iter_mut().enumerate().take(lanes) {
        let get = |value: Value| values[value.0 as usize][lane];
        let first = |value: Value| values[value.0 as usize][0];
        let begin = begin + lane;
        let words = &mut *work.words;
        match *step {
            Step::Load(_, place) | Step::LoadFour(place) => *result = words[begin + place],
            Step::Input(size, index) => *result = size.in_each(work.rows[0][index] as u64),
            Step::Row(row, first, count) if lane < count => {
                *result = work.rows[row][first + lane] as u64;
            }
            Step::Gather(lanes) => *result = first(lanes[lane]),
            Step::Patch(word, _) if lane == 0 => *result = first(word),
            Step::Patch(_, others) => *result = get(others),
            Step::Blend(low, high) => *result = blended(get(low), get(high)),
            Step::Two(how, a, b) => *result = how.of(a.1, get(a), get(b)),
            Step::Left(a, count) => *result = a.1.left(get(a), count),
            Step::Right(a, count) => *result = a.1.right(get(a), count),
            Step::Select(which, a, b) => {
                let tops = which.1.tops(get(which));
                *result = get(a) & tops | get(b) & !tops;
            }
            Step::Lookup(table, at) => {
                let entry = |at: u64| table[(at >> 1 & 3) as usize] >> (32 * (at & 1));
                *result = blended(entry(get(at)), entry(get(at) >> 32) << 32);
            }
            Step::Read(place, at) => *result = words[begin + place + get(at) as usize],
            Step::Store(value, place) => words[begin + place] = get(value),
            Step::Write(place, at, value) => words[begin + place + get(at) as usize] = get(value),
            Step::Give(value, place) => work.given[place + lane] = get(value),
            Step::Widen(..) | Step::Narrow(..) => unreachable!("it was split"),
            Step::Constant(..) | Step::Shuffle(..) | Step::Row(..) => {}
            Step::OnlyIf(..) | Step::Call(..) => {}
        }
    }
    result
}
