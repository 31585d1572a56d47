//! Support surfaces of faces.

use super::vector::*;

/// What a face lies on.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// A point of a plane or of the axis; the apex of a cone, the centre of a sphere or torus.
    pub origin: Vector,
    /// Unit vector: the outer normal of a plane, the axis (of a cone into its nappe), or a pole of a sphere.
    pub axis: Vector,
    /// Its kind with its sizes.
    pub form: Form,
}

/// Kinds of surfaces.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Form {
    /// All points `p` with `(p - origin) . axis = 0`.
    #[default]
    Plane,
    /// A right circular cylinder, endless, of a radius above 0.
    Cylinder(f64),
    /// One nappe of a right circular cone: the angle between axis and surface, radians, up to a right angle.
    Cone(f64),
    /// A sphere of a radius above 0.
    Sphere(f64),
    /// A torus, which is drawn as bands of cones: the radius of the middle of the tube, below 0 for the inner part of
    /// a torus that meets its axis, and that of the tube, above 0.
    Torus(f64, f64),
    /// A surface that is not drawn, by its name.
    Other(String),
}

/// `a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j`, negative inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Implicit(pub [f64; 10]);

impl Implicit {
    /// The value at a point.
    pub fn value(&self, p: Vector) -> f64 {
        self.on_line(p, [0.0; 3])[2]
    }

    /// The matrix of the second degree times a vector.
    fn quadratic(&self, u: Vector) -> Vector {
        let [a, b, c, d, e, f, ..] = self.0;
        [[a, d, e], [d, b, f], [e, f, c]].map(|row| dot(row, u))
    }

    /// Half the gradient at a point.
    pub fn half_gradient(&self, p: Vector) -> Vector {
        let [.., g, h, i, _] = self.0;
        plus(self.quadratic(p), [g, h, i])
    }

    /// The value on `p + t v` as `[A, B, C]` of `A t^2 + B t + C`.
    pub fn on_line(&self, p: Vector, v: Vector) -> [f64; 3] {
        let [.., g, h, i, j] = self.0;
        let (linear, of_p) = ([g, h, i], self.quadratic(p));
        [
            dot(v, self.quadratic(v)),
            2.0 * (dot(v, of_p) + dot(linear, v)),
            dot(p, of_p) + 2.0 * dot(linear, p) + j,
        ]
    }

    /// The side that is kept: that where it is negative, or the other, inside and outside exchanged.
    pub fn kept(&self, positive: bool) -> Implicit {
        // Zero stays without sign, so that the written scene has no "-0".
        let turned = |value: f64| if positive { 0.0 - value } else { value };
        Implicit(self.0.map(turned))
    }

    /// `one * identity - by * axis axis^T`, centred at `centre`, and the constant there.
    fn centred(axis: Vector, by: f64, centre: Vector, constant: f64) -> Implicit {
        let entry = |r: usize, c: usize| {
            let product = by * axis[r] * axis[c];
            let value = if r == c { 1.0 - product } else { -product };
            if value == 0.0 { 0.0 } else { value }
        };
        let matrix = [0, 1, 2].map(|r| [0, 1, 2].map(|c| entry(r, c)));
        let [[a, d, e], [_, b, f], [_, _, c]] = matrix;
        let linear = matrix.map(|row| -dot(row, centre));
        let [g, h, i] = linear;
        Implicit([a, b, c, d, e, f, g, h, i, constant - dot(linear, centre)])
    }
}

impl Surface {
    /// Of a kind, with its point and its direction.
    pub fn new(origin: Vector, axis: Vector, form: Form) -> Surface {
        Surface { origin, axis, form }
    }

    /// A surface that is named only.
    pub fn other(name: impl Into<String>) -> Surface {
        Surface::new([0.0; 3], [0.0; 3], Form::Other(name.into()))
    }

    /// Its word in a face list and in reports.
    pub fn name(&self) -> &str {
        match &self.form {
            Form::Plane => "plane",
            Form::Cylinder(_) => "cylinder",
            Form::Cone(_) => "cone",
            Form::Sphere(_) => "sphere",
            Form::Torus(..) => "torus",
            Form::Other(name) => name,
        }
    }

    /// Point and normal of a plane.
    pub fn plane(&self) -> Option<(Vector, Vector)> {
        self.is_plane().then_some((self.origin, self.axis))
    }

    /// It is a plane.
    pub fn is_plane(&self) -> bool {
        self.form == Form::Plane
    }

    /// It is one nappe of a cone.
    pub fn is_cone(&self) -> bool {
        matches!(self.form, Form::Cone(_))
    }

    /// It is a sphere.
    pub fn is_sphere(&self) -> bool {
        matches!(self.form, Form::Sphere(_))
    }

    /// It is a torus.
    pub fn is_torus(&self) -> bool {
        matches!(self.form, Form::Torus(..))
    }

    /// The quadric, negative inside, of a cone with both nappes; nothing for a plane or another surface.
    pub fn implicit(&self) -> Option<Implicit> {
        let Surface { origin, axis, .. } = *self;
        match self.form {
            // The point of the axis nearest to the frame's origin has the shortest numbers.
            Form::Cylinder(radius) => {
                let centre = across(origin, axis);
                Some(Implicit::centred(axis, 1.0, centre, -radius * radius))
            }
            Form::Cone(half_angle) => {
                let slope = clean_tangent(half_angle);
                Some(Implicit::centred(axis, 1.0 + slope * slope, origin, 0.0))
            }
            Form::Sphere(r) => Some(Implicit::centred([0.0; 3], 0.0, origin, -r * r)),
            Form::Plane | Form::Torus(..) | Form::Other(_) => None,
        }
    }

    /// The middle of the tube of a torus nearest to a point; nothing on the axis.
    fn spine(&self, major: f64, p: Vector) -> Option<Vector> {
        let out = outwards(across(minus(p, self.origin), self.axis))?;
        Some(along(self.origin, major, out))
    }

    /// The unit normal at a point of the surface, away from axis or centre; nothing at an apex and for another surface.
    pub fn normal_at(&self, p: Vector) -> Option<Vector> {
        match self.form {
            Form::Plane => Some(self.axis),
            Form::Torus(major, _) => outwards(minus(p, self.spine(major, p)?)),
            _ => outwards(self.implicit()?.half_gradient(p)),
        }
    }

    /// The point of the surface nearest to `p`; nothing for another surface and on an axis, which has no nearest point.
    pub fn nearest(&self, p: Vector) -> Option<Vector> {
        let from = minus(p, self.origin);
        let out = across(from, self.axis);
        match self.form {
            Form::Plane => Some(onto_plane(p, self.origin, self.axis)),
            Form::Cylinder(radius) => Some(along(minus(p, out), radius, outwards(out)?)),
            Form::Cone(half_angle) => {
                let Some(out) = outwards(out) else {
                    return (length(from) == 0.0).then_some(self.origin);
                };
                let (sine, cosine) = half_angle.sin_cos();
                let ray = along(times(cosine, self.axis), sine, out);
                Some(along(self.origin, dot(from, ray).max(0.0), ray))
            }
            Form::Sphere(radius) => Some(along(self.origin, radius, outwards(from)?)),
            Form::Torus(major, minor) => {
                let spine = self.spine(major, p)?;
                Some(along(spine, minor, outwards(minus(p, spine))?))
            }
            Form::Other(_) => None,
        }
    }

    /// The surface at a distance along its own normal; `None` if there is none.
    pub fn offset(&self, by: f64) -> Option<Surface> {
        let wider = |radius: f64| (radius + by > 0.0).then_some(radius + by);
        let mut origin = self.origin;
        let form = match &self.form {
            Form::Plane => {
                origin = along(origin, by, self.axis);
                Form::Plane
            }
            Form::Cylinder(radius) => Form::Cylinder(wider(*radius)?),
            Form::Cone(half_angle) => {
                origin = along(origin, -by / half_angle.sin(), self.axis);
                Form::Cone(*half_angle)
            }
            Form::Sphere(radius) => Form::Sphere(wider(*radius)?),
            Form::Torus(major, minor) => Form::Torus(*major, wider(*minor)?),
            Form::Other(_) => return None,
        };
        Some(Surface::new(origin, self.axis, form))
    }

    /// Whether two surfaces are the same within a length.
    pub fn same(&self, other: &Surface, tolerance: f64) -> bool {
        let apart = minus(self.origin, other.origin);
        let parallel = length(cross(self.axis, other.axis)) <= 1e-9;
        let near = |a: f64, b: f64| (a - b).abs() <= tolerance;
        match (&self.form, &other.form) {
            (Form::Plane, Form::Plane) => parallel && dot(apart, other.axis).abs() <= tolerance,
            (Form::Cylinder(r), Form::Cylinder(s)) => {
                parallel && near(*r, *s) && length(across(apart, other.axis)) <= tolerance
            }
            (Form::Cone(a), Form::Cone(b)) => {
                let one_way = parallel && dot(self.axis, other.axis) > 0.0;
                one_way && (a - b).abs() <= 1e-9 && length(apart) <= tolerance
            }
            (Form::Sphere(r), Form::Sphere(s)) => near(*r, *s) && length(apart) <= tolerance,
            (Form::Torus(r, s), Form::Torus(t, u)) => {
                parallel && near(*r, *t) && near(*s, *u) && length(apart) <= tolerance
            }
            _ => false,
        }
    }

    /// The greatest distance of places from the surface; 0 for a surface that is not known.
    pub fn gap(&self, places: &[Vector]) -> f64 {
        let off = |p: &Vector| match (self.nearest(*p), &self.form) {
            (Some(q), _) => distance(*p, q),
            // On the axis: as far as the surface is from it.
            (None, Form::Cylinder(radius) | Form::Sphere(radius)) => *radius,
            _ => 0.0,
        };
        places.iter().map(off).fold(0.0, f64::max)
    }
}

/// The direction of a vector that has one.
fn outwards(out: Vector) -> Option<Vector> {
    (length(out) > 0.0).then(|| unit(out))
}

/// The tangent of an angle, exactly 1 at 45 degrees: the rounding of pi does not belong in a coefficient.
pub fn clean_tangent(angle: f64) -> f64 {
    let tangent = angle.tan();
    let rounded = (tangent * 1e12).round() / 1e12;
    let is_near = (tangent - rounded).abs() <= 4.0 * f64::EPSILON * tangent;
    if is_near { rounded } else { tangent }
}
