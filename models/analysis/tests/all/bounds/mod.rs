//! The bounds of prepared objects: random quadrics through the whole preparation, in random formats, compared exactly.

mod accumulators;
mod depth;
mod headroom;
mod interval;
mod kind;
mod outline;
mod quick;
mod silhouette;

use imogene_algebra::rational::{fraction, from_f64_exact, integer, power_of_two};
use imogene_analysis::bounds::depth_bound;
use imogene_analysis::exact::number::SurdReal;
use imogene_contract::{MachineWords, RootForm};
use imogene_golden::format::Format;
use imogene_golden::unit::depth_interval::{Class, FACE_FAR, FACE_NEAR};
use imogene_prepare::{PreparedQuadric, prepare_for_roots as prepare_for};
use imogene_scene::{Quadric, Surface};
use imogene_testkit::*;
use num_rational::BigRational;
use num_traits::{One, Signed};
use proptest::prelude::*;
use std::cmp::Ordering;

fn formats() -> impl Strategy<Value = Format> {
    (0usize..5, 0u32..=8, 0u32..=8).prop_map(|(depth, linear, quadratic)| {
        let base = Format::new(Format::CATALOGUE[depth]).expect("in the catalogue");
        let quadratic = quadratic.min(64 - base.quadratic);
        base.with_guards(linear, quadratic).expect("within limits")
    })
}

const FORMS: [RootForm; 8] = [
    RootForm::NonRestoring,
    RootForm::Linear(0),
    RootForm::Linear(1),
    RootForm::Linear(2),
    RootForm::Quadratic(0),
    RootForm::Quadratic(1),
    RootForm::Leading(3),
    RootForm::Leading(12),
];

/// Of fitted machines: depth words of no catalogue, normals of 10 to 16 bits, root networks without their last rows,
/// and every form of the root.
fn fitted_formats() -> impl Strategy<Value = Format> {
    let form = prop_oneof![Just(RootForm::Restoring), prop::sample::select(&FORMS[..])];
    let widths = (12u32..=28, 10u32..=16, 0u32..=4, 0u32..=8, 0u32..=8);
    (widths, form).prop_map(|((depth, normal, linear, quadratic, dropped), form)| {
        let digits = depth - dropped;
        let widths = MachineWords {
            normal,
            guard_linear: linear,
            guard_quadratic: quadratic,
            dropped_rows: dropped,
            root_form: match form.least_digits() <= digits {
                true => form,
                false => RootForm::Leading(digits / 2),
            },
            ..MachineWords::of(depth)
        };
        Format::fitted(&widths).expect("within limits")
    })
}

/// `|computed - exact| <= bound`, exactly.
fn within(computed: BigRational, exact: &BigRational, bound: f64) -> bool {
    (computed - exact).abs() <= from_f64_exact(bound)
}

/// `|depth - (f1 + sign sqrt(f2))| <= bound`, exactly.
fn depth_within(depth: i64, f1: &BigRational, sign: i32, f2: &BigRational, bound: f64) -> bool {
    let (d1, d2) = (f1.denom(), f2.denom());
    let exact = SurdReal::new(f1.numer() * d2, sign, f2.numer() * d2 * d1 * d1, d1 * d2);
    let (depth, bound) = (integer(depth), from_f64_exact(bound));
    let (low, high) = (&depth - &bound, depth + bound);
    exact.cmp_ratio(low.numer(), low.denom()) != Ordering::Less
        && exact.cmp_ratio(high.numer(), high.denom()) != Ordering::Greater
}

fn check_pixel(
    object: &PreparedQuadric,
    format: &Format,
    x: i64,
    y: i64,
) -> Result<(), TestCaseError> {
    let (px, py) = (integer(x), integer(y));
    let (f1, f2) = (object.exact.f1.at(&px, &py), object.exact.f2.at(&px, &py));
    let words = &object.words;
    let output = |value, guards| BigRational::from_integer(value) / power_of_two(guards);
    let q1 = output(words.f1.exact_at(x, y), format.guard_linear);
    let q2 = output(words.f2.exact_at(x, y), format.guard_quadratic);
    prop_assert!(within(q1, &f1, object.bounds.f1), "f1 at ({x}, {y})");
    prop_assert!(within(q2, &f2, object.bounds.f2), "f2 at ({x}, {y})");
    for (i, plane) in words.planes.iter().enumerate() {
        let computed = BigRational::from_integer(plane.depth.exact_at(x, y));
        let exact = object.exact.planes[i].at(&px, &py);
        let holds = within(computed, &exact, object.bounds.planes[i]);
        prop_assert!(holds, "plane {i} at ({x}, {y})");
    }
    let (own_f1, own_f2) = (words.f1_at(x, y, format), words.f2_at(x, y, format));
    if f2.is_negative() || own_f2 < 0 || words.class == Class::Prism {
        return Ok(());
    }
    let root = format.root_of(own_f2);
    for (face, sign) in [(FACE_NEAR, -1), (FACE_FAR, 1)] {
        let bound = depth_bound(object, face, own_f2);
        let depth = own_f1 + i64::from(sign) * root;
        let holds = depth_within(depth, &f1, sign, &f2, bound);
        prop_assert!(holds, "face {face} at ({x}, {y}): {depth} beyond {bound}");
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn prepared_objects_stay_within_their_bounds(
        format in prop_oneof![formats(), fitted_formats()], squares in [1i64..500, 1i64..500, 1i64..500], signs in 0usize..4, cross in [-100i64..100, -100i64..100, -100i64..100],
        centre in [-300i64..300, -200i64..200, -200i64..600], size in 1i64..200, denominator in 1i64..1000, plane in [-50i64..50, -50i64..50, -50i64..50, -300i64..300],
        places in proptest::collection::vec((0.0f64..1.0, 0.0f64..1.0), 6)
    ) {
        let [a, b, c] = squares;
        let [a, b, c] = [[a, b, c], [a, -b, c], [a, b, -c], [-a, b, c]][signs];
        let [d, e, f] = cross;
        let [x, y, z] = centre;
        // (p - m)' M (p - m) = |a| size^2, over a common denominator.
        let linear = [a * x + d * y + e * z, d * x + b * y + f * z, e * x + f * y + c * z];
        let constant = linear[0] * x + linear[1] * y + linear[2] * z - a.abs() * size * size;
        let form = [a, b, c, d, e, f, -linear[0], -linear[1], -linear[2], constant];
        let mut form = form.map(|n| fraction(n, denominator));
        form[9] += BigRational::one() / integer(7);
        let scene = scene(vec![object("thing", Surface::Patch, Quadric::from_array(form), &[plane])]);
        // Refusals are the business of other tests; if they became frequent this one would give up and fail.
        let prepared = prepare_for(&scene, format);
        prop_assume!(prepared.is_ok());
        let prepared = prepared.expect("assumed");
        let object = first(&prepared);
        let b = object.words.screen_box;
        prop_assume!(!b.is_empty());
        for (x, y) in [(b.x0, b.y0), (b.x1, b.y0), (b.x0, b.y1), (b.x1, b.y1)] {
            check_pixel(object, &format, x, y)?;
        }
        for (s, t) in places {
            let at = |low: i64, high: i64, part: f64| low + (part * (high - low) as f64) as i64;
            check_pixel(object, &format, at(b.x0, b.x1, s), at(b.y0, b.y1, t))?;
        }
    }
}
