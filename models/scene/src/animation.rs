//! Animations: the frames of a scene with key images (source: animator).
//!
//! [`Playback`] says which frames there are and what the scene is in each of them, again as a
//! [`SceneFile`].

use super::camera::Camera;
use super::file::SceneFile;
use super::image::{Action, KeyImage, MoveFrame};
use super::step::{Rotation, Scale, Step};
use imogene_algebra::rational::{from_decimal, integer, to_f64};
use std::collections::HashMap;
use thiserror::Error;

/// Most steps that the actions of a chain of images may add to one placement, those that are one step counted once.
///
/// Every turn that is not a quarter lengthens the exact entries of a placement by the digits of a sine.
pub const MAX_MOVES: usize = 64;

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
    /// The frames of a checked scene: those of its active images, in their order. Fails without any active image.
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

    /// What a frame is, counted from 0. Panics if there is no such frame.
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
    /// those of its own image. Fails if the chain adds more than [`MAX_MOVES`] steps to a placement. Panics if there
    /// is no such frame.
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
    pub fn scenes(&self, file: &str) -> Result<Vec<(String, SceneFile)>, PlaybackError> {
        let named = |index: usize| {
            let of = self.frame(index);
            let place = format!("frame {} of {}", of.step, of.steps);
            let name = format!("{file}, image `{}`, {place}", of.image);
            Ok((name, self.scene(index)?))
        };
        (0..self.count()).map(named).collect()
    }
}

/// The changes of a scene, by names: only what was touched.
#[derive(Clone, Debug, Default)]
struct State<'a> {
    moves: HashMap<&'a str, Moves>,
    shown: HashMap<&'a str, bool>,
    intensities: HashMap<&'a str, f64>,
    focals: HashMap<&'a str, f64>,
    active_camera: Option<&'a str>,
}

impl<'a> State<'a> {
    /// Does a part of an action on the scene; a switch is thrown at once. The name of what has been moved in too many
    /// ways is refused.
    fn act(&mut self, action: &'a Action, part: Part, scene: &SceneFile) -> Result<(), &'a str> {
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
                let now = self.intensities.entry(light).or_insert_with(|| {
                    let mut lights = scene.lights.iter();
                    let own = lights.find(|own| own.node.name.as_ref() == Some(light));
                    own.expect("checked: the light exists").intensity
                });
                *now = part.between(*now, *intensity);
            }
            Action::Focal { camera, focal } => {
                let now = self.focals.entry(camera).or_insert_with(|| {
                    let own = scene.camera_named(camera).and_then(Camera::focal);
                    own.expect("checked: a perspective camera")
                });
                *now = part.between(*now, *focal);
            }
            Action::ActiveCamera { active_camera } => self.active_camera = Some(active_camera),
        }
        Ok(())
    }

    /// The scene with these changes, and without images.
    fn scene(&self, file: &SceneFile) -> SceneFile {
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
        let active = self.active_camera.map(str::to_owned);
        scene.active_camera = active.or(scene.active_camera);
        scene
    }

    fn place(&self, name: &str, place: &mut Vec<Step>) {
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

/// `done` of `steps` equal parts, `0 < done <= steps`; all of them are what is written, unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    /// Parts that are done.
    pub done: u32,
    /// Parts of the whole.
    pub steps: u32,
}

impl Part {
    /// The whole.
    pub const WHOLE: Part = Part { done: 1, steps: 1 };

    fn is_whole(self) -> bool {
        self.done == self.steps
    }

    /// The part of the way from one value to another: the nearest `f64` to the exact one.
    pub fn between(self, from: f64, to: f64) -> f64 {
        if self.is_whole() {
            return to;
        }
        let [done, steps] = [self.done, self.steps].map(|n| integer(i64::from(n)));
        let [from, to] = [from, to].map(from_decimal);
        to_f64(&(&from + (to - &from) * done / steps))
    }

    /// The part of a step: displacements and angles grow by equal amounts, factors by equal ratios.
    pub fn of_step(self, step: &Step) -> Step {
        if self.is_whole() {
            return step.clone();
        }
        let power = f64::from(self.done) / f64::from(self.steps);
        match step {
            Step::Translate(offset) => {
                Step::Translate(offset.map(|value| self.between(0.0, value)))
            }
            Step::Rotate(rotation) => Step::Rotate(Rotation {
                axis: rotation.axis,
                degrees: self.between(0.0, rotation.degrees),
            }),
            Step::Scale(Scale::Uniform(factor)) => Step::Scale(Scale::Uniform(factor.powf(power))),
            Step::Scale(Scale::PerAxis(factors)) => {
                Step::Scale(Scale::PerAxis(factors.map(|factor| factor.powf(power))))
            }
        }
    }
}

/// What actions add to the placement of one element.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moves {
    /// In its own frame: before the placement that is written.
    own: Vec<Step>,
    /// In the frame of its group: after it.
    parent: Vec<Step>,
}

impl Moves {
    /// Adds a step, in one with the last one in its frame where the sum of both is one step.
    pub fn add(&mut self, step: Step, frame: MoveFrame) {
        let last = match frame {
            MoveFrame::Parent => self.parent.last_mut(),
            MoveFrame::Own => self.own.first_mut(),
        };
        match (last, frame) {
            (Some(last), _) if let Some(sum) = sum(last, &step) => *last = sum,
            (_, MoveFrame::Parent) => self.parent.push(step),
            (_, MoveFrame::Own) => self.own.insert(0, step),
        }
    }

    /// Steps that are not one.
    pub fn count(&self) -> usize {
        self.own.len() + self.parent.len()
    }

    /// The whole placement.
    pub fn around(&self, place: &[Step]) -> Vec<Step> {
        [&self.own, place, &self.parent].concat()
    }
}

/// Two steps as one: turns about the same axis by the sum of their angles, displacements by theirs where it is a number
/// that can be written.
///
/// Without the first the entries of a placement would grow by the digits of a sine at every turn of a long animation.
fn sum(one: &Step, other: &Step) -> Option<Step> {
    let exact = |a: f64, b: f64| from_decimal(a) + from_decimal(b);
    match (one, other) {
        (Step::Rotate(a), Step::Rotate(b)) if a.axis == b.axis => Some(Step::Rotate(Rotation {
            axis: a.axis,
            degrees: to_f64(&exact(a.degrees, b.degrees)),
        })),
        (Step::Translate(a), Step::Translate(b)) => {
            let sums: [_; 3] = std::array::from_fn(|k| exact(a[k], b[k]));
            let rounded = sums.each_ref().map(to_f64);
            let kept = sums.iter().zip(rounded).all(|(s, r)| from_decimal(r) == *s);
            kept.then_some(Step::Translate(rounded))
        }
        _ => None,
    }
}
