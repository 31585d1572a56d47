use crate::common::{choices, planes_at};
use imogene_golden::format::Format;
use imogene_golden::unit::cut_plane::{PlaneKind, cut};
use imogene_golden::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE, Interval};
use imogene_golden::unit::half_spaces::{close, leaf, tree, tree_levels};

const F: Format = Format::BASE;

fn parallel(planes: &[(PlaneKind, i64)]) -> Interval {
    let leaves = planes.iter().enumerate();
    let leaves = leaves.map(|(i, &(kind, zp))| leaf(kind, zp, i, &F));
    close(tree(leaves.collect()).unwrap(), true, &F)
}

/// The source's chain: the whole line of sight, cut by one plane after the other.
fn chain(planes: &[(PlaneKind, i64)]) -> Interval {
    let line = Interval::new((F.z_low(), FACE_NEAR_END), (F.z_max(), FACE_NEAR_END));
    let numbered = planes.iter().zip(FACE_PLANE..);
    numbered.fold(line, |state, (&(kind, zp), number)| {
        cut(state, kind, zp, number, false, &F)
    })
}

/// One to four planes on all levels around both ends and in between: ties, touching planes, empty intersections,
/// planes at the ends.
#[test]
fn equals_the_chain_of_cut_planes() {
    let levels = [F.plane_low(), F.z_low(), -1, 0, 1, F.z_max() - 1, F.z_max()];
    let mut all = planes_at(&levels);
    all.push((PlaneKind::None, 0));
    let (mut present, mut absent) = (0u32, 0u32);
    for planes in (1..=4).flat_map(|n| choices(&all, n)) {
        let (ours, theirs) = (parallel(&planes), chain(&planes));
        if theirs.is_present(&F) {
            assert_eq!(ours, theirs, "{planes:?}");
            present += 1;
        } else {
            assert_eq!(ours, Interval::absent(&F), "{planes:?}");
            absent += 1;
        }
    }
    assert_eq!(present + absent, 17 + 17 * 17 + 4_913 + 83_521);
    assert!(present > 20_000 && absent > 20_000, "{present} {absent}");
}

#[test]
fn a_pixel_outside_the_box_is_absent() {
    let alone = leaf(PlaneKind::Front, 5, 0, &F);
    assert!(close(alone, true, &F).is_present(&F));
    assert_eq!(close(alone, false, &F), Interval::absent(&F));
}

#[test]
fn the_tree_has_the_levels_it_claims() {
    let levels: Vec<u32> = (1..=12).map(tree_levels).collect();
    assert_eq!(levels, [0, 1, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4]);
    assert_eq!(tree(vec![]), None);
}
