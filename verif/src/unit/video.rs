//! The raster of a screen.

use super::description::{Description, bit};
use crate::stimulus::each;
use crate::subject::{Inputs, Subject};
use imogene_contract::video::{LEAD, VideoMode};
use imogene_golden::machine::video_timing::{Shown, VideoTiming};
use proptest::prelude::*;

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
