//! The checks of names: who is called what, who belongs to whom, and that nothing goes round in circles.

use super::check::{Checked, check_name};
use super::error::SceneError;
use super::file::SceneFile;
use std::collections::HashMap;

/// Most groups above a member.
pub const MAX_NESTING: usize = 64;

/// What has a name that actions and members use.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Class {
    Object,
    Group,
    Light,
    Camera,
}

impl Class {
    pub const fn word(self) -> &'static str {
        match self {
            Self::Object => "object",
            Self::Group => "group",
            Self::Light => "light",
            Self::Camera => "camera",
        }
    }
}

/// Names by class.
pub(super) type Names<'a> = HashMap<&'a str, Class>;

/// The names of everything an action can change; refused are those that are empty or taken.
pub(super) fn check_names(file: &SceneFile) -> Result<Names<'_>, SceneError> {
    let objects = file.objects.iter().map(|o| Some(&o.name)).enumerate();
    let groups = file.groups.iter().map(|g| Some(&g.name)).enumerate();
    let lights = file.lights.iter().map(|l| l.node().name.as_ref());
    let cameras = file.all_cameras().map(|c| c.node().name.as_ref());
    let all = objects
        .map(|(index, name)| (Class::Object, index, name))
        .chain(groups.map(|(index, name)| (Class::Group, index, name)))
        .chain((0..).zip(lights).map(|(i, name)| (Class::Light, i, name)))
        .chain((0..).zip(cameras).map(|(i, name)| (Class::Camera, i, name)));
    let mut names = Names::new();
    for (class, index, name) in all {
        let Some(name) = name else {
            continue;
        };
        let word = class.word();
        check_name(&format!("{word}s[{index}].name"), name)?;
        if let Some(earlier) = names.insert(name.as_str(), class) {
            return Err(SceneError::value(
                format!("{word} `{name}`"),
                format!("this name is taken by an earlier {}", earlier.word()),
                "every name must be unique",
            ));
        }
    }
    Ok(names)
}

/// Refuses members of groups that do not exist, groups that contain themselves, and an active camera that does not exist.
pub(super) fn check_members(file: &SceneFile) -> Checked {
    let objects = file.objects.iter().map(|o| {
        let place = || format!("object `{}`", o.name);
        (o.group.as_deref(), place())
    });
    for (group, place) in objects.filter(|(group, _)| group.is_some()) {
        check_group(file, group, &place)?;
    }
    for group in &file.groups {
        check_group(
            file,
            group.group.as_deref(),
            &format!("group `{}`", group.name),
        )?;
    }
    for (index, light) in file.lights.iter().enumerate() {
        check_group(
            file,
            light.node().group.as_deref(),
            &format!("lights[{index}]"),
        )?;
    }
    for camera in file.all_cameras() {
        let name = camera.node().name.as_ref();
        let place = name.map_or("camera".to_owned(), |name| format!("camera `{name}`"));
        check_group(file, camera.node().group.as_deref(), &place)?;
    }
    check_circles(file)?;
    match &file.active_camera {
        Some(name) => check_camera_name(file, "active_camera", name),
        None => Ok(()),
    }
}

fn check_group(file: &SceneFile, group: Option<&str>, place: &str) -> Checked {
    let Some(name) = group else {
        return Ok(());
    };
    if file.groups.iter().any(|g| g.name == name) {
        return Ok(());
    }
    Err(SceneError::value(
        format!("{place}, group"),
        format!("`{name}` is not a group of this scene"),
        known(file.groups.iter().map(|g| g.name.as_str()), "`[[groups]]`"),
    ))
}

/// Refuses a name that no camera has.
pub(super) fn check_camera_name(file: &SceneFile, place: &str, name: &str) -> Checked {
    let names = || {
        let nodes = file.all_cameras().map(|camera| camera.node());
        nodes.filter_map(|node| node.name.as_deref())
    };
    if names().any(|known| known == name) {
        return Ok(());
    }
    Err(SceneError::value(
        place,
        format!("`{name}` is not a camera of this scene"),
        known(names(), "camera with a `name`"),
    ))
}

/// What a scene has of a sort, as the last part of a message; long lists are cut.
pub(super) fn known<'a>(names: impl Iterator<Item = &'a str>, what: &str) -> String {
    const SHOWN: usize = 12;
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    match names.len() {
        0 => format!("the scene has no {what} yet"),
        count if count > SHOWN => format!(
            "the scene has {} and {} more",
            names[..SHOWN].join(", "),
            count - SHOWN
        ),
        _ => format!("the scene has {}", names.join(", ")),
    }
}

/// Refuses groups that contain themselves, or are nested too deeply.
fn check_circles(file: &SceneFile) -> Checked {
    let above: HashMap<&str, Option<&str>> = file
        .groups
        .iter()
        .map(|group| (group.name.as_str(), group.group.as_deref()))
        .collect();
    for group in &file.groups {
        let place = || format!("group `{}`, group", group.name);
        let mut path = vec![group.name.as_str()];
        let mut next = group.group.as_deref();
        while let Some(name) = next {
            path.push(name);
            if name == group.name {
                return Err(SceneError::value(
                    place(),
                    format!("the group is within itself: {}", arrows(&path)),
                    "a group belongs to one outside it, or to none",
                ));
            }
            if path.len() > MAX_NESTING {
                return Err(SceneError::value(
                    place(),
                    format!(
                        "more than {MAX_NESTING} groups are above it, or they go round in a circle"
                    ),
                    format!("at most {MAX_NESTING} are possible"),
                ));
            }
            next = above.get(name).copied().flatten();
        }
    }
    Ok(())
}

/// A circle of names as it is gone through.
pub(super) fn arrows(path: &[&str]) -> String {
    let names: Vec<String> = path.iter().map(|name| format!("`{name}`")).collect();
    names.join(" in ")
}
