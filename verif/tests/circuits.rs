//! Circuits of `imogene-circuits`: against their golden models clock by clock, and proven the same circuit as the
//! emitted text of the unit, as our Verilog and as rust-hdl prints it. Needs the package 'yosys' and fails without it.

use imogene_circuits::machine::{Beam, Load, Slot, Zone, beam};
use imogene_circuits::units::{self, widths};
use imogene_contract::parameters::Parameters as Built;
use imogene_hdl::block::Block;
use imogene_hdl::{Design, verilog};
use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::{EmitRequest, emit};
use imogene_verif::engine::circuit::Circuit;
use imogene_verif::equivalence::sequential::compare_sequences;
use imogene_verif::equivalence::{Text, Verdict};
use imogene_verif::unit::{Parameters, subject};
use rust_hdl::core::prelude::generate_verilog;

/// The units that are circuits of functions.
fn circuits() -> impl Iterator<Item = Unit> {
    let is_circuit = |unit: &Unit| units::UNITS.iter().any(|(name, _)| *name == unit.name());
    Unit::ALL.into_iter().filter(is_circuit)
}

/// A beam machine of equal slots.
fn machine(word: u32, rows_per_stage: u32, objects: usize, planes: usize) -> Beam {
    let slot = Slot {
        planes,
        two_volumes: true,
    };
    Beam {
        depth: word,
        widths: widths(word),
        rows_per_stage,
        slots: vec![slot; objects],
    }
}

/// The circuit of a unit in a format.
fn design(unit: Unit, depth_word: u32, rows_per_stage: u32) -> Design {
    let parameters = Built {
        rows_per_stage,
        ..Built::of(depth_word)
    };
    units::design(unit.name(), &parameters).expect("a circuit")
}

fn text(design: &Design) -> String {
    let modules = design.top.all();
    modules
        .iter()
        .map(|module| verilog::write(module, ""))
        .collect()
}

fn is_full_run() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

/// Every format of the catalogue in the full run.
fn words() -> &'static [u32] {
    if is_full_run() {
        &[16, 20, 24, 28, 32]
    } else {
        &[16]
    }
}

#[test]
fn circuits_agree_with_their_golden_models() {
    for unit in circuits() {
        for depth_word in [16, 24, 32] {
            for rows_per_stage in [1, 3] {
                let parameters = Parameters {
                    depth_word,
                    rows_per_stage,
                    ..Parameters::default()
                };
                let mut subject = subject(unit.name(), parameters).expect("a unit");
                let (inputs, outputs) = (subject.inputs.clone(), subject.outputs.clone());
                subject.hardware = Box::new(move || {
                    let design = design(unit, depth_word, rows_per_stage as u32);
                    Box::new(Circuit::new(&design, &inputs, &outputs))
                });
                let stimulus = subject.seeded_stimulus(2_000, 19);
                let (report, _) = subject.run(&stimulus, false);
                let name = format!("{} {depth_word}:{rows_per_stage}", unit.name());
                assert_eq!(
                    report.mismatches, 0,
                    "{name}: {:?}",
                    report.first_mismatches
                );
                assert!(report.comparisons > 500, "{name}: {}", report.comparisons);
            }
        }
    }
}

#[test]
fn circuits_are_those_of_the_emitted_text() {
    // The machine has a test of its own.
    for unit in circuits().filter(|unit| *unit != Unit::Beam) {
        for &word in words() {
            let request = EmitRequest {
                depth_word: word as usize,
                ..EmitRequest::new(unit)
            };
            let emitted = emit(&request).expect("a request of the catalogue");
            let emitted_text = emitted.bundle();
            let theirs = Text {
                top: &emitted.top,
                verilog: &emitted_text,
            };
            let design = design(unit, word, 1);
            let own = text(&design);
            let printed = generate_verilog(&Block::of(&design.top));
            for (top, verilog) in [(design.top.name.as_str(), &own), ("top", &printed)] {
                let verdict = compare_sequences(theirs, Text { top, verilog }).unwrap();
                assert_eq!(verdict, Verdict::Equal, "{} {word} {top}", unit.name());
            }
        }
    }
}

/// Two objects with a plane each; four with three planes in the full run.
#[test]
fn a_machine_is_that_of_the_emitted_text() {
    let (objects, planes) = if is_full_run() { (4, 3) } else { (2, 1) };
    let request = EmitRequest {
        depth_word: 16,
        objects,
        planes,
        ..EmitRequest::new(Unit::Beam)
    };
    let emitted = emit(&request).expect("a request of the catalogue");
    let theirs = Text {
        top: &emitted.top,
        verilog: &emitted.bundle(),
    };
    let machine = machine(16, 1, objects, planes);
    let design = Design::of(|| {
        beam("top", Zone::input(), Load::input(32), &machine);
    });
    let ours = Text {
        top: "beam",
        verilog: &text(&design),
    };
    assert_eq!(compare_sequences(theirs, ours).unwrap(), Verdict::Equal);
}

/// A test of the proof: each change of the text is found.
#[test]
fn another_circuit_is_told_apart() {
    let design = design(Unit::Pe1, 16, 1);
    let own = text(&design);
    let changes = [
        (
            "first ? line_begin : next_pixel",
            "start ? line_begin : next_pixel",
        ),
        ("line_value + kept_b", "line_value - kept_b"),
        (
            "reg signed [17:0] pixel_value = 18'sd0",
            "reg signed [17:0] pixel_value = 18'sd1",
        ),
        ("if (start) begin", "if (line) begin"),
    ];
    for (from, to) in changes {
        assert!(own.contains(from), "{from} is not in\n{own}");
        let changed = own.replace(from, to);
        let texts = [&own, &changed].map(|verilog| Text {
            top: "pe1",
            verilog,
        });
        let [one, other] = texts;
        let verdict = compare_sequences(one, other).unwrap();
        assert!(
            matches!(verdict, Verdict::Differs(_)),
            "{from}: {verdict:?}"
        );
    }
}
