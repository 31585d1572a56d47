//! `imogene roots`.

use crate::arguments::Roots;
use crate::failure::Failure;
use crate::output;
use imogene_golden::format::Format;
use imogene_studies::kit::page::text;
use imogene_studies::root_errors::table;
use serde_json::json;

/// Prints the measured table of the family of square root networks, as Markdown or JSON.
pub fn run(options: &Roots, json: bool) -> Result<(), Failure> {
    let rows = table(&Format::new(options.format)?);
    let page = text(
        "no table",
        include_str!("roots.md"),
        json!({ "rows": rows }),
    )?;
    output::report(json, &rows, |_| output::text(page.trim_end()));
    Ok(())
}
