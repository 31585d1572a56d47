//! The rows of `evaluation.toml`, their expressions worked out.

use super::EvaluateError;
use super::figures::counts;
use super::hardware::{Hardware, Parts};
use super::row::{Evaluation, Group, Omitted, Printed, Row};
use minijinja::Environment;
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Table {
    /// Name and expression, each over those before.
    sums: Vec<(String, String)>,
    groups: Vec<Subject>,
    omitted: Vec<Omitted>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Subject {
    name: String,
    title: String,
    about: String,
    #[serde(flatten)]
    usual: Usual,
    #[serde(default)]
    rows: Vec<Line>,
    #[serde(default)]
    processors: Vec<Processor>,
}

/// What is the same in most rows of a group.
#[derive(Deserialize)]
struct Usual {
    #[serde(default)]
    section: String,
    #[serde(default)]
    unit: String,
    #[serde(default)]
    why: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    name: String,
    section: Option<String>,
    printed: Source,
    corrected: Option<String>,
    ours: String,
    unit: Option<String>,
    why: Option<String>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Source {
    Number(f64),
    Text(String),
    Sum { sum: String },
}

/// What a source counts in a processor: PE1, PE2, roots, multipliers; and why ours has others.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Processor {
    unit: String,
    parameters: String,
    name: String,
    section: String,
    counts: [usize; 4],
    #[serde(default)]
    why: String,
}

/// Counts everything.
pub fn evaluate(hardware: &Hardware) -> Result<Evaluation, EvaluateError> {
    let table: Table = toml::from_str(include_str!("evaluation.toml"))
        .map_err(|error| format!("evaluation.toml: {error}"))?;
    let mut names = counts(hardware)?;
    for (name, expression) in &table.sums {
        let sum = value(&names, expression)?;
        names.add_global(name.clone(), sum);
    }
    let groups = table.groups.iter().map(|subject| {
        let rows = subject.rows.iter().map(|line| row(&names, line, subject));
        let mut rows = rows.collect::<Result<Vec<Row>, EvaluateError>>()?;
        for processor in &subject.processors {
            rows.extend(processor.rows(&hardware.processors)?);
        }
        Ok(Group {
            name: subject.name.clone(),
            title: subject.title.clone(),
            about: text(&names, &subject.about)?,
            rows,
        })
    });
    Ok(Evaluation {
        groups: groups.collect::<Result<_, EvaluateError>>()?,
        omitted: table.omitted,
    })
}

fn value(names: &Environment, expression: &str) -> Result<f64, EvaluateError> {
    let compiled = names.compile_expression(expression);
    let value = compiled.and_then(|compiled| f64::try_from(compiled.eval(())?));
    value.map_err(failed(expression))
}

fn text(names: &Environment, template: &str) -> Result<String, EvaluateError> {
    let text = names.render_str(template, ());
    text.map_err(failed(template))
}

fn row(
    names: &Environment,
    line: &Line,
    Subject { usual, .. }: &Subject,
) -> Result<Row, EvaluateError> {
    let own_or = |own: &Option<String>, usual: &str| own.clone().unwrap_or_else(|| usual.into());
    let printed = match &line.printed {
        Source::Number(value) => Printed::from(*value),
        Source::Text(text) => Printed::from(text.as_str()),
        Source::Sum { sum } => Printed::from(value(names, sum)?),
    };
    let corrected = line.corrected.as_ref().map(|sum| value(names, sum));
    let section = own_or(&line.section, &usual.section);
    let unit = own_or(&line.unit, &usual.unit);
    let ours = value(names, &line.ours)?;
    let about = [&*line.name, &section, &unit];
    let mut row = Row::new(about, printed, ours, corrected.transpose()?);
    row.why = text(names, &own_or(&line.why, &usual.why))?;
    Ok(row)
}

fn failed(expression: &str) -> impl Fn(minijinja::Error) -> EvaluateError {
    move |problem| format!("evaluation.toml, `{expression}`: {problem:#}").into()
}

impl Processor {
    fn rows(&self, all: &[Parts]) -> Result<Vec<Row>, EvaluateError> {
        let own = |p: &&Parts| p.unit == self.unit && p.parameters == self.parameters;
        let missing = || format!("no parts of `{}` for {}", self.unit, self.parameters);
        let ours = all.iter().find(own).ok_or_else(missing)?.counts;
        let row = |what: &str, unit: &str, printed: Printed, ours: f64, corrected: Option<f64>| {
            let name = format!("{}: {what}", self.name);
            let mut row = Row::new([&*name, &*self.section, unit], printed, ours, corrected);
            row.why = match row.reference() == Some(ours) {
                true => "counted in the emitted hierarchy".into(),
                false => self.why.clone(),
            };
            row
        };
        let mut rows = vec![];
        let kinds = ["PE1", "PE2", "roots", "multipliers"];
        for (k, kind) in kinds.into_iter().enumerate() {
            let (there, here) = (self.counts[k], ours[k]);
            if there + here > 0 {
                rows.push(row(kind, "units", (there as f64).into(), here as f64, None));
            }
        }
        // Of the elementary processors at a pixel: one of a PE1, two of a PE2.
        let additions = |[pe1, pe2, ..]: [usize; 4]| (pe1 + 2 * pe2) as f64;
        let (there, here) = (Some(additions(self.counts)), additions(ours));
        let what = "additions of its expressions";
        rows.push(row(what, "a pixel", "nothing".into(), here, there));
        Ok(rows)
    }
}
