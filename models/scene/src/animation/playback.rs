//! The frames of an animation, and the scene in each of them.

use super::moves::Part;
use super::state::{MAX_MOVES, State};
use crate::{KeyImage, SceneFile};
use std::collections::HashMap;
use thiserror::Error;

/// A scene whose images cannot be played.
#[derive(Debug, Error)]
pub enum PlaybackError {
    /// There is nothing to play.
    #[error(
        "the scene has no images to play; `[[images]]`, at least one of them active, are needed for frames"
    )]
    NoFrames,
    /// An element was moved in too many ways.
    #[error(
        "image `{image}`: the placement of `{target}` has more than {MAX_MOVES} steps by then; \
         a chain of images may add {MAX_MOVES} to each placement, turns about one axis one after the other counted once"
    )]
    TooManyMoves {
        /// The image.
        image: String,
        /// What is moved.
        target: String,
    },
}

/// Which frame of which image.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameOf {
    /// Name of the image.
    pub image: String,
    /// Its frame, from 1.
    pub step: u32,
    /// Frames of the image.
    pub steps: u32,
    /// Seconds that it is shown.
    pub duration: f64,
}

/// An animation, frame by frame.
pub struct Playback<'a> {
    file: &'a SceneFile,
    /// Where each image starts from.
    parents: Vec<Option<usize>>,
    /// The image and the part of each frame.
    frames: Vec<(usize, Part)>,
}

impl<'a> Playback<'a> {
    /// The frames of a checked scene: those of its active images, in their order.
    ///
    /// # Errors
    ///
    /// Without any active image.
    pub fn new(file: &'a SceneFile) -> Result<Playback<'a>, PlaybackError> {
        let images = || file.images.iter().enumerate();
        let named: HashMap<&str, usize> = images().map(|(i, own)| (&*own.name, i)).collect();
        let parent = |image: &KeyImage| {
            let name = image.parent.as_deref();
            name.and_then(|name| named.get(name).copied())
        };
        let of_image = |(index, image): (usize, &KeyImage)| {
            let steps = image.steps;
            (1..=steps).map(move |done| (index, Part { done, steps }))
        };
        let active = images().filter(|(_, image)| image.active);
        let frames: Vec<(usize, Part)> = active.flat_map(of_image).collect();
        if frames.is_empty() {
            return Err(PlaybackError::NoFrames);
        }
        Ok(Playback {
            file,
            parents: file.images.iter().map(parent).collect(),
            frames,
        })
    }

    /// How many frames there are, at least one.
    pub fn count(&self) -> usize {
        self.frames.len()
    }

    /// What a frame is, counted from 0.
    ///
    /// # Panics
    ///
    /// If there is no such frame.
    pub fn frame(&self, index: usize) -> FrameOf {
        let (image, part) = self.frames[index];
        let image = &self.file.images[image];
        FrameOf {
            image: image.name.clone(),
            step: part.done,
            steps: part.steps,
            duration: image.duration,
        }
    }

    /// The scene in a frame, counted from 0, as a scene file without images.
    ///
    /// It is the scene as it is written, with the actions of the chain of parents done, and then the frame's part of
    /// those of its own image.
    ///
    /// # Errors
    ///
    /// If the chain adds more than [`MAX_MOVES`] steps to a placement.
    ///
    /// # Panics
    ///
    /// If there is no such frame.
    pub fn scene(&self, index: usize) -> Result<SceneFile, PlaybackError> {
        let (image, part) = self.frames[index];
        let chain = std::iter::successors(Some(image), |image| self.parents[*image]);
        let mut chain: Vec<usize> = chain.collect();
        chain.reverse();
        let mut state = State::default();
        for ancestor in chain {
            let part = if ancestor == image { part } else { Part::WHOLE };
            let image = &self.file.images[ancestor];
            for action in &image.actions {
                let done = state.act(action, part, self.file);
                done.map_err(|target| PlaybackError::TooManyMoves {
                    image: image.name.clone(),
                    target: target.to_owned(),
                })?;
            }
        }
        Ok(state.scene(self.file))
    }

    /// All frames as scenes, each under the name of the file and its place in it.
    ///
    /// # Errors
    ///
    /// Those of [`Playback::scene`].
    pub fn scenes(&self, file: &str) -> Result<Vec<(String, SceneFile)>, PlaybackError> {
        let named = |index: usize| {
            let FrameOf {
                image, step, steps, ..
            } = self.frame(index);
            let name = format!("{file}, image `{image}`, frame {step} of {steps}");
            Ok((name, self.scene(index)?))
        };
        (0..self.count()).map(named).collect()
    }
}
