//! The quadric elementary processor, around a square root network.

use super::description::{Description, late, scan, stated};
use super::zone::Reader;
use crate::stimulus::raster;
use crate::subject::{Inputs, Subject};
use imogene_golden::format::{Format, wrap64};
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::pe2::Pe2;
use imogene_golden::unit::root::restoring_root;
use proptest::strategy::{BoxedStrategy, Strategy};

/// The low bits of a word as a number without sign.
pub(super) fn unsigned(value: i128, width: u32) -> u128 {
    value as u128 & (u128::MAX >> (128 - width))
}

pub(super) fn quadric_pe(format: Format, rows_per_stage: usize) -> Description {
    let root_latency = (format.root as usize).div_ceil(rows_per_stage);
    Description::new(coefficients_held, move || {
        let mut zone = None;
        let (mut late, mut late_flags) = (late(root_latency + 2), late(root_latency));
        move |i: &[i64]| {
            let flags = late_flags.push([i[0], i[1], i[2]]);
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

fn start(i: &[i64], format: &Format) -> (Pe1, Pe2) {
    let mut reader = Reader::of(&i[3..]);
    (
        Pe1::object_start(&reader.linear(), format.sum),
        Pe2::object_start(&reader.quadratic(), format.quadratic),
    )
}

fn depths(f1: i64, f2: i128, format: &Format) -> [i64; 4] {
    let radicand = unsigned(f2, format.quadratic);
    let root = restoring_root(radicand, format.root).root as i64;
    [
        wrap64(f1 - root, format.sum),
        wrap64(f1 + root, format.sum),
        root,
        i64::from(f2 >= 0),
    ]
}
