//! What is told of a fitted machine: a summary for the terminal, and the contract beside the Verilog.

use crate::command::emit::{PortEntry, port};
use imogene_analysis::metrics::Metrics;
use imogene_contract::MachineWords;
use imogene_contract::slots;
use imogene_files::text::counted;
use imogene_golden::widths;
use imogene_plan::description::{MachineDescription, MachineKind};
use imogene_rtl::emit::Emitted;
use imogene_studies::fit::budget::Budget;
use imogene_studies::fit::frames::Drawn;
use imogene_studies::fit::omission::LeftPlane;
use imogene_studies::fit::proof::{Bounds, Proven};
use imogene_studies::kit::DrawError;
use imogene_studies::kit::page::{text, with};
use imogene_synth::fitted::MachineCost;
use imogene_verif::report::Report;
use serde::Serialize;
use serde_json::json;
use std::path::PathBuf;

/// What was fitted; the keys are stable.
#[derive(Serialize)]
pub struct FitReport<'a> {
    pub scenes: Vec<String>,
    pub width: usize,
    pub height: usize,
    pub budget: Budget,
    pub unit: String,
    pub machine: &'a MachineDescription,
    pub format: MachineWords,
    pub widths: String,
    pub slots: String,
    pub rows_per_stage: u32,
    pub latency: usize,
    pub clocks_per_frame: u64,
    /// Objects that the machine does not show.
    pub left_out: Vec<String>,
    /// Cut planes of the others that it does not have.
    pub left_out_planes: Vec<LeftPlane>,
    pub limits: Vec<Proven>,
    /// None where objects have none.
    pub bounds: Option<Bounds>,
    pub measured: Vec<Metrics>,
    pub target: &'static str,
    /// None without synthesis.
    pub cost: Option<MachineCost>,
    pub base_cost: Option<MachineCost>,
    /// Of the base machine, in percent.
    pub saving_percent: Option<Saving>,
    pub cosim: Vec<Report>,
    pub command: String,
    pub reproduce: String,
    pub files: Vec<PathBuf>,
    pub seconds: f64,
}

#[derive(Clone, Copy, Serialize)]
pub struct Saving {
    pub cells: f64,
    pub lut: f64,
    pub ff: f64,
}

/// Frames are many: the first and the last stand for those between.
fn named(scenes: &[String]) -> String {
    match scenes {
        [first, .., last] if scenes.len() > 3 => {
            format!("{} frames, from {first} to {last}", scenes.len())
        }
        _ => scenes.join(", "),
    }
}

pub const fn kind(machine: MachineKind) -> &'static str {
    match machine {
        MachineKind::Beam => "beam machine",
        MachineKind::Zone => "zone machine",
    }
}

/// A machine in one line.
fn line(machine: &MachineDescription, widths: &str) -> String {
    let processors = match machine.zone {
        None => format!("slots {}", slots::print(&machine.slots())),
        Some(zone) => format!(
            "{} of {}, zones of {} x {}",
            counted(machine.objects, "processor"),
            counted(machine.planes, "plane"),
            zone.width,
            zone.height
        ),
    };
    let volumes = match machine.volumes {
        0 => String::new(),
        volumes => format!(
            ", {} of {}",
            counted(volumes, "volume processor"),
            counted(machine.volume_planes, "plane")
        ),
    };
    let lights = match machine.lit_sphere {
        Some(sphere) => format!(
            "{} of {1} x {1} entries",
            counted(sphere.materials << machine.lights, "table"),
            sphere.side
        ),
        None => counted(machine.lights, "light"),
    };
    let rows = counted(machine.rows_per_stage, "row");
    let kind = match machine.pixels_per_clock {
        1 => kind(machine.machine).to_owned(),
        pixels => format!("{} of {pixels} pixels per clock", kind(machine.machine)),
    };
    format!("{kind}, {widths}, {processors}{volumes}, {lights}, {rows} per stage")
}

/// What is said of a machine before synthesis.
pub fn found(drawn: &Drawn, machine: &MachineDescription) -> String {
    let line = line(machine, &widths::print(&drawn.widths));
    format!("meets the budget: {line}")
}

/// A text about a machine from its template.
fn told(template: &str, report: &FitReport, ports: Vec<PortEntry>) -> Result<String, DrawError> {
    let others = json!({
        "named": named(&report.scenes),
        "line": line(report.machine, &report.widths),
        "ports": ports,
    });
    text("cannot tell of the machine", template, with(report, others))
}

pub fn summary(report: &FitReport) -> Result<String, DrawError> {
    let text = told(include_str!("summary.txt"), report, vec![])?;
    Ok(text.trim_end().to_owned())
}

pub fn page(report: &FitReport, emitted: &Emitted) -> Result<String, DrawError> {
    let ports = emitted.ports.iter().map(port).collect();
    told(include_str!("contract.md"), report, ports)
}
