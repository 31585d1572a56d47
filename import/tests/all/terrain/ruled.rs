use imogene_algebra::rational::{fraction, from_decimal, integer};
use imogene_import::terrain::ruled::{Point, ruled_pieces};
use imogene_import::terrain::{Corners, Piece, twist};
use imogene_scene::{Quadric, Shape};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use proptest::prelude::*;

fn quadric((coefficients, _): &Piece) -> Quadric {
    let coefficients = *coefficients;
    Quadric::from_shape(&Shape::Quadric { coefficients }).unwrap()
}

fn keeps((_, cuts): &Piece, [u, v]: &Point) -> bool {
    cuts.iter().all(|cut| {
        let [pu, _, pv] = cut.point.map(from_decimal);
        let [nu, _, nv] = cut.normal.map(from_decimal);
        !(nu * (u - pu) + nv * (v - pv)).is_positive()
    })
}

/// The height over a point of the cell where the line of sight to it enters and leaves the cell, interpolated along
/// it: the source's definition.
fn height(z: &Corners, eye: &Point, point: &Point) -> Option<BigRational> {
    let mut crossed: Vec<(BigRational, BigRational)> = vec![];
    for (axis, end) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
        let along = &point[axis] - &eye[axis];
        if along.is_zero() {
            continue;
        }
        let t = (integer(end) - &eye[axis]) / along;
        let other = &eye[1 - axis] + &t * (&point[1 - axis] - &eye[1 - axis]);
        if other.is_negative() || other > integer(1) {
            continue;
        }
        let corner = |k: usize| match axis {
            0 => &z[k][end as usize],
            _ => &z[end as usize][k],
        };
        let level = corner(0) + (corner(1) - corner(0)) * &other;
        crossed.push((t, level));
    }
    crossed.sort();
    crossed.dedup();
    let [(t0, h0), (t1, h1)] = <[_; 2]>::try_from(crossed).ok()?;
    Some(&h0 + (h1 - &h0) * (integer(1) - &t0) / (t1 - t0))
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Every point of the cell belongs to a piece, whose surface has there the height of the straight line between
    /// the two edges, and the pieces agree where they meet. The ruled one holds every point of the vertical through
    /// the eye.
    #[test]
    fn pieces_are_the_surface_of_the_source(
        heights in [-50i64..50, -50..50, -50..50, -50..50], eye in [-30i64..30, -30..30], places in proptest::collection::vec([-9i64..=21, -9..=21], 24)
    ) {
        let [a, b, c, d] = heights.map(|h| fraction(h, 4));
        let z = [[a, b], [c, d]];
        let eye = eye.map(|e| fraction(e, 6));
        prop_assume!(!twist(&z).is_zero());
        prop_assume!(eye.iter().any(|e| e.is_negative() || *e > integer(1)));
        let pieces = ruled_pieces(&z, &eye, [0.0; 4]).expect("few digits");
        prop_assert!(!pieces.is_empty() && pieces.len() <= 3);
        for piece in pieces.iter().filter(|(c, _)| [0, 2, 3, 5].iter().any(|k| c[*k] != 0.0)) {
            for level in [-3, 0, 1000] {
                prop_assert!(quadric(piece).value_at(&eye[0], &integer(level), &eye[1]).is_zero());
            }
        }
        for place in places {
            let point = place.map(|p| fraction(p, 12));
            let there: Vec<&Piece> = pieces.iter().filter(|p| keeps(p, &point)).collect();
            let inside = point.iter().all(|p| !p.is_negative() && *p <= integer(1));
            prop_assert_eq!(inside, !there.is_empty(), "{:?} of an eye at {:?}", place, &eye);
            if !inside {
                continue;
            }
            let Some(level) = height(&z, &eye, &point) else { continue };
            for piece in there {
                prop_assert!(quadric(piece).value_at(&point[0], &level, &point[1]).is_zero());
                let below = quadric(piece).value_at(&point[0], &(&level - integer(1)), &point[1]);
                prop_assert!(below.is_negative());
            }
        }
    }

    /// Along a line of sight the bilinear patch is at most |e| / 4 away.
    #[test]
    fn the_bilinear_patch_is_near(
        heights in [-50i64..50, -50..50, -50..50, -50..50], eye in [-30i64..30, -30..30], place in [0i64..=12, 0..=12]
    ) {
        let [a, b, c, d] = heights.map(integer);
        let z = [[a, b], [c, d]];
        let (eye, [u, v]) = (eye.map(|e| fraction(e, 6)), place.map(|p| fraction(p, 12)));
        prop_assume!(eye.iter().any(|e| e.is_negative() || *e > integer(1)));
        let e = twist(&z);
        let patch = &z[0][0] + (&z[0][1] - &z[0][0]) * &u + (&z[1][0] - &z[0][0]) * &v + &e * &u * &v;
        if let Some(level) = height(&z, &eye, &[u, v]) {
            prop_assert!((level - patch).abs() <= e.abs() / integer(4));
        }
    }
}
