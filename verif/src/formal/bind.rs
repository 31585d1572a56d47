//! `bind` statements of SystemVerilog, resolved in the text: Yosys reads them but does not act on them.

use super::FormalError;

/// Puts what `properties` binds into the modules of `design`, and returns it with the rest of the properties.
///
/// A statement begins at the start of a line and ends with a line `);`, as in `bind pe1 pe1_properties properties (\n
/// ...\n);`. Fails when a module is not in the design exactly once, or a statement does not end.
pub fn resolve(job: &str, design: &str, properties: &str) -> Result<String, FormalError> {
    let mut design = design.to_owned();
    let mut kept = String::new();
    let wrong = |problem: &str| FormalError::Text(job.to_owned(), problem.to_owned());
    let mut rest = properties;
    while let Some((before, statement)) = split_at_line(rest, "bind ") {
        kept += before;
        let end = statement
            .find("\n);")
            .ok_or_else(|| wrong("a `bind` statement does not end with `);`"))?;
        let (module, instance) = statement["bind ".len()..end + 3]
            .split_once(' ')
            .ok_or_else(|| wrong("a `bind` statement names no instance"))?;
        let range = module_range(&design, module)
            .ok_or_else(|| wrong(&format!("module `{module}` is not in the design once")))?;
        design.insert_str(range.end, &format!("\n    {instance}\n"));
        rest = &statement[end + 3..];
    }
    Ok(design + "\n" + &kept + rest)
}

/// Splits before the first line that begins with a word.
fn split_at_line<'a>(text: &'a str, word: &str) -> Option<(&'a str, &'a str)> {
    let at = if text.starts_with(word) {
        0
    } else {
        text.find(&format!("\n{word}"))? + 1
    };
    Some(text.split_at(at))
}

/// The text of a module, from its name to before `endmodule`, as a range of the design.
fn module_range(design: &str, module: &str) -> Option<std::ops::Range<usize>> {
    let head = format!("\nmodule {module} (");
    let mut places = design.match_indices(&head);
    let (start, _) = places.next()?;
    if places.next().is_some() {
        return None;
    }
    let length = design[start..].find("\nendmodule")?;
    Some(start..start + length)
}
