//! What a cell of pixels shows of one object, as far as intervals can tell.
//!
//! On the line of sight `from + t along` the quadric is `R t^2 + 2 S t + T`. A cell is a pixel, or a rectangle of
//! pixels of which each is as it is said: so objects are ruled out, with no other structure of space.

use crate::body::{Body, CutBody};
use crate::interval::{Interval, dot};
use crate::verdict::{Cell, Verdict};
use imogene_golden::unit::depth_interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END};
use imogene_scene::Surface;

impl Body {
    /// What a cell shows of it.
    pub fn decide(&self, cell: &Cell) -> Verdict {
        match self {
            Body::Cut(body) => body.decide(cell),
            Body::Facet(facet) => facet.decide(cell),
        }
    }
}

/// A line of sight, or all of a cell.
struct Line {
    from: [Interval; 4],
    along: [Interval; 4],
    /// R, S, T and `S^2 - R T`.
    r: Interval,
    s: Interval,
    t: Interval,
    discriminant: Interval,
}

type Point = [Interval; 4];

const TWO: Interval = Interval::point(2.0);

/// `a + b u + c v + d u^2 + e u v + f v^2` about the middle of a cell.
type Polynomial = [Interval; 6];

impl CutBody {
    fn decide(&self, cell: &Cell) -> Verdict {
        let line = self.line(cell);
        let nowhere_inside = line.r.lo > 0.0 || line.t.lo > 0.0;
        if line.discriminant.hi < 0.0 && nowhere_inside {
            return Verdict::Absent;
        }
        match self.surface {
            Surface::Solid => self.solid(cell, &line),
            Surface::Patch => self.patch(cell, &line),
        }
    }

    fn line(&self, cell: &Cell) -> Line {
        let lines = &self.quick;
        let (x, y) = (Interval::point(cell.x), Interval::point(cell.y));
        let at = |[a, b, c]: &[[Interval; 4]; 3]| -> [Interval; 4] {
            std::array::from_fn(|k| a[k] * x + b[k] * y + c[k])
        };
        let (from, along) = (at(&lines.from), at(&lines.along));
        let [u, v] = [cell.reach_x, cell.reach_y].map(Interval::within);
        let spread = |middle: &[Interval; 4], [a, b, _]: &[[Interval; 4]; 3]| -> [Interval; 4] {
            std::array::from_fn(|k| middle[k] + a[k] * u + b[k] * v)
        };
        let [r, s, t, discriminant] = match &lines.form {
            None => [Interval::ZERO; 4],
            Some(form) if cell.reach_x == 0.0 && cell.reach_y == 0.0 => {
                let (to_along, to_from) = (product(form, &along), product(form, &from));
                let r = dot(&along, &to_along);
                let s = dot(&from, &to_along);
                let t = dot(&from, &to_from);
                [r, s, t, s.square() - r * t]
            }
            Some(form) => {
                let ([ux, uy, _], [vx, vy, _]) = (&lines.from, &lines.along);
                let r = squares(form, &along, vx, vy);
                let t = squares(form, &from, ux, uy);
                let s = mixed(form, [&from, ux, uy], [&along, vx, vy]);
                // In perspective T is the same for all lines, in parallel projection R.
                let (constant, other) = match self.perspective {
                    true => (t[0], &r),
                    false => (r[0], &t),
                };
                let square = square_of(&s);
                let discriminant = std::array::from_fn(|k| square[k] - constant * other[k]);
                [r, s, t, discriminant].map(|[a, b, c, d, e, f]| {
                    a + b * u + c * v + d * u.square() + e * (u * v) + f * v.square()
                })
            }
        };
        Line {
            from: spread(&from, &lines.from),
            along: spread(&along, &lines.along),
            r,
            s,
            t,
            discriminant,
        }
    }

    /// Where each plane bounds the line; `None` if a plane removes all of it.
    fn bounds(&self, cell: &Cell, line: &Line) -> Option<Bounds> {
        let mut bounds = Bounds {
            start: Interval::point(cell.first),
            number: Some(FACE_NEAR_END),
            end: Interval::point(f64::INFINITY),
            open: false,
        };
        for (plane, &number) in self.quick.planes.iter().zip(&self.numbers) {
            let (at, slope) = (dot(plane, &line.from), dot(plane, &line.along));
            if slope.is_zero() {
                if at.lo > 0.0 {
                    return None;
                }
                bounds.open |= at.hi > 0.0;
            } else if slope.hi < 0.0 {
                let at = -at / slope;
                if !at.not_above(bounds.start) {
                    bounds.number = bounds.start.below(at).then_some(number);
                    bounds.start = bounds.start.max(at);
                }
            } else if slope.lo > 0.0 {
                bounds.end = bounds.end.min(-at / slope);
            } else {
                bounds.open = true;
            }
        }
        Some(bounds)
    }

    /// The first point of the volume.
    fn solid(&self, cell: &Cell, line: &Line) -> Verdict {
        let Some(bounds) = self.bounds(cell, line) else {
            return Verdict::Absent;
        };
        let (start, end) = (bounds.start, bounds.end);
        if end.below(start) || start.lo >= cell.last {
            return Verdict::Absent;
        }
        let open = Verdict::Open(start.lo);
        let there = !bounds.open && start.not_above(end) && start.hi < cell.last;
        let Line { r, s, t, .. } = *line;
        let at_start = (r * start + TWO * s) * start + t;
        if at_start.hi <= 0.0 {
            return match bounds.number {
                Some(number) if there => hit(start, number),
                _ => open,
            };
        }
        if at_start.lo <= 0.0 {
            return open;
        }
        // Outside at the start: the line enters later, or never.
        if line.discriminant.hi < 0.0 {
            return Verdict::Absent;
        }
        let slope = r * start + s;
        if slope.lo > 0.0 && r.lo >= 0.0 {
            return Verdict::Absent;
        }
        let enters = line.discriminant.lo >= 0.0 && (slope.hi < 0.0 || r.hi < 0.0);
        let root = line.discriminant.sqrt();
        // (-S - sqrt) / R = T / (sqrt - S): the one without cancellation.
        let entry = match s.hi < 0.0 {
            true => t / (root - s),
            false => (-s - root) / r,
        };
        if enters && (end.below(entry) || entry.lo >= cell.last) {
            return Verdict::Absent;
        }
        let kept = entry.not_above(end) && entry.hi < cell.last;
        let (lo, hi) = (entry.lo.max(start.lo), entry.hi);
        // It enters through the far face if the other comes before it. In perspective the order is that of the depth,
        // in which points behind the eye come after infinity.
        let far = r.hi < 0.0 && (!self.perspective || t.hi < 0.0);
        let near = r.lo >= 0.0 || (self.perspective && t.lo > 0.0);
        match enters {
            true if there && kept && near => hit(Interval { lo, hi }, FACE_NEAR),
            true if there && kept && far => hit(Interval { lo, hi }, FACE_FAR),
            true => Verdict::Open(lo),
            false => open,
        }
    }

    /// The first point of the surface that the planes keep.
    fn patch(&self, cell: &Cell, line: &Line) -> Verdict {
        if line.discriminant.hi < 0.0 {
            return Verdict::Absent;
        }
        let open = Verdict::Open(cell.first);
        let open_from = |t: Interval| Verdict::Open(t.lo.max(cell.first));
        let Line { r, s, t, .. } = *line;
        if r.is_zero() && !s.holds_zero() {
            let only = -t / (TWO * s);
            return match self.keeps(cell, line, only) {
                Some(false) => Verdict::Absent,
                Some(true) => hit(only, FACE_NEAR),
                None => open,
            };
        }
        if r.holds_zero() || line.discriminant.lo < 0.0 {
            return open;
        }
        let [low, high] = roots(line);
        // Behind the eye comes after infinity.
        let number = match !self.perspective || low.lo > 0.0 {
            true => Some(FACE_FAR),
            false => (low.hi <= 0.0).then_some(FACE_NEAR),
        };
        let [keeps_low, keeps_high] = [low, high].map(|t| self.keeps(cell, line, t));
        match (keeps_low, keeps_high, number) {
            (Some(false), Some(false), _) => Verdict::Absent,
            (Some(true), _, _) => hit(low, FACE_NEAR),
            (Some(false), Some(true), Some(number)) => hit(high, number),
            (Some(false), _, _) => open_from(high),
            _ => open_from(low),
        }
    }

    /// Whether the planes and the ends of the depth keep a point.
    fn keeps(&self, cell: &Cell, line: &Line, t: Interval) -> Option<bool> {
        if t.hi < cell.first || t.lo >= cell.last {
            return Some(false);
        }
        let mut all = (t.lo >= cell.first && t.hi < cell.last).then_some(true);
        for plane in &self.quick.planes {
            let value = dot(plane, &line.from) + t * dot(plane, &line.along);
            if value.lo > 0.0 {
                return Some(false);
            }
            if value.hi > 0.0 {
                all = None;
            }
        }
        all
    }
}

fn hit(t: Interval, number: u8) -> Verdict {
    Verdict::Hit { t, number, part: 0 }
}

/// The part of a line that planes and near end leave.
struct Bounds {
    start: Interval,
    /// The face at the start; `None` if two come too close to tell.
    number: Option<u8>,
    end: Interval,
    /// Some plane could not be placed.
    open: bool,
}

/// Both roots in ascending order, where R is not zero and the discriminant not negative.
fn roots(line: &Line) -> [Interval; 2] {
    let (r, s, t) = (line.r, line.s, line.t);
    let root = line.discriminant.sqrt();
    let (one, other) = if s.lo >= 0.0 {
        let q = -(s + root);
        (q / r, t / q)
    } else if s.hi <= 0.0 {
        let q = root - s;
        (t / q, q / r)
    } else {
        ((-s - root) / r, (-s + root) / r)
    };
    match r.lo > 0.0 {
        true => [one, other],
        false => [other, one],
    }
}

fn product(form: &[[Interval; 4]; 4], v: &[Interval; 4]) -> [Interval; 4] {
    form.each_ref().map(|row| dot(row, v))
}

/// The quadric of `m + u a + v b`.
fn squares(form: &[Point; 4], m: &Point, a: &Point, b: &Point) -> Polynomial {
    let (to_m, to_a, to_b) = (product(form, m), product(form, a), product(form, b));
    let [am, bm, ab] = [dot(a, &to_m), dot(b, &to_m), dot(a, &to_b)].map(|v| TWO * v);
    [dot(m, &to_m), am, bm, dot(a, &to_a), ab, dot(b, &to_b)]
}

/// The bilinear form of two points of first degree, of which one is constant.
fn mixed(form: &[Point; 4], [m, ma, mb]: [&Point; 3], [n, na, nb]: [&Point; 3]) -> Polynomial {
    let (to_m, to_n) = (product(form, m), product(form, n));
    let a = dot(ma, &to_n) + dot(na, &to_m);
    let b = dot(mb, &to_n) + dot(nb, &to_m);
    let zero = Interval::ZERO;
    [dot(m, &to_n), a, b, zero, zero, zero]
}

/// The square of a polynomial of first degree.
fn square_of([a, b, c, ..]: &Polynomial) -> Polynomial {
    let [ab, ac, bc] = [(a, b), (a, c), (b, c)].map(|(u, v)| TWO * *u * *v);
    [a.square(), ab, ac, b.square(), bc, c.square()]
}
