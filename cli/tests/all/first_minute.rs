//! The first minute with the program: a scene to begin with, names that need not be given, and answers that are not
//! silent.

use crate::common::{Place, Run, json, repository, run};

#[test]
fn a_new_scene_draws_and_is_never_overwritten() {
    let place = Place::new();
    let out = place.run("new").ended(0).out;
    assert!(out.contains("imogene render scene.toml"), "{out}");
    let report = place.json("render scene.toml");
    assert_eq!(report["files"][0], "scene.png");
    // All three objects are in the picture, and none fills it.
    let covered = report["covered_pixels"].as_u64().unwrap();
    assert!((40_000..120_000).contains(&covered), "{covered}");
    let out = place.run("check scene.toml").ended(0).out;
    for object in ["ball:", "post:", "ground:"] {
        assert!(out.contains(object), "{out}");
    }

    place.write("scene.toml", "mine");
    let again = place.run("new scene.toml");
    again.refused(&["scene.toml exists"]);
    assert_eq!(place.text("scene.toml"), "mine");
    let nowhere = place.run("new no/such/folder.toml");
    nowhere.refused(&["no/such/folder.toml"]);
}

#[test]
fn render_names_its_files_after_the_scene_in_the_current_folder() {
    let place = Place::new();
    let cone = place.run("render scenes/cone.toml --size 40x30");
    let out = cone.ended(0).out;
    assert!(out.ends_with("wrote cone.png\n"), "{out}");
    assert!(place.has("cone.png"));
    let frames = "render scenes/animation/arm.toml --size 40x30 --frames 1..2";
    place.run(frames).ended(0);
    assert!(place.has("arm/animation.png"));
}

#[test]
fn one_is_written_without_an_s() {
    let frames = "render scenes/animation/arm.toml --size 40x30 --frames 2..2";
    let out = Place::new().run(frames).out;
    assert!(out.starts_with("1 frame of 40 x 30 pixels"), "{out}");
    let out = run("units").out;
    assert!(out.contains("latency:    1 clock\n"), "{out}");
}

/// What `units` lists, `cosim` runs; the two that are loaded over a bus as well.
#[test]
fn units_of_the_load_bus_are_co_simulated_by_name() {
    for unit in ["coefficient_store", "beam"] {
        let report = json(&format!("cosim {unit} --clocks 1000"));
        assert_eq!(report["mismatches"], 0, "{unit}");
        let comparisons = report["comparisons"].as_u64();
        assert!(comparisons > Some(1_000), "{unit}: {report}");
    }
    run("cosim nothing").refused(&["coefficient_store, beam"]);
}

#[test]
fn a_unit_without_a_baseline_is_a_failed_check() {
    let text = std::fs::read_to_string(repository("docs/resources.json")).unwrap();
    let mut baseline: serde_json::Value = serde_json::from_str(&text).unwrap();
    let rows = baseline["rows"].as_array_mut().unwrap();
    rows.retain(|row| row["unit"] != "shading_processor" && row["unit"] != "shadow_stage");
    let place = Place::new();
    place.write("baseline.json", baseline.to_string());
    let check = "synth --baseline baseline.json --check";
    let failed = place.run(&format!("{check} shading_processor")).ended(1);
    failed.says(&["shading_processor has no baseline"]);
    // Of all units, those without one are named before a tool is looked for.
    let mut command = place.command(&format!("{check} --no-clock"));
    let tools = command
        .env("PATH", "")
        .env("IMOGENE_TOOLS", "no/such/folder");
    let said = Run::of(tools).said;
    assert!(said.starts_with("not checked, no baseline"), "{said}");
    assert!(said.contains("shadow_stage"), "{said}");
}

#[test]
fn a_trade_of_a_scene_that_no_machine_draws_is_refused() {
    let place = Place::new();
    let eye = "scenes/extremes/eye-on-quadric.toml";
    let trade = format!("trade {eye} --size 40x30 --points quick --no-cost --out out");
    let refused = place.run(&trade);
    refused.refused(&["the viewer lies exactly on this quadric"]);
    assert!(!place.has("out"));
}

#[test]
fn processors_by_themselves_are_said_to_have_no_guard_bits() {
    let place = Place::new();
    let mesh = "scenes/processors/mesh.toml";
    let render = format!("render {mesh} --size 40x30 --model rtl --guards 10:0");
    place.run(&render).refused(&["imogene machine"]);
    assert!(!place.has("mesh.png"));
}
