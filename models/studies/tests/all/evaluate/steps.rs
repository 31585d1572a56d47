use imogene_studies::evaluate::steps::costs;

fn weighted(name: &str) -> u64 {
    let cost = costs().get(name).and_then(|cost| cost.as_u64());
    cost.unwrap_or_else(|| panic!("no {name}"))
}

/// Counts that follow from the size of the matrices alone.
#[test]
fn products_cost_what_their_sizes_say() {
    for (name, expected) in [
        ("product", 16 * (4 + 3)),
        ("affine_product", 12 * 5 + 3),
        ("point", 4 * 6),
        ("direction", 3 * 5),
        ("divide", 8 + 3),
        ("plane_image", 4 * 7),
        ("quadric_in_full", 2 * 112),
        ("quadric_image", 112 + 10 * 7),
        ("cofactors", 16 * 14),
        ("shared_cofactors", 12 * 3 + 16 * 5),
        ("determinant", 7),
        ("determinant_alone", 4 * 14 + 7),
        ("inverse", 8 + 16),
        ("normalised", 5 + 8 + 8 + 3),
    ] {
        assert_eq!(weighted(name), expected, "{name}");
    }
}

#[test]
fn outlines_have_the_sides_that_their_corners_are_tested_against() {
    for (object, sides) in [("facet", 3), ("patch", 4), ("quadric", 6)] {
        let set_up = weighted(&format!("{object}_sides"));
        let corner = weighted(&format!("{object}_sides_and_corner")) - set_up;
        assert_eq!(corner, sides * 5, "{object}");
    }
}
