//! The emitted Verilog of every unit in Icarus Verilog against golden vectors. Needs the package 'iverilog' and fails without it.

use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::emit;
use imogene_verif::icarus;
use imogene_verif::unit::{NAMES, Parameters, subject};

/// Clocks per stimulus and stimuli per unit: at least 2 000 compared pixels, edges included.
const CLOCKS: usize = 450;
const STIMULI: u64 = 6;

fn check(name: &str, parameters: Parameters) {
    let unit = Unit::from_name(name).expect("a unit of the catalogue");
    let request = parameters.request(unit);
    let emitted = emit(&request).expect("a legal request");
    let text = emitted.bundle();
    let subject = subject(name, parameters).expect("a legal subject");
    let mut pixels = 0;
    for seed in 0..STIMULI {
        let stimulus = subject.seeded_stimulus(CLOCKS, seed);
        let report = icarus::run(&subject, &emitted.top, &text, &stimulus)
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        assert_eq!(
            report.mismatches, 0,
            "{name} {}, seed {seed}: {:?}",
            subject.options, report.first_mismatches
        );
        pixels += report.pixels;
    }
    // The raster control is stated on every clock, the others from their first pixel on.
    assert!(
        pixels >= 2_000,
        "{name}: only {pixels} pixels were compared"
    );
}

#[test]
fn units_of_the_base_format() {
    for name in NAMES {
        check(name, Parameters::default());
    }
}

#[test]
fn units_of_the_narrowest_and_widest_format() {
    for name in NAMES {
        for depth_word in [16, 32] {
            check(
                name,
                Parameters {
                    depth_word,
                    planes: 1,
                    rows_per_stage: 3,
                    objects: 5,
                    ..Parameters::default()
                },
            );
        }
    }
}
