//! `imogene contract` and `package`.

use crate::common::{assert_keys, imogene, json};

#[test]
fn contract_prints_json_or_markdown_and_writes_a_file() {
    let value = json(&["contract", "pe1", "--format", "16"]);
    assert_keys(
        &value,
        &[
            "unit",
            "computes",
            "source",
            "parameters",
            "ports",
            "latency",
            "throughput",
            "reset",
            "ties",
            "error",
            "command",
        ],
    );
    let port = &value["ports"].as_array().expect("ports")[4];
    assert_eq!((&port["name"], &port["width"]), (&"a".into(), &18.into()));
    assert_eq!(port["formula"], "W + 2");
    let folder = tempfile::tempdir().expect("a scratch folder");
    let file = folder.path().join("pe1.md");
    let name = file.to_str().expect("a plain path");
    imogene()
        .args(["contract", "pe1", "--out", name])
        .assert()
        .success();
    let page = std::fs::read_to_string(&file).expect("the page");
    assert!(page.contains("| `a` | input | 26 | `W + 2` |"), "{page}");
    imogene().args(["contract", "pe3"]).assert().code(2);
}

#[test]
fn package_writes_every_core_that_it_names() {
    let folder = tempfile::tempdir().expect("a scratch folder");
    let out = folder.path().to_str().expect("a plain path");
    let value = json(&["package", "--clocks", "20", "--out", out]);
    assert_keys(&value, &["cores", "bytes", "files"]);
    assert_eq!(value["cores"], 50);
    for file in value["files"].as_array().expect("files") {
        let path = std::path::Path::new(file.as_str().expect("a path"));
        assert!(path.is_file(), "{}", path.display());
    }
    for file in ["beam.core", "contract.json", "bench/bench.v", "rtl/beam.v"] {
        assert!(folder.path().join("beam").join(file).is_file(), "{file}");
    }
}
