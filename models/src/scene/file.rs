//! The scene file: TOML, written by hand or by an importer. `docs/scene-format.md` is its user's page.

use std::fs;
use std::path::Path;

use serde::de::{self, Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

use super::error::{SceneError, line_and_column};

/// The version this code reads and writes.
pub const FORMAT_VERSION: i64 = 1;

/// A scene as its author wrote it: scene units, right-handed axes, y upwards by habit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneFile {
    /// Version of the format, [`FORMAT_VERSION`].
    pub format: i64,
    /// Title of the picture.
    pub title: String,
    /// Colour of a pixel that no object covers, 0 to 1 for each of red, green, blue.
    #[serde(default, deserialize_with = "numbers")]
    pub background: [f64; 3],
    /// Ambient light `I_a`, 0 to 1 for each of red, green, blue.
    #[serde(default = "white", deserialize_with = "numbers")]
    pub ambient: [f64; 3],
    /// Size of the picture unless the user asks for another.
    #[serde(default)]
    pub image: ImageSize,
    /// The observer.
    pub camera: Camera,
    /// Light sources; without any, only the ambient light shows the objects.
    #[serde(default)]
    pub lights: Vec<Light>,
    /// Materials, referred to by name.
    #[serde(default)]
    pub materials: Vec<Material>,
    /// Objects, in the order that breaks ties of equal depth (the first wins).
    #[serde(default)]
    pub objects: Vec<Object>,
}

/// Size of a picture in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ImageSize {
    /// Columns, 1 to 4096.
    pub width: u32,
    /// Lines, 1 to 4096.
    pub height: u32,
}

impl Default for ImageSize {
    /// The screen of the source machine (thesis section 4.1.3).
    fn default() -> Self {
        Self {
            width: 720,
            height: 540,
        }
    }
}

/// The observer: it looks from `eye` towards `target`, with `up` upwards in the picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "CameraKeys", into = "CameraKeys")]
pub enum Camera {
    /// Central projection on the screen plane at `viewer_distance` in front of the eye.
    Perspective {
        /// The observer's eye.
        eye: [f64; 3],
        /// A point on the optical axis, seen in the middle of the picture.
        target: [f64; 3],
        /// A direction seen upwards.
        up: [f64; 3],
        /// Distance from the eye to the screen plane, in scene units.
        viewer_distance: f64,
        /// Height, in scene units, of the window that the picture shows of the screen plane.
        view_height: f64,
    },
    /// Parallel projection on the screen plane through `target`.
    Orthographic {
        /// A point in the direction the picture is seen from.
        eye: [f64; 3],
        /// The point of the screen plane in the middle of the picture.
        target: [f64; 3],
        /// A direction seen upwards.
        up: [f64; 3],
        /// Height of the picture in scene units.
        view_height: f64,
        /// Depth, in scene units, covered in front of and behind the screen plane.
        half_depth: f64,
    },
}

/// A light source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "LightKeys", into = "LightKeys")]
pub enum Light {
    /// Parallel light.
    Directional {
        /// The direction the light comes from: a vector from the scene towards the source.
        from: [f64; 3],
        /// 0 to 1 for each of red, green, blue.
        colour: [f64; 3],
        /// Factor of the colour.
        intensity: f64,
    },
    /// Light from one point, without attenuation.
    Point {
        /// Where the source stands.
        position: [f64; 3],
        /// 0 to 1 for each of red, green, blue.
        colour: [f64; 3],
        /// Factor of the colour.
        intensity: f64,
    },
}

/// What a surface does with light: `I = ambient I_a + sum of I_p (diffuse cos + specular cos^exponent)` (thesis section 1.2.4).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Unique name.
    pub name: String,
    /// Colour of the ambient and diffuse terms, 0 to 1 for each of red, green, blue; a highlight has the colour of its source.
    #[serde(deserialize_with = "numbers")]
    pub colour: [f64; 3],
    /// Share of the ambient light, 0 to 1.
    #[serde(default = "default_ambient")]
    pub ambient: f64,
    /// Share of the diffused light, 0 to 1.
    #[serde(default = "default_diffuse")]
    pub diffuse: f64,
    /// Share of the mirrored light, 0 to 1.
    #[serde(default = "default_specular")]
    pub specular: f64,
    /// Sharpness of the highlight, 1 to 200.
    #[serde(default = "default_exponent")]
    pub exponent: u32,
}

/// Whether an object is the cut volume or only the cut surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Surface {
    /// The volume: a cut shows a flat face.
    #[default]
    Solid,
    /// The surface alone: a cut opens it, and its inner wall shows.
    Patch,
}

/// One quadric bounded by planes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "ObjectKeys", into = "ObjectKeys")]
pub struct Object {
    /// Unique name.
    pub name: String,
    /// The quadric in local coordinates.
    pub shape: Shape,
    /// Volume or surface.
    pub mode: Surface,
    /// Name of the material.
    pub material: String,
    /// Steps from local to scene coordinates, the first applied first.
    pub place: Vec<Step>,
    /// Planes that remove a part, in local coordinates.
    pub cuts: Vec<Cut>,
}

/// A quadric in canonical position, inside where the expression is negative or zero (thesis Table 2.1).
///
/// Axes of revolution, of two-sheetedness and of rulings of the cylinders all lie along the local y axis.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// `x^2/A^2 + y^2/B^2 + z^2/C^2 - 1`
    Ellipsoid {
        /// A, B, C.
        radii: [f64; 3],
    },
    /// `x^2 + y^2 + z^2 - R^2`
    Sphere {
        /// R.
        radius: f64,
    },
    /// `x^2/A^2 + z^2/C^2 - 1`
    EllipticCylinder {
        /// A, C.
        radii: [f64; 2],
    },
    /// `x^2/A^2 - z^2/C^2 - 1`, the part that contains the y axis.
    HyperbolicCylinder {
        /// A, C.
        radii: [f64; 2],
    },
    /// `x^2/A^2 - z/C`, open towards +z.
    ParabolicCylinder {
        /// A, C.
        radii: [f64; 2],
    },
    /// `x^2/A^2 - y^2/B^2 + z^2/C^2`, both halves, apex at the origin.
    Cone {
        /// A, B, C.
        radii: [f64; 3],
    },
    /// `x^2/A^2 - y^2/B^2 + z^2/C^2 - 1`, the part that contains the y axis.
    HyperboloidOneSheet {
        /// A, B, C.
        radii: [f64; 3],
    },
    /// `x^2/A^2 - y^2/B^2 + z^2/C^2 + 1`, tips at y = -B and y = B.
    HyperboloidTwoSheets {
        /// A, B, C.
        radii: [f64; 3],
    },
    /// `x^2/A^2 + z^2/C^2 - y/B`, open towards +y.
    EllipticParaboloid {
        /// A, B, C.
        radii: [f64; 3],
    },
    /// `x^2/A^2 - z^2/C^2 - y/B`, the part above the saddle.
    HyperbolicParaboloid {
        /// A, B, C.
        radii: [f64; 3],
    },
    /// `a x^2 + b y^2 + c z^2 + 2d xy + 2e xz + 2f yz + 2g x + 2h y + 2i z + j`
    Quadric {
        /// a to j.
        coefficients: [f64; 10],
    },
}

/// One step of an object's placement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "StepKeys", into = "StepKeys")]
pub enum Step {
    /// Displacement in scene units.
    Translate([f64; 3]),
    /// Rotation about an axis through the origin.
    Rotate(Rotation),
    /// Scaling from the origin, one factor or one for each axis; negative factors mirror.
    Scale(Scale),
}

/// A rotation about an axis through the origin, counter-clockwise when the axis points to the observer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rotation {
    /// The axis.
    pub axis: Axis,
    /// The angle in degrees; multiples of 90 about a coordinate axis are exact.
    pub degrees: f64,
}

/// Axis of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// The x axis.
    X,
    /// The y axis.
    Y,
    /// The z axis.
    Z,
    /// Any other direction; its length does not matter.
    #[serde(untagged)]
    Vector([f64; 3]),
}

/// Factors of a scaling.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Scale {
    /// The same factor for x, y and z.
    Uniform(f64),
    /// One factor for each axis.
    PerAxis([f64; 3]),
}

/// A cut plane in local coordinates: the part on the side of the normal is removed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Cut {
    /// A point of the plane.
    #[serde(deserialize_with = "numbers")]
    pub point: [f64; 3],
    /// Outward normal, of any length.
    #[serde(deserialize_with = "numbers")]
    pub normal: [f64; 3],
}

impl SceneFile {
    /// Reads and checks a scene file.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let file = path.display().to_string();
        let bytes = fs::read(path).map_err(|source| SceneError::Unreadable {
            file: file.clone(),
            source,
        })?;
        let text = match std::str::from_utf8(&bytes) {
            Ok(text) => text,
            Err(error) => {
                let offset = error.valid_up_to();
                let good = String::from_utf8_lossy(&bytes[..offset]);
                let (line, _) = line_and_column(&good, offset);
                return Err(SceneError::NotText { file, line, offset });
            }
        };
        Self::parse(text, &file)
    }

    /// Reads and checks the text of a scene; `file` is the name that messages give it.
    pub fn parse(text: &str, file: &str) -> Result<Self, SceneError> {
        check_version(text, file)?;
        let scene: Self =
            toml::from_str(text).map_err(|error| SceneError::syntax(file, text, &error))?;
        scene.validate().map_err(|error| error.in_file(file))?;
        Ok(scene)
    }

    /// The scene as the text of a scene file; [`SceneFile::parse`] reads it back as the same scene.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        self.validate()?;
        toml::to_string(self).map_err(|source| SceneError::Unwritable { source })
    }
}

/// Refuses another version before its unknown keys are blamed on the author.
fn check_version(text: &str, file: &str) -> Result<(), SceneError> {
    let table: toml::Table =
        toml::from_str(text).map_err(|error| SceneError::syntax(file, text, &error))?;
    let accepted = format!("this program reads `format = {FORMAT_VERSION}`");
    let refuse =
        |problem: String| Err(SceneError::value("format", problem, accepted).in_file(file));
    match table.get("format") {
        None if table.is_empty() => refuse("the file is empty".to_owned()),
        None => refuse("the version of the format is missing".to_owned()),
        Some(toml::Value::Integer(FORMAT_VERSION)) => Ok(()),
        Some(other) => refuse(format!("version {other} is not known")),
    }
}

/// The keys of `[camera]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraKeys {
    kind: CameraKind,
    #[serde(deserialize_with = "numbers")]
    eye: [f64; 3],
    #[serde(deserialize_with = "numbers")]
    target: [f64; 3],
    #[serde(default = "upwards", deserialize_with = "numbers")]
    up: [f64; 3],
    viewer_distance: Option<f64>,
    view_height: f64,
    half_depth: Option<f64>,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CameraKind {
    Perspective,
    Orthographic,
}

impl TryFrom<CameraKeys> for Camera {
    type Error = String;

    fn try_from(keys: CameraKeys) -> Result<Self, String> {
        let CameraKeys {
            kind,
            eye,
            target,
            up,
            viewer_distance,
            view_height,
            half_depth,
        } = keys;
        match kind {
            CameraKind::Perspective => {
                refuse_key(
                    half_depth.is_some(),
                    "half_depth",
                    "a perspective camera",
                    "`viewer_distance`",
                )?;
                Ok(Self::Perspective {
                    eye,
                    target,
                    up,
                    viewer_distance: require(
                        viewer_distance,
                        "a perspective camera",
                        "`viewer_distance`, from the eye to the screen plane",
                    )?,
                    view_height,
                })
            }
            CameraKind::Orthographic => {
                refuse_key(
                    viewer_distance.is_some(),
                    "viewer_distance",
                    "an orthographic camera",
                    "`half_depth`",
                )?;
                Ok(Self::Orthographic {
                    eye,
                    target,
                    up,
                    view_height,
                    half_depth: require(
                        half_depth,
                        "an orthographic camera",
                        "`half_depth`, the depth covered on each side of the screen plane",
                    )?,
                })
            }
        }
    }
}

impl From<Camera> for CameraKeys {
    fn from(camera: Camera) -> Self {
        match camera {
            Camera::Perspective {
                eye,
                target,
                up,
                viewer_distance,
                view_height,
            } => Self {
                kind: CameraKind::Perspective,
                eye,
                target,
                up,
                viewer_distance: Some(viewer_distance),
                view_height,
                half_depth: None,
            },
            Camera::Orthographic {
                eye,
                target,
                up,
                view_height,
                half_depth,
            } => Self {
                kind: CameraKind::Orthographic,
                eye,
                target,
                up,
                viewer_distance: None,
                view_height,
                half_depth: Some(half_depth),
            },
        }
    }
}

/// The keys of an entry of `[[lights]]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct LightKeys {
    kind: LightKind,
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    from: Option<[f64; 3]>,
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    position: Option<[f64; 3]>,
    #[serde(default = "white", deserialize_with = "numbers")]
    colour: [f64; 3],
    #[serde(default = "full")]
    intensity: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum LightKind {
    Directional,
    Point,
}

impl TryFrom<LightKeys> for Light {
    type Error = String;

    fn try_from(keys: LightKeys) -> Result<Self, String> {
        let LightKeys {
            kind,
            from,
            position,
            colour,
            intensity,
        } = keys;
        match kind {
            LightKind::Directional => {
                refuse_key(
                    position.is_some(),
                    "position",
                    "a directional light",
                    "`from`",
                )?;
                Ok(Self::Directional {
                    from: require(
                        from,
                        "a directional light",
                        "`from`, the direction the light comes from",
                    )?,
                    colour,
                    intensity,
                })
            }
            LightKind::Point => {
                refuse_key(from.is_some(), "from", "a point light", "`position`")?;
                Ok(Self::Point {
                    position: require(position, "a point light", "`position`")?,
                    colour,
                    intensity,
                })
            }
        }
    }
}

impl From<Light> for LightKeys {
    fn from(light: Light) -> Self {
        let (kind, from, position, colour, intensity) = match light {
            Light::Directional {
                from,
                colour,
                intensity,
            } => (LightKind::Directional, Some(from), None, colour, intensity),
            Light::Point {
                position,
                colour,
                intensity,
            } => (LightKind::Point, None, Some(position), colour, intensity),
        };
        Self {
            kind,
            from,
            position,
            colour,
            intensity,
        }
    }
}

/// The keys of an entry of `[[objects]]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct ObjectKeys {
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

/// The key of a step as it stands in the file.
#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct StepKeys {
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    translate: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rotate: Option<Rotation>,
    #[serde(skip_serializing_if = "Option::is_none")]
    scale: Option<Scale>,
}

impl TryFrom<StepKeys> for Step {
    type Error = String;

    fn try_from(keys: StepKeys) -> Result<Self, String> {
        match (keys.translate, keys.rotate, keys.scale) {
            (Some(offset), None, None) => Ok(Self::Translate(offset)),
            (None, Some(rotation), None) => Ok(Self::Rotate(rotation)),
            (None, None, Some(scale)) => Ok(Self::Scale(scale)),
            (None, None, None) => {
                Err("the step is empty; it needs one of `translate`, `rotate`, `scale`".to_owned())
            }
            _ => Err(
                "several steps in one table; write each in its own { }, in the order they apply"
                    .to_owned(),
            ),
        }
    }
}

impl From<Step> for StepKeys {
    fn from(step: Step) -> Self {
        let none = Self::default();
        match step {
            Step::Translate(offset) => Self {
                translate: Some(offset),
                ..none
            },
            Step::Rotate(rotation) => Self {
                rotate: Some(rotation),
                ..none
            },
            Step::Scale(scale) => Self {
                scale: Some(scale),
                ..none
            },
        }
    }
}

fn require<T>(value: Option<T>, owner: &str, wanted: &str) -> Result<T, String> {
    value.ok_or_else(|| format!("{owner} needs {wanted}"))
}

fn refuse_key(present: bool, key: &str, owner: &str, wanted: &str) -> Result<(), String> {
    if present {
        return Err(format!("{owner} has no `{key}`; it takes {wanted}"));
    }
    Ok(())
}

fn fixed<const N: usize>(
    values: Option<&[f64]>,
    owner: &str,
    wanted: &str,
) -> Result<[f64; N], String> {
    let values = require(values, owner, wanted)?;
    values
        .try_into()
        .map_err(|_| format!("{owner} needs {wanted}; found {} numbers", values.len()))
}

/// Reads an array of exactly `N` numbers; the array type alone would let a surplus number pass unseen.
fn numbers<'de, D: Deserializer<'de>, const N: usize>(input: D) -> Result<[f64; N], D::Error> {
    let values = Vec::<f64>::deserialize(input)?;
    values.as_slice().try_into().map_err(|_| {
        de::Error::custom(format!(
            "{} numbers found; [{}], {N} numbers, would be accepted",
            values.len(),
            vec!["0.0"; N].join(", ")
        ))
    })
}

fn optional_numbers<'de, D: Deserializer<'de>>(input: D) -> Result<Option<[f64; 3]>, D::Error> {
    numbers(input).map(Some)
}

/// Reads three numbers that stand where another form is also possible.
fn three_of<'de, A: SeqAccess<'de>>(mut sequence: A, wanted: &str) -> Result<[f64; 3], A::Error> {
    let mut values = Vec::new();
    while let Some(value) = sequence.next_element::<f64>()? {
        values.push(value);
    }
    values.as_slice().try_into().map_err(|_| {
        de::Error::custom(format!(
            "{} numbers found; {wanted} would be accepted",
            values.len()
        ))
    })
}

const AXIS_FORMS: &str = "\"x\", \"y\", \"z\" or a vector [x, y, z]";
const SCALE_FORMS: &str = "one number or [x, y, z]";

impl<'de> Deserialize<'de> for Axis {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct AxisVisitor;
        impl<'de> Visitor<'de> for AxisVisitor {
            type Value = Axis;

            fn expecting(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
                out.write_str(AXIS_FORMS)
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Axis, E> {
                match name {
                    "x" => Ok(Axis::X),
                    "y" => Ok(Axis::Y),
                    "z" => Ok(Axis::Z),
                    other => Err(E::invalid_value(de::Unexpected::Str(other), &self)),
                }
            }

            fn visit_seq<A: SeqAccess<'de>>(self, sequence: A) -> Result<Axis, A::Error> {
                three_of(sequence, AXIS_FORMS).map(Axis::Vector)
            }
        }
        input.deserialize_any(AxisVisitor)
    }
}

impl<'de> Deserialize<'de> for Scale {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct ScaleVisitor;
        impl<'de> Visitor<'de> for ScaleVisitor {
            type Value = Scale;

            fn expecting(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
                out.write_str(SCALE_FORMS)
            }

            fn visit_f64<E: de::Error>(self, factor: f64) -> Result<Scale, E> {
                Ok(Scale::Uniform(factor))
            }

            fn visit_i64<E: de::Error>(self, factor: i64) -> Result<Scale, E> {
                Ok(Scale::Uniform(factor as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, sequence: A) -> Result<Scale, A::Error> {
                three_of(sequence, SCALE_FORMS).map(Scale::PerAxis)
            }
        }
        input.deserialize_any(ScaleVisitor)
    }
}

fn white() -> [f64; 3] {
    [1.0; 3]
}

fn upwards() -> [f64; 3] {
    [0.0, 1.0, 0.0]
}

fn full() -> f64 {
    1.0
}

fn default_ambient() -> f64 {
    0.2
}

fn default_diffuse() -> f64 {
    0.7
}

fn default_specular() -> f64 {
    0.3
}

fn default_exponent() -> u32 {
    30
}
