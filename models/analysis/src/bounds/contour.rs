//! How far the silhouette of the golden picture can be from the true one.
//!
//! Let f2' be the value of the second-degree processor with its guard bits: dropping them keeps its sign. Let `|f2' -
//! f2| <= e2` on the screen box, true at every point of its rectangle, and let the gradient of f2' be nowhere shorter
//! than G in the band `|f2'| <= e2`. A point of the true contour f2 = 0 lies in the band; along the steepest slope of
//! f2' towards zero f2' changes by at least G per pixel, so the computed contour, or the box's edge, is met within
//! e2 / G pixels. From a point of the computed contour the steepest slope leads within e2 / G pixels to f2' = e2,
//! where f2 >= 0, and to f2' = -e2, where f2 <= 0: the true contour is crossed on the way.
//!
//! G is bounded from below cell by cell. On the cell of half width h around a point with gradient (gx, gy), f2'
//! differs from the value at the point by at most `(|gx| + |gy|) h + (|a| + |b| + |c|) h^2`, which tells whether the
//! cell meets the band; the components of the gradient differ by at most `(2|a| + |c|) h` and `(2|b| + |c|) h`.
//! Inconclusive cells are quartered. Cells at which a plane removes the contour with a pixel to spare do not count, as
//! long as the displacement found is below one pixel.
//!
//! Cells that stay inconclusive to the last surround the point where the gradient vanishes. If it is a saddle, as at
//! the apex of a double cone seen from the side, the slope lines pass by: along a slope line of a second-degree
//! expression both coordinates on its principal axes change monotonically, so a line spends at most twice the
//! diagonal of the rectangle around these cells inside it, which is added to e2 / G. (The lines that end in the
//! saddle itself are limits of lines that pass by.)
//!
//! If it is a summit or a pit of value m, as at the apex of a cone that is looked into, let h be the smaller
//! eigenvalue of the second derivatives. At a distance t from it f2' differs from m by at least `h t^2 / 2`, and its
//! gradient is at least `sqrt(2 h |f2' - m|)` long.
//!
//! * Where m is beyond the band on the side of its own sign, both contours go around it, and G is at least `sqrt(2 h
//!   (|m| - e2))`.
//! * Where m is in the band, the whole band is a spot within `t = sqrt(2 (e2 + |m|) / h)` of it. Either contour may
//!   be missing there, so the displacement that is stated is the width 2t of the spot: nothing wider can appear or
//!   vanish.

use imogene_golden::format::Format;
use imogene_golden::object::quadric::QuadricWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::PreparedQuadric;
use imogene_prepare::rounding::Anchor;
use rayon::prelude::*;

/// Quarterings of a pixel before a vanishing gradient is believed.
const DEPTH_OF_SEARCH: u32 = 7;
/// Cells of one pixel that are examined before the rest of it is taken as flat: where f2 is small on a whole area,
/// finer cells tell nothing.
const CELL_BUDGET: usize = 400;
/// Pixels around a cell on which a plane must remove the contour for the cell not to count.
const SPARE: f64 = 1.5;
/// Relative allowance for the evaluation of gradients in `f64`.
const FLOAT_MARGIN: f64 = 1e-9;

/// What is known of an object's silhouette.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Displacement {
    /// Greatest displacement in pixels.
    pub pixels: f64,
    /// The pixel near which the silhouette has no direction, if there is one.
    pub singular: Option<(i64, i64)>,
}

impl Displacement {
    /// Of a silhouette that has a direction everywhere.
    const fn straight(pixels: f64) -> Displacement {
        Displacement {
            pixels,
            singular: None,
        }
    }
}

/// Bounds the displacement of the contour on the object's screen box.
pub(super) fn displacement(object: &PreparedQuadric, format: &Format) -> Displacement {
    if object.words.screen_box.is_empty() {
        return Displacement::straight(0.0);
    }
    let contour = Contour::new(object, format);
    let trimmed = contour.search(true);
    if trimmed.pixels <= SPARE - 0.5 {
        trimmed
    } else {
        contour.search(false)
    }
}

/// True if a look at the whole of f2 shows that no contour can be displaced by a pixel: one around a summit or a pit
/// beyond the band.
pub(super) fn steep_everywhere(object: &PreparedQuadric, format: &Format) -> bool {
    let contour = Contour::new(object, format);
    let [a, b, c] = contour.second;
    let middle = Anchor::middle_of(&object.words.screen_box);
    4.0 * a * b > c * c * (1.0 + FLOAT_MARGIN) && contour.spot([middle.x, middle.y]) < 1.0
}

/// A square cell: centre relative to a pixel, and half width.
#[derive(Clone, Copy)]
struct Cell {
    u: f64,
    v: f64,
    half: f64,
}

impl Cell {
    /// The cell on the screen, around pixel (x, y).
    fn at(&self, x: i64, y: i64) -> Rectangle {
        let centre = [x as f64 + self.u, y as f64 + self.v];
        Rectangle {
            low: centre.map(|c| c - self.half),
            high: centre.map(|c| c + self.half),
        }
    }
}

/// A rectangle of the screen.
#[derive(Clone, Copy)]
struct Rectangle {
    low: [f64; 2],
    high: [f64; 2],
}

impl Rectangle {
    const EMPTY: Rectangle = Rectangle {
        low: [f64::INFINITY; 2],
        high: [f64::NEG_INFINITY; 2],
    };

    fn around_both(self, other: Rectangle) -> Rectangle {
        Rectangle {
            low: [0, 1].map(|k| self.low[k].min(other.low[k])),
            high: [0, 1].map(|k| self.high[k].max(other.high[k])),
        }
    }
}

/// What is found on a part of the screen.
#[derive(Clone, Copy)]
struct Survey {
    /// Lower bound of the gradient where the part meets the band; infinite if it does not.
    least_gradient: f64,
    /// The rectangle around the cells on which the gradient may vanish.
    flat: Rectangle,
}

impl Survey {
    const EMPTY: Survey = Survey {
        least_gradient: f64::INFINITY,
        flat: Rectangle::EMPTY,
    };

    fn merged(self, other: Survey) -> Survey {
        Survey {
            least_gradient: self.least_gradient.min(other.least_gradient),
            flat: self.flat.around_both(other.flat),
        }
    }
}

/// All values of f2 in units of the last guard bit.
struct Contour<'a> {
    object: &'a PreparedQuadric,
    words: &'a QuadricWords,
    format: &'a Format,
    /// e2.
    error: f64,
    second: [f64; 3],
}

/// f2' and its gradient at a pixel.
struct Local {
    value: f64,
    gradient: [f64; 2],
}

impl<'a> Contour<'a> {
    fn new(object: &'a PreparedQuadric, format: &'a Format) -> Contour<'a> {
        let q = &object.words.f2;
        Contour {
            object,
            words: &object.words,
            format,
            error: object.bounds.f2 * f64::from(1u32 << format.guard_quadratic),
            second: [q.a as f64, q.b as f64, q.c as f64],
        }
    }

    fn search(&self, trimmed: bool) -> Displacement {
        let window = self.words.screen_box;
        let line = |y: i64| {
            (window.x0..=window.x1)
                .filter(|&x| !(trimmed && self.is_removed(x, y)))
                .map(|x| self.survey(x, y))
                .fold(Survey::EMPTY, Survey::merged)
        };
        let lines = (window.y0..=window.y1).into_par_iter().map(line);
        self.conclude(&lines.reduce(|| Survey::EMPTY, Survey::merged))
    }

    fn conclude(&self, survey: &Survey) -> Displacement {
        let steep = self.error / survey.least_gradient * (1.0 + FLOAT_MARGIN);
        let Rectangle { low, high } = survey.flat;
        if low[0] > high[0] {
            return Displacement::straight(steep);
        }
        let window = self.words.screen_box;
        let diagonal = ((window.x1 - window.x0) as f64).hypot((window.y1 - window.y0) as f64);
        let middle = [0, 1].map(|k| (0.5 * (low[k] + high[k])).round() as i64);
        let [a, b, c] = self.second;
        let determinant = 4.0 * a * b - c * c;
        let surely = FLOAT_MARGIN * c * c;
        let bound = if determinant < -surely {
            steep + 2.0 * (high[0] - low[0]).hypot(high[1] - low[1])
        } else if determinant > surely {
            self.spot(middle)
        } else {
            diagonal
        };
        Displacement {
            pixels: diagonal.min(bound),
            singular: Some((middle[0], middle[1])),
        }
    }

    /// Displacement around a summit or a pit, which is near a pixel.
    fn spot(&self, [x, y]: [i64; 2]) -> f64 {
        let [a, b, c] = self.second;
        let least_curvature = ((a + b).abs() - (a - b).hypot(c)) - FLOAT_MARGIN * (a + b).abs();
        if least_curvature <= 0.0 {
            return f64::INFINITY;
        }
        let local = self.local(x, y);
        let (value, [gx, gy]) = (local.value, local.gradient);
        let determinant = 4.0 * a * b - c * c;
        let u = (c * gy - 2.0 * b * gx) / determinant;
        let v = (c * gx - 2.0 * a * gy) / determinant;
        // Counted from the side to which the summit or pit points; beyond -e2 both contours go around it.
        let extreme = (value + 0.5 * (gx * u + gy * v)) * a.signum();
        let margin = FLOAT_MARGIN * (value.abs() + (gx * u).abs() + (gy * v).abs() + self.error);
        let beyond = -extreme - self.error - margin;
        if beyond > 0.0 {
            return self.error / (2.0 * least_curvature * beyond).sqrt() * (1.0 + FLOAT_MARGIN);
        }
        let reach = (self.error - extreme + margin).max(0.0);
        2.0 * (2.0 * reach / least_curvature).sqrt() * (1.0 + FLOAT_MARGIN)
    }

    fn local(&self, x: i64, y: i64) -> Local {
        let q = &self.words.f2;
        let (px, py) = (i128::from(x), i128::from(y));
        Local {
            value: q.wrapped_at(x, y, self.format.pe2_width()) as f64,
            gradient: [
                (2 * q.a * px + q.c * py + q.d) as f64,
                (2 * q.b * py + q.c * px + q.e) as f64,
            ],
        }
    }

    /// What the square of one pixel contributes.
    fn survey(&self, x: i64, y: i64) -> Survey {
        let local = self.local(x, y);
        let whole = Cell {
            u: 0.0,
            v: 0.0,
            half: 0.5,
        };
        let mut survey = Survey::EMPTY;
        let mut open = vec![(whole, 0)];
        let mut examined = 0;
        while let Some((cell, depth)) = open.pop() {
            examined += 1;
            match self.cell_gradient(&local, cell) {
                None => {}
                Some((low, centre)) if low >= 0.5 * centre && low > 0.0 => {
                    survey.least_gradient = survey.least_gradient.min(low);
                }
                Some(_) if depth == DEPTH_OF_SEARCH || examined > CELL_BUDGET => {
                    survey.flat = survey.flat.around_both(cell.at(x, y));
                }
                Some(_) => open.extend(quarters(cell).map(|c| (c, depth + 1))),
            }
        }
        survey
    }

    /// Least gradient on the cell and gradient at its centre; `None` if the cell does not meet the band.
    fn cell_gradient(&self, local: &Local, cell: Cell) -> Option<(f64, f64)> {
        let [a, b, c] = self.second;
        let Cell { u, v, half } = cell;
        let [gx, gy] = local.gradient;
        let value = local.value + (gx + a * u + c * v) * u + (gy + b * v) * v;
        let (gx, gy) = (gx + 2.0 * a * u + c * v, gy + 2.0 * b * v + c * u);
        let reach = (gx.abs() + gy.abs()) * half + (a.abs() + b.abs() + c.abs()) * half * half;
        if value.abs() - reach > self.error {
            return None;
        }
        let low_x = (gx.abs() - (2.0 * a.abs() + c.abs()) * half).max(0.0);
        let low_y = (gy.abs() - (2.0 * b.abs() + c.abs()) * half).max(0.0);
        Some((low_x.hypot(low_y), gx.hypot(gy)))
    }

    /// True if some plane certainly removes the contour around this pixel. On the contour the depth is f1.
    fn is_removed(&self, x: i64, y: i64) -> bool {
        // In the band the depth differs from f1 by the root of up to 2 e2.
        let slack = self.object.bounds.f1 + (2.0 * self.object.bounds.f2).sqrt() + 1.0;
        // All in units of the last guard bit of f1, which the planes do not have.
        let guards = self.format.guard_linear;
        let f1 = &self.words.f1;
        let planes = self.words.planes.iter().zip(&self.object.bounds.planes);
        let solid_inside_out = self.words.class == Class::Front;
        planes.into_iter().any(|(plane, bound)| {
            let [pa, pb, pc] =
                [plane.depth.a, plane.depth.b, plane.depth.c].map(|word| word << guards);
            let (sign, reference) = match plane.kind {
                PlaneKind::Perpendicular => (1, None),
                _ if solid_inside_out || self.words.class == Class::Prism => return false,
                PlaneKind::Front => (-1, Some(f1)),
                PlaneKind::Back => (1, Some(f1)),
                PlaneKind::None => return false,
            };
            // Kept where `sign * (p - f1)` is not negative.
            let (ra, rb, rc) = reference.map_or((0, 0, 0), |f| (f.a, f.b, f.c));
            let value = |a: i128, b: i128, c: i128| a * i128::from(x) + b * i128::from(y) + c;
            let at = sign * value(pa - ra, pb - rb, pc - rc);
            let reach = SPARE * ((pa - ra) as f64).abs() + SPARE * ((pb - rb) as f64).abs();
            let error = bound + if reference.is_some() { slack } else { 0.0 };
            (at as f64) + reach + error * f64::from(1u32 << guards) < 0.0
        })
    }
}

fn quarters(cell: Cell) -> [Cell; 4] {
    let half = 0.5 * cell.half;
    [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].map(|(s, t)| Cell {
        u: cell.u + s * half,
        v: cell.v + t * half,
        half,
    })
}
