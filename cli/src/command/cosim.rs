//! `imogene cosim`.

use super::render::golden_frame;
use super::{describe, extremes, frame_in, read_scene, run_beam, run_slots, threads, verdict};
use crate::arguments::{Cosim, option};
use crate::failure::{Failure, Result};
use crate::output;
use imogene_contract::Unit;
use imogene_prepare::PreparedScene;
use imogene_synth::{Target, netlist};
use imogene_verif::engine::Engine;
use imogene_verif::engine::simulator::with_verilog;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, slots, volumes};
use imogene_verif::{random, unit};
use std::path::Path;

pub fn run(options: &Cosim, json: bool) -> Result {
    if extremes::is_meant(&options.subject) {
        options.given.of_neither("an extreme")?;
        return extremes::run(&options.subject, json);
    }
    let mut report = if Unit::from_name(&options.subject).is_ok() {
        run_unit(options)?
    } else {
        run_scene(options)?
    };
    if let (Some(trace), Some(path)) = (report.trace.take(), &options.waves.vcd) {
        let mut files = output::files();
        trace.add_to(&mut files, path)?;
        report.files = files.finish()?;
    }
    output::report(json, &report, |_| output::text(describe(&report)));
    verdict(&report)
}

fn run_unit(options: &Cosim) -> Result<Report> {
    options.given.of_unit()?;
    let request = options.shape.request(&options.subject)?;
    let subject = match (&options.netlist, options.engine) {
        (None, engine) => engine.unit(&request)?,
        (Some(_), Engine::BuiltIn) => {
            return Err(Failure::Input(
                "a netlist is Verilog, which the built-in engine does not run; give --engine icarus or --engine verilator"
                    .into(),
            ));
        }
        (Some(target), Engine::Verilog(simulator)) => {
            let netlist = netlist(&request, Target::from_name(target)?)?;
            let subject = unit::subject(&request)?;
            with_verilog(subject, simulator, &netlist.top, &netlist.text)?
        }
    };
    let waves = &options.waves;
    let wants_trace = waves.vcd.is_some();
    let (mut report, trace) = random::run(&subject, options.clocks, options.seed, wants_trace);
    let is_wanted = !waves.vcd_at_mismatch || report.mismatches > 0;
    report.trace = trace.filter(|_| is_wanted);
    report.seed = Some(options.seed);
    report.netlist = options.netlist.clone();
    report.reproduce = format!(
        "imogene cosim {} --engine {} {} --clocks {} --seed {}",
        options.subject, report.engine, subject.options, options.clocks, options.seed
    );
    report.reproduce += &option("netlist", options.netlist.as_ref());
    Ok(report)
}

fn run_scene(options: &Cosim) -> Result<Report> {
    let path = Path::new(&options.subject);
    if path.extension().is_none() && !path.exists() {
        let names = Unit::ALL.map(Unit::name).join(", ");
        return Err(Failure::Input(format!(
            "'{}' is neither a scene file nor a unit; units: {names}",
            options.subject
        )));
    }
    options.given.of_scene()?;
    if !options.shape.others.root_form.is_usual() {
        return Err(Failure::Input(format!(
            "--root-form is that of a unit; of a scene's machine give --widths depth={},root_form={}",
            options.shape.format, options.shape.others.root_form
        )));
    }
    let file = read_scene(path, &options.view)?;
    let format = options.words.format(options.shape.format);
    let (_, prepared) = frame_in(&file, options.size, format?)?;
    prepared.refuse_composed()?;
    let rows = options.shape.rows_per_stage();
    let mut report = if slots::is_for_beam(&prepared) {
        let run_options = scene::Options {
            rows_per_stage: rows,
            threads: threads(),
            trace: options.waves.request(),
            traced: options.trace_object,
            fault: options.inject_fault,
        };
        run_beam(&prepared, &run_options, options.engine)?.0
    } else {
        // Processors that a beam machine does not have: each by itself.
        let waves = options.waves.vcd.as_ref().map(|_| "--vcd");
        let fault = options.inject_fault.map(|_| "--inject-fault");
        if let Some(option) = waves.or(fault) {
            return Err(Failure::Input(format!(
                "{option} takes a scene of quadric processors alone, which a beam machine draws; this one has others, and each is run by itself"
            )));
        }
        run_slots(&prepared, rows, options.engine)?.0
    };
    run_volumes(options, &prepared, &mut report)?;
    report.engine = options.engine.name().into();
    report.subject = options.subject.clone();
    report.reproduce = format!(
        "imogene cosim {} --engine {} --size {}x{}{} --rows-per-stage {}",
        options.subject,
        report.engine,
        prepared.width,
        prepared.height,
        options.words.options(options.shape.format),
        rows
    );
    report.reproduce += &options.view.options();
    report.reproduce += &option("inject-fault", options.inject_fault);
    Ok(report)
}

/// The shadow and light volumes of a scene, on the depths of its golden frame, into the report of the rest.
fn run_volumes(options: &Cosim, prepared: &PreparedScene, report: &mut Report) -> Result {
    if prepared.volumes.is_empty() {
        return Ok(());
    }
    let frame = golden_frame(prepared);
    let rows = options.shape.rows_per_stage();
    let (pixels, engine) = (volumes::pixels(prepared), options.engine);
    let part = output::during(pixels, "volumes in simulation", |bar| {
        volumes::run(prepared, &frame, rows, engine, |n| bar.inc(n))
    })?;
    let seconds = report.seconds + part.seconds;
    report.absorb(part);
    report.timed(seconds);
    Ok(())
}
