//! `imogene processors`.

use crate::arguments::Processors;
use crate::failure::Failure;
use crate::output;
use imogene_files::text::counted;
use imogene_package::processors::{markdown, processors};

/// Lists the object processors with their parts, or writes the list to a file.
pub fn run(options: &Processors, json: bool) -> Result<(), Failure> {
    let list = processors()?;
    if let Some(path) = &options.out {
        output::write_text(path, &markdown(&list))?;
    }
    if json {
        output::json(&list);
        return Ok(());
    }
    for p in list {
        let parts = [
            (p.census.pe1, "pe1"),
            (p.census.pe2, "pe2"),
            (p.census.roots, "root"),
            (p.census.multipliers, "multipliers"),
        ];
        let parts = parts.iter().filter(|(count, _)| *count > 0);
        let parts = parts.map(|(count, name)| format!("{count} {name}"));
        output::text(format!(
            "{} {}\n  parts:      {}\n  latency:    {} = {}\n  source:     {} ({})\n  difference: {}\n",
            p.unit,
            p.parameters,
            output::joined(parts, ", "),
            counted(p.latency, "clock"),
            p.latency_formula,
            p.source,
            p.section,
            p.difference
        ));
    }
    Ok(())
}
