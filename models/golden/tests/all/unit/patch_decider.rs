use crate::common::{choices, permutations, planes_at};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::{Class, Interval, halves};
use imogene_golden::unit::patch_decider::{Faces, decide, kept, visible};

const F: Format = Format::BASE;

type Plane = (PlaneKind, i64);

fn parallel(near: i64, far: i64, there: bool, planes: &[Plane]) -> Interval {
    let each = planes.iter().map(|&(kind, zp)| kept(kind, zp, near, far));
    let left = each.fold(visible(near, far, there, &F), Faces::and);
    decide(near, far, left, &F)
}

fn sequential(near: i64, far: i64, there: bool, planes: &[Plane], order: &[usize]) -> Interval {
    let start = halves(Class::Patch, near, far, !there, &F).0;
    order.iter().fold(start, |state, &i| {
        cut(state, planes[i].0, planes[i].1, 2 + i as u8, true, &F)
    })
}

/// Compares all configurations of `n` planes whose depths stand at one of `levels`, roots likewise, in every order
/// of the planes; how many configurations and orders there are.
fn exhaust(n: usize, levels: &[i64]) -> (usize, usize) {
    let orders = permutations(n);
    let mut configurations = 0;
    for planes in choices(&planes_at(levels), n as u32) {
        for (i, &near) in levels.iter().enumerate() {
            for &far in &levels[i..] {
                let decided = parallel(near, far, true, &planes);
                for order in &orders {
                    let found = sequential(near, far, true, &planes, order);
                    assert_eq!(
                        found, decided,
                        "{near} {far} {planes:?} in the order {order:?}"
                    );
                }
                configurations += 1;
            }
        }
    }
    (configurations, orders.len())
}

/// Two roots and n planes on n + 2 levels: every order there is, with every tie.
#[test]
fn equals_the_chain_of_cut_planes_in_every_order() {
    let counts = [(3, 1), (48, 1), (1_000, 2), (25_920, 6), (806_736, 24)];
    for (n, expected) in counts.into_iter().enumerate() {
        let levels: Vec<i64> = (0..n as i64 + 2).collect();
        assert_eq!(exhaust(n, &levels), expected, "{n} planes");
    }
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
    let left = kept(PlaneKind::Front, 3, 1, 2);
    let wrong = decide(1, 2, Faces::new(left.front, true), &F);
    let right = decide(1, 2, left, &F);
    assert!(wrong.is_present(&F) && !right.is_present(&F));
}
