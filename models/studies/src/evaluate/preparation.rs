//! Operations of the preparation (source: 5.1.2, Tables 5.1 to 5.7, annex A).

use super::costs::{change, facets, quadrics};
use super::row::{Group, Row};

const OPERATIONS: &str = "operations";

fn row(name: &str, section: &'static str, printed: f64, ours: f64) -> Row {
    Row::new(name, section, printed, ours, OPERATIONS)
}

/// Changes of frame.
pub fn frame() -> Group {
    let same = "the same products, counted by running them";
    let facet = change::product() + change::facet();
    Group {
        name: "frame",
        title: "Change of frame",
        about: "Weights of the source: an addition, subtraction, multiplication or test is 1, a division or root 8; conversion to a whole number, which the source does not weigh, is 1 here. \
                Every figure of ours is what a run of the step counts."
            .into(),
        rows: vec![
            row("product of two 4 x 4 matrices", "5.1.2", 112.0, change::product()).why(same),
            row(
                "the same, both without perspective",
                "5.1.2",
                112.0,
                change::affine_product(),
            )
            .why("the last row is 0 0 0 1 and neither read nor computed; only the last product, with the perspective, needs all of it"),
            row("three points and three normals of a facet", "5.1.2", 117.0, 3.0 * (change::point() + change::direction())).why(same),
            row("division of three homogeneous points", "5.1.2", 33.0, 3.0 * change::divide()).why(same),
            row("facet, all", "5.1.2", 262.0, facet).why("sum of the three rows with the full product"),
            row("quadric, both products", "5.1.2", 224.0, change::quadric_in_full()).why(same),
            row("quadric, as the result is symmetric", "5.1.2", 182.0, change::quadric()).why(same),
            row("plane", "5.1.2", 28.0, change::plane()).why(same),
            row("determinant", "5.1.2", 95.0, change::determinant_alone()).why(
                "the source multiplies out all 24 products of four; by cofactors of the first row it is this",
            ),
            row("determinant where the cofactors are known", "5.1.2", 95.0, change::determinant()).why(
                "a quadric needs the cofactors anyway; what is left is a row times its cofactors",
            ),
            row("matrix of cofactors", "5.1.2", 272.0, change::cofactors()).why(
                "a determinant of 3 x 3 is 14 operations by its first row, 17 by the source's rule; the preparation of this project forms them so",
            ),
            row("matrix of cofactors, minors shared", "5.1.2", 272.0, change::cofactors_of_shared_minors())
                .why("the 16 cofactors have 12 minors of 2 x 2 in common"),
            row("division by the determinant", "5.1.2", 24.0, change::inverse()).why(same),
            row(
                "inverse, all",
                "5.1.2",
                391.0,
                change::cofactors() + change::determinant() + change::inverse(),
            )
            .why("determinant from the cofactors"),
            row("matrices of a quadric: product, determinant, cofactors", "5.1.2", 479.0, change::quadric_matrices())
                .why("determinant from the cofactors"),
            row("patch, corners of its tetrahedron", "5.1.2", 140.0, change::tetrahedron()).why(same),
        ],
    }
}

/// Facets.
pub fn facet() -> Group {
    use facets::{
        contour, contour_words, expressed, expression_words, expressions, followed, lighting,
    };
    let plain = lighting(false, false);
    let lit = |near: f64, corrected: f64, name: &str, ours: f64| {
        row(name, "Table 5.3", near, ours).corrected(corrected).why(
            "a direction, 27 operations, is needed at each of the three corners; the print adds it once",
        )
    };
    let frame = change::product() + change::facet();
    let colours = "Gouraud: light at the corners, then three colours";
    let normals = "Phong: three components of the normal";
    let sums = "sum of the rows above";
    Group {
        name: "facet",
        title: "Facet: set-up, light, totals",
        about: format!(
            "A facet of three corners. Contour following is run with a facet that has two sides on its left, the longer case. The power of Phong's formula is by squaring with the worst exponent up to 128, {}: {} operations \
             for the 20 that the source's sum implies.",
            facets::WORST_EXPONENT,
            facets::one_power()
        ),
        rows: vec![
            row("contour following, set-up", "Table 5.1", 73.0, contour()).why(
                "the same 11 subtractions, 8 products and 4 divisions; 8 tests sort the corners and find the sides, where the source has 22; 4 more for the step of the depth along the left sides",
            ),
            row("expressions, set-up", "Table 5.1", 43.0, expressions())
                .why("the constants of the three sides add up to the doubled area, so it is no product more"),
            row("light at three corners, all far away", "Table 5.2", 207.0, plain).why(
                "both cosines are tested for their sign, and colours are three; the power is cheaper",
            ),
            lit(234.0, 288.0, "the same, source at a point", lighting(true, false)),
            lit(234.0, 288.0, "the same, viewer at a point", lighting(false, true)),
            lit(261.0, 369.0, "the same, both", lighting(true, true)),
            row("three quantities, contour following", "Table 5.4", 54.0, followed())
                .why("differences of the corners and one over the area are shared with the depth"),
            row("three quantities, expressions", "Table 5.4", 72.0, expressed())
                .why("the same"),
            row("colours, contour following", "Table 5.4", 334.0, contour() + plain + followed()).why(colours),
            row("colours, expressions", "Table 5.4", 322.0, expressions() + plain + expressed()).why(colours),
            row("normals, contour following", "Table 5.4", 127.0, contour() + followed()).why(normals),
            row("normals, expressions", "Table 5.4", 115.0, expressions() + expressed()).why(normals),
            row("whole numbers, contour following", "Table 5.5", 45.0, contour_words())
                .why("21 values, each a product and a conversion; a normal of length 1 needs no search of its greatest component"),
            row("whole numbers, expressions", "Table 5.5", 72.0, expression_words())
                .why("corners are put on a grid of 1/16 pixel, and then the sides are whole without a conversion"),
            row("colours, contour following, all", "Table 5.5", 626.0, frame + contour() + plain + followed() + contour_words()).why(sums),
            row("colours, expressions, all", "Table 5.5", 641.0, frame + expressions() + plain + expressed() + expression_words()).why(sums),
            row("normals, contour following, all", "Table 5.5", 434.0, frame + contour() + followed() + contour_words()).why(sums),
            row("normals, expressions, all", "Table 5.5", 449.0, frame + expressions() + expressed() + expression_words()).why(sums),
        ],
    }
}

/// Quadrics, patches, and all of them side by side.
pub fn quadric() -> Group {
    use quadrics::{depth, depth_words, normal, normal_words, plane, plane_normal, plane_words};
    let forms = depth() + normal();
    let words = depth_words() + normal_words();
    let with = |matrices: f64, object: f64| matrices + object;
    Group {
        name: "quadric",
        title: "Quadric and patch: expressions, words, totals",
        about: "After the change of frame, with the perspective in its matrix. A quadric has three planes with constant normals, a patch four planes without."
            .into(),
        rows: vec![
            row("quadric: expressions of depth and normal", "Table 5.6", 52.0, forms).corrected(51.0).why(
                format!("its parts in the text are 33 + 18; ours are {} + {}: the third component of the normal before perspective takes four products with 1/D, and the class of the view two tests", depth(), normal()),
            ),
            row("quadric: whole numbers", "Table 5.6", 74.0, words).corrected(70.0).why(format!(
                "its parts in the text are 16 + 54; ours are {} + {}: the scale of the normal needs its greatest component over the box, found here from four corners and the greatest root, which is most of it",
                depth_words(),
                normal_words()
            )),
            row("three planes: expressions", "Table 5.6", 54.0, 3.0 * plane()).why("side, division, steepness"),
            row("three planes: whole numbers and normals", "Table 5.6", 93.0, 3.0 * (plane_words() + plane_normal()))
                .why("three products and conversions of the depth, normalisation, and three of the normal, for each plane"),
            row("quadric processor, all", "Table 5.6", 273.0, quadrics::solid()).why("sum"),
            row("patch: four planes", "Table 5.6", 120.0, 4.0 * (plane() + plane_words())).why("a plane of a patch has no normal"),
            row("patch processor, all", "Table 5.6", 245.0, quadrics::patch()).why("sum, with depth and normal as in the quadric"),
            row("facet, contour following", "Table 5.7", 322.0, facets::phong_by_contour()).why("without the product of the matrices"),
            row("facet, contour following, with matrices", "Table 5.7", 334.0, with(change::product(), facets::phong_by_contour()))
                .corrected(434.0)
                .why("322 and 112 are 434, as Table 5.5 has it"),
            row("facet, expressions", "Table 5.7", 337.0, facets::phong_by_expressions()).why("without the product of the matrices"),
            row("facet, expressions, with matrices", "Table 5.7", 449.0, with(change::product(), facets::phong_by_expressions())).why("sum"),
            row("quadric, three planes", "Table 5.7", 539.0, quadrics::solid_in_all()).why("182, 84 and 273 there"),
            row("quadric, three planes, with matrices", "Table 5.7", 1018.0, with(change::quadric_matrices(), quadrics::solid_in_all()))
                .why("more for the scale of the normal, less for cofactors and determinant"),
            row("patch, four planes", "Table 5.7", 567.0, quadrics::patch_in_all()).why("182, 140 and 245 there"),
            row("patch, four planes, with matrices", "Table 5.7", 1046.0, with(change::quadric_matrices(), quadrics::patch_in_all()))
                .why("the same"),
        ],
    }
}

/// The polyhedron of annex A.
pub fn polyhedron() -> Group {
    let faces = 6.0;
    let normals = faces * quadrics::normalisation();
    let words = faces * quadrics::plane_words();
    let normal_words = faces * quadrics::plane_normal() - normals;
    let all = faces
        * (change::plane()
            + quadrics::plane()
            + quadrics::plane_words()
            + quadrics::plane_normal());
    let facets = 12.0 * facets::phong_by_expressions();
    Group {
        name: "polyhedron",
        title: "Polyhedron of six faces",
        about: "Without the matrices, which its faces share.".into(),
        rows: vec![
            row("planes, change of frame", "annex A", 168.0, faces * change::plane()).why("the same"),
            row("planes, expressions", "annex A", 72.0, faces * quadrics::plane())
                .why("with the side and the steepness of each plane"),
            row("normals made as long as 1", "annex A", 144.0, normals).why("the same"),
            row("whole numbers of the depths", "annex A", 36.0, words).why("the same"),
            row("whole numbers of the normals", "annex A", 36.0, normal_words).why("the same"),
            row("polyhedron, all", "annex A", 600.0, all)
                .corrected(456.0)
                .why("the print adds the 144 of the normals twice"),
            Row::new("over one facet", "annex A", "less than 2", all / facets::phong_by_expressions(), "times").why(
                "both without the product of the matrices",
            ),
            Row::new("its twelve facets over it", "annex A", "4 times", facets / all, "times")
                .why("twelve triangles with normals, by expressions; with normals that are the same all over a face they would be cheaper"),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Sums of the printed tables, with the corrections: a slip in a printed number does not get through.
    #[test]
    fn printed_values_add_up() {
        let printed = |group: &Group, name: &str| {
            let row = group.rows.iter().find(|row| row.name == name);
            row.unwrap_or_else(|| panic!("no {name}"))
                .reference()
                .expect("a number")
        };
        let facet = facet();
        let of = |name: &str| printed(&facet, name);
        for (way, set_up, quantities) in [
            ("contour following", 73.0, 54.0),
            ("expressions", 43.0, 72.0),
        ] {
            assert_eq!(of(&format!("{way}, set-up")), set_up);
            assert_eq!(of(&format!("colours, {way}")), set_up + 207.0 + quantities);
            assert_eq!(of(&format!("normals, {way}")), set_up + quantities);
            let all = 262.0 + set_up + quantities + of(&format!("whole numbers, {way}"));
            assert_eq!(of(&format!("normals, {way}, all")), all);
        }
        let frame = frame();
        let of = |name: &str| printed(&frame, name);
        assert_eq!(of("facet, all"), 112.0 + 117.0 + 33.0);
        assert_eq!(
            of("matrices of a quadric: product, determinant, cofactors"),
            112.0 + 95.0 + 272.0
        );
        assert_eq!(of("inverse, all"), 272.0 + 95.0 + 24.0);
        let quadric = quadric();
        let of = |name: &str| printed(&quadric, name);
        assert_eq!(of("quadric processor, all"), 52.0 + 74.0 + 54.0 + 93.0);
        assert_eq!(of("patch processor, all"), 51.0 + 74.0 + 120.0);
        assert_eq!(of("quadric, three planes"), 182.0 + 84.0 + 273.0);
        assert_eq!(of("quadric, three planes, with matrices"), 539.0 + 479.0);
        assert_eq!(of("patch, four planes, with matrices"), 567.0 + 479.0);
        let polyhedron = polyhedron();
        let parts: f64 = polyhedron.rows[..5].iter().filter_map(Row::reference).sum();
        assert_eq!(printed(&polyhedron, "polyhedron, all"), parts);
    }

    /// Our totals are the sums of our parts.
    #[test]
    fn our_sums_add_up() {
        let ours = |group: &Group, name: &str| {
            group
                .rows
                .iter()
                .find(|row| row.name == name)
                .expect("a row")
                .ours
        };
        let quadric = quadric();
        let of = |name: &str| ours(&quadric, name);
        let parts: f64 = quadric.rows[..4].iter().map(|row| row.ours).sum();
        assert_eq!(of("quadric processor, all"), parts);
        assert_eq!(
            of("patch processor, all"),
            quadric.rows[0].ours + quadric.rows[1].ours + of("patch: four planes")
        );
        assert_eq!(
            of("quadric, three planes"),
            182.0 + 84.0 + of("quadric processor, all")
        );
        assert_eq!(
            of("patch, four planes"),
            182.0 + 140.0 + of("patch processor, all")
        );
        let polyhedron = polyhedron();
        let parts: f64 = polyhedron.rows[..5].iter().map(|row| row.ours).sum();
        assert_eq!(ours(&polyhedron, "polyhedron, all"), parts);
    }
}
