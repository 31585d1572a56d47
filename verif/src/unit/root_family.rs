//! The other members of the family of square root networks.

use super::root::radicands;
use super::{Description, Late, bit};
use crate::stimulus::radicand;
use crate::subject::{GoldenFn, Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::root::iterative::IterativeRoot;
use imogene_golden::unit::root::{Method, root};
use proptest::prelude::*;

pub(super) fn non_restoring(format: Format, rows_per_stage: usize) -> Description {
    network(format, Method::NonRestoring, rows_per_stage)
}

pub(super) fn rows(format: Format, kept: u32, rows_per_stage: usize) -> Description {
    network(format, Method::Rows { kept }, rows_per_stage)
}

pub(super) fn leading(format: Format, kept: u32, rows_per_stage: usize) -> Description {
    network(format, Method::Leading { kept }, rows_per_stage)
}

pub(super) fn linear(format: Format, corrections: u32) -> Description {
    network(format, Method::Linear { corrections }, 1)
}

pub(super) fn quadratic(format: Format, corrections: u32) -> Description {
    network(format, Method::Quadratic { corrections }, 1)
}

/// A free running member: one radicand and one result each clock.
fn network(format: Format, method: Method, rows_per_stage: usize) -> Description {
    let latency = method.latency(format.root, rows_per_stage as u32) as usize;
    Description {
        golden: Box::new(move || {
            let mut late = Late::new(latency);
            Box::new(GoldenFn(move |i: &[i64]| {
                let found = late.push(root(method, unsigned(i[0], format.quadratic), format.root));
                let mut values = vec![found.map(|r| r.root as i64)];
                if method.is_exact() {
                    values.push(found.and_then(|r| r.remainder).map(|r| r as i64));
                }
                values
            }))
        }),
        stimulus: radicands,
    }
}

fn unsigned(value: i64, width: u32) -> u128 {
    u128::from(value as u64) & (u128::MAX >> (128 - width))
}

pub(super) fn iterative(format: Format) -> Description {
    Description {
        golden: Box::new(move || {
            let mut unit = IterativeRoot::new(format.root);
            Box::new(GoldenFn(move |i: &[i64]| {
                let shown = unit.clock(bit(i[0]), unsigned(i[1], format.quadratic));
                vec![
                    Some(shown.busy.into()),
                    Some(shown.done.into()),
                    Some(shown.root as i64),
                    Some(shown.remainder as i64),
                ]
            }))
        }),
        stimulus: starts,
    }
}

/// Starts at any time, many of them during the work and some beside `done`.
fn starts(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let start = prop_oneof![3 => Just(1i64), 1 => Just(0i64)];
    let one = (start, radicand(&subject.inputs[1])).prop_map(|(start, value)| vec![start, value]);
    proptest::collection::vec(one, clocks).boxed()
}
