//! The quadric processor over whole lines, for pictures: the same values as [`super::quadric`], many pixels at a time,
//! visiting only the pixels of the screen box.

use super::lanes::draw_line;
use super::quadric::{ObjectPixel, QuadricWords};
use crate::format::Format;

/// Vector instructions that the lanes are compiled for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Instructions {
    /// Those that every processor has.
    Any,
    /// 256 bits.
    #[cfg(target_arch = "x86_64")]
    Avx2,
    /// 512 bits.
    #[cfg(target_arch = "x86_64")]
    Avx512,
}

impl Instructions {
    /// All that this processor has, the best last.
    pub fn available() -> impl Iterator<Item = Instructions> {
        #[cfg(target_arch = "x86_64")]
        let all = [Instructions::Any, Instructions::Avx2, Instructions::Avx512];
        #[cfg(not(target_arch = "x86_64"))]
        let all = [Instructions::Any];
        all.into_iter().filter(|&one| one <= Instructions::here())
    }

    /// The best that this processor has.
    #[inline]
    fn here() -> Instructions {
        #[cfg(target_arch = "x86_64")]
        {
            let has_512 =
                is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512dq");
            if has_512
                && is_x86_feature_detected!("avx512bw")
                && is_x86_feature_detected!("avx512vl")
            {
                return Instructions::Avx512;
            }
            if is_x86_feature_detected!("avx2") {
                return Instructions::Avx2;
            }
        }
        Instructions::Any
    }
}

/// Calls `sink(x, pixel)` for every pixel of line `y` (zone coordinates) at which the object is present, left to right.
pub fn for_each_present(
    words: &QuadricWords,
    format: &Format,
    y: i64,
    sink: impl FnMut(i64, ObjectPixel),
) {
    for_each_present_by(Instructions::here(), words, format, y, sink);
}

/// As [`for_each_present`], with no better instructions than `most`.
#[inline]
pub fn for_each_present_by(
    most: Instructions,
    words: &QuadricWords,
    format: &Format,
    y: i64,
    sink: impl FnMut(i64, ObjectPixel),
) {
    let window = &words.screen_box;
    if window.is_empty() || y < window.y0 || y > window.y1 {
        return;
    }
    match most.min(Instructions::here()) {
        Instructions::Any => draw_line(words, format, y, sink),
        // SAFETY: no better than [`Instructions::here`] has found on this processor.
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx2 => unsafe { avx2(words, format, y, sink) },
        // SAFETY: as above.
        #[cfg(target_arch = "x86_64")]
        Instructions::Avx512 => unsafe { avx512(words, format, y, sink) },
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn avx2(words: &QuadricWords, format: &Format, y: i64, sink: impl FnMut(i64, ObjectPixel)) {
    draw_line(words, format, y, sink);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512dq,avx512bw,avx512vl")]
fn avx512(words: &QuadricWords, format: &Format, y: i64, sink: impl FnMut(i64, ObjectPixel)) {
    draw_line(words, format, y, sink);
}
