//! The commands on real input: pictures, words, JSON keys that scripts rely on.

use crate::common::{COSIM_KEYS, assert_keys, json, scene};
use serde_json::Value;

#[test]
fn demo_draws_the_teapot_with_no_difference() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("demo");
    let summary = json(&["demo", "--out", out.to_str().unwrap()]);
    assert_keys(&summary, &COSIM_KEYS);
    assert_eq!(summary["mismatches"], 0);
    assert_eq!(summary["pixels"], 2 * 640 * 480 + 160 * 120);
    assert_eq!(summary["clocks_per_frame"], 800 * 525);
    for name in [
        "pins.png",
        "golden.png",
        "trace.vcd",
        "trace.gtkw",
        "beam_display.v",
        "summary.json",
    ] {
        assert!(out.join(name).is_file(), "no {name}");
    }
    let picture = std::fs::read(out.join("pins.png")).unwrap();
    assert_eq!(picture, std::fs::read(out.join("golden.png")).unwrap());
    let vcd = std::fs::read_to_string(out.join("trace.vcd")).unwrap();
    assert!(vcd.contains("processor_0") && vcd.contains("golden") && vcd.contains("hardware"));
    let written: Value =
        serde_json::from_slice(&std::fs::read(out.join("summary.json")).unwrap()).unwrap();
    assert_eq!(written["mismatches"], 0);
}

#[test]
fn three_models_draw_the_same_molecule() {
    let folder = tempfile::tempdir().unwrap();
    let molecule = scene("molecule.toml");
    let mut pictures = Vec::new();
    for model in ["golden", "rtl", "exact"] {
        let path = |name: &str| folder.path().join(format!("{model}-{name}"));
        let (png, depth, ids, normals) =
            (path("p.png"), path("d.npy"), path("i.npy"), path("n.npy"));
        let report = json(&[
            "render",
            molecule.to_str().unwrap(),
            "--model",
            model,
            "--size",
            "40x30",
            "-o",
            png.to_str().unwrap(),
            "--depth",
            depth.to_str().unwrap(),
            "--ids",
            ids.to_str().unwrap(),
            "--normals",
            normals.to_str().unwrap(),
        ]);
        assert_keys(
            &report,
            &["model", "width", "height", "seconds", "pixels_per_second"],
        );
        assert_eq!(report["width"], 40);
        let header = std::fs::read(&depth).unwrap();
        let text = String::from_utf8_lossy(&header[..80]).into_owned();
        assert!(text.contains("'<i8'") && text.contains("(30, 40"), "{text}");
        assert!(normals.is_file());
        pictures.push((std::fs::read(&png).unwrap(), std::fs::read(&ids).unwrap()));
    }
    assert_eq!(
        pictures[0], pictures[1],
        "golden and hardware pictures differ"
    );
    assert_eq!(
        pictures[0].1, pictures[2].1,
        "golden and exact object indices differ"
    );
}

#[test]
fn units_prepare_and_check_answer_in_json() {
    let units = json(&["units"]);
    let names: Vec<&str> = units
        .as_array()
        .unwrap()
        .iter()
        .map(|unit| unit["name"].as_str().unwrap())
        .collect();
    for name in ["pe1", "square_root", "quadric_processor", "decider", "beam"] {
        assert!(names.contains(&name), "no {name} in {names:?}");
    }
    let teapot = scene("teapot.toml");
    let prepared = json(&["prepare", teapot.to_str().unwrap(), "--size", "160x120"]);
    assert_eq!(prepared["objects"].as_array().unwrap().len(), 10);
    let checked = json(&["check", teapot.to_str().unwrap(), "--size", "160x120"]);
    assert_keys(&checked, &["objects", "bounds", "widths", "ok"]);
    assert_keys(
        &checked["bounds"],
        &["depth_lsb", "silhouette_px", "normal_deg"],
    );
    assert_keys(
        &checked["objects"][0],
        &[
            "name",
            "kind",
            "class",
            "problems",
            "shows",
            "visible_pixels",
            "front_view",
            "prism",
            "degenerate",
            "highlights",
            "perpendicular_planes",
            "planes_without_effect",
        ],
    );
    let accumulators = &checked["objects"][0]["accumulators"];
    assert_keys(
        accumulators,
        &["f1", "f2", "f1_minus_r", "root", "normal_sum"],
    );
    assert_keys(
        &accumulators["increments"]["f2"],
        &["a2", "b2", "c", "j", "p", "i", "line_value"],
    );
    assert_keys(&checked["summary"]["guards"], &["g1", "g2", "accepted"]);
    let machine = &checked["summary"]["machine"];
    assert_keys(machine, &["widths", "slots", "root_limit", "plane_limit"]);
    // What is printed is what the commands take, and the scene fits it.
    let widths = machine["widths"].as_str().unwrap();
    let path = teapot.to_str().unwrap();
    let narrow = json(&["check", path, "--size", "160x120", "--widths", widths]);
    assert_eq!(&narrow["summary"]["machine"], machine);
}

/// Moved to the screen's corner, a 64-bit word can be longer; it is shown as its register holds it.
#[test]
fn the_longest_words_are_printed() {
    let path = scene("orthographic.toml");
    let prepared = json(&["prepare", path.to_str().unwrap(), "--format", "32"]);
    assert!(prepared["objects"].as_array().unwrap().len() > 3);
    // The same of its shadows.
    let text = std::fs::read_to_string(&path).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shadows.toml");
    let shaded = text.replace("[[lights]]\n", "[[lights]]\nshadows = true\n");
    std::fs::write(&path, shaded).unwrap();
    let prepared = json(&["prepare", path.to_str().unwrap(), "--format", "32"]);
    assert!(prepared["volumes"].as_array().unwrap().len() > 10);
}

/// Objects of the other processors: their words, widths and problems under stable keys, in every format.
#[test]
fn scenes_of_other_processors_are_drawn_prepared_and_checked() {
    let folder = tempfile::tempdir().unwrap();
    let expected = [
        ("polyhedron", "polyhedron", "polyhedron"),
        ("mesh", "mesh", "facet"),
        ("paraboloids", "sphere", "sphere"),
        ("first-generation", "ellipsoid", "first_generation"),
        ("patch-processor", "elliptic_paraboloid", "patch"),
        ("tetrahedra", "ellipsoid", "patch"),
        ("curved-facet", "sphere", "curved_facet"),
    ];
    for (name, kind, processor) in expected {
        let path = scene(&format!("processors/{name}.toml"));
        let path = path.to_str().unwrap();
        for format in ["16", "24", "32"] {
            let options = [path, "--size", "120x90", "--format", format];
            let prepared = json(&[&["prepare"], &options[..]].concat());
            assert_eq!(prepared["objects"][0]["processor"], processor, "{name}");
            let checked = json(&[&["check"], &options[..]].concat());
            let object = &checked["objects"][0];
            assert_eq!(
                (&object["kind"], &object["processor"]),
                (&kind.into(), &processor.into())
            );
            assert_keys(
                object,
                &["name", "screen_box", "pixels", "needed", "problems"],
            );
            assert!(object["pixels"].as_u64().unwrap() > 100, "{name}");
            for model in ["golden", "exact"] {
                let picture = folder.path().join(format!("{name}-{model}.png"));
                let picture = picture.to_str().unwrap();
                let drawn =
                    json(&[&["render", "--model", model, "-o", picture], &options[..]].concat());
                assert!(drawn["covered_pixels"].as_u64().unwrap() > 500, "{name}");
                assert!(std::fs::metadata(picture).unwrap().len() > 500);
            }
        }
    }
}
