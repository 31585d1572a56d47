use imogene_contract::object::ProductSlots;
use imogene_contract::slots::FittedSlot;
use imogene_golden::machine::zone::ZoneMachine;
use imogene_plan::zone::plan::{ZoneProduct, in_passes};

/// Two alone, then products of 2 - 1 and 1 - 3.
fn machine() -> ZoneMachine {
    let products = [(2, 1), (1, 3)].map(|(intersected, subtracted)| ProductSlots {
        intersected,
        subtracted,
    });
    ZoneMachine {
        layers: vec![],
        slots: vec![FittedSlot::quadric(3); 9],
        products: products.to_vec(),
        volume_processors: 0,
        volume_planes: 0,
        zone_width: 8,
        zone_height: 8,
        samples: 1,
    }
}

fn product(intersected: &[u32], subtracted: &[u32]) -> ZoneProduct {
    ZoneProduct {
        intersected: intersected.to_vec(),
        subtracted: subtracted.to_vec(),
    }
}

#[test]
fn a_product_takes_the_smallest_slots_that_are_free_and_enough() {
    let products = [
        // Either would do, the smaller one is taken.
        product(&[10], &[11]),
        // Both want the larger one: one has to wait.
        product(&[12], &[13, 14]),
        product(&[15], &[16, 17, 18]),
        product(&[19, 20], &[]),
    ];
    let first = vec![(2, 10), (3, 10), (4, 11), (5, 12), (6, 13), (7, 14)];
    let second = vec![(5, 15), (6, 16), (7, 17), (8, 18), (2, 19), (3, 20)];
    assert_eq!(in_passes(&machine(), &products), [first, second]);
    assert!(in_passes(&machine(), &[]).is_empty());
}
