//! Every unit against its golden model, cycle by cycle, on random stimulus biased to the edges; failures shrink and are
//! replayed from their seeds.

use super::request;
use imogene_contract::{MachineWords, Request, RootForm, Unit};
use imogene_golden::format::Format;
use imogene_verif::subject::LANES;
use imogene_verif::unit::{subject, units};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::test_runner::{Config, TestRunner};

/// Stimuli per configuration; `scripts/test --full` asks for more.
fn cases() -> u32 {
    let what = "IMOGENE_CASES is a number of stimuli per configuration";
    std::env::var("IMOGENE_CASES").map_or(24, |text| text.parse().expect(what))
}

fn check(request: &Request, clocks: usize) {
    let name = request.unit.name();
    let subject = subject(request).expect("a unit in its legal range");
    let mut runner = TestRunner::new(Config {
        cases: cases().div_ceil(LANES as u32),
        // Replayable without files: proptest prints the minimal stimulus, and the seed of a run is fixed below.
        failure_persistence: None,
        ..Config::default()
    });
    let stimuli = vec((subject.stimulus)(&subject, clocks), LANES);
    let outcome = runner.run(&stimuli, |stimuli| {
        for (report, _) in subject.run_all(&stimuli, false) {
            let first = report.first_mismatches.first();
            prop_assert!(first.is_none(), "{name} {}: {first:?}", subject.options);
            prop_assert!(report.comparisons > 0, "{name}: nothing was compared");
        }
        Ok(())
    });
    if let Err(failure) = outcome {
        panic!("{name} {}: {failure}", subject.options);
    }
}

/// At the base format with these parameters.
fn check_with(unit: Unit, options: &[(&'static str, u32)]) {
    check(&request(unit.name(), 24, options), CLOCKS);
}

/// Clocks of a stimulus: longer than the deepest pipeline.
const CLOCKS: usize = 120;

#[test]
fn every_unit_at_every_format() {
    for unit in units() {
        let least = unit.least_word();
        for depth_word in Format::CATALOGUE.into_iter().chain([least, 13, 27, 31]) {
            check(&Request::of(unit, depth_word), CLOCKS);
        }
    }
}

#[test]
fn root_networks_at_all_rows_per_stage() {
    for rows_per_stage in 1..=24 {
        let rows = [("rows-per-stage", rows_per_stage)];
        check_with(Unit::SquareRoot, &rows);
        check_with(Unit::SquareRootNonRestoring, &rows);
        check_with(Unit::SquareRootRows, &rows);
        check_with(Unit::SquareRootLeading, &rows);
    }
}

#[test]
fn shortened_and_corrected_roots_of_every_parameter() {
    for digits in 1..=24 {
        for unit in [Unit::SquareRootRows, Unit::SquareRootLeading] {
            check_with(unit, &[("digits", digits), ("rows-per-stage", 3)]);
        }
    }
    for corrections in 0..=2 {
        for unit in [Unit::SquareRootLinear, Unit::SquareRootQuadratic] {
            check_with(unit, &[("corrections", corrections)]);
        }
    }
}

/// Every form of the root of an object, the shortest and the longest with its digits.
fn forms() -> Vec<RootForm> {
    let corrected = (0..=2).flat_map(|count| [RootForm::Linear(count), RootForm::Quadratic(count)]);
    let leading = [1, 5, 16].map(RootForm::Leading);
    let exact = [
        RootForm::Restoring,
        RootForm::NonRestoring,
        RootForm::Iterative,
    ];
    exact.into_iter().chain(corrected).chain(leading).collect()
}

#[test]
fn processors_with_every_form_of_the_root() {
    for unit in units().filter(|unit| unit.has_object_root()) {
        for (depth_word, rows_per_stage) in [(16, 1), (24, 5), (32, 3)] {
            for root_form in forms() {
                let request = Request {
                    rows_per_stage,
                    root_form,
                    ..Request::of(unit, depth_word)
                };
                check(&request, CLOCKS);
            }
        }
    }
}

#[test]
fn processors_with_0_to_12_planes() {
    for planes in 0..=12 {
        for rows_per_stage in [1, 5, 24] {
            let options = [("planes", planes), ("rows-per-stage", rows_per_stage)];
            check_with(Unit::QuadricProcessor, &options);
            check_with(Unit::QuotientProcessor, &options);
        }
        check(&request("normal_unit", 24, &[("planes", planes)]), 30);
    }
}

#[test]
fn other_processors_with_every_number_of_planes_and_sides() {
    for unit in [
        Unit::PatchDecider,
        Unit::PatchProcessor,
        Unit::QuadricVolume,
        Unit::PolyhedralVolume,
        Unit::PolyhedronProcessor,
    ] {
        for planes in u32::from(unit == Unit::PolyhedronProcessor)..=12 {
            let request = Request {
                planes,
                rows_per_stage: 7,
                ..Request::new(unit)
            };
            check(&request, CLOCKS);
        }
    }
    for (unit, sides) in [
        (Unit::FacetProcessor, 3..=4),
        (Unit::CurvedFacetProcessor, 1..=4),
    ] {
        for sides in sides {
            check_with(unit, &[("sides", sides)]);
        }
    }
}

/// The hardware's latency and the golden model's are stated by two crates that do not know each other.
#[test]
fn both_sides_state_the_same_latency() {
    use imogene_golden::object::{
        curved_facet, cylinder, facet, first_generation, patch, polyhedron, quadric, quotient,
        sphere, volume,
    };
    let words = Format::CATALOGUE.into_iter();
    let all = words.flat_map(|word| forms().into_iter().map(move |f| (word, f)));
    for (depth_word, root_form) in all {
        let words = MachineWords {
            root_form,
            ..MachineWords::of(depth_word)
        };
        let format = Format::fitted(&words).unwrap();
        for planes in [1, 2, 12] {
            for rows in [1, 3, 7, 16] {
                let stated = |unit: Unit| {
                    let request = Request {
                        planes: planes as u32,
                        rows_per_stage: rows,
                        root_form: match unit.has_object_root() {
                            true => root_form,
                            false => RootForm::default(),
                        },
                        ..Request::of(unit, depth_word)
                    };
                    request.latency() as u32
                };
                let first = first_generation::latency(&format, rows);
                let quadric = quadric::latency(&format, planes, rows);
                let quotient = quotient::latency(&format, planes, rows);
                let pairs = [
                    (Unit::QuadricProcessor, quadric),
                    (Unit::QuotientProcessor, quotient),
                    (Unit::PatchProcessor, patch::latency(&format, rows)),
                    (Unit::FirstGenerationProcessor, first),
                    (Unit::PolyhedronProcessor, polyhedron::latency(planes)),
                    (Unit::QuadricVolume, volume::quadric_latency(&format, rows)),
                    (Unit::PolyhedralVolume, volume::polyhedral_latency()),
                    (Unit::FacetProcessor, facet::LATENCY),
                    (Unit::CurvedFacetProcessor, curved_facet::LATENCY),
                    (Unit::SphereProcessor, sphere::LATENCY),
                    (Unit::CylinderProcessor, cylinder::LATENCY),
                ];
                for (unit, golden) in pairs {
                    let name = unit.name();
                    assert_eq!(stated(unit), golden, "{name} {depth_word} {planes}");
                }
            }
        }
    }
}

#[test]
fn deciders_of_every_shape_of_tree() {
    for objects in [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 13, 16, 17] {
        check(&request("decider", 24, &[("objects", objects)]), 30);
    }
}
