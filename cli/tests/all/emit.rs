//! `imogene emit`: files, prefixes, JSON keys.

use crate::common::{assert_keys, json};

#[test]
fn emit_reports_top_files_latency_and_ports() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let report = json(&[
        "emit",
        "quadric_processor",
        "--planes",
        "2",
        "--rows-per-stage",
        "4",
        "--out",
        out,
    ]);
    assert_keys(&report, &["top", "files", "latency", "ports"]);
    assert_eq!(report["latency"], 6 + 2 * 2 + 11);
    let file = report["files"][0].as_str().unwrap();
    let first = std::fs::read(file).unwrap();
    json(&[
        "emit",
        "quadric_processor",
        "--planes",
        "2",
        "--rows-per-stage",
        "4",
        "--out",
        out,
    ]);
    assert_eq!(
        first,
        std::fs::read(file).unwrap(),
        "emission is not deterministic"
    );
    let text = String::from_utf8(first).unwrap();
    assert!(
        text.contains("imogene emit quadric_processor --format 24 --planes 2 --rows-per-stage 4")
    );
}

#[test]
fn emit_split_writes_each_module_once_and_lists_them() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    let report = json(&["emit", "quadric_pe", "--split", "--out", out]);
    let list = std::fs::read_to_string(folder.path().join("quadric_pe.f")).unwrap();
    assert_eq!(list.lines().last(), Some("quadric_pe.v"));
    assert_eq!(
        list.lines().count() as u64,
        report["modules"].as_u64().unwrap()
    );
    for file in list.lines() {
        let text = std::fs::read_to_string(folder.path().join(file)).unwrap();
        let module = file.strip_suffix(".v").unwrap();
        assert_eq!(text.matches("\nmodule ").count(), 1, "{file}");
        assert!(text.contains(&format!("\nmodule {module} (")), "{file}");
    }
}

#[test]
fn emit_puts_a_prefix_before_modules_and_files() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().to_str().unwrap();
    for (prefix, word) in [("narrow_", "16"), ("wide_", "24")] {
        let report = json(&[
            "emit",
            "square_root",
            "--format",
            word,
            "--split",
            "--prefix",
            prefix,
            "--out",
            out,
        ]);
        assert_eq!(report["top"], format!("{prefix}square_root"));
        let list = folder.path().join(format!("{prefix}square_root.f"));
        let list = std::fs::read_to_string(list).unwrap();
        assert_eq!(list.lines().count(), 3);
        for file in list.lines() {
            let text = std::fs::read_to_string(folder.path().join(file)).unwrap();
            let module = file.strip_suffix(".v").unwrap();
            assert!(module.starts_with(prefix), "{file}");
            assert!(text.contains(&format!("\nmodule {module} (")), "{file}");
        }
    }
}
