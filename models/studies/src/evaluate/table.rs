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
    corrected: Option<Amount>,
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

#[derive(Deserialize)]
#[serde(untagged)]
enum Amount {
    Number(f64),
    Sum(String),
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
    let sums = Sums::of(&table.sums, counts(hardware)?)?;
    let groups = table.groups.iter().map(|subject| {
        let rows = subject.rows.iter().map(|line| sums.row(line, subject));
        let mut rows = rows.collect::<Result<Vec<Row>, EvaluateError>>()?;
        for processor in &subject.processors {
            rows.extend(processor.rows(&hardware.processors)?);
        }
        Ok(Group {
            name: subject.name.clone(),
            title: subject.title.clone(),
            about: sums.text(&subject.about)?,
            rows,
        })
    });
    Ok(Evaluation {
        groups: groups.collect::<Result<_, EvaluateError>>()?,
        omitted: table.omitted,
    })
}

/// The counts and the sums of them, by name.
struct Sums<'a>(Environment<'a>);

impl<'a> Sums<'a> {
    fn of(sums: &[(String, String)], counts: Environment<'a>) -> Result<Self, EvaluateError> {
        let mut all = Sums(counts);
        for (name, expression) in sums {
            let value = all.value(expression)?;
            all.0.add_global(name.clone(), value);
        }
        Ok(all)
    }

    fn value(&self, expression: &str) -> Result<f64, EvaluateError> {
        let compiled = self.0.compile_expression(expression);
        let value = compiled.and_then(|compiled| f64::try_from(compiled.eval(())?));
        value.map_err(|problem| failed(expression, &problem))
    }

    fn text(&self, template: &str) -> Result<String, EvaluateError> {
        let text = self.0.render_str(template, ());
        text.map_err(|problem| failed(template, &problem))
    }

    fn row(&self, line: &Line, Subject { usual, .. }: &Subject) -> Result<Row, EvaluateError> {
        let of = |own: &Option<String>, usual: &str| own.clone().unwrap_or_else(|| usual.into());
        let printed = match &line.printed {
            Source::Number(value) => Printed::from(*value),
            Source::Text(text) => Printed::from(text.as_str()),
            Source::Sum { sum } => Printed::from(self.value(sum)?),
        };
        let corrected = line.corrected.as_ref().map(|corrected| match corrected {
            Amount::Number(value) => Ok(*value),
            Amount::Sum(sum) => self.value(sum),
        });
        let (section, unit) = (
            of(&line.section, &usual.section),
            of(&line.unit, &usual.unit),
        );
        let names = [&*line.name, &*section, &*unit];
        Ok(Row {
            why: self.text(&of(&line.why, &usual.why))?,
            ..Row::new(
                names,
                printed,
                self.value(&line.ours)?,
                corrected.transpose()?,
            )
        })
    }
}

fn failed(expression: &str, problem: &minijinja::Error) -> EvaluateError {
    format!("evaluation.toml, `{expression}`: {problem:#}").into()
}

/// Additions of the elementary processors at a pixel: one of a PE1, two of a PE2.
fn additions([pe1, pe2, ..]: [usize; 4]) -> f64 {
    (pe1 + 2 * pe2) as f64
}

impl Processor {
    fn rows(&self, all: &[Parts]) -> Result<Vec<Row>, EvaluateError> {
        let own = |p: &&Parts| p.unit == self.unit && p.parameters == self.parameters;
        let missing = || format!("no parts of `{}` for {}", self.unit, self.parameters);
        let parts = all.iter().find(own).ok_or_else(missing)?;
        let ours = [parts.pe1, parts.pe2, parts.roots, parts.multipliers];
        let row = |what: &str, unit: &str, printed: Printed, ours: f64, corrected: Option<f64>| {
            let name = format!("{}: {what}", self.name);
            let row = Row::new([&*name, &*self.section, unit], printed, ours, corrected);
            let why = match row.reference() == Some(ours) {
                true => "counted in the emitted hierarchy",
                false => &self.why,
            };
            Row {
                why: why.into(),
                ..row
            }
        };
        let kinds = ["PE1", "PE2", "roots", "multipliers"];
        let counts = kinds.iter().zip(self.counts.into_iter().zip(ours));
        let counts = counts.filter(|(_, (there, here))| there + here > 0);
        let counts = counts.map(|(kind, (there, here))| {
            let there = Printed::from(there as f64);
            row(kind, "units", there, here as f64, None)
        });
        let (there, here) = (additions(self.counts), additions(ours));
        let what = "additions of its expressions";
        let sum = row(what, "a pixel", Printed::from("nothing"), here, Some(there));
        Ok(counts.chain([sum]).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluate::duplication::{Edges, touched};

    /// With the processors that the source counts.
    fn evaluation() -> Evaluation {
        let table: Table = toml::from_str(include_str!("evaluation.toml")).unwrap();
        let all = table.groups.into_iter().flat_map(|group| group.processors);
        let parts = all.map(|processor| {
            let [pe1, pe2, roots, multipliers] = processor.counts;
            Parts {
                unit: processor.unit,
                parameters: processor.parameters,
                pe1,
                pe2,
                roots,
                multipliers,
            }
        });
        let hardware = Hardware {
            processors: parts.collect(),
            zone_timing: Default::default(),
        };
        evaluate(&hardware).unwrap()
    }

    /// Group and row, what the source's own sum gives, and how far the print may be rounded.
    const PRINTED: &str = "
        facet: colours, contour following = 73 + 207 + 54
        facet: colours, expressions = 43 + 207 + 72
        facet: normals, contour following = 73 + 54
        facet: normals, expressions = 43 + 72
        facet: normals, contour following, all = 262 + 73 + 54 + 45
        facet: normals, expressions, all = 262 + 43 + 72 + 72
        frame: facet, all = 112 + 117 + 33
        frame: matrices of a quadric: product, determinant, cofactors = 112 + 95 + 272
        frame: inverse, all = 272 + 95 + 24
        quadric: quadric processor, all = 52 + 74 + 54 + 93
        quadric: patch processor, all = 51 + 74 + 120
        quadric: quadric, three planes = 182 + 84 + 273
        quadric: quadric, three planes, with matrices = 539 + 479
        quadric: patch, four planes, with matrices = 567 + 479
        polyhedron: polyhedron, all = 168 + 72 + 144 + 36 + 36
        zones: refinement, patch, 5 x 5 zones = 90 + 20 * 36
        zones: refinement, patch, 2 x 2 zones = 90 + 20 * 9
        zones: refinement, quadric, 5 x 5 zones = 420 + 30 * 36
        zones: refinement, quadric, 2 x 2 zones = 420 + 30 * 9
        zones: facet of 20 x 20 in zones of 32, mean = 174 +- 1
        zones: patch of 20 x 20 in zones of 32, mean = 330 +- 1
        zones: quadric of 20 x 20 in zones of 32, mean = 1006 +- 1
        software: facet of 20 x 20 = 20 * 20 * 10 + 20 * 7
        software: quadric of 128 x 128 = 128 * 128 * (0.75 * 95 + 0.25 * 9) + 128 * 10
        software: quadric of 80 x 80 = 80 * 80 * (0.75 * 95 + 0.25 * 9) + 80 * 10
        software: patch of 80 x 80 = 80 * 80 * (0.75 * 63 + 0.25 * 10) + 80 * 11
        software: patch of 64 x 64 = 64 * 64 * (0.75 * 63 + 0.25 * 10) + 64 * 11
        pipeline: processors that one link keeps busy, zones of 128 = 496
        pipeline: the same, zones of 64 = 124
        pipeline: zones of 128 of one processor = 2014 +- 0.5
        pipeline: zones of 64 of one processor = 8057 +- 0.5
        pipeline: patches times zones, zones of 128 = 1000000 +- 1
        pipeline: patches of 80 x 80, zones of 128 = 370000 +- 11100";

    /// Sums of the printed tables, with the corrections: a slip in a printed number does not get through.
    #[test]
    fn printed_values_add_up() {
        let evaluation = evaluation();
        let arithmetic = Sums(Environment::new());
        let mut checked = 0;
        for line in PRINTED
            .lines()
            .map(str::trim)
            .filter(|line| !line.is_empty())
        {
            let (group, rest) = line.split_once(": ").expect("a group");
            let (name, sum) = rest.split_once(" = ").expect("a sum");
            let (sum, rounded) = sum.split_once(" +- ").unwrap_or((sum, "0"));
            let row = evaluation
                .row(group, name)
                .unwrap_or_else(|| panic!("no {name}"));
            let off = row.reference().expect("a number") - arithmetic.value(sum).unwrap();
            assert!(off.abs() <= rounded.parse().unwrap(), "{line}: {off}");
            checked += 1;
        }
        assert_eq!(checked, 33);
    }

    /// With eight corners of four zones in place of nine the source's parts give the printed means, to their last
    /// digit.
    #[test]
    fn printed_means_take_eight_corners() {
        let share = touched(20, 32, Edges::Anywhere);
        let corners = 4.0 * share.one + 6.0 * share.two + 8.0 * share.four;
        for ([presort, set_up, corner, shift], printed) in [
            ([48.0, 0.0, 15.0, 14.0], 169.0),
            ([60.0, 90.0, 20.0, 26.0], 323.0),
            ([340.0, 420.0, 30.0, 24.0], 995.0f64),
        ] {
            let mean = presort + set_up + corner * corners + shift * (share.mean - 1.0);
            assert!((mean - printed).abs() <= 1.0, "{mean} {printed}");
        }
    }

    /// Our totals are the sums of our parts.
    #[test]
    fn our_sums_add_up() {
        let evaluation = evaluation();
        let ours = |group: &str, name: &str| evaluation.row(group, name).expect("a row").ours;
        let first = |group: &str, count: usize| -> f64 {
            let found = evaluation.groups.iter().find(|g| g.name == group);
            found.expect("a group").rows[..count]
                .iter()
                .map(|row| row.ours)
                .sum()
        };
        let of = |name: &str| ours("quadric", name);
        let (solid, patch) = (of("quadric processor, all"), of("patch processor, all"));
        assert_eq!(solid, first("quadric", 4));
        assert_eq!(patch, first("quadric", 2) + of("patch: four planes"));
        assert_eq!(of("quadric, three planes"), 182.0 + 84.0 + solid);
        assert_eq!(of("patch, four planes"), 182.0 + 140.0 + patch);
        assert_eq!(
            ours("polyhedron", "polyhedron, all"),
            first("polyhedron", 5)
        );
        // Three PE2 and two PE1 without the back (Chaillou, IV.2.4).
        assert_eq!(additions([2, 3, 0, 0]), 8.0);
    }
}
