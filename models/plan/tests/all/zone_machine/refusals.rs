//! Scenes that a zone machine cannot draw are refused by name.

use super::{MACHINE, quadrics, scene};
use imogene_contract::object::Kind;
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_plan::zone::plan::{PlanError, ZonePlan};

const SIZE: (u32, u32) = (60, 45);

fn refused(path: &str, machine: ZoneMachine) -> PlanError {
    let prepared = scene(path, SIZE, Format::BASE);
    ZonePlan::of(&prepared, machine).expect_err("refused")
}

#[test]
fn slots_that_would_do_are_named() {
    for (name, what) in [
        ("first-generation", "first_generation;"),
        ("paraboloids", "sphere;"),
        ("curved-facet", "curved_facet1;"),
    ] {
        let path = format!("scenes/processors/{name}.toml");
        let message = refused(&path, MACHINE.clone()).to_string();
        assert!(
            message.starts_with("object '") && message.contains(&format!("a slot such as {what}")),
            "{message}"
        );
        assert!(message.contains("the machine has 4x12 for objects in no solid"));
    }
    let facets = ZoneMachine {
        slots: vec![FittedSlot::of(Kind::Facet, 4)],
        ..MACHINE.clone()
    };
    let message = refused("scenes/teapot.toml", facets).to_string();
    assert!(
        message.contains("a slot such as patch2; the machine has facet4"),
        "{message}"
    );
}

#[test]
fn a_mesh_needs_guard_bits() {
    let PlanError::Object(_, why) = refused("scenes/processors/mesh.toml", MACHINE.clone()) else {
        panic!("an object is refused")
    };
    assert!(matches!(why, AsQuadricError::GuardBits(1..=10, 0)), "{why}");
}

#[test]
fn planes_and_processors_must_be_there() {
    let robot = "scenes/shadows/robot.toml";
    let message = |machine| refused(robot, machine).to_string();
    type Change = fn(&mut ZoneMachine);
    let cases: [(Change, &str); 8] = [
        (
            |m| m.slots = vec![FittedSlot::NONE; 4],
            "the processor has 0",
        ),
        (|m| m.volume_planes = 0, "the processor has 0"),
        (|m| m.volume_processors = 0, "no volume processor"),
        (
            |m| m.slots.clear(),
            "0 object processors: accepted are 1 to 256",
        ),
        (|m| m.slots = quadrics(257), "257 object processors"),
        (
            |m| m.slots[3].planes = 13,
            "13 planes: accepted are 0 to 12",
        ),
        (|m| m.zone_width = 0, "0 zone width: accepted are 1 to 4095"),
        (|m| m.zone_height = 4096, "4096 zone height"),
    ];
    for (change, wanted) in cases {
        let mut machine = MACHINE.clone();
        change(&mut machine);
        let message = message(machine);
        assert!(message.contains(wanted), "{message}");
    }
    let few = ZoneMachine {
        volume_planes: 0,
        ..MACHINE.clone()
    };
    assert!(message(few).starts_with("the "));
}

#[test]
fn ids_and_materials_are_counted() {
    let mut prepared = scene("scenes/teapot.toml", SIZE, Format::BASE);
    let plan = ZonePlan::of(&prepared, MACHINE.clone()).expect("fits");
    let refused = plan.shaded(vec![], vec![0]);
    let message = refused.expect_err("refused").to_string();
    assert!(message.starts_with("1 materials for"), "{message}");
    let one = prepared.objects[0].clone();
    prepared.objects.resize(4097, one);
    let refusal = ZonePlan::of(&prepared, MACHINE.clone()).expect_err("refused");
    assert_eq!(refusal, PlanError::Objects(4097));
    assert!(refusal.to_string().contains("up to 4096"));
}
