//! `imogene fit`.

mod contract;

use super::{fitted, size_of, threads};
use crate::arguments::{Fit, FitEngine};
use crate::failure::Failure;
use crate::{missing, molecules, output};
use contract::{FitReport, Saving};
use imogene_files::text::counted;
use imogene_golden::format::Format;
use imogene_golden::machine::fitted::FittedMachine;
use imogene_golden::{slots, widths};
use imogene_prepare::Options;
use imogene_rtl::emit::Emitted;
use imogene_scene::SceneFile;
use imogene_scene::animation::Playback;
use imogene_studies::fit::budget::Item;
use imogene_studies::fit::frames::{Drawn, Frames};
use imogene_studies::fit::proof;
use imogene_studies::fit::search::{Outcome, search};
use imogene_studies::picture;
use imogene_synth::Target;
use imogene_synth::fitted::MachineCost;
use imogene_verif::engine::beam::BeamDesign;
use imogene_verif::report::Report;
use imogene_verif::scene;
use std::time::Instant;

/// Machines of different depth words whose costs are compared.
const SYNTHESISED: usize = 3;
/// Rows of the root network between registers that are tried when a clock is asked for.
const ROWS: [u32; 4] = [1, 2, 3, 4];

/// A machine that meets the budget, with what it costs.
struct Choice<'a> {
    drawn: &'a Drawn,
    machine: FittedMachine,
    cost: MachineCost,
}

/// Finds, proves, emits and co-simulates the smallest machine.
pub fn run(options: &Fit, json: bool) -> Result<(), Failure> {
    let started = Instant::now();
    let target = Target::from_name(&options.target)?;
    let budget = options.budget();
    let frames = frames(options)?;
    let outcome = output::during(0, "machines drawn", |bar| {
        search(&frames, &budget, || bar.inc(1))
    });
    let found = match outcome? {
        Outcome::Fits(found) => found,
        Outcome::Unreachable { items, nearest } => return Err(unreachable(&items, &nearest)),
    };
    let choice = choose(&found, options.min_mhz, target)?;
    let base = base_machine(&choice.machine);
    let machines = [choice.machine.clone(), base];
    let with_clock = options.clock || options.min_mhz.is_some();
    let costs = fitted::costs(&machines, target, with_clock)?;
    let (cost, base_cost) = (costs[0], costs[1]);
    let emitted = fitted::emit(&choice.machine, None)?;
    let cosim = cosimulate(&choice, options.engine)?;
    let bounds = proof::bounds(&frames, choice.drawn);
    let limits = proof::proofs(&frames, &budget, choice.drawn, &bounds);
    let format = choice.machine.format()?;
    let (width, height) = (frames.all()[0].truth.width, frames.all()[0].truth.height);
    let mut report = FitReport {
        scenes: frames.all().iter().map(|f| f.name.clone()).collect(),
        width,
        height,
        unit: "beam",
        format: choice.machine.widths,
        widths: widths::print(&choice.machine.widths),
        slots: slots::print(&choice.machine.slots),
        rows_per_stage: choice.machine.rows_per_stage,
        latency: choice.machine.latency(&format),
        clocks_per_frame: choice
            .machine
            .clocks_per_frame(&format, width as u32, height as u32),
        limits,
        bounds,
        measured: choice.drawn.metrics.clone(),
        target: target.name(),
        cost,
        base_cost,
        saving_percent: saving(&cost, &base_cost),
        cosim,
        command: choice.machine.command(),
        reproduce: options.reproduce(&budget),
        budget,
        files: vec![],
        seconds: 0.0,
    };
    report.seconds = started.elapsed().as_secs_f64();
    write(&mut report, &frames, choice.drawn, &emitted, options)?;
    output::report(json, &report, |_| output::text(contract::summary(&report)));
    verdict(&report)
}

fn frames(options: &Fit) -> Result<Frames, Failure> {
    let mut files: Vec<(String, SceneFile)> = vec![];
    for path in &options.scenes {
        let file = molecules::read_scene(path)?;
        let name = path.display().to_string();
        if file.images.is_empty() {
            let size = size_of(&file, options.size);
            files.push((
                name,
                missing::reduced(file, size, Format::BASE, Options::ROOTS)?,
            ));
        } else {
            let playback = Playback::new(&file)?;
            files.extend(playback.scenes(&name)?);
        }
    }
    let frames = output::during(0, "lines of the truth", |bar| {
        Frames::new(&files, options.size, || bar.inc(1))
    });
    frames.map_err(Failure::from)
}

/// The message of a budget that no machine meets.
fn unreachable(items: &[Item], nearest: &Drawn) -> Failure {
    let mut text = String::from("no machine meets the budget; out of reach:");
    for item in items.iter().filter(|item| !item.holds()) {
        text += &format!("\n  {item}");
    }
    text += &format!(
        "\nthe figures are those of the nearest machine, --widths {}",
        widths::print(&nearest.widths)
    );
    Failure::Check(text)
}

/// The cheapest of the machines found; with a clock asked for, the cheapest that reaches it.
fn choose<'a>(
    found: &'a [Drawn],
    min_mhz: Option<f64>,
    target: Target,
) -> Result<Choice<'a>, Failure> {
    let rows: &[u32] = if min_mhz.is_some() { &ROWS } else { &ROWS[..1] };
    let candidates: Vec<(&Drawn, FittedMachine)> = found
        .iter()
        .take(SYNTHESISED)
        .flat_map(|drawn| rows.iter().map(move |&rows| (drawn, rows)))
        .filter(|(drawn, rows)| *rows <= drawn.widths.root - drawn.widths.dropped_rows)
        .map(|(drawn, rows)| (drawn, drawn.machine(rows)))
        .collect();
    let machines: Vec<FittedMachine> = candidates.iter().map(|(_, m)| m.clone()).collect();
    let costs = fitted::costs(&machines, target, min_mhz.is_some())?;
    let priced = candidates.into_iter().zip(costs);
    let priced: Vec<Choice> = priced
        .map(|((drawn, machine), cost)| Choice {
            drawn,
            machine,
            cost,
        })
        .collect();
    let fast = |choice: &Choice| min_mhz.is_none_or(|least| choice.cost.fmax_mhz >= Some(least));
    let fastest = priced.iter().filter_map(|choice| choice.cost.fmax_mhz);
    let fastest = fastest.reduce(f64::max);
    let cheapest = priced.into_iter().filter(fast);
    let cheapest = cheapest.min_by_key(|choice| (choice.cost.cells, choice.cost.resources.ff));
    cheapest.ok_or_else(|| {
        Failure::Check(format!(
            "no machine reaches {} MHz on {}: the slowest unit of the fastest machine that meets the budget runs at {} MHz",
            min_mhz.unwrap_or_default(),
            target.name(),
            fastest.map_or("an unknown number of".into(), |mhz| format!("{mhz:.1}"))
        ))
    })
}

/// The machine of the base format for the same scene: equal slots with half B.
fn base_machine(machine: &FittedMachine) -> FittedMachine {
    let planes = machine.slots.iter().map(|slot| slot.planes).max();
    FittedMachine::uniform(&Format::BASE, machine.slots.len(), planes.unwrap_or(0), 1)
}

fn saving(cost: &MachineCost, base: &MachineCost) -> Saving {
    let percent = |own: u64, base: u64| 100.0 * (1.0 - own as f64 / base.max(1) as f64);
    Saving {
        cells: percent(cost.cells, base.cells),
        lut: percent(cost.resources.lut, base.resources.lut),
        ff: percent(cost.resources.ff, base.resources.ff),
    }
}

/// Every frame in hardware against the golden machine.
fn cosimulate(choice: &Choice, engine: FitEngine) -> Result<Vec<Report>, Failure> {
    let Some(engine) = engine else {
        return Ok(vec![]);
    };
    let machine = &choice.machine;
    let design = BeamDesign::compile(engine, &scene::request(machine, ""), vec![])?;
    let options = scene::Options::plain(machine.rows_per_stage as usize, threads());
    let frames = &choice.drawn.prepared;
    let pixels: u64 = frames
        .iter()
        .map(|f| u64::from(f.width) * u64::from(f.height))
        .sum();
    let bar = output::progress(pixels, "hardware in simulation");
    let one = |prepared| {
        let drawn = scene::run_on(&design, machine, prepared, &options, || bar.inc(1));
        Ok(drawn?.0)
    };
    let reports = frames.iter().map(one).collect();
    bar.finish_and_clear();
    reports
}

/// Verilog, contract, report, and of every frame the golden picture and the map of its errors.
fn write(
    report: &mut FitReport,
    frames: &Frames,
    drawn: &Drawn,
    emitted: &Emitted,
    options: &Fit,
) -> Result<(), Failure> {
    let mut files = output::files();
    files.add_text(&options.out.join("beam.v"), &emitted.bundle())?;
    for (index, frame) in frames.all().iter().enumerate() {
        let (rgb, map) = frame.picture(&drawn.prepared[index]);
        let number = if frames.all().len() > 1 {
            format!("-{index}")
        } else {
            String::new()
        };
        for (name, picture) in [("golden", rgb), ("errors", map)] {
            let path = options.out.join(format!("{name}{number}.png"));
            let (width, height) = (frame.truth.width, frame.truth.height);
            files.add(&path, |out| picture::png(out, width, height, &picture))?;
        }
    }
    let page = contract::page(report, emitted);
    files.add_text(&options.out.join("contract.md"), &page)?;
    let figures = options.out.join("fit.json");
    report.files = files.paths();
    report.files.push(figures.clone());
    files.add_text(&figures, &output::json_text(report))?;
    files.finish()?;
    Ok(())
}

fn verdict(report: &FitReport) -> Result<(), Failure> {
    let mismatches: u64 = report.cosim.iter().map(|r| r.mismatches).sum();
    if mismatches == 0 {
        return Ok(());
    }
    Err(Failure::Check(format!(
        "{} between the fitted hardware and the golden model; please report the command: {}",
        counted(mismatches, "difference"),
        report.reproduce
    )))
}
