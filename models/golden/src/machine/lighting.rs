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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::slab;

    /// A volume from column 1 to 2 and from depth 100 on.
    fn volume(kind: VolumeKind, source: u8, margin: u32) -> VolumeWords {
        slab((kind, source), [1, 2], 100, margin)
    }

    #[test]
    fn shadows_clear_inside_and_lights_outside_in_any_order() {
        let format = Format::BASE;
        let mut frame = Frame::background(4, 1, format.z_max());
        frame.depth = vec![200, 100, 200, 200];
        let shade = volume(VolumeKind::Shadow, 0, 1);
        let spot = volume(VolumeKind::Light, 1, 0);
        let wanted = [0xfffd, 0xffff, 0xfffe, 0xfffd];
        for order in [[&shade, &spot], [&spot, &shade]] {
            assert_eq!(light(&frame, &order, &format, || ()).flags, wanted);
        }
        // One source, both kinds: lit inside the cone and outside the shadow.
        let shaded_spot = volume(VolumeKind::Shadow, 1, 1);
        let flags = light(&frame, &[&spot, &shaded_spot], &format, || ()).flags;
        assert_eq!(flags, [0xfffd, 0xffff, 0xfffd, 0xfffd]);
    }

    #[test]
    fn a_background_pixel_is_in_no_shadow() {
        let format = Format::BASE;
        let frame = Frame::background(4, 1, format.z_max());
        let shade = volume(VolumeKind::Shadow, 0, 1);
        let lighting = light(&frame, &[&shade], &format, || ());
        assert_eq!(lighting, Lighting::full(&frame));
    }
}
