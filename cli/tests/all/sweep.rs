//! `imogene sweep`: tables, figures, plots, refusals.

use crate::common::imogene;
use serde_json::Value;

fn output(arguments: &[&str]) -> String {
    let output = imogene().arg("sweep").args(arguments).output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{arguments:?}: {message}");
    String::from_utf8(output.stdout).unwrap()
}

fn refused(arguments: &[&str]) -> String {
    let output = imogene().arg("sweep").args(arguments).output().unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn a_table_shows_bounds_errors_and_where_the_format_gives_out() {
    let text = output(&["steep-plane"]);
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
    let report: Value = serde_json::from_str(&output(&["viewer-distance", "--json"])).unwrap();
    let sweep = &report["sweeps"][0];
    assert_eq!(sweep["name"], "viewer-distance");
    assert_eq!(sweep["depth_word"], 24);
    assert_eq!(sweep["violations"], Value::Array(vec![]));
    let records = sweep["records"].as_array().unwrap();
    let refused = &records[0];
    assert_eq!(refused["parameter"], "20");
    assert!(
        refused["refused"]
            .as_str()
            .unwrap()
            .contains("object 'ball'")
    );
    assert!(refused["figures"].is_null());
    let drawn = records.iter().find(|r| r["parameter"] == "1000").unwrap();
    let figures = &drawn["figures"];
    for (group, keys) in [
        (
            "bounds",
            &["depth_words", "depth_px", "silhouette_px", "normal_deg"][..],
        ),
        (
            "observed",
            &["depth_words", "depth_px", "silhouette_px", "normal_deg"],
        ),
        (
            "observed",
            &["silhouette_pixels", "wrong_faces", "compared"],
        ),
        ("ratios", &["depth", "silhouette", "normal"]),
    ] {
        for key in keys {
            assert!(figures[group][key].is_number(), "{group}.{key}");
        }
    }
    assert!(figures["undecided"].is_u64() && figures["words_per_pixel"].is_f64());
    let run = &sweep["gives_out"][0];
    assert_eq!(
        (&run["by"], &run["last"]),
        (&"refused".into(), &"28".into())
    );
}

#[test]
fn plots_figures_and_sections_are_written_once_for_each_sweep() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new");
    let out_text = out.to_str().unwrap();
    let text = output(&[
        "sphere-radius",
        "sphere-radius",
        "--format",
        "16",
        "--out",
        out_text,
    ]);
    assert_eq!(text.matches("(`sphere-radius`)").count(), 1);
    let mut files: Vec<String> = std::fs::read_dir(&out)
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .collect();
    files.sort();
    assert_eq!(files, ["sphere-radius.svg", "sweeps.json", "sweeps.md"]);
    let read = |name: &str| std::fs::read_to_string(out.join(name)).unwrap();
    let picture = read("sphere-radius.svg");
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
    let figures: Value = serde_json::from_str(&read("sweeps.json")).unwrap();
    assert_eq!(figures[0]["depth_word"], 16);
    let page = read("sweeps.md");
    assert!(page.contains("](sphere-radius.svg)"));
    assert!(page.contains("imogene sweep sphere-radius --format 16"));
}

#[test]
fn unknown_names_and_formats_are_bad_input() {
    let message = refused(&["steep-plane", "steep"]);
    assert!(
        message.contains("no sweep `steep`") && message.contains("cylinder-axis, eye-distance")
    );
    assert!(message.contains("word-length"));
    assert!(refused(&["thin", "--format", "33"]).contains("8 to 32"));
}

#[test]
fn a_folder_that_cannot_be_made_is_bad_input() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    std::fs::write(&file, "").unwrap();
    let message = {
        let output = imogene()
            .args(["sweep", "steep-plane", "--out"])
            .arg(file.join("sub"))
            .output()
            .unwrap();
        assert_eq!(output.status.code(), Some(2));
        String::from_utf8(output.stderr).unwrap()
    };
    assert!(message.contains("file"), "{message}");
}
