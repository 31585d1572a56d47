//! Steps of a placement.

use super::keys::{Three, three_of};
use serde::de::{self, Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

/// One step of a placement.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "StepKeys", rename_all = "snake_case")]
pub enum Step {
    /// Displacement in scene units.
    Translate([f64; 3]),
    /// Rotation about an axis through the origin.
    Rotate(Rotation),
    /// Scaling from the origin, one factor or one for each axis; negative factors mirror.
    Scale(Scale),
}

/// A rotation about an axis through the origin, counter-clockwise when the axis points to the observer.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rotation {
    /// The axis.
    pub axis: Axis,
    /// The angle in degrees; multiples of 90 about a coordinate axis are exact.
    pub degrees: f64,
}

/// Axis of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// The x axis.
    X,
    /// The y axis.
    Y,
    /// The z axis.
    Z,
    /// Any other direction; its length does not matter.
    #[serde(untagged)]
    Vector([f64; 3]),
}

/// Factors of a scaling.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Scale {
    /// The same factor for x, y and z.
    Uniform(f64),
    /// One factor for each axis.
    PerAxis([f64; 3]),
}

impl Scale {
    /// The factors as they are written.
    pub(crate) fn factors(&self) -> &[f64] {
        match self {
            Scale::Uniform(factor) => std::slice::from_ref(factor),
            Scale::PerAxis(factors) => factors,
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StepKeys {
    pub translate: Option<Three>,
    pub rotate: Option<Rotation>,
    pub scale: Option<Scale>,
}

impl TryFrom<StepKeys> for Step {
    type Error = String;

    fn try_from(keys: StepKeys) -> Result<Self, String> {
        match (keys.translate, keys.rotate, keys.scale) {
            (Some(Three(offset)), None, None) => Ok(Self::Translate(offset)),
            (None, Some(rotation), None) => Ok(Self::Rotate(rotation)),
            (None, None, Some(scale)) => Ok(Self::Scale(scale)),
            (None, None, None) => {
                Err("the step is empty; it needs one of `translate`, `rotate`, `scale`".into())
            }
            _ => Err(
                "several steps in one table; write each in its own { }, in the order they apply"
                    .into(),
            ),
        }
    }
}

const AXIS_FORMS: &str = "\"x\", \"y\", \"z\" or a vector [x, y, z]";
const SCALE_FORMS: &str = "one number or [x, y, z]";

impl<'de> Deserialize<'de> for Axis {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct AxisVisitor;
        impl<'de> Visitor<'de> for AxisVisitor {
            type Value = Axis;

            fn expecting(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
                out.write_str(AXIS_FORMS)
            }

            fn visit_str<E: de::Error>(self, name: &str) -> Result<Axis, E> {
                match name {
                    "x" => Ok(Axis::X),
                    "y" => Ok(Axis::Y),
                    "z" => Ok(Axis::Z),
                    other => Err(E::invalid_value(de::Unexpected::Str(other), &self)),
                }
            }

            fn visit_seq<A: SeqAccess<'de>>(self, sequence: A) -> Result<Axis, A::Error> {
                three_of(sequence, AXIS_FORMS).map(Axis::Vector)
            }
        }
        input.deserialize_any(AxisVisitor)
    }
}

impl<'de> Deserialize<'de> for Scale {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Self, D::Error> {
        struct ScaleVisitor;
        impl<'de> Visitor<'de> for ScaleVisitor {
            type Value = Scale;

            fn expecting(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
                out.write_str(SCALE_FORMS)
            }

            fn visit_f64<E: de::Error>(self, factor: f64) -> Result<Scale, E> {
                Ok(Scale::Uniform(factor))
            }

            fn visit_i64<E: de::Error>(self, factor: i64) -> Result<Scale, E> {
                Ok(Scale::Uniform(factor as f64))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, sequence: A) -> Result<Scale, A::Error> {
                three_of(sequence, SCALE_FORMS).map(Scale::PerAxis)
            }
        }
        input.deserialize_any(ScaleVisitor)
    }
}
