//! Two numbers (u, w) for each point of a support surface, and where a separator crosses a line u = constant.

use super::polynomial::{harmonic, quadratic, roots_between};
use super::surface::{Implicit, Surface};
use super::vector::{Vector, along, cross, dot, frame, length, minus, plus, positive_angle, times};

/// Something whose sign divides a surface in two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Separator {
    /// The sign of `normal . p - offset`.
    Plane {
        /// Unit normal.
        normal: Vector,
        /// Distance from the frame's origin along the normal.
        offset: f64,
    },
    /// The sign of a quadric; divides planes alone.
    Quadric(Implicit),
}

impl Separator {
    /// Whether a point is on the positive side.
    pub fn is_positive(&self, p: Vector) -> bool {
        match self {
            Self::Plane { normal, offset } => dot(*normal, p) > *offset,
            Self::Quadric(implicit) => implicit.value(p) > 0.0,
        }
    }
}

/// Parameters of a surface.
#[derive(Clone, Debug)]
pub enum Chart {
    /// `origin + u e1 + w e2`
    Plane {
        /// A point.
        origin: Vector,
        /// Two unit vectors.
        e: [Vector; 2],
    },
    /// `origin + (radius + w sine) e(u) + w cosine axis`, u an angle: cylinders and cones.
    Ruled {
        /// Point of the axis: the apex of a cone.
        origin: Vector,
        /// Unit vector of the axis.
        axis: Vector,
        /// Two unit vectors across it.
        e: [Vector; 2],
        /// Radius at w = 0.
        radius: f64,
        /// Sine and cosine of the half angle.
        slope: [f64; 2],
    },
    /// `centre + radius (cos w e(u) + sin w axis)`, u the longitude and w the latitude.
    Sphere {
        /// Centre.
        centre: Vector,
        /// Radius.
        radius: f64,
        /// Unit vector to the north pole.
        axis: Vector,
        /// Two unit vectors across it.
        e: [Vector; 2],
    },
}

impl Chart {
    /// A chart of a surface in which none of the separators lies along a line that matters; nothing for a surface that
    /// is none of the four.
    pub fn of(surface: &Surface, separators: &[Separator]) -> Option<Chart> {
        Some(match *surface {
            Surface::Plane { origin, normal } => Chart::Plane {
                origin,
                // Away from the directions that edges of parts have.
                e: frame(normal, 0.387_161_9),
            },
            Surface::Cylinder {
                origin,
                axis,
                radius,
            } => Chart::Ruled {
                origin,
                axis,
                e: frame(axis, 0.0),
                radius,
                slope: [0.0, 1.0],
            },
            Surface::Cone {
                apex,
                axis,
                half_angle,
            } => {
                let (sine, cosine) = half_angle.sin_cos();
                Chart::Ruled {
                    origin: apex,
                    axis,
                    e: frame(axis, 0.0),
                    radius: 0.0,
                    slope: [sine, cosine],
                }
            }
            Surface::Sphere { centre, radius } => {
                let axis = free_pole(centre, radius, separators);
                Chart::Sphere {
                    centre,
                    radius,
                    axis,
                    e: frame(axis, 0.0),
                }
            }
            Surface::Torus { .. } | Surface::Other(_) => return None,
        })
    }

    /// u is an angle.
    pub fn is_periodic(&self) -> bool {
        !matches!(self, Self::Plane { .. })
    }

    /// The ends of w.
    pub fn reach(&self) -> [f64; 2] {
        match self {
            Self::Sphere { .. } => [-std::f64::consts::FRAC_PI_2, std::f64::consts::FRAC_PI_2],
            _ => [f64::NEG_INFINITY, f64::INFINITY],
        }
    }

    /// The point of two parameters.
    pub fn point(&self, u: f64, w: f64) -> Vector {
        match self {
            Self::Plane { origin, e } => along(along(*origin, u, e[0]), w, e[1]),
            Self::Ruled { .. } | Self::Sphere { .. } => {
                let (origin, out, axis) = self.spread(w);
                plus(along(origin, out, self.radial(u)), axis)
            }
        }
    }

    /// Origin, distance from the axis and offset along it at w.
    fn spread(&self, w: f64) -> (Vector, f64, Vector) {
        match self {
            Self::Ruled {
                origin,
                axis,
                radius,
                slope,
                ..
            } => (*origin, radius + w * slope[0], times(w * slope[1], *axis)),
            Self::Sphere {
                centre,
                radius,
                axis,
                ..
            } => (*centre, radius * w.cos(), times(radius * w.sin(), *axis)),
            Self::Plane { origin, .. } => (*origin, 0.0, [0.0; 3]),
        }
    }

    /// The unit vector across the axis at the angle u.
    fn radial(&self, u: f64) -> Vector {
        let (Self::Ruled { e, .. } | Self::Sphere { e, .. } | Self::Plane { e, .. }) = self;
        let (sine, cosine) = u.sin_cos();
        plus(times(cosine, e[0]), times(sine, e[1]))
    }

    /// u of a point of the surface.
    pub fn u_of(&self, p: Vector) -> f64 {
        match self {
            Self::Plane { origin, e } => dot(minus(p, *origin), e[0]),
            Self::Ruled { origin, e, .. }
            | Self::Sphere {
                centre: origin, e, ..
            } => {
                let from = minus(p, *origin);
                positive_angle(dot(from, e[1]).atan2(dot(from, e[0])))
            }
        }
    }

    /// The direction of growing u at a point of the surface.
    pub fn eastwards(&self, p: Vector) -> Vector {
        match self {
            Self::Plane { e, .. } => e[0],
            Self::Ruled { origin, axis, .. }
            | Self::Sphere {
                centre: origin,
                axis,
                ..
            } => cross(*axis, minus(p, *origin)),
        }
    }

    /// A line u = constant as start and direction in w; nothing on a sphere, where it is half a circle.
    fn line(&self, u: f64) -> Option<(Vector, Vector)> {
        match self {
            Self::Plane { origin, e } => Some((along(*origin, u, e[0]), e[1])),
            Self::Ruled {
                origin,
                axis,
                radius,
                slope,
                ..
            } => {
                let out = self.radial(u);
                let direction = plus(times(slope[0], out), times(slope[1], *axis));
                Some((along(*origin, *radius, out), direction))
            }
            Self::Sphere { .. } => None,
        }
    }

    /// The w at which a separator passes zero on the line u, ascending.
    pub fn crossings(&self, u: f64, separator: &Separator) -> Vec<f64> {
        match (self, self.line(u), separator) {
            (_, Some((from, along)), Separator::Plane { normal, offset }) => {
                let slope = dot(*normal, along);
                if slope.abs() <= 1e-13 {
                    return vec![];
                }
                vec![(offset - dot(*normal, from)) / slope]
            }
            (_, Some((from, along)), Separator::Quadric(implicit)) => {
                let [a, b, c] = implicit.on_line(from, along);
                quadratic(a, b, c)
            }
            (
                Self::Sphere {
                    centre,
                    radius,
                    axis,
                    ..
                },
                None,
                Separator::Plane { normal, offset },
            ) => {
                let rest = (offset - dot(*normal, *centre)) / radius;
                let mut roots: Vec<f64> =
                    harmonic(dot(*normal, self.radial(u)), dot(*normal, *axis), rest)
                        .into_iter()
                        .map(|w| {
                            if w > std::f64::consts::PI {
                                w - std::f64::consts::TAU
                            } else {
                                w
                            }
                        })
                        .filter(|w| w.abs() < std::f64::consts::FRAC_PI_2)
                        .collect();
                roots.sort_by(f64::total_cmp);
                roots
            }
            _ => vec![],
        }
    }

    /// All u at which the number of crossings of a separator may change, or at which it lies along the line u.
    pub fn turns(&self, separator: &Separator) -> Vec<f64> {
        match (self, separator) {
            (Self::Plane { origin, e }, Separator::Plane { normal, offset }) => {
                let slope = dot(*normal, e[0]);
                let upright = dot(*normal, e[1]).abs() <= 1e-12;
                if upright && slope != 0.0 {
                    vec![(offset - dot(*normal, *origin)) / slope]
                } else {
                    vec![]
                }
            }
            (Self::Plane { origin, e }, Separator::Quadric(implicit)) => {
                let (a, b, c) = conic(implicit, *origin, e);
                // Discriminant of the quadratic in w, as a polynomial in u.
                let disc = [
                    b[0] * b[0] - 4.0 * a * c[0],
                    2.0 * b[0] * b[1] - 4.0 * a * c[1],
                    b[1] * b[1] - 4.0 * a * c[2],
                ];
                let mut turns = quadratic(disc[2], disc[1], disc[0]);
                turns.extend(quadratic(0.0, b[1], b[0]));
                turns
            }
            (
                Self::Ruled {
                    origin,
                    axis,
                    e,
                    radius,
                    slope,
                },
                Separator::Plane { normal, offset },
            ) => {
                let [n1, n2] = [dot(*normal, e[0]), dot(*normal, e[1])];
                let mut turns = harmonic(
                    slope[0] * n1,
                    slope[0] * n2,
                    -slope[1] * dot(*normal, *axis),
                );
                if *radius > 0.0 {
                    turns.extend(harmonic(
                        radius * n1,
                        radius * n2,
                        offset - dot(*normal, *origin),
                    ));
                }
                turns
            }
            (
                Self::Sphere {
                    centre,
                    radius,
                    axis,
                    e,
                },
                Separator::Plane { normal, offset },
            ) => {
                let rest = (offset - dot(*normal, *centre)) / radius;
                let [n1, n2] = [dot(*normal, e[0]), dot(*normal, e[1])];
                let up = dot(*normal, *axis);
                let square = rest * rest - up * up;
                let mut turns = vec![];
                if square >= 0.0 {
                    turns.extend(harmonic(n1, n2, square.sqrt()));
                    turns.extend(harmonic(n1, n2, -square.sqrt()));
                }
                turns.extend(harmonic(n1, n2, 0.0));
                turns
            }
            (_, Separator::Quadric(_)) => vec![],
        }
    }

    /// All u at which two separators cross each other on the surface.
    pub fn meetings(&self, one: &Separator, other: &Separator, surface: &Surface) -> Vec<f64> {
        match (one, other) {
            (
                Separator::Plane { normal, offset },
                Separator::Plane {
                    normal: n,
                    offset: o,
                },
            ) => self.two_planes((*normal, *offset), (*n, *o), surface),
            (Separator::Plane { normal, offset }, Separator::Quadric(implicit))
            | (Separator::Quadric(implicit), Separator::Plane { normal, offset }) => {
                self.plane_and_conic((*normal, *offset), implicit)
            }
            (Separator::Quadric(one), Separator::Quadric(other)) => self.two_conics(one, other),
        }
    }

    fn two_planes(
        &self,
        (n, c): (Vector, f64),
        (m, d): (Vector, f64),
        surface: &Surface,
    ) -> Vec<f64> {
        let direction = cross(n, m);
        let square = dot(direction, direction);
        if square <= 1e-24 {
            return vec![];
        }
        let start = times(
            1.0 / square,
            plus(times(c, cross(m, direction)), times(d, cross(direction, n))),
        );
        if let Surface::Plane { origin, normal } = surface {
            let slope = dot(direction, *normal);
            if slope.abs() <= 1e-13 * length(direction) {
                return vec![];
            }
            let t = dot(minus(*origin, start), *normal) / slope;
            return vec![self.u_of(along(start, t, direction))];
        }
        let Some(implicit) = surface.implicit() else {
            return vec![];
        };
        let [a, b, c] = implicit.on_line(start, direction);
        let meetings = quadratic(a, b, c)
            .into_iter()
            .map(|t| self.u_of(along(start, t, direction)));
        match surface {
            // A point of the other nappe lies on the line of the opposite angle.
            Surface::Cone { .. } => meetings
                .flat_map(|u| [u, positive_angle(u + std::f64::consts::PI)])
                .collect(),
            _ => meetings.collect(),
        }
    }

    fn plane_and_conic(&self, (n, c): (Vector, f64), implicit: &Implicit) -> Vec<f64> {
        let Self::Plane { origin, e } = self else {
            return vec![];
        };
        let [n1, n2] = [dot(n, e[0]), dot(n, e[1])];
        let square = n1 * n1 + n2 * n2;
        if square <= 1e-24 {
            return vec![];
        }
        let rest = (c - dot(n, *origin)) / square;
        let start = along(along(*origin, rest * n1, e[0]), rest * n2, e[1]);
        let direction = along(times(-n2, e[0]), n1, e[1]);
        let [a, b, c] = implicit.on_line(start, direction);
        quadratic(a, b, c)
            .into_iter()
            .map(|t| self.u_of(along(start, t, direction)))
            .collect()
    }

    /// Roots of the resultant of the two quadratics in w.
    fn two_conics(&self, one: &Implicit, other: &Implicit) -> Vec<f64> {
        let Self::Plane { origin, e } = self else {
            return vec![];
        };
        let (a, b, c) = conic(one, *origin, e);
        let (d, f, g) = conic(other, *origin, e);
        let combine = |factor: f64, u: &[f64], by: f64, v: &[f64]| -> Vec<f64> {
            (0..u.len().max(v.len()))
                .map(|k| factor * u.get(k).unwrap_or(&0.0) - by * v.get(k).unwrap_or(&0.0))
                .collect()
        };
        let product = |u: &[f64], v: &[f64]| -> Vec<f64> {
            let mut all = vec![0.0; u.len() + v.len() - 1];
            for (i, x) in u.iter().enumerate() {
                for (j, y) in v.iter().enumerate() {
                    all[i + j] += x * y;
                }
            }
            all
        };
        let ag = combine(a, &g, d, &c);
        let af = combine(a, &f, d, &b);
        let bg: Vec<f64> = combine(1.0, &product(&b, &g), 1.0, &product(&f, &c));
        let resultant = combine(1.0, &product(&ag, &ag), 1.0, &product(&af, &bg));
        let reach = self.turns(&Separator::Quadric(*one));
        let other_reach = self.turns(&Separator::Quadric(*other));
        let all = || reach.iter().chain(&other_reach).copied();
        let (Some(low), Some(high)) = (all().min_by(f64::total_cmp), all().max_by(f64::total_cmp))
        else {
            return vec![];
        };
        let margin = high - low;
        roots_between(&resultant, low - margin, high + margin)
    }
}

/// A quadric on a plane as a quadratic in w: `a`, and the coefficients of `b` and `c` in u, lowest power first.
fn conic(implicit: &Implicit, origin: Vector, e: &[Vector; 2]) -> (f64, [f64; 2], [f64; 3]) {
    let [uu, u, one] = implicit.on_line(origin, e[0]);
    let [ww, w, _] = implicit.on_line(origin, e[1]);
    let [_, both, _] = implicit.on_line(along(origin, 1.0, e[0]), e[1]);
    (ww, [w, both - w], [one, u, uu])
}

/// A pole that is far from all separators, out of a fixed set of directions.
pub fn free_pole(centre: Vector, radius: f64, separators: &[Separator]) -> Vector {
    let nearest = |axis: &Vector| {
        separators
            .iter()
            .map(|separator| match separator {
                Separator::Plane { normal, offset } => {
                    let rest = (offset - dot(*normal, centre)) / radius;
                    let up = dot(*normal, *axis);
                    (up - rest).abs().min((up + rest).abs())
                }
                Separator::Quadric(_) => f64::INFINITY,
            })
            .fold(f64::INFINITY, f64::min)
    };
    // Directions spread evenly over the sphere by the golden angle.
    let directions = (0..64).map(|k| {
        let z = 1.0 - (2.0 * f64::from(k) + 1.0) / 64.0;
        let angle = 2.399_963_229_728_653 * f64::from(k) + 0.31;
        let across = (1.0 - z * z).sqrt();
        [across * angle.cos(), across * angle.sin(), z]
    });
    directions
        .max_by(|p, q| nearest(p).total_cmp(&nearest(q)))
        .map(super::vector::unit)
        .expect("there are directions")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::vector::unit;

    fn charts() -> Vec<(Surface, Chart)> {
        let axis = unit([1.0, 2.0, -2.0]);
        let surfaces = [
            Surface::Plane {
                origin: [1.0, 2.0, 3.0],
                normal: axis,
            },
            Surface::Cylinder {
                origin: [3.0, 1.0, 2.0],
                axis,
                radius: 1.5,
            },
            Surface::Cone {
                apex: [0.5, -1.0, 2.0],
                axis,
                half_angle: 0.6,
            },
            Surface::Sphere {
                centre: [1.0, 1.0, -4.0],
                radius: 2.0,
            },
        ];
        surfaces
            .into_iter()
            .map(|s| {
                let chart = Chart::of(&s, &[]).unwrap();
                (s, chart)
            })
            .collect()
    }

    #[test]
    fn points_of_a_chart_lie_on_the_surface_at_their_u() {
        for (surface, chart) in charts() {
            for k in 0..60 {
                let (u, w) = (0.1 * f64::from(k), 0.02 * f64::from(k) + 0.05);
                let p = chart.point(u, w);
                assert!(
                    length(minus(p, surface.nearest(p).unwrap())) < 1e-12,
                    "{surface:?}"
                );
                assert!((chart.u_of(p) - u).abs() < 1e-12, "{surface:?}");
            }
        }
    }

    #[test]
    fn crossings_lie_on_the_separator() {
        let normal = unit([0.3, 0.9, 0.2]);
        for (surface, chart) in charts() {
            let separator = Separator::Plane {
                normal,
                offset: dot(normal, chart.point(1.0, 0.3)),
            };
            let mut found = 0;
            for k in 0..60 {
                let u = 0.1 * f64::from(k);
                for w in chart.crossings(u, &separator) {
                    let Separator::Plane { offset, .. } = separator else {
                        unreachable!()
                    };
                    assert!(
                        (dot(normal, chart.point(u, w)) - offset).abs() < 1e-9,
                        "{surface:?}"
                    );
                    found += 1;
                }
            }
            assert!(found > 20, "{surface:?}");
        }
    }

    #[test]
    fn numbers_of_crossings_change_at_turns_alone() {
        for (surface, chart) in charts() {
            let normal = unit([0.3, 0.9, 0.2]);
            let separator = Separator::Plane {
                normal,
                offset: dot(normal, chart.point(1.0, 0.3)) + 0.4,
            };
            let turns = chart.turns(&separator);
            let count = |u: f64| chart.crossings(u, &separator).len();
            for k in 0..2000 {
                let (u, v) = (f64::from(k) * 0.003, f64::from(k + 1) * 0.003);
                if !turns.iter().any(|t| (u - 1e-9..=v + 1e-9).contains(t)) {
                    assert_eq!(count(u), count(v), "{surface:?} at {u}");
                }
            }
        }
    }

    #[test]
    fn conics_on_a_plane_meet_where_both_are_zero() {
        let plane = Surface::Plane {
            origin: [0.0; 3],
            normal: [0.0, 0.0, 1.0],
        };
        let chart = Chart::of(&plane, &[]).unwrap();
        let circle = |x: f64, radius: f64| {
            let surface = Surface::Cylinder {
                origin: [x, 0.0, 0.0],
                axis: [0.0, 0.0, 1.0],
                radius,
            };
            Separator::Quadric(surface.implicit().unwrap())
        };
        // x = 1/2, y = +-sqrt(3)/2
        let meetings = chart.meetings(&circle(0.0, 1.0), &circle(1.0, 1.0), &plane);
        for y in [-0.75_f64.sqrt(), 0.75_f64.sqrt()] {
            let u = chart.u_of([0.5, y, 0.0]);
            assert!(
                meetings.iter().any(|m| (m - u).abs() < 1e-7),
                "{meetings:?}"
            );
        }
    }
}
