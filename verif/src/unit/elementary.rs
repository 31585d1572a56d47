//! PE1 and PE2.

use super::Description;
use super::{any_raster, bit};
use crate::subject::GoldenFn;
use imogene_golden::unit::pe1::{Linear, Pe1};
use imogene_golden::unit::pe2::{Pe2, Quadratic};

pub(super) fn pe1(width: u32) -> Description {
    Description {
        golden: Box::new(move || {
            let mut pe: Option<Pe1> = None;
            let mut value = None;
            Box::new(GoldenFn(move |i: &[i64]| {
                if bit(i[0]) {
                    if bit(i[1]) {
                        let words = Linear::new(i[3].into(), i[4].into(), i[5].into());
                        pe = Some(Pe1::object_start(&words, width));
                    } else if bit(i[2])
                        && let Some(pe) = &mut pe
                    {
                        pe.line_step();
                    }
                    value = pe.as_mut().map(|pe| pe.pixel() as i64);
                }
                vec![value]
            }))
        }),
        stimulus: any_raster,
    }
}

/// The coefficients whose preconditioned words these are, modulo the width: the golden model takes a..f.
///
/// `a2 = 2a` and `b2 = 2b` have no unique half modulo 2^n, but the halves may be taken in one bit more.
fn unconditioned(words: &[i64]) -> Quadratic {
    let [a2, b2, c, i0, p0, f] = [0, 1, 2, 3, 4, 5].map(|k| i128::from(words[k]));
    let (a, b) = (a2 / 2, b2 / 2);
    Quadratic {
        a,
        b,
        c,
        d: p0 - a,
        e: i0 - b,
        f,
    }
}

pub(super) fn pe2(width: u32) -> Description {
    Description {
        golden: Box::new(move || {
            let mut pe: Option<Pe2> = None;
            let mut value = None;
            Box::new(GoldenFn(move |i: &[i64]| {
                if bit(i[0]) {
                    if bit(i[1]) {
                        pe = Some(Pe2::object_start(&unconditioned(&i[3..]), width));
                    } else if bit(i[2])
                        && let Some(pe) = &mut pe
                    {
                        pe.line_step();
                    }
                    value = pe.as_mut().map(|pe| pe.pixel() as i64);
                }
                vec![value]
            }))
        }),
        // Second differences are even: they are twice a coefficient.
        stimulus: |subject, clocks| {
            use proptest::strategy::Strategy;
            any_raster(subject, clocks)
                .prop_map(|mut list| {
                    for inputs in &mut list {
                        inputs[3] &= !1;
                        inputs[4] &= !1;
                    }
                    list
                })
                .boxed()
        },
    }
}
