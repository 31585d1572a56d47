//! The latency formulas, measured: an impulse at the inputs, and the clock at which an output answers.

use imogene_contract::{Request, Unit};
use imogene_hdl::{Port, Simulator};
use imogene_rtl::emit::design;
use std::collections::BTreeSet;

/// Clocks before the impulse, in which a unit forgets its power-up.
const QUIET: usize = 100;

/// What inputs show: names and values. A star in a name stands for every number.
fn values(text: &str) -> impl Iterator<Item = (&str, u64)> {
    let value = |text: &str| text.parse::<i64>().expect("a number") as u64;
    let each = text.split(", ").filter(|one| !one.is_empty());
    each.map(move |one| {
        let (name, number) = one.split_once(' ').expect("a name and a value");
        (name, value(number))
    })
}

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
fn measured(request: &Request, held: &str, impulse: &str, output: &str) -> usize {
    let design = design(request).expect("a legal request");
    let mut simulator = Simulator::new(&design);
    let ports = |simulator: &Simulator, text: &str| -> Vec<(Port, u64)> {
        let mut found = vec![];
        for (name, value) in values(text) {
            let before = found.len();
            let names = design.top.ports.iter().map(|port| &port.name);
            let called = names.filter(|port| is_called(port, name));
            found.extend(called.map(|port| (simulator.port(port), value)));
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
    let given = values.iter().map(|(option, value)| (*option, Some(*value)));
    let given: Vec<_> = given.collect();
    Request::given(unit.name(), 16, &given).expect("legal parameters")
}

fn check(request: &Request, held: &str, impulse: &str, output: &str) {
    let found = measured(request, held, impulse, output);
    assert_eq!(found, request.latency(), "{request:?} at {output}");
}

const GO: &str = "valid 1, start 1";
const ROOTS: &str = "f1_c 100, f2_f 9, gx_c 2560";
const QUOTIENT: &str = "denominator_c 5, numerator_f 500, gx_c 2560";
const ROOTS_OF_PE: &str = "f1_c 100, f2_f 9";
const RADICAND: &str = "radicand 1073741824";
const PICTURE: &str = "width 2, height 2";
const OTHER_END: &str = "intersected_*_other_end 9";
const OWN_DEPTH: &str = "intersected_*_depth -4";

/// Every unit with its default parameters: what its inputs hold, the impulse, and the output that answers. A pixel
/// leaves the filter when the one below it to the right comes.
const CASES: &str = "
    pe1                        | c 5                                         | valid 1, start 1                   | value
    pe2                        | f 5                                         | valid 1, start 1                   | value
    programmable_pe            | f 5                                         | valid 1, start 1                   | value
    memory_pe2                 |                                             | pixel 1                            | value_valid
    square_root                |                                             | radicand 1073741824                | root
    square_root_non_restoring  |                                             | radicand 1073741824                | root
    square_root_iterative      | radicand 1                                  | start 1                            | done
    square_root_rows           |                                             | radicand 1073741824                | root
    square_root_leading        |                                             | radicand 1073741824                | root
    square_root_linear         |                                             | radicand 1073741824                | root
    square_root_quadratic      |                                             | radicand 1073741824                | root
    quadric_pe                 | f1_c 100, f2_f 9                            | valid 1, start 1                   | near_sum
    quadric_pe                 | f1_c 100, f2_f 9                            | valid 1, start 1                   | root
    plane_depth                | c 5120                                      | valid 1, start 1                   | depth
    cut_plane                  |                                             | zf 1                               | cut_zf
    quadric_cut                | in_box 1                                    | is_inside 1                        | zf
    normal_unit                |                                             | number 15                          | nz
    normal_unit                | gy_c 256                                    | valid 1, start 1                   | ny
    patch_decider              | in_box 1                                    | is_inside 1                        | zf
    quadric_processor          | f1_c 100, f2_f 9, gx_c 2560                 | valid 1, start 1                   | out_valid
    quadric_processor          | f1_c 100, f2_f 9, gx_c 2560                 | valid 1, start 1                   | zf
    quadric_processor          | f1_c 100, f2_f 9, gx_c 2560                 | valid 1, start 1                   | zb
    quadric_processor          | f1_c 100, f2_f 9, gx_c 2560                 | valid 1, start 1                   | nx
    quotient_processor         | denominator_c 5, numerator_f 500, gx_c 2560 | valid 1, start 1                   | out_valid
    quotient_processor         | denominator_c 5, numerator_f 500, gx_c 2560 | valid 1, start 1                   | zf
    quotient_processor         | denominator_c 5, numerator_f 500, gx_c 2560 | valid 1, start 1                   | nx
    patch_processor            | f1_c 100, f2_f 9, gx_c 2560                 | valid 1, start 1                   | zf
    patch_processor            | f1_c 100, f2_f 9, gx_c 2560                 | valid 1, start 1                   | out_valid
    first_generation_processor | f1_c 100, f2_f 9, gx_c 2560                 | valid 1, start 1                   | out_valid
    polyhedron_processor       |                                             | valid 1, start 1                   | out_valid
    facet_processor            |                                             | valid 1, start 1                   | out_valid
    curved_facet_processor     |                                             | valid 1, start 1                   | out_valid
    sphere_processor           |                                             | valid 1, start 1                   | out_valid
    cylinder_processor         |                                             | valid 1, start 1                   | out_valid
    quadric_volume             |                                             | valid 1, start 1                   | out_valid
    polyhedral_volume          |                                             | valid 1, start 1                   | out_valid
    raster_control             | width 2, height 2                           | go 1                               | valid
    visibility_node            |                                             | b_depth -1                         | depth
    decider                    |                                             | input_0_depth -1                   | depth
    visibility_chain           |                                             | input_0_depth -1                   | depth
    card_decider               |                                             | input_0_depth -1                   | depth
    shadow_stage               |                                             | flags_in 1                         | flags
    transparency_stage         |                                             | pixel_red 1                        | red
    transparency_pipeline      |                                             | pixel_depth 1                      | depth
    csg_product                | intersected_*_other_end 9                   | intersected_*_depth -4             | depth
    coefficient_store          | address 25, data 3                          | write 1                            | plane_0_a
    beam                       | width 2, height 2                           | go 1                               | valid
    video_timing               |                                             | enable 1                           | frame_start
    pixel_fifo                 | data 7                                      | started 1, push 1                  | m_tvalid
    line_merger                |                                             | s_tvalid 1, s_tlast 1              | m_tvalid
    tmds_encoder               |                                             | de 1                               | word
    tmds_serialiser            | word 1                                      | turn 1                             | pair
    scene_sequencer            |                                             | m_tready 1                         | m_tvalid
    frame_store                |                                             | need 1                             | valid
    post_filter                |                                             | valid 1, x 1, y 1                  | out_valid
    overlay                    |                                             | valid 1                            | out_valid
    accumulator                |                                             | valid 1, first_pass 1, last_pass 1 | out_valid
    shading_processor          |                                             | valid 1                            | out_valid
    lit_sphere                 |                                             | valid 1                            | out_valid
    lit_sphere_nearest         |                                             | valid 1                            | out_valid
";

#[test]
fn every_unit() {
    let mut measured = BTreeSet::new();
    for case in CASES.lines().filter(|line| !line.is_empty()) {
        let cells: Vec<&str> = case.split('|').map(str::trim).collect();
        let of = Unit::from_name(cells[0]).expect("a unit");
        check(&unit(of, &[]), cells[1], cells[2], cells[3]);
        measured.insert(of);
    }
    assert!(measured.into_iter().eq(Unit::ALL));
}

#[test]
fn root_networks_of_every_depth() {
    for rows in [1, 3, 5, 8, 16] {
        let rows = ("rows-per-stage", rows);
        for of in [Unit::SquareRoot, Unit::SquareRootNonRestoring] {
            check(&unit(of, &[rows]), "", RADICAND, "root");
        }
        for digits in 1..=16 {
            for of in [Unit::SquareRootRows, Unit::SquareRootLeading] {
                let request = unit(of, &[rows, ("digits", digits)]);
                check(&request, "", RADICAND, "root");
            }
        }
        for output in ["near_sum", "root"] {
            check(&unit(Unit::QuadricPe, &[rows]), ROOTS_OF_PE, GO, output);
        }
    }
    for corrections in 0..=2 {
        for of in [Unit::SquareRootLinear, Unit::SquareRootQuadratic] {
            let request = unit(of, &[("corrections", corrections)]);
            check(&request, "", RADICAND, "root");
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
    for form in "non-restoring linear0 linear2 quadratic1 leading7".split(' ') {
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
        let request = unit(Unit::PolyhedronProcessor, &[("planes", planes)]);
        check(&request, "", GO, "out_valid");
    }
    for (objects, planes, rows) in [(1, 0, 4), (2, 1, 16), (5, 2, 3)] {
        let planes = ("planes", planes);
        let shape = [("objects", objects), planes, ("rows-per-stage", rows)];
        check(&unit(Unit::Beam, &shape), PICTURE, "go 1", "valid");
    }
}

#[test]
fn deciders_of_every_shape() {
    for inputs in [2, 3, 4, 5, 8, 9, 17] {
        // The last input is the one that may pass registers.
        let last = format!("input_{}_depth -1", inputs - 1);
        let request = unit(Unit::Decider, &[("objects", inputs)]);
        check(&request, "", &last, "depth");
    }
    assert_eq!(unit(Unit::Decider, &[("objects", 1)]).latency(), 0);
    let of_cards = [(1, 1), (1, 3), (4, 1), (3, 2), (4, 5)].map(|(objects, cards)| {
        let shape = [("objects", objects), ("cards", cards)];
        (unit(Unit::CardDecider, &shape), objects, cards)
    });
    let chain = |objects| {
        let request = unit(Unit::VisibilityChain, &[("objects", objects)]);
        (request, objects, 1)
    };
    for (request, objects, cards) in of_cards.into_iter().chain([1, 2, 5, 16].map(chain)) {
        // Input i of a card is taken i clocks after its input 0.
        for input in 0..objects * cards {
            let found = measured(&request, "", &format!("input_{input}_depth -1"), "depth");
            assert_eq!(found + (input % objects) as usize, request.latency());
        }
    }
}

#[test]
fn shadow_stages_and_blends_of_every_depth() {
    for volumes in [1, 8, 9, 64, 65, 256] {
        let request = unit(Unit::ShadowStage, &[("objects", volumes)]);
        check(&request, "", "flags_in 1", "flags");
        for volume in [0, volumes - 1] {
            let held = format!("flags_in 1, volume_{volume}_enabled 1");
            let inside = format!("volume_{volume}_inside 1");
            check(&request, &held, &inside, "flags");
        }
    }
    for layers in 1..=8 {
        let request = unit(Unit::TransparencyPipeline, &[("layers", layers)]);
        check(&request, "", "pixel_depth 1", "depth");
        // Layer i is taken 4 i clocks after the pixel.
        for layer in 0..layers {
            let held = format!("pixel_depth 5, layer_{layer}_red 200");
            let found = measured(&request, &held, &format!("layer_{layer}_weight 255"), "red");
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
        let found = measured(&solid, OTHER_END, "subtracted_0_depth 3", "depth");
        assert_eq!(found + skew, solid.latency());
    }
}
