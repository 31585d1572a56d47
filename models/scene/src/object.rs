//! Objects: a shape, its place and its cuts, and their keys in the file.

use super::keys::{fixed, is_yes, present, refuse_keys, require, yes};
use super::shape::{Cut, Kind, Mesh, Processor, Shape, Surface};
use super::step::Step;
use serde::{Deserialize, Serialize};

/// One object: a quadric bounded by planes, a polyhedron, a mesh or a tetrahedral patch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "ObjectKeys", into = "ObjectKeys")]
pub struct Object {
    /// Unique name.
    pub name: String,
    /// What it is, in local coordinates.
    pub shape: Shape,
    /// The processor asked for; the kind's own if none is.
    pub processor: Option<Processor>,
    /// Volume or surface.
    pub mode: Surface,
    /// Name of the material.
    pub material: String,
    /// Steps from local to scene coordinates, the first applied first.
    pub place: Vec<Step>,
    /// Planes that remove a part, in local coordinates.
    pub cuts: Vec<Cut>,
    /// Whether it keeps the light of sources with shadows off others.
    pub casts_shadow: bool,
    /// Name of the group it belongs to.
    pub group: Option<String>,
    /// Whether it is seen; an object that is not casts no shadow either.
    pub visible: bool,
}

impl Object {
    /// The processor that draws it; polyhedra and meshes have one of their own.
    pub fn drawn_by(&self) -> Option<Processor> {
        match self.shape {
            Shape::Polyhedron | Shape::Mesh(_) => None,
            Shape::TetrahedronPatch { .. } => Some(self.processor.unwrap_or(Processor::Patch)),
            _ => Some(self.processor.unwrap_or(Processor::Quadric)),
        }
    }
}

#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ObjectKeys {
    name: String,
    kind: Kind,
    radius: Option<f64>,
    radii: Option<Vec<f64>>,
    coefficients: Option<Vec<f64>>,
    vertices: Option<Vec<Vec<f64>>>,
    faces: Option<Vec<Vec<usize>>>,
    normals: Option<Vec<Vec<f64>>>,
    corners: Option<Vec<Vec<f64>>>,
    weights: Option<Vec<f64>>,
    processor: Option<Processor>,
    mode: Option<Surface>,
    material: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    place: Vec<Step>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    cuts: Vec<Cut>,
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    casts_shadow: bool,
    group: Option<String>,
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    visible: bool,
}

impl ObjectKeys {
    fn shape(&mut self) -> Result<Shape, String> {
        let owner = format!("object `{}`: this kind", self.name);
        let (keys, wanted) = self.kind.parameters();
        let present = present!(
            self; radius, radii, coefficients, vertices, faces, normals, corners, weights
        );
        let others = present.into_iter().filter(|(key, _)| !keys.contains(key));
        refuse_keys(others, &owner, wanted)?;
        let radii = self.radii.take();
        let two = || fixed(radii.clone(), &owner, wanted);
        let three = || fixed(radii.clone(), &owner, wanted);
        Ok(match self.kind {
            Kind::Sphere => Shape::Sphere {
                radius: require(self.radius, &owner, wanted)?,
            },
            Kind::EllipticCylinder => Shape::EllipticCylinder(two()?),
            Kind::HyperbolicCylinder => Shape::HyperbolicCylinder(two()?),
            Kind::ParabolicCylinder => Shape::ParabolicCylinder(two()?),
            Kind::Ellipsoid => Shape::Ellipsoid(three()?),
            Kind::Cone => Shape::Cone(three()?),
            Kind::HyperboloidOneSheet => Shape::HyperboloidOneSheet(three()?),
            Kind::HyperboloidTwoSheets => Shape::HyperboloidTwoSheets(three()?),
            Kind::EllipticParaboloid => Shape::EllipticParaboloid(three()?),
            Kind::HyperbolicParaboloid => Shape::HyperbolicParaboloid(three()?),
            Kind::Quadric => Shape::Quadric {
                coefficients: fixed(self.coefficients.take(), &owner, wanted)?,
            },
            Kind::Polyhedron => Shape::Polyhedron,
            Kind::Mesh => {
                let vertices = require(self.vertices.take(), &owner, wanted)?;
                let normals = self.normals.take().unwrap_or_default();
                Shape::Mesh(Mesh {
                    vertices: self.points(vertices, "vertices")?,
                    faces: require(self.faces.take(), &owner, wanted)?,
                    normals: self.points(normals, "normals")?,
                })
            }
            Kind::TetrahedronPatch => {
                let corners = require(self.corners.take(), &owner, wanted)?;
                let found = |corners: Vec<_>| {
                    format!("{owner} needs {wanted}; found {} corners", corners.len())
                };
                Shape::TetrahedronPatch {
                    corners: self.points(corners, "corners")?.try_into().map_err(found)?,
                    weights: Box::new(fixed(self.weights.take(), &owner, wanted)?),
                }
            }
        })
    }

    /// Points of three numbers each.
    fn points(&self, values: Vec<Vec<f64>>, key: &str) -> Result<Vec<[f64; 3]>, String> {
        let point = |(index, value): (usize, Vec<f64>)| {
            value.try_into().map_err(|value: Vec<f64>| {
                format!(
                    "object `{}`: {key}[{index}] has {} numbers; [x, y, z] would be accepted",
                    self.name,
                    value.len()
                )
            })
        };
        values.into_iter().enumerate().map(point).collect()
    }

    /// Volume or surface, where the kind leaves a choice.
    fn surface(&self) -> Result<Surface, String> {
        let problem = match (self.kind, self.mode) {
            (Kind::Mesh, Some(_)) => "has no `mode`; its facets are surfaces without inside",
            (Kind::Polyhedron, Some(Surface::Patch)) => {
                "is a volume; `mode = \"solid\"`, or no `mode`, would be accepted"
            }
            (Kind::TetrahedronPatch, Some(Surface::Solid)) => {
                "is a surface; `mode = \"patch\"`, or no `mode`, would be accepted"
            }
            (Kind::Mesh | Kind::TetrahedronPatch, _) => return Ok(Surface::Patch),
            (_, mode) => return Ok(mode.unwrap_or_default()),
        };
        Err(format!("object `{}`: this kind {problem}", self.name))
    }
}

impl TryFrom<ObjectKeys> for Object {
    type Error = String;

    fn try_from(mut keys: ObjectKeys) -> Result<Self, String> {
        Ok(Self {
            shape: keys.shape()?,
            mode: keys.surface()?,
            name: keys.name,
            processor: keys.processor,
            material: keys.material,
            place: keys.place,
            cuts: keys.cuts,
            casts_shadow: keys.casts_shadow,
            group: keys.group,
            visible: keys.visible,
        })
    }
}

impl From<Object> for ObjectKeys {
    fn from(object: Object) -> Self {
        let lists = |points: &[[f64; 3]]| Some(points.iter().map(|p| p.to_vec()).collect());
        let mut keys = Self {
            name: object.name,
            kind: object.shape.kind(),
            radii: object.shape.radii().map(<[f64]>::to_vec),
            processor: object.processor,
            mode: Some(object.mode),
            material: object.material,
            place: object.place,
            cuts: object.cuts,
            casts_shadow: object.casts_shadow,
            group: object.group,
            visible: object.visible,
            ..Self::default()
        };
        match object.shape {
            Shape::Sphere { radius } => keys.radius = Some(radius),
            Shape::Quadric { coefficients } => keys.coefficients = Some(coefficients.to_vec()),
            Shape::Mesh(mesh) => {
                keys.vertices = lists(&mesh.vertices);
                keys.normals = lists(&mesh.normals).filter(|normals: &Vec<_>| !normals.is_empty());
                (keys.faces, keys.mode) = (Some(mesh.faces), None);
            }
            Shape::TetrahedronPatch { corners, weights } => {
                (keys.corners, keys.weights) = (lists(&corners[..]), Some(weights.to_vec()));
            }
            _ => {}
        }
        keys
    }
}
