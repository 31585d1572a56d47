//! The ruled form of a cell, which depends on the eye: C8 of the source's systems (thesis of Coquillart, section 2.5,
//! its implicit form derived).
//!
//! Seen from above, the lines of sight through the corners divide the cell into up to three sectors. In the middle one
//! they pass opposite edges; lines that rest on both and on the vertical through the eye sweep the surface, so that the
//! eye lies on it. In the outer ones they pass adjacent edges, and the surface is their plane.

use super::cell::{Corner, Edge, Piece, bilinear_piece, surface};
use super::exact::proportional;
use super::grid::{Corners, is_plane, twist};
use imogene_algebra::matrix::transposed;
use imogene_algebra::rational::{fraction, integer};
use imogene_scene::Cut;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A place by its u and v: from 0 to 1 within the cell.
pub type Point = [BigRational; 2];

/// The pieces of a cell as an eye at (u, v) sees it, moved outwards as `bilinear_piece` is; the bilinear patch for a
/// plane or below the eye; `None` if the numbers have too many digits for a scene file.
pub fn ruled_pieces(z: &Corners, eye: &Point, outwards: [f64; 4]) -> Option<Vec<Piece>> {
    if is_plane(z) || eye.iter().all(|e| *e >= integer(0) && *e <= integer(1)) {
        return Some(vec![bilinear_piece(z, outwards)?]);
    }
    // The corners (u, v) as their lines of sight turn, by less than half a circle: the eye is outside of a convex cell.
    let mut order = [[0, 0], [1, 0], [1, 1], [0, 1]];
    order.sort_by(|p, q| integer(0).cmp(&turn(eye, &at(*p), &at(*q))));
    let sectors = order.windows(2).filter_map(|pair| {
        let bounds = [pair[0], pair[1]];
        Some(piece(z, eye, bounds, passed(eye, bounds)?, outwards))
    });
    sectors.collect()
}

fn at(corner: Corner) -> Point {
    corner.map(|end| integer(end as i64))
}

/// Positive if the line of sight turns from p towards q in the sense from u to v.
fn turn(eye: &Point, p: &Point, q: &Point) -> BigRational {
    let from = |k: usize, r: &Point| &r[k] - &eye[k];
    from(0, p) * from(1, q) - from(1, p) * from(0, q)
}

/// The edges that lines of sight between two corners pass; `None` if the corners are in one line of sight.
fn passed(eye: &Point, [p, q]: [Corner; 2]) -> Option<[Edge; 2]> {
    let (p, q) = (at(p), at(q));
    if turn(eye, &p, &q).is_zero() {
        return None;
    }
    let between: Point = std::array::from_fn(|k| (&p[k] + &q[k]) / integer(2));
    let is_passed = |edge: &Edge| {
        let [a, b] = edge.corners().map(|end| turn(eye, &between, &at(end)));
        a.is_negative() != b.is_negative() && !a.is_zero() && !b.is_zero()
    };
    let edges: Vec<Edge> = Edge::ALL.into_iter().filter(is_passed).collect();
    edges.try_into().ok()
}

/// The piece of a sector: between the lines of sight through two corners, that pass two edges.
fn piece(
    z: &Corners,
    eye: &Point,
    bounds: [Corner; 2],
    edges: [Edge; 2],
    outwards: [f64; 4],
) -> Option<Piece> {
    // Two adjacent edges, that of constant u first, have a corner in common; opposite ones have none.
    let common = (edges[0].axis != edges[1].axis).then(|| edges.map(|edge| edge.end));
    let coefficients = match (common, edges[0].axis) {
        (Some(corner), _) => plane(z, corner)?,
        (None, 0) => ruled_between_sides(z, eye)?,
        (None, _) => ruled(z, eye)?,
    };
    let cut = |edge: Edge| edge.cut(outwards[edge.index()]);
    let mut cuts = edges.map(cut).to_vec();
    for (index, corner) in bounds.into_iter().enumerate() {
        // The line of sight through the common corner only touches the piece.
        if Some(corner) != common {
            cuts.push(sector_cut(eye, corner, index == 0)?);
        }
    }
    Some((coefficients, cuts))
}

/// The vertical plane through the eye and a corner; it removes what is before it in the order of corners, or behind.
fn sector_cut(eye: &Point, corner: Corner, before: bool) -> Option<Cut> {
    let [u, v] = at(corner);
    let (du, dv) = (u - &eye[0], v - &eye[1]);
    // turn(corner, p) = du (p_v - e_v) - dv (p_u - e_u), positive behind.
    let (nu, nv) = if before { (dv, -du) } else { (-dv, du) };
    let [nu, nv] = proportional([&nu, &nv])?;
    Some(Cut {
        point: [corner[0] as f64, 0.0, corner[1] as f64],
        normal: [nu, 0.0, nv],
    })
}

fn plane(z: &Corners, [u, v]: Corner) -> Option<[f64; 10]> {
    // Slopes along the edge of constant v and along the edge of constant u.
    let (along_u, along_v) = (&z[v][1] - &z[v][0], &z[1][u] - &z[0][u]);
    let height = &z[v][u] - &along_u * integer(u as i64) - &along_v * integer(v as i64);
    let zero = integer(0);
    surface(&[zero, -along_u, integer(1), -along_v, integer(-2) * height])
}

/// On the northern and the southern edge, y = 0 and y = 1: with z as height,
/// `[b + ye (a - b)] xy - ye a x + [xe (b - a) + c] y^2 - y z + [xe (a - b) - ye c + z00] y + ye z - ye z00`. The
/// factor `ye - y` of the height is made positive over the cell, so that the ground is below as in other forms.
fn ruled(z: &Corners, [xe, ye]: &Point) -> Option<[f64; 10]> {
    debug_assert!(!twist(z).is_zero());
    let low = &z[0][0];
    let (a, b, c) = (&z[0][1] - low, &z[1][1] - &z[1][0], &z[1][0] - low);
    let less = &a - &b;
    let sign = if ye.is_positive() { 1 } else { -1 };
    let (uv, v) = (&b + ye * &less, xe * &less - ye * &c + low);
    let halves = [uv, integer(-1), -(ye * &a), ye.clone(), v].map(|f| f * fraction(sign, 2));
    let [vv, one] = [&c - xe * &less, -(ye * low)].map(|f| f * integer(sign));
    let [uv, vz, u, height, v] = &halves;
    let [vv, uv, vz, u, height, v, one] = proportional([&vv, uv, vz, u, height, v, &one])?;
    Some([0.0, 0.0, vv, 0.0, uv, vz, u, height, v, one])
}

/// On the western and the eastern edge: the same with u and v exchanged.
fn ruled_between_sides(z: &Corners, [xe, ye]: &Point) -> Option<[f64; 10]> {
    let [a, b, c, d, e, f, g, h, i, j] = ruled(&transposed(z), &[ye.clone(), xe.clone()])?;
    Some([c, b, a, f, e, d, i, h, g, j])
}
