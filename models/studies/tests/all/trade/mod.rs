//! The design space of a scene: the same results in whatever order and however often it is interrupted.

mod design;
mod report;
mod run;
mod shrink;
mod view;

use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_plan::description::MachineDescription;
use imogene_plan::pace::Timing;
use imogene_plan::zone::clocks::ZoneTiming;
use imogene_prepare::{Framing, prepare};
use imogene_scene::SceneFile;
use imogene_studies::kit::words::drawn;
use imogene_studies::trade::design::{Accuracy, Design, Space};
use imogene_studies::trade::measure::measure;
use imogene_studies::trade::page::page;
use imogene_studies::trade::plot::draw;
use imogene_studies::trade::point::{Cost, CostsOf, Pricing};
use imogene_studies::trade::report::{Entry, FRONTS, Trade};
use imogene_studies::trade::run::{Request, Shard, run, run_shard};
use imogene_studies::trade::speed;
use imogene_studies::trade::view::Views;
use imogene_testkit::scene_file;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Costs that are a sum of widths, so that every machine has one of its own; estimates are a hundredth more.
fn sums(machines: &[MachineDescription], pricing: Pricing) -> Result<Vec<Cost>, String> {
    let cost = |machine| sum(machine, pricing);
    Ok(machines.iter().map(cost).collect())
}

fn sum(machine: &MachineDescription, pricing: Pricing) -> Cost {
    let is_estimated = matches!(pricing, Pricing::Estimated(_));
    let scale = if is_estimated { 101 } else { 100 };
    let w = machine.words();
    let bits = u64::from(w.depth + 2 * w.root + w.normal + w.guard_linear + w.guard_quadratic);
    let clock = 200.0 / f64::from(machine.rows_per_stage);
    Cost {
        lut: bits,
        ff: bits * 2,
        dsp: 0,
        bram: 0,
        cells: scale * (bits * 3 * machine.objects as u64 + u64::from(machine.rows_per_stage)),
        fmax_mhz: matches!(pricing, Pricing::Routed).then_some(clock),
        is_estimated,
    }
}

/// A machine that takes a clock for each pixel and each word, and some clocks of latency.
const TIMING: Timing = Timing {
    latency: 50,
    zone: ZoneTiming {
        draw_drain: 30,
        light_drain: 30,
        show_drain: 2,
        settle: 30,
        command: 1,
    },
};

struct Run<'a> {
    out: &'a Path,
    file: SceneFile,
    size: (u32, u32),
    program: &'a str,
    costs: CostsOf<'a>,
    with_clock: bool,
    designs: Vec<Design>,
}

impl<'a> Run<'a> {
    fn new(out: &'a Path) -> Run<'a> {
        Run {
            out,
            file: scene_file("cut-sphere"),
            size: (48, 36),
            program: "one",
            costs: &sums,
            with_clock: true,
            designs: Space::Quick.designs(48),
        }
    }

    fn with<T>(&self, act: impl FnOnce(&Request) -> T) -> T {
        act(&Request {
            file: &self.file,
            name: "cut-sphere.toml",
            size: self.size,
            target: "ecp5-45k",
            designs: self.designs.clone(),
            out: self.out,
            version: "0",
            program: self.program,
            costs: self.costs,
            with_clock: self.with_clock,
            timing: &|_| TIMING,
            done: &|_| (),
        })
    }

    fn trade(&self) -> Trade {
        self.with(run).unwrap()
    }

    /// The results without the folder that the commands name.
    fn text(&self) -> String {
        let text = serde_json::to_string_pretty(&self.trade()).unwrap();
        text.replace(&self.out.display().to_string(), "OUT")
    }
}

fn point_files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder.join("points")).unwrap();
    let mut files: Vec<PathBuf> = entries.map(|e| e.unwrap().path()).collect();
    files.sort();
    files
}

#[test]
fn an_interrupted_run_goes_on_to_the_same_results() {
    let folder = tempfile::tempdir().unwrap();
    let asked = AtomicU64::new(0);
    let counted = |machines: &[MachineDescription], pricing: Pricing| {
        asked.fetch_add(machines.len() as u64, Ordering::Relaxed);
        sums(machines, pricing)
    };
    let whole = Run {
        costs: &counted,
        with_clock: false,
        ..Run::new(folder.path())
    };
    let first = whole.text();
    let all = whole.designs.len() as u64;
    assert!(asked.swap(0, Ordering::Relaxed) >= all);
    // Nothing is left to do.
    assert_eq!(whole.text(), first);
    assert_eq!(asked.swap(0, Ordering::Relaxed), 0);
    // Half of the points, a picture and a map are lost.
    let files = point_files(folder.path());
    assert_eq!(files.len() as u64, all);
    for file in files.iter().step_by(2) {
        std::fs::remove_file(file).unwrap();
    }
    std::fs::remove_file(folder.path().join("maps/w24-n16-g0.0-d0.png")).unwrap();
    std::fs::remove_dir_all(folder.path().join("pictures")).unwrap();
    assert_eq!(whole.text(), first);
    assert!(asked.load(Ordering::Relaxed) > 0);
    // Half-written rubbish, and a point of another name.
    std::fs::write(&files[0], "{").unwrap();
    std::fs::copy(&files[2], &files[1]).unwrap();
    assert_eq!(whole.text(), first);
    // Another folder, in parts.
    let other = tempfile::tempdir().unwrap();
    let parts = Run {
        with_clock: false,
        ..Run::new(other.path())
    };
    let shard = |number| parts.with(|r| run_shard(r, Shard { number, of: 3 }).unwrap());
    assert_eq!([3, 1, 2].map(shard).iter().sum::<usize>() as u64, all);
    // All is measured, and has no cost yet.
    assert_eq!(point_files(other.path()).len() as u64, all);
    assert_eq!(parts.text(), first);
}

#[test]
fn results_of_another_run_are_not_taken() {
    let folder = tempfile::tempdir().unwrap();
    let fresh = |change: fn(&mut Run)| {
        let other = tempfile::tempdir().unwrap();
        let mut run = Run::new(other.path());
        change(&mut run);
        run.text()
    };
    let changes: [fn(&mut Run); 3] = [
        |run| run.size = (40, 30),
        |run| run.file = scene_file("cone"),
        |run| run.program = "two",
    ];
    for change in changes {
        Run::new(folder.path()).text();
        let stamp = |path: &PathBuf| std::fs::read(path).unwrap();
        let before: Vec<Vec<u8>> = point_files(folder.path()).iter().map(stamp).collect();
        let mut run = Run::new(folder.path());
        change(&mut run);
        assert_eq!(run.text(), fresh(change));
        let after = point_files(folder.path());
        assert!(before.iter().zip(&after).all(|(b, a)| *b != stamp(a)));
    }
}

#[test]
fn a_cost_that_was_not_to_be_had_is_asked_for_again() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |_: &[MachineDescription], _: Pricing| Err("no tools: install them".to_owned());
    let without = Run {
        costs: &refused,
        ..Run::new(folder.path())
    };
    let trade = without.trade();
    assert_eq!(trade.measure, "toggles");
    for entry in &trade.points {
        assert_eq!(entry.point.cost, None);
        let refused = entry.point.cost_refused.as_deref();
        assert_eq!(refused, Some("no tools: install them"));
    }
    // Then without clocks, which are estimated, and with those of the front.
    let estimated = Run {
        with_clock: false,
        ..Run::new(folder.path())
    };
    let trade = estimated.trade();
    assert_eq!((trade.measure, trade.clock_error), ("cells", None));
    for entry in &trade.points {
        assert!(entry.point.mhz.is_some() && entry.point.mhz == entry.point.mhz_estimated);
    }
    let trade = Run::new(folder.path()).trade();
    let routed = |e: &&Entry| e.point.cost.is_some_and(|cost| cost.fmax_mhz.is_some());
    for entry in trade.points.iter().filter(|e| e.pareto.contains(&"speed")) {
        assert!(routed(&entry) && !entry.point.cost.unwrap().is_estimated);
    }
    let is_estimated = |e: &&Entry| e.point.cost.unwrap().is_estimated;
    let estimated: Vec<&Entry> = trade.points.iter().filter(is_estimated).collect();
    assert!(!estimated.is_empty());
    for entry in estimated {
        assert_eq!(entry.point.cost, entry.point.cost_estimated);
    }
    let error = trade.clock_error.unwrap();
    let routed: Vec<&Entry> = trade.points.iter().filter(routed).collect();
    assert_eq!(error.points, routed.len());
    assert!(routed.len() < trade.points.len());
    for entry in routed {
        let clock = entry.point.cost.unwrap().fmax_mhz.unwrap();
        assert_eq!(entry.point.mhz, Some(clock));
        let off = 100.0 * (entry.point.mhz_estimated.unwrap() / clock - 1.0).abs();
        assert!(off <= error.max_percent + 1e-9);
    }
}

#[test]
fn points_tell_speed_area_and_accuracy() {
    let folder = tempfile::tempdir().unwrap();
    let run = Run::new(folder.path());
    let trade = run.trade();
    let of = |id: &str| {
        let found = trade.points.iter().find(|e| e.point.id == id);
        found.unwrap_or_else(|| panic!("no {id}"))
    };
    let (narrow, wide) = (of("w10-n16-g0.0-d0-r1"), of("w24-n16-g0.0-d0-r1"));
    let error = |e: &Entry| e.point.errors.clone().unwrap();
    assert!(error(narrow).depth_px.max > 10.0 * error(wide).depth_px.max);
    assert!(wide.silhouette_exact && wide.pareto.contains(&"depth"));
    // No wider than the scene requires.
    assert!(wide.point.format.unwrap().root < 24 && wide.point.format.unwrap().plane < 36);
    // More rows a stage: the same picture and file.
    let two = of("w24-n16-g0.0-d0-r2");
    let shown = |e: &Entry| (e.point.errors.clone(), e.point.picture.clone());
    assert_eq!(shown(two), shown(wide));
    for entry in &trade.points {
        let point = &entry.point;
        let frames = 1e6 * point.mhz.unwrap() / point.clocks_per_frame.unwrap() as f64;
        assert_eq!(point.frames_per_second, Some(frames));
    }
    // A preview of a quarter of the pixels is faster and worse, four samples a pixel slower and better.
    let pixels = |e: &Entry| e.point.clocks_per_frame.unwrap() as f64 / (48.0 * 36.0);
    let picture = |e: &Entry| e.point.picture_error.unwrap();
    let [preview, once, samples] = [
        "w16-n16-g0.0-d0-p2-r1",
        "w16-n16-g0.0-d0-r1",
        "w16-n16-g0.0-d0-s2-z16k2-r1",
    ]
    .map(of);
    assert!(pixels(preview) > 0.25 && pixels(preview) < pixels(once) && pixels(samples) > 4.0);
    assert!(picture(preview) > 1.2 * picture(once) && picture(once) > 1.2 * picture(samples));
    // A zone machine of one processor draws the same picture with less.
    let zones = of("w16-n16-g0.0-d0-z16k1-r1");
    assert_eq!(zones.point.errors, once.point.errors);
    assert!(zones.point.clocks_per_frame > once.point.clocks_per_frame);
    assert!(zones.point.cost.unwrap().cells < once.point.cost.unwrap().cells);
    // One line of the table for each point, and a mark in each plot.
    let csv = trade.csv();
    assert_eq!(csv.lines().count(), 1 + trade.points.len());
    let columns = csv.lines().next().unwrap().split(',').count();
    assert_eq!(columns, 60);
    let fronts = FRONTS.iter().map(|front| draw(&trade, front).unwrap());
    for plot in fronts {
        for entry in &trade.points {
            let mark = format!("<circle data-point=\"{}\" ", entry.point.id);
            assert_eq!(plot.matches(&mark).count(), 1, "{mark}");
        }
    }
    let plot = speed::draw(&trade).unwrap();
    for entry in trade.points.iter().filter(|e| e.class.is_some()) {
        assert!(plot.contains(&format!("data-point=\"{}\"", entry.point.id)));
    }
    let page = page(&trade, folder.path()).unwrap();
    let bytes = page.len();
    assert!((50_000..3_000_000).contains(&bytes), "{bytes}");
}

#[test]
fn refusals_are_recorded() {
    let folder = tempfile::tempdir().unwrap();
    let run = Run {
        file: scene_file("extremes/eye-on-quadric"),
        ..Run::new(folder.path())
    };
    let trade = run.trade();
    let on_quadric = "the viewer lies exactly on this quadric";
    for entry in &trade.points {
        let problem = entry.point.refused.as_ref().unwrap();
        assert!(problem.contains(on_quadric), "{problem}");
        assert!(entry.point.errors.is_none() && entry.pareto.is_empty());
    }
    assert!(page(&trade, folder.path()).unwrap().contains(on_quadric));
}

#[test]
fn scenes_of_other_processors_are_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let run_of = Run {
        file: scene_file("processors/mesh"),
        ..Run::new(folder.path())
    };
    let error = run_of.with(run).unwrap_err();
    let error = error.to_string();
    assert!(
        error.contains("drawn by the processor \"facet\""),
        "{error}"
    );
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// The narrowest words that the preparation accepts: one bit less of the root is refused.
#[test]
fn words_are_as_narrow_as_the_scene_allows() {
    let file = scene_file("teapot");
    let views = Views::new(&file, (80, 60)).unwrap();
    let scene = file.frame(80, 60).unwrap();
    let measured = measure(&views, &Accuracy::of_depth(20)).unwrap();
    let widths = measured.widths;
    let narrower = MachineWords {
        root: widths.root - 1,
        ..widths
    };
    let format = Format::fitted(&narrower).unwrap();
    assert!(prepare(&scene, format).is_err());
    assert!(prepare(&scene, Format::fitted(&widths).unwrap()).is_ok());
    // And it draws what wide words draw.
    let wide = Format::new(20).unwrap();
    let wide = prepare(&scene, wide).unwrap();
    assert_eq!(drawn(&scene, &wide, None).unwrap().rgb, measured.rgb);
}
