//! A sweep as text: Markdown that reads well in a terminal too.

use super::naive::FloatError;
use super::record::{GivesOut, Notice, Record, SweepResult, runs};
use crate::kit::page::line;
use imogene_files::text::wrapped;

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
const NAIVE_HEAD: [&str; 4] = [
    "f32: depth, px",
    "wrong outline",
    "f64: depth, px",
    "wrong outline",
];

/// The heading of a sweep's section.
pub fn heading(result: &SweepResult) -> String {
    format!("## {} (`{}`)", result.title, result.name)
}

/// The section of a page: heading, plot, the command that makes it, text and tables. `pictures` is the folder of the
/// plots, seen from the page.
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
        let records = result.of_series(name);
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
    let mut head = [&[result.axis.label][..], &HEAD].concat();
    if naive {
        head.extend(NAIVE_HEAD);
    }
    let rule = "|---".repeat(head.len());
    let mut text = format!("\n*{name}*\n\n{}{rule}|\n", line(&head));
    for run in runs(records) {
        match run[0].refused {
            Some(_) => text += &line(&refused(&run, head.len())),
            None => text.extend(run.iter().map(|record| line(&cells(record, naive)))),
        }
    }
    text
}

/// One line for a run of refusals.
fn refused(run: &[&Record], columns: usize) -> Vec<String> {
    let (first, last) = (&run[0].parameter, &run[run.len() - 1].parameter);
    let values = match first == last {
        true => first.clone(),
        false => format!("{first} to {last}"),
    };
    let mut cells = vec![values, "refused".into()];
    cells.resize(columns, String::new());
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
        match o.silhouette_px {
            Some(off) => of(f.covered > 0, off),
            None => "-".into(),
        },
        normal(b.normal_deg),
        normal(o.normal_deg),
        f.covered.to_string(),
        f.undecided.to_string(),
        o.silhouette_pixels.to_string(),
        o.wrong_faces.to_string(),
        f.needed.quadratic.to_string(),
        match f.check_failed {
            None => "ok".into(),
            Some(_) => "fails".into(),
        },
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
    let values = match found.first == found.last {
        true => format!("at {}", found.first),
        false => format!("from {} to {}", found.first, found.last),
    };
    let before = found.last_accepted.as_ref();
    let before = before.map_or_else(String::new, |value| format!(" ({value} is accepted)"));
    let place = match result.series.len() {
        1 => String::new(),
        _ => format!("*{}*: ", found.series),
    };
    let message = wrapped(&format!("> {}", found.message), "> ");
    format!("{place}{what} {values}{before}\n\n{message}\n")
}

/// Three significant digits; an exponent where the number would be long.
fn figure(value: f64) -> String {
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
        for (value, expected) in [
            (0.0, "0"),
            (0.012345, "0.0123"),
            (1.0, "1.00"),
            (99_999.0, "99999"),
            (123_456.0, "1.23e5"),
            (1.234e-9, "1.23e-9"),
            (f64::INFINITY, "none"),
        ] {
            assert_eq!(figure(value), expected);
        }
    }
}
