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
fn every_file_is_written_and_every_picture_can_be_drawn_again() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let (code, printed, error) = trade("cut-sphere.toml", &out, &[]);
    assert_eq!(code, Some(0), "{error}");
    let summary: Value = serde_json::from_str(&printed).unwrap();
    let files = summary["files"].as_array().unwrap();
    assert_eq!(files.len(), 6);
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
    for point in points.iter().step_by(5) {
        let command = point["command"].as_str().unwrap();
        let again = folder.path().join("picture.png");
        let words = command.split(' ').skip(1);
        let words = words.map(|w| match w {
            "picture.png" => again.to_str().unwrap(),
            word => word,
        });
        let output = imogene().args(words).output().unwrap();
        assert!(output.status.success(), "{command}: {output:?}");
        let kept = out.join(point["picture"].as_str().unwrap());
        assert!(
            std::fs::read(&again).unwrap() == std::fs::read(kept).unwrap(),
            "{command}"
        );
    }
    // Again, from what is kept; and in two parts.
    let read = |folder: &Path| std::fs::read(folder.join("trade.json")).unwrap();
    trade("cut-sphere.toml", &out, &[]);
    assert!(read(&out) == text.as_bytes());
    let parts = folder.path().join("parts");
    for part in ["2/2", "1/2"] {
        let (code, printed, error) = trade("cut-sphere.toml", &parts, &["--shard", part]);
        assert_eq!(code, Some(0), "{error}");
        let done: Value = serde_json::from_str(&printed).unwrap();
        assert!(done["points"].as_u64().unwrap() > 0);
        assert!(!parts.join("trade.json").exists());
    }
    trade("cut-sphere.toml", &parts, &[]);
    assert!(read(&parts) == text.as_bytes());
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
