//! `imogene raytrace`, `cracks` and `repair`.

use crate::common::{imogene, scene};
use serde_json::Value;
use std::path::Path;

/// Runs the program; its exit code, its standard output and what it says.
fn run(arguments: &[&str]) -> (Option<i32>, Vec<u8>, String) {
    let output = imogene()
        .args(arguments)
        .output()
        .expect("the program runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    (output.status.code(), output.stdout, said)
}

fn json(arguments: &[&str], code: i32) -> Value {
    let (found, out, said) = run(&[arguments, &["--json"]].concat());
    assert_eq!(found, Some(code), "{said}");
    serde_json::from_slice(&out).expect("one JSON document")
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a plain path")
}

/// A scene that cannot be drawn: a mesh of which a corner is behind the viewer.
fn sheet_behind_the_viewer(folder: &Path) -> std::path::PathBuf {
    let path = folder.join("sheet.toml");
    let scene = "format = 1\ntitle = \"t\"\nimage = { width = 32, height = 24 }\n[camera]\nkind = \"perspective\"\neye = [0, 0, 10]\n\
        target = [0, 0, 0]\nfield_of_view = 30\n[[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n[[objects]]\nname = \"sheet\"\n\
        material = \"m\"\nkind = \"mesh\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 0, 20]]\nfaces = [[0, 1, 2]]\n";
    std::fs::write(&path, scene).expect("written");
    path
}

#[test]
fn scenes_are_traced_and_refusals_are_listed() {
    let folder = tempfile::tempdir().expect("a folder");
    let (out, table) = (
        folder.path().join("pictures"),
        folder.path().join("table.md"),
    );
    let (teapot, refused) = (scene("teapot.toml"), sheet_behind_the_viewer(folder.path()));
    let value = json(
        &[
            "trace",
            text(&teapot),
            text(&refused),
            "--size",
            "80x60",
            "--out",
            text(&out),
            "--table",
            text(&table),
        ],
        0,
    );
    assert_eq!(value["holds"], true);
    let found = &value["scenes"][0]["comparison"];
    assert_eq!(
        (&found["pixels"], &found["differences_outside"]),
        (&4800.into(), &0.into())
    );
    assert!(found["band"].as_u64() > Some(100) && found["depths"].as_u64() > Some(1000));
    assert!(
        value["scenes"][1]["refused"]
            .as_str()
            .expect("a reason")
            .contains("object '")
    );
    for file in value["files"].as_array().expect("files") {
        assert!(
            Path::new(file.as_str().expect("a path")).is_file(),
            "{file}"
        );
    }
    let rows = std::fs::read_to_string(&table).expect("the table");
    assert_eq!(rows.lines().count(), 4);
    assert!(rows.contains("teapot.toml | 80 x 60 |") && rows.contains("| refused |"));
}

/// The words of this scene are too short for it: its check fails, and announces every pixel that differs beyond the
/// band.
#[test]
fn what_the_check_announces_is_no_surprise() {
    let leaf = scene("extremes/flat-as-a-leaf.toml");
    let value = json(&["trace", text(&leaf)], 0);
    let found = &value["scenes"][0]["comparison"];
    assert!(found["announced"].as_u64() > Some(10), "{found}");
    assert_eq!(found["differences_outside"], 0);
    assert_eq!(run(&["check", text(&leaf)]).0, Some(1));
}

#[test]
fn what_cannot_be_traced_is_refused_and_leaves_nothing() {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = folder.path().join("picture.png");
    let (ball, refused) = (
        scene("ellipsoid.toml"),
        sheet_behind_the_viewer(folder.path()),
    );
    let cases: [(&[&str], &str); 7] = [
        (&["trace", "no.toml"], "no.toml"),
        (&["trace", text(&refused), "-o", text(&picture)], "vertex 2"),
        (
            &["trace", text(&ball), text(&ball), "-o", text(&picture)],
            "--out",
        ),
        (
            &["trace", text(&ball), "--size", "0x5", "-o", text(&picture)],
            "4096",
        ),
        (&["cracks", text(&ball), "--min-distance=-1"], "above 0"),
        (&["cracks", text(&ball), "--width", "9"], "1..=8"),
        (&["repair", text(&ball), "--format", "33"], "8 to 32"),
    ];
    for (arguments, says) in cases {
        let (code, _, said) = run(arguments);
        assert_eq!(code, Some(2), "{arguments:?}: {said}");
        assert!(said.contains(says), "{arguments:?}: {said}");
    }
    assert!(!picture.exists());
}

#[test]
fn cracks_are_searched_for_and_made() {
    let folder = tempfile::tempdir().expect("a folder");
    let [picture, plot] = ["cracks.png", "cracks.svg"].map(|name| folder.path().join(name));
    let (ball, teapot) = (scene("ellipsoid.toml"), scene("teapot.toml"));
    let value = json(
        &[
            "cracks",
            text(&ball),
            "--size",
            "160x120",
            "-o",
            text(&picture),
        ],
        0,
    );
    assert_eq!(value["cracks"].as_array().expect("a list").len(), 0);
    assert!(picture.is_file());
    let value = json(
        &[
            "cracks",
            text(&teapot),
            "--size",
            "160x120",
            "--inject",
            "40",
            "--seed",
            "5",
            "--plot",
            text(&plot),
        ],
        0,
    );
    let drawn = std::fs::read_to_string(&plot).expect("the plot");
    // A line for each sort in each of three panels, and the axes.
    assert!(drawn.starts_with("<svg") && drawn.matches("<polyline").count() >= 9);
    let scores = value["scores"].as_array().expect("scores");
    assert_eq!(scores.len(), 27);
    let sum = |key: &str| {
        scores
            .iter()
            .map(|s| s[key].as_u64().expect("a count"))
            .sum::<u64>()
    };
    assert_eq!(sum("deep"), sum("deep_found"));
    assert!(sum("deep") > 300 && sum("made") > sum("deep"));
}

/// Flagged are gaps between parts at most: what cells of a divided face, faces of a part and cells of terrain have in
/// common has the same words in each.
#[test]
fn the_teapot_parts_and_terrain_have_no_cracks() {
    let mut files = vec![scene("teapot.toml")];
    for folder in ["cad", "terrain"] {
        let entries = std::fs::read_dir(scene(folder)).expect("a folder");
        let paths = entries.map(|entry| entry.expect("an entry").path());
        files.extend(paths.filter(|path| path.extension().is_some_and(|e| e == "toml")));
    }
    assert!(files.len() >= 10);
    for file in files {
        let value = json(&["cracks", text(&file)], 0);
        let found = value["cracks"].as_array().expect("a list");
        let is_open = |c: &Value| c["notch"] == true || c["opening"] == true;
        assert!(found.iter().all(is_open), "{}", file.display());
    }
}

#[test]
fn short_words_are_repaired_to_the_exact_picture() {
    let folder = tempfile::tempdir().expect("a folder");
    let [picture, map] = ["picture.png", "map.png"].map(|name| folder.path().join(name));
    let teapot = scene("teapot.toml");
    let value = json(
        &[
            "repair",
            text(&teapot),
            "--size",
            "160x120",
            "--format",
            "16",
            "-o",
            text(&picture),
            "--map",
            text(&map),
        ],
        0,
    );
    assert_eq!(value["exact"]["differing_after"], 0);
    assert!(value["exact"]["differing_before"].as_u64() > Some(0));
    assert_eq!(value["leaves_the_rest"], true);
    let share = value["share"].as_f64().expect("a share");
    assert!(share > 0.0 && share < 0.1, "{share}");
    assert!(picture.is_file() && map.is_file());
    let value = json(
        &["repair", text(&teapot), "--size", "80x60", "--unchecked"],
        0,
    );
    assert_eq!(value["exact"], Value::Null);
}
