//! The checks of a scene that its grammar cannot make.

use super::camera::{Camera, Lens};
use super::error::SceneError;
use super::file::{FORMAT_VERSION, Material, SceneFile};
use super::group::Groups;
use super::image_validation::check_images;
use super::kind_validation::check_kind;
use super::light::{Aim, Beam, Light};
use super::limits::*;
use super::names::{check_members, check_names, known_all, place_of};
use super::object::Object;
use super::shape::{Cut, Shape, Surface};
use imogene_algebra::vector::minus;
use rayon::prelude::*;
use std::borrow::Cow;
use std::collections::HashSet;
use std::fmt::Arguments;

impl SceneFile {
    /// Refuses a scene that cannot be drawn; [`SceneFile::parse`] has done so already, unless molecules are to be read.
    pub fn validate(&self) -> Checked {
        if let Some(molecule) = self.molecules.first() {
            let problem = format!("`{}` has not been read", molecule.file);
            let accepted = "the scene is drawn once each is turned into objects";
            return Err(SceneError::value("molecules", problem, accepted));
        }
        self.validate_text()
    }

    /// Refuses what cannot be drawn, as far as it stands in the scene's own file.
    pub(super) fn validate_text(&self) -> Checked {
        let problem = format_args!("version {} is not known", self.format);
        let accepted = format_args!("this program reads `format = {FORMAT_VERSION}`");
        unless(self.format == FORMAT_VERSION, "format", problem, accepted)?;
        check_colour("background", self.background)?;
        check_colour("ambient", self.ambient)?;
        check_image_size(self.image.width, self.image.height)?;
        self.all_cameras().try_for_each(check_camera)?;
        if let Some(half) = self.attenuation {
            check_length("attenuation", half)?;
            let is_sound = self.all_cameras().all(Camera::is_perspective);
            let problem = "a parallel view has no distance from an eye";
            let accepted = "take it out, or make every camera a perspective one";
            unless(is_sound, "attenuation", problem, accepted)?;
        }
        check_count("lights", self.lights.len(), "lights", MAX_LIGHTS)?;
        for (index, light) in self.lights.iter().enumerate() {
            check_light(format_args!("lights[{index}]"), light)?;
        }
        let mut names = HashSet::new();
        for (index, material) in self.materials.iter().enumerate() {
            check_name(format_args!("materials[{index}].name"), &material.name)?;
            let place = format_args!("material `{}`", material.name);
            check_new(names.insert(&material.name), place, "material")?;
            check_material(place, material)?;
        }
        let names = check_names(self)?;
        check_members(self)?;
        for group in &self.groups {
            check_place(format_args!("group `{}`", group.name), &group.place)?;
        }
        self.check_objects()?;
        // An action, or a solid, may be of an object that a molecule will bring.
        if self.molecules.is_empty() {
            self.check_solids()?;
            check_images(self, &names)?;
        }
        Ok(())
    }

    fn check_objects(&self) -> Checked {
        let is_empty = self.objects.is_empty() && self.molecules.is_empty();
        let accepted = "at least one `[[objects]]` is needed";
        unless(!is_empty, "objects", "the scene has no object", accepted)?;
        let groups = Groups::of(&self.groups);
        // The first that is wrong, in the order of the file, whoever finds one first.
        let problem = |object: &Object| {
            let place = format_args!("object `{}`", object.name);
            let names = || self.materials.iter().map(|m| m.name.as_str());
            if !names().any(|name| name == object.material) {
                let key = format_args!("{place}, material");
                let problem = format_args!("`{}` is not a material of this scene", object.material);
                let accepted = known_all(names(), "`[[materials]]`");
                return Err(SceneError::value(key, problem, accepted));
            }
            check_object(place, object)?;
            let mut placed = Cow::Borrowed(object);
            if object.group.is_some() {
                placed.to_mut().place = groups.whole(&object.place, object.group.as_deref());
            }
            check_kind(place, &placed, self.active())
        };
        let objects = self.objects.par_iter();
        let first = objects.find_map_first(|object| problem(object).err());
        first.map_or(Ok(()), Err)
    }

    /// Refuses an object of a flat scene that cannot be had where it has been moved to; all else of it was checked
    /// before.
    pub fn check_moved(&self, object: &Object) -> Checked {
        let place = format_args!("object `{}`", object.name);
        check_place(place, &object.place)?;
        check_kind(place, object, &self.camera)
    }
}

fn check_camera(camera: &Camera) -> Checked {
    let place = place_of(camera);
    let key = |key: &str| match camera.node.name {
        Some(_) => format!("{place}, {key}"),
        None => format!("camera.{key}"),
    };
    let (eye, target, up) = (camera.eye, camera.target, camera.up);
    match camera.lens {
        Lens::Perspective {
            viewer_distance,
            near,
        } => {
            check_length(key("viewer_distance"), viewer_distance)?;
            check_length(key("view_height"), camera.view_height)?;
            near.map_or(Ok(()), |near| check_length(key("near"), near))?;
        }
        Lens::Orthographic { half_depth, ends } => {
            check_length(key("view_height"), camera.view_height)?;
            half_depth.map_or(Ok(()), |half| check_length(key("half_depth"), half))?;
            if let Some([near, far]) = ends {
                check_number(key("near"), near)?;
                check_number(key("far"), far)?;
                let problem = format_args!("{far} is not behind `near`, which is {near}");
                let accepted = "a greater number is needed: both are distances from the screen plane away from \
                                the observer";
                unless(near < far, key("far"), problem, accepted)?;
            }
        }
    }
    check_numbers(key("eye"), &eye)?;
    let accepted =
        "columns and lines from a pixel's whole coordinates are needed, each from -1 to 1";
    for value in camera.sample_at {
        check_within(key("sample_at"), value, [-1.0, 1.0], accepted)?;
    }
    check_numbers(key("target"), &target)?;
    check_direction(key("up"), up)?;
    let view = minus(target, eye);
    let problem = format_args!("{target:?} is the eye itself, so there is no viewing direction");
    let accepted = "a point away from the eye is needed";
    unless(view != [0.0; 3], key("target"), problem, accepted)?;
    check_up(key("up"), view, up)?;
    check_place(&place, &camera.node.place)
}

fn check_light(place: Arguments, light: &Light) -> Checked {
    let key = |key: &str| format!("{place}.{key}");
    match light.beam {
        Beam::Directional { from } => check_direction(key("from"), from)?,
        Beam::Point { position } => check_numbers(key("position"), &position)?,
        Beam::Spot {
            position,
            aim,
            half_angle,
        } => {
            check_numbers(key("position"), &position)?;
            match aim {
                Aim::Towards(direction) => check_direction(key("towards"), direction)?,
                Aim::Target(target) => {
                    check_numbers(key("target"), &target)?;
                    let itself = "is the position of the spot itself, so it has no axis";
                    let problem = format_args!("{target:?} {itself}");
                    let accepted = "a point away from `position` is needed";
                    unless(target != position, key("target"), problem, accepted)?;
                }
            }
            check_number(key("half_angle"), half_angle)?;
            let is_sound = (SMALLEST_HALF_ANGLE..=LARGEST_HALF_ANGLE).contains(&half_angle);
            let problem = format_args!("{half_angle} degrees is out of range");
            let accepted = format_args!(
                "an angle between axis and cone from {SMALLEST_HALF_ANGLE} to {LARGEST_HALF_ANGLE} degrees is \
                 possible"
            );
            unless(is_sound, key("half_angle"), problem, accepted)?;
        }
    }
    check_colour(key("colour"), light.colour)?;
    check_share(key("intensity"), light.intensity, MAX_INTENSITY)?;
    check_place(place, &light.node.place)
}

fn check_material(place: Arguments, material: &Material) -> Checked {
    check_colour(format_args!("{place}, colour"), material.colour)?;
    for (key, share) in [
        ("ambient", material.ambient),
        ("diffuse", material.diffuse),
        ("specular", material.specular),
        ("opacity", material.opacity),
    ] {
        check_share(format_args!("{place}, {key}"), share, 1.0)?;
    }
    let accepted = format_args!("a whole number from 1 to {MAX_SPECULAR_EXPONENT} is possible");
    let (key, range) = (
        format_args!("{place}, exponent"),
        [1, MAX_SPECULAR_EXPONENT],
    );
    check_within(key, material.exponent, range, accepted)
}

fn check_object(place: Arguments, object: &Object) -> Checked {
    match &object.shape {
        Shape::Sphere { radius } => check_positive(format_args!("{place}, radius"), *radius)?,
        Shape::Quadric { coefficients } => {
            let cut_surface = object.mode == Surface::Patch && !object.cuts.is_empty();
            check_coefficients(place, coefficients, cut_surface)?;
        }
        shape => {
            for (index, radius) in shape.radii().into_iter().flatten().enumerate() {
                check_positive(format_args!("{place}, radii[{index}]"), *radius)?;
            }
        }
    }
    check_place(place, &object.place)?;
    let (key, count) = (format_args!("{place}, cuts"), object.cuts.len());
    check_count(key, count, "cut planes", MAX_CUTS)?;
    for (index, Cut { point, normal }) in object.cuts.iter().enumerate() {
        check_numbers(format_args!("{place}, cuts[{index}].point"), point)?;
        check_direction(format_args!("{place}, cuts[{index}].normal"), *normal)?;
    }
    Ok(())
}

/// A surface of first degree is a plane, which is a cut of a solid; as a surface it is a part of a plane that cuts
/// bound.
fn check_coefficients(place: Arguments, coefficients: &[f64; 10], cut_surface: bool) -> Checked {
    let key = format_args!("{place}, coefficients");
    check_numbers(key, coefficients)?;
    let zero = |part: &[f64]| part.iter().all(|value| *value == 0.0);
    let (no_square, no_slope) = (zero(&coefficients[..6]), zero(&coefficients[6..9]));
    let rest = match no_slope {
        true if coefficients[9] == 0.0 => "all ten are zero",
        true => "all but j are zero, which leaves nothing",
        false => "a to f are zero, which leaves a plane",
    };
    let accepted = "one of the second-degree coefficients a to f must not be zero \
                    (a plane is a cut of another object, or a `mode = \"patch\"` with cuts of its own)";
    let is_surface = !no_square || (cut_surface && !no_slope);
    unless(is_surface, key, rest, accepted)
}
