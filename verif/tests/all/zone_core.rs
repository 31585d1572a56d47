//! The deciding part of the zone machine against its golden model, on scenes.

use super::video::Numbers;
use imogene_contract::object::ProductSlots;
use imogene_contract::slots::{self, FittedSlot, Products};
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::machine::zone::beat::Beat;
use imogene_golden::machine::zone::golden::{ShownPixel, ZoneMachineModel};
use imogene_plan::zone::clocks::clocks;
use imogene_plan::zone::plan::ZonePlan;
use imogene_verif::display::request::{core_request, zone_timing};
use imogene_verif::engine::Engine;
use imogene_verif::engine::machine::{Machine, MachineDesign};
use imogene_verif::engine::simulator::Simulator;
use imogene_verif::random::Stalls;
use imogene_verif::report::Report;

fn plan(scene: &str, size: (u32, u32), machine: ZoneMachine) -> ZonePlan {
    let (_, prepared) = super::prepared(&super::scene(scene), size, Format::BASE);
    ZonePlan::of(&prepared, machine).expect("fits the machine")
}

fn machine(objects: usize, volumes: usize, side: u32) -> ZoneMachine {
    ZoneMachine {
        slots: vec![FittedSlot::quadric(3); objects],
        products: vec![],
        layers: vec![],
        volume_processors: volumes,
        volume_planes: 10,
        zone_width: side,
        zone_height: side,
        samples: 1,
    }
}

/// Rows of the root networks between registers.
const ROWS_PER_STAGE: usize = 4;

/// A stream through hardware and golden model, with random stalls of a seed on both sides: every shown pixel compared.
/// The report's cycles are those from the first beat to the last pixel.
fn run(beats: &[Beat], machine: &ZoneMachine, engine: Engine, seed: Option<u64>) -> Report {
    let mut golden = ZoneMachineModel::new(&Format::BASE, machine);
    let mut wanted = Vec::new();
    for beat in beats {
        let step = golden.beat(beat, |pixel| wanted.push(pixel));
        step.expect("a stream");
    }
    let request = core_request(machine, &Format::BASE, ROWS_PER_STAGE);
    let design = MachineDesign::compile(engine, &request, vec![], &[]);
    let design = design.expect("a machine");
    let mut hardware = Machine::of(&design);
    let mut stalls = Stalls::new(seed);
    let mut report = Report::default();
    hardware.set("room", 0);
    hardware.clock();
    hardware.clocks = 0;
    let (mut sent, mut seen, mut idle) = (0, 0, 0u64);
    while seen < wanted.len() && idle < 1 << 20 {
        let is_ready = hardware.is_set("s_tready");
        let beat = beats.get(sent).filter(|_| !stalls.stall());
        hardware.offer(beat);
        hardware.set("room", i64::from(!stalls.stall()));
        sent += usize::from(beat.is_some() && is_ready);
        hardware.clock();
        idle += 1;
        if hardware.is_set("valid") {
            compare(&hardware, &wanted[seen], &mut report);
            seen += 1;
            idle = 0;
        }
    }
    let all = wanted.len() as i64;
    report.compare(hardware.clocks, None, "pixels", Some(seen as i64), all);
    report.cycles = hardware.clocks;
    report.pixels = seen as u64;
    report
}

fn compare(hardware: &Machine, wanted: &ShownPixel, report: &mut Report) {
    let mut values = vec![
        ("x", i64::from(wanted.x)),
        ("y", i64::from(wanted.y)),
        ("depth", wanted.depth),
        ("sample", (wanted.sample.bits() >> 3) as i64),
        ("pass_ends", wanted.pass_ends.into()),
        ("frame_ends", wanted.last.into()),
    ];
    if wanted.depth != Format::BASE.z_max() {
        let [nx, ny, nz] = wanted.normal.map(i64::from);
        values.extend([("id", wanted.id.into()), ("nx", nx), ("ny", ny), ("nz", nz)]);
        values.push(("source_flags", wanted.flags.into()));
    }
    for (port, golden) in values {
        let pixel = Some((wanted.x.into(), wanted.y.into()));
        report.compare(hardware.clocks, pixel, port, hardware.get(port), golden);
    }
}

fn check(plan: &ZonePlan, engine: Engine, stalls: Option<u64>) {
    let beats: Vec<Beat> = plan.beats().collect();
    let report = run(&beats, &plan.machine, engine, stalls);
    assert_eq!(report.mismatches, 0, "{}", report.first_mismatches[0]);
    assert_eq!(report.pixels, u64::from(plan.width * plan.height));
    if stalls.is_none() {
        // Without stalls a frame takes the clocks of the formula, no more and no fewer.
        let request = core_request(&plan.machine, &Format::BASE, ROWS_PER_STAGE);
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
        let machine = machine(objects, volumes, side);
        let plan = plan("shadows/robot.toml", (96, 72), machine);
        check(&plan, engine, None);
        check(&plan, engine, Some(3));
    }
}

/// Processors of every kind, of each fewer than there are objects, and shadows on what they draw.
#[test]
fn slots_of_other_kinds() {
    for (scene, slots, volumes) in [
        ("processors/mesh.toml", "facet4,facet3", 0),
        ("processors/curved-facet.toml", "curved_facet4", 0),
        ("processors/first-generation.toml", "0,first_generation", 0),
        ("processors/paraboloids.toml", "cylinder,sphere,0", 0),
        ("processors/polyhedron.toml", "polyhedron8", 0),
        ("extremes/eye-on-quadric.toml", "0,quotient1", 0),
        ("shadows/robot.toml", "2,patch3,polyhedron6", 3),
    ] {
        let slots = slots::parse(slots).expect("slots");
        let machine = ZoneMachine {
            slots,
            ..machine(0, volumes, 16)
        };
        let plan = plan(scene, (56, 42), machine);
        check(&plan, Engine::BuiltIn, None);
        check(&plan, Engine::BuiltIn, Some(9));
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
        let members: usize = products.iter().map(ProductSlots::count).sum();
        let machine = ZoneMachine {
            slots: vec![FittedSlot::quadric(6); objects + members],
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
