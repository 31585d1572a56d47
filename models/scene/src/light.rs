//! Light sources, and their keys in the file.

use super::group::Node;
use super::keys::{Three, number, numbers, present, refuse_keys, require, white, yes};
use super::step::Step;
use serde::{Deserialize, Serialize};
use std::ops::Not;

/// A light source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "LightKeys")]
pub struct Light {
    /// From where, and whereto.
    #[serde(flatten)]
    pub beam: Beam,
    /// 0 to 1 for each of red, green, blue.
    pub colour: [f64; 3],
    /// Factor of the colour.
    pub intensity: f64,
    /// Whether objects in its way keep its light off others.
    #[serde(skip_serializing_if = "Not::not")]
    pub shadows: bool,
    /// Name, group and place.
    #[serde(flatten)]
    pub node: Node,
}

/// From where a light comes, and whereto.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Beam {
    /// Parallel light.
    Directional {
        /// The direction the light comes from: a vector from the scene towards the source.
        from: [f64; 3],
    },
    /// Light from one point, without attenuation.
    Point {
        /// Where the source stands.
        position: [f64; 3],
    },
    /// Light from one point into a cone, without attenuation.
    Spot {
        /// Where the source stands: the apex of the cone.
        position: [f64; 3],
        /// The axis of the cone.
        #[serde(flatten)]
        aim: Aim,
        /// Angle in degrees between the axis and the cone.
        half_angle: f64,
    },
}

/// What a spot is directed at.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Aim {
    /// A point on the axis.
    Target([f64; 3]),
    /// The direction of the axis.
    Towards([f64; 3]),
}

impl Light {
    /// White parallel light without shadows.
    pub fn directional(from: [f64; 3], intensity: f64) -> Light {
        Light {
            beam: Beam::Directional { from },
            colour: white(),
            intensity,
            shadows: false,
            node: Node::default(),
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LightKeys {
    kind: LightKind,
    from: Option<Three>,
    position: Option<Three>,
    target: Option<Three>,
    towards: Option<Three>,
    half_angle: Option<f64>,
    #[serde(default = "white", deserialize_with = "numbers")]
    colour: [f64; 3],
    #[serde(default = "number::<_, 1>")]
    intensity: f64,
    #[serde(default)]
    shadows: bool,
    name: Option<String>,
    group: Option<String>,
    #[serde(default = "yes")]
    visible: bool,
    #[serde(default)]
    place: Vec<Step>,
}

#[derive(Clone, Copy, PartialEq, Deserialize)]
#[serde(rename_all = "snake_case")]
enum LightKind {
    Directional,
    Point,
    Spot,
}

impl LightKeys {
    /// Refuses the keys of other kinds, and gives the words for this one.
    fn owner(&self) -> Result<&'static str, String> {
        let of_spot = "`position`, `target` or `towards`, and `half_angle`";
        let (owner, taken) = match self.kind {
            LightKind::Directional => ("a directional light", "`from`"),
            LightKind::Point => ("a point light", "`position`"),
            LightKind::Spot => ("a spot", of_spot),
        };
        let present = present!(self; from, position, target, towards, half_angle);
        let is_other = |(key, _): &(&str, bool)| !taken.contains(&format!("`{key}`"));
        refuse_keys(present.into_iter().filter(is_other), owner, taken)?;
        Ok(owner)
    }

    fn aim(&self) -> Result<Aim, String> {
        let problem = match (self.target, self.towards) {
            (Some(Three(target)), None) => return Ok(Aim::Target(target)),
            (None, Some(Three(direction))) => return Ok(Aim::Towards(direction)),
            (None, None) => {
                "a spot needs `target`, a point on its axis, or `towards`, the direction of its axis"
            }
            (Some(_), Some(_)) => "a spot takes `target` or `towards`; found both",
        };
        Err(problem.into())
    }

    fn beam(&self) -> Result<Beam, String> {
        let owner = self.owner()?;
        if self.kind == LightKind::Directional {
            let wanted = "`from`, the direction the light comes from";
            let Three(from) = require(self.from, owner, wanted)?;
            return Ok(Beam::Directional { from });
        }
        let Three(position) = require(self.position, owner, "`position`")?;
        if self.kind == LightKind::Point {
            return Ok(Beam::Point { position });
        }
        let wanted = "`half_angle`, the angle in degrees between its axis and its cone";
        Ok(Beam::Spot {
            position,
            aim: self.aim()?,
            half_angle: require(self.half_angle, owner, wanted)?,
        })
    }
}

impl TryFrom<LightKeys> for Light {
    type Error = String;

    fn try_from(keys: LightKeys) -> Result<Self, String> {
        Ok(Light {
            beam: keys.beam()?,
            colour: keys.colour,
            intensity: keys.intensity,
            shadows: keys.shadows,
            node: Node {
                name: keys.name,
                group: keys.group,
                visible: keys.visible,
                place: keys.place,
            },
        })
    }
}
