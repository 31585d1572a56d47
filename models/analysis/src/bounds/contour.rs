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
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
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

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Displacement {
    /// Greatest displacement in pixels.
    pub pixels: f64,
    /// The pixel near which the silhouette has no direction, if there is one.
    pub singular: Option<(i64, i64)>,
}

impl Displacement {
    const fn straight(pixels: f64) -> Displacement {
        Displacement {
            pixels,
            singular: None,
        }
    }
}

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

#[derive(Clone, Copy)]
struct Survey {
    /// Lower bound of the gradient where the part meets the band; infinite if it does not.
    least_gradient: f64,
    /// Corners of the rectangle around the cells on which the gradient may vanish.
    low: [f64; 2],
    high: [f64; 2],
}

impl Survey {
    const EMPTY: Survey = Survey {
        least_gradient: f64::INFINITY,
        low: [f64::INFINITY; 2],
        high: [f64::NEG_INFINITY; 2],
    };

    fn merged(self, other: Survey) -> Survey {
        Survey {
            least_gradient: self.least_gradient.min(other.least_gradient),
            low: [0, 1].map(|k| self.low[k].min(other.low[k])),
            high: [0, 1].map(|k| self.high[k].max(other.high[k])),
        }
    }
}

/// All values of f2 in units of the last guard bit.
struct Contour<'a> {
    object: &'a PreparedQuadric,
    format: &'a Format,
    /// e2.
    error: f64,
    second: [f64; 3],
}

impl<'a> Contour<'a> {
    fn new(object: &'a PreparedQuadric, format: &'a Format) -> Contour<'a> {
        let q = &object.words.f2;
        Contour {
            object,
            format,
            error: object.bounds.f2 * f64::from(1u32 << format.guard_quadratic),
            second: [q.a as f64, q.b as f64, q.c as f64],
        }
    }

    fn search(&self, trimmed: bool) -> Displacement {
        let window = self.object.words.screen_box;
        let line = |y: i64| {
            (window.x0..=window.x1)
                .filter(|&x| !(trimmed && self.is_removed(x, y)))
                .map(|x| self.survey(x, y))
                .fold(Survey::EMPTY, Survey::merged)
        };
        let lines = (window.y0..=window.y1).into_par_iter().map(line);
        let found = lines.reduce(|| Survey::EMPTY, Survey::merged);
        let steep = self.error / found.least_gradient * (1.0 + FLOAT_MARGIN);
        let Survey { low, high, .. } = found;
        if low[0] > high[0] {
            return Displacement::straight(steep);
        }
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
        let (value, [gx, gy]) = self.local(x, y);
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

    /// f2' and its gradient at a pixel.
    fn local(&self, x: i64, y: i64) -> (f64, [f64; 2]) {
        let q = &self.object.words.f2;
        let value = q.wrapped_at(x, y, self.format.pe2_width());
        let (x, y) = (i128::from(x), i128::from(y));
        let gx = 2 * q.a * x + q.c * y + q.d;
        let gy = 2 * q.b * y + q.c * x + q.e;
        (value as f64, [gx as f64, gy as f64])
    }

    /// What the square of one pixel contributes.
    fn survey(&self, x: i64, y: i64) -> Survey {
        let (value, [gx, gy]) = self.local(x, y);
        let [a, b, c] = self.second;
        // Least gradient on a cell and gradient at its centre; `None` if the cell does not meet the band.
        let gradient = |[u, v]: [f64; 2], half: f64| {
            let value = value + (gx + a * u + c * v) * u + (gy + b * v) * v;
            let (gx, gy) = (gx + 2.0 * a * u + c * v, gy + 2.0 * b * v + c * u);
            let reach = (gx.abs() + gy.abs()) * half + (a.abs() + b.abs() + c.abs()) * half * half;
            if value.abs() - reach > self.error {
                return None;
            }
            let low_x = (gx.abs() - (2.0 * a.abs() + c.abs()) * half).max(0.0);
            let low_y = (gy.abs() - (2.0 * b.abs() + c.abs()) * half).max(0.0);
            Some((low_x.hypot(low_y), gx.hypot(gy)))
        };
        let mut survey = Survey::EMPTY;
        // Square cells: centre relative to the pixel, half width, quarterings.
        let mut open = vec![([0.0, 0.0], 0.5, 0)];
        let mut examined = 0;
        while let Some((centre, half, depth)) = open.pop() {
            examined += 1;
            match gradient(centre, half) {
                None => {}
                Some((low, middle)) if low >= 0.5 * middle && low > 0.0 => {
                    survey.least_gradient = survey.least_gradient.min(low);
                }
                Some(_) if depth == DEPTH_OF_SEARCH || examined > CELL_BUDGET => {
                    let centre = [x as f64 + centre[0], y as f64 + centre[1]];
                    survey = survey.merged(Survey {
                        low: centre.map(|c| c - half),
                        high: centre.map(|c| c + half),
                        ..Survey::EMPTY
                    });
                }
                Some(_) => {
                    let [u, v] = centre;
                    let half = 0.5 * half;
                    let corners = [(-half, -half), (half, -half), (-half, half), (half, half)];
                    open.extend(corners.map(|(s, t)| ([u + s, v + t], half, depth + 1)));
                }
            }
        }
        survey
    }

    /// True if some plane certainly removes the contour around this pixel. On the contour the depth is f1.
    fn is_removed(&self, x: i64, y: i64) -> bool {
        // In the band the depth differs from f1 by the root of up to 2 e2.
        let slack = self.object.bounds.f1 + (2.0 * self.object.bounds.f2).sqrt() + 1.0;
        // All in units of the last guard bit of f1, which the planes do not have.
        let guards = self.format.guard_linear;
        let f1 = &self.object.words.f1;
        let PreparedQuadric { words, bounds, .. } = self.object;
        let mut planes = words.planes.iter().zip(&bounds.planes);
        let has_no_planes = matches!(words.class, Class::Front | Class::Prism);
        planes.any(|(plane, bound)| {
            let (sign, from, slack) = match plane.kind {
                PlaneKind::Perpendicular => (1, &Linear::default(), 0.0),
                _ if has_no_planes => return false,
                PlaneKind::Front => (-1, f1, slack),
                PlaneKind::Back => (1, f1, slack),
                PlaneKind::None => return false,
            };
            // Kept where `sign * (p - f1)` is not negative.
            let Linear { a, b, c } = plane.depth;
            let [a, b, c] = [(a, from.a), (b, from.b), (c, from.c)].map(|(p, f)| (p << guards) - f);
            let at = sign * (a * i128::from(x) + b * i128::from(y) + c);
            let reach = SPARE * (a as f64).abs() + SPARE * (b as f64).abs();
            let error = bound + slack;
            (at as f64) + reach + error * f64::from(1u32 << guards) < 0.0
        })
    }
}
