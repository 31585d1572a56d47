//! The checks of names: who is called what, who belongs to whom, and that nothing goes round in circles.

use super::camera::Camera;
use super::error::SceneError;
use super::file::SceneFile;
use super::group::Groups;
use super::limits::{Checked, check_name, check_new, unless};
use std::collections::HashMap;
use std::fmt::Display;

/// Most groups above a member.
pub const MAX_NESTING: usize = 64;

/// What has a name that actions and members use: an object, a group, a light or a camera; as messages say it.
pub(super) type Names<'a> = HashMap<&'a str, &'static str>;

/// The names of everything an action can change; refused are those that are empty or taken.
pub(super) fn check_names(file: &SceneFile) -> Result<Names<'_>, SceneError> {
    let lights = file.lights.iter().map(|l| l.node.name.as_ref());
    let cameras = file.all_cameras().map(|c| c.node.name.as_ref());
    let all: [(_, Vec<_>); 4] = [
        (
            "object",
            file.objects.iter().map(|o| Some(&o.name)).collect(),
        ),
        ("group", file.groups.iter().map(|g| Some(&g.name)).collect()),
        ("light", lights.collect()),
        ("camera", cameras.collect()),
    ];
    let mut names = Names::new();
    for (word, list) in all {
        for (index, name) in list.into_iter().enumerate() {
            let Some(name) = name else {
                continue;
            };
            check_name(format_args!("{word}s[{index}].name"), name)?;
            if let Some(earlier) = names.insert(name, word) {
                check_new(false, format_args!("{word} `{name}`"), earlier)?;
            }
        }
    }
    Ok(names)
}

/// Refuses members of groups that do not exist, groups that contain themselves, and an active camera that does not
/// exist.
pub(super) fn check_members(file: &SceneFile) -> Checked {
    for object in &file.objects {
        check_group(file, &object.group, || format!("object `{}`", object.name))?;
    }
    for group in &file.groups {
        check_group(file, &group.group, || format!("group `{}`", group.name))?;
    }
    for (index, light) in file.lights.iter().enumerate() {
        check_group(file, &light.node.group, || format!("lights[{index}]"))?;
    }
    for camera in file.all_cameras() {
        check_group(file, &camera.node.group, || place_of(camera))?;
    }
    check_circles(file)?;
    match &file.active_camera {
        Some(name) => check_camera_name(file, "active_camera", name),
        None => Ok(()),
    }
}

pub(super) fn place_of(camera: &Camera) -> String {
    let name = camera.node.name.as_ref();
    name.map_or("camera".to_owned(), |name| format!("camera `{name}`"))
}

fn check_group(file: &SceneFile, group: &Option<String>, place: impl Fn() -> String) -> Checked {
    let names = || file.groups.iter().map(|group| group.name.as_str());
    match group {
        Some(name) if !names().any(|own| own == name) => Err(SceneError::value(
            format_args!("{}, group", place()),
            format_args!("`{name}` is not a group of this scene"),
            known(names(), "`[[groups]]`"),
        )),
        _ => Ok(()),
    }
}

pub(super) fn check_camera_name(file: &SceneFile, place: impl Display, name: &str) -> Checked {
    if file.camera_named(name).is_some() {
        return Ok(());
    }
    let names = file
        .all_cameras()
        .filter_map(|camera| camera.node.name.as_deref());
    let problem = format_args!("`{name}` is not a camera of this scene");
    let accepted = known(names, "camera with a `name`");
    Err(SceneError::value(place, problem, accepted))
}

/// What a scene has of a sort, as the last part of a message; long lists are cut.
pub(super) fn known<'a>(names: impl Iterator<Item = &'a str>, what: &str) -> String {
    const SHOWN: usize = 12;
    let names: Vec<_> = names.collect();
    let shown = known_all(names.iter().copied().take(SHOWN), what);
    match names.len() {
        count if count > SHOWN => format!("{shown} and {} more", count - SHOWN),
        _ => shown,
    }
}

/// The same for a list that is never long.
pub(super) fn known_all<'a>(names: impl Iterator<Item = &'a str>, what: &str) -> String {
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    match names.is_empty() {
        true => format!("the scene has no {what} yet"),
        false => format!("the scene has {}", names.join(", ")),
    }
}

/// Refuses groups that contain themselves, or are nested too deeply.
fn check_circles(file: &SceneFile) -> Checked {
    let groups = Groups::of(&file.groups);
    for group in &file.groups {
        let place = format_args!("group `{}`, group", group.name);
        let mut path = vec![format!("`{}`", group.name)];
        for above in groups.chain(group.group.as_deref()) {
            path.push(format!("`{}`", above.name));
            if above.name == group.name {
                let problem = format_args!("the group is within itself: {}", path.join(" in "));
                let accepted = "a group belongs to one outside it, or to none";
                return Err(SceneError::value(place, problem, accepted));
            }
            let problem = format_args!(
                "more than {MAX_NESTING} groups are above it, or they go round in a circle"
            );
            let accepted = format_args!("at most {MAX_NESTING} are possible");
            unless(path.len() <= MAX_NESTING, place, problem, accepted)?;
        }
    }
    Ok(())
}
