//! The decider of a patch: the first face that every plane keeps, all planes at once (source: 2.4.3).
//!
//! A plane keeps or removes each of the two faces without looking at the other face or at another plane, so two bits of
//! each plane and two wide ANDs stand in the place of the chain of [`super::cut_plane`].

use super::cut_plane::PlaneKind;
use super::depth_interval::{FACE_FAR, FACE_NEAR, Interval};
use crate::format::Format;

/// For each of the two faces: is it there, or does a plane keep it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Faces {
    /// The front face, at the near root: the source's signal E_F.
    pub front: bool,
    /// The back face, at the far root: the source's signal E_B.
    pub back: bool,
}

impl Faces {
    /// The faces that are there.
    #[inline]
    pub const fn new(front: bool, back: bool) -> Faces {
        Faces { front, back }
    }

    /// Both faces.
    pub const BOTH: Faces = Faces::new(true, true);

    /// The faces that are in both sets.
    #[inline]
    pub const fn and(self, other: Faces) -> Faces {
        Faces::new(self.front && other.front, self.back && other.back)
    }
}

/// The faces at `near = f1 - r` and `far = f1 + r` (sum words) that exist between the near and the far end; `there` is
/// false outside the screen box and where f2 is negative.
///
/// The two ends are planes of constant depth, so this is formed beside the signals of the planes and not before them.
#[inline]
pub const fn visible(near: i64, far: i64, there: bool, format: &Format) -> Faces {
    let (low, end) = (format.z_low(), format.z_max());
    Faces::new(
        there && low <= near && near < end,
        there && low <= far && far < end,
    )
}

/// The two signals of one plane of saturated depth (or value) `zp`. Closed: a face in the plane is kept.
#[inline]
pub const fn kept(kind: PlaneKind, zp: i64, near: i64, far: i64) -> Faces {
    match kind {
        PlaneKind::None => Faces::BOTH,
        PlaneKind::Front => Faces::new(near >= zp, far >= zp),
        PlaneKind::Back => Faces::new(near <= zp, far <= zp),
        PlaneKind::Perpendicular => Faces::new(zp >= 0, zp >= 0),
    }
}

/// What is left of the two faces: both, one of them (then it is front and back at once) or nothing.
#[inline]
pub const fn decide(near: i64, far: i64, left: Faces, format: &Format) -> Interval {
    let (one, two) = ((near, FACE_NEAR), (far, FACE_FAR));
    match (left.front, left.back) {
        (true, true) => Interval::new(one, two),
        (true, false) => Interval::new(one, one),
        (false, true) => Interval::new(two, two),
        (false, false) => Interval::absent(format),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{choices, planes_at};
    use crate::unit::cut_plane::{cut, permutations};
    use crate::unit::depth_interval::{Class, halves};

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
}
