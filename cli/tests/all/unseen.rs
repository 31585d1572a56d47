//! Scenes of many objects: what nobody sees is left out and counted, and memory is looked at before it is taken.

use crate::common::imogene;
use serde_json::Value;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::Output;

/// A wall of balls before others that it hides, and one beside the picture.
fn scene(folder: &Path, side: u32) -> PathBuf {
    let mut text = String::from(
        "format = 1\ntitle = \"wall\"\n[camera]\nkind = \"perspective\"\neye = [0, 0, 40]\ntarget = [0, 0, 0]\n\
         viewer_distance = 40\nview_height = 8\n[[materials]]\nname = \"m\"\ncolour = [0.5, 0.5, 0.5]\n",
    );
    let mut ball = |name: String, place: [f64; 3], radius: f64| {
        writeln!(
            text,
            "[[objects]]\nname = \"{name}\"\nkind = \"sphere\"\nradius = {radius}\nmaterial = \"m\"\nplace = [{{ translate = {place:?} }}]"
        )
        .expect("text");
    };
    let step = 8.0 / f64::from(side);
    let at = |k: u32| (f64::from(k) + 0.5) * step - 4.0;
    for (k, l) in (0..side).flat_map(|k| (0..side).map(move |l| (k, l))) {
        // Overlapping, so that nothing shows between them.
        ball(format!("wall {k} {l}"), [at(k), at(l), 0.0], step);
    }
    for k in 0..7 {
        ball(format!("behind {k}"), [at(k), 0.3, -9.0], 0.4);
    }
    ball("beside".into(), [30.0, 0.0, 0.0], 1.0);
    let path = folder.join("wall.toml");
    std::fs::write(&path, text).expect("written");
    path
}

fn render(scene: &Path, more: &[&str]) -> Output {
    let mut command = imogene();
    command.arg("render").arg(scene);
    command
        .args(["--size", "200x200", "-o"])
        .arg(scene.with_extension("png"));
    command.args(more).output().expect("the program runs")
}

#[test]
fn what_nobody_sees_is_counted() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path(), 10);
    let output = render(&path, &["--json"]);
    assert_eq!(output.status.code(), Some(0));
    let report: Value = serde_json::from_slice(&output.stdout).expect("one document");
    assert_eq!(report["hidden"], 7);
    assert_eq!(report["off_screen"], 1);
    // In pieces every object counts as work, and none is left out.
    let output = render(&path, &["--json", "--split", "lines:4"]);
    assert_eq!(
        output.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&output.stderr)
    );
    let report: Value = serde_json::from_slice(&output.stdout).expect("one document");
    assert_eq!(report["hidden"], 0);
}

#[test]
fn a_scene_that_does_not_fit_into_memory_is_refused_with_what_would_do() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path(), 60);
    let refused = render(&path, &["--max-memory", "48M"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(!path.with_extension("png").exists());
    let message = String::from_utf8_lossy(&refused.stderr).into_owned();
    assert!(
        message.contains("preparing 3608 objects takes up to"),
        "{message}"
    );
    let words = message.split_whitespace();
    let enough = words
        .skip_while(|word| *word != "--max-memory")
        .nth(1)
        .expect("a size");
    let drawn = render(&path, &["--max-memory", enough]);
    assert_eq!(
        drawn.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&drawn.stderr)
    );
}

#[test]
fn a_size_that_is_none_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = scene(folder.path(), 2);
    for size in ["2GB", "0", "much"] {
        let refused = render(&path, &["--max-memory", size]);
        assert_eq!(refused.status.code(), Some(2), "{size}");
        let message = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(message.contains("such as 512M or 2G"), "{message}");
    }
}
