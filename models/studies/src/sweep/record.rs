//! What a sweep came to, and that as text: Markdown that reads well in a terminal too.

use super::measure::Figures;
use super::naive::Naive;
use crate::kit::DrawError;
use crate::kit::page::text;
use serde::Serialize;

/// How the parameter is plotted.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Axis {
    /// What it is, with its unit.
    pub label: &'static str,
    /// Powers of ten at equal distances.
    pub logarithmic: bool,
    /// Small values on the right: the extreme is at the right end of every plot.
    pub falling: bool,
}

impl Axis {
    const fn of(label: &'static str, logarithmic: bool, falling: bool) -> Axis {
        Axis {
            label,
            logarithmic,
            falling,
        }
    }

    pub(super) const fn linear(label: &'static str) -> Axis {
        Axis::of(label, false, false)
    }

    pub(super) const fn growing(label: &'static str) -> Axis {
        Axis::of(label, true, false)
    }

    pub(super) const fn falling(label: &'static str) -> Axis {
        Axis::of(label, true, true)
    }
}

/// What a step came to; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct Record {
    /// Which of the sweep's series.
    pub series: &'static str,
    /// The parameter as a decimal.
    pub parameter: String,
    /// The same as a number.
    pub value: f64,
    /// The refusal, if the scene was not accepted.
    pub refused: Option<String>,
    /// What was measured, if it was.
    pub figures: Option<Figures>,
    /// What floating point makes of the same scene, where that is asked.
    pub naive: Option<Naive>,
}

/// What is said before a scene is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Notice {
    /// The preparation refuses it: no word would be right.
    Refused,
    /// It is prepared, and `imogene check` fails: a silhouette may be displaced by a pixel or more.
    CheckFails,
    /// It is prepared, and the check says that no pixel shows it.
    NothingDrawn,
}

/// Where the format gives out in a series: a run of values with one notice; the keys are stable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct GivesOut {
    /// Which of the sweep's series.
    pub series: &'static str,
    /// In which way.
    pub by: Notice,
    /// The value before, if it was accepted and drawn.
    pub last_accepted: Option<String>,
    /// The first value with the notice.
    pub first: String,
    /// The last one.
    pub last: String,
    /// The message at the first value.
    pub message: String,
}

/// A whole sweep; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct SweepResult {
    /// Its name.
    pub name: &'static str,
    /// One line.
    pub title: &'static str,
    /// What it does and what it shows.
    pub about: &'static str,
    /// The parameter.
    pub axis: Axis,
    /// Depth word that was asked for; none if the sweep tries them all.
    pub depth_word: Option<u32>,
    /// The names of the series.
    pub series: &'static [&'static str],
    /// One for each step, series by series.
    pub records: Vec<Record>,
    /// Runs of values with a notice.
    pub gives_out: Vec<GivesOut>,
    /// Everything that breaks a rule; empty if all holds.
    pub violations: Vec<String>,
}

impl SweepResult {
    pub(super) fn of_series(&self, name: &str) -> Vec<&Record> {
        self.records.iter().filter(|r| r.series == name).collect()
    }
}

impl Record {
    /// Why nothing is drawn, or not within a pixel; none if all is well.
    pub fn notice(&self) -> Option<(Notice, String)> {
        if let Some(message) = &self.refused {
            return Some((Notice::Refused, message.clone()));
        }
        let figures = self.figures.as_ref()?;
        let check = figures.check_failed.clone();
        let check = check.map(|message| (Notice::CheckFails, message));
        let nothing = || (Notice::NothingDrawn, figures.problems.join("; "));
        check.or_else(|| (figures.covered == 0).then(nothing))
    }
}

/// The runs of records with the same notice, or with none.
fn runs<'a>(records: &[&'a Record]) -> Vec<Vec<&'a Record>> {
    // For the same reason if the messages are alike, but for their figures.
    let reason = |record: &Record| {
        let (by, mut message) = record.notice()?;
        message.retain(char::is_alphabetic);
        Some((by, message))
    };
    let runs = records.chunk_by(|a, b| reason(a) == reason(b));
    runs.map(<[_]>::to_vec).collect()
}

/// Every run of values with a notice.
pub(super) fn gives_out(series: &[&'static str], records: &[Record]) -> Vec<GivesOut> {
    let mut found = vec![];
    for name in series {
        let mut accepted = None;
        let own: Vec<&Record> = records.iter().filter(|r| r.series == *name).collect();
        for run in runs(&own) {
            let (first, last) = (run[0], run[run.len() - 1].parameter.clone());
            let before = accepted.take();
            match first.notice() {
                Some((by, message)) => found.push(GivesOut {
                    series: name,
                    by,
                    last_accepted: before,
                    first: first.parameter.clone(),
                    last,
                    message,
                }),
                None => accepted = Some(last),
            }
        }
    }
    found
}

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
