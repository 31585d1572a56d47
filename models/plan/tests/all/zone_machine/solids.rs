//! Solids: the picture is that of the beam machine, however many products a zone machine has and whatever is in one
//! pass.

use super::refine::assert_same;
use super::{MACHINE, MACHINES, Truth, machine_of, planned, quadrics, scene, scene_of, text};
use imogene_contract::object::ProductSlots;
use imogene_contract::slots::Products;
use imogene_golden::format::Format;
use imogene_golden::machine::lighting::ALL_SOURCES;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_plan::zone::plan::{PlanError, ZonePlan};
use imogene_prepare::PreparedScene;

const SIZE: (u32, u32) = (83, 61);
const BRACKET: &str = "scenes/solids/bracket.toml";
const PRINTED: &str = "scenes/solids/printed-example.toml";

fn with_products(machine: ZoneMachine, products: &str) -> ZoneMachine {
    let Products(products) = products.to_owned().try_into().expect("products");
    let members = products.iter().map(ProductSlots::count).sum();
    ZoneMachine {
        slots: [machine.slots, quadrics(members)].concat(),
        products,
        ..machine
    }
}

/// The bracket in the light of a lamp, with the shadow of its ball.
fn bracket_with_shadow() -> PreparedScene {
    let text = text(BRACKET)
        .replacen("[[lights]]\n", "[[lights]]\nshadows = true\n", 1)
        .replace("[[objects]]\n", "[[objects]]\ncasts_shadow = false\n")
        .replace(
            "casts_shadow = false\nname = \"ball\"",
            "casts_shadow = true\nname = \"ball\"",
        );
    scene_of(&text, SIZE, Format::BASE)
}

/// Places that are exactly those of a scene, one place for all, and more and larger ones than it needs.
const PRODUCTS: [[&str; 3]; 2] = [
    ["1-4,1-4", "1-4", "3-1,2-5,1-4"],
    ["2-1,2-1,2-1,2-1", "2-1", "1-16,2-1,16-1"],
];

#[test]
fn solids_are_drawn() {
    let scenes = [
        (scene(BRACKET, SIZE, Format::BASE), PRODUCTS[0]),
        (scene(PRINTED, SIZE, Format::BASE), PRODUCTS[1]),
        (bracket_with_shadow(), PRODUCTS[0]),
    ];
    for (prepared, products) in &scenes {
        let truth = Truth::of(prepared, &prepared.slots());
        let members = |id: &&i32| prepared.solids.members.contains(&(**id as usize));
        assert!(truth.frame.id.iter().filter(members).count() > 800);
        let dark = truth.lighting.flags.iter().zip(&truth.frame.id);
        let dark = dark.filter(|(flags, id)| **flags != ALL_SOURCES && members(id));
        assert!(prepared.volumes.is_empty() || dark.count() > 20);
        for products in products {
            for [width, height, k, v] in MACHINES {
                // More would leave no processors for the products.
                let machine = machine_of([width, height, k.min(200), v]);
                let machine = with_products(machine, products);
                let [boxes, bounds, pixels] = assert_same(prepared, machine, &truth);
                assert!(bounds[2] <= boxes[2] && pixels[2] <= bounds[2]);
                assert!(
                    width != 8 || bounds[2] < boxes[2],
                    "{products}: {boxes:?} {bounds:?} {pixels:?}"
                );
            }
        }
    }
}

#[test]
fn samples_of_solids_are_the_pixels_of_a_finer_picture() {
    let prepared = scene(BRACKET, (88, 68), Format::BASE);
    let truth = Truth::of(&prepared, &prepared.slots());
    for samples in [2, 4] {
        let machine = ZoneMachine {
            zone_width: 7,
            samples,
            ..with_products(MACHINE.clone(), "1-4")
        };
        truth.assert_is_drawn(&planned(&prepared, machine));
    }
}

/// Of two products that have the same object in front, either may be the first.
#[test]
fn the_order_of_products_changes_nothing() {
    let prepared = scene(PRINTED, SIZE, Format::BASE);
    let truth = Truth::of(&prepared, &prepared.slots());
    let machine = with_products(MACHINE.clone(), "2-1,2-1,2-1");
    let mut plan = planned(&prepared, machine);
    let most = plan.zones.iter().map(|zone| zone.products.len()).max();
    assert_eq!(most, Some(4));
    for zone in &mut plan.zones {
        zone.products.reverse();
    }
    truth.assert_is_drawn(&plan);
}

/// What does not reach a zone is not sent there, and the passes are those of the places.
#[test]
fn passes_are_counted() {
    let prepared = scene(PRINTED, SIZE, Format::BASE);
    let passes = |products| {
        let machine = with_products(machine_of([128, 128, 4, 2]), products);
        let plan = planned(&prepared, machine);
        let zone = &plan.zones[0];
        let draws = plan.passes(zone, true).count() - 1;
        (draws, zone.all_parts().count())
    };
    // Four products of three objects.
    assert_eq!(passes("2-1"), (4, 12));
    assert_eq!(passes("2-1,2-1,2-1"), (2, 12));
    assert_eq!(passes("2-1,2-1,2-1,4-4,1-1"), (1, 12));
    let small = with_products(machine_of([8, 8, 4, 2]), "2-1");
    let plan = planned(&prepared, small);
    let sent = plan.zones.iter().map(|zone| zone.all_parts().count());
    assert!(sent.clone().any(|parts| parts == 0) && sent.clone().any(|parts| parts % 3 > 0));
}

#[test]
fn a_machine_without_the_places_is_refused() {
    let refused = |path, machine| {
        let refused = ZonePlan::of(&scene(path, SIZE, Format::BASE), machine);
        refused.expect_err("refused")
    };
    assert_eq!(
        refused(BRACKET, MACHINE.clone()),
        PlanError::NoProduct([1, 4])
    );
    let small = with_products(MACHINE.clone(), "1-3,16-2");
    let message = refused(BRACKET, small).to_string();
    assert!(
        message.contains("intersects 1 objects and takes 4 away")
            && message.contains("products such as \"1-4\""),
        "{message}"
    );
    let none = ZoneMachine {
        slots: vec![],
        ..MACHINE.clone()
    };
    let without_others = with_products(none, "2-4");
    // The ball is in no solid; the other scene has nothing else.
    let none = refused(BRACKET, without_others.clone());
    assert_eq!(none, PlanError::NoObjectProcessor(1));
    let printed = scene(PRINTED, SIZE, Format::BASE);
    let truth = Truth::of(&printed, &printed.slots());
    truth.assert_is_drawn(&planned(&printed, without_others));
    let many = with_products(machine_of([32, 32, 250, 2]), "3-4");
    let message = refused(PRINTED, many).to_string();
    assert!(message.contains("257 object processors"), "{message}");
}
