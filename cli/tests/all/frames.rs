//! `imogene render` on animations: frames, cameras, and what a failing frame leaves.

use crate::common::{imogene, scene};
use std::fs;
use std::path::{Path, PathBuf};

fn frames(scene: &Path, out: &Path, more: &[&str]) -> assert_cmd::assert::Assert {
    let mut command = imogene();
    command.args(["--json", "render"]).arg(scene);
    command.args(["--size", "64x48", "-o"]).arg(out).args(more);
    command.assert()
}

fn stderr(assert: &assert_cmd::assert::Assert) -> String {
    String::from_utf8(assert.get_output().stderr.clone()).unwrap()
}

fn json(assert: &assert_cmd::assert::Assert) -> serde_json::Value {
    serde_json::from_slice(&assert.get_output().stdout).unwrap()
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
    let mut names: Vec<String> = entries
        .map(|entry| name(entry).into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// A sheet that comes nearer with every frame: in the second it is where the viewer is, from where a mesh cannot be
/// drawn.
fn through_the_viewer(folder: &Path) -> PathBuf {
    let path = folder.join("nearer.toml");
    let text = r#"
format = 1
title = "nearer"
[camera]
name = "front"
kind = "perspective"
eye = [0, 0, 10]
target = [0, 0, 0]
viewer_distance = 10
view_height = 6
[[cameras]]
name = "side"
kind = "orthographic"
eye = [10, 0, 0]
target = [0, 0, 0]
view_height = 6
half_depth = 30
[[lights]]
name = "sun"
kind = "directional"
from = [0, 1, 1]
[[materials]]
name = "plain"
colour = [0.5, 0.5, 0.5]
[[objects]]
name = "ball"
kind = "sphere"
radius = 1
material = "plain"
[[objects]]
name = "sheet"
kind = "mesh"
vertices = [[-0.2, -1, 0], [0.2, -1, 0], [0, 1, 0]]
faces = [[0, 1, 2]]
material = "plain"
place = [{ translate = [2, 0, 0] }]
[[images]]
name = "approach"
steps = 4
duration = 0.1
actions = [{ target = "sheet", translate = [-4, 0, 20] }]
"#;
    fs::write(&path, text).unwrap();
    path
}

#[test]
fn frames_preview_and_report_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("moon");
    let report =
        json(&frames(&scene("animation/moon.toml"), &out, &["--frames", "5..7"]).success());
    let wanted = [
        "animation.png",
        "frame-0005.png",
        "frame-0006.png",
        "frame-0007.png",
        "frames.json",
    ];
    assert_eq!(names(&out), wanted);
    let kept: serde_json::Value =
        serde_json::from_slice(&fs::read(out.join("frames.json")).unwrap()).unwrap();
    assert_eq!(kept, report);
    let list = report["frames"].as_array().unwrap();
    assert_eq!(list.len(), 3);
    for (frame, number) in list.iter().zip(5..) {
        assert_eq!(frame["frame"], number);
        assert_eq!(frame["image"], "round");
        assert_eq!(frame["step"], number);
        assert_eq!(frame["duration"], 0.08);
    }
    // The planet stands still, the moon moves.
    assert_eq!(report["objects_prepared"], 4);
    assert_eq!(report["objects_reused"], 2);
    let preview = fs::read(out.join("animation.png")).unwrap();
    let chunks = |name: &[u8]| preview.windows(4).filter(|w| *w == name).count();
    assert_eq!((chunks(b"acTL"), chunks(b"fcTL")), (1, 3));
}

#[test]
fn a_frame_is_the_picture_of_that_frame_alone() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("moon");
    let moon = scene("animation/moon.toml");
    frames(&moon, &out, &["--frames", "1..3"]).success();
    let alone = folder.path().join("alone.png");
    frames(&moon, &alone, &["--frame", "3"]).success();
    let third = fs::read(out.join("frame-0003.png")).unwrap();
    assert_eq!(third, fs::read(&alone).unwrap());
    assert!(third != fs::read(out.join("frame-0002.png")).unwrap());
}

#[test]
fn a_frame_that_cannot_be_drawn_is_named_and_leaves_nothing_half_written() {
    let folder = tempfile::tempdir().unwrap();
    let file = through_the_viewer(folder.path());
    let out = folder.path().join("out");
    let refused = frames(&file, &out, &["--frames", "--strict"]).code(2);
    let message = stderr(&refused);
    for part in [
        "nearer.toml: frame 2",
        "image `approach`, frame 2 of 4",
        "sheet",
    ] {
        assert!(message.contains(part), "{part}: {message}");
    }
    assert!(!out.exists());
}

#[test]
fn a_camera_is_chosen_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let file = through_the_viewer(folder.path());
    let [front, named, side] = ["front", "named", "side"].map(|n| folder.path().join(n));
    frames(&file, &front, &[]).success();
    frames(&file, &named, &["--camera", "front"]).success();
    frames(&file, &side, &["--camera", "side"]).success();
    let [front, named, side] = [front, named, side].map(|path| fs::read(path).unwrap());
    assert_eq!(front, named);
    assert!(front != side);
    let out = folder.path().join("none.png");
    let refused = frames(&file, &out, &["--camera", "top"]).code(2);
    let message = stderr(&refused);
    assert!(
        message.contains("`top` is not a camera of this scene; the scene has `front`, `side`"),
        "{message}"
    );
    assert!(!out.exists());
}

/// A frame is a scene for the hardware and the oracles too: its golden picture is another than that of the scene as it
/// is written.
#[test]
fn a_frame_is_a_scene_of_its_own_for_other_commands() {
    let moon = scene("animation/moon.toml");
    let of = |command: &str, frame: Option<&str>| {
        let mut run = imogene();
        run.args(["--json", command]).arg(&moon);
        run.args(["--size", "32x24"]);
        run.args(frame.map(|number| ["--frame", number]).iter().flatten());
        json(&run.assert().success())
    };
    let report = of("cosim", Some("4"));
    assert_eq!(report["mismatches"], 0);
    let command = report["reproduce"].as_str().expect("a command");
    assert!(command.ends_with("--frame 4"), "{command}");
    assert_ne!(report["pixels"], of("cosim", None)["pixels"]);
    let covered = |frame| of("trace", frame)["scenes"][0]["comparison"]["covered"].clone();
    assert_ne!(covered(Some("4")), covered(None));
}

#[test]
fn frames_that_there_are_not_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let moon = scene("animation/moon.toml");
    let refused = frames(&moon, &out, &["--frames", "20..25"]).code(2);
    assert!(stderr(&refused).contains("the animation has 24 frames"));
    let refused = frames(&moon, &out, &["--frame", "25"]).code(2);
    assert!(stderr(&refused).contains("a number from 1 to 24"));
    let refused = frames(&scene("teapot.toml"), &out, &["--frames"]).code(2);
    assert!(stderr(&refused).contains("the scene has no images to play"));
    let refused = frames(&moon, &out, &["--frames", "7..3"]).code(2);
    assert!(stderr(&refused).contains("'7..3' is no range of frames"));
    let refused = frames(&moon, &out, &["--frames", "1", "--model", "rtl"]).code(2);
    assert!(stderr(&refused).contains("--model golden or exact"));
    assert!(!out.exists());
}
