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
fn other_processors_with_every_number_of_planes_and_sides() {
    for planes in 0..=12 {
        let parameters = Parameters {
            planes,
            rows_per_stage: 7,
            ..Parameters::default()
        };
        for name in [
            "patch_decider",
            "patch_processor",
            "quadric_volume",
            "polyhedral_volume",
            "polyhedron_processor",
        ] {
            if planes > 0 || name != "polyhedron_processor" {
                check(name, parameters, CLOCKS);
            }
        }
    }
    for (name, sides) in [
        ("facet_processor", 3..=4),
        ("curved_facet_processor", 1..=4),
    ] {
        for sides in sides {
            let parameters = Parameters {
                sides: Some(sides),
                ..Parameters::default()
            };
            check(name, parameters, CLOCKS);
        }
    }
}

/// The hardware's latency and the golden model's are stated by two crates that do not know each other.
#[test]
fn both_sides_state_the_same_latency() {
    use imogene_models::object::{
        curved_facet, cylinder, facet, first_generation, patch, polyhedron, quadric, sphere, volume,
    };
    use imogene_rtl::catalogue::Unit;
    for depth_word in Format::CATALOGUE {
        let format = Format::new(depth_word).unwrap();
        for planes in 1..=12 {
            for rows in [1, 3, 7, 16] {
                let stated = |unit| {
                    let parameters = Parameters {
                        depth_word,
                        planes,
                        rows_per_stage: rows,
                        ..Parameters::default()
                    };
                    parameters.request(unit).latency() as u32
                };
                let rows = rows as u32;
                let pairs = [
                    (
                        Unit::QuadricProcessor,
                        quadric::latency(&format, planes, rows),
                    ),
                    (Unit::PatchProcessor, patch::latency(&format, rows)),
                    (
                        Unit::FirstGenerationProcessor,
                        first_generation::latency(&format, rows),
                    ),
                    (Unit::PolyhedronProcessor, polyhedron::latency(planes)),
                    (Unit::QuadricVolume, volume::quadric_latency(&format, rows)),
                    (Unit::PolyhedralVolume, volume::polyhedral_latency()),
                    (Unit::FacetProcessor, facet::LATENCY),
                    (Unit::CurvedFacetProcessor, curved_facet::LATENCY),
                    (Unit::SphereProcessor, sphere::LATENCY),
                    (Unit::CylinderProcessor, cylinder::LATENCY),
                ];
                for (unit, golden) in pairs {
                    assert_eq!(
                        stated(unit),
                        golden,
                        "{} {depth_word} {planes}",
                        unit.name()
                    );
                }
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
