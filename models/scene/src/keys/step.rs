//! Steps of a placement as they stand in the file.

use super::{optional_numbers, three_of};
use crate::file::{Axis, Rotation, Scale, Step};
use serde::de::{self, Deserializer, SeqAccess, Visitor};
use serde::{Deserialize, Serialize};

/// The key of a step as it stands in the file.
#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StepKeys {
    #[serde(
        default,
        deserialize_with = "optional_numbers",
        skip_serializing_if = "Option::is_none"
    )]
    pub(super) translate: Option<[f64; 3]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) rotate: Option<Rotation>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) scale: Option<Scale>,
}

impl TryFrom<StepKeys> for Step {
    type Error = String;

    fn try_from(keys: StepKeys) -> Result<Self, String> {
        match (keys.translate, keys.rotate, keys.scale) {
            (Some(offset), None, None) => Ok(Self::Translate(offset)),
            (None, Some(rotation), None) => Ok(Self::Rotate(rotation)),
            (None, None, Some(scale)) => Ok(Self::Scale(scale)),
            (None, None, None) => {
                Err("the step is empty; it needs one of `translate`, `rotate`, `scale`".to_owned())
            }
            _ => Err(
                "several steps in one table; write each in its own { }, in the order they apply"
                    .to_owned(),
            ),
        }
    }
}

impl From<Step> for StepKeys {
    fn from(step: Step) -> Self {
        let none = Self::default();
        match step {
            Step::Translate(offset) => Self {
                translate: Some(offset),
                ..none
            },
            Step::Rotate(rotation) => Self {
                rotate: Some(rotation),
                ..none
            },
            Step::Scale(scale) => Self {
                scale: Some(scale),
                ..none
            },
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
