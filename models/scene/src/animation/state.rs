//! What the images so far have made of a scene.

use super::moves::{Moves, Part};
use crate::{Action, SceneFile};
use std::collections::HashMap;

/// Most steps that the actions of a chain of images may add to one placement, those that are one step counted once.
///
/// Every turn that is not a quarter lengthens the exact entries of a placement by the digits of a sine.
pub const MAX_MOVES: usize = 64;

/// The changes of a scene, by names: only what was touched.
#[derive(Clone, Debug, Default)]
pub(super) struct State<'a> {
    moves: HashMap<&'a str, Moves>,
    shown: HashMap<&'a str, bool>,
    intensities: HashMap<&'a str, f64>,
    focals: HashMap<&'a str, f64>,
    active_camera: Option<&'a str>,
}

impl<'a> State<'a> {
    /// Does a part of an action on the scene; a switch is thrown at once. The name of what has been moved in too many
    /// ways is refused.
    pub fn act(
        &mut self,
        action: &'a Action,
        part: Part,
        scene: &SceneFile,
    ) -> Result<(), &'a str> {
        match action {
            Action::Move {
                target,
                step,
                frame,
            } => {
                let moves = self.moves.entry(target).or_default();
                moves.add(part.of_step(step), *frame);
                if moves.count() > MAX_MOVES {
                    return Err(target);
                }
            }
            Action::Show { target, show } => {
                self.shown.insert(target, *show);
            }
            Action::Intensity { light, intensity } => {
                let now = self.intensities.entry(light);
                let now = now.or_insert_with(|| intensity_of(scene, light));
                *now = part.between(*now, *intensity);
            }
            Action::Focal { camera, focal } => {
                let now = self.focals.entry(camera);
                let now = now.or_insert_with(|| focal_of(scene, camera));
                *now = part.between(*now, *focal);
            }
            Action::ActiveCamera(name) => self.active_camera = Some(name),
        }
        Ok(())
    }

    /// The scene with these changes, and without images.
    pub fn scene(&self, file: &SceneFile) -> SceneFile {
        let mut scene = file.clone();
        scene.images.clear();
        for object in &mut scene.objects {
            self.place(&object.name, &mut object.place);
            self.show(&object.name, &mut object.visible);
        }
        for group in &mut scene.groups {
            self.place(&group.name, &mut group.place);
            self.show(&group.name, &mut group.visible);
        }
        for light in &mut scene.lights {
            let Some(name) = light.node.name.clone() else {
                continue;
            };
            self.place(&name, &mut light.node.place);
            self.show(&name, &mut light.node.visible);
            if let Some(intensity) = self.intensities.get(name.as_str()) {
                light.intensity = *intensity;
            }
        }
        for camera in std::iter::once(&mut scene.camera).chain(&mut scene.cameras) {
            let Some(name) = camera.node.name.clone() else {
                continue;
            };
            self.place(&name, &mut camera.node.place);
            if let Some(focal) = self.focals.get(name.as_str()) {
                camera.set_focal(*focal);
            }
        }
        if let Some(name) = self.active_camera {
            scene.active_camera = Some(name.to_owned());
        }
        scene
    }

    fn place(&self, name: &str, place: &mut Vec<crate::Step>) {
        if let Some(moves) = self.moves.get(name) {
            *place = moves.around(place);
        }
    }

    fn show(&self, name: &str, visible: &mut bool) {
        if let Some(show) = self.shown.get(name) {
            *visible = *show;
        }
    }
}

fn intensity_of(scene: &SceneFile, name: &str) -> f64 {
    let mut lights = scene.lights.iter();
    let light = lights.find(|light| light.node.name.as_deref() == Some(name));
    light.expect("checked: the light exists").intensity
}

fn focal_of(scene: &SceneFile, name: &str) -> f64 {
    let mut cameras = scene.all_cameras();
    let camera = cameras.find(|camera| camera.node.name.as_deref() == Some(name));
    let focal = camera.and_then(|camera| camera.focal());
    focal.expect("checked: a perspective camera")
}
