//! One cell of a grid as cut surfaces, in coordinates (u, height, v) of the cell: u east and v south, 0 to 1 each.

use super::exact::proportional;
use super::grid::{Corners, is_plane, twist};
use imogene_algebra::rational::{integer, to_f64};
use imogene_scene::{Cut, Mesh};
use num_rational::BigRational;

/// What a cell is drawn as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cells {
    /// The bilinear patch of its corners, whatever the eye sees of it.
    Bilinear,
    /// The surface swept by the lines that rest on two opposite edges and on the vertical through the eye, and planes
    /// where a line of sight passes adjacent edges (thesis of Coquillart, section 2.5).
    Ruled,
    /// Facets where the patch is flat to half a pixel, else the bilinear patch.
    Auto,
}

/// A surface of a cell and what bounds it.
#[derive(Clone, Debug)]
pub struct Piece {
    /// Factors of the surface, as in a scene file.
    pub coefficients: [f64; 10],
    /// Planes that leave the piece.
    pub cuts: Vec<Cut>,
}

/// Edges of a cell, in the order of its cuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// u = 0.
    West,
    /// u = 1.
    East,
    /// v = 0.
    North,
    /// v = 1.
    South,
}

impl Edge {
    pub const ALL: [Edge; 4] = [Edge::West, Edge::East, Edge::North, Edge::South];

    /// The vertical plane through the edge, moved outwards by a part of the cell.
    pub fn cut(self, outwards: f64) -> Cut {
        let (point, normal) = match self {
            Edge::West => ([-outwards, 0.0, 0.0], [-1.0, 0.0, 0.0]),
            Edge::East => ([1.0 + outwards, 0.0, 0.0], [1.0, 0.0, 0.0]),
            Edge::North => ([0.0, 0.0, -outwards], [0.0, 0.0, -1.0]),
            Edge::South => ([0.0, 0.0, 1.0 + outwards], [0.0, 0.0, 1.0]),
        };
        Cut { point, normal }
    }
}

/// `height - z00 - a u - c v - e u v = 0`, e zero where the cell is a plane; `None` if the numbers have too many
/// digits for a scene file.
pub fn bilinear(z: &Corners) -> Option<[f64; 10]> {
    let (a, c) = (&z[0][1] - &z[0][0], &z[1][0] - &z[0][0]);
    let constant = integer(-2) * &z[0][0];
    surface(&[-twist(z), -a, integer(1), -c, constant])
}

/// The coefficients of a surface from half the factors of uv, u, height and v, and the constant, all doubled.
pub fn surface([uv, u, height, v, constant]: &[BigRational; 5]) -> Option<[f64; 10]> {
    let [uv, u, height, v, constant] = proportional([uv, u, height, v, constant])?;
    Some([0.0, 0.0, 0.0, 0.0, uv, 0.0, u, height, v, constant])
}

/// The bilinear patch of a cell, its cuts moved outwards by a part of the cell at each edge.
pub fn bilinear_piece(z: &Corners, outwards: [f64; 4]) -> Option<Piece> {
    let cuts = Edge::ALL.into_iter().zip(outwards);
    Some(Piece {
        coefficients: bilinear(z)?,
        cuts: cuts.map(|(edge, by)| edge.cut(by)).collect(),
    })
}

/// The cell as flat facets: one if it is a plane, else two that meet in the diagonal from its north-western corner.
pub fn facets(z: &Corners) -> Mesh {
    let faces = match is_plane(z) {
        true => vec![vec![0, 1, 2, 3]],
        false => vec![vec![0, 1, 2], vec![0, 2, 3]],
    };
    let corner = |(u, v): (usize, usize)| [u as f64, to_f64(&z[v][u]), v as f64];
    Mesh {
        vertices: [(0, 0), (0, 1), (1, 1), (1, 0)].map(corner).to_vec(),
        faces,
        normals: vec![],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_algebra::rational::{fraction, from_decimal};
    use imogene_scene::{Quadric, Shape};
    use num_traits::Zero;

    fn corners() -> Corners {
        let z = [[12.3, -4.75], [100.0, 33.125]];
        z.map(|row| row.map(from_decimal))
    }

    #[test]
    fn the_patch_passes_its_corners_and_its_middle() {
        let z = corners();
        let coefficients = bilinear(&z).unwrap();
        let quadric = Quadric::from_shape(&Shape::Quadric { coefficients }).unwrap();
        for (u, v) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            let at = quadric.value_at(&integer(u), &z[v as usize][u as usize], &integer(v));
            assert!(at.is_zero(), "corner ({u}, {v})");
        }
        let mean = (&z[0][0] + &z[0][1] + &z[1][0] + &z[1][1]) / integer(4);
        let half = fraction(1, 2);
        assert!(quadric.value_at(&half, &mean, &half).is_zero());
        // The ground is below.
        assert!(quadric.value_at(&half, &(mean - integer(1)), &half) < integer(0));
    }

    #[test]
    fn cuts_leave_the_cell_alone() {
        let piece = bilinear_piece(&corners(), [0.0, 0.5, 0.0, 0.0]).unwrap();
        let kept = |u: f64, v: f64| {
            piece.cuts.iter().all(|cut| {
                let from = [u - cut.point[0], 0.0, v - cut.point[2]];
                cut.normal.iter().zip(from).map(|(n, d)| n * d).sum::<f64>() <= 0.0
            })
        };
        assert!(kept(0.0, 0.0) && kept(1.0, 1.0) && kept(1.5, 0.5));
        assert!(!kept(-0.01, 0.5) && !kept(1.6, 0.5) && !kept(0.5, -0.01) && !kept(0.5, 1.01));
    }

    #[test]
    fn facets_look_upwards() {
        for last in [4, 5] {
            let mesh = facets(&[[1, 2], [3, last]].map(|row| row.map(integer)));
            for face in &mesh.faces {
                let [p, q, r] = [0, 1, 2].map(|k| mesh.vertices[face[k]]);
                let (s, t) = ([q[0] - p[0], q[2] - p[2]], [r[0] - p[0], r[2] - p[2]]);
                assert!(s[1] * t[0] - s[0] * t[1] > 0.0);
            }
        }
    }
}
