//! `imogene mutate`.

use super::machine;
use crate::arguments::{Mutate, View, option};
use crate::failure::{Failure, Result};
use crate::output;
use imogene_contract::{Request, Unit};
use imogene_files::text::counted;
use imogene_plan::description::MachineDescription;
use imogene_rtl::emit::{design, emit};
use imogene_verif::mutation::machine::{self as mutants, Shown};
use imogene_verif::mutation::{MutationReport, Options, circuit, netlist, table};
use imogene_verif::unit::subject;
use std::path::Path;

pub fn run(options: &Mutate, json: bool) -> Result {
    if let Some(path) = &options.machine {
        return of_machine(path, options, json);
    }
    let named = options.unit.iter().map(String::as_str);
    let units: Vec<&str> = match (options.unit == ["all"], options.netlist) {
        (true, None) => Unit::ALL.into_iter().map(Unit::name).collect(),
        (true, Some(_)) => table::NETLISTS.to_vec(),
        (false, _) => named.collect(),
    };
    let stimuli = options.netlist.map_or(20_000, |_| 150);
    let scale = Options {
        mutants: options.netlist.unwrap_or_default() as usize,
        stimuli: options.stimuli.unwrap_or(stimuli),
        clocks: options.clocks as usize,
        effort: options.effort,
        word_bits: options.word_bits,
        ..Options::default()
    };
    let mut reports = vec![];
    for format in &options.format {
        for unit in &units {
            let request = options.others.request(unit, *format)?;
            let report = match options.netlist {
                None => of_circuit(&request, &scale)?,
                Some(_) => of_netlist(&request, &scale)?,
            };
            if !json {
                output::text(output::page(LINE, &report)?);
            }
            reports.push(report);
        }
    }
    if let Some(path) = &options.out {
        let introduction = match options.netlist {
            None => table::OF_CIRCUITS,
            Some(_) => table::OF_NETLISTS,
        };
        let kind = option("netlist", options.netlist);
        let usual = Options::default();
        let effort = Some(options.effort).filter(|effort| *effort != usual.effort);
        let bits = Some(options.word_bits).filter(|bits| *bits != usual.word_bits);
        let unusual = option("effort", effort) + &option("word-bits", bits);
        let command = format!(
            "imogene mutate {} --format {}{}{kind} --stimuli {} --clocks {}{unusual} --out {}",
            options.unit.join(","),
            output::joined(&options.format, ","),
            options.others,
            scale.stimuli,
            options.clocks,
            path.display()
        );
        let text = table::markdown(&reports, introduction, &command);
        output::write_text(path, &text)?;
    }
    if json {
        output::json(&reports);
    }
    verdict(&reports)
}

/// What a machine is made of beside its units.
fn of_machine(path: &Path, options: &Mutate, json: bool) -> Result {
    let machine = MachineDescription::read(path)?;
    let as_written = View::default();
    let scenes = options.unit.iter().map(Path::new);
    let views: Vec<_> = scenes.map(|scene| (scene, as_written.clone())).collect();
    let images = machine::images_of(&views, &machine, path)?;
    let shown = Shown {
        machine: &machine,
        images: &images,
        runs: options.stimuli.unwrap_or(8),
        effort: options.effort,
    };
    let design = mutants::design(&machine, &images)?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let report = MutationReport::of(&name, &options.unit.join(","));
    let report = output::during(mutants::count(&design), "mutants", |bar| {
        mutants::run(&shown, &design, report, || bar.inc(1))
    })?;
    let line = output::page(LINE, &report)?;
    let reports = [report];
    output::report(json, &reports, |_| output::text(line));
    verdict(&reports)
}

fn of_circuit(request: &Request, options: &Options) -> Result<MutationReport> {
    let (subject, design) = (subject(request)?, design(request)?);
    Ok(output::during(circuit::count(&design), "mutants", |bar| {
        circuit::run(&subject, &design, options, || bar.inc(1))
    })?)
}

fn of_netlist(request: &Request, options: &Options) -> Result<MutationReport> {
    let (subject, emitted) = (subject(request)?, emit(request)?);
    let text = emitted.bundle();
    Ok(output::during(options.mutants as u64, "mutants", |bar| {
        netlist::run(&subject, (&emitted.top, &text), options, || bar.inc(1))
    })?)
}

/// A report in one line.
const LINE: &str = r#"{{ unit }}: {{ mutants|counted("mutant") }} of {{ candidates }}, {{ killed }} killed, {{ equivalent }} equivalent, {{ forgotten }} forgotten, {{ surviving|length }} surviving: score {{ score|fixed(2) }} % ({{ seconds|fixed(1) }} s)"#;

fn verdict(reports: &[MutationReport]) -> Result {
    let count: usize = reports.iter().map(|report| report.surviving.len()).sum();
    Failure::unless(count == 0, || {
        let (mutants, list) = (counted(count, "mutant"), table::survivors(reports));
        format!(
            "surviving and not proven equivalent: {mutants}\n{}",
            list.trim_end()
        )
    })
}
