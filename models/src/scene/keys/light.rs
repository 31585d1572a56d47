//! `[[lights]]` as they stand in the file.

use super::{numbers, optional_numbers, refuse_key, require};
use crate::scene::file::{Light, full, white};
use serde::{Deserialize, Serialize};

/// The keys of an entry of `[[lights]]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::scene) struct LightKeys {
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
    #[serde(default = "white", deserialize_with = "numbers")]
    colour: [f64; 3],
    #[serde(default = "full")]
    intensity: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum LightKind {
    Directional,
    Point,
}

impl TryFrom<LightKeys> for Light {
    type Error = String;

    fn try_from(keys: LightKeys) -> Result<Self, String> {
        let LightKeys {
            kind,
            from,
            position,
            colour,
            intensity,
        } = keys;
        match kind {
            LightKind::Directional => {
                refuse_key(
                    position.is_some(),
                    "position",
                    "a directional light",
                    "`from`",
                )?;
                Ok(Self::Directional {
                    from: require(
                        from,
                        "a directional light",
                        "`from`, the direction the light comes from",
                    )?,
                    colour,
                    intensity,
                })
            }
            LightKind::Point => {
                refuse_key(from.is_some(), "from", "a point light", "`position`")?;
                Ok(Self::Point {
                    position: require(position, "a point light", "`position`")?,
                    colour,
                    intensity,
                })
            }
        }
    }
}

impl From<Light> for LightKeys {
    fn from(light: Light) -> Self {
        let (kind, from, position, colour, intensity) = match light {
            Light::Directional {
                from,
                colour,
                intensity,
            } => (LightKind::Directional, Some(from), None, colour, intensity),
            Light::Point {
                position,
                colour,
                intensity,
            } => (LightKind::Point, None, Some(position), colour, intensity),
        };
        Self {
            kind,
            from,
            position,
            colour,
            intensity,
        }
    }
}
