//! Scenes that a zone machine cannot draw are refused by name.

use super::{MACHINE, scene};
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
fn processors_without_an_equal_are_named() {
    for (name, what) in [
        ("first-generation", "first generation"),
        ("paraboloids", "a paraboloid"),
        ("curved-facet", "a curved facet"),
    ] {
        let path = format!("../../scenes/processors/{name}.toml");
        let message = refused(&path, MACHINE).to_string();
        assert!(
            message.starts_with("object '") && message.contains(what),
            "{message}"
        );
        assert!(message.contains("accepted are quadrics, patches, polyhedra and flat facets"));
    }
}

#[test]
fn a_mesh_needs_guard_bits() {
    let PlanError::Object { why, .. } = refused("../../scenes/processors/mesh.toml", MACHINE)
    else {
        panic!("an object is refused")
    };
    assert!(
        matches!(
            why,
            AsQuadricError::GuardBits {
                needed: 1..=10,
                available: 0
            }
        ),
        "{why}"
    );
}

#[test]
fn planes_and_processors_must_be_there() {
    let robot = "../../scenes/shadows/robot.toml";
    let message = |machine| refused(robot, machine).to_string();
    type Change = fn(&mut ZoneMachine);
    let cases: [(Change, &str); 8] = [
        (|m| m.planes = 0, "the processor has 0"),
        (|m| m.volume_planes = 0, "the processor has 0"),
        (|m| m.volume_processors = 0, "no volume processor"),
        (
            |m| m.object_processors = 0,
            "0 object processors: accepted are 1 to 256",
        ),
        (|m| m.object_processors = 257, "257 object processors"),
        (|m| m.planes = 13, "13 planes: accepted are 0 to 12"),
        (|m| m.zone_width = 0, "0 zone width: accepted are 1 to 4095"),
        (|m| m.zone_height = 4096, "4096 zone height"),
    ];
    for (change, wanted) in cases {
        let mut machine = MACHINE;
        change(&mut machine);
        let message = message(machine);
        assert!(message.contains(wanted), "{message}");
    }
    let few = ZoneMachine {
        volume_planes: 0,
        ..MACHINE
    };
    assert!(message(few).starts_with("the "));
}

#[test]
fn ids_and_materials_are_counted() {
    let mut prepared = scene("../../scenes/teapot.toml", SIZE, Format::BASE);
    let plan = ZonePlan::of(&prepared, MACHINE).expect("fits");
    let message = plan
        .shaded(vec![], vec![0])
        .expect_err("refused")
        .to_string();
    assert!(message.starts_with("1 materials for"), "{message}");
    let one = prepared.objects[0].clone();
    prepared.objects.resize(4097, one);
    let refusal = ZonePlan::of(&prepared, MACHINE).expect_err("refused");
    assert_eq!(refusal, PlanError::Objects(4097));
    assert!(refusal.to_string().contains("up to 4096"));
}
