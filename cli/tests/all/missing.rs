//! An object that cannot be drawn costs itself, not the picture.

use crate::common::imogene;
use std::path::{Path, PathBuf};

/// A ball, and a mesh of which a corner is behind the viewer.
fn scene(folder: &Path, with_ball: bool) -> PathBuf {
    let ball = "[[objects]]\nname = \"ball\"\nmaterial = \"m\"\nkind = \"sphere\"\nradius = 1\n";
    let text = format!(
        "format = 1\ntitle = \"t\"\nimage = {{ width = 32, height = 24 }}\n[camera]\nkind = \"perspective\"\neye = [0, 0, 10]\n\
         target = [0, 0, 0]\nfield_of_view = 30\n[[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n{}\
         [[objects]]\nname = \"sheet\"\nmaterial = \"m\"\nkind = \"mesh\"\n\
         vertices = [[0, 0, 0], [1, 0, 0], [0, 0, 20]]\nfaces = [[0, 1, 2]]\n",
        if with_ball { ball } else { "" }
    );
    let path = folder.join("scene.toml");
    std::fs::write(&path, text).unwrap();
    path
}

fn run(command: &str, scene: &Path, flags: &[&str]) -> (Option<i32>, String) {
    let output = imogene()
        .arg(command)
        .arg(scene)
        .args(flags)
        .output()
        .unwrap();
    (
        output.status.code(),
        String::from_utf8(output.stderr).unwrap(),
    )
}

#[test]
fn the_rest_is_drawn_and_the_exit_code_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path(), true);
    let picture = folder.path().join("picture.png");
    let to = ["-o", picture.to_str().unwrap()];
    for (flags, code) in [
        (vec![], 1),
        (vec!["--allow-missing"], 0),
        (vec!["--strict"], 2),
    ] {
        let (found, message) = run("render", &scene, &[&to[..], &flags].concat());
        assert_eq!(found, Some(code), "{message}");
        assert!(
            message.contains("'sheet'") && message.contains("vertex 2"),
            "{message}"
        );
        assert_eq!(picture.exists(), code != 2, "{flags:?}");
        let _ = std::fs::remove_file(&picture);
    }
    for command in ["check", "prepare", "cosim", "detail", "raytrace", "cracks"] {
        for (flags, code) in [
            (vec![], 1),
            (vec!["--allow-missing"], 0),
            (vec!["--strict"], 2),
        ] {
            let (found, message) = run(command, &scene, &flags);
            assert_eq!(found, Some(code), "{command} {flags:?}: {message}");
            assert!(message.contains("'sheet'"), "{command}: {message}");
        }
    }
}

#[test]
fn a_scene_of_which_nothing_is_left_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path(), false);
    for flags in [vec![], vec!["--allow-missing"], vec!["--strict"]] {
        let (code, message) = run("check", &scene, &flags);
        assert_eq!(code, Some(2), "{message}");
    }
}

/// What the depth range is, as exact numbers: a word of the picture is turned back into the distance at which the
/// ball is.
#[test]
fn a_depth_word_can_be_turned_back_into_a_distance() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path(), true);
    let output = imogene()
        .args(["--json", "--allow-missing", "check"])
        .arg(&scene)
        .output()
        .unwrap();
    let report: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let range = &report["range"];
    assert_eq!(range["far"], serde_json::Value::Null);
    let near: f64 = range["near_units"].as_f64().unwrap();
    assert!(near > 0.0 && near <= 9.0, "{range}");
    let product = range["distance"].as_str().unwrap();
    assert!(product.ends_with("/ (8388607 - w)"), "{product}");
    let arrays = folder.path().join("depth.npy");
    let drawn = imogene()
        .args(["--allow-missing", "render"])
        .arg(&scene)
        .arg("-o")
        .arg(folder.path().join("p.png"))
        .arg("--depth")
        .arg(&arrays)
        .output()
        .unwrap();
    assert!(drawn.status.success());
    let bytes = std::fs::read(&arrays).unwrap();
    let words = bytes[bytes.len() - 32 * 24 * 8..].chunks(8);
    let words: Vec<i64> = words
        .map(|w| i64::from_le_bytes(w.try_into().unwrap()))
        .collect();
    // The middle pixel looks at the nearest point of the ball, 9 units away.
    let word = words[12 * 32 + 16] as f64;
    let distance = 2.0 * near * 8_388_607.0 / (8_388_607.0 - word);
    assert!((distance - 9.0).abs() < 1e-4, "{distance}");
}
