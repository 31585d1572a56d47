//! Words between the register stages of the emitted root networks, so that a property sees every one of them.

/// Definitions for the properties of a root network of `bits` bits: `K`, `STAGES`, `ROWS` and the words of all stages side
/// by side, the last stage first. Element 0 of a vector is what the first stage takes.
pub(super) fn stage_words(
    bits: usize,
    rows_per_stage: usize,
    remainder_bits: usize,
) -> Vec<(String, String)> {
    let stages = bits.div_ceil(rows_per_stage);
    let numbers = [("K", bits), ("STAGES", stages), ("ROWS", rows_per_stage)];
    let numbers = numbers.map(|(name, value)| (name.to_owned(), value.to_string()));
    let words = [
        ("PAIRS", "pairs", 2 * bits),
        ("ROOTS", "root", bits),
        ("REMAINDERS", "remainder", remainder_bits),
    ];
    let words = words.map(|(name, port, width)| {
        let high = (stages + 1) * width - 1;
        (name.to_owned(), format!("stages_{port}[{high}:{width}]"))
    });
    numbers.into_iter().chain(words).collect()
}
