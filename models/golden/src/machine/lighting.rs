//! Which sources reach the visible point of each pixel: the flags that shading asks (source: 4.1.3).

use super::frame::Frame;
use crate::format::Format;
use crate::object::volume::{VolumeKind, VolumeWords};
use crate::object::volume_line::for_each_inside;
use rayon::prelude::*;

/// Every source reaches the point.
pub const ALL_SOURCES: u16 = u16::MAX;

/// Flags of every pixel, row-major; bit i is set where `lights[i]` reaches the point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Lighting {
    /// The flags.
    pub flags: Vec<u16>,
}

impl Lighting {
    /// Every source reaches everything: a frame without volumes.
    pub fn full(frame: &Frame) -> Lighting {
        Lighting {
            flags: vec![ALL_SOURCES; frame.depth.len()],
        }
    }
}

/// The flags that volumes leave of a frame.
pub fn light(
    frame: &Frame,
    volumes: &[&VolumeWords],
    format: &Format,
    line_done: impl Fn() + Sync,
) -> Lighting {
    let mut lighting = Lighting::full(frame);
    lighting
        .flags
        .par_chunks_mut(frame.width)
        .zip(frame.depth.par_chunks(frame.width))
        .enumerate()
        .for_each(|(y, (flags, depths))| {
            for words in volumes {
                light_line(words, format, y as i64, depths, flags);
            }
            line_done();
        });
    lighting
}

fn light_line(words: &VolumeWords, format: &Format, y: i64, depths: &[i64], flags: &mut [u16]) {
    match words.kind {
        VolumeKind::Shadow => for_each_inside(words, format, y, depths, |x| {
            flags[x] = words.after(flags[x], true);
        }),
        // Outside is dark, also outside the box: what is inside gets back what it had.
        VolumeKind::Light => {
            let before = flags.to_vec();
            for flag in flags.iter_mut() {
                *flag = words.after(*flag, false);
            }
            for_each_inside(words, format, y, depths, |x| {
                flags[x] = words.after(before[x], true);
            });
        }
    }
}
