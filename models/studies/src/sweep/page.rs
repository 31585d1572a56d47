//! A sweep as text: Markdown that reads well in a terminal too.

use super::naive::FloatError;
use super::{GivesOut, Notice, Record, SweepResult, runs};
use crate::text::wrapped;

const HEAD: [&str; 15] = [
    "depth bound, words",
    "observed",
    "at its pixel, %",
    "depth bound, px",
    "observed",
    "silhouette bound, px",
    "observed",
    "normal bound, deg",
    "observed",
    "pixels",
    "undecided",
    "wrong outline",
    "wrong face",
    "f2 needs, bits",
    "check",
];

/// The heading of a sweep's section.
pub fn heading(result: &SweepResult) -> String {
    format!("## {} (`{}`)", result.title, result.name)
}

/// The section of a page: heading, plot, the command that makes it, text and tables. `pictures` is the folder of the plots, seen from the page.
pub fn section(result: &SweepResult, pictures: &str) -> String {
    let name = result.name;
    let format = match result.depth_word {
        None | Some(24) => String::new(),
        Some(word) => format!(" --format {word}"),
    };
    format!(
        "{}\n\n![{}]({pictures}{name}.svg)\n\n    imogene sweep {name}{format} --out DIR\n\n{}",
        heading(result),
        result.title,
        markdown(result)
    )
}

/// What a sweep does, its figures series by series, and where the format gives out.
pub fn markdown(result: &SweepResult) -> String {
    let mut text = format!("{}\n", wrapped(result.about, ""));
    for name in result.series {
        let records: Vec<&Record> = result
            .records
            .iter()
            .filter(|r| r.series == *name)
            .collect();
        if !records.is_empty() {
            text += &series(result, name, &records);
        }
    }
    for gives_out in &result.gives_out {
        text += &format!("\n{}", giving_out(result, gives_out));
    }
    if result.gives_out.iter().all(|g| g.by != Notice::Refused) {
        text += "\nNo value is refused.\n";
    }
    for violation in &result.violations {
        text += &format!("\n**VIOLATION** {violation}\n");
    }
    text
}

fn series(result: &SweepResult, name: &str, records: &[&Record]) -> String {
    let naive = records.iter().any(|r| r.naive.is_some());
    let mut head: Vec<&str> = vec![result.axis.label];
    head.extend(HEAD);
    if naive {
        head.extend([
            "f32: depth, px",
            "wrong outline",
            "f64: depth, px",
            "wrong outline",
        ]);
    }
    let rule = "|---".repeat(head.len());
    let mut text = format!("\n*{name}*\n\n| {} |\n{rule}|\n", head.join(" | "));
    for run in runs(records) {
        if run[0].refused.is_some() {
            text += &format!("| {} |\n", refused(&run, naive).join(" | "));
            continue;
        }
        for record in run {
            text += &format!("| {} |\n", cells(record, naive).join(" | "));
        }
    }
    text
}

/// One line for a run of refusals.
fn refused(run: &[&Record], naive: bool) -> Vec<String> {
    let (first, last) = (&run[0].parameter, &run[run.len() - 1].parameter);
    let values = if first == last {
        first.clone()
    } else {
        format!("{first} to {last}")
    };
    let mut cells = vec![values, "refused".into()];
    cells.resize(1 + HEAD.len() + if naive { 4 } else { 0 }, String::new());
    cells
}

fn cells(record: &Record, naive: bool) -> Vec<String> {
    let f = record.figures.as_ref().expect("drawn");
    let (b, o) = (&f.bounds, &f.observed);
    let of = |there: bool, value: f64| if there { figure(value) } else { "-".into() };
    let depth = |value| of(o.compared > 0, value);
    let normal = |value| of(o.normals > 0, value);
    let mut cells = vec![
        record.parameter.clone(),
        depth(b.depth_words),
        depth(o.depth_words),
        format!("{:.0}", 100.0 * f.ratios.depth),
        depth(b.depth_px),
        depth(o.depth_px),
        of(f.covered > 0, b.silhouette_px),
        of(
            f.covered > 0 && o.silhouette_px.is_some(),
            o.silhouette_px.unwrap_or(0.0),
        ),
        normal(b.normal_deg),
        normal(o.normal_deg),
        f.covered.to_string(),
        f.undecided.to_string(),
        o.silhouette_pixels.to_string(),
        o.wrong_faces.to_string(),
        f.needed.quadratic.to_string(),
        if f.check_failed.is_none() {
            "ok"
        } else {
            "fails"
        }
        .into(),
    ];
    if naive {
        let floats = record.naive.iter().flat_map(|n| [n.single, n.double]);
        let depth = |e: &FloatError| of(e.compared > 0, e.depth_px);
        cells.extend(floats.flat_map(|e| [depth(&e), e.silhouette_pixels.to_string()]));
    }
    cells
}

fn giving_out(result: &SweepResult, found: &GivesOut) -> String {
    let what = match found.by {
        Notice::Refused => "refused",
        Notice::CheckFails => "drawn, but `imogene check` fails",
        Notice::NothingDrawn => "no pixel is drawn",
    };
    let values = if found.first == found.last {
        format!("at {}", found.first)
    } else {
        format!("from {} to {}", found.first, found.last)
    };
    let before = found.last_accepted.as_ref();
    let before = before.map_or_else(String::new, |value| format!(" ({value} is accepted)"));
    let place = if result.series.len() > 1 {
        format!("*{}*: ", found.series)
    } else {
        String::new()
    };
    format!("{place}{what} {values}{before}\n\n    {}\n", found.message)
}

/// Three significant digits; an exponent where the number would be long.
pub(super) fn figure(value: f64) -> String {
    let size = value.abs();
    if value == 0.0 {
        "0".into()
    } else if !value.is_finite() {
        "none".into()
    } else if !(1e-3..1e5).contains(&size) {
        format!("{value:.2e}")
    } else {
        let decimals = (2 - size.log10().floor() as i32).max(0) as usize;
        format!("{value:.decimals$}")
    }
}

#[cfg(test)]
mod tests {
    use super::figure;

    #[test]
    fn figures_have_three_significant_digits() {
        let found = [
            0.0,
            0.012345,
            1.0,
            99_999.0,
            123_456.0,
            1.234e-9,
            f64::INFINITY,
        ]
        .map(figure);
        assert_eq!(
            found,
            ["0", "0.0123", "1.00", "99999", "1.23e5", "1.23e-9", "none"]
        );
    }
}
