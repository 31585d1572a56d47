//! `imogene synth --check`.

use crate::arguments::Synth;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_contract::Unit;
use imogene_files::text::counted;
use imogene_synth::Target;
use imogene_synth::baseline::{CheckOptions, RowCheck, check};
use imogene_synth::regression::{Change, Tolerance, Verdict};
use imogene_synth::table::rows::called;
use imogene_synth::table::{self, Row, Table};

pub fn run(options: &Synth, json: bool) -> Result {
    let baseline = Table::read(&options.baseline)?;
    let rows = select(options, &baseline)?;
    let check_options = CheckOptions {
        tolerance: Tolerance {
            resources: options.tolerance,
            clock: options.clock_tolerance,
        },
        clock: !options.no_clock,
        cache: options.cache(),
    };
    let checks = output::during(rows.len() as u64, "synthesis", |bar| {
        check(&rows, &baseline, &check_options, || bar.inc(1))
    })?;
    output::report(json, &checks, |checks| {
        checks.iter().for_each(|row| output::text(describe(row)));
        output::text(summary(checks));
    });
    verdict(&checks, options)
}

/// The rows asked for; what has no baseline is refused if it is named, and told if it is not.
fn select(options: &Synth, baseline: &Table) -> Result<Vec<Row>> {
    let unit = options.unit.as_deref().map(Unit::from_name).transpose()?;
    let target = options.target.as_deref().map(Target::from_name);
    let target = target.transpose()?;
    let file = options.baseline.display();
    let missing = |unit: &Unit| !baseline.has(*unit);
    if let Some(unit) = unit.filter(missing) {
        return Err(Failure::Check(format!(
            "{} has no baseline in {file}; `imogene synth {0} --target T` measures it",
            unit.name()
        )));
    }
    let without = Unit::ALL.into_iter().filter(missing).map(Unit::name);
    let without: Vec<&str> = without.collect();
    if options.unit.is_none() && !without.is_empty() {
        // On standard error, since standard output is one JSON document with --json.
        eprintln!("not checked, no baseline in {file}: {}", without.join(", "));
    }
    let mut rows = table::select(unit, target);
    rows.retain(|row| baseline.has(row.request.unit));
    if rows.is_empty() {
        let part = |name: &Option<String>| name.clone().unwrap_or_else(|| "all".into());
        return Err(Failure::Input(format!(
            "the table has no row of unit {} for target {}; docs/resources.md shows its rows",
            part(&options.unit),
            part(&options.target)
        )));
    }
    Ok(rows)
}

fn name(check: &RowCheck) -> String {
    called(&check.unit, &check.parameters, &check.target)
}

/// A row: every figure, with its baseline where they differ.
fn describe(check: &RowCheck) -> String {
    let verilog = match check.is_same_verilog {
        true => "",
        false => ", other Verilog",
    };
    let (name, word) = (name(check), word(check.verdict));
    let figures = output::joined(check.changes.iter().map(figure), ", ");
    format!("{name}: {word}{verilog}\n  {figures}")
}

fn word(verdict: Verdict) -> &'static str {
    match verdict {
        Verdict::Same => "as the baseline",
        Verdict::Better => "better",
        Verdict::Within => "within the tolerance",
        Verdict::Worse => "worse",
    }
}

fn figure(change: &Change) -> String {
    let (measure, was, now) = (&change.measure, &change.baseline, &change.now);
    if change.verdict == Verdict::Same {
        return format!("{measure} {now}");
    }
    let percent = change.percent;
    let percent = percent.map_or_else(String::new, |percent| format!(" ({percent:+.1} %)"));
    format!("{measure} {was} -> {now}{percent}")
}

fn summary(checks: &[RowCheck]) -> String {
    let count = |verdict| checks.iter().filter(|c| c.verdict == verdict).count();
    format!(
        "{}: {} as the baseline, {} better, {} within the tolerance, {} worse",
        counted(checks.len(), "row"),
        count(Verdict::Same),
        count(Verdict::Better),
        count(Verdict::Within),
        count(Verdict::Worse)
    )
}

fn verdict(checks: &[RowCheck], options: &Synth) -> Result {
    let is_worse = |check: &&RowCheck| check.verdict == Verdict::Worse;
    let worse: Vec<String> = checks.iter().filter(is_worse).map(complaint).collect();
    Failure::unless(worse.is_empty(), || {
        let (rows, file) = (counted(checks.len(), "row"), options.baseline.display());
        let (percent, clock) = (options.tolerance, options.clock_tolerance);
        let (count, list) = (worse.len(), worse.join("\n"));
        format!(
            "{count} of {rows} worse than {file} by more than {percent} % (Fmax {clock} %):\n{list}"
        )
    })
}

/// The figures of a row that got worse.
fn complaint(check: &RowCheck) -> String {
    let changes = check.changes.iter();
    let worse = changes.filter(|change| change.verdict == Verdict::Worse);
    let worse = output::joined(worse.map(figure), ", ");
    format!("  {}: {worse}", name(check))
}
