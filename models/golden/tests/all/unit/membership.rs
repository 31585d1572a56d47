use crate::common::{choices, planes_at};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::{Class, Interval, halves};
use imogene_golden::unit::membership::{Point, in_half_space, in_quadric};
use imogene_golden::unit::plane_depth::saturate;

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
                        let place = format!("{class:?} {near} {far} {negative} {planes:?} {z}");
                        assert_eq!(ours, theirs, "{place}");
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
