//! A grid of heights.

use num_rational::BigRational;
use num_traits::Zero;

/// Most nodes of a grid that is read.
pub const MAX_NODES: usize = 1 << 21;

/// Heights at the nodes of a grid, in exact decimals; columns run east, rows south.
#[derive(Clone, Debug, PartialEq)]
pub struct HeightGrid {
    /// Nodes of a row, at least 2.
    pub columns: usize,
    /// Rows, at least 2; the first is the northern one.
    pub rows: usize,
    /// Distance of two nodes eastwards and southwards, in units of the file.
    pub step: [f64; 2],
    /// Row by row; nothing where the file has no data.
    pub heights: Vec<Option<f64>>,
}

impl HeightGrid {
    /// The height of a node, if there is one.
    pub fn height(&self, column: usize, row: usize) -> Option<f64> {
        self.heights[row * self.columns + column]
    }

    /// Least and greatest height; `None` if no node has one.
    pub fn range(&self) -> Option<(f64, f64)> {
        let known = || self.heights.iter().flatten().copied();
        Some((known().reduce(f64::min)?, known().reduce(f64::max)?))
    }

    /// Nodes `first`, `first + every`, .. of a region of `nodes` nodes of this grid, which lies within it.
    pub fn part(&self, first: [usize; 2], nodes: [usize; 2], every: usize) -> HeightGrid {
        let kept = |axis: usize| (first[axis]..first[axis] + nodes[axis]).step_by(every);
        let heights = kept(1).flat_map(|row| kept(0).map(move |column| self.height(column, row)));
        HeightGrid {
            columns: kept(0).count(),
            rows: kept(1).count(),
            step: self.step.map(|step| step * every as f64),
            heights: heights.collect(),
        }
    }
}

/// Corner heights of a cell: `[v][u]`, u east and v south, 0 or 1 each.
pub type Corners = [[BigRational; 2]; 2];

/// `z00 + z11 - z10 - z01`, the factor of uv: how much the cell is twisted.
pub fn twist(z: &Corners) -> BigRational {
    &z[0][0] + &z[1][1] - &z[0][1] - &z[1][0]
}

pub fn is_plane(z: &Corners) -> bool {
    twist(z).is_zero()
}
