//! An object that cannot be drawn costs itself, not the picture.

use crate::common::{HEAD, Place, SHEET};

const BALL: &str = r#"
[[objects]]
name = "ball"
material = "m"
kind = "sphere"
radius = 1
"#;

/// A folder with a scene of these objects in it.
fn place(objects: &[&str]) -> Place {
    let place = Place::new();
    place.write("scene.toml", format!("{HEAD}{}", objects.concat()));
    place
}

/// What is done about the sheet, and how a command ends.
const POLICIES: [(&str, i32); 3] = [("", 1), ("--allow-missing", 0), ("--strict", 2)];

#[test]
fn the_rest_is_drawn_and_the_exit_code_says_so() {
    let place = place(&[BALL, SHEET]);
    for (flag, code) in POLICIES {
        let drawn = place.run(&format!("render scene.toml -o picture.png {flag}"));
        drawn.ended(code).says(&["'sheet'", "vertex 2"]);
        assert_eq!(place.has("picture.png"), code != 2, "{flag}");
        let _ = std::fs::remove_file(place.path("picture.png"));
    }
    for command in "check prepare cosim detail raytrace cracks".split(' ') {
        for (flag, code) in POLICIES {
            let run = place.run(&format!("{command} scene.toml {flag}"));
            run.ended(code).says(&["'sheet'"]);
        }
    }
}

#[test]
fn a_scene_of_which_nothing_is_left_is_refused() {
    let place = place(&[SHEET]);
    for (flag, _) in POLICIES {
        place.run(&format!("check scene.toml {flag}")).ended(2);
    }
}

/// What the depth range is, as exact numbers: a word of the picture is turned back into the distance at which the
/// ball is.
#[test]
fn a_depth_word_can_be_turned_back_into_a_distance() {
    let place = place(&[BALL, SHEET]);
    let report = place.json("--allow-missing check scene.toml");
    let range = &report["range"];
    assert_eq!(range["far"], serde_json::Value::Null);
    let near: f64 = range["near_units"].as_f64().unwrap();
    assert!(near > 0.0 && near <= 9.0, "{range}");
    let product = range["distance"].as_str().unwrap();
    assert!(product.ends_with("/ (8388607 - w)"), "{product}");
    place.json("--allow-missing render scene.toml -o p.png --depth depth.npy");
    let bytes = place.bytes("depth.npy");
    let words = bytes[bytes.len() - 32 * 24 * 8..].chunks(8);
    let words = words.map(|w| i64::from_le_bytes(w.try_into().unwrap()));
    let words: Vec<i64> = words.collect();
    // The middle pixel looks at the nearest point of the ball, 9 units away.
    let word = words[12 * 32 + 16] as f64;
    let distance = 2.0 * near * 8_388_607.0 / (8_388_607.0 - word);
    assert!((distance - 9.0).abs() < 1e-4, "{distance}");
}
