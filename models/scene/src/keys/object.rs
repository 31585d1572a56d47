//! `[[objects]]` as they stand in the file.

use super::{fixed, is_yes, refuse_key, require, yes};
use crate::file::{Cut, Mesh, Object, Processor, Shape, Step, Surface};
use serde::{Deserialize, Serialize};

/// The keys of an entry of `[[objects]]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ObjectKeys {
    name: String,
    kind: Kind,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radii: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    coefficients: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<Vec<f64>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    faces: Option<Vec<Vec<usize>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    normals: Option<Vec<Vec<f64>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    corners: Option<Vec<Vec<f64>>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    weights: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    processor: Option<Processor>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mode: Option<Surface>,
    material: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    place: Vec<Step>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    cuts: Vec<Cut>,
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    casts_shadow: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    group: Option<String>,
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    visible: bool,
}

#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum Kind {
    Ellipsoid,
    Sphere,
    EllipticCylinder,
    HyperbolicCylinder,
    ParabolicCylinder,
    Cone,
    HyperboloidOneSheet,
    HyperboloidTwoSheets,
    EllipticParaboloid,
    HyperbolicParaboloid,
    Quadric,
    Polyhedron,
    Mesh,
    TetrahedronPatch,
}

impl Kind {
    /// The keys that hold the parameters of this kind, and their meaning.
    fn parameters(self) -> (&'static [&'static str], &'static str) {
        match self {
            Self::Sphere => (&["radius"], "`radius`, one number"),
            Self::EllipticCylinder | Self::HyperbolicCylinder | Self::ParabolicCylinder => {
                (&["radii"], "`radii`, the two numbers A and C")
            }
            Self::Quadric => (&["coefficients"], "`coefficients`, the ten numbers a to j"),
            Self::Polyhedron => (&[], "`cuts`, the planes of its faces"),
            Self::Mesh => (
                &["vertices", "faces", "normals"],
                "`vertices` and `faces`, and `normals` if it is to look round",
            ),
            Self::TetrahedronPatch => (
                &["corners", "weights"],
                "`corners`, four points, and `weights`, ten numbers",
            ),
            _ => (&["radii"], "`radii`, the three numbers A, B and C"),
        }
    }
}

/// Points of three numbers each.
fn points(values: &[Vec<f64>], owner: &str, key: &str) -> Result<Vec<[f64; 3]>, String> {
    let point = |(index, value): (usize, &Vec<f64>)| {
        value.as_slice().try_into().map_err(|_| {
            format!(
                "{owner}: {key}[{index}] has {} numbers; [x, y, z] would be accepted",
                value.len()
            )
        })
    };
    values.iter().enumerate().map(point).collect()
}

impl ObjectKeys {
    fn shape(&self) -> Result<Shape, String> {
        let owner = format!("object `{}`: this kind", self.name);
        let (keys, wanted) = self.kind.parameters();
        let present = [
            ("radius", self.radius.is_some()),
            ("radii", self.radii.is_some()),
            ("coefficients", self.coefficients.is_some()),
            ("vertices", self.vertices.is_some()),
            ("faces", self.faces.is_some()),
            ("normals", self.normals.is_some()),
            ("corners", self.corners.is_some()),
            ("weights", self.weights.is_some()),
        ];
        for (key, is_present) in present {
            refuse_key(is_present && !keys.contains(&key), key, &owner, wanted)?;
        }
        let three = || fixed::<3>(self.radii.as_deref(), &owner, wanted);
        let two = || fixed::<2>(self.radii.as_deref(), &owner, wanted);
        Ok(match self.kind {
            Kind::Ellipsoid => Shape::Ellipsoid { radii: three()? },
            Kind::Sphere => Shape::Sphere {
                radius: require(self.radius, &owner, wanted)?,
            },
            Kind::EllipticCylinder => Shape::EllipticCylinder { radii: two()? },
            Kind::HyperbolicCylinder => Shape::HyperbolicCylinder { radii: two()? },
            Kind::ParabolicCylinder => Shape::ParabolicCylinder { radii: two()? },
            Kind::Cone => Shape::Cone { radii: three()? },
            Kind::HyperboloidOneSheet => Shape::HyperboloidOneSheet { radii: three()? },
            Kind::HyperboloidTwoSheets => Shape::HyperboloidTwoSheets { radii: three()? },
            Kind::EllipticParaboloid => Shape::EllipticParaboloid { radii: three()? },
            Kind::HyperbolicParaboloid => Shape::HyperbolicParaboloid { radii: three()? },
            Kind::Quadric => Shape::Quadric {
                coefficients: fixed::<10>(self.coefficients.as_deref(), &owner, wanted)?,
            },
            Kind::Polyhedron => Shape::Polyhedron,
            Kind::Mesh => Shape::Mesh(self.mesh(&owner, wanted)?),
            Kind::TetrahedronPatch => self.tetrahedron(&owner, wanted)?,
        })
    }

    fn mesh(&self, owner: &str, wanted: &str) -> Result<Mesh, String> {
        let object = format!("object `{}`", self.name);
        let vertices = require(self.vertices.as_deref(), owner, wanted)?;
        let normals = self.normals.as_deref().unwrap_or_default();
        Ok(Mesh {
            vertices: points(vertices, &object, "vertices")?,
            faces: require(self.faces.clone(), owner, wanted)?,
            normals: points(normals, &object, "normals")?,
        })
    }

    fn tetrahedron(&self, owner: &str, wanted: &str) -> Result<Shape, String> {
        let corners = require(self.corners.as_deref(), owner, wanted)?;
        let corners = points(corners, &format!("object `{}`", self.name), "corners")?;
        Ok(Shape::TetrahedronPatch {
            corners: corners.try_into().map_err(|corners: Vec<_>| {
                format!("{owner} needs {wanted}; found {} corners", corners.len())
            })?,
            weights: Box::new(fixed::<10>(self.weights.as_deref(), owner, wanted)?),
        })
    }

    /// Volume or surface, where the kind leaves a choice.
    fn surface(&self) -> Result<Surface, String> {
        let owner = format!("object `{}`: this kind", self.name);
        match (self.kind, self.mode) {
            (Kind::Mesh, Some(_)) => Err(format!(
                "{owner} has no `mode`; its facets are surfaces without inside"
            )),
            (Kind::Polyhedron, Some(Surface::Patch)) => Err(format!(
                "{owner} is a volume; `mode = \"solid\"`, or no `mode`, would be accepted"
            )),
            (Kind::TetrahedronPatch, Some(Surface::Solid)) => Err(format!(
                "{owner} is a surface; `mode = \"patch\"`, or no `mode`, would be accepted"
            )),
            (Kind::Mesh | Kind::TetrahedronPatch, _) => Ok(Surface::Patch),
            (_, mode) => Ok(mode.unwrap_or_default()),
        }
    }
}

impl TryFrom<ObjectKeys> for Object {
    type Error = String;

    fn try_from(keys: ObjectKeys) -> Result<Self, String> {
        let shape = keys.shape()?;
        let mode = keys.surface()?;
        Ok(Self {
            name: keys.name,
            shape,
            processor: keys.processor,
            mode,
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
        let mut keys = Self {
            name: object.name,
            kind: Kind::Polyhedron,
            radius: None,
            radii: None,
            coefficients: None,
            vertices: None,
            faces: None,
            normals: None,
            corners: None,
            weights: None,
            processor: object.processor,
            mode: Some(object.mode),
            material: object.material,
            place: object.place,
            cuts: object.cuts,
            casts_shadow: object.casts_shadow,
            group: object.group,
            visible: object.visible,
        };
        keys.kind = match object.shape {
            Shape::Sphere { radius } => {
                keys.radius = Some(radius);
                Kind::Sphere
            }
            Shape::Quadric { coefficients } => {
                keys.coefficients = Some(coefficients.to_vec());
                Kind::Quadric
            }
            Shape::Polyhedron => Kind::Polyhedron,
            Shape::Mesh(mesh) => {
                let lists = |points: &[[f64; 3]]| points.iter().map(|p| p.to_vec()).collect();
                keys.vertices = Some(lists(&mesh.vertices));
                keys.normals = (!mesh.normals.is_empty()).then(|| lists(&mesh.normals));
                keys.faces = Some(mesh.faces);
                keys.mode = None;
                Kind::Mesh
            }
            Shape::TetrahedronPatch { corners, weights } => {
                keys.corners = Some(corners.map(|c| c.to_vec()).to_vec());
                keys.weights = Some(weights.to_vec());
                Kind::TetrahedronPatch
            }
            Shape::EllipticCylinder { radii } => keys.with(&radii, Kind::EllipticCylinder),
            Shape::HyperbolicCylinder { radii } => keys.with(&radii, Kind::HyperbolicCylinder),
            Shape::ParabolicCylinder { radii } => keys.with(&radii, Kind::ParabolicCylinder),
            Shape::Ellipsoid { radii } => keys.with(&radii, Kind::Ellipsoid),
            Shape::Cone { radii } => keys.with(&radii, Kind::Cone),
            Shape::HyperboloidOneSheet { radii } => keys.with(&radii, Kind::HyperboloidOneSheet),
            Shape::HyperboloidTwoSheets { radii } => keys.with(&radii, Kind::HyperboloidTwoSheets),
            Shape::EllipticParaboloid { radii } => keys.with(&radii, Kind::EllipticParaboloid),
            Shape::HyperbolicParaboloid { radii } => keys.with(&radii, Kind::HyperbolicParaboloid),
        };
        keys
    }
}

impl ObjectKeys {
    fn with(&mut self, radii: &[f64], kind: Kind) -> Kind {
        self.radii = Some(radii.to_vec());
        kind
    }
}
