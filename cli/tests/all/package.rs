//! `imogene contract` and `package`.

use crate::common::{Place, assert_keys, json, run};

#[test]
fn contract_prints_json_or_markdown_and_writes_a_file() {
    let value = json("contract pe1 --format 16");
    let keys = "unit computes source parameters ports latency throughput reset ties error command";
    assert_keys(&value, keys);
    let port = &value["ports"][4];
    assert_eq!(port["name"], "a");
    assert_eq!(port["width"], 18);
    assert_eq!(port["formula"], "W + 2");
    let place = Place::new();
    place.run("contract pe1 --out pe1.md").ended(0);
    let page = place.text("pe1.md");
    assert!(page.contains("| `a` | input | 26 | `W + 2` |"), "{page}");
    run("contract pe3").ended(2);
}

#[test]
fn package_writes_every_core_that_it_names() {
    let place = Place::new();
    let value = place.json("package --clocks 20 --out .");
    assert_keys(&value, "cores bytes files");
    assert_eq!(value["cores"], 52);
    place.assert_files(&value);
    for file in ["beam.core", "contract.json", "bench/bench.v", "rtl/beam.v"] {
        assert!(place.has(&format!("beam/{file}")), "{file}");
    }
}
