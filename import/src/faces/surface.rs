//! Support surfaces of faces.

use super::vector::{Vector, across, along, cross, dot, length, minus, onto_plane, times, unit};

/// What a face lies on. Directions have length 1.
#[derive(Clone, Debug, PartialEq)]
pub enum Surface {
    /// All points `p` with `(p - origin) . normal = 0`; the outside is where the normal points.
    Plane {
        /// A point.
        origin: Vector,
        /// Normal.
        normal: Vector,
    },
    /// A right circular cylinder, endless.
    Cylinder {
        /// A point of the axis.
        origin: Vector,
        /// Direction of the axis.
        axis: Vector,
        /// Radius, above 0.
        radius: f64,
    },
    /// A right circular cone: the nappe into which `axis` points.
    Cone {
        /// Apex.
        apex: Vector,
        /// Direction of the axis, from the apex into the nappe.
        axis: Vector,
        /// Angle between the axis and the surface, radians, between 0 and a right angle.
        half_angle: f64,
    },
    /// A sphere.
    Sphere {
        /// Centre.
        centre: Vector,
        /// Radius, above 0.
        radius: f64,
    },
    /// A torus, which is drawn as bands of cones.
    Torus {
        /// Centre.
        centre: Vector,
        /// Direction of the axis.
        axis: Vector,
        /// Radius of the middle of the tube; below 0 for the inner part of a torus that meets its axis.
        major: f64,
        /// Radius of the tube, above 0.
        minor: f64,
    },
    /// A surface that is not drawn, by its name.
    Other(String),
}

/// `a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j`, negative inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Implicit(pub [f64; 10]);

impl Implicit {
    /// The value at a point.
    pub fn value(&self, p: Vector) -> f64 {
        let [_, _, c] = self.on_line(p, [0.0; 3]);
        c
    }

    /// Half the gradient at a point.
    pub fn half_gradient(&self, [x, y, z]: Vector) -> Vector {
        let [a, b, c, d, e, f, g, h, i, _] = self.0;
        [
            a * x + d * y + e * z + g,
            d * x + b * y + f * z + h,
            e * x + f * y + c * z + i,
        ]
    }

    /// The value on `p + t v` as `[A, B, C]` of `A t^2 + B t + C`.
    pub fn on_line(&self, p: Vector, v: Vector) -> [f64; 3] {
        let [a, b, c, d, e, f, g, h, i, j] = self.0;
        let form = |u: Vector| {
            [
                a * u[0] + d * u[1] + e * u[2],
                d * u[0] + b * u[1] + f * u[2],
                e * u[0] + f * u[1] + c * u[2],
            ]
        };
        let linear = [g, h, i];
        let of_p = form(p);
        [
            dot(v, form(v)),
            2.0 * (dot(v, of_p) + dot(linear, v)),
            dot(p, of_p) + 2.0 * dot(linear, p) + j,
        ]
    }

    /// The same surface with inside and outside exchanged.
    pub fn negated(&self) -> Implicit {
        // Zero stays without sign, so that the written scene has no "-0".
        Implicit(self.0.map(|value| if value == 0.0 { 0.0 } else { -value }))
    }

    /// From the matrix of the second degree, centred at `centre`, and the constant there.
    fn centred(matrix: [Vector; 3], centre: Vector, constant: f64) -> Implicit {
        let linear: Vector = std::array::from_fn(|k| -dot(matrix[k], centre));
        Implicit([
            matrix[0][0],
            matrix[1][1],
            matrix[2][2],
            matrix[0][1],
            matrix[0][2],
            matrix[1][2],
            linear[0],
            linear[1],
            linear[2],
            constant - dot(linear, centre),
        ])
    }
}

/// `one * identity - by * axis axis^T`.
fn projector(axis: Vector, one: f64, by: f64) -> [Vector; 3] {
    std::array::from_fn(|r| {
        std::array::from_fn(|c| {
            let product = by * axis[r] * axis[c];
            let value = if r == c { one - product } else { -product };
            if value == 0.0 { 0.0 } else { value }
        })
    })
}

impl Surface {
    /// Its word in a face list and in reports.
    pub fn name(&self) -> &str {
        match self {
            Self::Plane { .. } => "plane",
            Self::Cylinder { .. } => "cylinder",
            Self::Cone { .. } => "cone",
            Self::Sphere { .. } => "sphere",
            Self::Torus { .. } => "torus",
            Self::Other(name) => name,
        }
    }

    /// It is a plane.
    pub fn is_plane(&self) -> bool {
        matches!(self, Self::Plane { .. })
    }

    /// The quadric, negative on the side of the axis or centre; nothing for a plane or another surface. That of a cone
    /// has both nappes.
    pub fn implicit(&self) -> Option<Implicit> {
        match *self {
            Self::Cylinder {
                origin,
                axis,
                radius,
            } => Some(Implicit::centred(
                projector(axis, 1.0, 1.0),
                // The point of the axis nearest to the frame's origin has the shortest numbers.
                across(origin, axis),
                -radius * radius,
            )),
            Self::Cone {
                apex,
                axis,
                half_angle,
            } => {
                let slope = clean_tangent(half_angle);
                let matrix = projector(axis, 1.0, 1.0 + slope * slope);
                Some(Implicit::centred(matrix, apex, 0.0))
            }
            Self::Sphere { centre, radius } => {
                let identity = projector([0.0; 3], 1.0, 0.0);
                Some(Implicit::centred(identity, centre, -radius * radius))
            }
            Self::Plane { .. } | Self::Torus { .. } | Self::Other(_) => None,
        }
    }

    /// The middle of the tube of a torus nearest to a point; nothing on the axis.
    fn spine(centre: Vector, axis: Vector, major: f64, p: Vector) -> Option<Vector> {
        let out = across(minus(p, centre), axis);
        (length(out) > 0.0).then(|| along(centre, major, unit(out)))
    }

    /// The unit normal at a point of the surface, away from axis or centre; nothing at an apex and for another surface.
    pub fn normal_at(&self, p: Vector) -> Option<Vector> {
        if let Self::Plane { normal, .. } = *self {
            return Some(normal);
        }
        if let Self::Torus {
            centre,
            axis,
            major,
            ..
        } = *self
        {
            let out = minus(p, Self::spine(centre, axis, major, p)?);
            return (length(out) > 0.0).then(|| unit(out));
        }
        let gradient = self.implicit()?.half_gradient(p);
        (length(gradient) > 0.0).then(|| unit(gradient))
    }

    /// The point of the surface nearest to `p`; nothing for another surface and on an axis, which has no nearest point.
    pub fn nearest(&self, p: Vector) -> Option<Vector> {
        match *self {
            Self::Plane { origin, normal } => Some(onto_plane(p, origin, normal)),
            Self::Cylinder {
                origin,
                axis,
                radius,
            } => {
                let out = across(minus(p, origin), axis);
                let foot = minus(p, out);
                (length(out) > 0.0).then(|| along(foot, radius, unit(out)))
            }
            Self::Cone {
                apex,
                axis,
                half_angle,
            } => {
                let from = minus(p, apex);
                let out = across(from, axis);
                if length(out) == 0.0 {
                    return (length(from) == 0.0).then_some(apex);
                }
                let (sine, cosine) = half_angle.sin_cos();
                let ray = along(times(cosine, axis), sine, unit(out));
                Some(along(apex, dot(from, ray).max(0.0), ray))
            }
            Self::Sphere { centre, radius } => {
                let out = minus(p, centre);
                (length(out) > 0.0).then(|| along(centre, radius, unit(out)))
            }
            Self::Torus {
                centre,
                axis,
                major,
                minor,
            } => {
                let spine = Self::spine(centre, axis, major, p)?;
                let out = minus(p, spine);
                (length(out) > 0.0).then(|| along(spine, minor, unit(out)))
            }
            Self::Other(_) => None,
        }
    }

    /// The surface at a distance along its own normal; nothing if there is none.
    pub fn offset(&self, by: f64) -> Option<Surface> {
        let wider = |radius: f64| (radius + by > 0.0).then_some(radius + by);
        Some(match *self {
            Self::Plane { origin, normal } => Self::Plane {
                origin: along(origin, by, normal),
                normal,
            },
            Self::Cylinder {
                origin,
                axis,
                radius,
            } => Self::Cylinder {
                origin,
                axis,
                radius: wider(radius)?,
            },
            Self::Cone {
                apex,
                axis,
                half_angle,
            } => Self::Cone {
                apex: along(apex, -by / half_angle.sin(), axis),
                axis,
                half_angle,
            },
            Self::Sphere { centre, radius } => Self::Sphere {
                centre,
                radius: wider(radius)?,
            },
            Self::Torus {
                centre,
                axis,
                major,
                minor,
            } => Self::Torus {
                centre,
                axis,
                major,
                minor: wider(minor)?,
            },
            Self::Other(_) => return None,
        })
    }

    /// Whether two surfaces are the same within a length.
    pub fn same(&self, other: &Surface, tolerance: f64) -> bool {
        let parallel = |u, v| length(cross(u, v)) <= 1e-9;
        match (self, other) {
            (
                Self::Plane { origin, normal },
                Self::Plane {
                    origin: o,
                    normal: n,
                },
            ) => parallel(*normal, *n) && dot(minus(*origin, *o), *n).abs() <= tolerance,
            (
                Self::Cylinder {
                    origin,
                    axis,
                    radius,
                },
                Self::Cylinder {
                    origin: o,
                    axis: a,
                    radius: r,
                },
            ) => {
                parallel(*axis, *a)
                    && (radius - r).abs() <= tolerance
                    && length(across(minus(*origin, *o), *a)) <= tolerance
            }
            (
                Self::Cone {
                    apex,
                    axis,
                    half_angle,
                },
                Self::Cone {
                    apex: o,
                    axis: a,
                    half_angle: h,
                },
            ) => {
                parallel(*axis, *a)
                    && dot(*axis, *a) > 0.0
                    && (half_angle - h).abs() <= 1e-9
                    && length(minus(*apex, *o)) <= tolerance
            }
            (
                Self::Sphere { centre, radius },
                Self::Sphere {
                    centre: o,
                    radius: r,
                },
            ) => (radius - r).abs() <= tolerance && length(minus(*centre, *o)) <= tolerance,
            (
                Self::Torus {
                    centre,
                    axis,
                    major,
                    minor,
                },
                Self::Torus {
                    centre: o,
                    axis: a,
                    major: m,
                    minor: n,
                },
            ) => {
                parallel(*axis, *a)
                    && (major - m).abs().max((minor - n).abs()) <= tolerance
                    && length(minus(*centre, *o)) <= tolerance
            }
            _ => false,
        }
    }
}

/// The tangent of an angle, exactly 1 at 45 degrees: its square is a coefficient, and the rounding of pi does not
/// belong in it.
pub fn clean_tangent(angle: f64) -> f64 {
    let tangent = angle.tan();
    let rounded = (tangent * 1e12).round() / 1e12;
    if (tangent - rounded).abs() <= 4.0 * f64::EPSILON * tangent {
        rounded
    } else {
        tangent
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faces::vector::{distance, frame};

    fn surfaces() -> Vec<Surface> {
        let axis = unit([1.0, 2.0, -2.0]);
        vec![
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
        ]
    }

    #[test]
    fn nearest_points_lie_on_the_quadric_along_its_normal() {
        for surface in surfaces() {
            let implicit = surface.implicit().unwrap();
            for k in 0..50 {
                let t = f64::from(k);
                let p = [
                    t.sin() * 3.0 + 4.0,
                    t.cos() * 2.0 - 3.0,
                    (0.7 * t).sin() * 4.0,
                ];
                let q = surface.nearest(p).unwrap();
                assert!(implicit.value(q).abs() < 1e-12, "{surface:?}");
                let Some(normal) = surface.normal_at(q) else {
                    continue;
                };
                let off = minus(p, q);
                let is_apex =
                    matches!(&surface, Surface::Cone { apex, .. } if distance(q, *apex) < 1e-12);
                assert!(is_apex || length(cross(off, normal)) < 1e-9, "{surface:?}");
            }
        }
    }

    #[test]
    fn a_point_on_the_axis_is_inside() {
        for surface in surfaces() {
            let inside = match surface {
                Surface::Cylinder { origin, .. } => origin,
                Surface::Cone { apex, axis, .. } => along(apex, 2.0, axis),
                Surface::Sphere { centre, .. } => centre,
                _ => unreachable!(),
            };
            let implicit = surface.implicit().unwrap();
            assert!(implicit.value(inside) < 0.0);
            assert!(implicit.negated().value(inside) > 0.0);
        }
    }

    #[test]
    fn cones_of_forty_five_degrees_have_whole_coefficients() {
        let cone = Surface::Cone {
            apex: [0.0; 3],
            axis: [0.0, 1.0, 0.0],
            half_angle: 45.0_f64.to_radians(),
        };
        assert_eq!(cone.implicit().unwrap().0[..3], [1.0, -1.0, 1.0]);
    }

    #[test]
    fn frames_are_right_handed() {
        let axis = unit([0.3, -0.2, 0.9]);
        let [e1, e2] = frame(axis, 0.4);
        assert!(distance(cross(e1, e2), axis) < 1e-14);
    }
}
