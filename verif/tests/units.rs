//! Every unit against its golden model, cycle by cycle, on random stimulus biased to the edges; failures shrink and are replayed from
//! their seeds.

use imogene_models::format::Format;
use imogene_verif::unit::{NAMES, Parameters, subject};
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Stimuli per configuration; `scripts/test --full` asks for more.
fn cases() -> u32 {
    std::env::var("IMOGENE_CASES").map_or(24, |text| {
        text.parse()
            .expect("IMOGENE_CASES is a number of stimuli per configuration")
    })
}

fn check(name: &str, parameters: Parameters, clocks: usize) {
    let subject = subject(name, parameters).expect("a unit in its legal range");
    let mut runner = TestRunner::new(Config {
        cases: cases(),
        // Replayable without files: proptest prints the minimal stimulus, and the seed of a run is fixed below.
        failure_persistence: None,
        ..Config::default()
    });
    let stimulus = (subject.stimulus)(&subject, clocks);
    let outcome = runner.run(&stimulus, |stimulus| {
        let (report, _) = subject.run(&stimulus, false);
        prop_assert!(
            report.mismatches == 0,
            "{name} {}: {}",
            subject.options,
            report.first_mismatches[0]
        );
        prop_assert!(report.comparisons > 0, "{name}: nothing was compared");
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{name} {}: {failure}", subject.options);
    }
}

/// Clocks of a stimulus: longer than the deepest pipeline.
const CLOCKS: usize = 120;

#[test]
fn every_unit_at_every_format() {
    for name in NAMES {
        for depth_word in Format::CATALOGUE {
            let parameters = Parameters {
                depth_word,
                ..Parameters::default()
            };
            check(name, parameters, CLOCKS);
        }
    }
}

#[test]
fn root_networks_at_all_rows_per_stage() {
    for rows_per_stage in 1..=24 {
        let parameters = Parameters {
            rows_per_stage,
            ..Parameters::default()
        };
        for name in [
            "square_root",
            "square_root_non_restoring",
            "square_root_rows",
            "square_root_leading",
        ] {
            check(name, parameters, CLOCKS);
        }
    }
}

#[test]
fn shortened_and_corrected_roots_of_every_parameter() {
    for digits in 1..=24 {
        let parameters = Parameters {
            digits: Some(digits),
            rows_per_stage: 3,
            ..Parameters::default()
        };
        for name in ["square_root_rows", "square_root_leading"] {
            check(name, parameters, CLOCKS);
        }
    }
    for corrections in 0..=2 {
        let parameters = Parameters {
            corrections: Some(corrections),
            ..Parameters::default()
        };
        for name in ["square_root_linear", "square_root_quadratic"] {
            check(name, parameters, CLOCKS);
        }
    }
}

#[test]
fn processors_with_0_to_12_planes() {
    for planes in 0..=12 {
        for rows_per_stage in [1, 5, 24] {
            let parameters = Parameters {
                planes,
                rows_per_stage,
                ..Parameters::default()
            };
            check("quadric_processor", parameters, CLOCKS);
            if rows_per_stage == 1 {
                check("normal_unit", parameters, 30);
            }
        }
    }
}

#[test]
fn deciders_of_every_shape_of_tree() {
    for objects in [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 13, 16, 17] {
        let parameters = Parameters {
            objects,
            ..Parameters::default()
        };
        check("decider", parameters, 30);
    }
}
