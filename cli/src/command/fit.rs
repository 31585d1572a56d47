//! `imogene fit`.

mod contract;

use super::emit::add_verilog;
use super::fitted::{costs, emitted};
use super::size_of;
use crate::arguments::{Fit, MACHINE_FILE};
use crate::failure::{Failure, Result};
use crate::{missing, molecules, output};
use contract::{FitReport, Saving};
use imogene_contract::slots;
use imogene_files::text::counted;
use imogene_golden::format::Format;
use imogene_golden::widths;
use imogene_plan::description::{MachineDescription, MachineKind};
use imogene_plan::display::{Image, check_tables, image};
use imogene_prepare::{Framing, Options};
use imogene_rtl::emit::Emitted;
use imogene_rtl::emit::machine::emit_machine;
use imogene_scene::SceneFile;
use imogene_scene::animation::Playback;
use imogene_studies::fit::budget::Budget;
use imogene_studies::fit::frames::{Drawn, Frames};
use imogene_studies::fit::machine::{self, Fitted};
use imogene_studies::fit::omission::{LeaveOut, LeftOut, Omission};
use imogene_studies::fit::search::{Outcome, search};
use imogene_studies::fit::{FitError, proof};
use imogene_synth::Target;
use imogene_synth::fitted::{MachineCost, Parts};
use imogene_verif::display::pins::{PinsRun, run as run_pins};
use imogene_verif::display::request::{request_for, zone_timing};
use imogene_verif::report::Report;
use std::path::PathBuf;
use std::time::Instant;

/// Machines of different depth words whose costs are compared.
const SYNTHESISED: usize = 3;
/// Rows of the root network between registers that are tried when a clock is asked for.
const ROWS: [u32; 4] = [1, 2, 3, 4];

/// A machine that meets the budget, with what it costs.
struct Choice<'a> {
    drawn: &'a Drawn,
    machine: Fitted,
    cost: Option<MachineCost>,
}

/// Finds, proves, emits and co-simulates the smallest machine; where a beam machine has too many cells, that of a zone
/// machine.
pub fn run(options: &Fit, json: bool) -> Result {
    let started = Instant::now();
    let target = Target::from_name(&options.target)?;
    let budget = options.budget();
    let (mut frames, left_out, mut found) = searched(options)?;
    let mut too_large: Vec<String> = vec![];
    loop {
        let choice = choose(&frames, &found, options, target, json)?;
        let Some(cells) = too_many(&choice, options) else {
            return finish(options, json, (&frames, left_out, choice), target, started);
        };
        let tried = choice.machine.description.machine;
        too_large.push(format!("a {} takes {cells}", contract::kind(tried)));
        let is_last = options.kind().is_some() || tried == MachineKind::Zone;
        if is_last || !frames.share_processors() {
            let (most, target) = (options.max_cells.unwrap_or_default(), target.name());
            let taken = too_large.join(", ");
            return Err(Failure::Check(format!(
                "no machine that meets the budget has at most {most} logic cells of {target}: {taken}"
            )));
        }
        found = self::found(&frames, &budget)?;
    }
}

/// The cells of a machine, if it has more than it may have.
fn too_many(choice: &Choice, options: &Fit) -> Option<u64> {
    let (cost, most) = choice.cost.zip(options.max_cells)?;
    (cost.cells > most).then_some(cost.cells)
}

/// Proves, emits and co-simulates a machine, and writes what is told of it.
fn finish(
    options: &Fit,
    json: bool,
    (frames, left_out, choice): (&Frames, LeftOut, Choice),
    target: Target,
    started: Instant,
) -> Result {
    let budget = options.budget();
    let named = |index| frame_file(options, frames, "scene", index, "toml");
    let scenes = (0..).map(named).zip(left_out.scenes);
    let scenes: Vec<(PathBuf, SceneFile)> = scenes.collect();
    let written: Vec<PathBuf> = scenes.iter().map(|(path, _)| path.clone()).collect();
    let command = options.command(frames, &written);
    let description = &choice.machine.description;
    let (images, cosim) = show(&choice, frames, options)?;
    let emitted = emit_machine(&request_for(description, &images[0].tables, &command))?;
    let base_cost = match choice.cost {
        Some(_) => Some(price(&[machine::base(description)], target, options)?[0]),
        None => None,
    };
    let has_bounds = frames.has_bounds && frames.is_whole;
    let bounds = has_bounds.then(|| proof::bounds(frames, choice.drawn));
    let limits = proof::proofs(frames, &budget, choice.drawn, bounds.as_ref());
    let truth = &frames.all[0].truth;
    let percent = |own: u64, base: u64| 100.0 * (1.0 - own as f64 / base.max(1) as f64);
    let saving = |(own, base): (MachineCost, MachineCost)| Saving {
        cells: percent(own.cells, base.cells),
        lut: percent(own.resources.lut, base.resources.lut),
        ff: percent(own.resources.ff, base.resources.ff),
    };
    let mut report = FitReport {
        scenes: frames.all.iter().map(|f| f.name.clone()).collect(),
        width: truth.width,
        height: truth.height,
        unit: emitted.top.clone(),
        machine: description,
        format: choice.drawn.widths,
        widths: widths::print(&choice.drawn.widths),
        slots: slots::print(&description.slots()),
        rows_per_stage: description.rows_per_stage,
        latency: emitted.latency,
        clocks_per_frame: choice.machine.clocks,
        left_out: left_out.names,
        left_out_planes: left_out.planes,
        limits,
        bounds,
        measured: choice.drawn.metrics.clone(),
        target: target.name(),
        cost: choice.cost,
        base_cost,
        saving_percent: choice.cost.zip(base_cost).map(saving),
        cosim,
        command,
        reproduce: options.reproduce(&budget),
        budget,
        files: vec![],
        seconds: started.elapsed().as_secs_f64(),
    };
    let drawn = (choice.drawn, &images[..], &scenes[..]);
    write(&mut report, frames, drawn, &emitted, options)?;
    let summary = contract::summary(&report)?;
    output::report(json, &report, |_| output::text(summary));
    verdict(&report)
}

/// The machine that should be smallest, without its cost and unchecked.
pub fn smallest(options: &Fit) -> Result<MachineDescription> {
    let (frames, _, found) = searched(options)?;
    let drawn = found.first().expect("a machine was found");
    Ok(fitted(&frames, drawn, ROWS[0], options)?.description)
}

/// The words that keep to a budget, those first that should make the smallest machine.
fn found(frames: &Frames, budget: &Budget) -> Result<Vec<Drawn>> {
    let outcome = output::during(0, "machines drawn", |bar| {
        search(frames, budget, || bar.inc(1))
    });
    match outcome? {
        Outcome::Fits(found) => Ok(found),
        Outcome::Unreachable(nearest) => Err(unreachable(&nearest)),
    }
}

/// The frames, what is left out of them, and the words that keep to the budget.
fn searched(options: &Fit) -> Result<(Frames, LeftOut, Vec<Drawn>)> {
    let budget = options.budget();
    budget.check()?;
    if let Some(leave_out) = options.leave_out {
        leave_out.check(&budget)?;
    }
    let mut files: Vec<(String, SceneFile)> = vec![];
    for path in &options.scenes {
        let file = molecules::read_scene(path)?;
        let name = path.display().to_string();
        if file.images.is_empty() {
            let size = size_of(&file, options.size);
            let file = missing::reduced(file, size, Format::BASE, Options::HARDWARE)?;
            files.push((name, file));
        } else {
            files.extend(Playback::new(&file)?.scenes(&name)?);
        }
    }
    if options.leave_out.is_some() {
        // The depth word stands for the same with fewer objects.
        for (_, file) in &mut files {
            let (width, height) = size_of(file, options.size);
            let range = file.frame(width, height)?.range;
            range.put_into(&mut file.camera);
        }
    }
    let mut frames = output::during(0, "lines of the truth", |bar| {
        Frames::new(&files, options.size, options.kind(), || bar.inc(1))
    })?;
    frames.lit_sphere = options.lit_sphere;
    frames.pixels_per_clock = options.pixels_per_clock.unwrap_or(1);
    let Some(leave_out) = options.leave_out else {
        let found = found(&frames, &budget)?;
        return Ok((frames, LeftOut::default(), found));
    };
    let omission = Omission::new(&frames, &files, options.kind(), (leave_out, &budget))?;
    let choices = match leave_out {
        LeaveOut::Below(_) => vec![omission.all().to_vec()],
        LeaveOut::Auto => omission.within(&budget)?,
    };
    let tried = choices.iter().map(|parts| {
        let (frames, left_out) = omission.without(parts)?;
        let found = found(&frames, &budget)?;
        let machine = fitted(&frames, &found[0], ROWS[0], options)?;
        Ok::<_, Failure>((machine, (frames, left_out, found)))
    });
    let smallest = tried.reduce(|least, next| match (&least, &next) {
        (Ok((smallest, _)), Ok((machine, _))) if !machine.is_smaller(smallest) => least,
        (_, Ok(_)) => next,
        _ => least,
    });
    let (_, searched) = smallest.expect("something is tried")?;
    Ok(searched)
}

/// The message of a budget that no machine meets.
fn unreachable(nearest: &Drawn) -> Failure {
    let mut text = String::from("no machine meets the budget; out of reach:");
    for item in nearest.items.iter().filter(|item| !item.holds()) {
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
    frames: &Frames,
    found: &'a [Drawn],
    options: &Fit,
    target: Target,
    json: bool,
) -> Result<Choice<'a>> {
    let rows = options.min_mhz.map_or(&ROWS[..1], |_| &ROWS);
    let synthesised = if options.no_cost { 1 } else { SYNTHESISED };
    let mut candidates: Vec<(&Drawn, Fitted)> = vec![];
    for drawn in found.iter().take(synthesised) {
        let most = drawn.widths.root - drawn.widths.dropped_rows;
        for &rows in rows.iter().filter(|rows| **rows <= most) {
            candidates.push((drawn, fitted(frames, drawn, rows, options)?));
        }
    }
    if !json && !options.no_cost {
        for (drawn, machine) in &candidates {
            output::text(contract::found(drawn, &machine.description));
        }
    }
    let machines = candidates.iter().map(|(_, machine)| &machine.description);
    let machines: Vec<MachineDescription> = machines.cloned().collect();
    let costs = match options.no_cost {
        true => vec![None],
        false => price(&machines, target, options)?
            .into_iter()
            .map(Some)
            .collect(),
    };
    let priced = candidates.into_iter().zip(costs);
    let priced = priced.map(|((drawn, machine), cost)| Choice {
        drawn,
        machine,
        cost,
    });
    cheapest(priced.collect(), options.min_mhz, target)
}

/// The machine of these words.
fn fitted(frames: &Frames, drawn: &Drawn, rows: u32, options: &Fit) -> Result<Fitted> {
    let timing = |machine: &MachineDescription| {
        zone_timing(&request_for(machine, &[], "")).expect("a machine that is within its ranges")
    };
    let machine = machine::machine(frames, drawn, rows, options.pace(), &timing);
    let mut machine = machine.map_err(|error| match error {
        error @ FitError::Slow { .. } => Failure::Check(error.to_string()),
        error => error.into(),
    })?;
    // The words are those of any exact root.
    machine.description.root_form = Target::from_name(&options.target)?.exact_root();
    Ok(machine)
}

fn price(
    machines: &[MachineDescription],
    target: Target,
    options: &Fit,
) -> Result<Vec<MachineCost>> {
    let with_clock = options.clock || options.min_mhz.is_some();
    costs(&emitted(machines)?, Parts::Cores, target, with_clock)
}

fn cheapest(priced: Vec<Choice<'_>>, min_mhz: Option<f64>, target: Target) -> Result<Choice<'_>> {
    let clock = |choice: &Choice| choice.cost.and_then(|cost| cost.fmax_mhz);
    let fast = |choice: &Choice| min_mhz.is_none_or(|least| clock(choice) >= Some(least));
    let fastest = priced.iter().filter_map(clock).reduce(f64::max);
    let cheapest = priced.into_iter().filter(fast);
    let cheapest =
        cheapest.min_by_key(|choice| choice.cost.map(|cost| (cost.cells, cost.resources.ff)));
    cheapest.ok_or_else(|| {
        let why = match fastest {
            Some(mhz) => format!(
                "the slowest unit of the fastest machine that meets the budget runs at {mhz:.1} MHz"
            ),
            None => "one of the units of each machine that meets the budget does not fit it".into(),
        };
        let (least, target) = (min_mhz.unwrap_or_default(), target.name());
        Failure::Check(format!("no machine reaches {least} MHz on {target}: {why}"))
    })
}

/// What the machine shows of every frame, and that compared with the pins on every clock.
fn show(choice: &Choice, frames: &Frames, options: &Fit) -> Result<(Vec<Image>, Vec<Report>)> {
    let machine = &choice.machine.description;
    let scenes = frames.all.iter().zip(&choice.drawn.prepared);
    let images = scenes.map(|(frame, prepared)| image(&frame.scene, prepared, machine));
    let images: Vec<Image> = images.collect::<Result<_, _>>()?;
    check_tables(&images)
        .map_err(|error| Failure::Input(format!("{}: {error}", frames.all[error.image].name)))?;
    let Some(engine) = options.engine else {
        return Ok((images, vec![]));
    };
    let run = PinsRun::plain(engine);
    let steps = images.len() as u64 + 1;
    let outcome = output::during(steps, "frames on the pins", |bar| {
        run_pins(machine, &images, &run, || bar.inc(1))
    })?;
    Ok((images, vec![outcome.report]))
}

/// Machine, Verilog, contract, report, and of every frame the picture and the map of its errors.
fn write(
    report: &mut FitReport,
    frames: &Frames,
    (drawn, images, scenes): (&Drawn, &[Image], &[(PathBuf, SceneFile)]),
    emitted: &Emitted,
    options: &Fit,
) -> Result {
    let mut files = output::files();
    let machine = report.machine.to_toml();
    let description = format!("# Made by: {}\n{machine}", report.reproduce);
    files.add_text(&options.out.join(MACHINE_FILE), &description)?;
    add_verilog(&mut files, emitted, &options.out, false)?;
    for (path, scene) in scenes {
        files.add_text(path, &scene.to_toml()?)?;
    }
    let each = frames.all.iter().zip(&drawn.prepared).zip(images);
    for (index, ((frame, prepared), image)) in each.enumerate() {
        let errors = frame.errors(prepared)?;
        for (name, picture) in [("golden", &image.picture), ("errors", &errors)] {
            let path = frame_file(options, frames, name, index, "png");
            let size = [frame.truth.width, frame.truth.height];
            output::add_picture(&mut files, &path, size, picture)?;
        }
    }
    let page = contract::page(report, emitted)?;
    files.add_text(&options.out.join("contract.md"), &page)?;
    let figures = options.out.join("fit.json");
    report.files = files.paths();
    report.files.push(figures.clone());
    files.add_text(&figures, &output::json_text(report))?;
    files.finish()?;
    Ok(())
}

/// The file of a frame, with its number where there are several.
fn frame_file(options: &Fit, frames: &Frames, name: &str, index: usize, end: &str) -> PathBuf {
    let number = match frames.all.len() {
        1 => String::new(),
        _ => format!("-{index}"),
    };
    options.out.join(format!("{name}{number}.{end}"))
}

fn verdict(report: &FitReport) -> Result {
    let mismatches: u64 = report.cosim.iter().map(|r| r.mismatches).sum();
    Failure::unless(mismatches == 0, || {
        let (differences, command) = (counted(mismatches, "difference"), &report.reproduce);
        format!(
            "{differences} between the fitted hardware and the golden model; please report the command: {command}"
        )
    })
}
