//! The emitted Verilog of the units in Verilator against the golden models. Needs the packages 'verilator' and 'g++'
//! and fails without them. A first run compiles each unit, some seconds each: all units under `IMOGENE_FULL=1`, one of
//! each group otherwise.

use super::{compiled, is_full_run, unit, verilog};
use imogene_contract::Unit;
use imogene_verif::engine::simulator::{Simulator, with_verilog};
use imogene_verif::random;
use imogene_verif::unit::units;

const REPRESENTATIVES: [&str; 4] = ["pe2", "square_root", "cut_plane", "quadric_processor"];
const CLOCKS: usize = 5_000;

#[test]
fn emitted_units_agree_with_their_golden_models() {
    let names = match is_full_run() {
        true => units().map(Unit::name).collect(),
        false => REPRESENTATIVES.to_vec(),
    };
    for name in names {
        let text = verilog(name, 24);
        let unit = with_verilog(unit(name, 24), Simulator::Verilator, name, &text);
        let (report, _) = random::run(&unit.expect("a compiled unit"), CLOCKS, 11, false);
        assert_eq!(report.engine, "verilator");
        assert!(report.passed(), "{name}: {:?}", report.first_mismatches);
        assert!(report.cycles >= CLOCKS as u64, "{name}");
        // Results begin after the latency and, in a raster, after a gap at most.
        assert!(report.pixels >= 2_000, "{name}: {} pixels", report.pixels);
    }
}

#[test]
fn instances_of_one_model_do_not_share_registers() {
    let unit = unit("pe1", 24);
    let model = compiled(&unit, &verilog("pe1", 24)).expect("pe1");
    let (mut one, mut other) = (model.instance(), model.instance());
    let mut value = [0];
    one.clock_words(&[1, 1, 0, 3, 0, 100], &mut value);
    assert_eq!(value, [100]);
    other.clock_words(&[1, 1, 0, 5, 0, 7], &mut value);
    assert_eq!(value, [7]);
    one.clock_words(&[1, 0, 0, 3, 0, 0], &mut value);
    assert_eq!(value, [103]);
    let mut moved = std::thread::spawn(move || {
        other.clock_words(&[1, 0, 0, 5, 0, 0], &mut value);
        (other, value)
    })
    .join()
    .expect("no panic");
    assert_eq!(moved.1, [12]);
    moved.0.clock_words(&[1, 0, 0, 5, 0, 0], &mut moved.1);
    assert_eq!(moved.1, [17]);
}

#[test]
fn verilog_that_verilator_refuses_is_reported_and_not_kept() {
    let unit = unit("pe1", 24);
    for _ in 0..2 {
        let text = verilog("pe1", 24);
        let broken = text.replace("= line_begin + b;", "= line_begin + missing_name;");
        let outcome = compiled(&unit, &broken);
        let message = outcome.err().expect("a refusal").to_string();
        assert!(message.contains("missing_name"), "{message}");
    }
}
