//! `imogene raytrace`, `cracks` and `repair`.

use crate::common::{HEAD, Place, SHEET, json, repository, run};
use serde_json::Value;

/// A folder with a scene in it that cannot be drawn.
fn place() -> Place {
    let place = Place::new();
    place.write("sheet.toml", format!("{HEAD}{SHEET}"));
    place
}

#[test]
fn scenes_are_traced_and_refusals_are_listed() {
    let place = place();
    let options = "--size 80x60 --out pictures --table table.md";
    let value = place.json(&format!("trace scenes/teapot.toml sheet.toml {options}"));
    assert_eq!(value["holds"], true);
    let found = &value["scenes"][0]["comparison"];
    assert_eq!(found["pixels"], 4800);
    assert_eq!(found["differences_outside"], 0);
    assert!(found["band"].as_u64() > Some(100) && found["depths"].as_u64() > Some(1000));
    let refused = value["scenes"][1]["refused"].as_str().expect("a reason");
    assert!(refused.contains("object '"));
    place.assert_files(&value);
    let rows = place.text("table.md");
    assert_eq!(rows.lines().count(), 4);
    assert!(rows.contains("teapot.toml | 80 x 60 |") && rows.contains("| refused |"));
}

/// The words of this scene are too short for it: its check fails, and announces every pixel that differs beyond the
/// band.
#[test]
fn what_the_check_announces_is_no_surprise() {
    let value = json("trace scenes/extremes/flat-as-a-leaf.toml");
    let found = &value["scenes"][0]["comparison"];
    assert!(found["announced"].as_u64() > Some(10), "{found}");
    assert_eq!(found["differences_outside"], 0);
    run("check scenes/extremes/flat-as-a-leaf.toml").ended(1);
}

#[test]
fn what_cannot_be_traced_is_refused_and_leaves_nothing() {
    let place = place();
    let ball = "scenes/ellipsoid.toml";
    for (line, part) in [
        ("trace no.toml", "no.toml"),
        ("trace sheet.toml -o picture.png", "vertex 2"),
        ("trace BALL BALL -o picture.png", "--out"),
        ("trace BALL --size 0x5 -o picture.png", "4096"),
        ("cracks BALL --min-distance=-1", "above 0"),
        ("cracks BALL --width 9", "1..=8"),
        ("repair BALL --format 33", "8 to 32"),
    ] {
        place.run(&line.replace("BALL", ball)).refused(&[part]);
    }
    assert!(!place.has("picture.png"));
}

#[test]
fn cracks_are_searched_for_and_made() {
    let place = Place::new();
    let value = place.json("cracks scenes/ellipsoid.toml --size 160x120 -o cracks.png");
    assert_eq!(value["cracks"].as_array().expect("a list").len(), 0);
    assert!(place.has("cracks.png"));
    let inject = "--size 160x120 --inject 40 --seed 5 --plot cracks.svg";
    let value = place.json(&format!("cracks scenes/teapot.toml {inject}"));
    let drawn = place.text("cracks.svg");
    // A line for each sort in each of three panels, and the axes.
    assert!(drawn.starts_with("<svg") && drawn.matches("<polyline").count() >= 9);
    let scores = value["scores"].as_array().expect("scores");
    assert_eq!(scores.len(), 27);
    let sum = |key: &str| {
        let counts = scores.iter().map(|s| s[key].as_u64().expect("a count"));
        counts.sum::<u64>()
    };
    assert_eq!(sum("deep"), sum("deep_found"));
    assert!(sum("deep") > 300 && sum("made") > sum("deep"));
}

/// Flagged are gaps between parts at most: what cells of a divided face, faces of a part and cells of terrain have in
/// common has the same words in each.
#[test]
fn the_teapot_parts_and_terrain_have_no_cracks() {
    let mut files = vec![repository("scenes/teapot.toml")];
    for folder in ["scenes/cad", "scenes/terrain"] {
        let entries = std::fs::read_dir(repository(folder)).expect("a folder");
        let paths = entries.map(|entry| entry.expect("an entry").path());
        files.extend(paths.filter(|path| path.extension().is_some_and(|e| e == "toml")));
    }
    assert!(files.len() >= 10);
    for file in files {
        let value = json(&format!("cracks {}", file.display()));
        let found = value["cracks"].as_array().expect("a list");
        let is_open = |c: &Value| c["notch"] == true || c["opening"] == true;
        assert!(found.iter().all(is_open), "{}", file.display());
    }
}

#[test]
fn short_words_are_repaired_to_the_exact_picture() {
    let place = Place::new();
    let repair = "repair scenes/teapot.toml";
    let options = "--size 160x120 --format 16 -o picture.png --map map.png";
    let value = place.json(&format!("{repair} {options}"));
    assert_eq!(value["exact"]["differing_after"], 0);
    assert!(value["exact"]["differing_before"].as_u64() > Some(0));
    assert_eq!(value["leaves_the_rest"], true);
    let share = value["share"].as_f64().expect("a share");
    assert!(share > 0.0 && share < 0.1, "{share}");
    assert!(place.has("picture.png") && place.has("map.png"));
    let value = place.json(&format!("{repair} --size 80x60 --unchecked"));
    assert_eq!(value["exact"], Value::Null);
}
