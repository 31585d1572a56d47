//! The emitted Verilog of every unit in Icarus Verilog against the golden models, by the scoreboard of every engine.
//! Needs the package 'iverilog' and fails without it. The narrowest and the widest words under `IMOGENE_FULL=1` alone.

use super::{is_full_run, run};
use imogene_contract::Request;
use imogene_rtl::emit::emit;
use imogene_verif::engine::simulator::{Simulator, with_verilog};
use imogene_verif::unit::{subject, units};

/// Clocks per stimulus and stimuli per unit: at least 2 000 compared pixels, edges included.
const CLOCKS: usize = 450;
const STIMULI: u64 = 6;

fn check(request: &Request) {
    let name = request.unit.name();
    let emitted = emit(request).expect("a legal request");
    let subject = subject(request).expect("a legal request");
    let unit = with_verilog(subject, Simulator::Icarus, &emitted.top, &emitted.bundle())
        .unwrap_or_else(|error| panic!("{name}: {error}"));
    let reports = run(&unit, STIMULI, CLOCKS);
    assert!(reports.iter().all(|report| report.engine == "icarus"));
    let pixels: u64 = reports.iter().map(|report| report.pixels).sum();
    // The raster control is stated on every clock, the others from their first pixel on.
    assert!(pixels >= 2_000, "{name}: {pixels} pixels were compared");
}

#[test]
fn units_of_the_base_format() {
    units().for_each(|unit| check(&Request::new(unit)));
}

#[test]
fn units_of_the_narrowest_and_widest_format() {
    if !is_full_run() {
        return;
    }
    for unit in units() {
        for depth_word in [16, 32] {
            check(&Request {
                planes: 1,
                rows_per_stage: 3,
                objects: 5,
                ..Request::of(unit, depth_word)
            });
        }
    }
}
