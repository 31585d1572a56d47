//! The checks of a scene that its grammar cannot make.

use rayon::prelude::*;
use std::collections::HashSet;

use super::check_kind::check_kind;
use super::error::SceneError;
use super::file::{
    Aim, Axis, Camera, Cut, FORMAT_VERSION, Light, Material, Object, Scale, SceneFile, Shape, Step,
    Surface,
};
use super::flat::Groups;
use super::image_check::check_images;
use super::names::{check_members, check_names};
use super::transform::{cross, dot, normalised};

/// Most cut planes of one object.
pub const MAX_CUTS: usize = 12;
/// Most columns or lines of a picture.
pub const MAX_IMAGE_SIDE: u32 = 4096;
/// Most light sources: a pixel carries one flag for each (thesis section 4.1.3).
pub const MAX_LIGHTS: usize = 16;
/// Shortest length of a camera, in scene units; below it `f64` pictures of it lose their meaning.
const SHORTEST_LENGTH: f64 = 1e-30;
/// Largest magnitude of any number of a scene; beyond it `f64` directions lose their meaning.
pub const MAX_MAGNITUDE: f64 = 1e12;
/// Largest exponent of a highlight.
pub const MAX_SPECULAR_EXPONENT: u32 = 200;
/// Largest factor of a light's colour.
pub const MAX_INTENSITY: f64 = 10.0;

/// Smallest angle between the axis of a spot and its cone, in degrees.
pub const SMALLEST_HALF_ANGLE: f64 = 0.1;
/// Largest angle between the axis of a spot and its cone, in degrees; at 90 the cone is a plane.
pub const LARGEST_HALF_ANGLE: f64 = 89.0;

/// Sine of the angle under which `up` counts as parallel to the viewing direction.
const PARALLEL: f64 = 1e-9;

pub(super) type Checked = Result<(), SceneError>;

impl SceneFile {
    /// Refuses a scene that cannot be drawn; [`SceneFile::parse`] has done so already, unless molecules are to be read.
    pub fn validate(&self) -> Checked {
        self.check_molecules_read()?;
        self.validate_text()
    }

    /// Refuses what cannot be drawn, as far as it stands in the scene's own file.
    pub(super) fn validate_text(&self) -> Checked {
        if self.format != FORMAT_VERSION {
            return Err(SceneError::value(
                "format",
                format!("version {} is not known", self.format),
                format!("this program reads `format = {FORMAT_VERSION}`"),
            ));
        }
        check_colour("background", self.background)?;
        check_colour("ambient", self.ambient)?;
        check_image_size(self.image.width, self.image.height)?;
        for camera in self.all_cameras() {
            check_camera(camera)?;
        }
        self.check_lights()?;
        self.check_materials()?;
        let names = check_names(self)?;
        check_members(self)?;
        self.check_groups()?;
        self.check_objects()?;
        // An action may be of an object that a molecule will bring.
        if self.molecules.is_empty() {
            check_images(self, &names)?;
        }
        Ok(())
    }

    fn check_lights(&self) -> Checked {
        if self.lights.len() > MAX_LIGHTS {
            return Err(SceneError::value(
                "lights",
                format!("{} lights", self.lights.len()),
                format!("at most {MAX_LIGHTS} are possible"),
            ));
        }
        for (index, light) in self.lights.iter().enumerate() {
            let place = format!("lights[{index}]");
            check_light(&place, light)?;
            check_place(&place, &light.node().place)?;
        }
        Ok(())
    }

    fn check_materials(&self) -> Checked {
        let mut names = HashSet::new();
        for (index, material) in self.materials.iter().enumerate() {
            check_name(&format!("materials[{index}].name"), &material.name)?;
            let place = format!("material `{}`", material.name);
            if !names.insert(&material.name) {
                return Err(duplicate(&place, "material"));
            }
            check_material(&place, material)?;
        }
        Ok(())
    }

    fn check_groups(&self) -> Checked {
        let mut groups = self.groups.iter();
        groups.try_for_each(|group| check_place(&format!("group `{}`", group.name), &group.place))
    }

    fn check_objects(&self) -> Checked {
        if self.objects.is_empty() && self.molecules.is_empty() {
            return Err(SceneError::value(
                "objects",
                "the scene has no object",
                "at least one `[[objects]]` is needed",
            ));
        }
        let groups = Groups::of(self);
        // The first that is wrong, in the order of the file, whoever finds one first.
        let problem = |object: &Object| {
            let place = format!("object `{}`", object.name);
            self.check_material_name(&place, object)?;
            check_object(&place, object)?;
            if object.group.is_some() {
                let mut placed = object.clone();
                placed.place = groups.whole(&object.place, object.group.as_deref());
                check_kind(&place, &placed, self.active())
            } else {
                check_kind(&place, object, self.active())
            }
        };
        let objects = self.objects.par_iter();
        objects
            .find_map_first(|object| problem(object).err())
            .map_or(Ok(()), Err)
    }

    /// Refuses an object of a flat scene that cannot be had where it has been moved to; all else of it was checked
    /// before.
    pub fn check_moved(&self, object: &Object) -> Checked {
        let place = format!("object `{}`", object.name);
        check_place(&place, &object.place)?;
        check_kind(&place, object, &self.camera)
    }

    fn check_material_name(&self, place: &str, object: &Object) -> Checked {
        if self.materials.iter().any(|m| m.name == object.material) {
            return Ok(());
        }
        let known: Vec<_> = self
            .materials
            .iter()
            .map(|m| format!("`{}`", m.name))
            .collect();
        let accepted = if known.is_empty() {
            "the scene has no `[[materials]]` yet".to_owned()
        } else {
            format!("the scene has {}", known.join(", "))
        };
        Err(SceneError::value(
            format!("{place}, material"),
            format!("`{}` is not a material of this scene", object.material),
            accepted,
        ))
    }
}

/// Refuses a picture size the machine cannot scan.
pub(super) fn check_image_size(width: u32, height: u32) -> Checked {
    for (key, side) in [("image.width", width), ("image.height", height)] {
        if side == 0 || side > MAX_IMAGE_SIDE {
            return Err(SceneError::value(
                key,
                format!("{side} pixels"),
                format!("1 to {MAX_IMAGE_SIDE} are possible"),
            ));
        }
    }
    Ok(())
}

fn check_camera(camera: &Camera) -> Checked {
    let name = camera.node().name.as_ref();
    let key = |key: &str| match name {
        Some(name) => format!("camera `{name}`, {key}"),
        None => format!("camera.{key}"),
    };
    let (eye, target, up) = match camera {
        Camera::Perspective {
            eye,
            target,
            up,
            viewer_distance,
            view_height,
            near,
            ..
        } => {
            check_length(&key("viewer_distance"), *viewer_distance)?;
            check_length(&key("view_height"), *view_height)?;
            if let Some(near) = near {
                check_length(&key("near"), *near)?;
            }
            (*eye, *target, *up)
        }
        Camera::Orthographic {
            eye,
            target,
            up,
            view_height,
            half_depth,
            ends,
            ..
        } => {
            check_length(&key("view_height"), *view_height)?;
            if let Some(half_depth) = half_depth {
                check_length(&key("half_depth"), *half_depth)?;
            }
            if let Some([near, far]) = ends {
                check_numbers(&key("near"), &[*near])?;
                check_numbers(&key("far"), &[*far])?;
                if near >= far {
                    return Err(SceneError::value(
                        key("far"),
                        format!("{far} is not behind `near`, which is {near}"),
                        "a greater number is needed: both are distances from the screen plane away from the observer",
                    ));
                }
            }
            (*eye, *target, *up)
        }
    };
    check_numbers(&key("eye"), &eye)?;
    if let Some(value) = camera
        .sample_at()
        .iter()
        .find(|v| !(-1.0..=1.0).contains(*v))
    {
        return Err(SceneError::value(
            key("sample_at"),
            format!("{value} is out of range"),
            "columns and lines from a pixel's whole coordinates are needed, each from -1 to 1",
        ));
    }
    check_numbers(&key("target"), &target)?;
    check_direction(&key("up"), up)?;
    let view: [f64; 3] = std::array::from_fn(|axis| target[axis] - eye[axis]);
    if view == [0.0; 3] {
        return Err(SceneError::value(
            key("target"),
            format!("{target:?} is the eye itself, so there is no viewing direction"),
            "a point away from the eye is needed",
        ));
    }
    check_up(&key("up"), view, up)?;
    let place = name.map_or("camera".to_owned(), |name| format!("camera `{name}`"));
    check_place(&place, &camera.node().place)
}

/// Refuses a length of the camera that is not above 0, or so short that nothing could be told apart in it.
fn check_length(place: &str, value: f64) -> Checked {
    check_positive(place, value)?;
    if value < SHORTEST_LENGTH {
        return Err(SceneError::value(
            place,
            format!("{value:e} is too small"),
            format!("at least {SHORTEST_LENGTH:e} is possible"),
        ));
    }
    Ok(())
}

/// Refuses a direction upwards along the view.
pub(super) fn check_up(key: &str, view: [f64; 3], up: [f64; 3]) -> Checked {
    let side = cross(normalised(view), normalised(up));
    if dot(side, side).sqrt() < PARALLEL {
        return Err(SceneError::value(
            key,
            format!("{up:?} is parallel to the viewing direction {view:?}"),
            "a direction seen upwards in the picture is needed",
        ));
    }
    Ok(())
}

fn check_light(place: &str, light: &Light) -> Checked {
    let (colour, intensity) = match light {
        Light::Directional {
            from,
            colour,
            intensity,
            ..
        } => {
            check_direction(&format!("{place}.from"), *from)?;
            (colour, intensity)
        }
        Light::Point {
            position,
            colour,
            intensity,
            ..
        } => {
            check_numbers(&format!("{place}.position"), position)?;
            (colour, intensity)
        }
        Light::Spot {
            position,
            aim,
            half_angle,
            colour,
            intensity,
            ..
        } => {
            check_numbers(&format!("{place}.position"), position)?;
            check_aim(place, *position, *aim)?;
            check_half_angle(&format!("{place}.half_angle"), *half_angle)?;
            (colour, intensity)
        }
    };
    check_colour(&format!("{place}.colour"), *colour)?;
    check_range(&format!("{place}.intensity"), *intensity, MAX_INTENSITY)
}

fn check_aim(place: &str, position: [f64; 3], aim: Aim) -> Checked {
    match aim {
        Aim::Towards(direction) => check_direction(&format!("{place}.towards"), direction),
        Aim::Target(target) => {
            let key = format!("{place}.target");
            check_numbers(&key, &target)?;
            if target == position {
                return Err(SceneError::value(
                    key,
                    format!("{target:?} is the position of the spot itself, so it has no axis"),
                    "a point away from `position` is needed",
                ));
            }
            Ok(())
        }
    }
}

fn check_half_angle(key: &str, degrees: f64) -> Checked {
    check_number(key, degrees)?;
    if !(SMALLEST_HALF_ANGLE..=LARGEST_HALF_ANGLE).contains(&degrees) {
        return Err(SceneError::value(
            key,
            format!("{degrees} degrees is out of range"),
            format!(
                "an angle between axis and cone from {SMALLEST_HALF_ANGLE} to {LARGEST_HALF_ANGLE} degrees is possible"
            ),
        ));
    }
    Ok(())
}

fn check_material(place: &str, material: &Material) -> Checked {
    check_colour(&format!("{place}, colour"), material.colour)?;
    check_range(&format!("{place}, ambient"), material.ambient, 1.0)?;
    check_range(&format!("{place}, diffuse"), material.diffuse, 1.0)?;
    check_range(&format!("{place}, specular"), material.specular, 1.0)?;
    if !(1..=MAX_SPECULAR_EXPONENT).contains(&material.exponent) {
        return Err(SceneError::value(
            format!("{place}, exponent"),
            format!("{} is out of range", material.exponent),
            format!("a whole number from 1 to {MAX_SPECULAR_EXPONENT} is possible"),
        ));
    }
    Ok(())
}

fn check_object(place: &str, object: &Object) -> Checked {
    check_shape(place, object)?;
    check_place(place, &object.place)?;
    if object.cuts.len() > MAX_CUTS {
        return Err(SceneError::value(
            format!("{place}, cuts"),
            format!("{} cut planes", object.cuts.len()),
            format!("at most {MAX_CUTS} are possible"),
        ));
    }
    for (index, Cut { point, normal }) in object.cuts.iter().enumerate() {
        check_numbers(&format!("{place}, cuts[{index}].point"), point)?;
        check_direction(&format!("{place}, cuts[{index}].normal"), *normal)?;
    }
    Ok(())
}

fn check_shape(place: &str, object: &Object) -> Checked {
    let shape = &object.shape;
    let cut_surface = object.mode == Surface::Patch && !object.cuts.is_empty();
    let radii: &[f64] = match shape {
        Shape::Sphere { radius } => return check_positive(&format!("{place}, radius"), *radius),
        Shape::Quadric { coefficients } => {
            return check_coefficients(place, coefficients, cut_surface);
        }
        Shape::Polyhedron | Shape::Mesh(_) | Shape::TetrahedronPatch { .. } => return Ok(()),
        Shape::EllipticCylinder { radii }
        | Shape::HyperbolicCylinder { radii }
        | Shape::ParabolicCylinder { radii } => radii,
        Shape::Ellipsoid { radii }
        | Shape::Cone { radii }
        | Shape::HyperboloidOneSheet { radii }
        | Shape::HyperboloidTwoSheets { radii }
        | Shape::EllipticParaboloid { radii }
        | Shape::HyperbolicParaboloid { radii } => radii,
    };
    for (index, radius) in radii.iter().enumerate() {
        check_positive(&format!("{place}, radii[{index}]"), *radius)?;
    }
    Ok(())
}

/// A surface of first degree is a plane, which is a cut of a solid; as a surface it is a part of a plane that cuts
/// bound.
fn check_coefficients(place: &str, coefficients: &[f64; 10], cut_surface: bool) -> Checked {
    let key = format!("{place}, coefficients");
    check_numbers(&key, coefficients)?;
    let zero = |part: &[f64]| part.iter().all(|value| *value == 0.0);
    if !zero(&coefficients[..6]) || (cut_surface && !zero(&coefficients[6..9])) {
        return Ok(());
    }
    let rest = if zero(coefficients) {
        "all ten are zero"
    } else if zero(&coefficients[6..9]) {
        "all but j are zero, which leaves nothing"
    } else {
        "a to f are zero, which leaves a plane"
    };
    Err(SceneError::value(
        key,
        rest,
        "one of the second-degree coefficients a to f must not be zero \
         (a plane is a cut of another object, or a `mode = \"patch\"` with cuts of its own)",
    ))
}

fn check_place(place: &str, steps: &[Step]) -> Checked {
    let mut steps = steps.iter().enumerate();
    steps.try_for_each(|(index, step)| check_step(&format!("{place}, place[{index}]"), step))
}

pub(super) fn check_step(place: &str, step: &Step) -> Checked {
    match step {
        Step::Translate(offset) => check_numbers(&format!("{place}.translate"), offset),
        Step::Rotate(rotation) => {
            if let Axis::Vector(vector) = rotation.axis {
                check_direction(&format!("{place}.rotate.axis"), vector)?;
            }
            check_numbers(&format!("{place}.rotate.degrees"), &[rotation.degrees])
        }
        Step::Scale(Scale::Uniform(factor)) => check_scale(place, &[*factor]),
        Step::Scale(Scale::PerAxis(factors)) => check_scale(place, factors),
    }
}

fn check_scale(place: &str, factors: &[f64]) -> Checked {
    let key = format!("{place}.scale");
    check_numbers(&key, factors)?;
    if factors.contains(&0.0) {
        return Err(SceneError::value(
            key,
            "a factor of 0 flattens the object, the transform is singular",
            "factors other than 0 are needed (negative ones mirror)",
        ));
    }
    Ok(())
}

pub(super) fn check_name(place: &str, name: &str) -> Checked {
    if name.trim().is_empty() {
        return Err(SceneError::value(
            place,
            "the name is empty",
            "a name is needed",
        ));
    }
    Ok(())
}

fn duplicate(place: &str, what: &str) -> SceneError {
    SceneError::value(
        place,
        format!("this name is taken by an earlier {what}"),
        "every name must be unique",
    )
}

fn check_number(place: &str, value: f64) -> Checked {
    if !value.is_finite() {
        return Err(SceneError::value(
            place,
            format!("{value} is not a finite number"),
            "a finite number is needed",
        ));
    }
    if value.abs() > MAX_MAGNITUDE {
        return Err(SceneError::value(
            place,
            format!("{value:e} is too large"),
            format!(
                "numbers from {:e} to {MAX_MAGNITUDE:e} are possible",
                -MAX_MAGNITUDE
            ),
        ));
    }
    Ok(())
}

pub(super) fn check_numbers(place: &str, values: &[f64]) -> Checked {
    match values {
        [value] => check_number(place, *value),
        _ => values
            .iter()
            .enumerate()
            .try_for_each(|(index, value)| check_number(&format!("{place}[{index}]"), *value)),
    }
}

pub(super) fn check_direction(place: &str, vector: [f64; 3]) -> Checked {
    check_numbers(place, &vector)?;
    if vector == [0.0; 3] {
        return Err(SceneError::value(
            place,
            "[0, 0, 0] has no direction",
            "a vector with at least one number other than 0 is needed",
        ));
    }
    Ok(())
}

fn check_positive(place: &str, value: f64) -> Checked {
    check_number(place, value)?;
    if value <= 0.0 {
        return Err(SceneError::value(
            place,
            format!("{value} is not positive"),
            "a number above 0 is needed",
        ));
    }
    Ok(())
}

pub(super) fn check_range(place: &str, value: f64, largest: f64) -> Checked {
    check_number(place, value)?;
    if !(0.0..=largest).contains(&value) {
        return Err(SceneError::value(
            place,
            format!("{value} is out of range"),
            format!("a number from 0 to {largest} is possible"),
        ));
    }
    Ok(())
}

fn check_colour(place: &str, colour: [f64; 3]) -> Checked {
    check_numbers(place, &colour)?;
    for (index, value) in colour.iter().enumerate() {
        if !(0.0..=1.0).contains(value) {
            return Err(SceneError::value(
                format!("{place}[{index}]"),
                format!("{value} is out of range"),
                "red, green and blue are numbers from 0 to 1 (an 8-bit value divided by 255)",
            ));
        }
    }
    Ok(())
}
