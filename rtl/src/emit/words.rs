//! Words and slots that a machine may have.

use imogene_circuits::machine::Slot;
use imogene_circuits::machines::MachineWords;
use imogene_contract::RequestError;
use imogene_contract::request::in_range;
use imogene_contract::words::{
    LEAST_DEPTH, MOST_BITS, MOST_DEPTH, MOST_OBJECTS, MOST_PLANES, NORMAL, plane, quadratic,
};

/// Refuses words that are out of their ranges: no word has more than 64 bits.
pub(super) fn check_words(words: &MachineWords, rows_per_stage: usize) -> Result<(), RequestError> {
    let most_guard = 16;
    let [depth, root, dropped] =
        [words.depth, words.root, words.dropped_rows].map(|bits| bits as usize);
    let [linear, quadratic_guard] =
        [words.guard_linear, words.guard_quadratic].map(|bits| bits as usize);
    // Each range stands on those before it.
    in_range("depth word", depth, LEAST_DEPTH, MOST_DEPTH)?;
    in_range("root", root, 4, depth)?;
    in_range("dropped digits of the root", dropped, 0, 8.min(root - 1))?;
    in_range("plane word", words.plane as usize, depth, plane(depth))?;
    in_range("normal component", words.normal as usize, 10, NORMAL)?;
    in_range("guard bits of f1", linear, 0, most_guard)?;
    let left = MOST_BITS - quadratic(root);
    in_range("guard bits of f2", quadratic_guard, 0, most_guard.min(left))?;
    in_range("rows per stage", rows_per_stage, 1, root - dropped)
}

/// The words as the header of the Verilog states them.
pub(super) fn lines(words: &MachineWords, rows_per_stage: usize) -> Vec<String> {
    let rows = format!("rows per stage {rows_per_stage}");
    if *words == MachineWords::of(words.depth) {
        return vec![format!("format {}", words.depth), rows];
    }
    let (root, dropped) = (words.root, words.dropped_rows);
    let (linear, quadratic) = (words.guard_linear, words.guard_quadratic);
    vec![
        format!("depth word {}", words.depth),
        format!("root {root}, of which the last {dropped} digits are zero"),
        format!("plane word {}", words.plane),
        format!("normal component {}", words.normal),
        format!("guard bits {linear} of f1, {quadratic} of f2"),
        rows,
    ]
}

/// Refuses slots that are too many, or have too many planes.
pub(super) fn check_slots(slots: &[Slot]) -> Result<(), RequestError> {
    in_range("objects", slots.len(), 1, MOST_OBJECTS)?;
    let mut planes = slots.iter().map(|slot| slot.planes);
    planes.try_for_each(|planes| in_range("planes", planes, 0, MOST_PLANES))
}

/// The slots as the header of the Verilog states them.
pub(super) fn slots_line(slots: &[Slot]) -> String {
    let (count, first) = (slots.len(), slots[0].planes);
    if slots.iter().all(|slot| *slot == Slot::full(first)) {
        return format!("{count} object processors of {first} planes");
    }
    let slot = |slot: &Slot| {
        format!(
            " {}{}",
            slot.planes,
            ["", "v"][usize::from(slot.two_volumes)]
        )
    };
    let slots: String = slots.iter().map(slot).collect();
    format!("slots, by their planes, v with half B:{slots}")
}
