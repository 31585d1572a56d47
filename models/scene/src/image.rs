//! Key images of an animation: what each changes, and how long it is shown (source: animator, images and actions).

use super::keys::{Three, is_default, is_yes, number, present, require, yes};
use super::step::{Rotation, Scale, Step, StepKeys};
use serde::{Deserialize, Serialize};

/// One image of an animation, of one frame or of several in-between frames.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KeyImage {
    /// Unique among the images.
    pub name: String,
    /// Name of the image whose last frame it starts from, wherever that stands in the sequence; without it the scene
    /// as it is written, the image -1 of the source.
    pub parent: Option<String>,
    /// Seconds that each of its frames is shown.
    #[serde(default = "frame_duration")]
    pub duration: f64,
    /// Frames over which its actions are spread in equal parts.
    #[serde(default = "number::<_, 1>")]
    pub steps: u32,
    /// `false`: no frames of the sequence; other images may still start from it.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub active: bool,
    /// What the author wants to remember.
    pub note: Option<String>,
    /// What it changes, in this order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub actions: Vec<Action>,
}

/// One change that an image makes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "ActionKeys", untagged)]
pub enum Action {
    /// Moves an object, a group, a light or a camera.
    Move {
        /// Its name.
        target: String,
        /// By what.
        #[serde(flatten)]
        step: Step,
        /// In which frame.
        #[serde(skip_serializing_if = "is_default")]
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
        /// Millimetres on a film of 24 x 36, as [`Camera::focal`](crate::Camera::focal).
        focal: f64,
    },
    /// Makes a camera the one that is looked through.
    ActiveCamera {
        /// Its name.
        active_camera: String,
    },
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

/// Seconds that a frame is shown unless its image says otherwise: the 25 images a second of the source.
fn frame_duration() -> f64 {
    0.04
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ActionKeys {
    target: Option<String>,
    translate: Option<Three>,
    rotate: Option<Rotation>,
    scale: Option<Scale>,
    frame: Option<MoveFrame>,
    show: Option<bool>,
    light: Option<String>,
    intensity: Option<f64>,
    camera: Option<String>,
    focal: Option<f64>,
    active_camera: Option<String>,
}

/// The forms of an action, by the key that names what is changed: that key, the others it takes, and how it is written.
const FORMS: [(&str, &[&str], &str); 4] = [
    (
        "target",
        &["translate", "rotate", "scale", "frame", "show"],
        "{ target = NAME, translate | rotate | scale = ... } or { target = NAME, show = true | false }",
    ),
    (
        "light",
        &["intensity"],
        "{ light = NAME, intensity = FACTOR }",
    ),
    (
        "camera",
        &["focal"],
        "{ camera = NAME, focal = MILLIMETRES }",
    ),
    ("active_camera", &[], "{ active_camera = NAME }"),
];

impl ActionKeys {
    /// Refuses keys that do not go together.
    fn check_form(&self) -> Result<(), String> {
        let keys = present!(
            self; target, translate, rotate, scale, frame, show, light, intensity, camera, focal, active_camera
        );
        let present = keys.into_iter().filter(|(_, present)| *present);
        let present: Vec<&str> = present.map(|(key, _)| key).collect();
        let form = FORMS.iter().find(|(key, ..)| present.contains(key));
        let Some((name, others, written)) = form else {
            let forms: Vec<_> = FORMS.iter().map(|(.., written)| *written).collect();
            return Err(format!(
                "the action does not name what it changes; {} would be accepted",
                forms.join(", ")
            ));
        };
        let is_other = |key: &&&str| *key != name && !others.contains(*key);
        match present.iter().find(is_other) {
            Some(key) => Err(format!(
                "an action with `{name}` has no `{key}`; {written} would be accepted"
            )),
            None => Ok(()),
        }
    }

    /// A move, or showing and hiding.
    fn of_target(self, target: String) -> Result<Action, String> {
        let moves = self.translate.is_some() || self.rotate.is_some() || self.scale.is_some();
        let problem = match self.show {
            Some(_) if moves || self.frame.is_some() => {
                "moves and shows at once; write each in its own { }, in the order they apply"
            }
            Some(show) => return Ok(Action::Show { target, show }),
            None if !moves => "is empty; it needs one of `translate`, `rotate`, `scale`, `show`",
            None => {
                let step = Step::try_from(StepKeys {
                    translate: self.translate,
                    rotate: self.rotate,
                    scale: self.scale,
                })?;
                let frame = self.frame.unwrap_or_default();
                return Ok(Action::Move {
                    target,
                    step,
                    frame,
                });
            }
        };
        Err(format!("the action on `{target}` {problem}"))
    }
}

impl TryFrom<ActionKeys> for Action {
    type Error = String;

    fn try_from(mut keys: ActionKeys) -> Result<Self, String> {
        keys.check_form()?;
        if let Some(target) = keys.target.take() {
            return keys.of_target(target);
        }
        if let Some(light) = keys.light {
            let wanted = "`intensity`, the factor of its colour that it has in the end";
            let intensity = require(keys.intensity, "an action with `light`", wanted)?;
            return Ok(Self::Intensity { light, intensity });
        }
        if let Some(camera) = keys.camera {
            let wanted = "`focal`, millimetres on a film of 24 x 36";
            let focal = require(keys.focal, "an action with `camera`", wanted)?;
            return Ok(Self::Focal { camera, focal });
        }
        let active_camera = keys.active_camera.expect("one of the forms is there");
        Ok(Self::ActiveCamera { active_camera })
    }
}
