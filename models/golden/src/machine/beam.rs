//! The golden beam machine: all slots over a frame, through the decider. The id of a pixel is the object of its slot.

use super::decider;
use super::frame::{Frame, FrameLayer};
use crate::format::Format;
use crate::object::slot::Slot;
use crate::slots;
use imogene_contract::slots::FittedSlot;
use rayon::prelude::*;

/// Clocks from `go` to the first pixel: raster control, the longest slot, the decider. Shorter slots get the raster
/// flags later, so that all hand on the same pixel at the same clock.
pub fn latency(slots: &[FittedSlot], format: &Format, rows_per_stage: u32) -> u32 {
    let own = |slot| slots::latency(slot, format, rows_per_stage);
    1 + slots.iter().map(own).max().unwrap_or(0) + decider::latency(slots.len())
}

/// One line of a frame, borrowed: depth, id, number of the face, normal, back depth.
type Line<'a> = (
    &'a mut [i64],
    &'a mut [i32],
    &'a mut [u8],
    &'a mut [[i16; 3]],
    &'a mut [i64],
);

/// The frame that the machine draws of these slots; `line_done` is called once a line, from any thread.
pub fn render(
    slots: &[Slot],
    format: &Format,
    width: usize,
    height: usize,
    line_done: impl Fn() + Sync,
) -> Frame {
    render_with_backs(slots, format, width, height, line_done).0
}

/// The same, and the back depth that the visible object's processor hands on beside the front depth; `z_max` where
/// nothing is seen.
pub fn render_with_backs(
    slots: &[Slot],
    format: &Format,
    width: usize,
    height: usize,
    line_done: impl Fn() + Sync,
) -> (Frame, Vec<i64>) {
    let mut frame = Frame::background(width, height, format.z_max());
    let mut backs = frame.depth.clone();
    let layer = |slot| layer(slot, format, width, height);
    frame.layers = slots.iter().filter_map(layer).collect();
    let lines = by_line(slots, height);
    let parts = (
        frame.depth.par_chunks_mut(width),
        frame.id.par_chunks_mut(width),
        frame.number.par_chunks_mut(width),
        frame.normal.par_chunks_mut(width),
        backs.par_chunks_mut(width),
    );
    parts.into_par_iter().enumerate().for_each(|(y, line)| {
        render_line(&lines[y], format, y as i64, line);
        line_done();
    });
    (frame, backs)
}

/// A transparent object, if the slot is one's.
pub(super) fn layer(
    slot: &Slot,
    format: &Format,
    width: usize,
    height: usize,
) -> Option<FrameLayer> {
    let weight = slot.weight?;
    let alone = Slot {
        weight: None,
        ..slot.clone()
    };
    let Frame { depth, normal, .. } = render(&[alone], format, width, height, || ());
    Some(FrameLayer {
        object: slot.object,
        weight,
        depth,
        normal,
    })
}

/// The slots of objects that are not transparent whose boxes meet each line, in their order.
fn by_line(slots: &[Slot], height: usize) -> Vec<Vec<&Slot>> {
    let mut lines = vec![vec![]; height];
    for slot in slots.iter().filter(|slot| slot.weight.is_none()) {
        let window = slot.words.screen_box();
        let (first, last) = (window.y0.max(0), window.y1.min(height as i64 - 1));
        if !window.is_empty() && first <= last {
            let met = &mut lines[first as usize..=last as usize];
            met.iter_mut().for_each(|line| line.push(slot));
        }
    }
    lines
}

/// Slots are visited in order, so that a strict comparison leaves ties with the first one, whose object has the smaller
/// id.
fn render_line(slots: &[&Slot], format: &Format, y: i64, line: Line) {
    let (depth, id, number, normal, back) = line;
    for slot in slots {
        slot.words.for_each_present(format, y, |x, pixel| {
            let x = x as usize;
            if pixel.zf < depth[x] {
                depth[x] = pixel.zf;
                id[x] = slot.object as i32;
                number[x] = pixel.number;
                normal[x] = pixel.normal;
                back[x] = pixel.zb;
            }
        });
    }
}
