//! The screen box of an object: the pixels at which the cut quadric can be met, found by branch and bound in screen
//! space.
//!
//! A box is a correctness matter, not only a saving: outside it f2 may wrap. It is conservative (interval bounds with
//! a margin for floating-point rounding) and tight to a fraction of a pixel as long as the node budget lasts; if it
//! runs out the box is only larger.

use super::cell::Cell;
use super::enclosure::{REACH, around};
use super::forms::unreduced;
use imogene_algebra::rational::to_f64;
use imogene_algebra::whole::{common_denominator, greatest};
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{Plane, Quadric, Surface};
use num_rational::BigRational;
use num_traits::Zero;
use std::cmp::Ordering;
use std::collections::BinaryHeap;

/// How far a search goes before it settles for a larger box.
#[derive(Clone, Copy, Debug)]
pub struct Search {
    /// Cells no larger than this (pixels) are not split any more.
    pub resolution: f64,
    /// Cells examined per side of the box.
    pub budget: usize,
}

impl Search {
    /// Tight to a fraction of a pixel: objects, whose boxes the hardware scans.
    pub const FINE: Search = Search {
        resolution: 0.2,
        budget: 20_000,
    };
    /// Tight to some pixels, in a fraction of the time: volumes, of which there are many.
    pub const COARSE: Search = Search {
        resolution: 2.0,
        budget: 400,
    };
}

/// Relative margin for the rounding of the interval evaluation.
const MARGIN: f64 = 1e-11;

/// A cut quadric in floating point, for conservative tests of axis-parallel cells.
#[derive(Clone, Debug)]
pub struct Region {
    quadric: [f64; 10],
    planes: Vec<[f64; 4]>,
    surface: Surface,
    /// A cell that holds all of it, but for what is so far from the screen that `f64` is not exact enough, if one was
    /// found.
    pub enclosure: Option<Cell>,
}

impl Region {
    /// A region from exact coefficients; `planes` are kept where they are not positive.
    pub fn new(quadric: &Quadric, planes: &[Plane], surface: Surface) -> Region {
        let mut region = Region::unenclosed(quadric, planes, surface);
        region.enclosure = around(&region.quadric, &region.planes);
        region
    }

    /// A region that is searched wherever it is asked for.
    pub fn unenclosed(quadric: &Quadric, planes: &[Plane], surface: Surface) -> Region {
        Region {
            quadric: normalised(quadric.coefficients()),
            planes: planes
                .iter()
                .map(|plane| normalised(plane.coefficients()))
                .collect(),
            surface,
            enclosure: None,
        }
    }

    /// False only if no point of the region lies in the cell.
    fn may_meet(&self, cell: &Cell) -> bool {
        if let Some(around) = &self.enclosure
            && (0..3).all(|k| cell.centre[k].abs() + cell.half[k] <= REACH[k])
        {
            if !around.meets(cell) {
                return false;
            }
            // Halves of a cell so large are asked again.
            if around.is_within(cell) {
                return true;
            }
        }
        // Planes first: they are tested in a third of the time.
        if !self.planes.iter().all(|p| plane_low(p, cell) <= 0.0) {
            return false;
        }
        let (low, high) = self.quadric_range(cell);
        match self.surface {
            Surface::Solid => low <= 0.0,
            Surface::Patch => low <= 0.0 && high >= 0.0,
        }
    }

    fn quadric_range(&self, cell: &Cell) -> (f64, f64) {
        let [a, b, c, d, e, f, g, h, i, j] = self.quadric;
        let ([x, y, z], [hx, hy, hz]) = (cell.centre, cell.half);
        let gx = a * x + d * y + e * z + g;
        let gy = d * x + b * y + f * z + h;
        let gz = e * x + f * y + c * z + i;
        let value = (gx + g) * x + (gy + h) * y + (gz + i) * z + j;
        let first = 2.0 * (gx.abs() * hx + gy.abs() * hy + gz.abs() * hz);
        let cross = 2.0 * (d.abs() * hx * hy + e.abs() * hx * hz + f.abs() * hy * hz);
        let squares = [a * hx * hx, b * hy * hy, c * hz * hz];
        let up: f64 = squares.iter().map(|s| s.max(0.0)).sum();
        let down: f64 = squares.iter().map(|s| s.min(0.0)).sum();
        let (ex, ey, ez) = (x.abs() + hx, y.abs() + hy, z.abs() + hz);
        let size = (a * ex * ex).abs()
            + (b * ey * ey).abs()
            + (c * ez * ez).abs()
            + 2.0 * ((d * ex * ey).abs() + (e * ex * ez).abs() + (f * ey * ez).abs())
            + 2.0 * ((g * ex).abs() + (h * ey).abs() + (i * ez).abs())
            + j.abs();
        let margin = MARGIN * size;
        (
            value - first - cross + down - margin,
            value + first + cross + up + margin,
        )
    }

    /// True if a point surely lies in the region of a solid, so that no search in a cell around it can find the cell
    /// empty.
    pub(super) fn holds(&self, point: [f64; 3]) -> bool {
        let cell = Cell {
            centre: point,
            half: [0.0; 3],
        };
        let kept = |plane: &[f64; 4]| plane_low(&plane.map(|v| -v), &cell) >= 0.0;
        self.surface == Surface::Solid
            && self.planes.iter().all(kept)
            && self.quadric_range(&cell).1 <= 0.0
    }

    /// Searches the cell for a point of the region, down to cells of `resolution` along each axis. False only if it is
    /// proven that no point lies there: a small cell may not be excluded, or the budget run out.
    pub fn may_be_in(&self, cell: Cell, resolution: [f64; 3]) -> bool {
        let mut open = vec![cell];
        for _ in 0..Search::FINE.budget {
            let Some(cell) = open.pop() else {
                return false;
            };
            if self.may_meet(&cell) {
                if cell.relative_size(&resolution).all(|size| size <= 1.0) {
                    return true;
                }
                open.extend(cell.halves(&resolution));
            }
        }
        true
    }

    /// The least value of `direction * coordinate[axis]` at which the region can be met, or `None` if it is empty.
    fn extreme(&self, domain: Cell, axis: usize, direction: f64, search: Search) -> Option<f64> {
        let key = |cell: &Cell| direction * cell.centre[axis] - cell.half[axis];
        let mut open = BinaryHeap::new();
        open.push(Entry {
            key: key(&domain),
            cell: domain,
        });
        for _ in 0..search.budget {
            let Entry { key: bound, cell } = open.pop()?;
            if !self.may_meet(&cell) {
                continue;
            }
            if cell.half.iter().all(|&h| 2.0 * h <= search.resolution) {
                return Some(bound);
            }
            for half in cell.halves(&[1.0; 3]) {
                open.push(Entry {
                    key: key(&half),
                    cell: half,
                });
            }
        }
        // The head of the queue bounds everything still open.
        open.pop().map(|entry| entry.key)
    }

    /// Least and greatest coordinate at which the region can be met in the domain, if it can be met at all: along axis
    /// 0 columns, 1 lines, 2 depths.
    pub fn range_within(&self, domain: Cell, axis: usize, search: Search) -> Option<(f64, f64)> {
        let low = self.extreme(domain, axis, 1.0, search)?;
        let high = self.extreme(domain, axis, -1.0, search)?;
        Some((low, -high))
    }

    /// The box of the pixels (column, line; the screen's first pixel at `-centre`) at which the region can be met for
    /// a depth within `-depth .. depth`, on a screen of `width` x `height` pixels.
    pub fn screen_box(&self, width: u32, height: u32, depth: f64) -> ScreenBox {
        let domain = screen_between(width, height, [-depth, depth]);
        self.box_within(domain, width, height, Search::FINE)
    }

    /// The box of the pixels at which the region can be met in the domain, a part of that screen's.
    pub fn box_within(&self, domain: Cell, width: u32, height: u32, search: Search) -> ScreenBox {
        let (w, h) = (f64::from(width), f64::from(height));
        let (left, top) = (-0.5 * w, -0.5 * h);
        let side = |axis, direction| self.extreme(domain, axis, direction, search);
        // Where nothing is found on one side, the others need not be searched.
        let ends = || Some([side(0, 1.0)?, side(0, -1.0)?, side(1, 1.0)?, side(1, -1.0)?]);
        let Some([x_low, x_high, y_low, y_high]) = ends() else {
            return ScreenBox::EMPTY;
        };
        // Cell corners carry the rounding of a few halvings; a thousandth of a pixel covers it.
        let first = |v: f64| (v - 1e-3).ceil().max(0.0) as i64;
        let last = |v: f64, size: f64| (v + 1e-3).floor().min(size - 1.0) as i64;
        let columns = [first(x_low - left), last(-x_high - left, w)];
        let lines = [first(y_low - top), last(-y_high - top, h)];
        ScreenBox::of(columns, lines).or_empty()
    }
}

/// All pixel centres of the screen, between two depths.
pub(super) fn screen_between(width: u32, height: u32, [near, far]: [f64; 2]) -> Cell {
    let (w, h) = (f64::from(width), f64::from(height));
    Cell::between(
        [-0.5 * w, -0.5 * h, near],
        [0.5 * w - 1.0, 0.5 * h - 1.0, far],
    )
}

/// The coefficients divided by the greatest magnitude, so that large exact numbers become moderate floats.
fn normalised<const N: usize>(coefficients: [&BigRational; N]) -> [f64; N] {
    let (whole, _) = common_denominator(coefficients);
    let greatest = greatest(whole.each_ref());
    if greatest.is_zero() {
        return [0.0; N];
    }
    unreduced(whole, &greatest).map(|c| to_f64(&c))
}

fn plane_low(plane: &[f64; 4], cell: &Cell) -> f64 {
    let [a, b, c, d] = plane;
    let ([x, y, z], [hx, hy, hz]) = (cell.centre, cell.half);
    let spread = a.abs() * hx + b.abs() * hy + c.abs() * hz;
    let size = a.abs() * x.abs() + b.abs() * y.abs() + c.abs() * z.abs() + d.abs() + spread;
    a * x + b * y + c * z + d - spread - MARGIN * size
}

/// A cell in the queue; the smallest key is served first.
struct Entry {
    key: f64,
    cell: Cell,
}

impl PartialEq for Entry {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Entry {}

impl PartialOrd for Entry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Entry {
    fn cmp(&self, other: &Self) -> Ordering {
        other.key.total_cmp(&self.key)
    }
}
