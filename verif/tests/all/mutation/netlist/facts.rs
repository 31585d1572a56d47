use crate::is_full_run;
use imogene_contract::Request;
use imogene_rtl::emit::emit;
use imogene_tools::{read, scratch, write};
use imogene_verif::mutation::Options;
use imogene_verif::mutation::netlist::facts::{ASSUMED, Facts, Proof, assume, live, wires};
use imogene_verif::mutation::netlist::mutant::{SOURCE, elaborate};

#[test]
fn facts_name_wires_of_the_netlist() {
    let text = "module \\m\n  wire width 4 input 2 \\a2\n  wire width 5 \\s[0].t.next_remainder\n  \
                wire width 4 \\s[0].t.next_root\n  wire width 5 \\s[0].t.rows_0.next_remainder\n  \
                wire width 4 \\s[0].t.rows_0.next_root\n  wire width 5 \\s[0].t.rows_0.next_live\n  wire $1\nend\n";
    let wires = wires(text);
    assert_eq!(wires.get("a2"), Some(&4));
    assert_eq!(wires.len(), 6);
    let facts = Facts::of("square_root", &wires);
    assert_eq!(facts.inputs, ["!({a2} & 1)"]);
    let row = "{s[0].t.next_remainder} <= 2 * {s[0].t.next_root}";
    assert_eq!(facts.registers, [row]);
    let (verilog, connections) = facts.module("assert", &wires);
    let stated = "assert({64'd0, p1} <= 2 * {64'd0, p2});";
    assert!(verilog.contains(stated), "{verilog}");
    assert!(connections.contains("connect \\p2 \\s[0].t.next_root"));
    assert_eq!(live("s[0].t", &wires), "{s[0].t.rows_0.next_live}");
}

/// What becomes of the facts of a unit that is taken for `named`, and the netlist with them.
fn assumed(unit: &str, rows_per_stage: u32, named: &str) -> (Proof, String) {
    let options = [("rows-per-stage", Some(rows_per_stage))];
    let request = Request::given(unit, 16, &options).expect("a unit of the catalogue");
    let emitted = emit(&request).expect("a legal request");
    let (top, text) = (&emitted.top, &emitted.bundle());
    let scratch = scratch().expect("a folder");
    let folder = scratch.path();
    write(&folder.join(SOURCE), text).expect("a file");
    elaborate(folder, top, text, &Options::default()).expect("a legal unit");
    let proof = assume(folder, top, named).expect("yosys runs");
    (proof, read(&folder.join(ASSUMED)).expect("a netlist"))
}

/// A remainder behind each stage, but the last one of a PE, which nothing reads.
#[test]
fn facts_of_roots_are_proven() {
    let units = [
        ("square_root", 1, 16),
        ("square_root", 3, 6),
        ("square_root_non_restoring", 1, 16),
        ("square_root_non_restoring", 3, 6),
        ("quadric_pe", 1, 15),
    ];
    for (place, (unit, rows_per_stage, facts)) in units.into_iter().enumerate() {
        if place % 3 > 0 && !is_full_run() {
            continue;
        }
        let (proof, netlist) = assumed(unit, rows_per_stage, unit);
        assert_eq!(proof, Proof::Proven(facts), "{unit}");
        assert!(netlist.matches("cell $assume").count() >= facts, "{unit}");
    }
}

/// What does not hold is not assumed: rows that do not restore are taken for rows that do.
#[test]
fn facts_that_do_not_hold_are_told() {
    let (proof, netlist) = assumed("square_root_non_restoring", 1, "square_root");
    assert_eq!(proof, Proof::Failed);
    assert!(!netlist.contains("cell $assume"));
}
