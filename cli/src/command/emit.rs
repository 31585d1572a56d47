//! `imogene emit`.

use super::emit_request;
use crate::arguments::Emit;
use crate::failure::Failure;
use crate::output;
use imogene_models::picture::write_whole;
use imogene_rtl::emit::{Direction, EmitRequest, Emitted, emit, emit_with_prefix};
use serde::Serialize;
use std::io::Write;
use std::path::{Path, PathBuf};

/// What was emitted; the keys are stable.
#[derive(Serialize)]
struct EmitReport {
    unit: &'static str,
    top: String,
    files: Vec<PathBuf>,
    latency: usize,
    modules: usize,
    ports: Vec<PortEntry>,
}

#[derive(Serialize)]
struct PortEntry {
    name: String,
    direction: &'static str,
    width: usize,
    signed: bool,
}

/// Writes the Verilog of a unit.
pub fn run(options: &Emit, json: bool) -> Result<(), Failure> {
    let request = emit_request(&options.unit, options.shape)?;
    let (emitted, files) = write_verilog(
        &request,
        options.prefix.as_deref(),
        &options.out,
        options.split,
    )?;
    let report = EmitReport {
        unit: request.unit.name(),
        top: emitted.top.clone(),
        files,
        latency: emitted.latency,
        modules: emitted.modules.len(),
        ports: emitted.ports.iter().map(port).collect(),
    };
    if json {
        output::json(&report);
    } else {
        for file in &report.files {
            output::text(format!("wrote {}", file.display()));
        }
        output::text(format!(
            "top {}, {} modules, {} ports, latency {} clocks",
            report.top,
            report.modules,
            report.ports.len(),
            report.latency
        ));
    }
    Ok(())
}

/// Emits and writes one file, or one for each module and a list of them; returns what was emitted and the files.
pub fn write_verilog(
    request: &EmitRequest,
    prefix: Option<&str>,
    folder: &Path,
    split: bool,
) -> Result<(Emitted, Vec<PathBuf>), Failure> {
    let emitted = match prefix {
        Some(prefix) => emit_with_prefix(request, prefix),
        None => emit(request),
    };
    let emitted = emitted.map_err(Failure::input)?;
    let texts = if split {
        let mut texts = emitted.files();
        let names: Vec<String> = texts.iter().map(|(name, _)| format!("{name}\n")).collect();
        texts.push((format!("{}.f", emitted.top), names.concat()));
        texts
    } else {
        vec![(format!("{}.v", emitted.top), emitted.bundle())]
    };
    let mut files = Vec::new();
    for (name, text) in &texts {
        let path = folder.join(name);
        write_whole(&path, |out| out.write_all(text.as_bytes())).map_err(Failure::input)?;
        files.push(path);
    }
    Ok((emitted, files))
}

fn port(port: &imogene_rtl::emit::Port) -> PortEntry {
    PortEntry {
        name: port.name.clone(),
        direction: match port.direction {
            Direction::Input => "input",
            Direction::Output => "output",
        },
        width: port.width,
        signed: port.signed,
    }
}
