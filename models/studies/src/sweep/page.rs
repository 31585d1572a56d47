//! A sweep as text: Markdown that reads well in a terminal too.

use super::record::{Record, SweepResult, runs};
use crate::kit::DrawError;
use crate::kit::page::text;
use serde::Serialize;

/// What stands in the template.
#[derive(Serialize)]
struct Section<'a> {
    #[serde(flatten)]
    result: &'a SweepResult,
    pictures: Option<&'a str>,
    tables: Vec<Table<'a>>,
}

/// The records of a series, those of one refusal together.
#[derive(Serialize)]
struct Table<'a> {
    series: &'a str,
    is_naive: bool,
    runs: Vec<Vec<&'a Record>>,
}

/// The section of a page: heading, what the sweep does, its figures series by series, and where the format gives out;
/// with plot and command if there is a folder of `pictures`, as seen from the page.
pub fn section(result: &SweepResult, pictures: Option<&str>) -> Result<String, DrawError> {
    let table = |series: &&'static str| {
        let records = result.of_series(series);
        (!records.is_empty()).then(|| Table {
            series,
            is_naive: records.iter().any(|r| r.naive.is_some()),
            runs: runs(&records),
        })
    };
    let section = Section {
        result,
        pictures,
        tables: result.series.iter().filter_map(table).collect(),
    };
    text("cannot tell of a sweep", include_str!("page.md"), section)
}
