//! The golden beam machine: all objects over a frame, through the decider.

use super::frame::Frame;
use crate::format::Format;
use crate::object::line::for_each_present;
use crate::object::quadric::QuadricWords;
use rayon::prelude::*;

/// One line of a frame, borrowed.
struct Line<'a> {
    depth: &'a mut [i64],
    id: &'a mut [i32],
    number: &'a mut [u8],
    normal: &'a mut [[i16; 3]],
}

/// The frame that the machine draws of these objects; `line_done` is called once a line, from any thread.
pub fn render(
    objects: &[QuadricWords],
    format: &Format,
    width: usize,
    height: usize,
    line_done: impl Fn() + Sync,
) -> Frame {
    let mut frame = Frame::background(width, height, format.z_max());
    frame
        .depth
        .par_chunks_mut(width)
        .zip(frame.id.par_chunks_mut(width))
        .zip(frame.number.par_chunks_mut(width))
        .zip(frame.normal.par_chunks_mut(width))
        .enumerate()
        .for_each(|(y, (((depth, id), number), normal))| {
            let line = Line {
                depth,
                id,
                number,
                normal,
            };
            render_line(objects, format, y as i64, line);
            line_done();
        });
    frame
}

/// Objects are visited by ascending id, so that a strict comparison leaves ties with the smaller id.
fn render_line(objects: &[QuadricWords], format: &Format, y: i64, line: Line) {
    for (id, words) in objects.iter().enumerate() {
        for_each_present(words, format, y, |x, pixel| {
            let x = x as usize;
            if pixel.zf < line.depth[x] {
                line.depth[x] = pixel.zf;
                line.id[x] = id as i32;
                line.number[x] = pixel.number;
                line.normal[x] = pixel.normal;
            }
        });
    }
}
