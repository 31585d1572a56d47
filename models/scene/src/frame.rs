//! A scene in the camera frame, in exact rationals.
//!
//! The camera frame has its origin in the middle of the picture, x to the right, y *down* the screen and z away from
//! the observer; its unit is one pixel. The screen plane is z = 0. A perspective eye stands at (0, 0, -D); an
//! orthographic one looks along +z. The pixel of column i and line j samples x = i - width/2, y = j - height/2. For a
//! camera that samples elsewhere in its pixels the whole frame is moved there: parallel to the screen plane, and so
//! far at each depth that the screen moves by as much. In perspective that is a shear about the eye.
//!
//! Directions of the camera and rotations other than quarter turns are computed once in `f64`; their matrix entries
//! are then taken as exact, so that everything derived from them is exact.

use super::camera::{Camera, Lens, Sight};
use super::error::SceneError;
use super::file::{Material, SceneFile};
use super::framed::FramedObject;
use super::light::Light;
use super::limits::check_image_size;
use super::mesh::FramedMesh;
use super::object::Object;
use super::paraboloids::{FramedCylinder, FramedSphere};
use super::quadric::{FramedQuadric, Plane, Quadric, implicit};
use super::range::{DepthRange, Projection};
use super::shape::{Processor, Shape};
use super::solid::{FramedSolid, Solid, Tree};
use super::source::{FramedSource, homogeneous};
use super::transform::{Transform, WholeTransform};
use imogene_algebra::rational::{from_decimal, integer, to_f64};
use imogene_algebra::vector::{Vector, minus, normalised, unit};
use num_traits::Zero;
use rayon::prelude::*;

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
    /// Which distances the depth word tells apart.
    pub range: DepthRange,
    /// Where pixels are sampled: columns and lines from whole coordinates. Objects and sources are moved by as much,
    /// the other way.
    pub sample_at: [f64; 2],
    /// Objects in the order of the file.
    pub objects: Vec<FramedObject>,
    /// Solids made of objects, in the order of the file.
    pub solids: Vec<FramedSolid>,
    /// Materials in the order of the file.
    pub materials: Vec<Material>,
    /// Light sources in the order of the file.
    pub lights: Vec<FramedLight>,
    /// The same sources for shadows: exactly where they stand, and what they reach.
    pub sources: Vec<FramedSource>,
    /// Ambient light, 0 to 1 for each of red, green, blue.
    pub ambient: [f64; 3],
    /// Distance from the eye, in pixels, at which half of what the sources send is seen.
    pub attenuation: Option<f64>,
    /// Colour of a pixel without object, 8 bits for each of red, green, blue.
    pub background: [u8; 3],
}

/// A light source in the camera frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FramedLight {
    /// Where it stands, in pixels; of parallel light the unit vector towards it.
    pub at: Vector,
    /// It is no parallel light.
    pub is_at_a_point: bool,
    /// Colour times intensity.
    pub colour: [f64; 3],
}

impl FramedLight {
    fn new(light: &Light, camera: &Transform) -> FramedLight {
        let [x, y, z, w] = homogeneous(light, camera);
        let at = [x, y, z].map(|value| to_f64(&value));
        FramedLight {
            at: if w.is_zero() { normalised(at) } else { at },
            is_at_a_point: !w.is_zero(),
            colour: light.colour.map(|value| value * light.intensity),
        }
    }

    /// The unit vector towards it from a point.
    pub fn towards(&self, point: Vector) -> Vector {
        match self.is_at_a_point {
            true => unit(minus(self.at, point)),
            false => unit(self.at),
        }
    }
}

impl SceneFile {
    /// A checked and flattened scene in the camera frame of a picture of `width` by `height` pixels, with the depth
    /// word of a range, taking over the objects that `kept` hands out for the index of an object and its material.
    pub fn frame_within(
        &self,
        range: &DepthRange,
        (width, height): (u32, u32),
        kept: impl Fn(usize, usize) -> Result<Option<FramedObject>, SceneError> + Sync,
    ) -> Result<FramedScene, SceneError> {
        check_image_size(width, height)?;
        let (upright, projection) = camera_frame(&self.camera, height, range)?;
        let sample_at = self.camera.sample_at;
        let camera = match sample_at {
            [0.0, 0.0] => upright.clone(),
            _ => moved(sample_at, &projection).after(&upright),
        };
        let lights = self.lights.iter();
        // An object that is not visible is nowhere.
        let index = |name: &str| self.objects.iter().position(|object| object.name == name);
        let solid = |solid: &Solid| FramedSolid {
            name: solid.name.clone(),
            tree: Tree::of(&solid.of, &index),
        };
        let attenuation = match &projection {
            Projection::Perspective { distance } => {
                let pixels_per_unit = to_f64(&(distance / (integer(2) * &range.near)));
                self.attenuation.map(|half| half * pixels_per_unit)
            }
            Projection::Orthographic { .. } => None,
        };
        Ok(FramedScene {
            title: self.title.clone(),
            width,
            height,
            projection,
            range: range.clone(),
            sample_at,
            objects: self.framed_objects(&camera, kept)?,
            solids: self.solids.iter().map(solid).collect(),
            materials: self.materials.clone(),
            lights: lights
                .clone()
                .map(|l| FramedLight::new(l, &upright))
                .collect(),
            sources: lights.map(|l| FramedSource::new(l, &camera)).collect(),
            ambient: self.ambient,
            attenuation,
            background: self.background.map(|value| (value * 255.0).round() as u8),
        })
    }

    fn framed_objects(
        &self,
        camera: &Transform,
        kept: impl Fn(usize, usize) -> Result<Option<FramedObject>, SceneError> + Sync,
    ) -> Result<Vec<FramedObject>, SceneError> {
        let whole = WholeTransform::new(camera);
        // Collected before the first error is taken, so that the same object is named in every run.
        let framed = |(index, object): (usize, &Object)| {
            let mut materials = self.materials.iter();
            let material = materials.position(|own| own.name == object.material);
            let material = material.expect("validated: every material exists");
            match kept(index, material)? {
                Some(framed) => Ok(framed),
                None => framed_object(object, material, camera, &whole),
            }
        };
        let objects = self.objects.par_iter().enumerate();
        let framed: Vec<Result<FramedObject, SceneError>> = objects.map(framed).collect();
        framed.into_iter().collect()
    }
}

impl FramedScene {
    /// Where a pixel samples the screen plane of the camera frame, which is moved to where pixels are sampled.
    pub fn pixel_centre(&self, column: usize, line: usize) -> [f64; 2] {
        [
            column as f64 - 0.5 * f64::from(self.width),
            line as f64 - 0.5 * f64::from(self.height),
        ]
    }

    /// Is something seen through an object?
    pub fn is_transparent(&self, object: usize) -> bool {
        let material = self.materials.get(self.objects[object].material());
        material.is_some_and(Material::is_transparent)
    }

    /// An object's part of what is seen, in 255ths.
    pub fn weight(&self, object: usize) -> u8 {
        let opacity = self.materials[self.objects[object].material()].opacity;
        (opacity * 255.0).round() as u8
    }

    /// The normal in a frame at right angles, of one in the frame that is moved to where pixels are sampled.
    pub fn upright(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        match &self.projection {
            Projection::Perspective { distance } => {
                let [u, v] = self.sample_at;
                [x, y, z - (u * x + v * y) / to_f64(distance)]
            }
            Projection::Orthographic { .. } => [x, y, z],
        }
    }
}

/// The change from scene to camera coordinates.
///
/// A perspective picture does not change when the scene grows about the eye. So the frame is scaled until the point
/// at twice the near end lies on the screen plane, where depth is zero; an orthographic frame is moved until the
/// middle of the range does.
fn camera_frame(
    camera: &Camera,
    height: u32,
    range: &DepthRange,
) -> Result<(Transform, Projection), SceneError> {
    let sight = Sight::of(camera)?;
    let pixels_per_unit = integer(i64::from(height)) / from_decimal(camera.view_height);
    let behind = |depth| Transform::translation([integer(0), integer(0), depth]);
    match camera.lens {
        Lens::Perspective {
            viewer_distance, ..
        } => {
            let distance = from_decimal(viewer_distance) * pixels_per_unit;
            let pixels_per_unit = &distance / (integer(2) * &range.near);
            // The eye, not the screen plane, is the fixed point: it then stands exactly at (0, 0, -D).
            let frame = behind(-&distance).after(&sight.frame(&sight.eye, &pixels_per_unit));
            Ok((frame, Projection::Perspective { distance }))
        }
        Lens::Orthographic { .. } => {
            let range = range.middle_and_half();
            let [middle, half_depth] = range.map(|length| length * &pixels_per_unit);
            let frame = sight.frame(&sight.target, &pixels_per_unit);
            let frame = match middle.is_zero() {
                true => frame,
                false => behind(-middle).after(&frame),
            };
            Ok((frame, Projection::Orthographic { half_depth }))
        }
    }
}

/// Moves the camera frame so that the screen moves by `-sample_at`.
fn moved(sample_at: [f64; 2], projection: &Projection) -> Transform {
    let offset = sample_at.map(|v| -from_decimal(v));
    let mut change = Transform::identity();
    for (row, offset) in change.rows.iter_mut().zip(offset) {
        if let Projection::Perspective { distance } = projection {
            row[2] = &offset / distance;
        }
        row[3] = offset;
    }
    change
}

fn framed_object(
    object: &Object,
    material: usize,
    camera: &Transform,
    whole: &WholeTransform,
) -> Result<FramedObject, SceneError> {
    let to_camera = || camera.after(&Transform::placement(&object.place));
    let name = &object.name;
    let cut = || Box::new(cut_quadric(object, material, whole));
    let ball = |radius: f64| Box::new(FramedSphere::new(name, material, radius, &to_camera()));
    Ok(match (&object.shape, object.drawn_by()) {
        (Shape::Mesh(mesh), _) => {
            let mesh = FramedMesh::new((name, material), mesh, &to_camera(), object.casts_shadow);
            FramedObject::Mesh(Box::new(mesh))
        }
        (Shape::Polyhedron, _) | (_, None) => FramedObject::Polyhedron(cut()),
        (_, Some(Processor::Quadric)) => FramedObject::Quadric(cut()),
        (_, Some(Processor::Patch)) => FramedObject::Patch(cut()),
        (_, Some(Processor::FirstGeneration)) => FramedObject::FirstGeneration(cut()),
        (Shape::Sphere { radius }, Some(Processor::Paraboloid)) => {
            FramedObject::Sphere(ball(*radius))
        }
        (Shape::Sphere { radius }, Some(Processor::CurvedFacet)) => {
            FramedObject::CurvedSphere(ball(*radius))
        }
        (Shape::EllipticCylinder(radii), Some(Processor::Paraboloid)) => {
            let ends = [&object.cuts[0], &object.cuts[1]].map(|cut| from_decimal(cut.point[1]));
            let cylinder = FramedCylinder::new(name, material, *radii, ends, &to_camera())?;
            FramedObject::Cylinder(Box::new(cylinder))
        }
        (_, Some(Processor::Paraboloid | Processor::CurvedFacet)) => {
            let facet = cut();
            check_one_depth(&facet)?;
            FramedObject::CurvedFacet(facet)
        }
    })
}

/// An object that is a quadric bounded by planes.
pub(super) fn cut_quadric(
    object: &Object,
    material: usize,
    camera: &WholeTransform,
) -> FramedQuadric {
    let inverse = WholeTransform::of_steps(camera, &object.place).inverse();
    let local = match &object.shape {
        Shape::TetrahedronPatch { corners, weights } => {
            let (_, planes) = implicit(corners, weights).expect("checked: no flat tetrahedron");
            planes.map(Plane::from_array).to_vec()
        }
        _ => object.cuts.iter().map(Plane::from_cut).collect(),
    };
    let quadric = Quadric::from_shape(&object.shape).expect("a mesh is framed apart");
    let framed = |plane: &Plane| plane.transformed_whole(&inverse).primitive();
    FramedQuadric {
        name: object.name.clone(),
        surface: object.mode,
        quadric: quadric.transformed_whole(&inverse).primitive(),
        planes: local.iter().map(framed).collect(),
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
