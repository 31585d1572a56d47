//! `imogene cosim`.

use super::{describe, emit_request, extremes, frame_scene, threads, verdict};
use crate::arguments::{Cosim, EngineName};
use crate::failure::Failure;
use crate::output;
use imogene_models::scene::SceneFile;
use imogene_rtl::emit::emit;
use imogene_verif::engine::rust_hdl::RustHdl;
use imogene_verif::engine::verilator::beam::BeamModel;
use imogene_verif::engine::verilator::verilate;
use imogene_verif::report::Report;
use imogene_verif::scene::{self, TraceRequest};
use imogene_verif::unit::{self, Parameters};
use imogene_verif::{icarus, random};
use std::path::Path;

/// Clocks of the waveforms kept from the beginning of a scene.
const TRACE_CLOCKS: u64 = 2_000;

/// Compares hardware and golden model.
pub fn run(options: &Cosim, json: bool) -> Result<(), Failure> {
    if extremes::is_meant(&options.subject) {
        return extremes::run(&options.subject, json);
    }
    let report = if unit::NAMES.contains(&options.subject.as_str()) {
        run_unit(options)?
    } else {
        run_scene(options)?
    };
    if json {
        output::json(&report);
    } else {
        output::text(describe(&report));
    }
    verdict(&report)
}

fn run_unit(options: &Cosim) -> Result<Report, Failure> {
    let shape = options.shape;
    let parameters = Parameters {
        depth_word: shape.format,
        planes: shape.planes,
        rows_per_stage: shape.rows_per_stage,
        objects: shape.objects,
        digits: shape.digits,
        corrections: shape.corrections,
    };
    let subject = unit::subject(&options.subject, parameters).map_err(Failure::input)?;
    if options.inject_fault.is_some() {
        return Err(Failure::Input(
            "--inject-fault flips a coefficient bit of a scene's object; give a scene file".into(),
        ));
    }
    let subject = match options.engine {
        EngineName::Verilator => {
            let (top, text) = verilog(options)?;
            verilate(subject, &top, &text).map_err(Failure::input)?
        }
        EngineName::RustHdl | EngineName::Icarus => subject,
    };
    let (mut report, trace) = match options.engine {
        EngineName::RustHdl | EngineName::Verilator => random::run(
            &subject,
            options.clocks,
            options.seed,
            options.vcd.is_some(),
        ),
        EngineName::Icarus if options.vcd.is_some() => {
            return Err(Failure::Input(
                "--vcd is written by the engines rust-hdl and verilator; the engine icarus only compares".into(),
            ));
        }
        EngineName::Icarus => {
            let (top, text) = verilog(options)?;
            let stimuli = random::stimuli(&subject, options.clocks, options.seed);
            (
                icarus::run_all(&subject, &top, &text, &stimuli).map_err(Failure::input)?,
                None,
            )
        }
    };
    if let (Some(trace), Some(path)) = (trace, &options.vcd) {
        report.files = trace.write(path).map_err(Failure::input)?;
    }
    report.seed = Some(options.seed);
    report.reproduce = format!(
        "imogene cosim {} --engine {} {} --clocks {} --seed {}",
        options.subject, report.engine, subject.options, options.clocks, options.seed
    );
    Ok(report)
}

/// Name of the top module and text of the unit's Verilog.
fn verilog(options: &Cosim) -> Result<(String, String), Failure> {
    let request = emit_request(&options.subject, options.shape)?;
    let emitted = emit(&request).map_err(Failure::input)?;
    let text = emitted.bundle();
    Ok((emitted.top, text))
}

fn run_scene(options: &Cosim) -> Result<Report, Failure> {
    if options.engine == EngineName::Icarus {
        return Err(Failure::Input(
            "a scene is co-simulated by the engines rust-hdl and verilator; the engine icarus takes a unit".into(),
        ));
    }
    if options.engine == EngineName::Verilator && options.vcd.is_some() {
        return Err(Failure::Input(
            "--vcd of a scene shows the inside of a processor, which only the engine rust-hdl does"
                .into(),
        ));
    }
    let path = Path::new(&options.subject);
    if path.extension().is_none() && !path.exists() {
        return Err(Failure::Input(format!(
            "'{}' is neither a scene file nor a unit; units: {}",
            options.subject,
            unit::NAMES.join(", ")
        )));
    }
    let file = SceneFile::read(path).map_err(Failure::input)?;
    let (_, prepared) = frame_scene(&file, options.size, options.shape.format)?;
    let run_options = scene::Options {
        rows_per_stage: options.shape.rows_per_stage,
        bands: threads(),
        trace: options.vcd.as_ref().map(|path| TraceRequest {
            path: path.clone(),
            object: options.trace_object,
            clocks: TRACE_CLOCKS,
        }),
        fault: options.inject_fault.map(|f| f.0),
    };
    let pixels = u64::from(prepared.width) * u64::from(prepared.height);
    let bar = output::progress(pixels, "hardware in simulation");
    let (mut report, _) = if options.engine == EngineName::Verilator {
        let shape =
            scene::shape_of(&prepared, run_options.rows_per_stage).map_err(Failure::input)?;
        let model = BeamModel::compile(&shape).map_err(Failure::input)?;
        scene::run(&prepared, &run_options, |_| model.machine(), || bar.inc(1))
    } else {
        let engine = |shape: &_| RustHdl::new(shape).expect("the shape was checked");
        scene::run(&prepared, &run_options, engine, || bar.inc(1))
    }
    .map_err(Failure::input)?;
    bar.finish_and_clear();
    if options.engine == EngineName::Verilator {
        report.engine = "verilator".into();
    }
    report.subject = options.subject.clone();
    report.reproduce = format!(
        "imogene cosim {} --engine {} --size {}x{} --format {} --rows-per-stage {}",
        options.subject,
        report.engine,
        prepared.width,
        prepared.height,
        options.shape.format,
        options.shape.rows_per_stage
    );
    if let Some(f) = run_options.fault {
        report.reproduce += &format!(" --inject-fault {}:{}:{}", f.object, f.address, f.bit);
    }
    Ok(report)
}
