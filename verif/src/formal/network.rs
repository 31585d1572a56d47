//! Connections of the emitted root networks, read from the text, so that a property sees every register stage.

use super::bind::module_range;

/// Definitions for the properties of a root network of `bits` bits: `K`, `STAGES`, `ROWS` and the words of all stages side by side,
/// the last stage first.
///
/// # Errors
///
/// A sentence that names what is not in the text.
pub(super) fn stage_words(
    design: &str,
    module: &str,
    bits: usize,
    rows_per_stage: usize,
    remainder_bits: usize,
) -> Result<Vec<(String, String)>, String> {
    let range = module_range(design, module).ok_or(format!("no module `{module}`"))?;
    let body = &design[range];
    let stages = bits.div_ceil(rows_per_stage);
    if body.contains(&format!(" stages_{stages} (")) {
        return Err(format!("`{module}` has more than {stages} stages"));
    }
    let mut definitions: Vec<(String, String)> =
        [("K", bits), ("STAGES", stages), ("ROWS", rows_per_stage)]
            .map(|(name, value)| (name.to_owned(), value.to_string()))
            .into();
    let words = [
        ("PAIRS", "next_pairs", 2 * bits),
        ("ROOTS", "next_root", bits),
        ("REMAINDERS", "next_remainder", remainder_bits),
    ];
    for (name, port, width) in words {
        let nets: Result<Vec<String>, String> = (0..stages)
            .rev()
            .map(|stage| match connection(body, stage, port)? {
                "" if stage + 1 == stages => Ok(format!("{width}'d0")),
                "" => Err(format!("`{port}` of stage {stage} is not connected")),
                net => Ok(net.to_owned()),
            })
            .collect();
        definitions.push((name.to_owned(), format!("{{{}}}", nets?.join(", "))));
    }
    Ok(definitions)
}

/// The net at a port of `stages_N`; empty if it is open.
fn connection<'a>(body: &'a str, stage: usize, port: &str) -> Result<&'a str, String> {
    let missing = || format!("no `{port}` of an instance `stages_{stage}`");
    let start = body
        .find(&format!(" stages_{stage} ("))
        .ok_or_else(missing)?;
    let instance = &body[start..];
    let instance = &instance[..instance.find("\n    );").ok_or_else(missing)?];
    let (_, after) = instance
        .split_once(&format!(".{port}("))
        .ok_or_else(missing)?;
    let (net, _) = after.split_once(')').ok_or_else(missing)?;
    Ok(net)
}
