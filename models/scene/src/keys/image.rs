//! Actions of `[[images]]` as they stand in the file.

use super::{StepKeys, optional_numbers, require};
use crate::file::{Rotation, Scale, Step};
use crate::image::{Action, MoveFrame};
use serde::{Deserialize, Serialize};

/// The keys of an action as they stand in the file.
#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ActionKeys {
    #[serde(skip_serializing_if = "Option::is_none")]
    target: Option<String>,
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    translate: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    rotate: Option<Rotation>,
    #[serde(skip_serializing_if = "Option::is_none")]
    scale: Option<Scale>,
    #[serde(skip_serializing_if = "Option::is_none")]
    frame: Option<MoveFrame>,
    #[serde(skip_serializing_if = "Option::is_none")]
    show: Option<bool>,
    #[serde(skip_serializing_if = "Option::is_none")]
    light: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    intensity: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    camera: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    focal: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
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
    fn present(&self) -> Vec<&'static str> {
        let keys = [
            ("target", self.target.is_some()),
            ("translate", self.translate.is_some()),
            ("rotate", self.rotate.is_some()),
            ("scale", self.scale.is_some()),
            ("frame", self.frame.is_some()),
            ("show", self.show.is_some()),
            ("light", self.light.is_some()),
            ("intensity", self.intensity.is_some()),
            ("camera", self.camera.is_some()),
            ("focal", self.focal.is_some()),
            ("active_camera", self.active_camera.is_some()),
        ];
        let present = keys.into_iter().filter(|(_, present)| *present);
        present.map(|(key, _)| key).collect()
    }

    /// Refuses keys that do not go together.
    fn check_form(&self) -> Result<(), String> {
        let present = self.present();
        let form = FORMS.iter().find(|(key, ..)| present.contains(key));
        let Some((name, others, written)) = form else {
            let forms: Vec<_> = FORMS.iter().map(|(.., written)| *written).collect();
            return Err(format!(
                "the action does not name what it changes; {} would be accepted",
                forms.join(", ")
            ));
        };
        match present
            .iter()
            .find(|key| *key != name && !others.contains(key))
        {
            Some(key) => Err(format!(
                "an action with `{name}` has no `{key}`; {written} would be accepted"
            )),
            None => Ok(()),
        }
    }

    /// A move, or showing and hiding.
    fn of_target(self, target: String) -> Result<Action, String> {
        let moves = self.translate.is_some() || self.rotate.is_some() || self.scale.is_some();
        match self.show {
            Some(_) if moves || self.frame.is_some() => Err(format!(
                "the action on `{target}` moves and shows at once; write each in its own {{ }}, in the order they apply"
            )),
            Some(show) => Ok(Action::Show { target, show }),
            None if !moves => Err(format!(
                "the action on `{target}` is empty; it needs one of `translate`, `rotate`, `scale`, `show`"
            )),
            None => Ok(Action::Move {
                step: Step::try_from(StepKeys {
                    translate: self.translate,
                    rotate: self.rotate,
                    scale: self.scale,
                })?,
                frame: self.frame.unwrap_or_default(),
                target,
            }),
        }
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
        let name = keys.active_camera.expect("one of the forms is there");
        Ok(Self::ActiveCamera(name))
    }
}

impl From<Action> for ActionKeys {
    fn from(action: Action) -> Self {
        let none = Self::default();
        match action {
            Action::Move {
                target,
                step,
                frame,
            } => {
                let step = StepKeys::from(step);
                Self {
                    target: Some(target),
                    translate: step.translate,
                    rotate: step.rotate,
                    scale: step.scale,
                    frame: (frame == MoveFrame::Own).then_some(frame),
                    ..none
                }
            }
            Action::Show { target, show } => Self {
                target: Some(target),
                show: Some(show),
                ..none
            },
            Action::Intensity { light, intensity } => Self {
                light: Some(light),
                intensity: Some(intensity),
                ..none
            },
            Action::Focal { camera, focal } => Self {
                camera: Some(camera),
                focal: Some(focal),
                ..none
            },
            Action::ActiveCamera(name) => Self {
                active_camera: Some(name),
                ..none
            },
        }
    }
}
