//! `[[objects]]` as they stand in the file.

use super::{fixed, refuse_key, require};
use crate::scene::file::{Cut, Object, Shape, Step, Surface};
use serde::{Deserialize, Serialize};

/// The keys of an entry of `[[objects]]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::scene) struct ObjectKeys {
    name: String,
    kind: Kind,
    #[serde(skip_serializing_if = "Option::is_none")]
    radius: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    radii: Option<Vec<f64>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    coefficients: Option<Vec<f64>>,
    #[serde(default)]
    mode: Surface,
    material: String,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    place: Vec<Step>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    cuts: Vec<Cut>,
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
}

impl Kind {
    /// The key that holds the parameters of this kind, with its meaning.
    fn parameters(self) -> (&'static str, &'static str) {
        match self {
            Self::Sphere => ("radius", "`radius`, one number"),
            Self::EllipticCylinder | Self::HyperbolicCylinder | Self::ParabolicCylinder => {
                ("radii", "`radii`, the two numbers A and C")
            }
            Self::Quadric => ("coefficients", "`coefficients`, the ten numbers a to j"),
            _ => ("radii", "`radii`, the three numbers A, B and C"),
        }
    }
}

impl ObjectKeys {
    fn shape(&self) -> Result<Shape, String> {
        let owner = format!("object `{}`: this kind", self.name);
        let (key, wanted) = self.kind.parameters();
        let present = [
            ("radius", self.radius.is_some()),
            ("radii", self.radii.is_some()),
            ("coefficients", self.coefficients.is_some()),
        ];
        for (other, is_present) in present {
            refuse_key(is_present && other != key, other, &owner, wanted)?;
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
        })
    }
}

impl TryFrom<ObjectKeys> for Object {
    type Error = String;

    fn try_from(keys: ObjectKeys) -> Result<Self, String> {
        let shape = keys.shape()?;
        Ok(Self {
            name: keys.name,
            shape,
            mode: keys.mode,
            material: keys.material,
            place: keys.place,
            cuts: keys.cuts,
        })
    }
}

impl From<Object> for ObjectKeys {
    fn from(object: Object) -> Self {
        let mut radius = None;
        let mut radii = None;
        let mut coefficients = None;
        let kind = match object.shape {
            Shape::Sphere { radius: value } => {
                radius = Some(value);
                Kind::Sphere
            }
            Shape::Quadric {
                coefficients: values,
            } => {
                coefficients = Some(values.to_vec());
                Kind::Quadric
            }
            Shape::EllipticCylinder { radii: values } => {
                radii = Some(values.to_vec());
                Kind::EllipticCylinder
            }
            Shape::HyperbolicCylinder { radii: values } => {
                radii = Some(values.to_vec());
                Kind::HyperbolicCylinder
            }
            Shape::ParabolicCylinder { radii: values } => {
                radii = Some(values.to_vec());
                Kind::ParabolicCylinder
            }
            Shape::Ellipsoid { radii: values } => {
                radii = Some(values.to_vec());
                Kind::Ellipsoid
            }
            Shape::Cone { radii: values } => {
                radii = Some(values.to_vec());
                Kind::Cone
            }
            Shape::HyperboloidOneSheet { radii: values } => {
                radii = Some(values.to_vec());
                Kind::HyperboloidOneSheet
            }
            Shape::HyperboloidTwoSheets { radii: values } => {
                radii = Some(values.to_vec());
                Kind::HyperboloidTwoSheets
            }
            Shape::EllipticParaboloid { radii: values } => {
                radii = Some(values.to_vec());
                Kind::EllipticParaboloid
            }
            Shape::HyperbolicParaboloid { radii: values } => {
                radii = Some(values.to_vec());
                Kind::HyperbolicParaboloid
            }
        };
        Self {
            name: object.name,
            kind,
            radius,
            radii,
            coefficients,
            mode: object.mode,
            material: object.material,
            place: object.place,
            cuts: object.cuts,
        }
    }
}
