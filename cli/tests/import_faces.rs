//! `imogene import` of face lists.

mod common;

use common::{imogene, scene};

/// A face list of the repository.
fn part(name: &str) -> String {
    format!("{}/../parts/{name}.faces.toml", env!("CARGO_MANIFEST_DIR"))
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
        assert_eq!(rejected, usize::from(name == "fillet"), "{name}");
        let shipped = std::fs::read_to_string(scene(&format!("cad/{name}.toml"))).unwrap();
        assert_eq!(std::fs::read_to_string(&output).unwrap(), shipped, "{name}");
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
    assert_eq!(report["report"]["total"]["exact"], 2);
    assert_eq!(report["report"]["total"]["rejected"], 2);
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
    for length in ["-1", "nan", "wide"] {
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
