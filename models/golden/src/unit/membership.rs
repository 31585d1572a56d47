//! Is a point of the line of sight inside a volume: the test of shadow and light volumes (source: 3.2.1, 4.1.3).
//!
//! The source cuts the volume's depth interval and compares the point with what is left. A point is in an intersection
//! exactly if it is in every part, so each part is asked by itself: one comparison of each plane, and neither a chain
//! nor a second half.

use super::cut_plane::PlaneKind;
use super::depth_interval::Class;
use crate::format::Format;

/// The depth in question.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    /// Visible depth.
    pub z: i64,
    /// The depth less the margin, `S` bits: what has to lie at or behind a face where the volume begins.
    pub entered: i64,
}

impl Point {
    /// The point at the visible depth `z`. With margin 0 the test is closed; a margin m >= 1 asks for m counts behind
    /// the beginning, so that a surface does not shadow itself. The end of a volume is closed.
    #[inline]
    pub const fn new(z: i64, margin: u32) -> Point {
        Point {
            z,
            entered: z - margin as i64,
        }
    }

    /// The point in units of `2^shift`, downwards: `near 2^shift <= entered` exactly if `near` is not above the coarse
    /// one.
    #[inline]
    pub const fn coarse(&self, shift: u8) -> Point {
        Point {
            z: self.z >> shift,
            entered: self.entered >> shift,
        }
    }

    /// False for the background, which is in no volume.
    #[inline]
    pub const fn is_surface(&self, format: &Format) -> bool {
        self.z < format.z_max()
    }
}

/// Is the point inside the unbounded quadric with the sums `near = f1 - r` and `far = f1 + r`; `negative` is `f2 < 0`.
///
/// A patch has no inside.
#[inline]
pub const fn in_quadric(class: Class, near: i64, far: i64, negative: bool, point: Point) -> bool {
    match class {
        Class::Side => !negative && near <= point.entered && point.z <= far,
        Class::Front => negative || point.z <= near || far <= point.entered,
        Class::Prism => !negative,
        Class::Patch => false,
    }
}

/// Is the point on the kept side of a plane of depth (or value) `zp`, all P bits of it: no saturation is needed.
#[inline]
pub const fn in_half_space(kind: PlaneKind, zp: i64, point: Point) -> bool {
    match kind {
        PlaneKind::None => true,
        PlaneKind::Front => zp <= point.entered,
        PlaneKind::Back => point.z <= zp,
        PlaneKind::Perpendicular => zp >= 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::{choices, planes_at};
    use crate::unit::cut_plane::cut;
    use crate::unit::depth_interval::{Interval, halves};
    use crate::unit::plane_depth::saturate;

    const F: Format = Format::BASE;

    /// The source's way: cut both halves, then compare.
    fn by_cutting(
        class: Class,
        near: i64,
        far: i64,
        negative: bool,
        planes: &[(PlaneKind, i64)],
        z: i64,
    ) -> bool {
        let (a, b) = halves(class, near, far, negative, &F);
        let holds = |half: Interval| {
            let left = planes.iter().fold(half, |state, &(kind, zp)| {
                cut(state, kind, saturate(zp, &F), 2, false, &F)
            });
            left.is_present(&F) && left.zf <= z && z <= left.zb
        };
        holds(a) || holds(b)
    }

    /// Every class, roots and two planes of every kind on levels around both ends and beyond, every visible point on
    /// them.
    #[test]
    fn closed_test_equals_the_cut_interval() {
        let (low, end) = (F.z_low(), F.z_max());
        let at = |end: i64, steps: &[i64]| -> Vec<i64> { steps.iter().map(|s| end + s).collect() };
        let levels = [
            at(low, &[-9, -1, 0, 1]),
            at(0, &[0, 1, 2]),
            at(end, &[-1, 0, 9]),
        ]
        .concat();
        let visible = levels.iter().filter(|z| (low..end).contains(*z));
        let points: Vec<i64> = visible.copied().collect();
        let mut planes = planes_at(&levels);
        planes.push((PlaneKind::None, 0));
        let pairs: Vec<Vec<(PlaneKind, i64)>> = choices(&planes, 2).collect();
        let mut inside = 0;
        for class in Class::ALL {
            for (i, &near) in levels.iter().enumerate() {
                for &far in &levels[i..] {
                    for (planes, negative) in pairs.iter().flat_map(|p| [(p, false), (p, true)]) {
                        for &z in &points {
                            let point = Point::new(z, 0);
                            let ours = in_quadric(class, near, far, negative, point)
                                && planes
                                    .iter()
                                    .all(|&(kind, zp)| in_half_space(kind, zp, point));
                            let theirs = class != Class::Patch
                                && by_cutting(class, near, far, negative, planes, z);
                            assert_eq!(
                                ours, theirs,
                                "{class:?} {near} {far} {negative} {planes:?} {z}"
                            );
                            inside += u32::from(ours);
                        }
                    }
                }
            }
        }
        assert!(inside > 50_000, "{inside}");
    }

    #[test]
    fn the_margin_keeps_a_surface_out_of_the_volume_that_begins_at_it() {
        let at = |z, margin| in_half_space(PlaneKind::Front, 100, Point::new(z, margin));
        assert!(at(100, 0) && !at(100, 1) && at(101, 1) && !at(101, 2));
        // The end stays closed, whatever the margin.
        assert!(in_half_space(PlaneKind::Back, 100, Point::new(100, 7)));
        assert!(!in_half_space(PlaneKind::Back, 100, Point::new(101, 7)));
        assert!(!Point::new(F.z_max(), 0).is_surface(&F));
    }
}
