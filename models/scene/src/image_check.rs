//! The checks of the images of an animation.

use super::camera::{LONGEST_FOCAL, SHORTEST_FOCAL};
use super::check::{Checked, MAX_INTENSITY, check_name, check_numbers, check_range, check_step};
use super::error::SceneError;
use super::file::{Camera, Scale, SceneFile, Step};
use super::image::{Action, KeyImage};
use super::names::{Class, Names, check_camera_name, known};
use std::collections::HashMap;

/// Most images of an animation.
pub const MAX_IMAGES: usize = 10_000;
/// Most frames of one image, and of a whole animation.
pub const MAX_FRAMES: u32 = 100_000;
/// Seconds that a frame is shown at least.
pub const SHORTEST_FRAME: f64 = 0.001;
/// Seconds that a frame is shown at most.
pub const LONGEST_FRAME: f64 = 60.0;

/// Refuses images that cannot be played.
pub(super) fn check_images(file: &SceneFile, names: &Names) -> Checked {
    if file.images.len() > MAX_IMAGES {
        return Err(SceneError::value(
            "images",
            format!("{} images", file.images.len()),
            format!("at most {MAX_IMAGES} are possible"),
        ));
    }
    let mut index_of = HashMap::new();
    for (index, image) in file.images.iter().enumerate() {
        check_name(&format!("images[{index}].name"), &image.name)?;
        if index_of.insert(image.name.as_str(), index).is_some() {
            return Err(SceneError::value(
                format!("image `{}`", image.name),
                "this name is taken by an earlier image",
                "every name must be unique",
            ));
        }
    }
    for image in &file.images {
        let place = format!("image `{}`", image.name);
        check_timing(&place, image)?;
        for (index, action) in image.actions.iter().enumerate() {
            let key = format!("{place}, actions[{index}]");
            check_action(&key, action, image.steps, file, names)?;
        }
    }
    check_parents(&file.images, &index_of)?;
    check_count(&file.images)
}

fn check_count(images: &[KeyImage]) -> Checked {
    let active = images.iter().filter(|image| image.active);
    let frames: u64 = active.map(|image| u64::from(image.steps)).sum();
    if frames > u64::from(MAX_FRAMES) {
        return Err(SceneError::value(
            "images",
            format!("{frames} frames"),
            format!("an animation has at most {MAX_FRAMES}"),
        ));
    }
    Ok(())
}

fn check_timing(place: &str, image: &KeyImage) -> Checked {
    let duration = image.duration;
    if !(SHORTEST_FRAME..=LONGEST_FRAME).contains(&duration) {
        return Err(SceneError::value(
            format!("{place}, duration"),
            format!("{duration} is out of range"),
            format!("each frame is shown for {SHORTEST_FRAME} to {LONGEST_FRAME} seconds"),
        ));
    }
    if !(1..=MAX_FRAMES).contains(&image.steps) {
        return Err(SceneError::value(
            format!("{place}, steps"),
            format!("{} is out of range", image.steps),
            format!("an image has 1 to {MAX_FRAMES} frames"),
        ));
    }
    Ok(())
}

fn check_action(
    place: &str,
    action: &Action,
    steps: u32,
    file: &SceneFile,
    names: &Names,
) -> Checked {
    match action {
        Action::Move { target, step, .. } => {
            let all = [Class::Object, Class::Group, Class::Light, Class::Camera];
            check_target(&format!("{place}.target"), target, &all, names)?;
            check_step(place, step)?;
            check_parts(place, step, steps)
        }
        Action::Show { target, .. } => {
            let seen = [Class::Object, Class::Group, Class::Light];
            check_target(&format!("{place}.target"), target, &seen, names)
        }
        Action::Intensity { light, intensity } => {
            check_target(&format!("{place}.light"), light, &[Class::Light], names)?;
            check_range(&format!("{place}.intensity"), *intensity, MAX_INTENSITY)
        }
        Action::Focal { camera, focal } => check_focal(place, camera, *focal, file),
        Action::ActiveCamera(name) => {
            check_camera_name(file, &format!("{place}.active_camera"), name)
        }
    }
}

/// Refuses a name that is not of one of the classes.
fn check_target(place: &str, name: &str, classes: &[Class], names: &Names) -> Checked {
    let words: Vec<_> = classes.iter().map(|class| class.word()).collect();
    let (problem, accepted) = match names.get(name) {
        Some(class) if classes.contains(class) => return Ok(()),
        Some(class) => (
            format!("`{name}` is {} {}", article(class.word()), class.word()),
            format!(
                "the name of {} {} is needed",
                article(words[0]),
                words.join(" or ")
            ),
        ),
        None => {
            let mut fitting: Vec<&str> = names
                .iter()
                .filter(|(_, class)| classes.contains(class))
                .map(|(name, _)| *name)
                .collect();
            fitting.sort_unstable();
            let what = format!("{} with this name", words.join(" or "));
            (
                format!("nothing of this scene has the name `{name}`"),
                known(fitting.into_iter(), &what),
            )
        }
    };
    Err(SceneError::value(place, problem, accepted))
}

fn article(word: &str) -> &'static str {
    if word.starts_with('o') { "an" } else { "a" }
}

fn check_focal(place: &str, name: &str, focal: f64, file: &SceneFile) -> Checked {
    check_camera_name(file, &format!("{place}.camera"), name)?;
    let mut cameras = file.all_cameras();
    let camera = cameras.find(|camera| camera.node().name.as_deref() == Some(name));
    if let Some(Camera::Orthographic { .. }) = camera {
        return Err(SceneError::value(
            format!("{place}.camera"),
            format!("`{name}` is an orthographic camera and has no lens"),
            "a perspective camera is needed",
        ));
    }
    check_numbers(&format!("{place}.focal"), &[focal])?;
    if !(SHORTEST_FOCAL..=LONGEST_FOCAL).contains(&focal) {
        return Err(SceneError::value(
            format!("{place}.focal"),
            format!("{focal} is out of range"),
            format!(
                "a focal length from {SHORTEST_FOCAL} to {LONGEST_FOCAL} millimetres is possible"
            ),
        ));
    }
    Ok(())
}

/// Refuses a mirror image over several frames: on the way there is a frame without thickness.
fn check_parts(place: &str, step: &Step, steps: u32) -> Checked {
    let factors: &[f64] = match step {
        Step::Scale(Scale::Uniform(factor)) => std::slice::from_ref(factor),
        Step::Scale(Scale::PerAxis(factors)) => factors,
        _ => return Ok(()),
    };
    if steps > 1 && factors.iter().any(|factor| *factor < 0.0) {
        return Err(SceneError::value(
            format!("{place}.scale"),
            format!("{factors:?} mirrors, which cannot be spread over {steps} frames"),
            "factors above 0, or an image with `steps = 1`, are needed",
        ));
    }
    Ok(())
}

/// Refuses parents that do not exist and images that start from themselves.
fn check_parents(images: &[KeyImage], index_of: &HashMap<&str, usize>) -> Checked {
    // Images known to end at the scene as it is written.
    let mut sound = vec![false; images.len()];
    for (start, image) in images.iter().enumerate() {
        let mut path = vec![];
        let mut next = Some(start);
        while let Some(index) = next {
            if sound[index] {
                break;
            }
            if path.contains(&index) {
                let circle = path.iter().skip_while(|i| **i != index);
                let names: Vec<String> = circle
                    .chain([&index])
                    .map(|i| format!("`{}`", images[*i].name))
                    .collect();
                return Err(SceneError::value(
                    format!("image `{}`, parent", image.name),
                    format!("the images start from each other: {}", names.join(" from ")),
                    "a chain of parents that ends with an image without `parent` is needed",
                ));
            }
            path.push(index);
            next = parent_of(&images[index], images, index_of)?;
        }
        for index in path {
            sound[index] = true;
        }
    }
    Ok(())
}

fn parent_of(
    image: &KeyImage,
    images: &[KeyImage],
    index_of: &HashMap<&str, usize>,
) -> Result<Option<usize>, SceneError> {
    let Some(name) = &image.parent else {
        return Ok(None);
    };
    match index_of.get(name.as_str()) {
        Some(index) => Ok(Some(*index)),
        None => Err(SceneError::value(
            format!("image `{}`, parent", image.name),
            format!("`{name}` is not an image of this scene"),
            known(images.iter().map(|i| i.name.as_str()), "`[[images]]`"),
        )),
    }
}
