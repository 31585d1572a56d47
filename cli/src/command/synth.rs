//! `imogene synth`.

mod check;

use super::fitted;
use crate::arguments::Synth;
use crate::failure::{Failure, Result};
use crate::output;
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};
use imogene_studies::kit::page::with;
use imogene_synth::fitted::Parts;
use imogene_synth::table::{self, Table};
use imogene_synth::{Target, synthesise, synthesise_design};
use serde_json::json;
use std::path::Path;

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
    let target = Target::from_name(target)?;
    let machine = emit_machine(&fitted::described(file, None)?)?;
    let report = synthesise_design(&machine, target, options.seeds, options.cache())?;
    output::told(json, &report, include_str!("synth/report.txt"))
}

fn run_unit(unit: &str, target: &str, options: &Synth, json: bool) -> Result {
    let request = options.shape.request(unit)?;
    let target = Target::from_name(target)?;
    if let Some(machine) = fitted::asked(&options.fitted, &request, None)? {
        return run_machine(&machine, target, json);
    }
    let report = synthesise(&request, target, options.seeds, options.cache())?;
    output::told(json, &report, include_str!("synth/report.txt"))
}

/// The cost of a machine of its own widths: the sum of its units, and the clock of the slowest.
fn run_machine(machine: &MachineRequest, target: Target, json: bool) -> Result {
    let cost = fitted::costs(&[emit_machine(machine)?], Parts::Units, target, true)?[0];
    let told = with(cost, json!({ "target": target.name() }));
    let page = output::page(include_str!("synth/fitted.txt"), told)?;
    output::report(json, &cost, |_| output::text(page));
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
        // A path that the page names, seen from here.
        let folder = options.out.parent().unwrap_or(Path::new(""));
        files.add_text(&folder.join(table::PICTURE), &picture)?;
    }
    let files = files.finish()?;
    output::report(json, &table, |_| {
        let files = output::joined(files.iter().map(|path| path.display()), ", ");
        output::text(format!("wrote {files}"));
    });
    Ok(())
}
