//! PE1 and PE2.

use super::description::{Description, any_raster, last_pixel};
use super::zone::Reader;
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::pe2::Pe2;

pub(super) fn pe1(width: u32) -> Description {
    Description::new(any_raster, move || {
        let start = move |i: &[i64]| Pe1::object_start(&Reader::of(&i[3..]).linear(), width);
        let mut last = last_pixel(start, Pe1::line_step, |pe| pe.pixel() as i64);
        move |i: &[i64]| vec![last(i)]
    })
}

pub(super) fn pe2(width: u32) -> Description {
    // Second differences are even: they are twice a coefficient.
    let stimulus = |subject: &_, clocks| {
        use proptest::strategy::Strategy;
        let even = |mut list: Vec<Vec<i64>>| {
            for inputs in &mut list {
                inputs[3] &= !1;
                inputs[4] &= !1;
            }
            list
        };
        any_raster(subject, clocks).prop_map(even).boxed()
    };
    Description::new(stimulus, move || {
        let start = move |i: &[i64]| Pe2::object_start(&Reader::of(&i[3..]).quadratic(), width);
        let mut last = last_pixel(start, Pe2::line_step, |pe| pe.pixel() as i64);
        move |i: &[i64]| vec![last(i)]
    })
}
