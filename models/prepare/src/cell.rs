//! Axis-parallel cells of screen space.

/// An axis-parallel cell: centre and half extent along x, y, z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Centre.
    pub centre: [f64; 3],
    /// Half extent.
    pub half: [f64; 3],
}

impl Cell {
    /// The cell between two corners.
    pub fn between(low: [f64; 3], high: [f64; 3]) -> Cell {
        Cell {
            centre: std::array::from_fn(|k| 0.5 * (low[k] + high[k])),
            half: std::array::from_fn(|k| 0.5 * (high[k] - low[k])),
        }
    }

    /// Its extent along each axis, in units of that axis.
    pub(super) fn relative_size(&self, units: &[f64; 3]) -> impl Iterator<Item = f64> {
        std::array::from_fn::<f64, 3, _>(|k| 2.0 * self.half[k] / units[k]).into_iter()
    }

    /// Does it hold a point, not nearer to a side than the rounding of a few halvings.
    pub(super) fn holds(&self, point: &[f64; 3]) -> bool {
        (0..3).all(|k| (point[k] - self.centre[k]).abs() < self.half[k] * (1.0 - 1e-9))
    }

    pub(super) fn meets(&self, other: &Cell) -> bool {
        (0..3).all(|k| (self.centre[k] - other.centre[k]).abs() <= self.half[k] + other.half[k])
    }

    pub(super) fn is_within(&self, other: &Cell) -> bool {
        (0..3).all(|k| (self.centre[k] - other.centre[k]).abs() + self.half[k] < other.half[k])
    }

    /// Halves along the axis on which it is widest in these units.
    pub(super) fn halves(&self, units: &[f64; 3]) -> [Cell; 2] {
        let (axis, _) = self
            .relative_size(units)
            .enumerate()
            .max_by(|(_, a), (_, b)| a.total_cmp(b))
            .expect("three axes");
        [-0.5, 0.5].map(|side| {
            let mut cell = *self;
            cell.half[axis] *= 0.5;
            cell.centre[axis] += side * self.half[axis];
            cell
        })
    }
}
