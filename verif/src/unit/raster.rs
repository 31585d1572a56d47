//! The raster control.

use super::description::{Description, bit};
use crate::stimulus::each;
use crate::subject::{Inputs, Subject};
use imogene_golden::machine::raster::RasterControl;
use proptest::prelude::*;

pub(super) fn raster_control() -> Description {
    Description::new(zones, || {
        let mut raster = RasterControl::default();
        move |i: &[i64]| {
            match raster.clock(bit(i[0]), i[1] as u16, i[2] as u16) {
                Some(p) => {
                    let [start, line, last] = [p.start, p.line, p.last].map(i64::from);
                    [1, start, line, p.x.into(), p.y.into(), last]
                        .map(Some)
                        .to_vec()
                }
                // Without a pixel only the flags are stated.
                None => vec![Some(0), Some(0), Some(0), None, None, Some(0)],
            }
        }
    })
}

/// Requests at random times, small zones so that many end, now and then a long line.
fn zones(_: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let go = prop_oneof![2 => Just(0i64), 1 => Just(1)].boxed();
    let side = prop_oneof![6 => 1i64..6, 1 => 1i64..40].boxed();
    each(vec![go, side.clone(), side], clocks)
}
