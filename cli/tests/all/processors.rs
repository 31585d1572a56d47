//! Scenes whose objects are drawn by other processors than the quadric processor.

use crate::common::{imogene, said, scene};
use serde_json::Value;
use std::path::PathBuf;

/// Every scene of the folder.
fn scenes() -> Vec<PathBuf> {
    let folder = scene("processors");
    let entries = std::fs::read_dir(&folder).expect("the folder of scenes");
    let mut list: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    list.retain(|path| path.extension().is_some_and(|end| end == "toml"));
    assert!(list.len() >= 7, "{list:?}");
    list
}

fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = imogene().args(arguments).output().unwrap();
    said(output)
}

#[test]
fn hardware_draws_what_the_golden_model_draws() {
    let folder = tempfile::tempdir().unwrap();
    for path in scenes() {
        let scene = path.to_str().unwrap();
        let (code, out, error) = run(&["cosim", scene, "--size", "80x60", "--json"]);
        assert_eq!(code, Some(0), "{scene}: {error}");
        let report: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(report["mismatches"], 0, "{scene}");
        assert!(report["pixels"].as_u64() > Some(500), "{scene}: {report}");
        let pictures = ["golden", "rtl"].map(|model| {
            let png = folder.path().join(format!("{model}.png"));
            let output = png.to_str().unwrap();
            let arguments = [
                "render", scene, "--model", model, "--size", "80x60", "-o", output,
            ];
            let (code, _, error) = run(&arguments);
            assert_eq!(code, Some(0), "{scene}, {model}: {error}");
            std::fs::read(&png).unwrap()
        });
        assert_eq!(pictures[0], pictures[1], "{scene}");
    }
}

#[test]
fn emitted_verilog_of_the_processors_draws_the_scenes_too() {
    for name in ["paraboloids", "polyhedron", "first-generation"] {
        let path = scene(&format!("processors/{name}.toml"));
        let arguments = [
            "cosim",
            path.to_str().unwrap(),
            "--engine",
            "icarus",
            "--size",
            "40x30",
            "--rows-per-stage",
            "5",
            "--json",
        ];
        let (code, out, error) = run(&arguments);
        assert_eq!(code, Some(0), "{name}: {error}");
        let report: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(
            (&report["engine"], &report["mismatches"]),
            (&"icarus".into(), &0.into())
        );
        assert!(report["pixels"].as_u64() > Some(100), "{name}: {report}");
    }
}

#[test]
fn rows_out_of_range_are_refused() {
    let path = scene("processors/mesh.toml");
    let mesh = path.to_str().unwrap();
    let (code, _, error) = run(&["cosim", mesh, "--rows-per-stage", "99"]);
    assert_eq!(code, Some(2));
    assert!(
        error.contains("rows-per-stage = 99 is out of range; legal values are 1 to 24"),
        "{error}"
    );
}

#[test]
fn volumes_in_hardware_leave_the_flags_of_the_golden_machine() {
    for (name, size) in [("shadows/robot", "40x30"), ("shadows/dna", "24x18")] {
        let path = scene(&format!("{name}.toml"));
        let arguments = ["cosim", path.to_str().unwrap(), "--size", size, "--json"];
        let (code, out, error) = run(&arguments);
        assert_eq!(code, Some(0), "{name}: {error}");
        let report: Value = serde_json::from_str(&out).unwrap();
        assert_eq!(report["mismatches"], 0, "{name}");
        assert!(report["pixels"].as_u64() > Some(5_000), "{name}: {report}");
    }
}

#[test]
fn the_list_of_processors_is_printed() {
    let (code, out, _) = run(&["processors", "--json"]);
    assert_eq!(code, Some(0));
    let list: Value = serde_json::from_str(&out).unwrap();
    let patch = &list[1];
    assert_eq!(patch["unit"], "patch_processor");
    assert_eq!(
        ["pe1", "pe2", "roots", "multipliers"].map(|key| patch[key].as_u64().unwrap()),
        [8, 1, 1, 3]
    );
}
