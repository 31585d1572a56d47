//! `imogene render` on animations: frames, cameras, and what a failing frame leaves.

use crate::common::{Place, Run, columns, json, names_in};

const MOON: &str = "scenes/animation/moon.toml";

/// Frames of a scene, drawn in a folder.
fn frames(place: &Place, scene: &str, more: &str) -> Run {
    place.run(&format!("--json render {scene} --size 64x48 {more}"))
}

/// A sheet that comes nearer with every frame: in the second it is where the viewer is, from where a mesh cannot be
/// drawn.
const THROUGH_THE_VIEWER: &str = r#"
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

/// A folder with that scene in it.
fn place() -> Place {
    let place = Place::new();
    place.write("nearer.toml", THROUGH_THE_VIEWER);
    place
}

#[test]
fn frames_preview_and_report_are_written() {
    let place = Place::new();
    let drawn = frames(&place, MOON, "-o moon --frames 5..7");
    let report = drawn.ended(0).json();
    let wanted = "animation.png frame-0005.png frame-0006.png frame-0007.png frames.json";
    assert_eq!(names_in(&place.path("moon")).join(" "), wanted);
    let kept: serde_json::Value = serde_json::from_str(&place.text("moon/frames.json")).unwrap();
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
    let preview = place.bytes("moon/animation.png");
    let chunks = |name: &[u8]| preview.windows(4).filter(|w| *w == name).count();
    assert_eq!((chunks(b"acTL"), chunks(b"fcTL")), (1, 3));
}

#[test]
fn a_frame_is_the_picture_of_that_frame_alone() {
    let place = Place::new();
    frames(&place, MOON, "-o moon --frames 1..3").ended(0);
    frames(&place, MOON, "-o alone.png --frame 3").ended(0);
    let third = place.bytes("moon/frame-0003.png");
    assert_eq!(third, place.bytes("alone.png"));
    assert!(third != place.bytes("moon/frame-0002.png"));
}

#[test]
fn a_frame_that_cannot_be_drawn_is_named_and_leaves_nothing_half_written() {
    let place = place();
    let refused = frames(&place, "nearer.toml", "-o out --frames --strict");
    refused.refused(&[
        "nearer.toml: frame 2",
        "image `approach`, frame 2 of 4",
        "sheet",
    ]);
    assert!(!place.has("out"));
}

#[test]
fn a_camera_is_chosen_by_its_name() {
    let place = place();
    let picture = |camera: &str| {
        frames(&place, "nearer.toml", &format!("-o p.png {camera}")).ended(0);
        place.bytes("p.png")
    };
    let front = picture("");
    assert_eq!(front, picture("--camera front"));
    assert!(front != picture("--camera side"));
    let refused = frames(&place, "nearer.toml", "-o none.png --camera top");
    refused.refused(&["`top` is not a camera of this scene; the scene has `front`, `side`"]);
    assert!(!place.has("none.png"));
}

/// A frame is a scene for the hardware and the oracles too: its golden picture is another than that of the scene as it
/// is written.
#[test]
fn a_frame_is_a_scene_of_its_own_for_other_commands() {
    let of = |command: &str, frame: &str| json(&format!("{command} {MOON} --size 32x24 {frame}"));
    let report = of("cosim", "--frame 4");
    assert_eq!(report["mismatches"], 0);
    let command = report["reproduce"].as_str().expect("a command");
    assert!(command.ends_with("--frame 4"), "{command}");
    assert_ne!(report["pixels"], of("cosim", "")["pixels"]);
    let covered = |frame| of("trace", frame)["scenes"][0]["comparison"]["covered"].clone();
    assert_ne!(covered("--frame 4"), covered(""));
}

#[test]
fn frames_that_there_are_not_are_refused() {
    let place = Place::new();
    let cases = "
        animation/moon | --frames 20..25        | the animation has 24 frames
        animation/moon | --frame 25             | a number from 1 to 24
        teapot         | --frames               | the scene has no images to play
        animation/moon | --frames 7..3          | '7..3' is no range of frames
        animation/moon | --frames 1 --model rtl | --model golden or exact
    ";
    for [name, options, part] in columns(cases) {
        let scene = format!("scenes/{name}.toml");
        frames(&place, &scene, &format!("-o out {options}")).refused(&[part]);
        assert!(!place.has("out"));
    }
}
