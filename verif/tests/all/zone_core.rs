//! The deciding part of the zone machine against its golden model, on scenes.

use super::video::Numbers;
use imogene_contract::slots::Products;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::machine::zone::beat::Beat;
use imogene_golden::machine::zone::golden::ZoneMachineModel;
use imogene_plan::zone::clocks::clocks;
use imogene_plan::zone::plan::ZonePlan;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_verif::display::request::{core_request, zone_timing};
use imogene_verif::display::zone_core::{CoreRun, run};
use imogene_verif::engine::Engine;
use imogene_verif::engine::design::Simulator;

fn plan(scene: &str, (width, height): (u32, u32), machine: ZoneMachine) -> ZonePlan {
    let framed = super::scene(scene).frame(width, height);
    let framed = framed.expect("a valid size");
    let prepared = prepare(&framed, Format::BASE).expect("fits the format");
    ZonePlan::of(&prepared, machine).expect("fits the machine")
}

fn machine(objects: usize, volumes: usize, side: u32) -> ZoneMachine {
    ZoneMachine {
        object_processors: objects,
        products: vec![],
        planes: 3,
        volume_processors: volumes,
        volume_planes: 10,
        zone_width: side,
        zone_height: side,
        samples: 1,
    }
}

fn check(plan: &ZonePlan, engine: Engine, stalls: Option<u64>) {
    let beats: Vec<Beat> = plan.beats().collect();
    let options = CoreRun {
        rows_per_stage: 4,
        engine,
        stalls,
    };
    let report = run(&beats, &Format::BASE, &plan.machine, &options).expect("a machine that runs");
    assert_eq!(report.mismatches, 0, "{}", report.first_mismatches[0]);
    assert_eq!(report.pixels, u64::from(plan.width * plan.height));
    if stalls.is_none() {
        // Without stalls a frame takes the clocks of the formula, no more and no fewer.
        let request = core_request(&plan.machine, &Format::BASE, 4);
        let timing = zone_timing(&request).expect("a machine");
        assert_eq!(report.cycles, clocks(plan, &timing).total);
    }
}

#[test]
fn small_scenes_in_the_built_in_simulator() {
    let plan = plan("teapot.toml", (40, 24), machine(2, 0, 16));
    check(&plan, Engine::BuiltIn, None);
    check(&plan, Engine::BuiltIn, Some(7));
}

#[test]
fn scenes_with_shadows_in_verilator() {
    let engine = Engine::Verilog(Simulator::Verilator);
    for (objects, volumes, side) in [(3, 2, 24), (1, 5, 10), (4, 9, 40)] {
        let plan = plan(
            "shadows/robot.toml",
            (96, 72),
            machine(objects, volumes, side),
        );
        check(&plan, engine, None);
        check(&plan, engine, Some(3));
    }
}

/// Products in turn in the places of one or of several, also without any other object.
#[test]
fn solids() {
    let verilator = Engine::Verilog(Simulator::Verilator);
    let (bracket, printed) = ("solids/bracket.toml", "solids/printed-example.toml");
    for (scene, size, objects, products, engine) in [
        (bracket, (40, 30), 1, "1-4", Engine::BuiltIn),
        (printed, (40, 30), 0, "2-1,2-1", Engine::BuiltIn),
        (bracket, (64, 48), 2, "3-1,2-5", Engine::BuiltIn),
        (printed, (64, 48), 1, "1-0,3-2,2-1", verilator),
    ] {
        let Products(products) = products.to_owned().try_into().expect("products");
        let machine = ZoneMachine {
            planes: 6,
            products,
            ..machine(objects, 0, 16)
        };
        let plan = plan(scene, size, machine);
        assert!(plan.zones.iter().any(|zone| zone.products.len() > 1));
        check(&plan, engine, None);
        check(&plan, engine, Some(5));
    }
}

/// Which processor draws an object, and in which pass, changes nothing: the pixels of the shuffled plan are those of
/// the plan.
#[test]
fn the_order_of_arrival_changes_nothing() {
    let engine = Engine::Verilog(Simulator::Verilator);
    let plan = plan("shadows/robot.toml", (96, 72), machine(3, 2, 24));
    let beats: Vec<Beat> = plan.beats().collect();
    let mut wanted = ZoneMachineModel::new(&Format::BASE, &plan.machine);
    let wanted = wanted.frame(beats, 96, 72).expect("a stream");
    for seed in 1..=4 {
        let mut shuffled = plan.clone();
        let mut numbers = Numbers(seed);
        for zone in &mut shuffled.zones {
            for place in (1..zone.parts.len()).rev() {
                let other = numbers.below(place as u64 + 1);
                zone.parts.swap(place, other as usize);
            }
        }
        let mut zones = shuffled.zones.iter().zip(&plan.zones);
        assert!(zones.any(|(a, b)| a.parts != b.parts));
        let mut golden = ZoneMachineModel::new(&Format::BASE, &plan.machine);
        let found = golden.frame(shuffled.beats(), 96, 72).expect("a stream");
        assert!(found == wanted, "seed {seed}");
        check(&shuffled, engine, None);
    }
}
