//! `imogene trade`: files, keys, commands that reproduce, refusals.

use crate::common::{imogene, said, scene};
use serde_json::Value;
use std::path::Path;

fn trade(scene_name: &str, out: &Path, more: &[&str]) -> (Option<i32>, String, String) {
    let output = imogene()
        .args([
            "--json",
            "trade",
            "--size",
            "48x36",
            "--points",
            "quick",
            "--no-cost",
            "--out",
        ])
        .arg(out)
        .arg(scene(scene_name))
        .args(more)
        .output()
        .unwrap();
    said(output)
}

#[test]
fn every_file_is_written_whatever_the_parts() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let (code, printed, error) = trade("cut-sphere.toml", &out, &[]);
    assert_eq!(code, Some(0), "{error}");
    let summary: Value = serde_json::from_str(&printed).unwrap();
    let files = summary["files"].as_array().unwrap();
    assert_eq!(files.len(), 7);
    for file in files {
        assert!(Path::new(file.as_str().unwrap()).is_file(), "{file}");
    }
    let text = std::fs::read_to_string(out.join("trade.json")).unwrap();
    let report: Value = serde_json::from_str(&text).unwrap();
    let points = report["points"].as_array().unwrap();
    assert_eq!(points.len() as u64, summary["points"]);
    for point in points {
        for key in ["format", "unit", "errors", "cost", "command"] {
            assert!(point.get(key).is_some(), "no {key}");
        }
    }
    // Again, from what is kept; and in two parts.
    let read = |folder: &Path| {
        let text = std::fs::read_to_string(folder.join("trade.json")).unwrap();
        text.replace(&folder.display().to_string(), "OUT")
    };
    let first = read(&out);
    trade("cut-sphere.toml", &out, &[]);
    assert!(read(&out) == first);
    let parts = folder.path().join("parts");
    for part in ["2/2", "1/2"] {
        let (code, printed, error) = trade("cut-sphere.toml", &parts, &["--shard", part]);
        assert_eq!(code, Some(0), "{error}");
        let done: Value = serde_json::from_str(&printed).unwrap();
        assert!(done["points"].as_u64().unwrap() > 0);
        assert!(!parts.join("trade.json").exists());
    }
    trade("cut-sphere.toml", &parts, &[]);
    assert!(read(&parts) == first);
}

/// What a command prints of a machine, with the folder of its files.
fn shown(command: &str, out: &Path) -> Value {
    let out = out.display().to_string();
    let words = command.split(' ').skip(1);
    let words = words.map(|word| if word == "DIR" { &out } else { word });
    let output = imogene().arg("--json").args(words).output().unwrap();
    assert!(output.status.success(), "{command}: {output:?}");
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The command of a point draws its picture, in hardware as in the golden model, and the hardware takes as many clocks
/// from frame to frame as the point says.
#[test]
fn every_point_is_a_machine_that_draws_its_picture_in_its_clocks() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let (code, _, error) = trade("cut-sphere.toml", &out, &[]);
    assert_eq!(code, Some(0), "{error}");
    let text = std::fs::read_to_string(out.join("trade.json")).unwrap();
    let report: Value = serde_json::from_str(&text).unwrap();
    let points = report["points"].as_array().unwrap();
    let of = |id: &str| points.iter().find(|point| point["id"] == id).unwrap();
    for id in [
        "w20-n16-g0.0-d3-r2",
        "w16-n16-g0.0-d0-z16k1-r2",
        "w16-n16-g0.0-d0-s2-z16k2-r1",
        "w16-n16-g0.0-d0-p2-r1",
    ] {
        let (point, again) = (of(id), folder.path().join(id));
        let command = point["command"].as_str().unwrap();
        let name = scene("cut-sphere.toml").display().to_string();
        let cycles = [1, 2, 3].map(|times| {
            let names = vec![name.as_str(); times].join(" ");
            let shown = shown(&command.replacen(&name, &names, 1), &again);
            assert_eq!(shown["report"]["mismatches"], 0, "{id}");
            shown["report"]["cycles"].as_u64().unwrap()
        });
        let clocks = point["clocks_per_frame"].as_u64().unwrap();
        assert_eq!(cycles[2] - cycles[1], clocks, "{id}");
        assert!(cycles[0] > clocks, "{id}");
        if !id.contains("-p2") {
            let [seen, kept] = [
                again.join("pins.png"),
                out.join(point["picture"].as_str().unwrap()),
            ];
            assert!(
                std::fs::read(seen).unwrap() == std::fs::read(kept).unwrap(),
                "{id}"
            );
        }
    }
    let emitted = folder.path().join("emitted");
    let point = of("w24-n16-g0.0-d0-r1");
    shown(point["emit"].as_str().unwrap(), &emitted);
    assert!(emitted.join("beam_stream.v").is_file());
}

#[test]
fn zones_and_widths_of_one_picture() {
    let folder = tempfile::tempdir().unwrap();
    let render = |more: &[&str]| {
        let output = imogene()
            .args(["render", "--size", "64x48", "-o"])
            .arg(folder.path().join("picture.png"))
            .arg(scene("cone.toml"))
            .args(more)
            .output()
            .unwrap();
        let error = String::from_utf8(output.stderr).unwrap();
        (output.status.code(), error)
    };
    let picture = || std::fs::read(folder.path().join("picture.png")).unwrap();
    assert_eq!(render(&["--widths", "depth=16"]).0, Some(0));
    let by_widths = picture();
    assert_eq!(render(&["--format", "16"]).0, Some(0));
    assert!(picture() == by_widths);
    assert_eq!(render(&["--widths", "depth=12", "--zone", "16"]).0, Some(0));
    assert!(picture() != by_widths);
    let own = ["--widths", "depth=20,root=18"];
    assert_eq!(render(&own).0, Some(0));
    let golden = picture();
    let (code, error) = render(&[&own[..], &["--model", "rtl"]].concat());
    assert_eq!(code, Some(0), "{error}");
    assert!(picture() == golden);
    for (more, wanted) in [
        (vec!["--widths", "depth=40"], "accepted are 8 to 32"),
        (vec!["--widths", "root=12"], "depth=W"),
        (
            vec!["--widths", "depth=16", "--format", "16"],
            "cannot be used with",
        ),
        (vec!["--zone", "16", "--model", "exact"], "--model golden"),
        (vec!["--zone", "1"], "8..=4096"),
    ] {
        std::fs::remove_file(folder.path().join("picture.png")).ok();
        let (code, error) = render(&more);
        assert_eq!(code, Some(2), "{more:?}: {error}");
        assert!(error.contains(wanted), "{more:?}: {error}");
        assert!(!folder.path().join("picture.png").exists());
    }
}

#[test]
fn bad_input_is_refused_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    for (name, more, wanted) in [
        ("processors/mesh.toml", vec![], "processor \"facet\""),
        ("cone.toml", vec!["--target", "abacus"], "abacus"),
        ("cone.toml", vec!["--shard", "3/2"], "K from 1 to N"),
        ("cone.toml", vec!["--shard", "0/2"], "K from 1 to N"),
        ("nowhere.toml", vec![], "nowhere.toml"),
    ] {
        let (code, printed, error) = trade(name, &out, &more);
        assert_eq!(code, Some(2), "{error}");
        let document: serde_json::Value = serde_json::from_str(&printed).unwrap();
        assert_eq!(document["error"]["exit_code"], 2);
        assert!(
            error.contains(wanted) && !error.contains("panicked"),
            "{error}"
        );
        assert!(!out.exists(), "{name} {more:?}");
    }
}
