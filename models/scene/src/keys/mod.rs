//! The keys of a scene file as they stand in the text: everything optional that depends on a kind, turned into the types of
//! [`file`](super::file) with a message that says what the kind takes.

mod camera;
mod image;
mod light;
mod object;
mod scene;
mod step;

pub(super) use camera::CameraKeys;
pub(super) use image::ActionKeys;
pub(super) use light::LightKeys;
pub(super) use object::ObjectKeys;
pub(super) use scene::SceneKeys;
pub(super) use step::StepKeys;

use serde::Deserialize;
use serde::de::{self, Deserializer, SeqAccess};

/// Default of a switch that is on unless the author turns it off.
pub(crate) fn yes() -> bool {
    true
}

/// A switch left at that default is not written.
pub(crate) fn is_yes(value: &bool) -> bool {
    *value
}

/// A switch left off is not written.
pub(crate) fn is_no(value: &bool) -> bool {
    !*value
}

pub(crate) fn require<T>(value: Option<T>, owner: &str, wanted: &str) -> Result<T, String> {
    value.ok_or_else(|| format!("{owner} needs {wanted}"))
}

pub(crate) fn refuse_key(
    present: bool,
    key: &str,
    owner: &str,
    wanted: &str,
) -> Result<(), String> {
    if present {
        return Err(format!("{owner} has no `{key}`; it takes {wanted}"));
    }
    Ok(())
}

pub(crate) fn fixed<const N: usize>(
    values: Option<&[f64]>,
    owner: &str,
    wanted: &str,
) -> Result<[f64; N], String> {
    let values = require(values, owner, wanted)?;
    values
        .try_into()
        .map_err(|_| format!("{owner} needs {wanted}; found {} numbers", values.len()))
}

/// Reads an array of exactly `N` numbers; the array type alone would let a surplus number pass unseen.
pub(crate) fn numbers<'de, D: Deserializer<'de>, const N: usize>(
    input: D,
) -> Result<[f64; N], D::Error> {
    let values = Vec::<f64>::deserialize(input)?;
    values.as_slice().try_into().map_err(|_| {
        de::Error::custom(format!(
            "{} numbers found; [{}], {N} numbers, would be accepted",
            values.len(),
            vec!["0.0"; N].join(", ")
        ))
    })
}

pub(crate) fn optional_numbers<'de, D: Deserializer<'de>>(
    input: D,
) -> Result<Option<[f64; 3]>, D::Error> {
    numbers(input).map(Some)
}

/// Reads three numbers that stand where another form is also possible.
pub(crate) fn three_of<'de, A: SeqAccess<'de>>(
    mut sequence: A,
    wanted: &str,
) -> Result<[f64; 3], A::Error> {
    let mut values = Vec::new();
    while let Some(value) = sequence.next_element::<f64>()? {
        values.push(value);
    }
    values.as_slice().try_into().map_err(|_| {
        de::Error::custom(format!(
            "{} numbers found; {wanted} would be accepted",
            values.len()
        ))
    })
}
