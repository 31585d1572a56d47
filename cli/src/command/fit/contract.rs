//! What is told of a fitted machine: a summary for the terminal, and the contract beside the Verilog.

use imogene_analysis::metrics::Metrics;
use imogene_contract::MachineWords;
use imogene_files::text::counted;
use imogene_golden::{slots, widths};
use imogene_plan::description::{MachineDescription, MachineKind};
use imogene_rtl::emit::{Direction, Emitted};
use imogene_studies::fit::budget::Budget;
use imogene_studies::fit::frames::Drawn;
use imogene_studies::fit::proof::{Bounds, Proof, Proven};
use imogene_synth::fitted::MachineCost;
use imogene_verif::report::Report;
use serde::Serialize;
use std::fmt::Write;
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
    let kind = match machine.machine {
        MachineKind::Beam => "beam machine",
        MachineKind::Zone => "zone machine",
    };
    let lights = counted(machine.lights, "light");
    let rows = counted(machine.rows_per_stage, "row");
    format!("{kind}, {widths}, {processors}{volumes}, {lights}, {rows} per stage")
}

/// What is said of a machine before synthesis.
pub fn found(drawn: &Drawn, machine: &MachineDescription) -> String {
    format!(
        "meets the budget: {}",
        line(machine, &widths::print(&drawn.widths))
    )
}

pub fn summary(report: &FitReport) -> String {
    let mut text = format!(
        "{}: {}\n",
        named(&report.scenes),
        line(report.machine, &report.widths)
    );
    for limit in &report.limits {
        let _ = writeln!(text, "  {}, {}", limit.item, how(limit));
    }
    let clocks = counted(report.clocks_per_frame, "clock");
    let _ = writeln!(text, "  {clocks} a frame");
    if let (Some(cost), Some(base), Some(saving)) =
        (report.cost, report.base_cost, report.saving_percent)
    {
        let _ = writeln!(
            text,
            "  {}: {} logic cells, {} LUT, {} FF; the base format takes {} cells, {} LUT, {} FF: {:.1} % of the LUT saved",
            report.target,
            cost.cells,
            cost.resources.lut,
            cost.resources.ff,
            base.cells,
            base.resources.lut,
            base.resources.ff,
            saving.lut
        );
    }
    for cosim in &report.cosim {
        let _ = writeln!(
            text,
            "  {}: {}, {} compared, {}",
            cosim.engine,
            counted(cosim.cycles, "clock"),
            counted(cosim.comparisons, "value"),
            counted(cosim.mismatches, "mismatch")
        );
    }
    for file in &report.files {
        let _ = writeln!(text, "wrote {}", file.display());
    }
    text.trim_end().to_owned()
}

fn how(limit: &Proven) -> String {
    match (limit.proof, limit.bound) {
        (Proof::Bound, Some(bound)) => format!("proven: at most {bound:.4}"),
        (_, Some(bound)) => {
            format!("by comparing every pixel (what is proven for any pixel: at most {bound:.4})")
        }
        (_, None) => "by comparing every pixel".into(),
    }
}

pub fn page(report: &FitReport, emitted: &Emitted) -> String {
    let mut text = format!(
        "# `{}`: a machine fitted to {}\n\nMade by `{}`; shown and emitted again by `{}`.\n\n",
        emitted.top,
        named(&report.scenes),
        report.reproduce,
        report.command
    );
    let _ = writeln!(
        text,
        "A {}. Shows these frames at {} x {} pixels; {} clocks a frame.\n",
        line(report.machine, &report.widths),
        report.width,
        report.height,
        report.clocks_per_frame
    );
    text += "## Errors\n\n| limit | allowed | measured | proven | how it is known |\n|---|---|---|---|---|\n";
    for limit in &report.limits {
        let item = &limit.item;
        let bound = limit
            .bound
            .map_or("-".into(), |bound| format!("{bound:.4}"));
        let known = match limit.proof {
            Proof::Bound => "the bound holds for every pixel",
            Proof::Exhaustive => "every pixel of every frame compared with the exact picture",
        };
        let _ = writeln!(
            text,
            "| {}, {} | {} | {:.4} | {bound} | {known} |",
            item.limit, item.unit, item.allowed, item.measured
        );
    }
    if let Some(bounds) = &report.bounds {
        text += &proven(bounds);
    }
    text += &words(report);
    text += &ports(emitted);
    text += &cost(report);
    for cosim in &report.cosim {
        let _ = writeln!(
            text,
            "The pins in {}: {}, {} compared with the golden machine, {}.",
            cosim.engine,
            counted(cosim.cycles, "clock"),
            counted(cosim.comparisons, "value"),
            counted(cosim.mismatches, "mismatch")
        );
    }
    text
}

fn proven(bounds: &Bounds) -> String {
    format!(
        "\nProven before any pixel is drawn: depth within {:.3} words of the base format, silhouette within {:.2e} pixels, normal within {:.3} degrees; {} \
         undecided, everywhere else the visible face is the true one.\n\n",
        bounds.depth_lsb,
        bounds.silhouette_px,
        bounds.normal_deg,
        counted(bounds.undecided_pixels, "pixel")
    )
}

fn words(report: &FitReport) -> String {
    let w = &report.format;
    format!(
        "## Words\n\n| word | bits |\n|---|---|\n| depth | {} |\n| f1 in its pe1 | {}, of which {} guard bits |\n| f2 in its pe2 | {}, of which {} guard bits |\n\
         | root | {}, of which the last {} are zero |\n| plane | {} |\n| normal component | {} |\n\n\
         Object processors, by their planes, with a `v` where the viewer may be inside: {}. Rows of the root network between \
         registers: {}.\n\n",
        w.depth,
        w.depth + 2 + w.guard_linear,
        w.guard_linear,
        2 * w.root + w.guard_quadratic,
        w.guard_quadratic,
        w.root,
        w.dropped_rows,
        w.plane,
        w.normal,
        report.slots,
        report.rows_per_stage
    )
}

fn ports(emitted: &Emitted) -> String {
    let mut text = String::from("## Ports\n\n| port | direction | bits |\n|---|---|---|\n");
    for port in &emitted.ports {
        let direction = match port.direction {
            Direction::In => "in",
            Direction::Out => "out",
        };
        let sign = if port.signed {
            ", two's complement"
        } else {
            ""
        };
        let _ = writeln!(
            text,
            "| `{}` | {direction} | {}{sign} |",
            port.name, port.width
        );
    }
    text + "\nTheir meanings, the words and the order of events are those of `docs/machines.md`.\n\n"
}

fn cost(report: &FitReport) -> String {
    let (Some(own), Some(base), Some(saving)) =
        (report.cost, report.base_cost, report.saving_percent)
    else {
        return String::new();
    };
    let row = |name: &str, cost: &MachineCost| {
        let own = &cost.resources;
        let clock = cost.fmax_mhz.map_or("-".into(), |mhz| format!("{mhz:.1}"));
        format!(
            "| {name} | {} | {} | {} | {} | {} | {clock} |\n",
            cost.cells, own.lut, own.ff, own.carry, own.dsp
        )
    };
    format!(
        "## Cost on {}\n\n| machine | logic cells | LUT | FF | carry | multipliers | MHz of the slowest unit |\n|---|---|---|---|---|---|---|\n{}{}\n\
         Saved: {:.1} % of the cells, {:.1} % of the LUT, {:.1} % of the FF. Sums over separately synthesised modules; `docs/fit.md` compares them with the flat \
         machine.\n\n",
        report.target,
        row("fitted", &own),
        row("base format, all processors alike", &base),
        saving.cells,
        saving.lut,
        saving.ff
    )
}
