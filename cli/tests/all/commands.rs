//! The commands on real input: pictures, words, JSON keys that scripts rely on.

use crate::common::{COSIM_KEYS, Place, assert_keys, json, scene};
use serde_json::Value;

#[test]
fn demo_draws_the_teapot_with_no_difference() {
    let place = Place::new();
    let summary = place.json("demo --out .");
    assert_keys(&summary, COSIM_KEYS);
    assert_eq!(summary["mismatches"], 0);
    assert_eq!(summary["pixels"], 640 * 480 + 160 * 120);
    assert_eq!(summary["clocks_per_frame"], 800 * 525);
    for name in ["trace.gtkw", "beam_display.v"] {
        assert!(place.has(name), "no {name}");
    }
    assert_eq!(place.bytes("pins.png"), place.bytes("golden.png"));
    let vcd = place.text("trace.vcd");
    assert!(vcd.contains("processor_0") && vcd.contains("golden") && vcd.contains("hardware"));
    let written: Value = serde_json::from_str(&place.text("summary.json")).unwrap();
    assert_eq!(written["mismatches"], 0);
}

#[test]
fn three_models_draw_the_same_molecule() {
    let place = Place::new();
    let [golden, rtl, exact] = ["golden", "rtl", "exact"].map(|model| {
        let files = format!("-o p.png --depth d.npy --ids i.npy --normals {model}.npy");
        let render = format!("render scenes/molecule.toml --model {model} --size 40x30 {files}");
        let report = place.json(&render);
        assert_keys(&report, "model width height seconds pixels_per_second");
        assert_eq!(report["width"], 40);
        let header = place.bytes("d.npy");
        let text = String::from_utf8_lossy(&header[..80]).into_owned();
        assert!(text.contains("'<i8'") && text.contains("(30, 40"), "{text}");
        assert!(place.has(&format!("{model}.npy")));
        (place.bytes("p.png"), place.bytes("i.npy"))
    });
    assert_eq!(golden, rtl, "golden and hardware pictures differ");
    assert_eq!(golden.1, exact.1, "golden and exact object indices differ");
}

#[test]
fn units_prepare_and_check_answer_in_json() {
    let units = json("units");
    let units = units.as_array().unwrap();
    for name in ["pe1", "square_root", "quadric_processor", "decider", "beam"] {
        let is_listed = units.iter().any(|unit| unit["name"] == name);
        assert!(is_listed, "no {name}");
    }
    let teapot = "scenes/teapot.toml --size 160x120";
    let prepared = json(&format!("prepare {teapot}"));
    assert_eq!(prepared["objects"].as_array().unwrap().len(), 10);
    let checked = json(&format!("check {teapot}"));
    assert_keys(&checked, "objects bounds widths ok");
    assert_keys(&checked["bounds"], "depth_lsb silhouette_px normal_deg");
    let object = &checked["objects"][0];
    assert_keys(object, "name kind class problems shows visible_pixels");
    assert_keys(object, "front_view prism degenerate highlights");
    assert_keys(object, "perpendicular_planes planes_without_effect");
    let accumulators = &object["accumulators"];
    assert_keys(accumulators, "f1 f2 f1_minus_r root normal_sum");
    let f2 = &accumulators["increments"]["f2"];
    assert_keys(f2, "a2 b2 c j p i line_value");
    assert_keys(&checked["summary"]["guards"], "g1 g2 accepted");
    let machine = &checked["summary"]["machine"];
    assert_keys(machine, "widths slots root_limit plane_limit");
    // What is printed is what the commands take, and the scene fits it.
    let widths = machine["widths"].as_str().unwrap();
    let narrow = json(&format!("check {teapot} --widths {widths}"));
    assert_eq!(&narrow["summary"]["machine"], machine);
}

/// Moved to the screen's corner, a 64-bit word can be longer; it is shown as its register holds it.
#[test]
fn the_longest_words_are_printed() {
    let path = scene("orthographic.toml");
    let prepared = json(&format!("prepare {path} --format 32"));
    assert!(prepared["objects"].as_array().unwrap().len() > 3);
    // The same of its shadows.
    let text = std::fs::read_to_string(&path).unwrap();
    let place = Place::new();
    let shaded = text.replace("[[lights]]\n", "[[lights]]\nshadows = true\n");
    place.write("shadows.toml", shaded);
    let prepared = place.json("prepare shadows.toml --format 32");
    assert!(prepared["volumes"].as_array().unwrap().len() > 10);
    // The denominator of a quotient is longer than 64 bits.
    let near = scene("extremes/eye-barely-inside.toml");
    for options in ["", "--json"] {
        let prepare = format!("prepare {near} --size 96x72 {options}");
        place.run(&prepare).ended(0);
    }
}

/// Objects of the other processors: their words, widths and problems under stable keys, in every format.
#[test]
fn scenes_of_other_processors_are_drawn_prepared_and_checked() {
    let place = Place::new();
    for (name, kind, processor) in [
        ("polyhedron", "polyhedron", "polyhedron"),
        ("mesh", "mesh", "facet"),
        ("paraboloids", "sphere", "sphere"),
        ("first-generation", "ellipsoid", "first_generation"),
        ("patch-processor", "elliptic_paraboloid", "patch"),
        ("tetrahedra", "ellipsoid", "patch"),
        ("curved-facet", "sphere", "curved_facet"),
    ] {
        for format in [16, 24, 32] {
            let scene = format!("scenes/processors/{name}.toml --size 120x90 --format {format}");
            let prepared = place.json(&format!("prepare {scene}"));
            assert_eq!(prepared["objects"][0]["processor"], processor, "{name}");
            let checked = place.json(&format!("check {scene}"));
            let object = &checked["objects"][0];
            assert_eq!(object["kind"], kind);
            assert_eq!(object["processor"], processor);
            assert_keys(object, "name screen_box pixels needed problems");
            assert!(object["pixels"].as_u64().unwrap() > 100, "{name}");
            for model in ["golden", "exact"] {
                let drawn = place.json(&format!("render --model {model} -o p.png {scene}"));
                assert!(drawn["covered_pixels"].as_u64().unwrap() > 500, "{name}");
                assert!(place.bytes("p.png").len() > 500);
            }
        }
    }
}
