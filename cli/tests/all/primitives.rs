//! `imogene primitives`: the page is what the command prints, and the figures are those of the sources.

use crate::common::{imogene, said};
use serde_json::Value;
use std::path::{Path, PathBuf};

fn docs(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("../docs")
        .join(name)
}

fn run(arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = imogene().arg("compare").args(arguments).output().unwrap();
    said(output)
}

fn variant<'a>(report: &'a Value, name: &str) -> &'a Value {
    let variants = report["variants"].as_array().unwrap();
    let found = variants.iter().find(|v| v["variant"] == name);
    found.unwrap_or_else(|| panic!("no {name}"))
}

fn figure(value: &Value, path: &str) -> f64 {
    let found = value.pointer(path).and_then(Value::as_f64);
    found.unwrap_or_else(|| panic!("no {path} in {value}"))
}

#[test]
fn the_page_and_its_picture_are_what_the_command_makes() {
    let folder = tempfile::tempdir().unwrap();
    let (code, out, error) = run(&["--json", "--out", folder.path().to_str().unwrap()]);
    assert_eq!(code, Some(0), "{error}");
    let made = |name: &str| std::fs::read(folder.path().join(name)).unwrap();
    let page = std::fs::read_to_string(docs("comparison.md")).unwrap();
    let tables = String::from_utf8(made("comparison.md")).unwrap();
    assert!(
        page.contains(tables.trim()),
        "docs/comparison.md does not hold what the command prints:\n{tables}"
    );
    let picture = made("comparison.png");
    assert!(picture.len() < 250_000, "{} bytes", picture.len());
    assert!(
        picture == std::fs::read(docs("images/comparison.png")).unwrap(),
        "docs/images/comparison.png is not what the command draws"
    );
    let report: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(
        serde_json::from_slice::<Value>(&made("comparison.json")).unwrap(),
        report
    );
    assert_figures(&report);
}

fn assert_figures(report: &Value) {
    // A sphere by a paraboloid, with pixels exactly on its outline.
    let paraboloids = variant(report, "paraboloids");
    let near = |path: &str, wanted: f64, within: f64| {
        let found = figure(paraboloids, path);
        assert!((found - wanted).abs() < within, "{path}: {found}");
    };
    near("/bulges/0/most_percent", 29.45, 0.01);
    near("/bulges/0/least_percent", -4.50, 0.01);
    // Pixels sample the steep outline coarsely.
    near("/bulges/0/rms_percent", 5.08, 0.12);
    near("/bulges/0/normal_mean_deg", 1.6, 0.05);
    near("/bulges/0/normal_max_deg", 16.4, 0.05);
    near("/errors/presence_differs", 0.0, 0.5);
    // Quadrics: one pixel on the edge of an end, depth to the rounding of the words.
    let quadrics = variant(report, "quadrics");
    assert_eq!(figure(quadrics, "/errors/presence_differs"), 1.0);
    assert_eq!(figure(quadrics, "/errors/object_differs"), 0.0);
    assert!(figure(quadrics, "/errors/depth_max_words") < 52.9);
    assert_eq!(figure(quadrics, "/hardware/processors"), 3.0);
    assert_eq!(figure(quadrics, "/hardware/roots"), 3.0);
    // The more facets, the better and the more.
    let facets = ["facets_8", "facets_20", "facets_fair"].map(|name| variant(report, name));
    for (path, grows) in [
        ("/errors/presence_differs", false),
        ("/errors/depth_rms_px", false),
        ("/hardware/processors", true),
        ("/hardware/pe1", true),
    ] {
        let [coarse, finer, _] = facets.map(|v| figure(v, path));
        assert_eq!(coarse < finer, grows, "{path}: {coarse} {finer}");
    }
    for facets in facets {
        let work = &facets["facet_work"];
        assert_eq!(
            figure(work, "/contour/pixel_additions"),
            5.0 * figure(work, "/contour/pixels")
        );
        assert!(figure(work, "/contour/line_additions") < figure(work, "/processor_box_additions"));
    }
    assert!(figure(report, "/speed/ratio") > 0.0);
}

#[test]
fn bad_input_is_refused_and_writes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let obstacle = folder.path().join("obstacle");
    std::fs::write(&obstacle, "x").unwrap();
    let blocked = obstacle.join("out");
    let fresh = folder.path().join("fresh");
    let text = |path: &Path| path.to_str().unwrap().to_owned();
    for (size, out, wanted) in [
        ("16x12", text(&blocked), ["cannot write", "obstacle"]),
        ("0x12", text(&fresh), ["0", "4096"]),
        ("12x0", text(&fresh), ["0", "4096"]),
        ("12", text(&fresh), ["12", "WIDTHxHEIGHT"]),
    ] {
        let (code, _, error) = run(&["--size", size, "--out", &out]);
        assert_eq!(code, Some(2), "{size}: {error}");
        assert!(!error.contains("panicked"), "{error}");
        for part in wanted {
            assert!(error.contains(part), "no '{part}' in: {error}");
        }
        assert!(!fresh.exists());
    }
}
