//! A scene without groups: what is seen of it, by whom, each part with its whole placement.
//!
//! A placement is a list of steps, so that the placement of a member is its own list followed by those of the groups
//! above it, and nothing is rounded.

use super::camera::Camera;
use super::error::SceneError;
use super::file::SceneFile;
use super::group::Groups;
use super::image::Action;
use super::names::check_camera_name;
use std::borrow::Cow;

impl SceneFile {
    /// The observer who is looked through.
    pub fn active(&self) -> &Camera {
        let name = self.active_camera.as_deref();
        let active = name.and_then(|name| self.camera_named(name));
        active.unwrap_or(&self.camera)
    }

    /// Looks through another camera, in all images. Fails if no camera has this name.
    pub fn look_through(&mut self, name: &str) -> Result<(), SceneError> {
        check_camera_name(self, "camera", name)?;
        self.active_camera = Some(name.to_owned());
        for image in &mut self.images {
            let stays = |action: &Action| !matches!(action, Action::ActiveCamera { .. });
            image.actions.retain(stays);
        }
        Ok(())
    }

    /// The same picture without groups, images and what is not seen: objects, lights and the active camera have the
    /// steps of the groups above them in their own placements.
    ///
    /// The names of groups must be checked, as those of a scene that was read are.
    pub fn flattened(&self) -> Cow<'_, SceneFile> {
        let plain = self.groups.is_empty()
            && self.images.is_empty()
            && self.cameras.is_empty()
            && self.objects.iter().all(|object| object.visible)
            && self.lights.iter().all(|light| light.node.visible);
        if plain {
            return Cow::Borrowed(self);
        }
        let groups = Groups::of(&self.groups);
        let active = self.active();
        let mut camera = active.clone();
        groups.flatten(&mut camera.node, active.node.group.as_deref());
        let mut flat = SceneFile {
            format: self.format,
            background: self.background,
            ambient: self.ambient,
            attenuation: self.attenuation,
            image: self.image,
            materials: self.materials.clone(),
            solids: self.solids.clone(),
            ..SceneFile::new(&self.title, camera)
        };
        for light in &self.lights {
            let group = light.node.group.as_deref();
            if light.node.visible && groups.shows(group) {
                let mut light = light.clone();
                groups.flatten(&mut light.node, group);
                flat.lights.push(light);
            }
        }
        for object in &self.objects {
            let group = object.group.as_deref();
            if object.visible && groups.shows(group) {
                let mut object = object.clone();
                object.place = groups.whole(&object.place, group);
                object.group = None;
                flat.objects.push(object);
            }
        }
        Cow::Owned(flat)
    }
}
