//! The cut-plane unit: shortens a solid's depth interval, or removes faces of a patch, at one plane
//! (source: 2.4.2, comparisons of B.12).

use super::depth_interval::Interval;
use crate::format::Format;
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// How a plane lies to the viewer; decided once in the preparation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[repr(u8)]
pub enum PlaneKind {
    /// No plane: passes everything.
    #[default]
    None = 0,
    /// Normal towards the viewer: keeps depths at and behind the plane.
    Front = words::FRONT_PLANE as u8,
    /// Normal away from the viewer: keeps depths at and before the plane.
    Back = words::BACK_PLANE as u8,
    /// Plane along the line of sight: keeps the pixel where the plane's value is not negative.
    Perpendicular = words::PERPENDICULAR as u8,
}

impl PlaneKind {
    /// All of them, in the order of their words.
    pub const ALL: [PlaneKind; 4] = [Self::None, Self::Front, Self::Back, Self::Perpendicular];
}

/// The interval that is left after one plane of depth (or value) `zp`, already saturated.
///
/// Ties keep the object: a plane that only touches leaves a zero thickness; a plane at the present front or back
/// changes nothing, and the older face number stays.
#[inline]
pub fn cut(
    interval: Interval,
    kind: PlaneKind,
    zp: i64,
    number: u8,
    patch: bool,
    format: &Format,
) -> Interval {
    let Interval { zf, zb, nf, nb } = interval;
    let (front, back) = ((zf, nf), (zb, nb));
    match kind {
        PlaneKind::Perpendicular if zp < 0 => Interval::absent(format),
        PlaneKind::Front if zp <= zf => interval,
        PlaneKind::Front if zb < zp => Interval::absent(format),
        PlaneKind::Front if patch => Interval::new(back, back),
        PlaneKind::Front => Interval::new((zp, number), back),
        PlaneKind::Back if zb <= zp => interval,
        PlaneKind::Back if zp < zf => Interval::absent(format),
        PlaneKind::Back if patch => Interval::new(front, front),
        PlaneKind::Back => Interval::new(front, (zp, number)),
        _ => interval,
    }
}

/// All orders of n planes.
#[cfg(test)]
pub(super) fn permutations(n: usize) -> Vec<Vec<usize>> {
    if n == 0 {
        return vec![vec![]];
    }
    permutations(n - 1)
        .into_iter()
        .flat_map(|shorter| {
            (0..n).map(move |at| {
                let mut order = shorter.clone();
                order.insert(at, n - 1);
                order
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::choices;

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
}
