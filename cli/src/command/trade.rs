//! `imogene trade`.

use super::{fitted, size_of};
use crate::arguments::{Trade, TradeEngine};
use crate::failure::{Failure, Result};
use crate::{missing, molecules, output};
use imogene_files::text::counted;
use imogene_golden::format::Format;
use imogene_plan::description::MachineDescription;
use imogene_prepare::Options;
use imogene_studies::picture;
use imogene_studies::sheet::Sheet;
use imogene_studies::trade::design::Space;
use imogene_studies::trade::page::page;
use imogene_studies::trade::plot;
use imogene_studies::trade::point::{Cost, Point, Pricing};
use imogene_studies::trade::report::{self, FRONTS};
use imogene_studies::trade::run::{self, Request};
use imogene_studies::trade::speed;
use imogene_synth::Target;
use imogene_synth::fitted::{MachineCost, Parts};
use imogene_tools::{call, find, own_folders};
use imogene_verif::display::request::{request_for, timing};
use serde_json::json;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

pub fn run(options: &Trade, json: bool) -> Result {
    let started = Instant::now();
    let file = molecules::read_scene(&options.scene)?;
    let size = size_of(&file, options.size);
    let file = missing::reduced(file, size, Format::BASE, Options::ROOTS)?;
    let target = Target::from_name(&options.target)?;
    let designs = options.points.designs(size.0);
    let bar = output::progress(designs.len() as u64, "points");
    let version = env!("CARGO_PKG_VERSION");
    // What tells this program from any other: results of another one are measured again.
    let bytes = std::env::current_exe().and_then(std::fs::read);
    let unread = |error| Failure::Input(format!("cannot read the program itself: {error}"));
    let asked = Request {
        file: &file,
        name: &options.scene.display().to_string(),
        size,
        target: target.name(),
        designs,
        out: &options.out,
        version,
        program: &format!("{version} {}", run::digest(bytes.map_err(unread)?)),
        costs: &|machines, pricing| costs(machines, target, pricing, options),
        with_clock: options.clock,
        timing: &|machine| {
            timing(&request_for(machine, &[], "")).expect("a machine that is within its ranges")
        },
        done: &|points| {
            bar.inc(points);
            if Some(bar.position()) == bar.length() {
                bar.finish_and_clear();
            }
        },
    };
    if let Some(shard) = options.shard {
        let points = run::run_shard(&asked, shard)?;
        bar.finish_and_clear();
        output::report(json, &json!({ "points": points, "files": [] }), |_| {
            let measured = counted(points, "point");
            output::text(format!("part {} of {}: {measured}", shard.number, shard.of));
        });
        return Ok(());
    }
    if options.engine == TradeEngine::Hq {
        run::check(&asked)?;
        run_in_parts(options)?;
    }
    let trade = run::run(&asked)?;
    bar.finish_and_clear();
    let files = write(&trade, &options.out, options.points)?;
    let seconds = started.elapsed().as_secs_f64();
    let count =
        |wanted: fn(&report::Entry) -> bool| trade.points.iter().filter(|e| wanted(e)).count();
    let summary = json!({
        "points": trade.points.len(),
        "refused": count(|e| e.point.refused.is_some()),
        "silhouette_exact": count(|e| e.silhouette_exact),
        "without_cost": count(|e| e.point.cost.is_none()),
        "seconds": seconds,
        "files": files,
    });
    output::report(json, &summary, |_| {
        tell(&trade, seconds);
        output::wrote(&files);
    });
    let points = trade.points.iter();
    let refusals = points.map(|entry| entry.point.refused.as_ref());
    match refusals.collect::<Option<Vec<&String>>>() {
        Some(refusals) => Err(Failure::Check(format!(
            "no machine of the design space draws {}; {} says: {}",
            options.scene.display(),
            trade.points.last().map_or("none", |e| e.point.id.as_str()),
            refusals.last().map_or("nothing", |why| why.as_str())
        ))),
        None => Ok(()),
    }
}

fn costs(
    machines: &[MachineDescription],
    target: Target,
    pricing: Pricing,
    options: &Trade,
) -> Result<Vec<Cost>, String> {
    if options.no_cost {
        return Err("not asked for; run the command again without --no-cost".into());
    }
    let costs = match pricing {
        Pricing::Estimated(known) => fitted::estimates(known, machines, target),
        Pricing::Synthesised | Pricing::Routed => fitted::emitted(machines).and_then(|machines| {
            let with_clock = matches!(pricing, Pricing::Routed);
            fitted::costs(&machines, Parts::Units, target, with_clock)
        }),
    };
    let costs = costs.map_err(|failure| failure.message().unwrap_or_default())?;
    let cost = |c: &MachineCost| Cost {
        lut: c.resources.lut,
        ff: c.resources.ff,
        dsp: c.resources.dsp,
        bram: c.resources.bram,
        cells: c.cells,
        fmax_mhz: c.fmax_mhz,
        is_estimated: matches!(pricing, Pricing::Estimated(_)),
    };
    Ok(costs.iter().map(cost).collect())
}

fn write(trade: &report::Trade, folder: &Path, points: Space) -> Result<Vec<PathBuf>> {
    let mut files = output::files();
    let mut put = |name: &str, text: String| files.add_text(&folder.join(name), &text);
    put("trade.json", output::json_text(trade) + "\n")?;
    put("trade.csv", trade.csv())?;
    put("plots/speed.svg", speed::draw(trade)?)?;
    for front in &FRONTS {
        let picture = plot::draw(trade, front)?;
        put(&format!("plots/{}.svg", front.name), picture)?;
    }
    put("index.html", page(trade, folder)?)?;
    if points == Space::Roots {
        let sheet = sheet(trade, folder)?;
        let path = folder.join("plots/pictures.png");
        let size = [sheet.width, sheet.height];
        output::add_picture(&mut files, &path, size, &sheet.rgb)?;
    }
    Ok(files.finish()?)
}

/// Pictures of a band of the sheet.
const BAND: usize = 6;

/// The pictures of the points of the first depth word, with the maps of their errors, in the order of the points.
fn sheet(trade: &report::Trade, folder: &Path) -> Result<Sheet> {
    let read = |file: &String| {
        let path = folder.join(file);
        let picture = picture::read_png(&path).map(|(_, rgb)| rgb);
        picture.map_err(Failure::in_file(&path))
    };
    let points = trade.points.iter().map(|entry| &entry.point);
    let depth = |point: &Point| point.design.accuracy.depth;
    let first = points.clone().next().map(depth);
    let files = points.filter(|point| Some(depth(point)) == first);
    let files = files.filter_map(|point| Some([point.picture.as_ref()?, point.map.as_ref()?]));
    let pair = |[picture, map]: [&String; 2]| Ok([read(picture)?, read(map)?]);
    let pairs: Vec<[Vec<u8>; 2]> = files.map(pair).collect::<Result<_>>()?;
    let size = (trade.width as usize, trade.height as usize);
    Ok(Sheet::of(&pairs, size, BAND))
}

fn tell(trade: &report::Trade, seconds: f64) {
    let (title, width, height) = (&trade.title, trade.width, trade.height);
    let points = counted(trade.points.len(), "point");
    output::text(format!(
        "{title}: {points} at {width} x {height} pixels in {seconds:.1} s"
    ));
    let exact = trade.points.iter().filter(|e| e.silhouette_exact);
    let refused = trade.points.iter().filter(|e| e.point.refused.is_some());
    output::text(format!(
        "  {} without a silhouette error, {} that the scene does not fit",
        exact.count(),
        refused.count()
    ));
    let mut points = trade.points.iter();
    if let Some(problem) = points.find_map(|e| e.point.cost_refused.as_ref()) {
        output::text(format!("  no cost of some points: {problem}"));
    }
}

/// What submits the jobs: HyperQueue's own Python interface.
const DRIVER: &str = include_str!("trade/hyperqueue.py");
/// Parts of each worker: what is lost with a part is measured again.
const PARTS: usize = 4;

/// Runs all parts of the points, each by this program as a job of a HyperQueue server.
fn run_in_parts(options: &Trade) -> Result {
    let program = std::env::current_exe()?;
    let mut command = vec![
        program.display().to_string(),
        "trade".into(),
        options.scene.display().to_string(),
        "--out".into(),
        options.out.display().to_string(),
        "--target".into(),
        options.target.clone(),
        "--points".into(),
        options.points().into(),
    ];
    if let Some((width, height)) = options.size {
        command.extend(["--size".into(), format!("{width}x{height}")]);
    }
    let request = json!({
        "command": command,
        "parts": PARTS * usize::from(options.workers),
        "workers": options.workers,
        "server": options.server,
    });
    // The Python of the folder of tools, which `IMOGENE_TOOLS` may name, or the system's.
    let python = find(&own_folders(), &["python"]).unwrap_or_else(|| "python3".into());
    let said = call(Command::new(python).args(["-c", DRIVER, &request.to_string()]))
        .map_err(|error| Failure::Input(format!("cannot run Python: {error}; {HOW}")))?;
    if said.succeeded() {
        return Ok(());
    }
    let said = said.errors;
    if said.contains("No module named 'hyperqueue'") {
        return Err(Failure::Input(format!(
            "HyperQueue is not installed; {HOW}"
        )));
    }
    let last = said.trim().lines().last().unwrap_or("it says nothing");
    Err(Failure::Input(format!(
        "the points in parts: {last}; run the command again, it goes on where it stopped"
    )))
}

const HOW: &str = "scripts/setup --parts installs it in target/tools";
