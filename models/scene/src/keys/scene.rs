//! The top level of a scene file as it stands in the text.

use super::numbers;
use crate::file::{Camera, ImageSize, Light, Material, Object, SceneFile, white};
use crate::group::Group;
use crate::image::KeyImage;
use crate::molecule::Molecule;
use serde::{Deserialize, Serialize};

/// The keys of the top level as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct SceneKeys {
    format: i64,
    title: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    incomplete: Option<String>,
    #[serde(default, deserialize_with = "numbers")]
    background: [f64; 3],
    #[serde(default = "white", deserialize_with = "numbers")]
    ambient: [f64; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    active_camera: Option<String>,
    #[serde(default)]
    image: ImageSize,
    camera: Option<Camera>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    cameras: Vec<Camera>,
    #[serde(default)]
    lights: Vec<Light>,
    #[serde(default)]
    materials: Vec<Material>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    groups: Vec<Group>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    objects: Vec<Object>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    molecules: Vec<Molecule>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    images: Vec<KeyImage>,
}

impl TryFrom<SceneKeys> for SceneFile {
    type Error = String;

    fn try_from(keys: SceneKeys) -> Result<Self, String> {
        let mut cameras = keys.cameras;
        if let Some(index) = cameras.iter().position(|c| c.node().name.is_none()) {
            return Err(format!(
                "cameras[{index}] has no `name`; each of `[[cameras]]` needs one, `[camera]` alone may go without"
            ));
        }
        let camera = match keys.camera {
            Some(camera) => camera,
            None if cameras.is_empty() => {
                return Err(
                    "missing field `camera`; a scene needs `[camera]`, or `[[cameras]]` with at least one"
                        .into(),
                );
            }
            None => cameras.remove(0),
        };
        Ok(Self {
            format: keys.format,
            title: keys.title,
            background: keys.background,
            ambient: keys.ambient,
            image: keys.image,
            camera,
            cameras,
            incomplete: keys.incomplete,
            active_camera: keys.active_camera,
            lights: keys.lights,
            materials: keys.materials,
            groups: keys.groups,
            objects: keys.objects,
            molecules: keys.molecules,
            images: keys.images,
        })
    }
}

impl From<SceneFile> for SceneKeys {
    fn from(file: SceneFile) -> Self {
        Self {
            format: file.format,
            title: file.title,
            background: file.background,
            ambient: file.ambient,
            incomplete: file.incomplete,
            active_camera: file.active_camera,
            image: file.image,
            camera: Some(file.camera),
            cameras: file.cameras,
            lights: file.lights,
            materials: file.materials,
            groups: file.groups,
            objects: file.objects,
            molecules: file.molecules,
            images: file.images,
        }
    }
}
