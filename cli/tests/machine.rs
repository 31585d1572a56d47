//! `imogene machine`: from a scene and a description to the picture from the pins.

mod common;

use common::imogene;
use imogene_models::picture::write_png;
use serde_json::Value;
use std::path::Path;

/// A beam machine with a screen of 40 x 30 pixels, and a zone machine for it.
const SMALL: [(&str, &str); 2] = [
    (
        "machine = \"beam\"\nobjects = 10\n",
        "loader_words = 1024\n",
    ),
    (
        "machine = \"zone\"\nobjects = 3\n",
        "zone = { width = 16, height = 16 }\nsupersampling = 2\noverlay = true\n",
    ),
];
const COMMON: &str = "planes = 3\nrows_per_stage = 6\nlights = 2\nmode = { columns = [40, 4, 4, 4], lines = [30, 2, 2, 40] }\n";

#[test]
fn the_pins_show_the_golden_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let mask = folder.path().join("mask.png");
    let stripes: Vec<u8> = (0..3 * 40 * 30)
        .map(|byte| u8::from(byte / 3 % 11 == 4))
        .collect();
    write_png(&mask, 40, 30, &stripes).expect("a picture");
    for (index, (head, tail)) in SMALL.iter().enumerate() {
        let description = folder.path().join(format!("{index}.toml"));
        std::fs::write(&description, format!("{head}{COMMON}{tail}")).expect("a file");
        let out = folder.path().join(format!("out{index}"));
        let mut command = imogene();
        command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        command.args([
            "machine",
            "scenes/teapot.toml",
            "--machine",
            description.to_str().expect("a plain path"),
            "--engine",
            "rust-hdl",
            "--out",
            out.to_str().expect("a plain path"),
            "--json",
        ]);
        if tail.contains("overlay") {
            command.arg("--overlay").arg(&mask);
        }
        let output = command.output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(0), "{said}");
        let value: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
        assert_eq!(value["equal"], true);
        assert_eq!(value["pixels_per_frame"], 1200);
        assert_eq!(value["report"]["mismatches"], 0);
        let pins = std::fs::read(out.join("pins.png")).expect("a picture");
        assert!(pins == std::fs::read(out.join("golden.png")).expect("a picture"));
        for file in value["files"].as_array().expect("files") {
            assert!(
                Path::new(file.as_str().expect("a path")).is_file(),
                "{file}"
            );
        }
    }
}

#[test]
fn an_animation_is_shown_frame_by_frame() {
    let folder = tempfile::tempdir().expect("a folder");
    let run = |range: &str| {
        let mut command = imogene();
        command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        command.args(["machine", "scenes/animation/arm.toml", "--json"]);
        command.args(["--machine", "machines/zone-320x240.toml", "--emit-only"]);
        command.args(["--animation", range, "--out"]);
        command
            .arg(folder.path())
            .output()
            .expect("the program runs")
    };
    let output = run("3..5");
    assert_eq!(output.status.code(), Some(0));
    let value: Value = serde_json::from_slice(&output.stdout).expect("one JSON document");
    let shown = [3, 4, 5].map(|n| format!("scenes/animation/arm.toml --frame {n}"));
    assert_eq!(value["scenes"], serde_json::json!(shown));
    // The arm moves, so that every frame has clocks of its own.
    let clocks = value["zone_clocks"].as_array().expect("a list");
    assert!(clocks.len() == 3 && clocks[0] != clocks[2]);
    let refused = run("20..99");
    assert_eq!(refused.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("numbers from 1 to 27"));
}

#[test]
fn what_a_machine_cannot_show_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("out");
    let refused_with = |scene: &str, machine: &str, more: &[&str], says: &str| {
        let mut command = imogene();
        command.current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/.."));
        command.args([
            "machine",
            scene,
            "--machine",
            machine,
            "--out",
            out.to_str().expect("a plain path"),
        ]);
        let output = command.args(more).output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(says), "{said}");
        assert!(!out.exists(), "{says}");
    };
    let refused = |scene, machine, says| refused_with(scene, machine, &[], says);
    refused("scenes/teapot.toml", "no/machine.toml", "give the path");
    let beam = "machines/beam-160x120.toml";
    refused("scenes/shadows/robot.toml", beam, "objects = 39 would do");
    refused("scenes/shadows/sphere-surface.toml", beam, "objects");
    let zone = "machines/zone-160x120.toml";
    refused("scenes/processors/mesh.toml", zone, "guard bits");
    let mask = ["--overlay", "docs/images/trace.png"];
    refused_with("scenes/teapot.toml", zone, &mask, "overlay = true");
    let description = folder.path().join("overlaid.toml");
    let text = format!("machine = \"beam\"\nobjects = 10\n{COMMON}overlay = true\n");
    std::fs::write(&description, text).expect("a file");
    let overlaid = description.to_str().expect("a plain path");
    refused_with(
        "scenes/teapot.toml",
        overlaid,
        &mask,
        "the screen has 40 x 30",
    );
    let mask = ["--overlay", "README.md"];
    refused_with("scenes/teapot.toml", overlaid, &mask, "a PNG picture");
}
