//! Weighted operations of every step of the preparation, each found by running it.
//!
//! The numbers that the steps are run with are of no meaning: no step asks a question whose answer changes its cost,
//! except where its name says so.

use super::count::{Counted, Tally, cost, number, numbers};
use super::work::facet;
use super::work::lighting::{Colours, Place, light, power};
use super::work::transform::{
    affine_product, cofactors_of_shared_minors, determinant, determinant_alone, direction, divided,
    inverse, normalised, point, quadric_in_full,
};
use super::work::zones::{outline, outline_of};
use super::work::{quadric, transform, zones};
use imogene_algebra::matrix::{cofactors4, image, product};
use serde_json::{Map, Value, json};

const MATRIX: [[f64; 4]; 4] = [
    [2.0, -1.0, 3.0, 5.0],
    [0.5, 4.0, 1.0, -2.0],
    [7.0, 1.0, -3.0, 6.0],
    [1.0, 0.25, 2.0, 3.0],
];
/// A sphere seen from the side, after perspective.
const QUADRIC: [f64; 10] = [
    1.0, 1.0, 1.7, 0.0, 0.02, -0.01, -20.0, 10.0, -380.0, 80_500.0,
];
const PLANE: [f64; 4] = [2.0, -4.0, -8.0, 16.0];
const POINT: [f64; 3] = [1.0, 2.0, 3.0];
/// Its middle corner is left of the long side, so that two sides are followed on the left: the longer case.
const CORNERS: [[f64; 3]; 3] = [[10.0, 2.0, 7.0], [1.0, 9.0, -3.0], [12.0, 20.0, 11.0]];
const QUANTITIES: [[f64; 3]; 3] = [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]];
/// Corners of a box with sides along no axis of the screen: all of them are apart, six are on the outline.
const CUBE: [[f64; 2]; 8] = [
    [0.0, 0.0],
    [40.0, 9.0],
    [13.0, 30.0],
    [53.0, 39.0],
    [17.0, -6.0],
    [57.0, 3.0],
    [30.0, 24.0],
    [70.0, 33.0],
];
/// Corners of a tetrahedron, all of them on the outline.
const TETRAHEDRON: [[f64; 2]; 4] = [[0.0, 0.0], [40.0, 9.0], [13.0, 30.0], [53.0, 39.0]];
/// The exponent up to 128 whose power takes most products.
const WORST_EXPONENT: u32 = 127;

fn steps() -> Vec<(&'static str, Tally)> {
    let (m, q, vector) = (MATRIX.map(numbers), numbers(QUADRIC), numbers(POINT));
    let (corners, quantities) = (CORNERS.map(numbers), QUANTITIES.map(numbers));
    let [depth_scale, quantity_scale] = numbers([8388.0, 32_767.0]);
    let [k, l] = numbers([128.0, 256.0]);
    let over_distance = number(0.001);
    let contour = || facet::contour(corners).expect("the corners have an area");
    let depth = || quadric::depth(q).expect("it has a depth");
    let lit = |source, viewer| move || lit_corners(source, viewer);
    vec![
        step("product", || product(&m, &m)),
        step("affine_product", || affine_product(&m, &m)),
        step("point", || point(&m, vector)),
        step("direction", || direction(&m, vector)),
        step("divide", || divided(numbers([1.0, 2.0, 3.0, 4.0]))),
        step("plane_image", || image(&m, &numbers(PLANE))),
        step("quadric_in_full", || quadric_in_full(&m, q)),
        step("quadric_image", || transform::quadric(&m, q)),
        step("cofactors", || cofactors4(&m)),
        step("shared_cofactors", || cofactors_of_shared_minors(&m)),
        step("determinant_alone", || determinant_alone(&m)),
        step("determinant", || determinant(&m, &m)),
        step("inverse", || inverse(&m, number(2.0))),
        step("normalised", || normalised(vector)),
        step("contour", contour),
        step("contour_and_followed", || {
            let contour = contour();
            quantities.map(|w| facet::followed(&contour, w))
        }),
        step("contour_to_words", || {
            facet::contour_words(&contour(), quantities, depth_scale, quantity_scale)
        }),
        step("expressions", || facet::expressions(corners)),
        step("expressions_and_expressed", || {
            let facet = facet::expressions(corners);
            quantities.map(|w| facet::expressed(&facet.shape, corners, w))
        }),
        step("expressions_to_words", || {
            facet::expression_words(corners, quantities, depth_scale, quantity_scale)
        }),
        step("light", lit(Place::Far, Place::Far)),
        step("light_near_source", lit(Place::Near, Place::Far)),
        step("light_near_viewer", lit(Place::Far, Place::Near)),
        step("light_near_both", lit(Place::Near, Place::Near)),
        step("one_power", || power(number(0.9), WORST_EXPONENT)),
        step("depth", depth),
        step("depth_to_words", || {
            quadric::depth_words(&depth(), depth_scale, number(7e7))
        }),
        step("normal", || quadric::normal(q, &vector, over_distance)),
        // With the search of its greatest component.
        step("normal_to_words", || {
            let depth = depth();
            let normal = quadric::normal(q, &depth.f1, over_distance);
            let root = quadric::greatest_f2(&depth.f2).root();
            let window = numbers([-70.0, -90.0, 180.0, 170.0]);
            let greatest = quadric::greatest_normal(&normal, root, window);
            quadric::normal_words(&normal, greatest, over_distance)
        }),
        step("plane", || {
            quadric::plane(numbers(PLANE), depth_scale, number(16e6))
        }),
        step("plane_words", || vector.map(|v| v.scaled(depth_scale))),
        step("plane_normal", || quadric::constant_normal(vector)),
        step("facet_box", || presort(&CUBE[..3])),
        step("patch_box", || presort(&TETRAHEDRON)),
        step("box_of_eight", || presort(&CUBE)),
        step("outline_to_box", || {
            let window = zones::box_of_outline(&depth().f2);
            zones::zones(window, number(1.0 / 128.0))
        }),
        step("facet_sides", || outline(&points(&CUBE[..3]))),
        step("facet_sides_and_corner", || {
            corner(outline(&points(&CUBE[..3])));
        }),
        step("patch_sides", || outline(&points(&TETRAHEDRON))),
        step("patch_sides_and_corner", || {
            corner(outline(&points(&TETRAHEDRON)));
        }),
        step("quadric_sides", || outline_of(&points(&CUBE), is_edge)),
        step("quadric_sides_and_corner", || {
            corner(outline_of(&points(&CUBE), is_edge));
        }),
        step("moved_line", || zones::moved_line(&vector, k, l)),
        step("moved_conic", || {
            zones::moved_conic(&numbers([1.0; 6]), k, l)
        }),
    ]
}

/// What a step costs; its result is of no use.
fn step<T>(name: &'static str, work: impl FnOnce() -> T) -> (&'static str, Tally) {
    (name, cost(|| drop(work())))
}

/// What each step costs; with factors that are powers of two, and shifts, a moved expression its additions.
pub fn costs() -> Map<String, Value> {
    let costs = steps();
    let weighted = |(name, cost): &(&str, Tally)| ((*name).into(), json!(cost.weighted()));
    let whole = costs.iter().map(weighted);
    let moved = costs.iter().filter(|(name, _)| name.starts_with("moved"));
    let shifted = moved.map(|(name, cost)| (format!("{name}_by_shifts"), json!(cost.additions)));
    let exponent = ("worst_exponent".into(), json!(WORST_EXPONENT));
    whole.chain(shifted).chain([exponent]).collect()
}

fn points(list: &[[f64; 2]]) -> Vec<[Counted; 2]> {
    list.iter().map(|p| numbers(*p)).collect()
}

fn presort(list: &[[f64; 2]]) {
    let window = zones::box_of(&points(list));
    zones::zones(window, number(1.0 / 128.0));
}

/// A zone's corner against the sides of an outline.
fn corner(sides: Vec<facet::Line>) {
    facet::is_inside(&sides, number(5.0), number(6.0));
}

/// Two corners of the box in space are joined if they differ in one bit of their index.
fn is_edge(i: usize, j: usize) -> bool {
    (i ^ j).is_power_of_two()
}

fn lit_corners(source: fn([Counted; 3]) -> Place, viewer: fn([Counted; 3]) -> Place) {
    let direction = numbers([0.0, 0.6, 0.8]);
    let colours = Colours {
        ambient: direction,
        diffuse: direction,
        specular: direction,
        exponent: WORST_EXPONENT,
    };
    let point = numbers([0.0; 3]);
    for _ in 0..3 {
        let normal = numbers([0.1, 0.2, 0.9]);
        let (source, viewer) = (source(direction), viewer(direction));
        light(point, normal, &source, &viewer, &colours);
    }
}
