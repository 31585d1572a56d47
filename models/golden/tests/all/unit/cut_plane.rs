use crate::common::*;
use imogene_golden::unit::cut_plane::cut;

const F: Format = Format::BASE;

fn solid(zf: i64, zb: i64) -> Interval {
    Interval::new((zf, 0), (zb, 1))
}

#[test]
fn ties_keep_the_object_and_its_older_face() {
    let start = solid(10, 20);
    assert_eq!(cut(start, PlaneKind::Front, 10, 2, false, &F), start);
    assert_eq!(cut(start, PlaneKind::Back, 20, 2, false, &F), start);
    let touched = cut(start, PlaneKind::Front, 20, 2, false, &F);
    assert_eq!((touched.zf, touched.zb, touched.nf), (20, 20, 2));
    assert!(!cut(start, PlaneKind::Back, 9, 2, false, &F).is_present(&F));
    assert!(cut(start, PlaneKind::Perpendicular, 0, 2, false, &F).is_present(&F));
    assert!(!cut(start, PlaneKind::Perpendicular, -1, 2, false, &F).is_present(&F));
}

#[test]
fn a_patch_loses_whole_faces() {
    let start = solid(10, 20);
    let back = cut(start, PlaneKind::Front, 15, 2, true, &F);
    assert_eq!((back.zf, back.zb, back.nf, back.nb), (20, 20, 1, 1));
    let front = cut(start, PlaneKind::Back, 15, 2, true, &F);
    assert_eq!((front.zf, front.zb, front.nf, front.nb), (10, 10, 0, 0));
}

#[test]
fn absent_stays_absent() {
    for kind in PlaneKind::ALL {
        for zp in [F.plane_low(), -1, 0, 1, F.z_max()] {
            for patch in [false, true] {
                let out = cut(Interval::absent(&F), kind, zp, 5, patch, &F);
                assert_eq!((out.zf, out.zb), (F.z_max(), F.z_max()));
            }
        }
    }
}

/// Depths never depend on the order of the planes: every type, level and permutation of three planes on small
/// levels.
#[test]
fn depths_do_not_depend_on_plane_order() {
    let at = |kind: &PlaneKind| (-1..=3).map(|zp| (*kind, zp)).collect::<Vec<_>>();
    let all: Vec<(PlaneKind, i64)> = PlaneKind::ALL[1..].iter().flat_map(at).collect();
    let orders = permutations(3);
    let mut configurations = 0u64;
    for planes in choices(&all, 3) {
        for (zf, zb) in [(0, 0), (0, 1), (0, 2), (1, 3), (-1, 3)] {
            for patch in [false, true] {
                let run = |order: &Vec<usize>| {
                    let mut s = solid(zf, zb);
                    for &i in order {
                        s = cut(s, planes[i].0, planes[i].1, 2 + i as u8, patch, &F);
                    }
                    (s.zf, s.zb)
                };
                let first = run(&orders[0]);
                assert!(orders.iter().all(|o| run(o) == first));
                configurations += 1;
            }
        }
    }
    assert_eq!(configurations, 33_750);
}
