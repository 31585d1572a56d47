//! A scene in the camera frame, in exact rationals.
//!
//! The camera frame has its origin in the middle of the picture, x to the right, y *down* the screen and z away from the
//! observer; its unit is one pixel. The screen plane is z = 0. A perspective eye stands at (0, 0, -D); an orthographic one
//! looks along +z. The pixel of column i and line j samples x = i - width/2, y = j - height/2.
//!
//! Directions of the camera and rotations other than quarter turns are computed once in `f64`; their matrix entries are then
//! taken as exact, so that everything derived from them is exact.

use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::{One, Signed, Zero};
use rayon::prelude::*;

use super::check::check_image_size;
use super::error::SceneError;
use super::file::{Camera, Cut, Light, Material, Object, Processor, SceneFile, Shape};
use super::framed::{FramedObject, FramedQuadric};
use super::mesh::FramedMesh;
use super::round::{FramedCylinder, FramedSphere};
use super::source::FramedSource;
use super::tetrahedron::implicit;
use super::transform::{Transform, cross, normalised};
use crate::rational::{from_decimal, integer, to_f64};

/// A scene prepared for one picture size.
#[derive(Clone, Debug, PartialEq)]
pub struct FramedScene {
    /// Title of the picture.
    pub title: String,
    /// Columns.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// How depth is projected.
    pub projection: Projection,
    /// Objects in the order of the file.
    pub objects: Vec<FramedObject>,
    /// Materials in the order of the file.
    pub materials: Vec<Material>,
    /// Light sources in the order of the file.
    pub lights: Vec<FramedLight>,
    /// The same sources for shadows: exactly where they stand, and what they reach.
    pub sources: Vec<FramedSource>,
    /// Ambient light, 0 to 1 for each of red, green, blue.
    pub ambient: [f64; 3],
    /// Colour of a pixel without object, 8 bits for each of red, green, blue.
    pub background: [u8; 3],
}

/// How the camera frame is projected on the screen plane z = 0.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Projection {
    /// From the eye (0, 0, -D).
    Perspective {
        /// D in pixels.
        distance: BigRational,
    },
    /// Along z.
    Orthographic {
        /// Depth in pixels covered on each side of the screen plane.
        half_depth: BigRational,
    },
}

/// `Q = a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j`, inside where `Q <= 0`.
///
/// A framed quadric has whole coefficients without common divisor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quadric {
    /// Coefficient of x^2.
    pub a: BigRational,
    /// Coefficient of y^2.
    pub b: BigRational,
    /// Coefficient of z^2.
    pub c: BigRational,
    /// Half the coefficient of xy.
    pub d: BigRational,
    /// Half the coefficient of xz.
    pub e: BigRational,
    /// Half the coefficient of yz.
    pub f: BigRational,
    /// Half the coefficient of x.
    pub g: BigRational,
    /// Half the coefficient of y.
    pub h: BigRational,
    /// Half the coefficient of z.
    pub i: BigRational,
    /// Constant.
    pub j: BigRational,
}

/// `a x + b y + c z + d`, kept where it is negative or zero; (a, b, c) is the outward normal.
///
/// A framed plane has whole coefficients without common divisor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plane {
    /// Coefficient of x.
    pub a: BigRational,
    /// Coefficient of y.
    pub b: BigRational,
    /// Coefficient of z.
    pub c: BigRational,
    /// Constant.
    pub d: BigRational,
}

/// A light source in the camera frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FramedLight {
    /// Parallel light.
    Directional {
        /// Unit vector towards the source.
        towards: [f64; 3],
        /// Colour times intensity.
        colour: [f64; 3],
    },
    /// Light from one point.
    Point {
        /// Position in pixels.
        position: [f64; 3],
        /// Colour times intensity.
        colour: [f64; 3],
    },
}

impl SceneFile {
    /// The scene in the camera frame of a picture of `width` by `height` pixels.
    pub fn frame(&self, width: u32, height: u32) -> Result<FramedScene, SceneError> {
        self.validate()?;
        check_image_size(width, height)?;
        let (camera, projection) = camera_frame(&self.camera, height);
        Ok(FramedScene {
            title: self.title.clone(),
            width,
            height,
            projection,
            objects: self.framed_objects(&camera)?,
            materials: self.materials.clone(),
            lights: self
                .lights
                .iter()
                .map(|light| framed_light(light, &camera))
                .collect(),
            sources: self
                .lights
                .iter()
                .map(|light| FramedSource::new(light, &camera))
                .collect(),
            ambient: self.ambient,
            background: self.background.map(|value| (value * 255.0).round() as u8),
        })
    }

    fn framed_objects(&self, camera: &Transform) -> Result<Vec<FramedObject>, SceneError> {
        self.objects
            .par_iter()
            .map(|object| {
                let material = self
                    .materials
                    .iter()
                    .position(|material| material.name == object.material)
                    .expect("validated: every material exists");
                framed_object(object, material, camera)
            })
            .collect()
    }
}

impl Quadric {
    /// The quadric that is nowhere positive: all of space.
    pub fn everywhere() -> Self {
        Self::from_array(std::array::from_fn(|_| BigRational::zero()))
    }

    /// It is zero everywhere, so that it bounds nothing.
    pub fn is_everywhere(&self) -> bool {
        self.coefficients().iter().all(|value| value.is_zero())
    }

    /// The quadric of a shape, in its local coordinates; [`Quadric::everywhere`] for a polyhedron, which has none, and nothing for a mesh.
    pub fn from_shape(shape: &Shape) -> Option<Self> {
        let one = integer(1);
        Some(match shape {
            Shape::Polyhedron => Self::everywhere(),
            Shape::Mesh(_) => return None,
            Shape::TetrahedronPatch { corners, weights } => implicit(corners, weights)?.0,
            Shape::Ellipsoid { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, b, c, -one)
            }
            Shape::Sphere { radius } => {
                let square = from_decimal(*radius).pow(2);
                Self::diagonal(one.clone(), one.clone(), one, -square)
            }
            Shape::EllipticCylinder { radii } => {
                let [a, c] = inverse_squares(radii);
                Self::diagonal(a, integer(0), c, -one)
            }
            Shape::HyperbolicCylinder { radii } => {
                let [a, c] = inverse_squares(radii);
                Self::diagonal(a, integer(0), -c, -one)
            }
            Shape::ParabolicCylinder { radii } => {
                let [a, _] = inverse_squares(radii);
                let mut quadric = Self::diagonal(a, integer(0), integer(0), integer(0));
                quadric.i = minus_half_inverse(radii[1]);
                quadric
            }
            Shape::Cone { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, -b, c, integer(0))
            }
            Shape::HyperboloidOneSheet { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, -b, c, -one)
            }
            Shape::HyperboloidTwoSheets { radii } => {
                let [a, b, c] = inverse_squares(radii);
                Self::diagonal(a, -b, c, one)
            }
            Shape::EllipticParaboloid { radii } => {
                let [a, _, c] = inverse_squares(radii);
                let mut quadric = Self::diagonal(a, integer(0), c, integer(0));
                quadric.h = minus_half_inverse(radii[1]);
                quadric
            }
            Shape::HyperbolicParaboloid { radii } => {
                let [a, _, c] = inverse_squares(radii);
                let mut quadric = Self::diagonal(a, integer(0), -c, integer(0));
                quadric.h = minus_half_inverse(radii[1]);
                quadric
            }
            Shape::Quadric { coefficients } => Self::from_array(coefficients.map(from_decimal)),
        })
    }

    /// The value of Q at a point, exactly.
    pub fn value_at(&self, x: &BigRational, y: &BigRational, z: &BigRational) -> BigRational {
        let along_x = &self.a * x + (&self.d * y + &self.e * z + &self.g) * integer(2);
        let along_y = &self.b * y + (&self.f * z + &self.h) * integer(2);
        let along_z = &self.c * z + &self.i * integer(2);
        along_x * x + along_y * y + along_z * z + &self.j
    }

    /// The same volume after the change of frame `P' = M P`.
    ///
    /// `cof(M) Q cof(M)^T` is the exact image times det(M)^2, a positive factor that changes neither surface nor inside. The
    /// source prints `M^-1 Q M^-1t`, which holds for row points only (section 5.1.2).
    pub fn transformed(&self, transform: &Transform) -> Self {
        let (cofactors, unit) = transform.whole_cofactors();
        let [a, b, c, d, e, f, g, h, i, j] = self.coefficients();
        let denominator = [a, b, c, d, e, f, g, h, i, j]
            .iter()
            .fold(BigInt::one(), |lcm, value| lcm.lcm(value.denom()));
        let matrix = self
            .matrix()
            .map(|row| row.map(|value| value.numer() * (&denominator / value.denom())));
        // Whole numbers are multiplied and divided once: reducing fractions on the way would take most of the time.
        let entry = |row: usize, column: usize| {
            let sum: BigInt = (0..16)
                .map(|k| &cofactors[row][k / 4] * &matrix[k / 4][k % 4] * &cofactors[column][k % 4])
                .sum();
            BigRational::new_raw(sum, &unit * &unit * &denominator)
        };
        let order = [
            (0, 0),
            (1, 1),
            (2, 2),
            (0, 1),
            (0, 2),
            (1, 2),
            (0, 3),
            (1, 3),
            (2, 3),
            (3, 3),
        ];
        Self::from_array(order.map(|(row, column)| entry(row, column)))
    }

    /// The quadric of a symmetric matrix.
    pub(super) fn from_matrix(matrix: [[BigRational; 4]; 4]) -> Self {
        let [[a, d, e, g], [_, b, f, h], [_, _, c, i], [_, _, _, j]] = matrix;
        Self::from_array([a, b, c, d, e, f, g, h, i, j])
    }

    /// The coefficients a to j.
    pub fn coefficients(&self) -> [&BigRational; 10] {
        [
            &self.a, &self.b, &self.c, &self.d, &self.e, &self.f, &self.g, &self.h, &self.i,
            &self.j,
        ]
    }

    /// The symmetric matrix of Q.
    pub fn matrix(&self) -> [[BigRational; 4]; 4] {
        let Self {
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i,
            j,
        } = self;
        [[a, d, e, g], [d, b, f, h], [e, f, c, i], [g, h, i, j]]
            .map(|row| row.map(BigRational::clone))
    }

    /// The positive multiple with whole coefficients without common divisor.
    pub fn primitive(self) -> Self {
        Self::from_array(primitive(self.coefficients().map(BigRational::clone)))
    }

    pub(super) fn diagonal(a: BigRational, b: BigRational, c: BigRational, j: BigRational) -> Self {
        let [d, e, f, g, h, i] = std::array::from_fn(|_| BigRational::zero());
        Self {
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i,
            j,
        }
    }

    /// The quadric of the coefficients a to j.
    pub fn from_array([a, b, c, d, e, f, g, h, i, j]: [BigRational; 10]) -> Self {
        Self {
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            i,
            j,
        }
    }
}

impl Plane {
    /// The plane of a cut, in the local coordinates of the object.
    pub fn from_cut(cut: &Cut) -> Self {
        let [a, b, c] = cut.normal.map(from_decimal);
        let [x, y, z] = cut.point.map(from_decimal);
        let d = -(&a * x + &b * y + &c * z);
        Self { a, b, c, d }
    }

    /// The value of `a x + b y + c z + d` at a point, exactly.
    pub fn value_at(&self, x: &BigRational, y: &BigRational, z: &BigRational) -> BigRational {
        &self.a * x + &self.b * y + &self.c * z + &self.d
    }

    /// The same half-space after the change of frame `P' = M P`.
    ///
    /// `cof(M) p` is the exact image times det(M): a mirror would exchange the kept and the removed side, so the sign of the
    /// determinant is put back, which the source omits (section 5.1.2).
    pub fn transformed(&self, transform: &Transform) -> Self {
        let column = [&self.a, &self.b, &self.c, &self.d];
        let sign = transform.determinant().signum();
        let [a, b, c, d] = transform.cofactors().map(|row| {
            let value: BigRational = row.iter().zip(column).map(|(m, p)| m * p).sum();
            value * &sign
        });
        Self { a, b, c, d }
    }

    /// The coefficients a to d.
    pub fn coefficients(&self) -> [&BigRational; 4] {
        [&self.a, &self.b, &self.c, &self.d]
    }

    /// The positive multiple with whole coefficients without common divisor.
    pub fn primitive(self) -> Self {
        let [a, b, c, d] = primitive(self.coefficients().map(BigRational::clone));
        Self { a, b, c, d }
    }
}

/// The change from scene to camera coordinates.
fn camera_frame(camera: &Camera, height: u32) -> (Transform, Projection) {
    let height = integer(i64::from(height));
    match camera {
        Camera::Perspective {
            eye,
            target,
            up,
            viewer_distance,
            view_height,
        } => {
            let pixels_per_unit = height / from_decimal(*view_height);
            let distance = from_decimal(*viewer_distance) * &pixels_per_unit;
            // The eye, not the screen plane, is the fixed point: it then stands exactly at (0, 0, -D).
            let behind = [integer(0), integer(0), -distance.clone()];
            let frame = Transform::translation(behind).after(&looking(
                *eye,
                *target,
                *up,
                *eye,
                &pixels_per_unit,
            ));
            (frame, Projection::Perspective { distance })
        }
        Camera::Orthographic {
            eye,
            target,
            up,
            view_height,
            half_depth,
        } => {
            let pixels_per_unit = height / from_decimal(*view_height);
            let half_depth = from_decimal(*half_depth) * &pixels_per_unit;
            let frame = looking(*eye, *target, *up, *target, &pixels_per_unit);
            (frame, Projection::Orthographic { half_depth })
        }
    }
}

/// The frame with its origin at `origin`, z from `eye` to `target`, and `up` towards -y.
fn looking(
    eye: [f64; 3],
    target: [f64; 3],
    up: [f64; 3],
    origin: [f64; 3],
    pixels_per_unit: &BigRational,
) -> Transform {
    let forward = normalised(std::array::from_fn(|axis| target[axis] - eye[axis]));
    let right = normalised(cross(forward, normalised(up)));
    let down = cross(forward, right);
    let to_origin = Transform::translation(origin.map(|value| -from_decimal(value)));
    let turned = Transform::linear([right, down, forward]).after(&to_origin);
    Transform::scaling(std::array::from_fn(|_| pixels_per_unit.clone())).after(&turned)
}

fn framed_object(
    object: &Object,
    material: usize,
    camera: &Transform,
) -> Result<FramedObject, SceneError> {
    let to_camera = camera.after(&Transform::placement(&object.place));
    let name = &object.name;
    let cut = || cut_quadric(object, material, &to_camera);
    Ok(match (&object.shape, object.drawn_by()) {
        (Shape::Mesh(mesh), _) => {
            FramedObject::Mesh(FramedMesh::new(name, material, mesh, &to_camera))
        }
        (Shape::Polyhedron, _) | (_, None) => FramedObject::Polyhedron(cut()),
        (_, Some(Processor::Quadric)) => FramedObject::Quadric(cut()),
        (_, Some(Processor::Patch)) => FramedObject::Patch(cut()),
        (_, Some(Processor::FirstGeneration)) => FramedObject::FirstGeneration(cut()),
        (Shape::Sphere { radius }, Some(Processor::Paraboloid)) => {
            FramedObject::Sphere(FramedSphere::new(name, material, *radius, &to_camera))
        }
        (Shape::Sphere { radius }, Some(Processor::CurvedFacet)) => {
            FramedObject::CurvedSphere(FramedSphere::new(name, material, *radius, &to_camera))
        }
        (Shape::EllipticCylinder { radii }, Some(Processor::Paraboloid)) => {
            let ends = [&object.cuts[0], &object.cuts[1]].map(|cut| from_decimal(cut.point[1]));
            let cylinder = FramedCylinder::new(name, material, *radii, ends, &to_camera)?;
            FramedObject::Cylinder(cylinder)
        }
        (_, Some(Processor::Paraboloid | Processor::CurvedFacet)) => {
            let facet = cut();
            check_one_depth(&facet)?;
            FramedObject::CurvedFacet(facet)
        }
    })
}

/// An object that is a quadric bounded by planes.
fn cut_quadric(object: &Object, material: usize, to_camera: &Transform) -> FramedQuadric {
    let local = match &object.shape {
        Shape::TetrahedronPatch { corners, weights } => {
            let (_, planes) = implicit(corners, weights).expect("checked: no flat tetrahedron");
            planes.to_vec()
        }
        _ => object.cuts.iter().map(Plane::from_cut).collect(),
    };
    let corners = match &object.shape {
        Shape::TetrahedronPatch { corners, .. } => Some(Box::new(
            corners.map(|c| to_camera.point(&c.map(from_decimal))),
        )),
        _ => None,
    };
    FramedQuadric {
        name: object.name.clone(),
        surface: object.mode,
        quadric: Quadric::from_shape(&object.shape)
            .expect("a mesh is framed apart")
            .transformed(to_camera)
            .primitive(),
        planes: local
            .iter()
            .map(|plane| plane.transformed(to_camera).primitive())
            .collect(),
        corners,
        material,
        casts_shadow: object.casts_shadow,
    }
}

/// Refuses a non-planar facet whose depth is not of second degree in the pixel's place.
fn check_one_depth(facet: &FramedQuadric) -> Result<(), SceneError> {
    let q = &facet.quadric;
    let place = format!("object `{}`, processor", facet.name);
    if [&q.c, &q.e, &q.f].iter().any(|v| !v.is_zero()) || q.i.is_zero() {
        return Err(SceneError::value(
            place,
            "the depth of this surface is not of second degree in the place on the screen",
            "\"curved_facet\" draws a sphere, or a quadric that depends on the depth in the first degree alone, \
             such as a paraboloid seen exactly along its axis",
        ));
    }
    if let Some(index) = facet.planes.iter().position(|p| !p.c.is_zero()) {
        return Err(SceneError::value(
            format!("object `{}`, cuts[{index}]", facet.name),
            "the plane is not perpendicular to the screen",
            "the cuts of a \"curved_facet\" are its sides on the screen: planes along the viewing direction",
        ));
    }
    Ok(())
}

fn framed_light(light: &Light, camera: &Transform) -> FramedLight {
    match light {
        Light::Directional {
            from,
            colour,
            intensity,
            ..
        } => FramedLight::Directional {
            towards: normalised(
                camera
                    .vector(&from.map(from_decimal))
                    .map(|value| to_f64(&value)),
            ),
            colour: colour.map(|value| value * intensity),
        },
        Light::Point {
            position,
            colour,
            intensity,
            ..
        }
        // Within its cone a spot is a point; the cone is a volume.
        | Light::Spot {
            position,
            colour,
            intensity,
            ..
        } => FramedLight::Point {
            position: camera
                .point(&position.map(from_decimal))
                .map(|value| to_f64(&value)),
            colour: colour.map(|value| value * intensity),
        },
    }
}

fn inverse_squares<const N: usize>(radii: &[f64; N]) -> [BigRational; N] {
    radii.map(|radius| from_decimal(radius).pow(2).recip())
}

/// Linear terms count twice in a quadric, so `-y/B` has the coefficient `-1/(2B)`.
fn minus_half_inverse(radius: f64) -> BigRational {
    -(from_decimal(radius) * integer(2)).recip()
}

/// The positive multiple of `values` that is whole and without common divisor; zeros stay as they are.
fn primitive<const N: usize>(values: [BigRational; N]) -> [BigRational; N] {
    let denominator = values
        .iter()
        .fold(BigInt::one(), |lcm, value| lcm.lcm(value.denom()));
    let numerators = values.map(|value| value.numer() * (&denominator / value.denom()));
    let divisor = numerators.iter().fold(BigInt::zero(), |gcd, value| {
        if gcd.is_one() { gcd } else { gcd.gcd(value) }
    });
    if divisor.is_zero() {
        return numerators.map(BigRational::from_integer);
    }
    numerators.map(|value| BigRational::from_integer(value / &divisor))
}
