//! Every refusal of a scene file says what is wrong, where, and what would be accepted.

use std::fs;
use std::path::{Path, PathBuf};

use imogene_models::scene::SceneFile;

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
    match SceneFile::parse(text, "demo.toml") {
        Ok(_) => panic!("accepted:\n{text}"),
        Err(error) => error.to_string(),
    }
}

fn assert_says(message: &str, parts: &[&str]) {
    assert!(
        message.starts_with("demo.toml"),
        "no file name in: {message}"
    );
    for part in parts {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

fn check(old: &str, new: &str, parts: &[&str]) {
    assert_says(&refusal(old, new), parts);
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
fn missing_file() {
    let error = SceneFile::read(Path::new("no/such/scene.toml")).expect_err("no such file");
    let message = error.to_string();
    assert!(message.starts_with("no/such/scene.toml: "), "{message}");
    assert!(message.contains("cannot be read"), "{message}");
    assert!(message.contains("readable TOML scene file"), "{message}");
}

#[test]
fn directory_instead_of_file() {
    let error = SceneFile::read(&std::env::temp_dir()).expect_err("a directory");
    assert!(error.to_string().contains("cannot be read"), "{error}");
}

#[test]
fn not_utf8() {
    let path = file_with("not-utf8", b"format = 1\ntitle = \"caf\xe9\"\n");
    let error = SceneFile::read(&path).expect_err("Latin-1 text");
    fs::remove_file(&path).expect("the file was written");
    let message = error.to_string();
    assert!(message.contains(":2: byte 23 is not UTF-8"), "{message}");
}

#[test]
fn empty_file() {
    assert_says(
        &refusal_of(""),
        &["format", "the file is empty", "`format = 1`"],
    );
}

#[test]
fn truncated_file() {
    let cut_short = &GOOD[..GOOD.len() - 20];
    assert_says(
        &refusal_of(cut_short),
        &["demo.toml:32:34:", "unclosed inline table", "expected `}`"],
    );
    let without_objects = &GOOD[..GOOD.find("[[objects]]").expect("it is there")];
    assert_says(
        &refusal_of(without_objects),
        &["objects", "no object", "at least one `[[objects]]`"],
    );
}

#[test]
fn every_truncation_is_refused_or_a_scene() {
    for end in 0..GOOD.len() {
        if let Err(error) = SceneFile::parse(&GOOD[..end], "demo.toml") {
            assert_says(&error.to_string(), &[]);
        }
    }
}

#[test]
fn missing_and_wrong_version() {
    check(
        "format = 1\n",
        "",
        &["version of the format is missing", "`format = 1`"],
    );
    check(
        "format = 1",
        "format = 2",
        &["version 2 is not known", "`format = 1`"],
    );
    check("format = 1", "format = \"1\"", &["version", "`format = 1`"]);
}

#[test]
fn unknown_key() {
    check(
        "radius = 1",
        "radios = 1",
        &["demo.toml:", "unknown field `radios`", "`radius`"],
    );
    check(
        "title =",
        "titel =",
        &["demo.toml:2:1:", "unknown field `titel`", "`title`"],
    );
    check(
        "eye =",
        "eyes =",
        &["demo.toml:", "unknown field `eyes`", "`eye`"],
    );
    check(
        "colour = [0.8",
        "color = [0.8",
        &["demo.toml:23:1:", "unknown field `color`", "`colour`"],
    );
    check(
        "{ scale = 2 }",
        "{ skale = 2 }",
        &["demo.toml:31:", "unknown field `skale`", "`scale`"],
    );
    check("from =", "form =", &["unknown field `form`", "`from`"]);
    check(
        ", height = 48",
        ", heigth = 48",
        &["demo.toml:5:", "unknown field `heigth`", "`height`"],
    );
}

#[test]
fn missing_key() {
    check("view_height = 4\n", "", &["missing field `view_height`"]);
    check(
        "radius = 1\n",
        "",
        &["object `ball`", "needs `radius`, one number"],
    );
    check(
        "viewer_distance = 10\n",
        "",
        &["a perspective camera needs `viewer_distance`"],
    );
    check(
        "from = [0, 1, 1]\n",
        "",
        &["a directional light needs `from`"],
    );
}

#[test]
fn key_of_another_kind() {
    check(
        "radius = 1",
        "radii = [1, 1, 1]",
        &["object `ball`", "no `radii`", "it takes `radius`"],
    );
    check(
        "kind = \"directional\"",
        "kind = \"point\"",
        &["a point light has no `from`", "`position`"],
    );
    check(
        "viewer_distance = 10",
        "half_depth = 10",
        &[
            "a perspective camera has no `half_depth`",
            "`viewer_distance`",
        ],
    );
}

#[test]
fn wrong_type() {
    check(
        "radius = 1",
        "radius = \"big\"",
        &["demo.toml:29:10:", "string \"big\"", "expected a number"],
    );
    check(
        "eye = [0, 0, 10]",
        "eye = [0, 10]",
        &["demo.toml:9:", "2 numbers found", "3 numbers"],
    );
    check(
        "eye = [0, 0, 10]",
        "eye = [0, 0, 10, 1]",
        &["demo.toml:9:", "4 numbers found", "3 numbers"],
    );
    check(
        "eye = [0, 0, 10]",
        "eye = 10",
        &["demo.toml:9:", "integer `10`", "array of numbers"],
    );
    check(
        "width = 64",
        "width = -64",
        &["demo.toml:5:", "-64", "a whole number"],
    );
    check(
        "exponent = 20",
        "exponent = 20.5",
        &["20.5", "a whole number"],
    );
    check(
        "{ scale = 2 }",
        "{ scale = [2, 2] }",
        &["2 numbers found", "one number or [x, y, z]"],
    );
    check(
        "axis = \"y\"",
        "axis = \"w\"",
        &["\"w\"", "\"x\", \"y\", \"z\" or a vector"],
    );
}

#[test]
fn steps_are_one_to_a_table() {
    check(
        "{ scale = 2 }",
        "{ scale = 2, translate = [1, 0, 0] }",
        &["demo.toml:31:", "several steps in one table", "its own { }"],
    );
    check(
        "{ scale = 2 }",
        "{}",
        &[
            "demo.toml:31:",
            "the step is empty",
            "`translate`, `rotate`, `scale`",
        ],
    );
}

#[test]
fn radii_of_the_wrong_length() {
    check(
        "kind = \"sphere\"\nradius = 1",
        "kind = \"elliptic_cylinder\"\nradii = [1, 2, 3]",
        &[
            "object `ball`",
            "the two numbers A and C",
            "found 3 numbers",
        ],
    );
}

#[test]
fn unknown_kind() {
    check(
        "kind = \"sphere\"",
        "kind = \"torus\"",
        &["unknown variant `torus`", "`sphere`", "`cone`"],
    );
    check(
        "kind = \"perspective\"",
        "kind = \"fisheye\"",
        &["unknown variant `fisheye`", "`orthographic`"],
    );
}

#[test]
fn not_a_number() {
    check(
        "radius = 1",
        "radius = nan",
        &["object `ball`, radius", "NaN", "finite number"],
    );
    check(
        "eye = [0, 0, 10]",
        "eye = [0, inf, 10]",
        &["camera.eye[1]", "inf", "finite number"],
    );
    check(
        "intensity = 1",
        "intensity = -inf",
        &["lights[0].intensity", "-inf", "finite number"],
    );
    check(
        "degrees = 30",
        "degrees = nan",
        &["object `ball`, place[1].rotate.degrees", "NaN"],
    );
    check(
        "point = [0, 0.5, 0]",
        "point = [0, nan, 0]",
        &["object `ball`, cuts[0].point[1]", "NaN"],
    );
}

#[test]
fn absurdly_large_number() {
    check(
        "radius = 1",
        "radius = 1e300",
        &["object `ball`, radius", "1e300", "1e12"],
    );
}

#[test]
fn radius_not_positive() {
    check(
        "radius = 1",
        "radius = 0",
        &["object `ball`, radius", "0 is not positive", "above 0"],
    );
    check(
        "kind = \"sphere\"\nradius = 1",
        "kind = \"ellipsoid\"\nradii = [1, -2, 3]",
        &["object `ball`, radii[1]", "-2 is not positive", "above 0"],
    );
}

#[test]
fn zero_direction() {
    check(
        "normal = [0, 1, 0]",
        "normal = [0, 0, 0]",
        &["object `ball`, cuts[0].normal", "no direction"],
    );
    check(
        "from = [0, 1, 1]",
        "from = [0, 0, 0]",
        &["lights[0].from", "no direction"],
    );
    check(
        "axis = \"y\"",
        "axis = [0, 0, 0]",
        &["object `ball`, place[1].rotate.axis", "no direction"],
    );
    check(
        "up = [0, 1, 0]",
        "up = [0, 0, 0]",
        &["camera.up", "no direction"],
    );
}

#[test]
fn singular_transform() {
    check(
        "scale = 2",
        "scale = 0",
        &["object `ball`, place[0].scale", "singular", "other than 0"],
    );
    check(
        "scale = 2",
        "scale = [1, 0, 1]",
        &["object `ball`, place[0].scale", "singular", "other than 0"],
    );
}

#[test]
fn duplicate_names() {
    let twice = format!(
        "{GOOD}\n[[objects]]\nname = \"ball\"\nkind = \"sphere\"\nradius = 2\nmaterial = \"clay\"\n"
    );
    assert_says(&refusal_of(&twice), &["object `ball`", "taken", "unique"]);
    let materials = format!("{GOOD}\n[[materials]]\nname = \"clay\"\ncolour = [1, 1, 1]\n");
    assert_says(
        &refusal_of(&materials),
        &["material `clay`", "taken", "unique"],
    );
}

#[test]
fn empty_name() {
    check(
        "name = \"ball\"",
        "name = \" \"",
        &["objects[0].name", "empty", "a name is needed"],
    );
    check(
        "name = \"clay\"",
        "name = \"\"",
        &["materials[0].name", "empty", "a name is needed"],
    );
}

#[test]
fn unknown_material() {
    check(
        "material = \"clay\"",
        "material = \"clya\"",
        &["object `ball`, material", "`clya`", "`clay`"],
    );
}

#[test]
fn camera_without_direction() {
    check(
        "target = [0, 0, 0]",
        "target = [0, 0, 10]",
        &["camera.target", "the eye itself", "away from the eye"],
    );
    check(
        "up = [0, 1, 0]",
        "up = [0, 0, -3]",
        &["camera.up", "parallel", "upwards"],
    );
}

#[test]
fn camera_without_window() {
    check(
        "viewer_distance = 10",
        "viewer_distance = 0",
        &["camera.viewer_distance", "not positive", "above 0"],
    );
    check(
        "view_height = 4",
        "view_height = -4",
        &["camera.view_height", "-4 is not positive"],
    );
    let orthographic = GOOD
        .replacen("\"perspective\"", "\"orthographic\"", 1)
        .replacen("viewer_distance = 10", "half_depth = 0", 1);
    assert_says(
        &refusal_of(&orthographic),
        &["camera.half_depth", "0 is not positive"],
    );
}

#[test]
fn out_of_range() {
    check(
        "colour = [0.8, 0.4, 0.3]",
        "colour = [204, 102, 77]",
        &["material `clay`, colour[0]", "204", "0 to 1", "255"],
    );
    check(
        "background = [0, 0, 0]",
        "background = [0, 0, -0.1]",
        &["background[2]", "-0.1", "0 to 1"],
    );
    check(
        "exponent = 20",
        "exponent = 0",
        &["material `clay`, exponent", "0 is out of range", "1 to 200"],
    );
    check(
        "exponent = 20",
        "exponent = 201",
        &["material `clay`, exponent", "201", "1 to 200"],
    );
    check(
        "exponent = 20",
        "diffuse = 1.5",
        &["material `clay`, diffuse", "1.5", "0 to 1"],
    );
    check(
        "intensity = 1",
        "intensity = 11",
        &["lights[0].intensity", "11", "0 to 10"],
    );
}

#[test]
fn too_many_cuts() {
    let cut = "{ point = [0, 0.5, 0], normal = [0, 1, 0] }";
    let thirteen = vec![cut; 13].join(", ");
    check(
        cut,
        &thirteen,
        &["object `ball`, cuts", "13 cut planes", "at most 12"],
    );
}

#[test]
fn too_many_lights() {
    let lights = "[[lights]]\nkind = \"point\"\nposition = [1, 2, 3]\n".repeat(16);
    assert_says(
        &refusal_of(&format!("{GOOD}\n{lights}")),
        &["lights", "17 lights", "at most 16"],
    );
}

#[test]
fn quadric_without_second_degree() {
    let quadric = |coefficients: &str| {
        refusal(
            "kind = \"sphere\"\nradius = 1",
            &format!("kind = \"quadric\"\ncoefficients = {coefficients}"),
        )
    };
    assert_says(
        &quadric("[0, 0, 0, 0, 0, 0, 0, 0, 0, 0]"),
        &["object `ball`, coefficients", "all ten are zero", "a to f"],
    );
    assert_says(
        &quadric("[0, 0, 0, 0, 0, 0, 1, 2, 3, 4]"),
        &["object `ball`, coefficients", "leaves a plane", "a to f"],
    );
    assert_says(
        &quadric("[1, 1, 1]"),
        &["object `ball`", "the ten numbers a to j", "found 3 numbers"],
    );
}

#[test]
fn image_size() {
    check(
        "width = 64",
        "width = 0",
        &["image.width", "0 pixels", "1 to 4096"],
    );
    check(
        "height = 48",
        "height = 4097",
        &["image.height", "4097 pixels", "1 to 4096"],
    );
    let scene = SceneFile::parse(GOOD, "demo.toml").expect("a good scene");
    let message = scene.frame(5000, 10).expect_err("too wide").to_string();
    assert!(message.contains("image.width: 5000 pixels"), "{message}");
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
    let page = include_str!("../../docs/scene-format.md");
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
