//! The elementary processors: PE1, PE2 and the programmable one.

use super::description::{Description, any_raster, bit, last_pixel, zones};
use super::words::{Ports, read};
use imogene_golden::format::Format;
use imogene_golden::unit::pe1::Pe1;
use imogene_golden::unit::pe2::{Pe2, PreconditionedWords};
use imogene_golden::unit::programmable::{Programmable, ProgrammableWords};

pub(super) fn pe1(format: Format) -> Description {
    Description::new(zones, move || {
        let words = move |i: &[i64]| read(&i[3..], &format, Ports::line);
        let start = move |i: &[i64]| Pe1::object_start(&words(i), format.sum);
        let mut last = last_pixel(start, Pe1::line_step, |pe| pe.pixel() as i64);
        move |i: &[i64]| vec![last(i)]
    })
}

pub(super) fn pe2(format: Format) -> Description {
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
        zones(subject, clocks).prop_map(even).boxed()
    };
    Description::new(stimulus, move || {
        let words = move |i: &[i64]| read(&i[3..], &format, Ports::quadratic);
        let start = move |i: &[i64]| Pe2::object_start(&words(i), format.quadratic);
        let mut last = last_pixel(start, Pe2::line_step, |pe| pe.pixel() as i64);
        move |i: &[i64]| vec![last(i)]
    })
}

pub(super) fn programmable_pe(format: Format) -> Description {
    Description::new(any_raster, move || {
        let mut pe: Option<Programmable> = None;
        let mut inside = None;
        move |i: &[i64]| {
            if bit(i[0]) {
                match &mut pe {
                    _ if bit(i[1]) => {
                        pe = Some(Programmable::start(&words_of(i), format.depth));
                    }
                    Some(pe) if bit(i[2]) => pe.next_line(),
                    Some(pe) => pe.next_pixel(),
                    None => {}
                }
            }
            // The decision is a clock behind the values.
            let Some(pe) = &pe else { return vec![None; 6] };
            let pixel = pe.pixel();
            let mut values = vec![Some(pixel.value as i64)];
            values.extend(pixel.lanes.map(|lane| Some(lane as i64)));
            values.push(inside.replace(i64::from(pixel.inside)));
            values
        }
    })
}

fn words_of(i: &[i64]) -> ProgrammableWords {
    let [a2, b2, c, i0, p0, f] = [5, 6, 7, 8, 9, 10].map(|k| i128::from(i[k]));
    ProgrammableWords {
        split: bit(i[3]),
        words: PreconditionedWords {
            a2,
            b2,
            c,
            i0,
            p0,
            f,
        },
        used: [0, 1, 2, 3].map(|lane| i[4] >> lane & 1 == 1),
    }
}
