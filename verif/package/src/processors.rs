//! The object processors of the two source machines: what each is made of here, and what the sources count.

use crate::census::{Census, census};
use imogene_contract::{Request, RequestError, Unit};
use serde::{Deserialize, Serialize};
use std::fmt::Write;

/// The command that makes the page.
pub const COMMAND: &str = "imogene processors --out docs/processor-table.md";

/// A processor as it is emitted, beside its source.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Processor {
    /// Unit.
    pub unit: &'static str,
    /// Its parameters besides the format.
    pub parameters: String,
    /// What it is made of.
    #[serde(flatten)]
    pub census: Census,
    /// Clocks from the flags to the results.
    pub latency: usize,
    /// The latency as a formula.
    pub latency_formula: &'static str,
    /// What the source counts.
    pub source: String,
    /// Where.
    pub section: &'static str,
    /// Why the counts differ, if they do.
    pub difference: String,
}

/// What a source counts of a processor.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    unit: String,
    /// Planes or sides.
    #[serde(default)]
    count: u32,
    source: String,
    #[serde(default = "same")]
    difference: String,
}

#[derive(Deserialize)]
struct Rows {
    row: Vec<Row>,
}

fn same() -> String {
    "the same".into()
}

/// Every processor, in the base format, one row of the root network per stage.
pub fn processors() -> Result<Vec<Processor>, RequestError> {
    let rows: Rows = toml::from_str(include_str!("processors.toml")).expect("rows of this crate");
    rows.row.into_iter().map(processor).collect()
}

fn processor(row: Row) -> Result<Processor, RequestError> {
    let (unit, count) = (Unit::from_name(&row.unit)?, row.count);
    let counted = ["planes", "sides"];
    let counted = counted.into_iter().find(|option| unit.has(option));
    let given = counted.map(|option| (option, Some(count)));
    let request = Request::given(unit.name(), 24, given.as_slice())?;
    let parameters = counted.map(|option| format!("{count} {option}"));
    Ok(Processor {
        unit: unit.name(),
        parameters: parameters.unwrap_or_default(),
        census: census(&request)?,
        latency: request.latency(),
        latency_formula: unit.record().latency,
        source: row.source,
        section: unit.record().source,
        difference: row.difference,
    })
}

/// The processors as a page of the documentation.
pub fn markdown(processors: &[Processor]) -> String {
    let mut text = format!(
        "# Object processors: parts and latency\n\nBase format 24, one row of the root network per register stage. Parts are counted in the hierarchy that is \
         emitted.\nHow each works: [processors.md](processors.md); what each costs on a device: [resources.md](resources.md).\n\nMade by `{COMMAND}`. Do not edit.\n\n"
    );
    text += "| processor | PE1 | PE2 | roots | multipliers | latency | formula | the source's count | difference | source |\n";
    text += "|---|---:|---:|---:|---:|---:|---|---|---|---|\n";
    for p in processors {
        let comma = if p.parameters.is_empty() { "" } else { ", " };
        let name = format!("`{}`{comma}{}", p.unit, p.parameters);
        let c = p.census;
        let counts = [c.pe1, c.pe2, c.roots, c.multipliers, p.latency];
        let counts = counts.map(|count| count.to_string()).join(" | ");
        let words = [p.latency_formula, &p.source, &p.difference, p.section];
        let _ = writeln!(text, "| {name} | {counts} | {} |", words.join(" | "));
    }
    text
}
