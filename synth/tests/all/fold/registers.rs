use super::fold_module as fold_all;
use serde_json::{Value, json};

/// Moves the flip-flops of a module; how many there were.
fn fold_module(module: &mut Value) -> u64 {
    fold_all(module).flip_flops
}

/// A flip-flop from one net to another.
fn flip_flop(from: u64, to: u64, more: Value) -> Value {
    let mut cell = json!({
        "type": "TRELLIS_FF",
        "parameters": { "CEMUX": "1 ", "CLKMUX": "CLK", "LSRMUX": "LSR", "REGSET": "RESET" },
        "port_directions": { "CLK": "input", "DI": "input", "LSR": "input", "Q": "output" },
        "connections": { "CLK": [2], "DI": [from], "LSR": ["0"], "Q": [to] },
    });
    for (key, value) in more.as_object().into_iter().flatten() {
        cell["parameters"][key] = value.clone();
    }
    cell
}

/// A multiplier and a memory whose outputs, nets 10 and 11 and net 12, go through flip-flops to nets 20 to 22.
fn module(second: Value) -> Value {
    json!({
        "ports": { "out": { "direction": "output", "bits": [20, 21, 22] } },
        "cells": {
            "product": {
                "type": "MULT18X18D", "parameters": {},
                "port_directions": { "P0": "output", "P1": "output", "P2": "output" },
                "connections": { "P0": [10], "P1": [11], "P2": [13] },
            },
            "store": {
                "type": "DP16KD", "parameters": {},
                "port_directions": { "CLKA": "input", "CLKB": "input", "DOB0": "output", "OCEB": "input" },
                "connections": { "CLKA": [2], "CLKB": [2], "DOB0": [12], "OCEB": ["1"] },
            },
            "a": flip_flop(10, 20, json!({})),
            "b": second,
            "c": flip_flop(12, 22, json!({})),
        },
    })
}

#[test]
fn flip_flops_become_output_registers() {
    let mut module = module(flip_flop(11, 21, json!({})));
    assert_eq!(fold_module(&mut module), 3);
    let cells = module["cells"].as_object().expect("cells");
    assert_eq!(cells.keys().collect::<Vec<_>>(), ["product", "store"]);
    let (product, store) = (&cells["product"], &cells["store"]);
    assert_eq!(product["parameters"]["REG_OUTPUT_CLK"], "CLK0");
    for (port, bits) in [
        ("P0", json!([20])),
        ("P1", json!([21])),
        ("CLK0", json!([2])),
        ("CE0", json!(["1"])),
    ] {
        assert_eq!(product["connections"][port], bits, "{port}");
    }
    assert_eq!(store["parameters"]["REGMODE_B"], "OUTREG");
    assert!(store["parameters"]["REGMODE_A"].is_null());
    assert_eq!(store["connections"]["DOB0"], json!([22]));
}

#[test]
fn a_word_of_36_bits_has_the_register_of_both_ports() {
    let mut module = module(flip_flop(30, 21, json!({})));
    let store = &mut module["cells"]["store"];
    store["parameters"]["DATA_WIDTH_B"] = "100100".into();
    store["connections"]["DOA3"] = json!([30]);
    store["port_directions"]["DOA3"] = "output".into();
    store["connections"]["OCEA"] = json!(["0"]);
    // Of the multiplier, whose second output nothing reads, one flip-flop moves.
    assert_eq!(fold_module(&mut module), 3);
    let store = &module["cells"]["store"];
    for (port, bits) in [("DOA3", 21), ("DOB0", 22)] {
        assert_eq!(store["connections"][port], json!([bits]));
    }
    for (side, enable) in [("REGMODE_A", "OCEA"), ("REGMODE_B", "OCEB")] {
        assert_eq!(store["parameters"][side], "OUTREG");
        assert_eq!(store["connections"][enable], json!(["1"]));
    }
}

#[test]
fn an_enable_of_all_flip_flops_is_that_of_the_register() {
    let enabled = |mut cell: Value| {
        cell["connections"]["CE"] = json!([5]);
        cell
    };
    let with_enable = |from, to| enabled(flip_flop(from, to, json!({ "CEMUX": "CE" })));
    let mut module = module(with_enable(11, 21));
    module["cells"]["a"] = with_enable(10, 20);
    assert_eq!(fold_module(&mut module), 3);
    let product = &module["cells"]["product"]["connections"];
    assert_eq!(product["CE0"], json!([5]));
    let store = &module["cells"]["store"]["connections"];
    assert_eq!(store["OCEB"], json!(["1"]));
}

#[test]
fn a_cell_is_left_alone_unless_all_its_flip_flops_can_move() {
    let other = |what: Value| flip_flop(11, 21, what);
    let mut late = other(json!({}));
    late["connections"]["CLK"] = json!([3]);
    let mut reset = other(json!({}));
    reset["connections"]["LSR"] = json!([4]);
    for (what, second) in [
        ("enable", other(json!({ "CEMUX": "CE" }))),
        ("falling edge", other(json!({ "CLKMUX": "INV" }))),
        ("starts at 1", other(json!({ "REGSET": "SET" }))),
        ("other clock", late),
        ("reset", reset),
        ("two readers", flip_flop(10, 21, json!({}))),
    ] {
        let mut module = module(second.clone());
        assert_eq!(fold_module(&mut module), 1, "{what}");
        assert_eq!(module["cells"]["b"], second, "{what}");
        assert!(module["cells"]["product"]["parameters"]["REG_OUTPUT_CLK"].is_null());
    }
}

/// A product with an output register of the nets 10, 12 and 11, which flip-flops take from the nets 30, 32 and 31.
fn factors() -> Value {
    json!({
        "ports": { "out": { "direction": "output", "bits": [20] } },
        "cells": {
            "product": {
                "type": "MULT18X18D", "parameters": { "REG_OUTPUT_CLK": "CLK0" },
                "port_directions": { "P0": "output" },
                "connections": {
                    "A0": [10], "A1": [12], "A2": ["0"], "B0": [11], "P0": [20], "CLK0": [2], "CE0": ["1"],
                },
            },
            "a": flip_flop(30, 10, json!({})),
            "b": flip_flop(31, 11, json!({})),
            "c": flip_flop(32, 12, json!({})),
            "first": flip_flop(20, 30, json!({})),
            "second": flip_flop(20, 31, json!({})),
            "third": flip_flop(20, 32, json!({})),
        },
    })
}

#[test]
fn flip_flops_that_only_delay_become_registers_of_factors() {
    let mut module = factors();
    assert_eq!(fold_module(&mut module), 3);
    let cells = module["cells"].as_object().expect("cells");
    assert_eq!(
        cells.keys().collect::<Vec<_>>(),
        ["first", "product", "second", "third"]
    );
    let product = &cells["product"];
    assert_eq!(product["parameters"]["REG_INPUTA_CLK"], "CLK0");
    assert_eq!(product["parameters"]["REG_INPUTB_CLK"], "CLK0");
    for (port, bit) in [
        ("A0", json!(30)),
        ("A1", json!(32)),
        ("A2", json!("0")),
        ("B0", json!(31)),
    ] {
        assert_eq!(product["connections"][port], json!([bit]), "{port}");
    }
}

#[test]
fn a_flip_flop_that_takes_a_constant_becomes_one_too() {
    let mut module = factors();
    module["cells"]["c"]["connections"]["DI"] = json!(["1"]);
    assert_eq!(fold_module(&mut module), 3);
    assert!(module["cells"]["c"].is_null());
    assert_eq!(
        module["cells"]["product"]["connections"]["A1"],
        json!(["1"])
    );
}

#[test]
fn a_flip_flop_that_is_read_elsewhere_stays_beside_the_register() {
    let mut module = factors();
    module["ports"]["out"]["bits"] = json!([20, 11]);
    assert_eq!(fold_module(&mut module), 2);
    assert_eq!(module["cells"]["b"], flip_flop(31, 11, json!({})));
    assert_eq!(module["cells"]["product"]["connections"]["B0"], json!([31]));
}

#[test]
fn a_multiplier_takes_the_registers_of_both_factors_or_none() {
    let table = json!({
        "type": "LUT4", "parameters": {}, "port_directions": { "Z": "output" }, "connections": { "Z": [31] },
    });
    let late = json!({ "CLKMUX": "INV" });
    let mut enabled = flip_flop(31, 11, json!({ "CEMUX": "CE" }));
    enabled["connections"]["CE"] = json!([5]);
    for (what, path, value) in [
        ("logic before a factor", "/cells/second", table.clone()),
        (
            "a factor of logic",
            "/cells/product/connections/B0",
            json!([31]),
        ),
        (
            "a factor of 1",
            "/cells/product/connections/A2",
            json!(["1"]),
        ),
        ("falling edge", "/cells/b", flip_flop(31, 11, late)),
        ("enable", "/cells/b", enabled),
        ("other clock", "/cells/b/connections/CLK", json!([3])),
        ("no output register", "/cells/product/parameters", json!({})),
    ] {
        let mut module = factors();
        if what == "a factor of logic" {
            module["cells"]["second"] = table.clone();
        }
        *module.pointer_mut(path).expect(what) = value;
        let before = module.clone();
        assert_eq!(fold_module(&mut module), 0, "{what}");
        assert_eq!(module, before, "{what}");
    }
}
