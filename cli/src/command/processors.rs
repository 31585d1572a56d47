//! `imogene processors`.

use crate::arguments::Processors;
use crate::failure::Failure;
use crate::output;
use imogene_package::processors::{markdown, processors};
use serde_json::json;

/// Lists the object processors with their parts, or writes the list to a file.
pub fn run(options: &Processors, json: bool) -> Result<(), Failure> {
    let list = processors()?;
    if let Some(path) = &options.out {
        output::write_text(path, &markdown(&list))?;
    }
    let page = output::page(
        include_str!("processors.txt"),
        json!({ "processors": list }),
    )?;
    output::report(json, &list, |_| output::text(page));
    Ok(())
}
