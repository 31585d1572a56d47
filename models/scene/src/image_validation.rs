//! The checks of the images of an animation.

use super::camera::{Camera, LONGEST_FOCAL, SHORTEST_FOCAL};
use super::error::SceneError;
use super::file::SceneFile;
use super::image::{Action, KeyImage};
use super::limits::*;
use super::names::{Names, check_camera_name, known};
use super::step::Step;
use std::collections::HashMap;
use std::fmt::Arguments;

/// Most images of an animation.
const MAX_IMAGES: usize = 10_000;
/// Most frames of one image, and of a whole animation.
const MAX_FRAMES: u32 = 100_000;
/// Seconds that a frame is shown at least.
const SHORTEST_FRAME: f64 = 0.001;
/// Seconds that a frame is shown at most.
const LONGEST_FRAME: f64 = 60.0;

pub(super) fn check_images(file: &SceneFile, names: &Names) -> Checked {
    check_count("images", file.images.len(), "images", MAX_IMAGES)?;
    let mut index_of = HashMap::new();
    for (index, image) in file.images.iter().enumerate() {
        check_name(format_args!("images[{index}].name"), &image.name)?;
        let is_new = index_of.insert(image.name.as_str(), index).is_none();
        check_new(is_new, format_args!("image `{}`", image.name), "image")?;
    }
    for image in &file.images {
        let place = format_args!("image `{}`", image.name);
        check_timing(place, image)?;
        for (index, action) in image.actions.iter().enumerate() {
            let key = format_args!("{place}, actions[{index}]");
            check_action(key, action, image.steps, file, names)?;
        }
    }
    check_parents(&file.images, &index_of)?;
    let active = file.images.iter().filter(|image| image.active);
    let frames: u64 = active.map(|image| u64::from(image.steps)).sum();
    let problem = format_args!("{frames} frames");
    let accepted = format_args!("an animation has at most {MAX_FRAMES}");
    unless(frames <= u64::from(MAX_FRAMES), "images", problem, accepted)
}

fn check_timing(place: Arguments, image: &KeyImage) -> Checked {
    let (key, range) = (
        format_args!("{place}, duration"),
        [SHORTEST_FRAME, LONGEST_FRAME],
    );
    let accepted =
        format_args!("each frame is shown for {SHORTEST_FRAME} to {LONGEST_FRAME} seconds");
    check_within(key, image.duration, range, accepted)?;
    let accepted = format_args!("an image has 1 to {MAX_FRAMES} frames");
    let key = format_args!("{place}, steps");
    check_within(key, image.steps, [1, MAX_FRAMES], accepted)
}

fn check_action(
    place: Arguments,
    action: &Action,
    steps: u32,
    file: &SceneFile,
    names: &Names,
) -> Checked {
    let key = |key: &str| format!("{place}.{key}");
    match action {
        Action::Move { target, step, .. } => {
            let all = ["object", "group", "light", "camera"];
            check_target(&key("target"), target, &all, names)?;
            check_step(place, step)?;
            check_parts(place, step, steps)
        }
        Action::Show { target, .. } => {
            check_target(&key("target"), target, &["object", "group", "light"], names)
        }
        Action::Intensity { light, intensity } => {
            check_target(&key("light"), light, &["light"], names)?;
            check_share(key("intensity"), *intensity, MAX_INTENSITY)
        }
        Action::Focal { camera, focal } => check_focal(place, camera, *focal, file),
        Action::ActiveCamera { active_camera } => {
            check_camera_name(file, key("active_camera"), active_camera)
        }
    }
}

/// Refuses a name that is not of one of the classes.
fn check_target(place: &str, name: &str, classes: &[&str], names: &Names) -> Checked {
    let words = classes.join(" or ");
    let (problem, accepted) = match names.get(name) {
        Some(class) if classes.contains(class) => return Ok(()),
        Some(class) => (
            format!("`{name}` is {}", with_article(class)),
            format!("the name of {} is needed", with_article(&words)),
        ),
        None => {
            let fitting = names.iter().filter(|(_, class)| classes.contains(class));
            let mut fitting: Vec<&str> = fitting.map(|(name, _)| *name).collect();
            fitting.sort_unstable();
            let what = format!("{words} with this name");
            let problem = format!("nothing of this scene has the name `{name}`");
            (problem, known(fitting.into_iter(), &what))
        }
    };
    Err(SceneError::value(place, problem, accepted))
}

fn with_article(words: &str) -> String {
    let vowel = words.starts_with('o');
    format!("{} {words}", if vowel { "an" } else { "a" })
}

fn check_focal(place: Arguments, name: &str, focal: f64, file: &SceneFile) -> Checked {
    let key = format_args!("{place}.camera");
    check_camera_name(file, key, name)?;
    let is_sound = file.camera_named(name).is_none_or(Camera::is_perspective);
    let problem = format_args!("`{name}` is an orthographic camera and has no lens");
    unless(is_sound, key, problem, "a perspective camera is needed")?;
    let key = format_args!("{place}.focal");
    check_number(key, focal)?;
    let accepted = format_args!(
        "a focal length from {SHORTEST_FOCAL} to {LONGEST_FOCAL} millimetres is possible"
    );
    check_within(key, focal, [SHORTEST_FOCAL, LONGEST_FOCAL], accepted)
}

/// Refuses a mirror image over several frames: on the way there is a frame without thickness.
fn check_parts(place: Arguments, step: &Step, steps: u32) -> Checked {
    let Step::Scale(scale) = step else {
        return Ok(());
    };
    let factors = scale.factors();
    let mirrors = factors.iter().any(|factor| *factor < 0.0);
    let key = format_args!("{place}.scale");
    let problem = format_args!("{factors:?} mirrors, which cannot be spread over {steps} frames");
    let accepted = "factors above 0, or an image with `steps = 1`, are needed";
    unless(steps <= 1 || !mirrors, key, problem, accepted)
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
                let circle = path.iter().skip_while(|i| **i != index).chain([&index]);
                let names = circle.map(|i| format!("`{}`", images[*i].name));
                let names: Vec<String> = names.collect();
                let place = format!("image `{}`, parent", image.name);
                let problem = format!("the images start from each other: {}", names.join(" from "));
                let accepted =
                    "a chain of parents that ends with an image without `parent` is needed";
                return Err(SceneError::value(place, problem, accepted));
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
    let index = index_of.get(name.as_str()).copied();
    if index.is_none() {
        let place = format_args!("image `{}`, parent", image.name);
        let problem = format_args!("`{name}` is not an image of this scene");
        let accepted = known(images.iter().map(|i| i.name.as_str()), "`[[images]]`");
        return Err(SceneError::value(place, problem, accepted));
    }
    Ok(index)
}
