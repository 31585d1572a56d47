//! The design space of a scene: the same results in whatever order and however often it is interrupted.

use imogene_analysis::metrics::{Drawing, Truth};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::machine::fitted::FittedMachine;
use imogene_prepare::Framing;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{Options, prepare, prepare_with};
use imogene_scene::SceneFile;
use imogene_studies::trade::TradeError;
use imogene_studies::trade::design::{Accuracy, Design, Space};
use imogene_studies::trade::measure::{measure, zones};
use imogene_studies::trade::page::page;
use imogene_studies::trade::plot::draw;
use imogene_studies::trade::point::{Cost, CostsOf};
use imogene_studies::trade::report::{FRONTS, Trade};
use imogene_studies::trade::run::{Request, Shard, run, run_shard};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

fn scene(name: &str) -> SceneFile {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    SceneFile::read(&folder.join(name)).unwrap()
}

/// Costs that are a sum of widths, so that every machine has one of its own.
fn sums(machines: &[FittedMachine]) -> Result<Vec<Cost>, String> {
    Ok(machines.iter().map(sum).collect())
}

fn sum(machine: &FittedMachine) -> Cost {
    let w = machine.widths;
    let bits = u64::from(w.depth + 2 * w.root + w.normal + w.guard_linear + w.guard_quadratic);
    Cost {
        lut: bits,
        ff: bits * 2,
        dsp: 0,
        cells: bits * 3 + u64::from(machine.rows_per_stage),
        fmax_mhz: Some(200.0 / f64::from(machine.rows_per_stage)),
    }
}

struct Run<'a> {
    out: &'a Path,
    file: SceneFile,
    size: (u32, u32),
    program: &'a str,
    costs: CostsOf<'a>,
    designs: Vec<Design>,
}

impl<'a> Run<'a> {
    fn new(out: &'a Path) -> Run<'a> {
        Run {
            out,
            file: scene("cut-sphere.toml"),
            size: (48, 36),
            program: "one",
            costs: &sums,
            designs: Space::Quick.designs(),
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
            with_clock: true,
            done: &|_| (),
        })
    }

    fn trade(&self) -> Trade {
        self.with(run).unwrap()
    }

    fn text(&self) -> String {
        serde_json::to_string_pretty(&self.trade()).unwrap()
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
    let counted = |machines: &[FittedMachine]| {
        asked.fetch_add(machines.len() as u64, Ordering::Relaxed);
        sums(machines)
    };
    let whole = Run {
        costs: &counted,
        ..Run::new(folder.path())
    };
    let first = whole.text();
    let all = whole.designs.len() as u64;
    assert_eq!(asked.swap(0, Ordering::Relaxed), all);
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
    let parts = Run::new(other.path());
    let points: usize = [3, 1, 2]
        .map(|number| parts.with(|r| run_shard(r, Shard { number, of: 3 }).unwrap()))
        .iter()
        .sum();
    assert_eq!(points as u64, all);
    // All is measured, and has no cost yet.
    assert_eq!(point_files(other.path()).len() as u64, all);
    let rest = Run::new(other.path());
    assert_eq!(rest.text(), first);
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
        |run| run.file = scene("cone.toml"),
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
    let refused = |_: &[FittedMachine]| Err("no tools: install them".to_owned());
    let without = Run {
        costs: &refused,
        ..Run::new(folder.path())
    };
    let trade = without.trade();
    assert_eq!(trade.measure, "toggles");
    for entry in &trade.points {
        assert_eq!(
            (entry.point.cost, entry.point.pixels_per_second),
            (None, None)
        );
        assert_eq!(
            entry.point.cost_refused.as_deref(),
            Some("no tools: install them")
        );
    }
    // Then without a clock, and with one.
    let other = tempfile::tempdir().unwrap();
    let slow = |machines: &[FittedMachine]| {
        let without = |cost: Cost| Cost {
            fmax_mhz: None,
            ..cost
        };
        Ok(machines.iter().map(sum).map(without).collect())
    };
    let without_clock = Run {
        costs: &slow,
        ..Run::new(folder.path())
    };
    let trade = without_clock.trade();
    assert_eq!(trade.measure, "cells");
    assert!(
        trade
            .points
            .iter()
            .all(|e| e.point.pixels_per_second.is_none())
    );
    let with = Run::new(folder.path()).text();
    assert_eq!(with, Run::new(other.path()).text());
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
    let error = |e: &imogene_studies::trade::report::Entry| e.point.errors.clone().unwrap();
    assert!(error(narrow).depth_px.max > 10.0 * error(wide).depth_px.max);
    assert!(wide.silhouette_exact && wide.pareto.contains(&"depth"));
    // No wider than the scene requires.
    assert!(wide.point.format.unwrap().root < 24 && wide.point.format.unwrap().plane < 36);
    // More rows a stage: the same picture and file, fewer clocks of latency, half the clock rate.
    let two = of("w24-n16-g0.0-d0-r2");
    assert_eq!(
        (&two.point.errors, &two.point.picture),
        (&wide.point.errors, &wide.point.picture)
    );
    assert!(two.point.latency < wide.point.latency);
    let clocks = two.point.clocks_per_frame.unwrap();
    assert_eq!(clocks, 48 * 36 + u64::from(two.point.latency.unwrap()));
    let speed = 100e6 * 48.0 * 36.0 / clocks as f64;
    assert_eq!(two.point.pixels_per_second, Some(speed));
    // One line of the table for each point, and a mark in each plot.
    let csv = trade.csv();
    assert_eq!(csv.lines().count(), 1 + trade.points.len());
    let columns = csv.lines().next().unwrap().split(',').count();
    assert_eq!(columns, 46);
    for front in &FRONTS {
        let plot = draw(&trade, front).unwrap();
        for entry in &trade.points {
            let mark = format!("<circle data-point=\"{}\" ", entry.point.id);
            assert_eq!(plot.matches(&mark).count(), 1, "{mark}");
        }
    }
    let page = page(&trade, folder.path()).unwrap();
    assert!(
        page.len() > 50_000 && page.len() < 3_000_000,
        "{}",
        page.len()
    );
}

#[test]
fn refusals_are_recorded() {
    let folder = tempfile::tempdir().unwrap();
    let run = Run {
        file: scene("extremes/eye-on-quadric.toml"),
        ..Run::new(folder.path())
    };
    let trade = run.trade();
    for entry in &trade.points {
        let problem = entry.point.refused.as_ref().unwrap();
        assert!(
            problem.contains("the viewer lies exactly on this quadric"),
            "{problem}"
        );
        assert!(entry.point.errors.is_none() && entry.pareto.is_empty());
    }
    assert!(
        page(&trade, folder.path())
            .unwrap()
            .contains("lies exactly on this quadric")
    );
}

#[test]
fn scenes_of_other_processors_are_refused_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let run_of = Run {
        file: scene("processors/mesh.toml"),
        ..Run::new(folder.path())
    };
    let error = run_of.with(run).unwrap_err();
    assert!(
        matches!(
            error,
            TradeError::Processor {
                processor: "facet",
                ..
            }
        ),
        "{error}"
    );
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

/// Zones whose words are rounded about a pixel outside them still draw their part of the picture of these words.
#[test]
fn zones_draw_their_part_of_the_screen() {
    let scene = scene("cut-sphere.toml").frame(60, 45).unwrap();
    let format = Format::new(16).unwrap();
    let drawing = Drawing::in_zones(&zones(&scene, format, 16).unwrap(), &scene);
    for (x, y) in [(0, 0), (16, 16), (32, 16), (48, 32)] {
        let (width, height) = (16.min(60 - x), 16.min(45 - y));
        let anchor = Anchor {
            x: (x + width / 2) as i64,
            y: (y + height / 2) as i64,
        };
        let options = Options {
            anchor: Some(anchor),
            ..Options::ROOTS
        };
        let whole = Drawing::of(&prepare_with(&scene, format, options).unwrap(), &scene);
        for index in (y..y + height).flat_map(|v| (x..x + width).map(move |u| v * 60 + u)) {
            assert_eq!(drawing.frame.depth[index], whole.frame.depth[index]);
            assert_eq!(drawing.frame.id[index], whole.frame.id[index]);
            assert_eq!(drawing.frame.normal[index], whole.frame.normal[index]);
            assert_eq!(drawing.backs[index], whole.backs[index]);
        }
    }
    assert_eq!(
        Drawing::in_zones(&zones(&scene, format, 0).unwrap(), &scene),
        Drawing::of(&prepare(&scene, format).unwrap(), &scene)
    );
}

/// Zones cost the latency and the words of all slots again for each of them.
#[test]
fn zones_cost_clocks() {
    let scene = scene("cut-sphere.toml").frame(60, 45).unwrap();
    let truth = Truth::new(&scene, || ());
    let of = |zone| {
        let accuracy = Accuracy {
            zone,
            ..Accuracy::of_depth(20)
        };
        measure(&scene, &truth, &accuracy).unwrap()
    };
    let (whole, zoned) = (of(0), of(16));
    let (one, other) = (whole.machine(1), zoned.machine(1));
    assert_eq!(
        whole.clocks_per_frame(&one),
        60 * 45 + u64::from(whole.latency(&one))
    );
    let words: u64 = other
        .slots
        .iter()
        .map(|s| 24 + 7 * u64::from(s.planes))
        .sum();
    let each = words + u64::from(zoned.latency(&other));
    assert_eq!(zoned.clocks_per_frame(&other), 60 * 45 + 4 * 3 * each);
    assert!(zoned.toggles(1).total > 0.0);
}

/// The narrowest words that the preparation accepts: one bit less of the root is refused.
#[test]
fn words_are_as_narrow_as_the_scene_allows() {
    let scene = scene("teapot.toml").frame(80, 60).unwrap();
    let truth = Truth::new(&scene, || ());
    let measured = measure(&scene, &truth, &Accuracy::of_depth(20)).unwrap();
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
    let drawing = Drawing::of(&prepare(&scene, wide).unwrap(), &scene);
    assert_eq!(drawing.rgb, measured.rgb);
}
