//! `imogene sweep`: tables, figures, plots, refusals.

use crate::common::{Place, json, rows, run};
use serde_json::Value;

#[test]
fn a_table_shows_bounds_errors_and_where_the_format_gives_out() {
    let text = run("sweep steep-plane").ended(0).out;
    assert!(text.starts_with("## A cut plane turns perpendicular to the screen (`steep-plane`)"));
    for essential in [
        "depth bound, words | observed",
        "| 0.00001 to 0.000000001 | refused |",
        "refused from 0.00001 to 0.000000001 (0.0001 is accepted)",
        "object 'ball', cut 0: the plane passes so nearly through the viewer",
    ] {
        assert!(text.contains(essential), "{essential}");
    }
    assert!(!text.contains("VIOLATION"));
}

#[test]
fn records_have_the_keys_that_scripts_rely_on() {
    let report = json("sweep viewer-distance");
    let sweep = &report["sweeps"][0];
    assert_eq!(sweep["name"], "viewer-distance");
    assert_eq!(sweep["depth_word"], 24);
    assert_eq!(sweep["violations"], Value::Array(vec![]));
    let records = sweep["records"].as_array().unwrap();
    let refused = &records[0];
    assert_eq!(refused["parameter"], "20");
    let reason = refused["refused"].as_str().unwrap();
    assert!(reason.contains("object 'ball'"));
    assert!(refused["figures"].is_null());
    let drawn = records.iter().find(|r| r["parameter"] == "1000").unwrap();
    let figures = &drawn["figures"];
    let errors = "depth_words depth_px silhouette_px normal_deg";
    for (group, keys) in [
        ("bounds", errors),
        ("observed", errors),
        ("observed", "silhouette_pixels wrong_faces compared"),
        ("ratios", "depth silhouette normal"),
    ] {
        for key in keys.split(' ') {
            assert!(figures[group][key].is_number(), "{group}.{key}");
        }
    }
    assert!(figures["undecided"].is_u64() && figures["words_per_pixel"].is_f64());
    let run = &sweep["gives_out"][0];
    assert_eq!(run["by"], "refused");
    assert_eq!(run["last"], "28");
}

#[test]
fn plots_figures_and_sections_are_written_once_for_each_sweep() {
    let place = Place::new();
    let line = "sweep sphere-radius sphere-radius --format 16 --out .";
    let text = place.run(line).ended(0).out;
    assert_eq!(text.matches("(`sphere-radius`)").count(), 1);
    let files = ["sphere-radius.svg", "sweeps.json", "sweeps.md"];
    assert_eq!(place.names(), files);
    let picture = place.text("sphere-radius.svg");
    for essential in [
        "<svg",
        "The radius of a sphere (depth word of 16 bits)",
        "radius (pixels)",
        "silhouette displacement (pixels)",
        "normal error (degrees)",
        "perspective, viewer at 3000 px",
    ] {
        assert!(picture.contains(essential), "{essential}");
    }
    let figures: Value = serde_json::from_str(&place.text("sweeps.json")).unwrap();
    assert_eq!(figures[0]["depth_word"], 16);
    let page = place.text("sweeps.md");
    assert!(page.contains("](sphere-radius.svg)"));
    assert!(page.contains("imogene sweep sphere-radius --format 16"));
}

#[test]
fn unknown_names_formats_and_folders_are_bad_input() {
    let place = Place::new();
    place.write("file", "");
    let cases = "
        steep-plane steep          | no sweep `steep` | cylinder-axis, eye-distance | word-length
        thin --format 33           | 8 to 32
        steep-plane --out file/sub | file
    ";
    for row in rows(cases) {
        let run = place.run(&format!("sweep {}", row[0]));
        assert_eq!(run.refused(&row[1..]).out, "");
    }
}
