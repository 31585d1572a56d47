//! The first minute with the program: a scene to begin with, names that need not be given, and answers that are not
//! silent.

use crate::common::{imogene, said, scene};
use std::path::Path;

fn run(folder: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let mut command = imogene();
    let output = command
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap();
    said(output)
}

#[test]
fn a_new_scene_draws_and_is_never_overwritten() {
    let folder = tempfile::tempdir().unwrap();
    let (code, out, error) = run(folder.path(), &["new"]);
    assert_eq!(code, Some(0), "{error}");
    assert!(out.contains("imogene render scene.toml"), "{out}");
    let drawn = run(folder.path(), &["render", "scene.toml", "--json"]);
    assert_eq!(drawn.0, Some(0), "{}", drawn.2);
    let report: serde_json::Value = serde_json::from_str(&drawn.1).unwrap();
    assert_eq!(report["files"][0], "scene.png");
    // All three objects are in the picture, and none fills it.
    let covered = report["covered_pixels"].as_u64().unwrap();
    assert!((40_000..120_000).contains(&covered), "{covered}");
    let (code, out, error) = run(folder.path(), &["check", "scene.toml"]);
    assert_eq!(code, Some(0), "{error}");
    for object in ["ball:", "post:", "ground:"] {
        assert!(out.contains(object), "{out}");
    }

    let path = folder.path().join("scene.toml");
    std::fs::write(&path, "mine").unwrap();
    let (code, _, error) = run(folder.path(), &["new", "scene.toml"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("scene.toml exists"), "{error}");
    assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
    let (code, _, error) = run(folder.path(), &["new", "no/such/folder.toml"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("no/such/folder.toml"), "{error}");
}

#[test]
fn render_names_its_files_after_the_scene_in_the_current_folder() {
    let folder = tempfile::tempdir().unwrap();
    let cone = scene("cone.toml");
    let small = ["render", cone.to_str().unwrap(), "--size", "40x30"];
    let (code, out, error) = run(folder.path(), &small);
    assert_eq!(code, Some(0), "{error}");
    assert!(out.ends_with("wrote cone.png\n"), "{out}");
    assert!(folder.path().join("cone.png").is_file());
    let arm = scene("animation/arm.toml");
    let frames = ["render", arm.to_str().unwrap(), "--size", "40x30"];
    let frames = [&frames[..], &["--frames", "1..2"]].concat();
    let (code, _, error) = run(folder.path(), &frames);
    assert_eq!(code, Some(0), "{error}");
    assert!(folder.path().join("arm/animation.png").is_file());
}

#[test]
fn one_is_written_without_an_s() {
    let folder = tempfile::tempdir().unwrap();
    let arm = scene("animation/arm.toml");
    let arguments = ["render", arm.to_str().unwrap(), "--size", "40x30"];
    let arguments = [&arguments[..], &["--frames", "2..2"]].concat();
    let (_, out, _) = run(folder.path(), &arguments);
    assert!(out.starts_with("1 frame of 40 x 30 pixels"), "{out}");
    let (_, out, _) = run(folder.path(), &["units"]);
    assert!(out.contains("latency:    1 clock\n"), "{out}");
}

/// What `units` lists, `cosim` runs; the two that are loaded over a bus as well.
#[test]
fn units_of_the_load_bus_are_co_simulated_by_name() {
    let folder = tempfile::tempdir().unwrap();
    for unit in ["coefficient_store", "beam"] {
        let arguments = ["cosim", unit, "--clocks", "1000", "--json"];
        let (code, out, error) = run(folder.path(), &arguments);
        assert_eq!(code, Some(0), "{unit}: {error}");
        let report: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert_eq!(report["mismatches"], 0, "{unit}");
        assert!(
            report["comparisons"].as_u64() > Some(1_000),
            "{unit}: {report}"
        );
    }
    let (code, _, error) = run(folder.path(), &["cosim", "nothing"]);
    assert_eq!(code, Some(2));
    assert!(error.contains("coefficient_store, beam"), "{error}");
}

#[test]
fn a_unit_without_a_baseline_is_a_failed_check() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let text = std::fs::read_to_string(root.join("docs/resources.json")).unwrap();
    let mut baseline: serde_json::Value = serde_json::from_str(&text).unwrap();
    let rows = baseline["rows"].as_array_mut().unwrap();
    rows.retain(|row| row["unit"] != "shading_processor" && row["unit"] != "shadow_stage");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("baseline.json");
    std::fs::write(&file, baseline.to_string()).unwrap();
    let check = ["synth", "--baseline", file.to_str().unwrap(), "--check"];
    let (code, _, error) = run(&root, &[&check[..], &["shading_processor"]].concat());
    assert_eq!(code, Some(1), "{error}");
    assert!(
        error.contains("shading_processor has no baseline"),
        "{error}"
    );
    // Of all units, those without one are named before a tool is looked for.
    let output = imogene()
        .args(check)
        .arg("--no-clock")
        .current_dir(&root)
        .env("PATH", "")
        .env("IMOGENE_TOOLS", "no/such/folder")
        .output()
        .unwrap();
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(error.starts_with("not checked, no baseline"), "{error}");
    assert!(error.contains("shadow_stage"), "{error}");
}

#[test]
fn a_trade_of_a_scene_that_no_machine_draws_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene("extremes/eye-on-quadric.toml");
    let arguments = ["trade", scene.to_str().unwrap(), "--size", "40x30"];
    let more = ["--points", "quick", "--no-cost", "--out", "out"];
    let (code, _, error) = run(folder.path(), &[&arguments[..], &more].concat());
    assert_eq!(code, Some(2), "{error}");
    assert!(!folder.path().join("out").exists());
    assert!(
        error.contains("the viewer lies exactly on this quadric"),
        "{error}"
    );
}

#[test]
fn processors_by_themselves_are_said_to_have_no_guard_bits() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = scene("processors/mesh.toml");
    let arguments = ["render", mesh.to_str().unwrap(), "--size", "40x30"];
    let more = ["--model", "rtl", "--guards", "10:0"];
    let (code, _, error) = run(folder.path(), &[&arguments[..], &more].concat());
    assert_eq!(code, Some(2));
    assert!(error.contains("imogene machine"), "{error}");
    assert!(!folder.path().join("mesh.png").exists());
}
