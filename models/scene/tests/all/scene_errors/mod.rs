//! Every refusal of a scene file says what is wrong, where, and what would be accepted.

mod file;
mod keys;
mod values;

use imogene_prepare::Framing;
use imogene_scene::SceneFile;
use imogene_testkit::rows;
use std::fs;
use std::path::PathBuf;

const GOOD: &str = r#"format = 1
title = "test"
background = [0, 0, 0]
ambient = [1, 1, 1]
image = { width = 64, height = 48 }

[camera]
kind = "perspective"
eye = [0, 0, 10]
target = [0, 0, 0]
up = [0, 1, 0]
viewer_distance = 10
view_height = 4

[[lights]]
kind = "directional"
from = [0, 1, 1]
colour = [1, 1, 1]
intensity = 1

[[materials]]
name = "clay"
colour = [0.8, 0.4, 0.3]
exponent = 20

[[objects]]
name = "ball"
kind = "sphere"
radius = 1
material = "clay"
place = [{ scale = 2 }, { rotate = { axis = "y", degrees = 30 } }]
cuts = [{ point = [0, 0.5, 0], normal = [0, 1, 0] }]
"#;

/// The message for the good scene with `old` replaced by `new`.
fn refusal(old: &str, new: &str) -> String {
    assert_eq!(GOOD.matches(old).count(), 1, "`{old}` must occur once");
    refusal_of(&GOOD.replacen(old, new, 1))
}

fn refusal_of(text: &str) -> String {
    let scene = SceneFile::parse(text, "demo.toml");
    scene.expect_err(text).to_string()
}

fn assert_says(message: &str, parts: &[&str]) {
    assert!(message.starts_with("demo.toml"), "no file: {message}");
    for part in parts {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

/// Asserts that a text is refused with all parts of a message that stand between bars.
fn refused(text: &str, parts: &str) {
    assert_says(&refusal_of(text), &parts.split(" | ").collect::<Vec<_>>());
}

/// A row is a text of the good scene, what stands in its place, and the parts of the message.
fn check_each(table: &str) {
    for row in rows(table) {
        let [old, new, parts @ ..] = &row[..] else {
            panic!("no change in {row:?}");
        };
        let [old, new] = [old, new].map(|text| text.replace("\\n", "\n"));
        assert_says(&refusal(&old, &new), parts);
    }
}

/// A file of this test alone, named after it.
fn file_with(name: &str, bytes: &[u8]) -> PathBuf {
    let path = std::env::temp_dir().join(format!("imogene-{}-{name}.toml", std::process::id()));
    fs::write(&path, bytes).expect("the temporary directory is writable");
    path
}

#[test]
fn the_good_scene_is_accepted() {
    SceneFile::parse(GOOD, "demo.toml").expect("the scene all other tests are derived from");
}

#[test]
fn duplicate_names() {
    let twice = format!(
        "{GOOD}\n[[objects]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 2\nmaterial = \"clay\"\n"
    );
    refused(&twice, "object `ball` | taken | unique");
    let materials = format!("{GOOD}\n[[materials]]\nname = \"clay\"\ncolour = [1, 1, 1]\n");
    refused(&materials, "material `clay` | taken | unique");
}

#[test]
fn empty_and_unknown_names() {
    check_each(
        r#"
        name = "ball" | name = " " | objects[0].name | empty | a name is needed
        name = "clay" | name = "" | materials[0].name | empty | a name is needed
        material = "clay" | material = "clya" | object `ball`, material | `clya` | `clay`
        "#,
    );
}

#[test]
fn camera_without_direction_or_window() {
    check_each(
        r#"
        target = [0, 0, 0] | target = [0, 0, 10] | camera.target | the eye itself | away from the eye
        up = [0, 1, 0] | up = [0, 0, -3] | camera.up | parallel | upwards
        viewer_distance = 10 | viewer_distance = 0 | camera.viewer_distance | not positive | above 0
        view_height = 4 | view_height = -4 | camera.view_height | -4 is not positive
        "#,
    );
    let orthographic = GOOD
        .replacen("\"perspective\"", "\"orthographic\"", 1)
        .replacen("viewer_distance = 10", "half_depth = 0", 1);
    refused(&orthographic, "camera.half_depth | 0 is not positive");
    let attenuated = orthographic
        .replacen("half_depth = 0", "half_depth = 1", 1)
        .replacen("ambient =", "attenuation = 9\nambient =", 1);
    refused(&attenuated, "attenuation | parallel view | perspective");
}

#[test]
fn too_many_cuts() {
    let cut = "{ point = [0, 0.5, 0], normal = [0, 1, 0] }";
    let thirteen = vec![cut; 13].join(", ");
    refused(
        &GOOD.replace(cut, &thirteen),
        "object `ball`, cuts | 13 cut planes | at most 12",
    );
}

#[test]
fn too_many_lights() {
    let lights = "[[lights]]\nkind = \"point\"\nposition = [1, 2, 3]\n".repeat(16);
    refused(
        &format!("{GOOD}\n{lights}"),
        "lights | 17 lights | at most 16",
    );
}

#[test]
fn scenes_built_in_memory_are_checked_too() {
    let mut scene = SceneFile::parse(GOOD, "demo.toml").expect("a good scene");
    scene.objects.clear();
    assert!(scene.frame(64, 48).is_err());
    assert!(scene.to_toml().is_err());
}

/// The messages shown on the page of the format are the real ones.
#[test]
fn documented_messages_are_real() {
    // A long message goes on in an indented line behind its semicolon.
    let page = include_str!("../../../../../docs/scene-format.md").replace(";\n  ", "; ");
    let slips = [
        ("colour = [0.8, 0.4, 0.3]", "color = [0.8, 0.4, 0.3]"),
        ("material = \"clay\"", "material = \"clya\""),
        ("normal = [0, 1, 0]", "normal = [0, 0, 0]"),
    ];
    for (old, new) in slips {
        let message = refusal(old, new);
        assert!(page.contains(&message), "not on the page: {message}");
    }
}
