//! Words between the register stages of the emitted root networks, so that a property sees every one of them.

/// Definitions for the properties of a root network of `bits` bits: `K`, `STAGES`, `ROWS` and the words of all stages side
/// by side, the last stage first. Element 0 of an array is what the first stage takes.
pub(super) fn stage_words(bits: usize, rows_per_stage: usize) -> Vec<(String, String)> {
    let stages = bits.div_ceil(rows_per_stage);
    let numbers = [("K", bits), ("STAGES", stages), ("ROWS", rows_per_stage)];
    let numbers = numbers.map(|(name, value)| (name.to_owned(), value.to_string()));
    let words = [
        ("PAIRS", "pairs"),
        ("ROOTS", "root"),
        ("REMAINDERS", "remainder"),
    ];
    let words = words.map(|(name, port)| {
        let stages = (1..=stages).rev();
        let list: Vec<String> = stages
            .map(|stage| format!("stages_{port}[{stage}]"))
            .collect();
        (name.to_owned(), format!("{{{}}}", list.join(", ")))
    });
    numbers.into_iter().chain(words).collect()
}
