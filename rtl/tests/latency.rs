//! The latency formulas, measured: an impulse at the input, and the clock at which the output answers.

use imogene_rtl::catalogue::Unit;
use imogene_rtl::emit::EmitRequest;
use imogene_rtl::machine::beam::Beam;
use imogene_rtl::machine::card_decider::CardDecider;
use imogene_rtl::machine::coefficient_store::CoefficientStore;
use imogene_rtl::machine::csg_decider::CsgDecider;
use imogene_rtl::machine::decider::Decider;
use imogene_rtl::machine::raster_control::RasterControl;
use imogene_rtl::machine::shadow_stage::ShadowStage;
use imogene_rtl::machine::transparency_pipeline::TransparencyPipeline;
use imogene_rtl::machine::transparency_stage::TransparencyStage;
use imogene_rtl::machine::visibility_chain::VisibilityChain;
use imogene_rtl::machine::visibility_node::VisibilityNode;
use imogene_rtl::object::quadric_processor::QuadricProcessor;
use imogene_rtl::step::{Clocked, step};
use imogene_rtl::unit::cut_plane::CutPlane;
use imogene_rtl::unit::depth_interval::DepthInterval;
use imogene_rtl::unit::normal_unit::NormalUnit;
use imogene_rtl::unit::pe1::Pe1;
use imogene_rtl::unit::pe2::Pe2;
use imogene_rtl::unit::plane_depth::PlaneDepth;
use imogene_rtl::unit::quadric_pe::QuadricPe;
use imogene_rtl::unit::square_root::SquareRoot;
use imogene_rtl::unit::square_root_iterative::SquareRootIterative;
use imogene_rtl::unit::square_root_leading::SquareRootLeading;
use imogene_rtl::unit::square_root_linear::SquareRootLinear;
use imogene_rtl::unit::square_root_non_restoring::SquareRootNonRestoring;
use imogene_rtl::unit::square_root_quadratic::SquareRootQuadratic;
use imogene_rtl::unit::square_root_rows::SquareRootRows;
use imogene_rtl::unit::two_volume_merge::TwoVolumeMerge;
use imogene_rtl::word::{Int, Word};

const W: usize = 16;
type Network = SquareRoot<32, W, 17, 18>;
type Depths = QuadricPe<W, 17, 18, 32>;
type Processor = QuadricProcessor<W, 17, 18, 32, 28>;
type Machine = Beam<W, 17, 18, 32, 28>;

/// Clocks until the output differs from what it would be without the impulse. Before the impulse the block runs long
/// enough to forget its power-up.
fn measured<B: Clocked>(
    mut block: B,
    drive: impl Fn(&mut B, bool),
    output: impl Fn(&B) -> i64,
) -> usize {
    block.connect_all();
    for _ in 0..100 {
        drive(&mut block, false);
        step(&mut block);
    }
    let quiet = output(&block);
    for clock in 1..100 {
        drive(&mut block, clock == 1);
        step(&mut block);
        if output(&block) != quiet {
            return clock;
        }
    }
    panic!("the block does not answer");
}

fn request(unit: Unit, planes: usize, rows_per_stage: usize, objects: usize) -> EmitRequest {
    EmitRequest {
        depth_word: W,
        planes,
        rows_per_stage,
        objects,
        ..EmitRequest::new(unit)
    }
}

/// The formula of the catalogue.
fn formula(unit: Unit, planes: usize, rows_per_stage: usize, objects: usize) -> usize {
    request(unit, planes, rows_per_stage, objects).latency()
}

#[test]
fn small_units() {
    let found = measured(
        Pe1::<W>::default(),
        |unit, on| {
            [unit.valid.next, unit.start.next] = [on; 2];
            unit.c.next = Int::new(5);
        },
        |unit| unit.value.val().get(),
    );
    assert_eq!(
        (found, found),
        (Pe1::<W>::latency(), formula(Unit::Pe1, 0, 1, 1))
    );
    let found = measured(
        Pe2::<W>::default(),
        |unit, on| {
            [unit.valid.next, unit.start.next] = [on; 2];
            unit.f.next = Int::new(5);
        },
        |unit| unit.value.val().get(),
    );
    assert_eq!(
        (found, found),
        (Pe2::<W>::latency(), formula(Unit::Pe2, 0, 1, 1))
    );
    let found = measured(
        PlaneDepth::<W, 28>::new(),
        |unit, on| {
            [unit.valid.next, unit.start.next] = [on; 2];
            unit.c.next = Int::new(5);
        },
        |unit| unit.depth.val().get(),
    );
    assert_eq!(
        (found, found),
        (
            PlaneDepth::<W, 28>::latency(),
            formula(Unit::PlaneDepth, 0, 1, 1)
        )
    );
    let found = measured(
        DepthInterval::<W, 18>::new(),
        |unit, on| {
            [unit.is_inside.next, unit.in_box.next] = [on, true];
        },
        |unit| unit.zf_a.val().get(),
    );
    assert_eq!(
        (found, found),
        (
            DepthInterval::<W, 18>::latency(),
            formula(Unit::DepthInterval, 0, 1, 1)
        )
    );
    let found = measured(
        CutPlane::<W>::new(),
        |unit, on| unit.zf.next = Int::new(on.into()),
        |unit| unit.cut_zf.val().get(),
    );
    assert_eq!(
        (found, found),
        (CutPlane::<W>::latency(), formula(Unit::CutPlane, 0, 1, 1))
    );
    let found = measured(
        TwoVolumeMerge::<W>::default(),
        |unit, on| unit.zf_b.next = Int::new(if on { -1 } else { 0 }),
        |unit| unit.zf.val().get(),
    );
    assert_eq!(
        (found, found),
        (
            TwoVolumeMerge::<W>::latency(),
            formula(Unit::TwoVolumeMerge, 0, 1, 1)
        )
    );
    let found = measured(
        NormalUnit::<W>::new(0),
        |unit, on| unit.number.next = Word::new(if on { 15 } else { 0 }),
        |unit| unit.nz.val().get(),
    );
    assert_eq!(
        (found, found),
        (
            NormalUnit::<W>::latency(),
            formula(Unit::NormalUnit, 0, 1, 1)
        )
    );
}

#[test]
fn first_degree_part_of_the_normal_meets_its_face() {
    let found = measured(
        NormalUnit::<W>::new(0),
        |unit, on| {
            [unit.valid.next, unit.start.next] = [on; 2];
            unit.gy_c.next = Int::new(256);
        },
        |unit| unit.ny.val().get(),
    );
    assert_eq!(found, NormalUnit::<W>::latency());
}

#[test]
fn root_network_and_quadric_pe() {
    for rows in [1, 3, 5, 8, 16] {
        let root = measured(
            Network::new(rows),
            |unit, on| unit.radicand.next = Word::new(on.into()),
            |unit| unit.root.val().get() as i64,
        );
        assert_eq!(
            (root, root),
            (
                Network::latency(rows),
                formula(Unit::SquareRoot, 0, rows, 1)
            )
        );
        let drive = |unit: &mut Depths, on: bool| {
            [unit.valid.next, unit.start.next] = [on; 2];
            unit.f1_c.next = Int::new(100);
            unit.f2_f.next = Int::new(9);
        };
        let depths = measured(Depths::new(rows), drive, |unit| unit.near_sum.val().get());
        assert_eq!(
            (depths, depths),
            (Depths::latency(rows), formula(Unit::QuadricPe, 0, rows, 1))
        );
        let beside = measured(Depths::new(rows), drive, |unit| {
            unit.root.val().get() as i64
        });
        assert_eq!(beside, depths);
    }
}

/// Drives the radicand of a root unit and reads its root.
macro_rules! measured_root {
    ($block:expr) => {
        measured(
            $block,
            |unit, on| unit.radicand.next = Word::new(if on { 1 << 30 } else { 0 }),
            |unit| unit.root.val().get() as i64,
        )
    };
}

#[test]
fn root_family() {
    type NonRestoring = SquareRootNonRestoring<32, W, 17, 18>;
    type Rows = SquareRootRows<32, W, 17, 18>;
    type Leading = SquareRootLeading<32, W, 17, 18>;
    type Iterative = SquareRootIterative<32, W, 17, 18>;
    type Lines = SquareRootLinear<32, W, 17>;
    type Parabolas = SquareRootQuadratic<32, W, 17, 28>;
    for rows in [1, 3, 5, 8, 16] {
        let found = measured_root!(NonRestoring::new(rows));
        let expected = formula(Unit::SquareRootNonRestoring, 0, rows, 1);
        assert_eq!((found, found), (NonRestoring::latency(rows), expected));
        for kept in 1..=W {
            let expected = |unit| {
                let digits = Some(kept);
                EmitRequest {
                    digits,
                    ..request(unit, 0, rows, 1)
                }
                .latency()
            };
            let found = measured_root!(Rows::new(kept, rows));
            let latency = Rows::latency(kept, rows);
            assert_eq!((found, found), (latency, expected(Unit::SquareRootRows)));
            let found = measured_root!(Leading::new(kept, rows));
            let latency = Leading::latency(kept, rows);
            assert_eq!((found, found), (latency, expected(Unit::SquareRootLeading)));
        }
    }
    for count in 0..=2 {
        let expected = |unit| {
            let corrections = Some(count);
            EmitRequest {
                corrections,
                ..request(unit, 0, 1, 1)
            }
            .latency()
        };
        let found = measured_root!(Lines::new(count));
        assert_eq!(
            (found, found),
            (Lines::latency(count), expected(Unit::SquareRootLinear))
        );
        let found = measured_root!(Parabolas::new(count));
        assert_eq!(
            (found, found),
            (
                Parabolas::latency(count),
                expected(Unit::SquareRootQuadratic)
            )
        );
    }
    let found = measured(
        Iterative::new(),
        |unit, on| {
            unit.start.next = on;
            unit.radicand.next = Word::new(1);
        },
        |unit| unit.done.val().into(),
    );
    let expected = formula(Unit::SquareRootIterative, 0, 1, 1);
    assert_eq!((found, found), (Iterative::latency(), expected));
}

#[test]
fn quadric_processor() {
    for (planes, rows) in [(0, 1), (1, 1), (3, 4), (12, 16)] {
        let drive = |unit: &mut Processor, on: bool| {
            [unit.valid.next, unit.start.next] = [on; 2];
            unit.f1_c.next = Int::new(100);
            unit.f2_f.next = Int::new(9);
            unit.gx_c.next = Int::new(2560);
            unit.kx.next = Int::new(0);
        };
        let new = || Processor::new(planes, rows);
        let expected = Processor::latency(planes, rows);
        assert_eq!(expected, formula(Unit::QuadricProcessor, planes, rows, 1));
        assert_eq!(
            measured(new(), drive, |unit| unit.out_valid.val().into()),
            expected
        );
        assert_eq!(measured(new(), drive, |unit| unit.zf.val().get()), expected);
        assert_eq!(measured(new(), drive, |unit| unit.zb.val().get()), expected);
        assert_eq!(measured(new(), drive, |unit| unit.nx.val().get()), expected);
    }
}

#[test]
fn machine() {
    let found = measured(
        RasterControl::new(),
        |unit, on| {
            unit.go.next = on;
            [unit.width.next, unit.height.next] = [Word::new(2); 2];
        },
        |unit| unit.valid.val().into(),
    );
    assert_eq!(
        (found, found),
        (
            RasterControl::latency(),
            formula(Unit::RasterControl, 0, 1, 1)
        )
    );
    let found = measured(
        VisibilityNode::<W>::default(),
        |unit, on| unit.b_depth.next = Int::new(if on { -1 } else { 0 }),
        |unit| unit.depth.val().get(),
    );
    assert_eq!(
        (found, found),
        (
            VisibilityNode::<W>::latency(),
            formula(Unit::VisibilityNode, 0, 1, 1)
        )
    );
    let found = measured(
        CoefficientStore::<18, 32, 28>::new(1),
        |unit, on| {
            unit.write.next = on;
            unit.address.next = Word::new(25);
            unit.data.next = Word::new(3);
        },
        |unit| unit.plane_a[0].val().get(),
    );
    assert_eq!(
        (found, found),
        (
            CoefficientStore::<18, 32, 28>::latency(),
            formula(Unit::CoefficientStore, 1, 1, 1)
        )
    );
    for inputs in [2, 3, 4, 5, 8, 9, 17] {
        // The last input is the one that may pass registers.
        let found = measured(
            Decider::<W>::new(inputs),
            |unit, on| unit.input_depth[inputs - 1].next = Int::new(if on { -1 } else { 0 }),
            |unit| unit.depth.val().get(),
        );
        assert_eq!(
            (found, found),
            (
                Decider::<W>::latency(inputs),
                formula(Unit::Decider, 0, 1, inputs)
            )
        );
    }
    assert_eq!(
        (Decider::<W>::latency(1), formula(Unit::Decider, 0, 1, 1)),
        (0, 0)
    );
    for (objects, planes, rows) in [(1, 0, 4), (2, 1, 16), (5, 2, 3)] {
        let found = measured(
            Machine::new(objects, planes, rows),
            |unit, on| {
                unit.go.next = on;
                [unit.width.next, unit.height.next] = [Word::new(2); 2];
            },
            |unit| unit.valid.val().into(),
        );
        let expected = formula(Unit::Beam, planes, rows, objects);
        assert_eq!(
            (found, found),
            (Machine::latency(objects, planes, rows), expected)
        );
    }
}

#[test]
fn deciders_that_run_past_their_processors() {
    for inputs in [1, 2, 5, 16] {
        // Input i is taken i clocks after input 0.
        for input in 0..inputs {
            let found = measured(
                VisibilityChain::<W>::new(inputs),
                |unit, on| unit.input_depth[input].next = Int::new(if on { -1 } else { 0 }),
                |unit| unit.depth.val().get(),
            );
            let latency = VisibilityChain::<W>::latency(inputs);
            assert_eq!(found + input, latency);
            assert_eq!(latency, formula(Unit::VisibilityChain, 0, 1, inputs));
        }
    }
    for (processors, cards) in [(1, 1), (1, 3), (4, 1), (3, 2), (4, 5)] {
        let latency = CardDecider::<W>::latency(processors, cards);
        for input in 0..processors * cards {
            let found = measured(
                CardDecider::<W>::new(processors, cards),
                |unit, on| unit.input_depth[input].next = Int::new(if on { -1 } else { 0 }),
                |unit| unit.depth.val().get(),
            );
            assert_eq!(found + input % processors, latency);
        }
        let request = EmitRequest {
            cards: Some(cards),
            ..request(Unit::CardDecider, 0, 1, processors)
        };
        assert_eq!(request.latency(), latency);
    }
}

#[test]
fn shadow_stages() {
    for volumes in [1, 8, 9, 64, 65, 256] {
        let latency = ShadowStage::latency(volumes);
        assert_eq!(latency, formula(Unit::ShadowStage, 0, 1, volumes));
        for volume in [0, volumes - 1] {
            let found = measured(
                ShadowStage::new(volumes),
                |unit, on| {
                    unit.flags_in.next = Word::new(1);
                    unit.volume_enabled[volume].next = true;
                    unit.volume_inside[volume].next = on;
                },
                |unit| unit.flags.val().get() as i64,
            );
            assert_eq!(found, latency);
        }
        let found = measured(
            ShadowStage::new(volumes),
            |unit, on| unit.flags_in.next = Word::new(on.into()),
            |unit| unit.flags.val().get() as i64,
        );
        assert_eq!(found, latency);
    }
}

#[test]
fn blends() {
    let found = measured(
        TransparencyStage::<W>::default(),
        |unit, on| unit.pixel_red.next = Word::new(on.into()),
        |unit| unit.red.val().get() as i64,
    );
    let latency = TransparencyStage::<W>::latency();
    assert_eq!(
        (found, found),
        (latency, request(Unit::TransparencyStage, 0, 1, 1).latency())
    );
    for layers in 1..=8 {
        let latency = TransparencyPipeline::<W>::latency(layers);
        let request = EmitRequest {
            layers: Some(layers),
            ..request(Unit::TransparencyPipeline, 0, 1, 1)
        };
        assert_eq!(request.latency(), latency);
        let found = measured(
            TransparencyPipeline::<W>::new(layers),
            |unit, on| unit.pixel_depth.next = Int::new(on.into()),
            |unit| unit.depth.val().get(),
        );
        assert_eq!(found, latency);
        // Layer i is taken 2 i clocks after the pixel.
        for layer in 0..layers {
            let found = measured(
                TransparencyPipeline::<W>::new(layers),
                |unit, on| {
                    unit.pixel_depth.next = Int::new(5);
                    unit.layer_red[layer].next = Word::new(200);
                    unit.layer_weight[layer].next = Word::new(if on { 255 } else { 0 });
                },
                |unit| unit.red.val().get() as i64,
            );
            assert_eq!(found + 2 * layer, latency);
        }
    }
}

#[test]
fn solids() {
    for (products, intersected, subtracted) in [
        (1, 1, 0),
        (1, 1, 1),
        (2, 2, 2),
        (3, 3, 1),
        (4, 5, 3),
        (16, 8, 8),
    ] {
        let latency = CsgDecider::<W>::latency(products, intersected, subtracted);
        let request = EmitRequest {
            products: Some(products),
            intersected: Some(intersected),
            subtracted: Some(subtracted),
            ..request(Unit::CsgDecider, 0, 1, 1)
        };
        assert_eq!(request.latency(), latency);
        let last = products * intersected - 1;
        let drive = |unit: &mut CsgDecider<W>| {
            for back in &mut unit.intersected_zb {
                back.next = Int::new(9);
            }
        };
        let found = measured(
            CsgDecider::<W>::new(products, intersected, subtracted),
            |unit, on| {
                drive(unit);
                unit.intersected_zf
                    .iter_mut()
                    .for_each(|front| front.next = Int::new(5));
                // The front of the last product alone comes nearer.
                let first = last + 1 - intersected;
                for front in &mut unit.intersected_zf[first..] {
                    front.next = Int::new(if on { 4 } else { 5 });
                }
            },
            |unit| unit.depth.val().get(),
        );
        assert_eq!(found, latency);
        if subtracted == 0 {
            continue;
        }
        // What is taken away is used after the tree of the intersection.
        let skew = intersected.next_power_of_two().trailing_zeros() as usize;
        let found = measured(
            CsgDecider::<W>::new(1, intersected, subtracted),
            |unit, on| {
                drive(unit);
                unit.subtracted_zb[0].next = Int::new(if on { 3 } else { 0 });
            },
            |unit| unit.depth.val().get(),
        );
        assert_eq!(
            found + skew,
            CsgDecider::<W>::latency(1, intersected, subtracted)
        );
    }
}
