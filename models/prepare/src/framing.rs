//! A scene file in the camera frame of a picture.

use super::range::frame_keeping;
use super::unseen::Seen;
use imogene_golden::format::Format;
use imogene_scene::{FramedScene, SceneError, SceneFile};
use std::borrow::Borrow;

/// A scene file in the camera frame of a picture.
pub trait Framing: Borrow<SceneFile> {
    /// The scene in the camera frame of a picture of `width` by `height` pixels, with the range of the depth word
    /// that it names or that is chosen for it.
    /// Fails on what the checks of a scene refuse, such as a size that is out of range.
    fn frame(&self, width: u32, height: u32) -> Result<FramedScene, SceneError> {
        self.frame_reporting(width, height, &|| ())
    }

    /// The same; `done` is called about once for each of [`Framing::frame_steps`], from any thread.
    fn frame_reporting(
        &self,
        width: u32,
        height: u32,
        done: &(impl Fn() + Sync),
    ) -> Result<FramedScene, SceneError> {
        let file = self.borrow();
        file.validate()?;
        frame_keeping(&file.flattened(), (width, height), |_, _| Ok(None), done)
    }

    /// The same without objects that are proven to be nowhere in the picture in a format:
    /// [`FramedObject::Unseen`](imogene_scene::FramedObject::Unseen) stands in their place, so that the index of every
    /// other object stays its id. What is drawn of the others is bit for bit the same.
    ///
    /// A scene with shadows or spots keeps all its objects: what is hidden may cast a shadow.
    fn frame_seen(
        &self,
        width: u32,
        height: u32,
        format: &Format,
    ) -> Result<FramedScene, SceneError> {
        Seen::of(self.borrow(), (width, height), format, &|| ())?.frame(&|| ())
    }

    /// Steps of the framing, for a bar of its progress.
    fn frame_steps(&self) -> u64 {
        2 * self.borrow().objects.len() as u64
    }
}

impl Framing for SceneFile {}
