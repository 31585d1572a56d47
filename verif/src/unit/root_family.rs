//! The family of square root networks.

use super::description::{Description, bit, late};
use super::root::unsigned;
use crate::stimulus::{each, radicand};
use crate::subject::{Inputs, Subject};
use imogene_golden::format::Format;
use imogene_golden::unit::root::iterative::IterativeRoot;
use imogene_golden::unit::root::{Method, root};
use proptest::prelude::*;

/// A free running member: one radicand and one result each clock.
pub(super) fn network(format: Format, method: Method, rows_per_stage: usize) -> Description {
    let latency = method.latency(format.root, rows_per_stage as u32) as usize;
    Description::new(radicands, move || {
        let mut late = late(latency);
        move |i: &[i64]| {
            let radicand = unsigned(i[0].into(), format.quadratic);
            let found = late.push(root(method, radicand, format.root));
            let mut values = vec![found.map(|r| r.root as i64)];
            if method.is_exact() {
                values.push(found.and_then(|r| r.remainder).map(|r| r as i64));
            }
            values
        }
    })
}

fn radicands(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    each(vec![radicand(&subject.inputs[0])], clocks)
}

pub(super) fn iterative(format: Format) -> Description {
    Description::new(starts, move || {
        let mut unit = IterativeRoot::new(format.root);
        move |i: &[i64]| {
            let shown = unit.clock(bit(i[0]), unsigned(i[1].into(), format.quadratic));
            vec![
                Some(shown.busy.into()),
                Some(shown.done.into()),
                Some(shown.root as i64),
                Some(shown.remainder as i64),
            ]
        }
    })
}

/// Starts at any time, many of them during the work and some beside `done`.
fn starts(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let start = prop_oneof![3 => Just(1i64), 1 => Just(0i64)].boxed();
    each(vec![start, radicand(&subject.inputs[1])], clocks)
}
