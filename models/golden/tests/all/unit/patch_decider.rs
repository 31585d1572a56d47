use crate::common::permutations;
use crate::common::{choices, planes_at};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::{Class, Interval, halves};
use imogene_golden::unit::patch_decider::{Faces, decide, kept, visible};

const F: Format = Format::BASE;

type Plane = (PlaneKind, i64);

fn parallel(near: i64, far: i64, there: bool, planes: &[Plane]) -> Interval {
    let left = planes
        .iter()
        .map(|&(kind, zp)| kept(kind, zp, near, far))
        .fold(visible(near, far, there, &F), Faces::and);
    decide(near, far, left, &F)
}

fn sequential(near: i64, far: i64, there: bool, planes: &[Plane], order: &[usize]) -> Interval {
    let start = halves(Class::Patch, near, far, !there, &F).0;
    order.iter().fold(start, |state, &i| {
        cut(state, planes[i].0, planes[i].1, 2 + i as u8, true, &F)
    })
}

/// Compares all configurations of `n` planes whose depths stand at one of `levels`, roots likewise, in every order
/// of the planes.
fn exhaust(n: usize, levels: &[i64]) -> (u64, u64) {
    let orders = permutations(n);
    let (mut configurations, mut runs) = (0, 0);
    for planes in choices(&planes_at(levels), n as u32) {
        for (i, &near) in levels.iter().enumerate() {
            for &far in &levels[i..] {
                let decided = parallel(near, far, true, &planes);
                for order in &orders {
                    assert_eq!(
                        sequential(near, far, true, &planes, order),
                        decided,
                        "roots {near}, {far}, planes {planes:?} in the order {order:?}"
                    );
                }
                configurations += 1;
                runs += orders.len() as u64;
            }
        }
    }
    (configurations, runs)
}

/// Two roots and n planes on n + 2 levels: every order there is, with every tie.
#[test]
fn equals_the_chain_of_cut_planes_in_every_order() {
    let counts: Vec<(u64, u64)> = (0..=4)
        .map(|n| {
            let levels: Vec<i64> = (0..n as i64 + 2).collect();
            exhaust(n, &levels)
        })
        .collect();
    assert_eq!(
        counts,
        [
            (3, 3),
            (48, 48),
            (1_000, 2_000),
            (25_920, 155_520),
            (806_736, 19_361_664)
        ]
    );
}

/// Roots beyond the ends are no faces; planes are saturated at them, and absent planes pass everything.
#[test]
fn equals_the_chain_at_both_ends_of_the_depth_word() {
    let (low, end) = (F.z_low(), F.z_max());
    let levels = [low - 1, low, low + 1, 0, end - 1, end];
    let beyond = [low - 70, low - 1, low, 0, end - 1, end, end + 70];
    let mut all = planes_at(&levels);
    all.extend([(PlaneKind::None, 0), (PlaneKind::Perpendicular, low - 1)]);
    for (i, &near) in beyond.iter().enumerate() {
        for &far in &beyond[i..] {
            for planes in choices(&all, 2) {
                for there in [false, true] {
                    let decided = parallel(near, far, there, &planes);
                    for order in [[0, 1], [1, 0]] {
                        let chain = sequential(near, far, there, &planes, &order);
                        assert_eq!(chain, decided, "{near} {far} {planes:?} {there}");
                    }
                }
            }
        }
    }
}

/// With signals from front planes to the front face and from back planes to the back face only, one plane could
/// never remove both faces: the decision is wrong already for one plane.
#[test]
fn each_plane_has_a_say_on_both_faces() {
    let front_only = |zp: i64, near: i64, far: i64| {
        Faces::new(kept(PlaneKind::Front, zp, near, far).front, true)
    };
    let wrong = decide(1, 2, front_only(3, 1, 2), &F);
    let right = decide(1, 2, kept(PlaneKind::Front, 3, 1, 2), &F);
    assert!(wrong.is_present(&F) && !right.is_present(&F));
}
