//! `imogene import` of face lists and STEP files.

use crate::common::{Place, Run, repository, scene};

/// Whatever is shipped is what the import writes.
fn assert_shipped(name: &str, file: &str) -> serde_json::Value {
    let place = Place::new();
    let report = place.json(&format!("import parts/{file} -o scene.toml"));
    let shipped = std::fs::read_to_string(scene(&format!("cad/{name}.toml"))).unwrap();
    assert_eq!(place.text("scene.toml"), shipped, "{name}");
    report
}

#[test]
fn shipped_scenes_are_what_the_import_writes() {
    let names = "ball-joint bracket cross-drilled curved-plate fillet flange volumes";
    for name in names.split(' ') {
        let report = assert_shipped(name, &format!("{name}.faces.toml"));
        assert_eq!(report["kind"], "faces");
        let faces = report["report"]["faces"].as_array().unwrap();
        let rejected = faces.iter().filter(|f| f["verdict"] == "rejected").count();
        assert_eq!(rejected, 0, "{name}");
    }
}

#[test]
fn shipped_scene_of_a_step_file_is_what_the_import_writes() {
    let report = assert_shipped("fixture", "fixture.step");
    assert_eq!(report["kind"], "step");
    let report = &report["report"];
    assert_eq!(report["total"]["exact"], 14);
    assert_eq!(report["faces"].as_array().unwrap().len(), 14);
    assert_eq!(report["step"]["schema"][0], "AUTOMOTIVE_DESIGN");
}

/// Whatever is imported can be drawn, and is what the tracer sees; `nut` has a cone that is seen nearly along its side
/// from the usual place.
#[test]
fn every_shipped_step_file_is_drawn_as_the_tracer_sees_it() {
    let place = Place::new();
    for name in "cross-drilled fillet fixture flange hollow nut stand".split(' ') {
        let import = format!("import parts/{name}.step -o {name}.toml");
        place.run(&import).ended(0);
        let value = place.json(&format!("trace {name}.toml --size 120x90"));
        let found = &value["scenes"][0]["comparison"];
        assert!(found["covered"].as_u64() > Some(1000), "{name}: {found}");
    }
}

#[test]
fn step_files_are_known_by_their_extension_or_by_what_the_user_says() {
    let place = Place::new();
    let text = std::fs::read(repository("parts/hollow.step")).unwrap();
    for file in ["a.step", "a.STP", "a.p21", "a.txt --as=step"] {
        place.write(file.split(' ').next().unwrap(), &text);
        let line = format!("import {file} -o scene.toml");
        let lines = place.run(&line).ended(0).out;
        let counts = "10 faces of 1 solid: 10 exact, 0 approximated, 0 rejected\n";
        assert!(lines.starts_with(counts), "{lines}");
        std::fs::remove_file(place.path("scene.toml")).unwrap();
    }
}

/// The import of a file is refused, and writes nothing.
fn refused(place: &Place, line: &str, part: &str) {
    let line = format!("import {line} -o scene.toml");
    place.run(&line).refused(&[part]);
    assert!(!place.has("scene.toml"));
}

#[test]
fn bad_step_files_are_refused_and_nothing_is_written() {
    let place = Place::new();
    let good = std::fs::read_to_string(repository("parts/hollow.step")).unwrap();
    let deep = format!("#9 = X({}", "(".repeat(1_000_000));
    #[rustfmt::skip]
    let cases = [
        ("#15 = BREP_WITH_VOIDS", "#15 = BREP_WITH_VOIDS(", "bad.step:25:43: "),
        ("(#165,#177)", "(#165,#9177)", "names `#9177`, which is not in the file; "),
        ("ISO-10303-21;\nHEADER", "HEADER", "bad.step:1:1: this is no STEP file; "),
        ("#16 = CLOSED_SHELL", &deep, "at most 32 lists inside each other"),
    ];
    for (from, to, part) in cases {
        assert!(good.contains(from), "{from}");
        place.write("bad.step", good.replacen(from, to, 1));
        refused(&place, "bad.step", part);
    }
}

/// A screw whose thread is no quadric: the rest is drawn with a warning, and the scene keeps what it lacks.
#[test]
fn what_is_missing_decides_the_exit_code_of_the_import_and_of_the_scene() {
    let place = Place::new();
    let screw = repository("import/tests/data/step/M6_screw.step");
    let screw = screw.display();
    let import = |flag: &str| place.run(&format!("{flag} import {screw} -o scene.toml"));
    import("--strict").ended(2);
    assert!(!place.has("scene.toml"));
    for (flag, code) in [("", 1), ("--allow-missing", 0)] {
        let missing = "5 of 28 faces (5 bspline) of M6_screw.step missing";
        let Run { out, .. } = import(flag).ended(code).says(&[missing]);
        assert!(out.starts_with("28 faces of 1 solid: "), "{out}");
        let render = format!("{flag} render scene.toml --size 80x60 -o p.png");
        place.run(&render).ended(code).says(&["5 of 28 faces"]);
    }
}

#[test]
fn a_deviation_of_zero_leaves_the_exact_faces() {
    let place = Place::new();
    let list = "parts/cross-drilled.faces.toml";
    let line = format!("import {list} --max-deviation 0 --json -o scene.toml");
    let report = place.run(&line).ended(1).json();
    assert_eq!(report["report"]["total"]["exact"], 2);
    assert_eq!(report["report"]["total"]["rejected"], 2);
}

/// Four times as near, a pixel is a quarter: so is what the fillet may be off by.
#[test]
fn a_deviation_in_pixels_follows_the_view() {
    let place = Place::new();
    let list = "parts/fillet.faces.toml";
    let deviation = |zoom: u32| {
        let options = format!("--max-deviation 0.5px --zoom {zoom} -o scene.toml");
        let report = place.json(&format!("import {list} {options}"));
        report["report"]["max_deviation"].as_f64().unwrap()
    };
    let (near, far) = (deviation(4), deviation(1));
    assert!((far / near - 4.0).abs() < 1e-6, "{far} {near}");
    // The part is 60 wide and fills 640x480: a pixel is about a tenth.
    assert!((0.03..0.07).contains(&far), "{far}");
}

#[test]
fn bad_lists_and_options_are_refused_and_nothing_is_written() {
    let place = Place::new();
    let list = "format = 1\ntitle = \"t\"\n[vertices]\na = [0, 0]\n";
    place.write("bad.faces.toml", list);
    refused(&place, "bad.faces.toml", "bad.faces.toml:4:5: ");
    let flange = "parts/flange.faces.toml";
    for length in ["-1", "nan", "wide", "px", "-1px"] {
        refused(&place, &format!("{flange} --max-deviation={length}"), "");
    }
}
