//! The raster control, and the raster of a screen.

use super::description::{Description, bit};
use crate::stimulus::each;
use crate::subject::{Inputs, Subject};
use imogene_contract::video::{LEAD, VideoMode};
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
}

/// Requests at random times, small zones so that many end, now and then a long line or a high column.
fn zones(_: &Subject, clocks: usize) -> BoxedStrategy<Vec<Inputs>> {
    let go = prop_oneof![2 => Just(0i64), 1 => Just(1)].boxed();
    let side = prop_oneof![12 => 1i64..6, 2 => 1i64..40, 1 => 1i64..4096].boxed();
    each(vec![go, side.clone(), side], clocks)
}

pub(super) fn video_timing(mode: usize) -> Description {
    Description::new(mostly_enabled, move || {
        let mut timing = VideoTiming::new(VideoMode::ALL[mode], LEAD as u64);
        move |i: &[i64]| {
            let at = timing.clock(bit(i[0]));
            let mut values = shown(&at.now);
            values.extend([at.hsync, at.vsync, at.frame_start].map(i64::from));
            values.extend(shown(&at.ahead));
            values.into_iter().map(Some).collect()
        }
    })
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
