//! `imogene primitives`: the page is what the command prints, and the figures are those of the sources.

use crate::common::{Place, repository};
use serde_json::Value;

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
    let place = Place::new();
    let report = place.json("compare --out .");
    let page = std::fs::read_to_string(repository("docs/comparison.md")).unwrap();
    let tables = place.text("comparison.md");
    let lacks = "docs/comparison.md does not hold what the command prints";
    assert!(page.contains(tables.trim()), "{lacks}:\n{tables}");
    let picture = place.bytes("comparison.png");
    assert!(picture.len() < 250_000, "{} bytes", picture.len());
    let shown = "docs/images/comparison.png";
    let is_same = picture == std::fs::read(repository(shown)).unwrap();
    assert!(is_same, "{shown} is not what the command draws");
    let figures: Value = serde_json::from_str(&place.text("comparison.json")).unwrap();
    assert_eq!(figures, report);
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
        let wanted = 5.0 * figure(work, "/contour/pixels");
        assert_eq!(figure(work, "/contour/pixel_additions"), wanted);
        assert!(figure(work, "/contour/line_additions") < figure(work, "/processor_box_additions"));
    }
    assert!(figure(report, "/speed/ratio") > 0.0);
}

#[test]
fn bad_input_is_refused_and_writes_nothing() {
    let place = Place::new();
    place.write("obstacle", "x");
    for (size, out, wanted) in [
        ("16x12", "obstacle/out", ["cannot write", "obstacle"]),
        ("0x12", "fresh", ["0", "4096"]),
        ("12x0", "fresh", ["0", "4096"]),
        ("12", "fresh", ["12", "WIDTHxHEIGHT"]),
    ] {
        let line = format!("compare --size {size} --out {out}");
        place.run(&line).refused(&wanted);
        assert!(!place.has("fresh"));
    }
}
