//! `imogene fit` and machines of any widths on the command line.

use crate::common::{Place, columns, is_full, repository, rows};
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Search, Verilog and pins on a real scene; in the full run with the costs of both machines, whose shading processor
/// takes a minute of synthesis.
#[test]
fn a_scene_is_fitted_emitted_and_compared() {
    let place = Place::new();
    let costs = if is_full() { "" } else { "--no-cost" };
    let limits = "--max-depth-error 0.5px --max-silhouette-errors 0";
    let fit = format!("fit scenes/cut-sphere.toml --size 48x36 {limits} --out fit {costs}");
    let report = place.json(&fit);
    for limit in report["limits"].as_array().unwrap() {
        let (measured, allowed) = (limit["measured"].as_f64(), limit["allowed"].as_f64());
        assert!(measured <= allowed, "{limit}");
    }
    assert_eq!(report["cosim"][0]["mismatches"], 0);
    // Every pin on every clock of a frame.
    assert_eq!(report["cosim"][0]["pixels"], 48 * 36);
    if is_full() {
        assert!(report["cost"]["lut"].as_u64() < report["base_cost"]["lut"].as_u64());
        assert!(report["saving_percent"]["lut"].as_f64().unwrap() > 0.0);
    }
    for file in ["machine.toml", "fit.json", "errors.png"] {
        assert!(place.has(&format!("fit/{file}")), "{file}");
    }
    // The command that it names shows the same on the pins of the same Verilog.
    place.reproduced(&report["command"], "again");
    let verilog = place.text("fit/beam_display.v");
    assert_eq!(verilog, place.text("again/beam_display.v"));
    assert_eq!(place.bytes("fit/golden.png"), place.bytes("again/pins.png"));
    let contract = place.text("fit/contract.md");
    let command = report["command"].as_str().unwrap();
    assert!(contract.contains("how it is known") && contract.contains(command));
}

#[test]
fn the_form_of_the_root_is_that_of_the_target() {
    for (target, form) in [("ecp5-85k", "non-restoring"), ("ice40-hx8k", "restoring")] {
        let place = Place::new();
        let fit = "fit scenes/cone.toml --size 32x24 --max-depth-error 2px --no-cost --out .";
        let report = place.json(&format!("{fit} --target {target}"));
        let chosen = report["machine"]["root_form"].as_str();
        assert_eq!(chosen.unwrap_or("restoring"), form, "{target}");
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{target}");
    }
}

/// A beam machine of two objects takes more than is allowed, and processors are shared; synthesis makes it a full run.
#[test]
fn a_budget_of_cells_takes_a_zone_machine() {
    let place = Place::new();
    let scene = "scenes/crossing-cylinders.toml";
    let fit = format!("fit {scene} --size 32x24 --max-depth-error 2px --lit-sphere --out fit");
    let refused = place.run(&format!("{fit} --max-cells 1 --no-cost"));
    refused.refused(&["--max-cells", "--no-cost"]);
    if !is_full() {
        return;
    }
    let beam = place.json(&format!("{fit} --machine beam"))["cost"]["cells"].as_u64();
    let most = beam.unwrap() - 1;
    let report = place.json(&format!("{fit} --max-cells {most}"));
    assert_eq!(report["machine"]["machine"], "zone");
    assert!(report["cost"]["cells"].as_u64() <= Some(most));
    assert_eq!(report["cosim"][0]["mismatches"], 0);
    let none = place.run(&format!("{fit} --max-cells 500")).ended(1);
    none.says(&["a beam machine takes", "a zone machine takes"]);
}

/// Shadows, meshes and more objects than a beam machine has processors, without an outside tool.
#[test]
fn scenes_of_every_kind_are_fitted_to_the_pins() {
    let place = Place::new();
    for (scene, more, kind) in [
        ("processors/polyhedron", "", "beam"),
        ("processors/mesh", "--machine beam", "beam"),
        ("processors/paraboloids", "", "beam"),
        ("processors/curved-facet", "", "beam"),
        ("processors/first-generation", "", "beam"),
        ("extremes/eye-on-quadric", "", "beam"),
        ("shadows/robot", "", "zone"),
        ("processors/mesh", "", "zone"),
        ("cone", "--machine zone --min-fps 60", "zone"),
        ("extremes/sixteen-lights", "", "beam"),
    ] {
        let out = scene.replace('/', "-");
        let fit = format!("fit scenes/{scene}.toml --size 32x24 --no-cost --out {out}");
        let report = place.json(&format!("{fit} --max-depth-error 2px {more}"));
        assert_eq!(report["machine"]["machine"], kind, "{scene}");
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{scene}");
        assert_eq!(report["cost"], Value::Null, "{scene}");
        assert!(place.has(&format!("{out}/machine.toml")), "{scene}");
    }
}

/// A scene with an object that the viewer nearly lies on, which no machine draws yet.
const NO_MACHINE: [&str; 1] = ["extremes/eye-barely-inside.toml"];

fn scenes_in(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => scenes_in(&path, found),
            false => found.push(path),
        }
    }
}

/// In the full run every scene that there is goes to the pins of a machine that is made for it; else one in twenty.
#[test]
fn scenes_go_to_the_pins_of_machines_that_are_made_for_them() {
    let root = repository("scenes");
    let mut scenes = vec![];
    scenes_in(&root, &mut scenes);
    scenes.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    scenes.sort();
    assert!(scenes.len() > 80);
    // Those of some scenes take minutes: they are for the full run.
    let (first, step) = if is_full() { (0, 1) } else { (9, 20) };
    let place = Place::new();
    for (index, path) in scenes.iter().enumerate().skip(first).step_by(step) {
        let name = path.strip_prefix(&root).unwrap().display().to_string();
        let options = format!("--size 32x24 --max-depth-error 2px --no-cost --out {index}");
        let fit = format!("--json --allow-missing fit {}", path.display());
        let fitted = place.run(&format!("{fit} {options}"));
        if NO_MACHINE.contains(&name.as_str()) {
            fitted.refused(&[]);
            continue;
        }
        let report = fitted.ended(0).json();
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{name}");
        assert!(report["cosim"][0]["pixels"].as_u64() >= Some(32 * 24));
    }
}

#[test]
fn what_is_out_of_reach_fails_the_check_and_writes_nothing() {
    let place = Place::new();
    let cases = "
        scenes/cone.toml --max-depth-error 1px --no-cost --min-fps 1e6 | 1000000 frames per second at 50 MHz
        scenes/cut-sphere.toml --max-normal-error 0 | out of reach | normal | --widths depth=
    ";
    for row in rows(cases) {
        let line = format!("fit {} --size 32x24 --out fit", row[0]);
        place.run(&line).ended(1).says(&row[1..]);
        assert!(!place.has("fit"));
    }
    let line = "fit scenes/cone.toml --max-depth-error 1px --no-cost --min-fps 8000 --size 160x24 --out fit";
    let refused = place.run(line).ended(1);
    refused.says(&["--pixels-per-clock 2 would do"]);
    let two = place.json(&format!("{line} --pixels-per-clock 2"));
    assert_eq!(two["cosim"][0]["mismatches"], 0);
}

#[test]
fn bad_input_is_refused_with_what_would_be_accepted() {
    let cases = "
        fit no-such-scene.toml                                            | --max-depth-error
        fit scenes/cut-sphere.toml --max-depth-error 1m                   | 0.5px
        fit scenes/cut-sphere.toml --max-face-errors 1.5                  | 0.1%
        fit scenes/cut-sphere.toml scenes/teapot.toml --max-depth-error 1 | the same objects
        fit scenes/extremes/eye-barely-inside.toml --max-depth-error 1    | would need 79 bits
        emit pe1 --widths depth=20 --slots 1                              | takes the unit beam
        emit beam --widths depth=20 --slots 13                            | 3,0,2:
        emit beam --widths depth=20                                       | --slots
    ";
    for [line, part] in columns(cases) {
        let place = Place::new();
        let refused = place.run(&format!("{line} --out x")).refused(&[part]);
        assert_eq!(refused.out, "", "{line}");
        assert!(!place.has("x"));
    }
}

/// The products of a solid, and the layers of transparent objects, on the pins; then the same from the machine file.
#[test]
fn solids_and_glass_go_to_the_pins() {
    let place = Place::new();
    let cases = r#"
        solids/bracket         | products = "1-4,1-4"         | products = "1-4"
        solids/printed-example | products = "2-1,2-1,2-1,2-1" | products = "2-1"
        glass/still-life       | layers = 3                   | layers = 3
    "#;
    for [name, key, of_zones] in columns(cases) {
        let scene = format!("scenes/{name}.toml");
        let fit =
            format!("fit {scene} --max-depth-error 1px --no-cost --size 64x48 --out fit/{name}");
        let report = place.json(&fit);
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{scene}");
        let machine = format!("fit/{name}/machine.toml");
        let text = place.text(&machine);
        assert!(text.contains(key), "{scene}: {text}");
        let again = format!("machine {scene} --machine {machine} --out again/{name}");
        place.run(&again).ended(0);
        let zones = place.json(&format!("{fit} --machine zone"));
        assert_eq!(zones["cosim"][0]["mismatches"], 0, "{scene}");
        // A zone machine draws one product after another.
        let zone = "--machine machines/zone-320x240.toml --out zone";
        let refused = place.run(&format!("machine {scene} {zone}"));
        refused.refused(&[of_zones]);
    }
}

/// What is left out is not in the machine, and counts among its errors.
#[test]
fn small_objects_are_left_out_within_the_budget() {
    let place = Place::new();
    let fit = |budget: &str, more: &str| {
        format!("fit scenes/shadows/robot.toml --size 96x72 --no-cost {budget} {more} --out out")
    };
    let budget = "--max-silhouette-errors 1% --max-face-errors 2%";
    let whole = place.json(&fit(budget, ""));
    let report = place.json(&fit(budget, "--leave-out 8"));
    assert_eq!(report["cosim"][0]["mismatches"], 0);
    let left_out = report["left_out"].as_array().unwrap();
    assert!((3..39).contains(&left_out.len()), "{left_out:?}");
    assert!(whole["left_out"].as_array().unwrap().is_empty());
    let clocks = |report: &Value| report["clocks_per_frame"].as_u64().unwrap();
    assert!(clocks(&report) < clocks(&whole));
    let text = place.text("out/scene.toml");
    for name in left_out {
        let name = name.as_str().unwrap();
        assert!(!text.contains(&format!("name = \"{name}\"")), "{name}");
    }
    let missing = &report["measured"][0];
    assert!(missing["silhouette"].as_u64().unwrap() > 0, "{missing}");
    place.reproduced(&report["command"], "again");
    assert!(place.bytes("again/pins.png") == place.bytes("out/golden.png"));
    let exact = "--max-silhouette-errors 0 --max-face-errors 0 --leave-out 8";
    let refused = place.run(&fit(exact, "")).ended(1);
    refused.says(&["out of reach"]);
}

/// A sphere whose second cut is the first once more, whose third removes nothing, and whose last takes a sliver off.
const SPARE_CUTS: &str = r#"
format = 1
title = "Sphere with spare cuts"
image = { width = 96, height = 72 }
camera = { kind = "perspective", eye = [2, 3, 9], target = [0, 0, 0], viewer_distance = 10, view_height = 2.6 }
lights = [{ kind = "directional", from = [-3, 5, 7] }]
materials = [{ name = "grey", colour = [0.5, 0.5, 0.5] }]

[[objects]]
name = "ball"
kind = "sphere"
radius = 1
mode = "solid"
material = "grey"
cuts = [
    { point = [0, 0.5, 0], normal = [0, 1, 0] },
    { point = [0, 0.5, 0], normal = [0, 2, 0] },
    { point = [0, -2, 0], normal = [0, -1, 0] },
    { point = [0.96, 0, 0], normal = [1, 0, 0] },
]
"#;

/// Planes that change nothing go within a budget of nothing, of two equal ones the second; one that takes a sliver off
/// goes where the budget allows its pixels.
#[test]
fn cut_planes_are_left_out_within_the_budget() {
    let place = Place::new();
    place.write("ball.toml", SPARE_CUTS);
    let cuts = |report: &Value| -> Vec<u64> {
        let planes = report["left_out_planes"].as_array().unwrap().iter();
        let planes = planes.inspect(|plane| assert_eq!(plane["object"], "ball"));
        planes.map(|plane| plane["cut"].as_u64().unwrap()).collect()
    };
    let errors = |report: &Value| {
        let measured = &report["measured"][0];
        ["silhouette", "visible_part"].map(|key| measured[key].as_u64().unwrap())
    };
    let exact = "--max-silhouette-errors 0 --max-face-errors 0";
    let some = "--max-silhouette-errors 1% --max-face-errors 2%";
    for (budget, leave_out, left, slots) in [
        (exact, "1", vec![1, 2], "2"),
        (some, "60", vec![1, 2, 3], "1"),
        (some, "auto", vec![1, 2, 3], "1"),
        (exact, "0", vec![], "4"),
    ] {
        let fit = format!("fit ball.toml {budget} --leave-out {leave_out} --no-cost --out out");
        let report = place.json(&fit);
        assert_eq!(cuts(&report), left, "{fit}");
        assert!(
            report["slots"].as_str().unwrap().starts_with(slots),
            "{fit}"
        );
        assert_eq!(report["cosim"][0]["mismatches"], 0, "{fit}");
        assert_eq!(errors(&report) == [0, 0], budget == exact, "{fit}");
        place.reproduced(&report["command"], "again");
        assert!(place.bytes("again/pins.png") == place.bytes("out/golden.png"));
    }
    let refused = place.run(&format!(
        "fit ball.toml {exact} --leave-out 60 --no-cost --out out"
    ));
    refused.ended(1).says(&["out of reach"]);
}

/// As many objects are left out as make the smallest machine; the budget has to say how many pixels may lack one.
#[test]
fn the_budget_says_which_objects_are_left_out() {
    let place = Place::new();
    let fit = "fit scenes/teapot.toml --size 96x72 --no-cost --out out";
    let budget = "--max-silhouette-errors 1% --max-face-errors 2%";
    let slots = |report: &Value| report["slots"].as_str().unwrap().split(',').count();
    let whole = place.json(&format!("{fit} {budget}"));
    let report = place.json(&format!("{fit} {budget} --leave-out auto"));
    let left_out = report["left_out"].as_array().unwrap().len();
    assert!(left_out > 0);
    assert_eq!(slots(&report) + left_out, slots(&whole));
    assert_eq!(report["cosim"][0]["mismatches"], 0);
    for limit in report["limits"].as_array().unwrap() {
        let [measured, allowed] = ["measured", "allowed"].map(|key| limit[key].as_f64());
        assert!(measured <= allowed, "{limit}");
    }
    place.reproduced(&report["command"], "again");
    assert!(place.bytes("again/pins.png") == place.bytes("out/golden.png"));
    let refused = place.run(&format!("{fit} --max-face-errors 2% --leave-out auto"));
    refused.refused(&["--max-silhouette-errors", "--max-face-errors"]);
    let refused = place.run(&format!("{fit} {budget} --leave-out few"));
    refused.refused(&["few", "auto", "60"]);
}
