//! How the work of a unit begins, for the proofs that what is held at power-up counts nothing.

use crate::subject::Subject;

/// Inputs that are 0 before, and the words of inputs in the clocks with which it begins.
pub(super) type Beginning = (Vec<String>, Vec<Vec<(String, u64)>>);

/// Inputs that are 1 in the clock with which the work of most units begins.
const BEGINS: [&str; 4] = ["pixel", "start", "go", "valid"];

/// Words of the memory of a PE2 with one.
const WORDS: u64 = 9;

/// Of a unit.
pub(super) fn beginning(subject: &Subject) -> Beginning {
    let named = |names: &[&str]| -> Vec<String> {
        let inputs = subject.inputs.iter().map(|signal| &signal.name[..]);
        let named = inputs.filter(|name| names.contains(name));
        named.map(str::to_owned).collect()
    };
    match &subject.name[..] {
        // All words, then a picture, and the clocks of its first line.
        "memory_pe2" => {
            let quiet = [
                "load_valid",
                "field_start",
                "picture_start",
                "line_start",
                "pixel",
            ];
            let loads = (0..WORDS).map(|word| clock(&[("load_valid", 1), ("load_address", word)]));
            let starts = ["picture_start", "line_start"].map(|name| clock(&[(name, 1)]));
            let line = std::iter::repeat_n(vec![], 15);
            (named(&quiet), loads.chain(starts).chain(line).collect())
        }
        // Two clocks of blanking.
        "tmds_encoder" => (vec![], vec![clock(&[("de", 0)]); 2]),
        _ => {
            let quiet = named(&BEGINS);
            let begins = quiet.iter().map(|name| (name.clone(), 1)).collect();
            (quiet, vec![begins])
        }
    }
}

fn clock(words: &[(&str, u64)]) -> Vec<(String, u64)> {
    let words = words.iter();
    words
        .map(|(name, word)| ((*name).to_owned(), *word))
        .collect()
}
