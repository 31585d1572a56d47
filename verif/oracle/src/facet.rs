//! Meshes along lines of sight: a line meets a triangle if its three volumes with the sides have one sign.

use crate::camera::{Sight, cross, point};
use crate::interval::Interval;
use crate::root::Real;
use crate::transform::{Matrix, Vector, apply};
use crate::verdict::{Cell, Ends, Solved, Verdict};
use imogene_golden::object::facet::FACE_FACET;
use imogene_scene::Mesh;
use num_rational::BigRational;
use num_traits::{Signed, Zero};

/// A form of first degree in X and Y: factors of X, Y and 1.
type Form = [BigRational; 3];

/// The facets of a mesh that was checked, at its place.
pub fn triangles(mesh: &Mesh, place: &Matrix, sight: &Sight) -> Vec<Triangle> {
    let local: Vec<Vector> = mesh.vertices.iter().map(point).collect();
    let placed: Vec<Vector> = local.iter().map(|v| apply(place, v)).collect();
    let mut triangles = vec![];
    let mut part = 0;
    for corners in &mesh.faces {
        for (new_part, triangle) in split(&local, corners) {
            part += u32::from(new_part);
            let corners = triangle.map(|k| &placed[k]);
            triangles.push(Triangle::new(corners, part - 1, sight));
        }
    }
    triangles
}

/// A flat facet of a mesh, or a half of it.
#[derive(Clone, Debug)]
pub struct Triangle {
    /// The facet it is a part of, counted through the mesh as its processor counts.
    pub part: u32,
    /// Volume of the line with each side.
    sides: [Both; 3],
    /// The plane at the beginning of the line, and along it.
    start: Both,
    slope: Both,
    perspective: bool,
}

#[derive(Clone, Debug)]
struct Both {
    exact: Form,
    quick: [Interval; 3],
}

impl Both {
    fn new(exact: Form) -> Both {
        Both {
            quick: crate::interval::about_all(&exact),
            exact,
        }
    }

    fn at(&self, x: i64, y: i64) -> BigRational {
        let [a, b, c] = &self.exact;
        a * BigRational::from_integer(x.into()) + b * BigRational::from_integer(y.into()) + c
    }

    fn on(&self, cell: &Cell) -> Interval {
        let [a, b, c] = self.quick;
        let at = a * Interval::point(cell.x) + b * Interval::point(cell.y) + c;
        at + a * Interval::within(cell.reach_x) + b * Interval::within(cell.reach_y)
    }
}

impl Triangle {
    fn new([a, b, c]: [&Vector; 3], part: u32, sight: &Sight) -> Triangle {
        let side = |p: &Vector, q: &Vector| Both::new(volume(p, q, sight));
        let plane = plane_through(a, b, c);
        let along = |affine: &[Vector; 3]| affine.each_ref().map(|v| dot(v, &plane));
        Triangle {
            part,
            sides: [side(a, b), side(b, c), side(c, a)],
            start: Both::new(along(&sight.from)),
            slope: Both::new(along(&sight.along)),
            perspective: sight.perspective,
        }
    }

    /// Change of the depth from a pixel to the next column and to the next line, in shares of the greatest depth word.
    ///
    /// In perspective the depth is `1 - 1/t`, and 1/t is of first degree in X and Y, as t is in parallel projection.
    pub fn depth_slope(&self) -> [f64; 2] {
        let (start, slope) = (&self.start.exact, &self.slope.exact);
        // t = - start / slope, one of which is the same for all lines.
        let (of, constant) = match self.perspective {
            true => (slope, &start[2]),
            false => (start, &slope[2]),
        };
        if constant.is_zero() {
            return [f64::INFINITY; 2];
        }
        // X and Y are in half pixels.
        [0, 1].map(|k| 2.0 * Interval::about(&(&of[k] / constant)).middle().abs())
    }

    /// Where the line of a pixel meets its plane, if the facet comes within `reach` (half pixels), across and down.
    pub fn near(&self, (x, y): (i64, i64), reach: f64) -> Option<Interval> {
        let cell = Cell {
            x: x as f64,
            y: y as f64,
            reach_x: reach,
            reach_y: reach,
            first: f64::NEG_INFINITY,
            last: f64::INFINITY,
        };
        // No side has the square on its outer side, and no side of the square has the facet on its own.
        let sides = self.sides.each_ref().map(|s| s.on(&cell));
        if sides.iter().any(|s| s.lo > 0.0) && sides.iter().any(|s| s.hi < 0.0) {
            return None;
        }
        let corners = self.corners()?;
        let meets = |axis: usize, at: f64| {
            corners.iter().any(|c| c[axis].hi >= at - reach)
                && corners.iter().any(|c| c[axis].lo <= at + reach)
        };
        let point = Cell {
            reach_x: 0.0,
            reach_y: 0.0,
            ..cell
        };
        let t = -self.start.on(&point) / self.slope.on(&point);
        (meets(0, cell.x) && meets(1, cell.y)).then_some(t)
    }

    /// The corners on the screen, in half pixels from its middle, where the sides cross; `None` if it is seen edge-on.
    fn corners(&self) -> Option<[[Interval; 2]; 3]> {
        let mut corners = [[Interval::ZERO; 2]; 3];
        for (k, corner) in corners.iter_mut().enumerate() {
            let ([a, b, c], [d, e, f]) = (&self.sides[k].exact, &self.sides[(k + 1) % 3].exact);
            let unit = a * e - b * d;
            if unit.is_zero() {
                return None;
            }
            *corner =
                [(b * f - c * e) / &unit, (c * d - a * f) / &unit].map(|v| Interval::about(&v));
        }
        Some(corners)
    }

    /// The hit at a pixel, in half pixels from the middle of the picture; sides belong to the triangle.
    pub fn solve(&self, x: i64, y: i64, ends: &Ends) -> Option<Solved> {
        let volumes = self.sides.each_ref().map(|s| s.at(x, y));
        let above = volumes.iter().any(BigRational::is_positive);
        let below = volumes.iter().any(BigRational::is_negative);
        let slope = self.slope.at(x, y);
        // Seen edge-on it shows nothing.
        if above == below || slope.is_zero() {
            return None;
        }
        let t = Real::Fraction(-self.start.at(x, y) / slope);
        ends.hold(&t).then_some(Solved {
            t,
            number: FACE_FACET,
            part: self.part,
        })
    }

    /// What a cell shows of it.
    pub fn decide(&self, cell: &Cell) -> Verdict {
        let sides = self.sides.each_ref().map(|s| s.on(cell));
        let above = sides.iter().any(|s| s.lo > 0.0);
        let below = sides.iter().any(|s| s.hi < 0.0);
        if above && below {
            return Verdict::Absent;
        }
        let inside = sides.iter().all(|s| s.lo > 0.0) || sides.iter().all(|s| s.hi < 0.0);
        let t = -self.start.on(cell) / self.slope.on(cell);
        if t.hi < cell.first || t.lo >= cell.last {
            return Verdict::Absent;
        }
        let drawn = t.lo >= cell.first && t.hi < cell.last;
        if inside && drawn {
            Verdict::Hit {
                t,
                number: FACE_FACET,
                part: self.part,
            }
        } else {
            Verdict::Open(t.lo.max(cell.first))
        }
    }
}

/// The determinant of a line's beginning and direction, one of them the same for all lines, and two points.
fn volume(p: &Vector, q: &Vector, sight: &Sight) -> Form {
    let det = |from: &Vector, along: &Vector| determinant([from, along, p, q]);
    let (from, along) = (&sight.from, &sight.along);
    if sight.perspective {
        along.each_ref().map(|v| det(&from[2], v))
    } else {
        from.each_ref().map(|v| det(v, &along[2]))
    }
}

fn determinant([a, b, c, d]: [&Vector; 4]) -> BigRational {
    let two = |i: usize, j: usize, u: &Vector, v: &Vector| &u[i] * &v[j] - &u[j] * &v[i];
    // Laplace's expansion by pairs of rows.
    two(0, 1, a, b) * two(2, 3, c, d) - two(0, 2, a, b) * two(1, 3, c, d)
        + two(0, 3, a, b) * two(1, 2, c, d)
        + two(1, 2, a, b) * two(0, 3, c, d)
        - two(1, 3, a, b) * two(0, 2, c, d)
        + two(2, 3, a, b) * two(0, 1, c, d)
}

/// The plane through three points with homogeneous coordinate 1.
fn plane_through(a: &Vector, b: &Vector, c: &Vector) -> Vector {
    let [u, v] = [b, c].map(|end| [0, 1, 2].map(|k| &end[k] - &a[k]));
    let normal = cross(&u, &v);
    let constant = -dot(&normal, &a[..3]);
    let [x, y, z] = normal;
    [x, y, z, constant]
}

fn dot(u: &[BigRational], v: &[BigRational]) -> BigRational {
    u.iter().zip(v).map(|(x, y)| x * y).sum()
}

/// The triangles of a face, and whether each begins a facet of its own.
///
/// A flat convex quadrangle is one facet; any other is two, from the first corner if that diagonal is inside.
fn split(vertices: &[Vector], corners: &[usize]) -> Vec<(bool, [usize; 3])> {
    let &[a, b, c, d] = corners else {
        return vec![(true, [corners[0], corners[1], corners[2]])];
    };
    let plane = |[a, b, c]: [usize; 3]| plane_through(&vertices[a], &vertices[b], &vertices[c]);
    let (one, two) = (plane([a, b, c]), plane([a, c, d]));
    // Normals are the first three words.
    let whole = [0, 1, 2].map(|k| &one[k] + &two[k]);
    let turns_with = |triangle: [usize; 3]| dot(&plane(triangle), &whole).is_positive();
    let from_first = turns_with([a, b, c]) && turns_with([a, c, d]);
    let from_second = turns_with([b, c, d]) && turns_with([b, d, a]);
    let flat = dot(&one, &vertices[d]).is_zero() && from_first && from_second;
    if from_first {
        vec![(true, [a, b, c]), (!flat, [a, c, d])]
    } else {
        vec![(true, [b, c, d]), (true, [b, d, a])]
    }
}
