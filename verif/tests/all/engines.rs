//! What every simulator of Verilog must do: find a fault, show it, name an undefined bit, say which tool is missing.

use super::{clock as clock_of, unit, verilog};
use imogene_contract::{Request, Unit};
use imogene_verif::engine::simulator::{Simulator, with_verilog};
use imogene_verif::random;
use imogene_verif::subject::Subject;
use imogene_verif::unit::{levelised, subject};

const CLOCKS: usize = 2_000;

fn changed(name: &str, right: &str, wrong: &str, simulator: Simulator) -> Subject {
    let text = verilog(name, 24);
    assert!(text.contains(right), "{name} has no '{right}'");
    let text = text.replacen(right, wrong, 1);
    with_verilog(unit(name, 24), simulator, name, &text).expect("a unit")
}

#[test]
fn a_fault_in_the_verilog_is_found_and_shown() {
    let faults = [
        ("pe1", "<= line_begin + b;", "<= next_line + b;"),
        ("cut_plane", "zp == zb", "zp != zb"),
    ];
    for simulator in Simulator::ALL {
        for (name, right, wrong) in faults {
            let broken = changed(name, right, wrong, simulator);
            let (report, trace) = random::run(&broken, CLOCKS, 11, true);
            assert_eq!(report.engine, simulator.name());
            assert!(report.mismatches > 0, "{name}: '{wrong}' was not found");
            assert!(trace.is_some_and(|trace| !trace.is_empty()));
        }
    }
}

/// Both engines count the same pixels and comparisons of the same stimulus.
#[test]
fn the_scoreboard_is_the_same() {
    let reports = Simulator::ALL.map(|simulator| {
        let unit = changed("quadric_cut", "", "", simulator);
        random::run(&unit, CLOCKS, 5, false).0
    });
    assert!(reports[0].passed(), "{:?}", reports[0].first_mismatches);
    let [one, other] = reports.map(|r| (r.cycles, r.pixels, r.comparisons, r.mismatches));
    assert_eq!(one, other);
}

#[test]
fn an_undefined_bit_is_a_mismatch_without_a_value() {
    let (right, wrong) = ("= line_begin + b;", "= line_begin + b + 1'bx;");
    let broken = changed("pe1", right, wrong, Simulator::Icarus);
    let (report, trace) = random::run(&broken, CLOCKS, 11, true);
    let undefined = |m: &&imogene_verif::report::Mismatch| m.hardware.is_none();
    let first = report.first_mismatches.iter().find(undefined);
    let shown = first.expect("an undefined output").to_string();
    assert!(shown.contains("undefined bits in hardware"), "{shown}");
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("pe1.vcd");
    trace.expect("a trace").write(&path).expect("written");
    let text = std::fs::read_to_string(&path).expect("read");
    assert!(text.contains("bxxxx"), "the waveform shows them as well");
}

#[test]
fn verilog_that_a_simulator_refuses_is_reported() {
    for simulator in Simulator::ALL {
        let text = verilog("pe1", 24).replace("= line_begin + b;", "= line_begin + missing_name;");
        let outcome = with_verilog(unit("pe1", 24), simulator, "pe1", &text);
        let message = outcome.err().expect("a refusal").to_string();
        assert!(message.contains("missing_name"), "{message}");
    }
}

/// The compiled circuit and the levelised one, on every clock, whether their golden model states anything or not.
#[test]
fn compiled_units_are_the_levelised_ones() {
    for unit in Unit::ALL {
        for depth_word in [24, unit.least_word(), 31] {
            let request = Request::of(unit, depth_word);
            let compiled = subject(&request).expect("a unit in its legal range");
            let levelised = levelised(&request, false).expect("a unit in its legal range");
            let [mut here, mut there] = [&compiled, &levelised].map(|unit| (unit.hardware)(1));
            let stimulus = compiled.seeded_stimulus(CLOCKS, 7);
            for (clock, inputs) in stimulus.iter().enumerate() {
                let place = format!("{} at {depth_word}, clock {clock}", unit.name());
                let values = [&mut here, &mut there].map(|unit| clock_of(unit.as_mut(), inputs));
                assert_eq!(values[0], values[1], "{place}");
            }
        }
    }
}

/// Parts give anything for a word that is read while it is written.
#[test]
fn no_unit_uses_what_it_reads_while_it_writes_it() {
    for unit in Unit::ALL {
        let request = Request::of(unit, unit.least_word());
        let upset = levelised(&request, true).expect("a unit in its legal range");
        let (report, _) = random::run(&upset, 5 * CLOCKS, 3, false);
        let name = unit.name();
        assert!(report.passed(), "{name}: {:?}", report.first_mismatches);
    }
}
