//! The family of square root networks, and the quadric elementary processor around one of them.

use super::description::{Description, bit, late, scan, stated};
use super::words::{Ports, read};
use crate::stimulus::{each, hold, mapped, radicand, raster};
use crate::subject::{Stimuli, Subject};
use imogene_golden::format::{Format, wrap64};
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::pe2::Pe2;
use imogene_golden::unit::root::iterative::IterativeRoot;
use imogene_golden::unit::root::{Method, root};
use proptest::prelude::*;

/// The low bits of a word as a number without sign.
fn unsigned(value: i128, width: u32) -> u128 {
    value as u128 & (u128::MAX >> (128 - width))
}

/// A free running member: one radicand and one result each clock.
pub(super) fn network(format: Format, method: Method, rows_per_stage: usize) -> Description {
    let latency = method.latency(format.root, rows_per_stage as u32) as usize;
    let radicands = |s: &Subject, clocks| each(vec![radicand(&s.inputs[0])], clocks);
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

pub(super) fn iterative(format: Format) -> Description {
    Description::new(starts, move || {
        let mut unit = IterativeRoot::new(format.root);
        move |i: &[i64]| {
            let shown = unit.clock(bit(i[0]), unsigned(i[1].into(), format.quadratic));
            let [busy, done] = [shown.busy, shown.done].map(i64::from);
            let values = [busy, done, shown.root as i64, shown.remainder as i64];
            values.map(Some).to_vec()
        }
    })
}

/// Starts at any time, many of them during the work and some beside `done`.
fn starts(subject: &Subject, clocks: usize) -> Stimuli {
    let start = prop_oneof![3 => Just(1i64), 1 => Just(0i64)].boxed();
    each(vec![start, radicand(&subject.inputs[1])], clocks)
}

pub(super) fn quadric_pe(format: Format, rows_per_stage: usize) -> Description {
    let root_latency = format.root_latency(rows_per_stage as u32) as usize;
    Description::new(any_words, move || {
        let mut zone = None;
        // Outputs are read behind the edge: a flag without a register stands where one with a register would.
        let (mut late, mut early) = (late(root_latency + 2), late((root_latency - 1).max(1)));
        move |i: &[i64]| {
            let flags = early.push([i[0], i[1], i[2]]);
            let line_step = |(f1, f2): &mut (Pe1, Pe2)| {
                f1.line_step();
                f2.line_step();
            };
            let pixel = scan(&mut zone, i, || start(i, &format), line_step);
            let found = pixel.map(|(f1, f2)| depths(f1.pixel() as i64, f2.pixel(), &format));
            [stated(late.push(found).flatten()), stated(flags)].concat()
        }
    })
}

/// Where the ports of f1 and f2 begin, and that of the value with which f2 does.
const F1: usize = 3;
const F2: usize = 6;
const F2_VALUE: usize = 11;

/// Words change where the root network has drained: the processor of f1 starts behind it.
///
/// Half of the time f2 begins at or beside a square and goes on in small steps, where roots are told apart.
fn any_words(subject: &Subject, clocks: usize) -> Stimuli {
    let rows = subject.latency - 2;
    let words = subject.inputs.len();
    let f2 = &subject.inputs[F2_VALUE];
    let near = (radicand(f2), f2.width - 4..f2.width);
    let near = proptest::collection::vec(proptest::option::of(near), clocks);
    mapped((raster(subject, clocks), near), move |(mut list, near)| {
        for (inputs, near) in list.iter_mut().zip(near) {
            if let Some((value, by)) = near {
                let steps = inputs[F2..F2_VALUE].iter_mut();
                steps.for_each(|step| *step >>= by);
                inputs[F2_VALUE] = value;
            }
            // Second differences are even: they are twice a coefficient.
            inputs[F2..F2 + 2].iter_mut().for_each(|step| *step &= !1);
        }
        hold(&mut list, F1..words, rows + 1);
        list
    })
}

fn start(i: &[i64], format: &Format) -> (Pe1, Pe2) {
    let f1 = Pe1::object_start(&read(&i[F1..], format, Ports::line), format.sum);
    let f2 = read(&i[F2..], format, Ports::quadratic);
    (f1, Pe2::object_start(&f2, format.quadratic))
}

fn depths(f1: i64, f2: i128, format: &Format) -> [i64; 4] {
    // The network does not see the sign of f2.
    let radicand = unsigned(f2, format.quadratic - 1);
    let root = root(Method::of(format.root_form), radicand, format.root).root as i64;
    let [near, far] = [f1 - root, f1 + root].map(|sum| wrap64(sum, format.sum));
    [near, far, root, i64::from(f2 >= 0)]
}
