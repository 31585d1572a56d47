//! Words and slots that a machine may have.

use imogene_contract::request::in_range;
use imogene_contract::slots::FittedSlot;
use imogene_contract::words::MOST_OBJECTS;
use imogene_contract::{MachineWords, RequestError};

/// Refuses words that are out of their ranges.
pub(super) fn check_words(words: &MachineWords, rows_per_stage: usize) -> Result<(), RequestError> {
    if let Some((word, bits, least, most)) = words.refused() {
        return in_range(word, bits as usize, least, most);
    }
    let rows = words.root - words.dropped_rows;
    in_range("rows per stage", rows_per_stage, 1, rows)
}

/// The words as the header of the Verilog states them.
pub(super) fn lines(words: &MachineWords, rows_per_stage: usize) -> Vec<String> {
    let rows = format!("rows per stage {rows_per_stage}");
    let form = words.root_form;
    let form = (!form.is_usual()).then(|| format!("root form {form}"));
    let usual = MachineWords {
        root_form: words.root_form,
        ..MachineWords::of(words.depth)
    };
    if *words == usual {
        let format = format!("format {}", words.depth);
        return [format, rows].into_iter().chain(form).collect();
    }
    let (root, dropped) = (words.root, words.dropped_rows);
    let (linear, quadratic) = (words.guard_linear, words.guard_quadratic);
    [
        format!("depth word {}", words.depth),
        format!("root {root}, of which the last {dropped} digits are zero"),
        format!("plane word {}", words.plane),
        format!("normal component {}", words.normal),
        format!("guard bits {linear} of f1, {quadratic} of f2"),
        rows,
    ]
    .into_iter()
    .chain(form)
    .collect()
}

/// Refuses slots that are too many, or have too many planes or sides.
pub(super) fn check_slots(slots: &[FittedSlot], words: &MachineWords) -> Result<(), RequestError> {
    in_range("objects", slots.len(), 1, MOST_OBJECTS)?;
    slots.iter().try_for_each(|slot| {
        let [least, most] = slot.kind.planes();
        in_range("planes", slot.planes as usize, least, most)?;
        match slot.refused(words) {
            Some((word, bits, least, most)) => in_range(word, bits as usize, least, most),
            None => Ok(()),
        }
    })
}

/// The slots as the header of the Verilog states them.
pub(super) fn slots_line(slots: &[FittedSlot]) -> String {
    let (count, first) = (slots.len(), slots[0].planes);
    if slots.iter().all(|slot| *slot == FittedSlot::quadric(first)) {
        return format!("{count} object processors of {first} planes");
    }
    let each: String = slots.iter().map(|slot| format!(" {slot}")).collect();
    let has_own = |slot: &FittedSlot| slot.root.or(slot.plane).is_some();
    let own = match slots.iter().any(has_own) {
        true => ", r and p bits of a shorter root and shorter planes",
        false => "",
    };
    format!("slots, by their planes{own}:{each}")
}
