//! The programmable elementary processor.

use super::description::{Description, any_raster, bit};
use imogene_golden::format::Format;
use imogene_golden::unit::pe2::PreconditionedWords;
use imogene_golden::unit::programmable::{Programmable, ProgrammableWords};

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
