//! The emitted text against rust-hdl's own, by Yosys. Needs the package 'yosys' and fails without it. Every unit at the base format and at the
//! shortest under `IMOGENE_FULL=1`; small units otherwise.

use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{EmitRequest, emit, raw};
use imogene_verif::equivalence::table::{Row, markdown};
use imogene_verif::equivalence::{Text, Verdict, compare, unit, with_ranges};

fn is_full_run() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

fn page() -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/emission.md");
    std::fs::read_to_string(path).expect("the page of the emission")
}

/// The rows of the published table, and beyond the base format that nothing turns out otherwise.
#[test]
fn every_unit_is_the_circuit_that_rust_hdl_prints() {
    let (units, words): (&[Unit], &[usize]) = if is_full_run() {
        (&Unit::ALL, &[24, 16])
    } else {
        (&[Unit::Pe1, Unit::PlaneDepth, Unit::VisibilityNode], &[24])
    };
    let page = page();
    let mut missing = Vec::new();
    for &depth_word in words {
        for &unit in units {
            let row = Row::of(unit, depth_word).unwrap_or_else(|error| panic!("{error}"));
            let text = markdown(std::slice::from_ref(&row));
            let line = text.lines().last().expect("a row");
            println!("{depth_word}: {line}");
            if depth_word == 24 && !page.contains(line) {
                missing.push(line.to_owned());
            }
            if let Ok([_, ranged]) = &row.found {
                assert_eq!(ranged.verdict, Verdict::Equal, "{}", unit.name());
                assert!(ranged.registers > 0, "{}", unit.name());
            }
        }
    }
    let missing = missing.join("\n");
    assert!(
        missing.is_empty(),
        "docs/emission.md does not have\n{missing}"
    );
}

/// Some nest an index in an index, which rust-hdl's printer cannot resolve; the others have a block memory, which has no kernel.
#[test]
fn rust_hdl_prints_every_other_unit() {
    for unit in Unit::ALL {
        let request = EmitRequest {
            depth_word: 16,
            ..EmitRequest::new(unit)
        };
        let is_printed = raw(&request).is_ok();
        let nests = matches!(
            unit,
            Unit::Decider
                | Unit::CardDecider
                | Unit::CsgDecider
                | Unit::PolyhedronProcessor
                | Unit::ShadowStage
                | Unit::Beam
        );
        let remembers = matches!(
            unit,
            Unit::PixelFifo
                | Unit::FrameStore
                | Unit::PostFilter
                | Unit::Overlay
                | Unit::Accumulator
                | Unit::ShadingProcessor
        );
        assert_eq!(is_printed, !nests && !remembers, "{}", unit.name());
    }
    let request = EmitRequest::new(Unit::Decider);
    let message = unit(&request, false).expect_err("no text").to_string();
    assert!(message.contains("`decider` stops"), "{message}");
}

/// Replaces a part of PE1's emitted text and compares it with rust-hdl's.
fn changed(from: &str, to: &str) -> Verdict {
    let request = EmitRequest::new(Unit::Pe1);
    let printed = with_ranges(&raw(&request).expect("a text"));
    let emitted = emit(&request).expect("a text").bundle();
    assert!(emitted.contains(from), "no `{from}` in the text");
    let theirs = Text {
        top: "top",
        verilog: &printed,
    };
    let ours = Text {
        top: "pe1",
        verilog: &emitted.replacen(from, to, 1),
    };
    let found = compare(theirs, ours).unwrap_or_else(|error| panic!("{error}"));
    found.verdict
}

#[test]
fn a_changed_text_is_not_equal() {
    assert_eq!(changed("pe1", "pe1"), Verdict::Equal);
    for (from, to, named) in [
        (
            "line_value + kept_b",
            "line_value - kept_b",
            "next value of line_value",
        ),
        ("start | line", "start & line", "next value of"),
        (
            "assign value = pixel_value",
            "assign value = line_value",
            "value",
        ),
        (
            "reg signed [25:0] kept_a = 26'sd0",
            "reg signed [25:0] kept_a = 26'sd4",
            "register kept_a",
        ),
        (
            "reg signed [25:0] kept_a = 26'sd0",
            "reg signed [25:0] kept_a",
            "register kept_a",
        ),
        ("posedge clock", "negedge clock", "falling edge"),
        ("posedge clock", "posedge valid", "clock of kept_a"),
        (
            "assign first = start | line",
            "assign first = (start | line) ? 1'b1 : 1'bx",
            "next value of",
        ),
    ] {
        match changed(from, to) {
            Verdict::Differs(what) => assert!(what.contains(named), "{to}: {what}"),
            other => panic!("{to}: {other:?}"),
        }
    }
}
