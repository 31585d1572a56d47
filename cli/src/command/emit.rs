//! `imogene emit`.

use super::fitted;
use crate::arguments::Emit;
use crate::failure::Result;
use crate::output;
use imogene_files::Outputs;
use imogene_files::text::counted;
use imogene_rtl::emit::machine::emit_machine;
use imogene_rtl::emit::{Emitted, emit, emit_with_prefix};
use serde::Serialize;
use std::path::{Path, PathBuf};

/// What was emitted; the keys are stable.
#[derive(Serialize)]
struct EmitReport {
    unit: String,
    top: String,
    files: Vec<PathBuf>,
    latency: usize,
    modules: usize,
    ports: Vec<PortEntry>,
}

#[derive(Serialize)]
pub struct PortEntry {
    name: String,
    direction: &'static str,
    width: usize,
    signed: bool,
}

pub fn run(options: &Emit, json: bool) -> Result {
    let prefix = options.prefix.as_deref();
    let (unit, emitted) = match (&options.machine, &options.unit) {
        (Some(file), _) => (None, emit_machine(&fitted::described(file, prefix)?)?),
        (None, unit) => {
            let request = options.shape.request(unit.as_deref().unwrap_or_default())?;
            let emitted = match fitted::asked(&options.fitted, &request, prefix)? {
                Some(machine) => emit_machine(&machine)?,
                None => prefix.map_or_else(|| emit(&request), |p| emit_with_prefix(&request, p))?,
            };
            (Some(request.unit.name()), emitted)
        }
    };
    let mut files = output::files();
    add_verilog(&mut files, &emitted, &options.out, options.split)?;
    let files = files.finish()?;
    let report = EmitReport {
        unit: unit.map_or_else(|| emitted.top.clone(), str::to_owned),
        top: emitted.top.clone(),
        files,
        latency: emitted.latency,
        modules: emitted.modules.len(),
        ports: emitted.ports.iter().map(port).collect(),
    };
    output::report(json, &report, |report| {
        output::wrote(&report.files);
        let (top, modules) = (&report.top, counted(report.modules, "module"));
        let ports = counted(report.ports.len(), "port");
        let latency = counted(report.latency, "clock");
        output::text(format!("top {top}, {modules}, {ports}, latency {latency}"));
    });
    Ok(())
}

/// Adds one file, or one for each module and a list of them.
pub fn add_verilog(files: &mut Outputs, emitted: &Emitted, folder: &Path, split: bool) -> Result {
    let mut texts = vec![(format!("{}.v", emitted.top), emitted.bundle())];
    if split {
        texts = emitted.files();
        let names: String = texts.iter().map(|(name, _)| format!("{name}\n")).collect();
        texts.push((format!("{}.f", emitted.top), names));
    }
    for (name, text) in &texts {
        files.add_text(&folder.join(name), text)?;
    }
    Ok(())
}

pub fn port(port: &imogene_rtl::emit::Port) -> PortEntry {
    PortEntry {
        name: port.name.clone(),
        direction: port.direction.keyword(),
        width: port.width,
        signed: port.signed,
    }
}
