//! Frames prepared one after the other, each from what it has in common with the one before.

use crate::again::{Kept, Reuse, prepare_again};
use crate::context::Options;
use crate::error::PrepareError;
use crate::range::frame_keeping;
use crate::scene::PreparedScene;
use imogene_golden::format::Format;
use imogene_scene::animation::{FrameOf, Playback, PlaybackError};
use imogene_scene::{
    Camera, FramedObject, FramedScene, Object, RangeOrigin, SceneError, SceneFile,
};
use std::collections::HashMap;
use thiserror::Error;

/// Prepares the frames of an animation.
pub struct Animator<'a> {
    /// The frames.
    pub playback: Playback<'a>,
    size: (u32, u32),
    format: Format,
    options: Options,
    before: Option<Before>,
    kept: Kept,
}

/// The frame before, as it is compared with the next: in the numbers of the file, without any arithmetic.
struct Before {
    camera: Camera,
    /// Its objects are framed in the range that the camera suggests or names.
    is_suggested: bool,
    /// Objects and the indices of their materials, by their names.
    objects: HashMap<String, (Object, usize)>,
}

/// A frame that is ready to be drawn.
pub struct PreparedFrame {
    /// Which frame it is.
    pub frame: FrameOf,
    /// The scene in the camera frame.
    pub framed: FramedScene,
    /// Its words.
    pub prepared: PreparedScene,
    /// How much of them was computed for this frame.
    pub reuse: Reuse,
}

/// A frame that cannot be drawn.
#[derive(Debug, Error)]
#[error("image `{}`, frame {} of {}: {source}", frame.image, frame.step, frame.steps)]
pub struct FrameError {
    /// The frame.
    pub frame: FrameOf,
    /// What is wrong with it.
    pub source: Box<FrameProblem>,
}

/// Why a frame cannot be drawn, or an animation cannot be played.
#[derive(Debug, Error)]
pub enum FrameProblem {
    /// There are no frames, or the actions cannot be done.
    #[error(transparent)]
    Playback(#[from] PlaybackError),
    /// The scene cannot be had as the actions leave it.
    #[error(transparent)]
    Scene(#[from] SceneError),
    /// The words are too short for it.
    #[error(transparent)]
    Prepare(#[from] PrepareError),
}

impl<'a> Animator<'a> {
    /// The animation of a scene, drawn in pictures of a size, columns and lines, by a machine of a format.
    /// Fails if the scene is refused, or has no frames.
    pub fn new(
        file: &'a SceneFile,
        size: (u32, u32),
        format: Format,
        options: Options,
    ) -> Result<Animator<'a>, FrameProblem> {
        file.validate()?;
        Ok(Animator {
            playback: Playback::new(file)?,
            size,
            format,
            options,
            before: None,
            kept: Kept::default(),
        })
    }

    /// Prepares a frame, counted from 0; any order is possible, neighbours have the most in common. `done` is called
    /// once a step, of which there are about as many as objects and shadows.
    /// Fails if the actions of the frame bring something where it cannot be drawn.
    /// Panics if there is no such frame.
    pub fn prepare(
        &mut self,
        index: usize,
        done: &(impl Fn() + Sync),
    ) -> Result<PreparedFrame, FrameError> {
        self.attempt(index, done).map_err(|source| FrameError {
            frame: self.playback.frame(index),
            source: Box::new(source),
        })
    }

    fn attempt(
        &mut self,
        index: usize,
        done: &(impl Fn() + Sync),
    ) -> Result<PreparedFrame, FrameProblem> {
        let scene = self.playback.scene(index)?;
        let flat = scene.flattened();
        let (width, height) = self.size;
        let framed = frame_keeping(
            &flat,
            (width, height),
            |index, material| {
                let object = &flat.objects[index];
                match self.framed_before(object, material, &flat.camera) {
                    Some(kept) => Ok(Some(kept.clone())),
                    None => flat.check_moved(object).map(|()| None),
                }
            },
            done,
        )?;
        let options = self.options;
        let (prepared, reuse) = prepare_again(&framed, self.format, options, &mut self.kept, done)?;
        self.before = Some(Before::of(flat.into_owned(), &framed));
        Ok(PreparedFrame {
            frame: self.playback.frame(index),
            framed,
            prepared,
            reuse,
        })
    }

    /// The object as it was framed, if it and the camera are those of the frame before.
    fn framed_before(
        &self,
        object: &Object,
        material: usize,
        camera: &Camera,
    ) -> Option<&FramedObject> {
        // Objects are handed on in the range that the camera suggests alone.
        let before = self.before.as_ref();
        let before = before.filter(|b| b.camera == *camera && b.is_suggested)?;
        let (known, known_material) = before.objects.get(&object.name)?;
        let same = *known_material == material && known == object;
        same.then(|| self.kept.framed(&object.name)).flatten()
    }
}

impl Before {
    fn of(flat: SceneFile, framed: &FramedScene) -> Before {
        let materials = framed.objects.iter().map(FramedObject::material);
        let objects = flat.objects.into_iter().zip(materials);
        Before {
            is_suggested: framed.range.origin != RangeOrigin::Scene,
            camera: flat.camera,
            objects: objects
                .map(|(object, material)| (object.name.clone(), (object, material)))
                .collect(),
        }
    }
}
