//! The scene file: TOML, written by hand or by an importer. `docs/scene-format.md` is its user's page.

use std::path::Path;

use serde::{Deserialize, Serialize};
use toml::de::DeTable;

use super::error::{SceneError, line_and_column};
use super::group::{Group, Node};
use super::image::KeyImage;
use super::keys::{CameraKeys, LightKeys, ObjectKeys, SceneKeys, StepKeys, numbers};
use super::molecule::Molecule;

/// The version this code reads and writes.
pub const FORMAT_VERSION: i64 = 1;

/// A scene as its author wrote it: scene units, right-handed axes, y upwards by habit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "SceneKeys", into = "SceneKeys")]
pub struct SceneFile {
    /// Version of the format, [`FORMAT_VERSION`].
    pub format: i64,
    /// Title of the picture.
    pub title: String,
    /// What of its source the scene lacks, for the warning of every command that reads it; nothing if it has all.
    pub incomplete: Option<String>,
    /// Colour of a pixel that no object covers, 0 to 1 for each of red, green, blue.
    pub background: [f64; 3],
    /// Ambient light `I_a`, 0 to 1 for each of red, green, blue.
    pub ambient: [f64; 3],
    /// Size of the picture unless the user asks for another.
    pub image: ImageSize,
    /// The first observer, who is looked through unless another is active.
    pub camera: Camera,
    /// The other observers, each with a name.
    pub cameras: Vec<Camera>,
    /// Name of the observer who is looked through; the first if there is none.
    pub active_camera: Option<String>,
    /// Light sources; without any, only the ambient light shows the objects.
    pub lights: Vec<Light>,
    /// Materials, referred to by name.
    pub materials: Vec<Material>,
    /// Groups of objects, lights, cameras and groups.
    pub groups: Vec<Group>,
    /// Objects, in the order that breaks ties of equal depth (the first wins).
    pub objects: Vec<Object>,
    /// Structure files whose atoms become further objects, behind the others, once they are read.
    pub molecules: Vec<Molecule>,
    /// Images of an animation, in the order in which they are shown.
    pub images: Vec<KeyImage>,
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
        /// Distance from the eye at which the depth word begins; chosen for the scene if not given.
        near: Option<f64>,
        /// Where pixels are sampled: columns to the right and lines down from whole coordinates.
        sample_at: [f64; 2],
        /// Name, group and place.
        node: Node,
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
        /// Depth, in scene units, to be covered in front of and behind the screen plane, or more if the objects need
        /// it; chosen for the scene if not given.
        half_depth: Option<f64>,
        /// Where the depth word begins and ends, from the screen plane away from the observer; in the place of
        /// `half_depth`.
        ends: Option<[f64; 2]>,
        /// Where pixels are sampled: columns to the right and lines down from whole coordinates.
        sample_at: [f64; 2],
        /// Name, group and place.
        node: Node,
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
        /// Whether objects in its way keep its light off others.
        shadows: bool,
        /// Name, group and place.
        node: Node,
    },
    /// Light from one point, without attenuation.
    Point {
        /// Where the source stands.
        position: [f64; 3],
        /// 0 to 1 for each of red, green, blue.
        colour: [f64; 3],
        /// Factor of the colour.
        intensity: f64,
        /// Whether objects in its way keep its light off others.
        shadows: bool,
        /// Name, group and place.
        node: Node,
    },
    /// Light from one point into a cone, without attenuation.
    Spot {
        /// Where the source stands: the apex of the cone.
        position: [f64; 3],
        /// The axis of the cone.
        aim: Aim,
        /// Angle in degrees between the axis and the cone.
        half_angle: f64,
        /// 0 to 1 for each of red, green, blue.
        colour: [f64; 3],
        /// Factor of the colour.
        intensity: f64,
        /// Whether objects in its way keep its light off others.
        shadows: bool,
        /// Name, group and place.
        node: Node,
    },
}

/// What a spot is directed at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Aim {
    /// A point on the axis.
    Target([f64; 3]),
    /// The direction of the axis.
    Towards([f64; 3]),
}

/// What a surface does with light: `I = ambient I_a + sum of I_p (diffuse cos + specular cos^exponent)` (thesis
/// section 1.2.4).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// Unique name.
    pub name: String,
    /// Colour of the ambient and diffuse terms, 0 to 1 for each of red, green, blue; a highlight has the colour of its
    /// source.
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

/// The processor that draws an object.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Processor {
    /// The quadric processor of the second generation.
    Quadric,
    /// The patch processor.
    Patch,
    /// The quadric processor of the first generation.
    FirstGeneration,
    /// The sphere or the cylinder processor, by paraboloids.
    Paraboloid,
    /// The processor of non-planar facets.
    CurvedFacet,
}

impl Processor {
    /// Its word in a scene file.
    pub fn name(self) -> &'static str {
        match self {
            Self::Quadric => "quadric",
            Self::Patch => "patch",
            Self::FirstGeneration => "first_generation",
            Self::Paraboloid => "paraboloid",
            Self::CurvedFacet => "curved_facet",
        }
    }
}

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

/// Flat facets with common corners.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Corners.
    pub vertices: Vec<[f64; 3]>,
    /// Facets of three or four corners, as indices of vertices from 0.
    pub faces: Vec<Vec<usize>>,
    /// A normal for each vertex, interpolated over the facets; flat facets if there are none.
    pub normals: Vec<[f64; 3]>,
}

/// What an object is. The quadrics are in canonical position, inside where the expression is negative or zero (thesis
/// Table 2.1).
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
    /// The convex solid that the cuts leave.
    Polyhedron,
    /// Flat facets.
    Mesh(Mesh),
    /// The quadric `sum of w_ii b_i^2 + sum of w_ij 2 b_i b_j = 0` inside a tetrahedron, b the barycentric coordinates
    /// of its corners.
    TetrahedronPatch {
        /// Corners 0 to 3.
        corners: Box<[[f64; 3]; 4]>,
        /// w00, w11, w22, w33, w01, w02, w03, w12, w13, w23.
        weights: Box<[f64; 10]>,
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

/// Most bytes of a scene file: a million objects take a hundred million.
const MAX_BYTES: u64 = 256 << 20;
/// Bytes of memory for each byte of a scene file, at least: 43 were measured of spheres, 53 of cut ellipsoids.
/// Reading takes the most; the preparation takes less than reading did.
const MEMORY_PER_BYTE: u64 = 40;

impl SceneFile {
    /// A scene with an observer and nothing else, to be filled.
    pub fn new(title: &str, camera: Camera) -> Self {
        Self {
            format: FORMAT_VERSION,
            title: title.to_owned(),
            background: [0.0; 3],
            ambient: white(),
            image: ImageSize::default(),
            camera,
            cameras: vec![],
            incomplete: None,
            active_camera: None,
            lights: vec![],
            materials: vec![],
            groups: vec![],
            objects: vec![],
            molecules: vec![],
            images: vec![],
        }
    }

    /// Reads and checks a scene file.
    pub fn read(path: &Path) -> Result<Self, SceneError> {
        let file = path.display().to_string();
        let unreadable = |source| SceneError::Unreadable {
            file: file.clone(),
            source,
        };
        let bytes = imogene_files::read(path, MAX_BYTES).map_err(unreadable)?;
        check_memory(bytes.len() as u64).map_err(unreadable)?;
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
        let syntax = |error| SceneError::syntax(file, text, &error);
        // Read once for both, because reading takes longer than all else of a scene of ten thousand objects.
        let table = DeTable::parse(text).map_err(syntax)?;
        if !is_known_version(table.get_ref()) {
            check_version(text, file)?;
        }
        let scene = Self::deserialize(toml::Deserializer::from(table)).map_err(syntax)?;
        scene.validate_text().map_err(|error| error.in_file(file))?;
        Ok(scene)
    }

    /// The scene as the text of a scene file; [`SceneFile::parse`] reads it back as the same scene.
    pub fn to_toml(&self) -> Result<String, SceneError> {
        self.validate_text()?;
        toml::to_string(self).map_err(|source| SceneError::Unwritable { source })
    }
}

/// Refuses a text whose parts do not fit into memory, before the system ends the process for it.
fn check_memory(bytes: u64) -> std::io::Result<()> {
    let needed = bytes * MEMORY_PER_BYTE;
    let gib = |bytes: u64| bytes as f64 / f64::from(1 << 30);
    match imogene_files::free_memory() {
        Some(free) if needed > free => Err(std::io::Error::other(format!(
            "it takes {:.1} GiB of memory and more, and {:.1} GiB are free",
            gib(needed),
            gib(free)
        ))),
        _ => Ok(()),
    }
}

/// The version of the format is there and is ours.
fn is_known_version(table: &DeTable) -> bool {
    let version = table.get("format").map(|value| value.get_ref());
    let whole = version.and_then(|value| value.as_integer());
    whole.is_some_and(|number| number.as_str() == FORMAT_VERSION.to_string())
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

pub(super) fn white() -> [f64; 3] {
    [1.0; 3]
}

pub(super) fn upwards() -> [f64; 3] {
    [0.0, 1.0, 0.0]
}

pub(super) fn full() -> f64 {
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
