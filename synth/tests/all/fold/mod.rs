//! Netlists with fewer cells do the same.

mod registers;
mod sums;

use imogene_synth::{Folded, fold};
use serde_json::{Value, json};

/// Changes a module; what it does without.
fn fold_module(module: &mut Value) -> Folded {
    let folder = imogene_tools::scratch().expect("a folder");
    let path = folder.path().join("netlist.json");
    let netlist = json!({ "modules": { "top": *module } }).to_string();
    imogene_tools::write(&path, &netlist).expect("a file");
    let folded = fold(&path).expect("a netlist")["top"];
    let written = imogene_tools::read(&path).expect("a file");
    let mut written: Value = serde_json::from_str(&written).expect("a netlist");
    *module = written["modules"]["top"].take();
    folded
}

#[test]
fn a_file_that_is_no_netlist_is_refused() {
    let folder = imogene_tools::scratch().expect("a folder");
    let path = folder.path().join("netlist.json");
    for text in ["", "{}", "[1]"] {
        imogene_tools::write(&path, text).expect("a file");
        assert!(fold(&path).is_err(), "{text}");
    }
}
