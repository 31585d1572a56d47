//! What a scene file says. `docs/scene-format.md` is its user's page.

use super::camera::Camera;
use super::group::Group;
use super::image::KeyImage;
use super::keys::{number, numbers, white};
use super::light::Light;
use super::molecule::Molecule;
use super::object::Object;
use super::solid::Solid;
use serde::{Deserialize, Serialize};

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
    #[serde(default = "tenths::<2>")]
    pub ambient: f64,
    /// Share of the diffused light, 0 to 1.
    #[serde(default = "tenths::<7>")]
    pub diffuse: f64,
    /// Share of the mirrored light, 0 to 1.
    #[serde(default = "tenths::<3>")]
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

fn tenths<const N: u8>() -> f64 {
    f64::from(N) / 10.0
}

fn is_opaque(opacity: &f64) -> bool {
    *opacity == 1.0
}

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

    /// All observers, the first one first.
    pub fn all_cameras(&self) -> impl Iterator<Item = &Camera> {
        std::iter::once(&self.camera).chain(&self.cameras)
    }

    /// The observer of a name.
    pub(super) fn camera_named(&self, name: &str) -> Option<&Camera> {
        let mut cameras = self.all_cameras();
        cameras.find(|camera| camera.node.name.as_deref() == Some(name))
    }
}
