//! `imogene synth`.

mod check;

use super::fitted;
use crate::arguments::Synth;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_files::text::counted;
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use imogene_synth::fitted::Parts;
use imogene_synth::table::{self, Table};
use imogene_synth::{SynthReport, Target, synthesise, synthesise_design};
use std::fmt::Display;
use std::path::{Path, PathBuf};

/// Synthesises a unit, makes the resource table, or checks against it.
pub fn run(options: &Synth, json: bool) -> Result {
    if options.check {
        return check::run(options, json);
    }
    match (&options.unit, &options.machine, &options.target) {
        (_, Some(machine), Some(target)) => run_design(machine, target, options, json),
        (Some(unit), _, Some(target)) => run_unit(unit, target, options, json),
        _ => run_table(options, json),
    }
}

/// A whole machine, placed and routed as one.
fn run_design(file: &Path, target: &str, options: &Synth, json: bool) -> Result {
    let (target, seeds) = (Target::from_name(target)?, options.seeds);
    let machine = emit_machine(&fitted::described(file, None)?)?;
    let report = synthesise_design(&machine, target, seeds, options.cache())?;
    output::report(json, &report, |_| output::text(describe(&report)));
    Ok(())
}

fn run_unit(unit: &str, target: &str, options: &Synth, json: bool) -> Result {
    let request = options.shape.request(unit)?;
    let target = Target::from_name(target)?;
    let seeds = options.seeds;
    if let Some(machine) = fitted::asked(&options.fitted, &request, None)? {
        return run_machine(&machine, target, json);
    }
    let report = synthesise(&request, target, seeds, options.cache())?;
    output::report(json, &report, |_| output::text(describe(&report)));
    Ok(())
}

/// The cost of a machine of its own widths: the sum of its units, and the clock of the slowest.
fn run_machine(machine: &MachineRequest, target: Target, json: bool) -> Result {
    let cost = fitted::costs_of(&[emit_machine(machine)?], Parts::Units, target, true)?[0];
    if json {
        output::json(&cost);
        return Ok(());
    }
    let own = cost.resources;
    let counts = [own.lut, own.ff, own.carry, own.dsp, own.bram, cost.cells];
    let mut lines = vec![format!("beam for {}, the sum of its units", target.name())];
    lines.extend(resources(counts.map(Some)));
    let clock = |fmax: f64| format!("{fmax:.1} MHz, of its slowest unit, one seed");
    lines.extend(cost.fmax_mhz.map(|fmax| line("Fmax", clock(fmax))));
    output::text(lines.join("\n"));
    Ok(())
}

fn run_table(options: &Synth, json: bool) -> Result {
    let figures = options.out.with_extension("json");
    if figures == options.out {
        let problem = "the page needs another ending than .json, which its figures have";
        return Err(Failure::at(&options.out, problem));
    }
    let rows = table::rows();
    let bar = output::progress(rows.len() as u64, "synthesis");
    // What is no table of this version gives no row; it is written anew.
    let known = Table::read(&figures).ok();
    let table = table::make(&rows, known.as_ref(), options.cache(), |_| bar.inc(1))?;
    bar.finish_and_clear();
    let mut files = output::files();
    files.add_text(&options.out, &table.markdown())?;
    files.add_text(&figures, &table.json())?;
    if let Some(picture) = table.picture()? {
        files.add_text(&beside(&options.out, table::PICTURE), &picture)?;
    }
    let files = files.finish()?;
    output::report(json, &table, |_| {
        let files = output::joined(files.iter().map(|path| path.display()), ", ");
        output::text(format!("wrote {files}"));
    });
    Ok(())
}

/// A path that the page names, seen from here.
fn beside(page: &Path, name: &str) -> PathBuf {
    page.parent().unwrap_or(Path::new("")).join(name)
}

/// A figure under its name.
fn line(name: &str, value: impl Display) -> String {
    format!("  {name:<12} {value}")
}

/// What is counted of resources: look-up tables, flip-flops, carry cells, multipliers, memories, logic cells.
fn resources(counts: [Option<u64>; 6]) -> Vec<String> {
    let names = ["LUT", "FF", "carry", "DSP", "BRAM", "logic cells"];
    let counted = names.iter().zip(counts);
    let lines = counted.filter_map(|(name, count)| Some(line(name, count?)));
    lines.collect()
}

fn describe(report: &SynthReport) -> String {
    let mut lines = vec![format!("{} for {}", report.unit, report.target)];
    lines.extend(resources([
        report.lut,
        report.ff,
        report.carry,
        report.dsp,
        report.bram,
        report.logic_cells,
    ]));
    let mut line = |name: &str, value: Option<String>| {
        lines.extend(value.map(|value| line(name, value)));
    };
    let count = |value: Option<u64>| value.map(|value| value.to_string());
    line("transistors", count(report.transistors));
    line("does not fit", report.does_not_fit.clone());
    let seeds = counted(report.seeds.len(), "seed");
    let clock = |fmax: f64| format!("{fmax:.1} MHz, median of {seeds}");
    line("Fmax", report.fmax_mhz.map(clock));
    let median = report.median_seed();
    let path = median.and_then(|run| run.critical_path.as_ref());
    let path = path.map(|path| {
        format!(
            "{} -> {} ({:.2} ns logic, {:.2} ns routing)",
            path.from, path.to, path.logic_ns, path.routing_ns
        )
    });
    line("slowest path", path);
    let tools = report.tools.iter();
    let tools = tools.map(|(tool, version)| format!("{tool} {version}"));
    line("tools", Some(output::joined(tools, ", ")));
    lines.join("\n")
}
