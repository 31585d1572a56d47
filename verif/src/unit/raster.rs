//! The raster control, and the raster of a screen.

use super::description::{Description, bit};
use crate::stimulus::each;
use crate::subject::{Inputs, Subject};
use imogene_contract::video::{LEAD, VideoMode};
use imogene_contract::words::COORDINATE;
use imogene_golden::machine::raster::RasterControl;
use imogene_golden::machine::video_timing::{Shown, VideoTiming};
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
    .reached_in(3 << COORDINATE)
}

/// Requests at random times, small zones so that many end, now and then a long line or a high column.
fn zones(_: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let go = prop_oneof![2 => Just(0i64), 1 => Just(1)];
    let sides = prop_oneof![
        24 => (1i64..6, 1i64..6),
        2 => (1i64..40, 1i64..40),
        1 => (1i64..1 << COORDINATE, 1i64..3),
        1 => (1i64..3, 1i64..1 << COORDINATE),
    ];
    let each = (go, sides).prop_map(|(go, (width, height))| vec![go, width, height]);
    proptest::collection::vec(each, clocks).boxed()
}

pub(super) fn video_timing(mode: usize) -> Description {
    let mode = VideoMode::ALL[mode];
    let frame = mode.clocks() as usize;
    Description::new(mostly_enabled, move || {
        let mut timing = VideoTiming::new(mode, LEAD as u64);
        move |i: &[i64]| {
            let at = timing.clock(bit(i[0]));
            let mut values = shown(&at.now);
            values.extend([at.hsync, at.vsync, at.frame_start].map(i64::from));
            values.extend(shown(&at.ahead));
            values.into_iter().map(Some).collect()
        }
    })
    // Two frames, of which some clocks are without `enable`.
    .reached_in(frame * 9 / 4)
}

fn shown(pixel: &Shown) -> Vec<i64> {
    vec![
        pixel.active.into(),
        pixel.start.into(),
        pixel.line.into(),
        pixel.x.into(),
        pixel.y.into(),
    ]
}

/// Now and then a clock without `enable`.
fn mostly_enabled(_: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let enable = prop_oneof![15 => Just(1i64), 1 => Just(0)];
    each(vec![enable.boxed()], clocks)
}
