//! The object processors of the two source machines side by side: what each is made of here, and what the sources
//! count.

use crate::census::{Census, census};
use imogene_contract::{Request, RequestError, Unit};
use serde::Serialize;
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
    pub source: &'static str,
    /// Where.
    pub section: &'static str,
    /// Why the counts differ, if they do.
    pub difference: &'static str,
}

/// A row: the unit, its planes or sides, the source's counts, the difference.
struct Row(Unit, u32, &'static str, &'static str);

const SAME: &str = "the same";
const ROWS: [Row; 16] = [
    Row(
        Unit::QuadricProcessor,
        2,
        "6 PE1, 1 PE2, 1 root, 3 multipliers",
        SAME,
    ),
    Row(
        Unit::PatchProcessor,
        4,
        "8 PE1, 1 PE2, 1 root, 3 multipliers",
        SAME,
    ),
    Row(
        Unit::FirstGenerationProcessor,
        2,
        "8 PE1, 6 PE2, 4 roots",
        "one normal unit with three multipliers stands for the source's three radicands of second degree, each with a root of its own",
    ),
    Row(
        Unit::PolyhedronProcessor,
        6,
        "6 PE1, 6 cut modules",
        "a tree that looks for two extremes in place of a chain of cut modules",
    ),
    Row(
        Unit::QuadricVolume,
        4,
        "5 PE1, 1 PE2, 1 root, 4 cut modules, 8 if seen from inside",
        "a comparator for each plane in place of a cut module, and no second half",
    ),
    Row(
        Unit::PolyhedralVolume,
        4,
        "4 PE1, 4 cut modules",
        "comparators in place of cut modules",
    ),
    Row(
        Unit::PolyhedralVolume,
        10,
        "10 PE1, 10 cut modules",
        "comparators in place of cut modules",
    ),
    Row(Unit::FacetProcessor, 3, "7 PE1", SAME),
    Row(Unit::FacetProcessor, 4, "8 PE1", SAME),
    Row(
        Unit::CurvedFacetProcessor,
        3,
        "7 PE2, second degree in place of first",
        SAME,
    ),
    Row(
        Unit::SphereProcessor,
        0,
        "2 PE1, 3 PE2; a fourth PE2 for the back depth",
        "the back depth is there too: front and back have a constant sum, so a subtractor gives it",
    ),
    Row(Unit::CylinderProcessor, 0, "5 PE1, 6 PE2", SAME),
    Row(
        Unit::ProgrammablePe,
        0,
        "1 PE2 that splits into 4 PE1, not built",
        "built: the adders of a PE2 with their carries cut, so no PE2 is counted",
    ),
    Row(
        Unit::MemoryPe2,
        0,
        "1 PE2 with 6 words of memory, 12 interlaced",
        "9 words: copies of second differences would never differ from the originals",
    ),
    Row(Unit::Pe1, 0, "1 PE1", SAME),
    Row(Unit::Pe2, 0, "1 PE2", SAME),
];

/// Every processor, in the base format, one row of the root network per stage.
///
/// # Errors
///
/// A defect of this workspace, if any.
pub fn processors() -> Result<Vec<Processor>, RequestError> {
    ROWS.iter().map(processor).collect()
}

fn processor(Row(unit, count, source, difference): &Row) -> Result<Processor, RequestError> {
    let counted = ["planes", "sides"];
    let counted = counted.into_iter().find(|option| unit.has(option));
    let given = counted.map(|option| (option, Some(*count)));
    let request = Request::given(unit.name(), 24, given.as_slice())?;
    let parameters = counted.map(|option| format!("{count} {option}"));
    Ok(Processor {
        unit: unit.name(),
        parameters: parameters.unwrap_or_default(),
        census: census(&request)?,
        latency: request.latency(),
        latency_formula: unit.record().latency,
        source,
        section: unit.record().source,
        difference,
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
        let name = if p.parameters.is_empty() {
            format!("`{}`", p.unit)
        } else {
            format!("`{}`, {}", p.unit, p.parameters)
        };
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {} | {} | {} | {} | {} | {} | {} |",
            p.census.pe1,
            p.census.pe2,
            p.census.roots,
            p.census.multipliers,
            p.latency,
            p.latency_formula,
            p.source,
            p.difference,
            p.section
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the counts are said to be the same, the first numbers of the source's text are those of the hierarchy.
    #[test]
    fn same_counts_are_the_same() {
        for p in processors().unwrap() {
            if p.difference != SAME {
                continue;
            }
            let counted = |word: &str| {
                let parts = p.source.split([',', ';']);
                let mut found = parts.filter_map(|part| part.trim().split_once(' '));
                found
                    .find(|(_, name)| name.starts_with(word))
                    .map_or(0, |(number, _)| number.parse().unwrap())
            };
            assert_eq!(
                [
                    p.census.pe1,
                    p.census.pe2,
                    p.census.roots,
                    p.census.multipliers
                ],
                ["PE1", "PE2", "root", "multiplier"].map(counted),
                "{} {}",
                p.unit,
                p.parameters
            );
        }
    }
}
