//! Scenes whose objects are drawn by other processors than the quadric processor.

use crate::common::{Place, json, repository, run};
use std::path::PathBuf;

/// Every scene of the folder.
fn scenes() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(repository("scenes/processors")).expect("a folder");
    let mut list: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    list.retain(|path| path.extension().is_some_and(|end| end == "toml"));
    assert!(list.len() >= 7, "{list:?}");
    list
}

/// Hardware and golden model agree on a scene, at so many pixels at least.
fn agrees(line: &str, pixels: u64) -> serde_json::Value {
    let report = json(&format!("cosim {line}"));
    assert_eq!(report["mismatches"], 0, "{line}");
    assert!(report["pixels"].as_u64() > Some(pixels), "{line}: {report}");
    report
}

#[test]
fn hardware_draws_what_the_golden_model_draws() {
    let place = Place::new();
    for path in scenes() {
        let scene = path.display();
        agrees(&format!("{scene} --size 80x60"), 500);
        let [golden, rtl] = ["golden", "rtl"].map(|model| {
            let line = format!("render {scene} --model {model} --size 80x60 -o p.png");
            place.run(&line).ended(0);
            place.bytes("p.png")
        });
        assert_eq!(golden, rtl, "{scene}");
    }
}

#[test]
fn emitted_verilog_of_the_processors_draws_the_scenes_too() {
    for name in ["paraboloids", "polyhedron", "first-generation"] {
        let options = "--engine icarus --size 40x30 --rows-per-stage 5";
        let report = agrees(&format!("scenes/processors/{name}.toml {options}"), 100);
        assert_eq!(report["engine"], "icarus");
    }
}

#[test]
fn rows_out_of_range_are_refused() {
    let refused = run("cosim scenes/processors/mesh.toml --rows-per-stage 99");
    refused.refused(&["rows-per-stage = 99 is out of range; legal values are 1 to 24"]);
}

#[test]
fn volumes_in_hardware_leave_the_flags_of_the_golden_machine() {
    agrees("scenes/shadows/robot.toml --size 40x30", 5_000);
    agrees("scenes/shadows/dna.toml --size 24x18", 5_000);
}

#[test]
fn the_list_of_processors_is_printed() {
    let list = json("processors");
    let patch = &list[1];
    assert_eq!(patch["unit"], "patch_processor");
    let parts = ["pe1", "pe2", "roots", "multipliers"].map(|key| patch[key].as_u64());
    assert_eq!(parts, [8, 1, 1, 3].map(Some));
}
