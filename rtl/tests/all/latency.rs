//! The latency formulas, measured: an impulse at the inputs, and the clock at which an output answers.

use imogene_contract::{Request, Unit};
use imogene_hdl::{Port, Simulator};
use imogene_rtl::emit::design;
use std::collections::BTreeSet;

/// Clocks before the impulse, in which a unit forgets its power-up.
const QUIET: usize = 100;

/// What inputs show: names and values. A star in a name stands for every number.
type Values<'a> = &'a [(&'a str, i64)];

fn is_called(port: &str, name: &str) -> bool {
    match name.split_once('*') {
        None => port == name,
        Some((before, after)) => {
            let inner = port.strip_prefix(before);
            let inner = inner.and_then(|rest| rest.strip_suffix(after));
            inner.is_some_and(|number| number.parse::<u32>().is_ok())
        }
    }
}

/// Clocks from the impulse to the clock at which the output differs from what it was without.
fn measured(request: &Request, held: Values, impulse: Values, output: &str) -> usize {
    let design = design(request).expect("a legal request");
    let mut simulator = Simulator::new(&design);
    let ports = |simulator: &Simulator, values: Values| -> Vec<(Port, u64)> {
        let mut found = vec![];
        for (name, value) in values {
            let before = found.len();
            let names = design.top.ports.iter().map(|port| &port.name);
            let called = names.filter(|port| is_called(port, name));
            found.extend(called.map(|port| (simulator.port(port), *value as u64)));
            let unit = request.unit.name();
            assert!(found.len() > before, "{unit}: no port {name}");
        }
        found
    };
    let (held, impulse) = (ports(&simulator, held), ports(&simulator, impulse));
    let output = simulator.port(output);
    let before: Vec<(Port, u64)> = impulse.iter().map(|(port, _)| (*port, 0)).collect();
    let quiet = |simulator: &mut Simulator| {
        for (port, value) in before.iter().chain(&held) {
            simulator.set(*port, *value);
        }
    };
    quiet(&mut simulator);
    (0..QUIET).for_each(|_| simulator.clock());
    let value = simulator.get(output);
    for (port, value) in &impulse {
        simulator.set(*port, *value);
    }
    for clock in 1..QUIET {
        simulator.clock();
        if simulator.get(output) != value {
            return clock;
        }
        quiet(&mut simulator);
    }
    panic!("{} does not answer", request.unit.name());
}

/// A unit of 16 bits with parameters by option.
fn unit(unit: Unit, values: &[(&'static str, u32)]) -> Request {
    let given: Vec<_> = values
        .iter()
        .map(|(option, value)| (*option, Some(*value)))
        .collect();
    Request::given(unit.name(), 16, &given).expect("legal parameters")
}

fn check(request: &Request, held: Values, impulse: Values, output: &str) {
    let found = measured(request, held, impulse, output);
    assert_eq!(found, request.latency(), "{request:?} at {output}");
}

const GO: Values = &[("valid", 1), ("start", 1)];
const ROOTS: Values = &[("f1_c", 100), ("f2_f", 9), ("gx_c", 2560)];
const QUOTIENT: Values = &[("denominator_c", 5), ("numerator_f", 500), ("gx_c", 2560)];
const ROOTS_OF_PE: Values = &[("f1_c", 100), ("f2_f", 9)];
const RADICAND: Values = &[("radicand", 1 << 30)];
const PICTURE: Values = &[("width", 2), ("height", 2)];
const DEPTH: Values = &[("input_0_depth", -1)];
const OTHER_END: Values = &[("intersected_*_other_end", 9)];
const OWN_DEPTH: Values = &[("intersected_*_depth", -4)];

/// A unit, what its inputs hold, the impulse, and the output that answers.
type Case = (Unit, Values<'static>, Values<'static>, &'static str);

/// Every unit with its default parameters.
const CASES: &[Case] = &[
    (Unit::Pe1, &[("c", 5)], GO, "value"),
    (Unit::Pe2, &[("f", 5)], GO, "value"),
    (Unit::ProgrammablePe, &[("f", 5)], GO, "value"),
    (Unit::MemoryPe2, &[], &[("pixel", 1)], "value_valid"),
    (Unit::SquareRoot, &[], RADICAND, "root"),
    (Unit::SquareRootNonRestoring, &[], RADICAND, "root"),
    (
        Unit::SquareRootIterative,
        &[("radicand", 1)],
        &[("start", 1)],
        "done",
    ),
    (Unit::SquareRootRows, &[], RADICAND, "root"),
    (Unit::SquareRootLeading, &[], RADICAND, "root"),
    (Unit::SquareRootLinear, &[], RADICAND, "root"),
    (Unit::SquareRootQuadratic, &[], RADICAND, "root"),
    (Unit::QuadricPe, ROOTS_OF_PE, GO, "near_sum"),
    (Unit::QuadricPe, ROOTS_OF_PE, GO, "root"),
    (Unit::PlaneDepth, &[("c", 5 << 10)], GO, "depth"),
    (Unit::CutPlane, &[], &[("zf", 1)], "cut_zf"),
    (
        Unit::QuadricCut,
        &[("in_box", 1)],
        &[("is_inside", 1)],
        "zf",
    ),
    (Unit::NormalUnit, &[], &[("number", 15)], "nz"),
    (Unit::NormalUnit, &[("gy_c", 256)], GO, "ny"),
    (
        Unit::PatchDecider,
        &[("in_box", 1)],
        &[("is_inside", 1)],
        "zf",
    ),
    (Unit::QuadricProcessor, ROOTS, GO, "out_valid"),
    (Unit::QuadricProcessor, ROOTS, GO, "zf"),
    (Unit::QuadricProcessor, ROOTS, GO, "zb"),
    (Unit::QuadricProcessor, ROOTS, GO, "nx"),
    (Unit::QuotientProcessor, QUOTIENT, GO, "out_valid"),
    (Unit::QuotientProcessor, QUOTIENT, GO, "zf"),
    (Unit::QuotientProcessor, QUOTIENT, GO, "nx"),
    (Unit::PatchProcessor, ROOTS, GO, "zf"),
    (Unit::PatchProcessor, ROOTS, GO, "out_valid"),
    (Unit::FirstGenerationProcessor, ROOTS, GO, "out_valid"),
    (Unit::PolyhedronProcessor, &[], GO, "out_valid"),
    (Unit::FacetProcessor, &[], GO, "out_valid"),
    (Unit::CurvedFacetProcessor, &[], GO, "out_valid"),
    (Unit::SphereProcessor, &[], GO, "out_valid"),
    (Unit::CylinderProcessor, &[], GO, "out_valid"),
    (Unit::QuadricVolume, &[], GO, "out_valid"),
    (Unit::PolyhedralVolume, &[], GO, "out_valid"),
    (Unit::RasterControl, PICTURE, &[("go", 1)], "valid"),
    (Unit::VisibilityNode, &[], &[("b_depth", -1)], "depth"),
    (Unit::Decider, &[], DEPTH, "depth"),
    (Unit::VisibilityChain, &[], DEPTH, "depth"),
    (Unit::CardDecider, &[], DEPTH, "depth"),
    (Unit::ShadowStage, &[], &[("flags_in", 1)], "flags"),
    (Unit::TransparencyStage, &[], &[("pixel_red", 1)], "red"),
    (
        Unit::TransparencyPipeline,
        &[],
        &[("pixel_depth", 1)],
        "depth",
    ),
    (Unit::CsgProduct, OTHER_END, OWN_DEPTH, "depth"),
    (
        Unit::CoefficientStore,
        &[("address", 25), ("data", 3)],
        &[("write", 1)],
        "plane_0_a",
    ),
    (Unit::Beam, PICTURE, &[("go", 1)], "valid"),
    (Unit::VideoTiming, &[], &[("enable", 1)], "frame_start"),
    (
        Unit::PixelFifo,
        &[("data", 7)],
        &[("started", 1), ("push", 1)],
        "m_tvalid",
    ),
    (Unit::TmdsEncoder, &[], &[("de", 1)], "word"),
    (Unit::TmdsSerialiser, &[("word", 1)], &[("turn", 1)], "pair"),
    (Unit::SceneSequencer, &[], &[("m_tready", 1)], "m_tvalid"),
    (Unit::FrameStore, &[], &[("need", 1)], "valid"),
    // A pixel leaves when the one below it to the right comes.
    (
        Unit::PostFilter,
        &[],
        &[("valid", 1), ("x", 1), ("y", 1)],
        "out_valid",
    ),
    (Unit::Overlay, &[], &[("valid", 1)], "out_valid"),
    (
        Unit::Accumulator,
        &[],
        &[("valid", 1), ("first_pass", 1), ("last_pass", 1)],
        "out_valid",
    ),
    (Unit::ShadingProcessor, &[], &[("valid", 1)], "out_valid"),
    (Unit::LitSphere, &[], &[("valid", 1)], "out_valid"),
    (Unit::LitSphereNearest, &[], &[("valid", 1)], "out_valid"),
];

#[test]
fn every_unit() {
    for (of, held, impulse, output) in CASES {
        check(&unit(*of, &[]), held, impulse, output);
    }
    let measured: BTreeSet<Unit> = CASES.iter().map(|case| case.0).collect();
    assert!(measured.into_iter().eq(Unit::ALL));
}

#[test]
fn root_networks_of_every_depth() {
    for rows in [1, 3, 5, 8, 16] {
        let rows = ("rows-per-stage", rows);
        for of in [Unit::SquareRoot, Unit::SquareRootNonRestoring] {
            check(&unit(of, &[rows]), &[], RADICAND, "root");
        }
        for digits in 1..=16 {
            for of in [Unit::SquareRootRows, Unit::SquareRootLeading] {
                check(
                    &unit(of, &[rows, ("digits", digits)]),
                    &[],
                    RADICAND,
                    "root",
                );
            }
        }
        for output in ["near_sum", "root"] {
            check(&unit(Unit::QuadricPe, &[rows]), ROOTS_OF_PE, GO, output);
        }
    }
    for corrections in 0..=2 {
        for of in [Unit::SquareRootLinear, Unit::SquareRootQuadratic] {
            check(
                &unit(of, &[("corrections", corrections)]),
                &[],
                RADICAND,
                "root",
            );
        }
    }
}

#[test]
fn processors_and_machines_of_every_depth() {
    for (planes, rows) in [(0, 1), (1, 1), (3, 4), (12, 16)] {
        let shape = [("planes", planes), ("rows-per-stage", rows)];
        for output in ["out_valid", "zf", "zb", "nx"] {
            check(&unit(Unit::QuadricProcessor, &shape), ROOTS, GO, output);
            check(&unit(Unit::QuotientProcessor, &shape), QUOTIENT, GO, output);
        }
        for of in [Unit::PatchProcessor, Unit::QuadricVolume] {
            check(&unit(of, &shape), ROOTS_OF_PE, GO, "out_valid");
        }
    }
    for form in [
        "non-restoring",
        "linear0",
        "linear2",
        "quadratic1",
        "leading7",
    ] {
        let with_form = |of| Request {
            root_form: form.parse().expect("a form"),
            ..unit(of, &[("planes", 1), ("rows-per-stage", 3)])
        };
        for output in ["out_valid", "zf", "nx"] {
            check(&with_form(Unit::QuadricProcessor), ROOTS, GO, output);
        }
        for of in [Unit::PatchProcessor, Unit::QuadricVolume] {
            check(&with_form(of), ROOTS_OF_PE, GO, "out_valid");
        }
    }
    for planes in 1..=12 {
        check(
            &unit(Unit::PolyhedronProcessor, &[("planes", planes)]),
            &[],
            GO,
            "out_valid",
        );
    }
    for (objects, planes, rows) in [(1, 0, 4), (2, 1, 16), (5, 2, 3)] {
        let shape = [
            ("objects", objects),
            ("planes", planes),
            ("rows-per-stage", rows),
        ];
        check(&unit(Unit::Beam, &shape), PICTURE, &[("go", 1)], "valid");
    }
}

#[test]
fn deciders_of_every_shape() {
    for inputs in [2, 3, 4, 5, 8, 9, 17] {
        // The last input is the one that may pass registers.
        let last = format!("input_{}_depth", inputs - 1);
        check(
            &unit(Unit::Decider, &[("objects", inputs)]),
            &[],
            &[(&last, -1)],
            "depth",
        );
    }
    assert_eq!(unit(Unit::Decider, &[("objects", 1)]).latency(), 0);
    let cards = [(1, 1), (1, 3), (4, 1), (3, 2), (4, 5)];
    let of_cards = cards.map(|(objects, cards)| {
        (
            unit(Unit::CardDecider, &[("objects", objects), ("cards", cards)]),
            objects,
            cards,
        )
    });
    let chain = |objects| {
        (
            unit(Unit::VisibilityChain, &[("objects", objects)]),
            objects,
            1,
        )
    };
    for (request, objects, cards) in of_cards.into_iter().chain([1, 2, 5, 16].map(chain)) {
        // Input i of a card is taken i clocks after its input 0.
        for input in 0..objects * cards {
            let name = format!("input_{input}_depth");
            let found = measured(&request, &[], &[(&name, -1)], "depth");
            assert_eq!(found + (input % objects) as usize, request.latency());
        }
    }
}

#[test]
fn shadow_stages_and_blends_of_every_depth() {
    for volumes in [1, 8, 9, 64, 65, 256] {
        let request = unit(Unit::ShadowStage, &[("objects", volumes)]);
        check(&request, &[], &[("flags_in", 1)], "flags");
        for volume in [0, volumes - 1] {
            let [enabled, inside] =
                ["enabled", "inside"].map(|what| format!("volume_{volume}_{what}"));
            check(
                &request,
                &[("flags_in", 1), (&enabled, 1)],
                &[(&inside, 1)],
                "flags",
            );
        }
    }
    for layers in 1..=8 {
        let request = unit(Unit::TransparencyPipeline, &[("layers", layers)]);
        check(&request, &[], &[("pixel_depth", 1)], "depth");
        // Layer i is taken 4 i clocks after the pixel.
        for layer in 0..layers {
            let [red, weight] = ["red", "weight"].map(|what| format!("layer_{layer}_{what}"));
            let found = measured(
                &request,
                &[("pixel_depth", 5), (&red, 200)],
                &[(&weight, 255)],
                "red",
            );
            assert_eq!(found + 4 * layer as usize, request.latency());
        }
    }
}

#[test]
fn solids_of_every_depth() {
    for (intersected, subtracted) in [(1, 0), (1, 1), (2, 2), (3, 1), (5, 3), (8, 8)] {
        let shape = [("intersected", intersected), ("subtracted", subtracted)];
        let solid = unit(Unit::CsgProduct, &shape);
        check(&solid, OTHER_END, OWN_DEPTH, "depth");
        if subtracted == 0 {
            continue;
        }
        // What is taken away is used after the tree of the intersection.
        let skew = u32::next_power_of_two(intersected).trailing_zeros() as usize;
        let impulse: Values = &[("subtracted_0_depth", 3)];
        let found = measured(&solid, OTHER_END, impulse, "depth");
        assert_eq!(found + skew, solid.latency());
    }
}
