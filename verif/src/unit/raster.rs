//! The raster control.

use super::description::Description;
use super::description::bit;
use crate::subject::{Inputs, Subject};
use imogene_golden::machine::raster::RasterControl;
use proptest::prelude::*;

pub(super) fn raster_control() -> Description {
    Description::new(zones, || {
        let mut raster = RasterControl::default();
        move |i: &[i64]| {
            match raster.clock(bit(i[0]), i[1] as u16, i[2] as u16) {
                Some(p) => vec![
                    Some(1),
                    Some(p.start.into()),
                    Some(p.line.into()),
                    Some(p.x.into()),
                    Some(p.y.into()),
                    Some(p.last.into()),
                ],
                // Without a pixel only the flags are stated.
                None => vec![Some(0), Some(0), Some(0), None, None, Some(0)],
            }
        }
    })
}

/// Requests at random times, small zones so that many end, now and then a long line.
fn zones(_: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let side = prop_oneof![6 => 1i64..6, 1 => 1i64..40];
    let one = (
        prop_oneof![2 => Just(0i64), 1 => Just(1)],
        side.clone(),
        side,
    )
        .prop_map(|(go, width, height)| vec![go, width, height]);
    proptest::collection::vec(one, clocks).boxed()
}
