//! Weighted operations of every step of the preparation, each found by running it.
//!
//! The numbers that the steps are run with are of no meaning: no step asks a question whose answer changes its cost,
//! except where its name says so.

use super::count::{Counted, Tally, cost, number, numbers};
use super::work::facet::{self, Contour, Corners};
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

/// A step by its name.
type Step = (&'static str, fn());

const STEPS: &[Step] = &[
    ("product", || done(product(&matrix(), &matrix()))),
    ("affine_product", || {
        done(affine_product(&matrix(), &matrix()))
    }),
    ("point", || done(point(&matrix(), numbers(POINT)))),
    ("direction", || done(direction(&matrix(), numbers(POINT)))),
    ("divide", || done(divided(numbers([1.0, 2.0, 3.0, 4.0])))),
    ("plane_image", || done(image(&matrix(), &numbers(PLANE)))),
    ("quadric_in_full", || {
        done(quadric_in_full(&matrix(), numbers(QUADRIC)))
    }),
    ("quadric_image", || {
        done(transform::quadric(&matrix(), numbers(QUADRIC)))
    }),
    ("cofactors", || done(cofactors4(&matrix()))),
    ("shared_cofactors", || {
        done(cofactors_of_shared_minors(&matrix()))
    }),
    ("determinant_alone", || done(determinant_alone(&matrix()))),
    ("determinant", || done(determinant(&matrix(), &matrix()))),
    ("inverse", || done(inverse(&matrix(), number(2.0)))),
    ("normalised", || done(normalised(numbers(POINT)))),
    ("contour", || done(contour())),
    ("contour_and_followed", || {
        let contour = contour();
        done(quantities().map(|w| facet::followed(&contour, w)));
    }),
    ("contour_to_words", || {
        let [depth, quantity] = numbers([8388.0, 32_767.0]);
        done(facet::contour_words(
            &contour(),
            quantities(),
            depth,
            quantity,
        ));
    }),
    ("expressions", || done(facet::expressions(corners()))),
    ("expressions_and_expressed", || {
        let facet = facet::expressions(corners());
        done(quantities().map(|w| facet::expressed(&facet.shape, corners(), w)));
    }),
    ("expressions_to_words", || {
        let [depth, quantity] = numbers([8388.0, 32_767.0]);
        done(facet::expression_words(
            corners(),
            quantities(),
            depth,
            quantity,
        ));
    }),
    ("light", || lit_corners(Place::Far, Place::Far)),
    ("light_near_source", || lit_corners(Place::Near, Place::Far)),
    ("light_near_viewer", || lit_corners(Place::Far, Place::Near)),
    ("light_near_both", || lit_corners(Place::Near, Place::Near)),
    ("one_power", || done(power(number(0.9), WORST_EXPONENT))),
    ("depth", || done(depth())),
    ("depth_to_words", || {
        let [scale, square] = numbers([8388.0, 7e7]);
        done(quadric::depth_words(&depth(), scale, square));
    }),
    ("normal", || {
        done(quadric::normal(
            numbers(QUADRIC),
            &numbers(POINT),
            number(0.001),
        ));
    }),
    // With the search of its greatest component.
    ("normal_to_words", || {
        let depth = depth();
        let normal = quadric::normal(numbers(QUADRIC), &depth.f1, number(0.001));
        let root = quadric::greatest_f2(&depth.f2).root();
        let window = numbers([-70.0, -90.0, 180.0, 170.0]);
        let greatest = quadric::greatest_normal(&normal, root, window);
        done(quadric::normal_words(&normal, greatest, number(0.001)));
    }),
    ("plane", || {
        done(quadric::plane(numbers(PLANE), number(8388.0), number(16e6)))
    }),
    ("plane_words", || {
        done(numbers(POINT).map(|v| v.scaled(number(8388.0))));
    }),
    ("plane_normal", || {
        done(quadric::constant_normal(numbers(POINT)))
    }),
    ("facet_box", || presort(&CUBE[..3])),
    ("patch_box", || presort(&TETRAHEDRON)),
    ("box_of_eight", || presort(&CUBE)),
    ("outline_to_box", || {
        let window = zones::box_of_outline(&depth().f2);
        done(zones::zones(window, number(1.0 / 128.0)));
    }),
    ("facet_sides", || done(outline(&points(&CUBE[..3])))),
    ("facet_sides_and_corner", || {
        corner(outline(&points(&CUBE[..3])))
    }),
    ("patch_sides", || done(outline(&points(&TETRAHEDRON)))),
    ("patch_sides_and_corner", || {
        corner(outline(&points(&TETRAHEDRON)))
    }),
    ("quadric_sides", || {
        done(outline_of(&points(&CUBE), is_edge))
    }),
    ("quadric_sides_and_corner", || {
        corner(outline_of(&points(&CUBE), is_edge))
    }),
    ("moved_line", || {
        let [k, l] = numbers([128.0, 256.0]);
        done(zones::moved_line(&numbers(POINT), k, l));
    }),
    ("moved_conic", || {
        let [k, l] = numbers([128.0, 256.0]);
        done(zones::moved_conic(&numbers([1.0; 6]), k, l));
    }),
];

/// What each step costs. Without products, where a factor is a power of two and they are shifts, a step costs its
/// additions.
pub fn costs() -> Map<String, Value> {
    let costs = STEPS.iter().map(|(name, step)| (*name, cost(step)));
    let costs: Vec<(&str, Tally)> = costs.collect();
    let weighted = |(name, cost): &(&str, Tally)| ((*name).into(), json!(cost.weighted()));
    let whole = costs.iter().map(weighted);
    let moved = costs.iter().filter(|(name, _)| name.starts_with("moved"));
    let shifted = moved.map(|(name, cost)| (format!("{name}_by_shifts"), json!(cost.additions)));
    let exponent = ("worst_exponent".into(), json!(WORST_EXPONENT));
    whole.chain(shifted).chain([exponent]).collect()
}

/// The result of a step has been counted and is of no further use.
fn done<T>(_result: T) {}

fn matrix() -> transform::Matrix {
    MATRIX.map(numbers)
}

fn corners() -> Corners {
    CORNERS.map(numbers)
}

fn quantities() -> [[Counted; 3]; 3] {
    [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0], [7.0, 8.0, 9.0]].map(numbers)
}

fn contour() -> Contour {
    facet::contour(corners()).expect("the corners have an area")
}

fn depth() -> quadric::Depth {
    quadric::depth(numbers(QUADRIC)).expect("it has a depth")
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

/// Light at three corners.
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
