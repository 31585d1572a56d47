//! The square root network and the quadric elementary processor around it.

use super::Description;
use super::{Late, bit};
use crate::stimulus::{radicand, raster};
use crate::subject::{GoldenFn, Inputs, Subject};
use imogene_golden::format::{Format, wrap64};
use imogene_golden::unit::pe1::{Linear, Pe1};
use imogene_golden::unit::pe2::{Pe2, Quadratic};
use imogene_golden::unit::root::restoring_root;
use proptest::strategy::{BoxedStrategy, Strategy};

pub(super) fn square_root(format: Format, rows_per_stage: usize) -> Description {
    Description {
        golden: Box::new(move || {
            let mut late = Late::new((format.root as usize).div_ceil(rows_per_stage));
            Box::new(GoldenFn(move |i: &[i64]| {
                let radicand = u128::from(i[0] as u64) & (u128::MAX >> (128 - format.quadratic));
                match late.push(restoring_root(radicand, format.root)) {
                    Some(r) => vec![Some(r.root as i64), Some(r.remainder as i64)],
                    None => vec![None, None],
                }
            }))
        }),
        stimulus: radicands,
    }
}

pub(super) fn radicands(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let one = radicand(&subject.inputs[0]).prop_map(|value| vec![value]);
    proptest::collection::vec(one, clocks).boxed()
}

pub(super) fn quadric_pe(format: Format, rows_per_stage: usize) -> Description {
    Description {
        golden: Box::new(move || Box::new(GoldenFn(golden_quadric_pe(format, rows_per_stage)))),
        stimulus: coefficients_held,
    }
}

/// Sets of coefficients in a stimulus.
const SETS: usize = 4;
/// Clocks without a pixel between two sets, more than the deepest network has.
const PAUSE: usize = 40;

/// The f1 processor starts later than the f2 processor, so coefficients change only when the pipeline has drained.
fn coefficients_held(subject: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let one_set = raster(&subject.inputs, (clocks / SETS).max(1)).prop_map(|mut list| {
        let held: Vec<i64> = list[0][3..].to_vec();
        for inputs in &mut list {
            inputs[3..].copy_from_slice(&held);
            // Second differences are even: they are twice a coefficient.
            inputs[6] &= !1;
            inputs[7] &= !1;
        }
        let mut rest = list[0].clone();
        rest[..3].fill(0);
        list.extend(std::iter::repeat_n(rest, PAUSE));
        list
    });
    proptest::collection::vec(one_set, SETS)
        .prop_map(|sets| sets.concat())
        .boxed()
}

fn golden_quadric_pe(
    format: Format,
    rows_per_stage: usize,
) -> impl FnMut(&[i64]) -> Vec<Option<i64>> {
    let mut processors: Option<(Pe1, Pe2)> = None;
    let root_latency = (format.root as usize).div_ceil(rows_per_stage);
    let mut late = Late::new(root_latency + 2);
    let mut late_flags = Late::new(root_latency);
    move |i: &[i64]| {
        let flags = late_flags.push([i[0], i[1], i[2]]);
        let mut result = None;
        if bit(i[0]) {
            if bit(i[1]) {
                processors = Some(start(i, &format));
            } else if bit(i[2])
                && let Some((f1, f2)) = &mut processors
            {
                f1.line_step();
                f2.line_step();
            }
            result = processors
                .as_mut()
                .map(|(f1, f2)| depths(f1.pixel() as i64, f2.pixel(), &format));
        }
        let depths = match late.push(result).flatten() {
            Some(values) => values.map(Some).to_vec(),
            None => vec![None; 4],
        };
        let flags = match flags {
            Some(flags) => flags.map(Some).to_vec(),
            None => vec![None; 3],
        };
        [depths, flags].concat()
    }
}

fn start(i: &[i64], format: &Format) -> (Pe1, Pe2) {
    let w = |k: usize| i128::from(i[k]);
    let (a, b) = (w(6) / 2, w(7) / 2);
    let f2 = Quadratic {
        a,
        b,
        c: w(8),
        d: w(10) - a,
        e: w(9) - b,
        f: w(11),
    };
    (
        Pe1::object_start(&Linear::new(w(3), w(4), w(5)), format.sum),
        Pe2::object_start(&f2, format.quadratic),
    )
}

fn depths(f1: i64, f2: i128, format: &Format) -> [i64; 4] {
    let radicand = f2 as u128 & (u128::MAX >> (128 - format.quadratic));
    let root = restoring_root(radicand, format.root).root as i64;
    [
        wrap64(f1 - root, format.sum),
        wrap64(f1 + root, format.sum),
        root,
        i64::from(f2 >= 0),
    ]
}
