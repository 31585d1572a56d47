//! `imogene import` of face lists and STEP files.

use crate::common::{imogene, scene};

/// A face list of the repository.
fn part(name: &str) -> String {
    format!("{}/../parts/{name}.faces.toml", env!("CARGO_MANIFEST_DIR"))
}

/// A STEP file of the repository.
fn step(name: &str) -> String {
    format!("{}/../parts/{name}.step", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn shipped_scenes_are_what_the_import_writes() {
    let folder = tempfile::tempdir().unwrap();
    for name in [
        "ball-joint",
        "bracket",
        "cross-drilled",
        "curved-plate",
        "fillet",
        "flange",
        "volumes",
    ] {
        let output = folder.path().join("scene.toml");
        let run = imogene()
            .arg("import")
            .arg(part(name))
            .arg("-o")
            .arg(&output)
            .arg("--json")
            .output()
            .unwrap();
        assert!(run.status.success(), "{name}");
        let report: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        assert_eq!(report["kind"], "faces");
        let faces = report["report"]["faces"].as_array().unwrap();
        let rejected = faces.iter().filter(|f| f["verdict"] == "rejected").count();
        assert_eq!(rejected, 0, "{name}");
        let shipped = std::fs::read_to_string(scene(&format!("cad/{name}.toml"))).unwrap();
        assert_eq!(std::fs::read_to_string(&output).unwrap(), shipped, "{name}");
    }
}

#[test]
fn shipped_scene_of_a_step_file_is_what_the_import_writes() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("scene.toml");
    let run = imogene()
        .arg("import")
        .arg(step("fixture"))
        .arg("-o")
        .arg(&output)
        .arg("--json")
        .output()
        .unwrap();
    assert!(run.status.success());
    let report: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(report["kind"], "step");
    assert_eq!(report["report"]["total"]["exact"], 14);
    assert_eq!(report["report"]["faces"].as_array().unwrap().len(), 14);
    assert_eq!(report["report"]["step"]["schema"][0], "AUTOMOTIVE_DESIGN");
    let shipped = std::fs::read_to_string(scene("cad/fixture.toml")).unwrap();
    assert_eq!(std::fs::read_to_string(&output).unwrap(), shipped);
}

/// Whatever is imported can be drawn, and is what the tracer sees; `nut` has a cone that is seen nearly along its side
/// from the usual place.
#[test]
fn every_shipped_step_file_is_drawn_as_the_tracer_sees_it() {
    let folder = tempfile::tempdir().unwrap();
    for name in [
        "cross-drilled",
        "fillet",
        "fixture",
        "flange",
        "hollow",
        "nut",
        "stand",
    ] {
        let output = folder.path().join(format!("{name}.toml"));
        let mut import = imogene();
        import.arg("import").arg(step(name)).arg("-o").arg(&output);
        import.assert().success();
        let mut trace = imogene();
        trace
            .arg("trace")
            .arg(&output)
            .args(["--size", "120x90", "--json"]);
        let traced = trace.assert().success();
        let value: serde_json::Value = serde_json::from_slice(&traced.get_output().stdout).unwrap();
        let found = &value["scenes"][0]["comparison"];
        assert!(found["covered"].as_u64() > Some(1000), "{name}: {found}");
    }
}

#[test]
fn step_files_are_known_by_their_extension_or_by_what_the_user_says() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read(step("hollow")).unwrap();
    let output = folder.path().join("scene.toml");
    for (name, kind) in [
        ("a.step", None),
        ("a.STP", None),
        ("a.p21", None),
        ("a.txt", Some("step")),
    ] {
        let file = folder.path().join(name);
        std::fs::write(&file, &text).unwrap();
        let run = imogene()
            .arg("import")
            .arg(&file)
            .args(kind.map(|kind| format!("--as={kind}")))
            .arg("-o")
            .arg(&output)
            .output()
            .unwrap();
        assert!(run.status.success(), "{name}");
        let lines = String::from_utf8(run.stdout).unwrap();
        let counts = "10 faces of 1 solid: 10 exact, 0 approximated, 0 rejected\n";
        assert!(lines.starts_with(counts), "{lines}");
        std::fs::remove_file(&output).unwrap();
    }
}

#[test]
fn bad_step_files_are_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let good = std::fs::read_to_string(step("hollow")).unwrap();
    let output = folder.path().join("scene.toml");
    let deep = format!("#9 = X({}", "(".repeat(1_000_000));
    for (from, to, part) in [
        (
            "#15 = BREP_WITH_VOIDS",
            "#15 = BREP_WITH_VOIDS(",
            "bad.step:25:43: ",
        ),
        (
            "(#165,#177)",
            "(#165,#9177)",
            "names `#9177`, which is not in the file; ",
        ),
        (
            "ISO-10303-21;\nHEADER",
            "HEADER",
            "bad.step:1:1: this is no STEP file; ",
        ),
        (
            "#16 = CLOSED_SHELL",
            &deep,
            "at most 32 lists inside each other",
        ),
    ] {
        assert!(good.contains(from), "{from}");
        let file = folder.path().join("bad.step");
        std::fs::write(&file, good.replacen(from, to, 1)).unwrap();
        let run = imogene()
            .arg("import")
            .arg(&file)
            .arg("-o")
            .arg(&output)
            .output()
            .unwrap();
        assert_eq!(run.status.code(), Some(2));
        let message = String::from_utf8(run.stderr).unwrap();
        assert!(message.contains(part), "{message}");
        assert!(!output.exists());
    }
}

/// A screw whose thread is no quadric: the rest is drawn with a warning, and the scene keeps what it lacks.
#[test]
fn what_is_missing_decides_the_exit_code_of_the_import_and_of_the_scene() {
    let folder = tempfile::tempdir().unwrap();
    let output = folder.path().join("scene.toml");
    let screw = format!(
        "{}/../import/tests/data/step/M6_screw.step",
        env!("CARGO_MANIFEST_DIR")
    );
    let import = |flag: &[&str]| {
        let mut command = imogene();
        command
            .args(flag)
            .arg("import")
            .arg(&screw)
            .arg("-o")
            .arg(&output);
        command.output().unwrap()
    };
    let strict = import(&["--strict"]);
    assert_eq!(strict.status.code(), Some(2));
    assert!(!output.exists());
    for (flag, code) in [(vec![], 1), (vec!["--allow-missing"], 0)] {
        let run = import(&flag);
        assert_eq!(run.status.code(), Some(code));
        let said = String::from_utf8(run.stderr).unwrap();
        assert!(
            said.contains("5 of 28 faces (5 bspline) of M6_screw.step missing"),
            "{said}"
        );
        let lines = String::from_utf8(run.stdout).unwrap();
        assert!(lines.starts_with("28 faces of 1 solid: "), "{lines}");
        let mut render = imogene();
        render
            .args(&flag)
            .arg("render")
            .arg(&output)
            .args(["--size", "80x60", "-o"]);
        let drawn = render.arg(folder.path().join("p.png")).output().unwrap();
        assert_eq!(drawn.status.code(), Some(code));
        let said = String::from_utf8(drawn.stderr).unwrap();
        assert!(said.contains("5 of 28 faces"), "{said}");
    }
}

#[test]
fn a_deviation_of_zero_leaves_the_exact_faces() {
    let folder = tempfile::tempdir().unwrap();
    let run = imogene()
        .arg("import")
        .arg(part("cross-drilled"))
        .args(["--max-deviation", "0", "--json", "-o"])
        .arg(folder.path().join("scene.toml"))
        .output()
        .unwrap();
    let report: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    assert_eq!(run.status.code(), Some(1));
    assert_eq!(report["report"]["total"]["exact"], 2);
    assert_eq!(report["report"]["total"]["rejected"], 2);
}

/// Four times as near, a pixel is a quarter: so is what the fillet may be off by.
#[test]
fn a_deviation_in_pixels_follows_the_view() {
    let folder = tempfile::tempdir().unwrap();
    let deviation = |zoom: &str| {
        let run = imogene()
            .arg("import")
            .arg(part("fillet"))
            .args(["--max-deviation", "0.5px", "--zoom", zoom, "--json", "-o"])
            .arg(folder.path().join("scene.toml"))
            .output()
            .unwrap();
        assert_eq!(run.status.code(), Some(0));
        let report: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
        report["report"]["max_deviation"].as_f64().unwrap()
    };
    let (near, far) = (deviation("4"), deviation("1"));
    assert!((far / near - 4.0).abs() < 1e-6, "{far} {near}");
    // The part is 60 wide and fills 640x480: a pixel is about a tenth.
    assert!((0.03..0.07).contains(&far), "{far}");
}

#[test]
fn bad_lists_and_options_are_refused_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("bad.faces.toml");
    std::fs::write(&list, "format = 1\ntitle = \"t\"\n[vertices]\na = [0, 0]\n").unwrap();
    let output = folder.path().join("scene.toml");
    let run = imogene()
        .arg("import")
        .arg(&list)
        .arg("-o")
        .arg(&output)
        .output()
        .unwrap();
    assert_eq!(run.status.code(), Some(2));
    let message = String::from_utf8(run.stderr).unwrap();
    assert!(message.contains("bad.faces.toml:4:5: "), "{message}");
    assert!(!output.exists());
    for length in ["-1", "nan", "wide", "px", "-1px"] {
        let run = imogene()
            .arg("import")
            .arg(part("flange"))
            .arg(format!("--max-deviation={length}"))
            .arg("-o")
            .arg(&output)
            .output()
            .unwrap();
        assert_eq!(run.status.code(), Some(2));
        assert!(!output.exists());
    }
}
