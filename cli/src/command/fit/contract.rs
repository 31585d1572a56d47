//! What is told of a fitted machine: a summary for the terminal, and the contract beside the Verilog.

use imogene_analysis::metrics::Metrics;
use imogene_contract::MachineWords;
use imogene_files::text::counted;
use imogene_rtl::emit::{Direction, Emitted};
use imogene_studies::fit::budget::Budget;
use imogene_studies::fit::proof::{Bounds, Proof, Proven};
use imogene_synth::fitted::MachineCost;
use imogene_verif::report::Report;
use serde::Serialize;
use std::fmt::Write;
use std::path::PathBuf;

/// What was fitted; the keys are stable.
#[derive(Serialize)]
pub struct FitReport {
    pub scenes: Vec<String>,
    pub width: usize,
    pub height: usize,
    pub budget: Budget,
    pub unit: &'static str,
    pub format: MachineWords,
    pub widths: String,
    pub slots: String,
    pub rows_per_stage: u32,
    pub latency: u32,
    pub clocks_per_frame: u64,
    pub limits: Vec<Proven>,
    pub bounds: Bounds,
    pub measured: Vec<Metrics>,
    pub target: &'static str,
    pub cost: MachineCost,
    pub base_cost: MachineCost,
    /// Of the base machine, in percent.
    pub saving_percent: Saving,
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

pub fn summary(report: &FitReport) -> String {
    let mut text = format!(
        "{}: beam --widths {} --slots {} --rows-per-stage {}\n",
        named(&report.scenes),
        report.widths,
        report.slots,
        report.rows_per_stage
    );
    for limit in &report.limits {
        let _ = writeln!(text, "  {}, {}", limit.item, how(limit));
    }
    let _ = writeln!(
        text,
        "  {}: {} logic cells, {} LUT, {} FF; the base format takes {} cells, {} LUT, {} FF: {:.1} % of the LUT saved",
        report.target,
        report.cost.cells,
        report.cost.resources.lut,
        report.cost.resources.ff,
        report.base_cost.cells,
        report.base_cost.resources.lut,
        report.base_cost.resources.ff,
        report.saving_percent.lut
    );
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
        "# `{}`: a beam machine fitted to {}\n\nMade by `{}`; the same Verilog: `{}`.\n\n",
        emitted.top,
        named(&report.scenes),
        report.reproduce,
        report.command
    );
    let _ = writeln!(
        text,
        "Draws these frames at {} x {} pixels, a pixel a clock: latency {} clocks from `go` to the first pixel, {} clocks a frame.\n",
        report.width, report.height, report.latency, report.clocks_per_frame
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
    let bounds = &report.bounds;
    let _ = writeln!(
        text,
        "\nProven before any pixel is drawn: depth within {:.3} words of the base format, silhouette within {:.2e} pixels, normal within {:.3} degrees; {} \
         undecided, everywhere else the visible face is the true one.\n",
        bounds.depth_lsb,
        bounds.silhouette_px,
        bounds.normal_deg,
        counted(bounds.undecided_pixels, "pixel")
    );
    text += &words(report);
    text += &ports(emitted);
    text += &cost(report);
    for cosim in &report.cosim {
        let _ = writeln!(
            text,
            "Co-simulated in {}: {}, {} compared with the golden machine, {}.",
            cosim.engine,
            counted(cosim.cycles, "clock"),
            counted(cosim.comparisons, "value"),
            counted(cosim.mismatches, "mismatch")
        );
    }
    text
}

fn words(report: &FitReport) -> String {
    let w = &report.format;
    format!(
        "## Words\n\n| word | bits |\n|---|---|\n| depth | {} |\n| f1 in its pe1 | {}, of which {} guard bits |\n| f2 in its pe2 | {}, of which {} guard bits |\n\
         | root | {}, of which the last {} are zero |\n| plane | {} |\n| normal component | {} |\n\n\
         Slots, by their planes, with a `v` where the viewer may be inside: {}. Rows of the root network between registers: {}.\n\n",
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
    text + "\nTheir meanings, the load bus and the order of events are those of `docs/architecture.md`, section 7.\n\n"
}

fn cost(report: &FitReport) -> String {
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
        row("fitted", &report.cost),
        row("base format, all slots alike", &report.base_cost),
        report.saving_percent.cells,
        report.saving_percent.lut,
        report.saving_percent.ff
    )
}
