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

/// A surface by its factors, as in a scene file, and its cuts.
pub type Piece = ([f64; 10], Vec<Cut>);

/// An edge of a cell: where u (axis 0) or v (axis 1) is 0 or 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    pub axis: usize,
    pub end: usize,
}

/// A corner: u and v, 0 or 1 each.
pub type Corner = [usize; 2];

impl Edge {
    /// West, east, north and south, the order of the cuts of a cell.
    pub const ALL: [Edge; 4] = [
        Edge { axis: 0, end: 0 },
        Edge { axis: 0, end: 1 },
        Edge { axis: 1, end: 0 },
        Edge { axis: 1, end: 1 },
    ];

    /// Its place in [`Edge::ALL`].
    pub fn index(self) -> usize {
        2 * self.axis + self.end
    }

    pub fn corners(self) -> [Corner; 2] {
        [0, 1].map(|other| match self.axis {
            0 => [self.end, other],
            _ => [other, self.end],
        })
    }

    /// The vertical plane through the edge, moved outwards by a part of the cell.
    pub fn cut(self, outwards: f64) -> Cut {
        let (mut point, mut normal) = ([0.0; 3], [0.0; 3]);
        (point[2 * self.axis], normal[2 * self.axis]) = match self.end {
            0 => (-outwards, -1.0),
            _ => (1.0 + outwards, 1.0),
        };
        Cut { point, normal }
    }
}

/// `height - z00 - a u - c v - e u v = 0`, e 0 for a plane; `None` if a scene file has too few digits for it.
pub fn bilinear(z: &Corners) -> Option<[f64; 10]> {
    let (a, c) = (&z[0][1] - &z[0][0], &z[1][0] - &z[0][0]);
    surface(&[-twist(z), -a, integer(1), -c, integer(-2) * &z[0][0]])
}

/// The coefficients of a surface from half the factors of uv, u, height and v, and the constant, all doubled.
pub fn surface([uv, u, height, v, constant]: &[BigRational; 5]) -> Option<[f64; 10]> {
    let [uv, u, height, v, constant] = proportional([uv, u, height, v, constant])?;
    Some([0.0, 0.0, 0.0, 0.0, uv, 0.0, u, height, v, constant])
}

/// The bilinear patch of a cell, its cuts moved outwards by a part of the cell at each edge.
pub fn bilinear_piece(z: &Corners, outwards: [f64; 4]) -> Option<Piece> {
    let edges = Edge::ALL.into_iter().zip(outwards);
    Some((bilinear(z)?, edges.map(|(edge, by)| edge.cut(by)).collect()))
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
