//! The limits of single values, and the refusals of what is beyond them.

use super::error::SceneError;
use super::step::{Axis, Step};
use imogene_algebra::vector::{cross, dot, normalised};
use std::fmt::Display;

/// Most cut planes of one object.
pub const MAX_CUTS: usize = 12;
/// Most columns or lines of a picture.
pub(super) const MAX_IMAGE_SIDE: u32 = 4096;
/// Most light sources: a pixel carries one flag for each (thesis section 4.1.3).
pub(super) const MAX_LIGHTS: usize = 16;
/// Shortest length of a camera, in scene units; below it `f64` pictures of it lose their meaning.
const SHORTEST_LENGTH: f64 = 1e-30;
/// Largest magnitude of any number of a scene; beyond it `f64` directions lose their meaning.
pub(super) const MAX_MAGNITUDE: f64 = 1e12;
/// Largest exponent of a highlight.
pub(super) const MAX_SPECULAR_EXPONENT: u32 = 200;
/// Largest factor of a light's colour.
pub(super) const MAX_INTENSITY: f64 = 10.0;
/// Smallest angle between the axis of a spot and its cone, in degrees.
pub(super) const SMALLEST_HALF_ANGLE: f64 = 0.1;
/// Largest angle between the axis of a spot and its cone, in degrees; at 90 the cone is a plane.
pub(super) const LARGEST_HALF_ANGLE: f64 = 89.0;
/// Sine of the angle under which `up` counts as parallel to the viewing direction.
const PARALLEL: f64 = 1e-9;

pub(super) type Checked = Result<(), SceneError>;

/// Refuses what is not sound: with the place, the problem and what would be accepted.
pub(super) fn unless(
    is_sound: bool,
    place: impl Display,
    problem: impl Display,
    accepted: impl Display,
) -> Checked {
    match is_sound {
        true => Ok(()),
        false => Err(SceneError::value(place, problem, accepted)),
    }
}

pub(super) fn check_number(place: impl Display, value: f64) -> Checked {
    let problem = format_args!("{value} is not a finite number");
    let accepted = "a finite number is needed";
    unless(value.is_finite(), &place, problem, accepted)?;
    let problem = format_args!("{value:e} is too large");
    let least = -MAX_MAGNITUDE;
    let accepted = format_args!("numbers from {least:e} to {MAX_MAGNITUDE:e} are possible");
    unless(value.abs() <= MAX_MAGNITUDE, place, problem, accepted)
}

pub(super) fn check_numbers(place: impl Display, values: &[f64]) -> Checked {
    let mut values = values.iter().enumerate();
    values.try_for_each(|(index, value)| check_number(format_args!("{place}[{index}]"), *value))
}

pub(super) fn check_direction(place: impl Display, vector: [f64; 3]) -> Checked {
    check_numbers(&place, &vector)?;
    let problem = "[0, 0, 0] has no direction";
    let accepted = "a vector with at least one number other than 0 is needed";
    unless(vector != [0.0; 3], place, problem, accepted)
}

pub(super) fn check_positive(place: impl Display, value: f64) -> Checked {
    check_number(&place, value)?;
    let problem = format_args!("{value} is not positive");
    unless(value > 0.0, place, problem, "a number above 0 is needed")
}

/// Refuses a length of the camera that is not above 0, or so short that nothing could be told apart in it.
pub(super) fn check_length(place: impl Display, value: f64) -> Checked {
    check_positive(&place, value)?;
    let problem = format_args!("{value:e} is too small");
    let accepted = format_args!("at least {SHORTEST_LENGTH:e} is possible");
    unless(value >= SHORTEST_LENGTH, place, problem, accepted)
}

/// Refuses a value that is not within; `accepted` says what is.
pub(super) fn check_within<T: PartialOrd + Display>(
    place: impl Display,
    value: T,
    [least, most]: [T; 2],
    accepted: impl Display,
) -> Checked {
    let problem = format_args!("{value} is out of range");
    unless(least <= value && value <= most, place, problem, accepted)
}

pub(super) fn check_share(place: impl Display, value: f64, largest: f64) -> Checked {
    check_number(&place, value)?;
    let accepted = format_args!("a number from 0 to {largest} is possible");
    check_within(place, value, [0.0, largest], accepted)
}

pub(super) fn check_colour(place: impl Display, colour: [f64; 3]) -> Checked {
    check_numbers(&place, &colour)?;
    let accepted = "red, green and blue are numbers from 0 to 1 (an 8-bit value divided by 255)";
    let mut parts = colour.into_iter().enumerate();
    parts.try_for_each(|(index, value)| {
        let key = format_args!("{place}[{index}]");
        check_within(key, value, [0.0, 1.0], accepted)
    })
}

pub(super) fn check_name(place: impl Display, name: &str) -> Checked {
    let (problem, accepted) = ("the name is empty", "a name is needed");
    unless(!name.trim().is_empty(), place, problem, accepted)
}

/// Refuses a name that an earlier one of a class has.
pub(super) fn check_new(is_new: bool, place: impl Display, earlier: &str) -> Checked {
    let problem = format_args!("this name is taken by an earlier {earlier}");
    unless(is_new, place, problem, "every name must be unique")
}

/// Refuses more than are possible.
pub(super) fn check_count(place: impl Display, count: usize, what: &str, most: usize) -> Checked {
    let problem = format_args!("{count} {what}");
    let accepted = format_args!("at most {most} are possible");
    unless(count <= most, place, problem, accepted)
}

/// Refuses a picture size the machine cannot scan.
pub(super) fn check_image_size(width: u32, height: u32) -> Checked {
    let mut sides = [("image.width", width), ("image.height", height)].into_iter();
    let accepted = format!("1 to {MAX_IMAGE_SIDE} are possible");
    sides.try_for_each(|(key, side)| {
        let is_sound = (1..=MAX_IMAGE_SIDE).contains(&side);
        unless(is_sound, key, format_args!("{side} pixels"), &accepted)
    })
}

/// Refuses a direction upwards along the view.
pub(super) fn check_up(key: impl Display, view: [f64; 3], up: [f64; 3]) -> Checked {
    let side = cross(normalised(view), normalised(up));
    let is_parallel = dot(side, side).sqrt() < PARALLEL;
    let problem = format_args!("{up:?} is parallel to the viewing direction {view:?}");
    let accepted = "a direction seen upwards in the picture is needed";
    unless(!is_parallel, key, problem, accepted)
}

pub(super) fn check_place(place: impl Display, steps: &[Step]) -> Checked {
    let mut steps = steps.iter().enumerate();
    steps.try_for_each(|(index, step)| check_step(format_args!("{place}, place[{index}]"), step))
}

pub(super) fn check_step(place: impl Display, step: &Step) -> Checked {
    match step {
        Step::Translate(offset) => check_numbers(format_args!("{place}.translate"), offset),
        Step::Rotate(rotation) => {
            if let Axis::Vector(vector) = rotation.axis {
                check_direction(format_args!("{place}.rotate.axis"), vector)?;
            }
            check_number(format_args!("{place}.rotate.degrees"), rotation.degrees)
        }
        Step::Scale(scale) => {
            let key = format_args!("{place}.scale");
            match scale.factors() {
                [factor] => check_number(key, *factor)?,
                factors => check_numbers(key, factors)?,
            }
            let problem = "a factor of 0 flattens the object, the transform is singular";
            let accepted = "factors other than 0 are needed (negative ones mirror)";
            unless(!scale.factors().contains(&0.0), key, problem, accepted)
        }
    }
}
