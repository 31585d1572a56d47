//! Key images of an animation: what each changes, and how long it is shown (source: animator, images and actions).

use super::file::Step;
use super::keys::{ActionKeys, is_yes, yes};
use serde::{Deserialize, Serialize};

/// Seconds that a frame is shown unless its image says otherwise: the 25 images a second of the source.
pub const FRAME_DURATION: f64 = 0.04;

/// One image of an animation, of one frame or of several in-between frames.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KeyImage {
    /// Unique among the images.
    pub name: String,
    /// Name of the image whose last frame it starts from, wherever that stands in the sequence; without it the scene as it is written, the image -1 of the
    /// source.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub parent: Option<String>,
    /// Seconds that each of its frames is shown.
    #[serde(default = "frame_duration")]
    pub duration: f64,
    /// Frames over which its actions are spread in equal parts.
    #[serde(default = "one")]
    pub steps: u32,
    /// `false`: no frames of the sequence; other images may still start from it.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub active: bool,
    /// What the author wants to remember.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub note: Option<String>,
    /// What it changes, in this order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub actions: Vec<Action>,
}

/// One change that an image makes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "ActionKeys", into = "ActionKeys")]
pub enum Action {
    /// Moves an object, a group, a light or a camera.
    Move {
        /// Its name.
        target: String,
        /// By what.
        step: Step,
        /// In which frame.
        frame: MoveFrame,
    },
    /// Shows or hides an object, a group or a light.
    Show {
        /// Its name.
        target: String,
        /// Whether it is seen from now on.
        show: bool,
    },
    /// Dims a light or turns it up.
    Intensity {
        /// Its name.
        light: String,
        /// The factor of its colour that it has in the end.
        intensity: f64,
    },
    /// Changes the focal length of a perspective camera.
    Focal {
        /// Its name.
        camera: String,
        /// Millimetres on a film of 24 x 36, as [`Camera::focal`](super::Camera::focal).
        focal: f64,
    },
    /// Makes a camera the one that is looked through.
    ActiveCamera(
        /// Its name.
        String,
    ),
}

/// The frame that a move is given in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum MoveFrame {
    /// That of the group it belongs to, or of the scene: the step comes after its placement so far.
    #[default]
    Parent,
    /// Its own: the step comes before its placement so far, so that a turn is about its own origin.
    Own,
}

fn frame_duration() -> f64 {
    FRAME_DURATION
}

fn one() -> u32 {
    1
}
