//! The steps of a line one by one: for processors without AVX2, and the check of what the others run.

use crate::code::Function;
use crate::line::{Step, Two, Value};

/// What a function works on.
pub(crate) struct Work<'a> {
    pub(crate) words: &'a mut [u64],
    pub(crate) given: &'a mut [u64],
}

/// Runs a function for the block that begins at this word.
pub(crate) fn run(functions: &[Function], index: usize, begin: usize, work: &mut Work<'_>) {
    let function = &functions[index];
    let lanes = function.lanes.count();
    for lane in 0..lanes {
        let steps = &function.line.steps;
        let mut values: Vec<u64> = Vec::with_capacity(steps.len());
        while let Some(step) = steps.get(values.len()) {
            match *step {
                Step::OnlyIf(which, end) if values[which.0 as usize] >> 63 == 0 => {
                    // Of what is left out only constants are read behind it.
                    values.extend(steps[values.len()..end].iter().map(|step| match step {
                        Step::Constant(word) => *word,
                        _ => 0,
                    }));
                }
                _ => values.push(run_step(step, &values, begin + lane, (lane, lanes), work)),
            }
        }
    }
    for step in &function.line.steps {
        if let Step::Call(part, place) = *step {
            run(functions, part, begin + place, work);
        }
    }
}

fn run_step(
    step: &Step,
    values: &[u64],
    begin: usize,
    (lane, lanes): (usize, usize),
    work: &mut Work<'_>,
) -> u64 {
    let get = |value: Value| values[value.0 as usize];
    let words = &mut *work.words;
    match *step {
        Step::Constant(word) => word,
        Step::Load(place) => words[begin + place],
        Step::Two(how, a, b) => two(how, get(a), get(b)),
        Step::Left(a, count) => get(a) << count,
        Step::Right(a, count) => get(a) >> count,
        Step::Select(which, a, b) => match get(which) >> 63 {
            1 => get(a),
            _ => get(b),
        },
        Step::Read(place, at) => words[begin + place + get(at) as usize],
        Step::Store(value, place) => {
            words[begin + place] = get(value);
            0
        }
        Step::Write(place, at, value) => {
            words[begin + place + get(at) as usize] = get(value);
            0
        }
        Step::Give(value, place) => {
            work.given[place * lanes + lane] = get(value);
            0
        }
        Step::OnlyIf(..) | Step::Call(..) => 0,
    }
}

fn two(how: Two, a: u64, b: u64) -> u64 {
    let mask = |is_so: bool| if is_so { u64::MAX } else { 0 };
    let by = |count: u64| u32::try_from(count).unwrap_or(u32::MAX);
    match how {
        Two::Add => a.wrapping_add(b),
        Two::Sub => a.wrapping_sub(b),
        Two::And => a & b,
        Two::Or => a | b,
        Two::Xor => a ^ b,
        Two::Equal => mask(a == b),
        Two::Greater => mask(a as i64 > b as i64),
        Two::LeftBy => a.checked_shl(by(b)).unwrap_or(0),
        Two::RightBy => a.checked_shr(by(b)).unwrap_or(0),
        Two::Product => u64::from(a as u32) * u64::from(b as u32),
        Two::SignedProduct => (i64::from(a as i32) * i64::from(b as i32)) as u64,
    }
}
