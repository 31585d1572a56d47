//! A scene without groups: what is seen of it, by whom, each part with its whole placement.
//!
//! A placement is a list of steps, so that the placement of a member is its own list followed by those of the groups
//! above it, and nothing is rounded.

use super::camera::Camera;
use super::error::SceneError;
use super::file::SceneFile;
use super::group::{Group, Node};
use super::image::Action;
use super::names::check_camera_name;
use super::step::Step;
use std::borrow::Cow;
use std::collections::HashMap;

pub(super) struct Groups<'a>(HashMap<&'a str, &'a Group>);

impl<'a> Groups<'a> {
    pub fn of(file: &'a SceneFile) -> Groups<'a> {
        Groups(file.groups.iter().map(|g| (g.name.as_str(), g)).collect())
    }

    /// The group of a name and all above it, innermost first. Checked scenes have no circles.
    pub fn chain(&self, name: Option<&'a str>) -> impl Iterator<Item = &'a Group> {
        let named = |name: &'a str| self.0.get(name).copied();
        std::iter::successors(name.and_then(named), move |group| {
            group.group.as_deref().and_then(named)
        })
    }

    /// Whether nothing above a member is hidden.
    fn shows(&self, group: Option<&'a str>) -> bool {
        self.chain(group).all(|group| group.visible)
    }

    /// A placement followed by those of the groups above.
    pub fn whole(&self, place: &[Step], group: Option<&'a str>) -> Vec<Step> {
        let above = self.chain(group).flat_map(|group| &group.place);
        place.iter().chain(above).cloned().collect()
    }

    fn flatten(&self, node: &mut Node, group: Option<&'a str>) {
        node.place = self.whole(&node.place, group);
        node.group = None;
    }
}

impl SceneFile {
    /// The observer who is looked through.
    pub fn active(&self) -> &Camera {
        let name = self.active_camera.as_deref();
        let named = |camera: &&Camera| camera.node.name.as_deref() == name;
        let active = name.and_then(|_| self.all_cameras().find(named));
        active.unwrap_or(&self.camera)
    }

    /// Looks through another camera, in all images.
    ///
    /// # Errors
    ///
    /// If no camera has this name.
    pub fn look_through(&mut self, name: &str) -> Result<(), SceneError> {
        check_camera_name(self, "camera", name)?;
        self.active_camera = Some(name.to_owned());
        for image in &mut self.images {
            let stays = |action: &Action| !matches!(action, Action::ActiveCamera { .. });
            image.actions.retain(stays);
        }
        Ok(())
    }

    /// All observers, the first one first.
    pub fn all_cameras(&self) -> impl Iterator<Item = &Camera> {
        std::iter::once(&self.camera).chain(&self.cameras)
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
        let groups = Groups::of(self);
        let active = self.active();
        let mut camera = active.clone();
        groups.flatten(&mut camera.node, active.node.group.as_deref());
        let mut flat = SceneFile::new(&self.title, camera);
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
        Cow::Owned(SceneFile {
            format: self.format,
            background: self.background,
            ambient: self.ambient,
            attenuation: self.attenuation,
            image: self.image,
            materials: self.materials.clone(),
            solids: self.solids.clone(),
            ..flat
        })
    }
}
