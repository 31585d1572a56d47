//! `[[lights]]` as they stand in the file.

use super::{is_no, is_yes, numbers, optional_numbers, refuse_key, require, yes};
use crate::file::{Aim, Light, Step, full, white};
use crate::group::Node;
use serde::{Deserialize, Serialize};

/// The keys of an entry of `[[lights]]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LightKeys {
    kind: LightKind,
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    from: Option<[f64; 3]>,
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    position: Option<[f64; 3]>,
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    target: Option<[f64; 3]>,
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    towards: Option<[f64; 3]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    half_angle: Option<f64>,
    #[serde(default = "white", deserialize_with = "numbers")]
    colour: [f64; 3],
    #[serde(default = "full")]
    intensity: f64,
    #[serde(default, skip_serializing_if = "is_no")]
    shadows: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    group: Option<String>,
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    visible: bool,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    place: Vec<Step>,
}

#[derive(Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum LightKind {
    Directional,
    Point,
    Spot,
}

impl LightKind {
    const fn owner(self) -> &'static str {
        match self {
            Self::Directional => "a directional light",
            Self::Point => "a point light",
            Self::Spot => "a spot",
        }
    }

    /// The keys that this kind takes beside those of every light.
    const fn keys(self) -> &'static str {
        match self {
            Self::Directional => "`from`",
            Self::Point => "`position`",
            Self::Spot => "`position`, `target` or `towards`, and `half_angle`",
        }
    }
}

impl LightKeys {
    fn refuse_others(&self) -> Result<(), String> {
        let spot = self.kind == LightKind::Spot;
        let directional = self.kind == LightKind::Directional;
        let keys = [
            ("from", self.from.is_some(), directional),
            ("position", self.position.is_some(), !directional),
            ("target", self.target.is_some(), spot),
            ("towards", self.towards.is_some(), spot),
            ("half_angle", self.half_angle.is_some(), spot),
        ];
        for (key, present, taken) in keys {
            refuse_key(present && !taken, key, self.kind.owner(), self.kind.keys())?;
        }
        Ok(())
    }

    fn aim(&self) -> Result<Aim, String> {
        match (self.target, self.towards) {
            (Some(target), None) => Ok(Aim::Target(target)),
            (None, Some(direction)) => Ok(Aim::Towards(direction)),
            (None, None) => Err(
                "a spot needs `target`, a point on its axis, or `towards`, the direction of its axis"
                    .into(),
            ),
            (Some(_), Some(_)) => {
                Err("a spot takes `target` or `towards`; found both".into())
            }
        }
    }
}

impl TryFrom<LightKeys> for Light {
    type Error = String;

    fn try_from(keys: LightKeys) -> Result<Self, String> {
        keys.refuse_others()?;
        let owner = keys.kind.owner();
        let (colour, intensity, shadows) = (keys.colour, keys.intensity, keys.shadows);
        let position = || require(keys.position, owner, "`position`");
        let node = Node {
            name: keys.name.clone(),
            group: keys.group.clone(),
            visible: keys.visible,
            place: keys.place.clone(),
        };
        Ok(match keys.kind {
            LightKind::Directional => Self::Directional {
                from: require(
                    keys.from,
                    owner,
                    "`from`, the direction the light comes from",
                )?,
                colour,
                intensity,
                shadows,
                node,
            },
            LightKind::Point => Self::Point {
                position: position()?,
                colour,
                intensity,
                shadows,
                node,
            },
            LightKind::Spot => Self::Spot {
                position: position()?,
                aim: keys.aim()?,
                half_angle: require(
                    keys.half_angle,
                    owner,
                    "`half_angle`, the angle in degrees between its axis and its cone",
                )?,
                colour,
                intensity,
                shadows,
                node,
            },
        })
    }
}

impl From<Light> for LightKeys {
    fn from(light: Light) -> Self {
        let keys = |kind, colour, intensity, shadows, node: Node| LightKeys {
            kind,
            from: None,
            position: None,
            target: None,
            towards: None,
            half_angle: None,
            colour,
            intensity,
            shadows,
            name: node.name,
            group: node.group,
            visible: node.visible,
            place: node.place,
        };
        match light {
            Light::Directional {
                from,
                colour,
                intensity,
                shadows,
                node,
            } => LightKeys {
                from: Some(from),
                ..keys(LightKind::Directional, colour, intensity, shadows, node)
            },
            Light::Point {
                position,
                colour,
                intensity,
                shadows,
                node,
            } => LightKeys {
                position: Some(position),
                ..keys(LightKind::Point, colour, intensity, shadows, node)
            },
            Light::Spot {
                position,
                aim,
                half_angle,
                colour,
                intensity,
                shadows,
                node,
            } => {
                let (target, towards) = match aim {
                    Aim::Target(point) => (Some(point), None),
                    Aim::Towards(direction) => (None, Some(direction)),
                };
                LightKeys {
                    position: Some(position),
                    target,
                    towards,
                    half_angle: Some(half_angle),
                    ..keys(LightKind::Spot, colour, intensity, shadows, node)
                }
            }
        }
    }
}
