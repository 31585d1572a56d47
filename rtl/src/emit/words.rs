//! Words and slots that a machine may have.

use crate::format::{
    LEAST_DEPTH, LEAST_NORMAL, LEAST_ROOT, MOST_BITS, MOST_DEPTH, MOST_DROPPED, MOST_GUARD,
    MOST_OBJECTS, MOST_PLANES, NORMAL, plane, quadratic,
};
use imogene_circuits::machine::Slot;
use imogene_circuits::machines::MachineWords;
use imogene_contract::RequestError;
use imogene_contract::request::in_range;

/// A parameter, its value, the least and the greatest that are accepted.
pub(super) type Row = (&'static str, usize, usize, usize);

/// Refuses the first parameter that is out of its range.
pub(super) fn check_ranges(rows: &[Row]) -> Result<(), RequestError> {
    let mut rows = rows.iter();
    rows.try_for_each(|&(parameter, value, least, most)| in_range(parameter, value, least, most))
}

/// Refuses words that are out of their ranges: no word has more than 64 bits.
pub(super) fn check_words(words: &MachineWords, rows_per_stage: usize) -> Result<(), RequestError> {
    let [
        depth,
        root,
        dropped,
        own_plane,
        normal,
        linear,
        quadratic_guard,
    ] = [
        words.depth,
        words.root,
        words.dropped_rows,
        words.plane,
        words.normal,
        words.guard_linear,
        words.guard_quadratic,
    ]
    .map(|bits| bits as usize);
    // Each row of the table stands on those before it.
    check_ranges(&[
        ("depth word", depth, LEAST_DEPTH, MOST_DEPTH),
        ("root", root, LEAST_ROOT, depth),
    ])?;
    check_ranges(&[
        (
            "dropped digits of the root",
            dropped,
            0,
            MOST_DROPPED.min(root - 1),
        ),
        ("plane word", own_plane, depth, plane(depth)),
        ("normal component", normal, LEAST_NORMAL, NORMAL),
        ("guard bits of f1", linear, 0, MOST_GUARD),
        (
            "guard bits of f2",
            quadratic_guard,
            0,
            MOST_GUARD.min(MOST_BITS - quadratic(root)),
        ),
    ])?;
    check_ranges(&[("rows per stage", rows_per_stage, 1, root - dropped)])
}

/// The words as the header of the Verilog states them.
pub(super) fn lines(words: &MachineWords, rows_per_stage: usize) -> Vec<String> {
    let rows = format!("rows per stage {rows_per_stage}");
    if *words == MachineWords::of(words.depth) {
        return vec![format!("format {}", words.depth), rows];
    }
    vec![
        format!("depth word {}", words.depth),
        format!(
            "root {}, of which the last {} digits are zero",
            words.root, words.dropped_rows
        ),
        format!("plane word {}", words.plane),
        format!("normal component {}", words.normal),
        format!(
            "guard bits {} of f1, {} of f2",
            words.guard_linear, words.guard_quadratic
        ),
        rows,
    ]
}

/// Refuses slots that are too many, or have too many planes.
pub(super) fn check_slots(slots: &[Slot]) -> Result<(), RequestError> {
    check_ranges(&[("objects", slots.len(), 1, MOST_OBJECTS)])?;
    let planes = |slot: &Slot| ("planes", slot.planes, 0, MOST_PLANES);
    check_ranges(&slots.iter().map(planes).collect::<Vec<_>>())
}

/// The slots as the header of the Verilog states them.
pub(super) fn slots_line(slots: &[Slot]) -> String {
    let first = slots[0];
    if slots.iter().all(|slot| *slot == Slot::full(first.planes)) {
        return format!(
            "{} object processors of {} planes",
            slots.len(),
            first.planes
        );
    }
    let slot = |slot: &Slot| {
        format!(
            " {}{}",
            slot.planes,
            if slot.two_volumes { "v" } else { "" }
        )
    };
    let slots: String = slots.iter().map(slot).collect();
    format!("slots, by their planes, v with half B:{slots}")
}
