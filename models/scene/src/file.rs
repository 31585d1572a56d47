//! The scene file: TOML, written by hand or by an importer. `docs/scene-format.md` is its user's page.

use super::camera::Camera;
use super::error::{SceneError, line_and_column};
use super::group::Group;
use super::image::KeyImage;
use super::keys::{number, numbers, white};
use super::light::Light;
use super::molecule::Molecule;
use super::object::Object;
use super::solid::Solid;
use serde::{Deserialize, Serialize};
use std::path::Path;
use toml::de::{DeArray, DeTable, DeValue};

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
    /// What of its source the scene lacks, for the warning of every command that reads it; `None` if it has all.
    pub incomplete: Option<String>,
    /// Colour of a pixel that no object covers, 0 to 1 for each of red, green, blue.
    #[serde(default, deserialize_with = "numbers")]
    pub background: [f64; 3],
    /// Ambient light `I_a`, 0 to 1 for each of red, green, blue.
    #[serde(default = "white", deserialize_with = "numbers")]
    pub ambient: [f64; 3],
    /// Distance `k` from the eye, in scene units, at which half of what the sources send is seen: `k / (d + k)` of it
    /// at a distance d. All of it if there is none.
    pub attenuation: Option<f64>,
    /// Name of the observer who is looked through; the first if there is none.
    pub active_camera: Option<String>,
    /// Size of the picture unless the user asks for another.
    #[serde(default)]
    pub image: ImageSize,
    /// The first observer, who is looked through unless another is active.
    pub camera: Camera,
    /// The other observers, each with a name.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub cameras: Vec<Camera>,
    /// Light sources; without any, only the ambient light shows the objects.
    #[serde(default)]
    pub lights: Vec<Light>,
    /// Materials, referred to by name.
    #[serde(default)]
    pub materials: Vec<Material>,
    /// Groups of objects, lights, cameras and groups.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub groups: Vec<Group>,
    /// Objects, in the order that breaks ties of equal depth (the first wins).
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub objects: Vec<Object>,
    /// Solids made of objects, behind those that are in none where depths are equal.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub solids: Vec<Solid>,
    /// Structure files whose atoms become further objects, behind the others, once they are read.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub molecules: Vec<Molecule>,
    /// Images of an animation, in the order in which they are shown.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
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
    #[serde(default = "number::<_, 30>")]
    pub exponent: u32,
    /// Part of what is seen that is the surface and not what lies behind it, 0 to 1; with less than 1 it is
    /// transparent.
    #[serde(default = "number::<_, 1>", skip_serializing_if = "is_opaque")]
    pub opacity: f64,
}

impl Material {
    /// Is something seen through it?
    pub fn is_transparent(&self) -> bool {
        !is_opaque(&self.opacity)
    }
}

fn is_opaque(opacity: &f64) -> bool {
    *opacity == 1.0
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
            attenuation: None,
            image: ImageSize::default(),
            camera,
            cameras: vec![],
            incomplete: None,
            active_camera: None,
            lights: vec![],
            materials: vec![],
            groups: vec![],
            objects: vec![],
            solids: vec![],
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
        let text = std::str::from_utf8(&bytes).map_err(|error| {
            let offset = error.valid_up_to();
            let (line, _) = line_and_column(&String::from_utf8_lossy(&bytes[..offset]), offset);
            let file = file.clone();
            SceneError::NotText { file, line, offset }
        })?;
        Self::parse(text, &file)
    }

    /// Reads and checks the text of a scene; `file` is the name that messages give it.
    pub fn parse(text: &str, file: &str) -> Result<Self, SceneError> {
        let syntax = |error| SceneError::syntax(file, text, &error);
        // Read once for both, because reading takes longer than all else of a scene of ten thousand objects.
        let mut table = DeTable::parse(text).map_err(syntax)?;
        check_version(table.get_ref(), text, file)?;
        let leads = first_camera_leads(table.get_mut());
        let scene = Self::deserialize(toml::Deserializer::from(table)).map_err(syntax)?;
        let first = leads.then_some(&scene.camera);
        let mut cameras = first.into_iter().chain(&scene.cameras);
        if let Some(index) = cameras.position(|camera| camera.node.name.is_none()) {
            return Err(syntax(serde::de::Error::custom(format!(
                "cameras[{index}] has no `name`; each of `[[cameras]]` needs one, `[camera]` alone may go without"
            ))));
        }
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
    let Some(free) = imogene_files::free_memory().filter(|free| needed > *free) else {
        return Ok(());
    };
    let (needed, free) = (gib(needed), gib(free));
    Err(std::io::Error::other(format!(
        "it takes {needed:.1} GiB of memory and more, and {free:.1} GiB are free"
    )))
}

/// Without `[camera]` the first of `[[cameras]]` takes its place.
fn first_camera_leads(table: &mut DeTable) -> bool {
    if table.contains_key("camera") {
        return false;
    }
    let Some(DeValue::Array(cameras)) = table.get_mut("cameras").map(|list| list.get_mut()) else {
        return false;
    };
    let mut each = std::mem::replace(cameras, DeArray::new()).into_iter();
    let first = each.next();
    *cameras = each.collect();
    let leads = first.map(|own| table.insert(toml::Spanned::new(own.span(), "camera".into()), own));
    leads.is_some()
}

/// Refuses another version before its unknown keys are blamed on the author.
fn check_version(table: &DeTable, text: &str, file: &str) -> Result<(), SceneError> {
    let version = table.get("format").map(|value| value.get_ref());
    let whole = version.and_then(|value| value.as_integer());
    if whole.is_some_and(|number| number.as_str() == FORMAT_VERSION.to_string()) {
        return Ok(());
    }
    let table: toml::Table =
        toml::from_str(text).map_err(|error| SceneError::syntax(file, text, &error))?;
    let accepted = format!("this program reads `format = {FORMAT_VERSION}`");
    let refuse =
        |problem: String| Err(SceneError::value("format", problem, accepted).in_file(file));
    match table.get("format") {
        None if table.is_empty() => refuse("the file is empty".into()),
        None => refuse("the version of the format is missing".into()),
        Some(toml::Value::Integer(FORMAT_VERSION)) => Ok(()),
        Some(other) => refuse(format!("version {other} is not known")),
    }
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
