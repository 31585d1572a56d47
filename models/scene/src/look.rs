//! Another look at a scene: from a side, turned, nearer, or so that all of it fills the picture.

use super::camera::{Lens, Sight};
use super::error::SceneError;
use super::file::SceneFile;
use super::light::Beam;
use super::reach::Body;
use super::step::{Axis, Rotation};
use super::transform::rotation_matrix;
use imogene_algebra::rational::to_f64;
use imogene_algebra::vector::{cross, dot, length, minus, normalised};
use rayon::prelude::*;

type Vector = [f64; 3];
/// Directions of a picture in scene coordinates: to the right, upwards and towards the viewer.
type Axes = [Vector; 3];

/// Share of the picture that stays free when a scene fills it, half of it on each side.
pub const MARGIN: f64 = 0.04;
/// An object that reaches so many times farther than the eye is away counts as endless.
const ENDLESS: f64 = 1e3;
/// Steps towards the opening of a picture: of each error a third remains at most.
const STEPS: usize = 10;

/// A side that a scene is seen from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Side {
    /// From z where y is up, from -y where z is up.
    Front,
    /// From behind.
    Back,
    /// From the left of the front.
    Left,
    /// From the right of the front.
    Right,
    /// From above, the back upwards.
    Top,
    /// From below, the front upwards.
    Bottom,
    /// From the front, the right and above, at equal angles.
    Iso,
}

impl Side {
    /// Directions towards the viewer and upwards, where x is to the right, y up and z to the front.
    fn directions(self) -> [Vector; 2] {
        match self {
            Side::Front => [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0]],
            Side::Back => [[0.0, 0.0, -1.0], [0.0, 1.0, 0.0]],
            Side::Left => [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            Side::Right => [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            Side::Top => [[0.0, 1.0, 0.0], [0.0, 0.0, -1.0]],
            Side::Bottom => [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0]],
            Side::Iso => [[1.0, 1.0, 1.0], [-1.0, 2.0, -1.0]],
        }
    }

    /// The directions of a picture of a scene whose camera has this upwards.
    fn axes(self, up: Vector) -> Axes {
        let axis = (0..3).fold(0, |k, l| if up[l].abs() > up[k].abs() { l } else { k });
        let sign = up[axis].signum();
        let up = std::array::from_fn(|k| if k == axis { sign } else { 0.0 });
        let front = match axis {
            2 => [0.0, -1.0, 0.0],
            _ => [0.0, 0.0, 1.0],
        };
        let axes = [cross(up, front), up, front];
        let [towards, up] = self.directions().map(|v| normalised(combined(axes, v)));
        [cross(up, towards), up, towards]
    }
}

/// The sum of axes, each times a factor; no part of it is -0.
fn combined(axes: Axes, factors: Vector) -> Vector {
    let parts = |k: usize| (0..3).map(move |axis| axes[axis][k] * factors[axis]);
    std::array::from_fn(|k| parts(k).sum::<f64>() + 0.0)
}

/// How the camera of a scene is changed.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Look {
    /// The eye goes to this side of the target, as far away as it is.
    pub side: Option<Side>,
    /// Degrees by which the scene is then seen turned about the target: about the picture's directions to the right,
    /// upwards and towards the viewer, in this order.
    pub turn: Option<[f64; 3]>,
    /// The eye or the parallel window then moves, without turning, until the scene fills the picture.
    pub fit: bool,
    /// Factor by which everything is then seen larger.
    pub zoom: Option<f64>,
    /// Directional light turns with the camera.
    pub lights: bool,
}

impl Look {
    /// The scene flattened and as its active camera sees it then, in a picture of so many columns and lines; and the
    /// names of the endless objects that were not fitted.
    ///
    /// A range of the depth word that the camera has does not hold for another place, and is chosen anew there. Fails
    /// if the camera would not be accepted, or nothing with an end is there to be fitted.
    pub fn applied(
        &self,
        scene: &SceneFile,
        (width, height): (u32, u32),
    ) -> Result<(SceneFile, Vec<String>), SceneError> {
        let mut scene = scene.flattened().into_owned();
        let sight = Sight::of(&scene.camera)?;
        let [eye, target] = [&sight.eye, &sight.target].map(|p| p.each_ref().map(to_f64));
        let distance = length(minus(eye, target));
        let [right, down, forward] = sight.axes();
        let before = [right, down.map(|v| 0.0 - v), forward.map(|v| 0.0 - v)];
        let axes = self.side.map_or(before, |side| side.axes(sight.up));
        let axes = self.turn.map_or(axes, |degrees| turned(axes, degrees));
        let mut pose = Pose {
            axes,
            target,
            distance,
        };
        let shape = f64::from(width) / f64::from(height);
        let left_out = match self.fit {
            true => pose.fit(&mut scene, shape)?,
            false => vec![],
        };
        for light in scene.lights.iter_mut().filter(|_| self.lights) {
            if let Beam::Directional { from } = &mut light.beam {
                *from = combined(axes, before.map(|axis| dot(axis, *from)));
            }
        }
        let camera = &mut scene.camera;
        if self.side.is_some() || self.turn.is_some() || self.fit {
            let [_, upwards, towards] = pose.axes;
            camera.node.place.clear();
            match &mut camera.lens {
                Lens::Perspective { near, .. } => *near = None,
                Lens::Orthographic { half_depth, ends } => (*half_depth, *ends) = (None, None),
            }
            camera.target = pose.target;
            camera.eye = std::array::from_fn(|k| pose.target[k] + distance * towards[k]);
            camera.up = upwards;
        }
        camera.view_height /= self.zoom.unwrap_or(1.0);
        scene.validate()?;
        Ok((scene, left_out))
    }
}

impl SceneFile {
    /// Side of a pixel, in scene units, at the depth of the nearest point of all objects with an end; `lines` is the
    /// height of the picture. What is shorter than this is less than a pixel of the picture, wherever it is.
    ///
    /// An object that reaches behind a perspective eye makes it 0. Fails if the camera would not be accepted.
    pub fn nearest_pixel(&self, lines: u32) -> Result<f64, SceneError> {
        let scene = self.flattened();
        let sight = Sight::of(&scene.camera)?;
        let [eye, target] = [&sight.eye, &sight.target].map(|p| p.each_ref().map(to_f64));
        let far = ENDLESS * length(minus(eye, target));
        let [_, _, forward] = sight.axes();
        let towards = forward.map(|v| -v);
        let objects = scene.objects.par_iter();
        let reaches = objects.map(|object| Body::of(object, eye, 10.0 * far).reach(towards));
        let with_end = reaches.filter(|reach| *reach < far);
        let nearest = -with_end.reduce(|| f64::NEG_INFINITY, f64::max);
        let height = scene.camera.view_height / f64::from(lines);
        Ok(match scene.camera.viewer_distance() {
            Some(distance) => height * nearest.max(0.0) / distance,
            None => height,
        })
    }
}

fn turned(axes: Axes, degrees: [f64; 3]) -> Axes {
    let about = [Axis::X, Axis::Y, Axis::Z].into_iter().zip(degrees);
    about.fold(axes, |axes, (axis, degrees)| {
        rotation_matrix(&Rotation { axis, degrees }).map(|row| combined(axes, row))
    })
}

struct Pose {
    axes: Axes,
    target: Vector,
    distance: f64,
}

impl Pose {
    /// Moves until the scene fills the picture; in a parallel view the window also takes another height. Gives the
    /// names of what is endless.
    fn fit(&mut self, scene: &mut SceneFile, shape: f64) -> Result<Vec<String>, SceneError> {
        let size = 10.0 * ENDLESS * self.distance;
        let up = scene.camera.viewer_distance().map_or(0.0, |distance| {
            (1.0 - MARGIN) * 0.5 * scene.camera.view_height / distance
        });
        let tangents = [up * shape, up];
        let objects = scene.objects.par_iter();
        let bodies: Vec<Body> = objects.map(|o| Body::of(o, self.target, size)).collect();
        let ends = bodies.par_iter().map(|body| {
            let far = ENDLESS * self.distance;
            let within = |along: Vector| body.reach(along) < far * length(along);
            sides(&self.axes, tangents).into_iter().all(within)
        });
        let has_end: Vec<bool> = ends.collect();
        let left_out = scene.objects.iter().zip(&has_end).filter(|(_, end)| !**end);
        let left_out = left_out.map(|(object, _)| object.name.clone()).collect();
        let kept = bodies.into_iter().zip(has_end).filter(|(_, end)| *end);
        let bodies: Vec<Body> = kept.map(|(body, _)| body).collect();
        let ([x, y, z], halves) = fitting(&bodies, &self.axes, tangents);
        if ![x, y].iter().all(|v| v.is_finite()) {
            return Err(SceneError::value(
                "objects",
                "nothing that is visible has an end, so that nothing can be fitted into the picture",
                "an object that its cuts bound is needed",
            ));
        }
        let mut along = 0.0;
        if scene.camera.is_perspective() {
            along = z - self.distance;
        } else {
            let half = halves[1].max(halves[0] / shape) / (1.0 - MARGIN);
            scene.camera.view_height = 2.0 * rounded_up(half.max(1e-6 * self.distance));
        }
        let moved = combined(self.axes, [x, y, along]);
        let step = 10f64.powf(self.distance.log10().floor() - 6.0);
        for (place, moved) in self.target.iter_mut().zip(moved) {
            *place = to_steps(*place + moved, step);
        }
        Ok(left_out)
    }
}

/// The nearest decimal in steps of a power of ten, for people who read the file.
fn to_steps(value: f64, step: f64) -> f64 {
    if step < 1.0 {
        let parts = (1.0 / step).round();
        (value * parts).round() / parts + 0.0
    } else {
        (value / step).round() * step + 0.0
    }
}

/// To five digits and no less.
fn rounded_up(value: f64) -> f64 {
    let step = 10f64.powf(value.log10().floor() - 4.0);
    to_steps(value + 0.5 * step, step)
}

/// Normals, away from the viewer's pyramid, of the planes on its right, its left, above and below; of a prism for
/// tangents of 0.
fn sides(axes: &Axes, [across, up]: [f64; 2]) -> [Vector; 4] {
    [
        [1.0, 0.0, across],
        [-1.0, 0.0, across],
        [0.0, 1.0, up],
        [0.0, -1.0, up],
    ]
    .map(|factors| combined(*axes, factors))
}

/// Where the eye stands, in parts along the axes of a picture, if everything just fits between the sides of its
/// pyramid: these have tangents to the right and upwards. With it half the width and height of what is seen; of a
/// prism, for tangents of 0, that is all there is to say.
pub fn fitting(bodies: &[Body], axes: &Axes, tangents: [f64; 2]) -> ([f64; 3], [f64; 2]) {
    let reach = |along: Vector| {
        let reaches = bodies.par_iter().map(|body| body.reach(along));
        reaches.reduce(|| f64::NEG_INFINITY, f64::max)
    };
    // A plane n.p <= n.eye on every side: the sum of two opposite ones has the distance alone, the difference the
    // place between them.
    let [right, left, above, below] = sides(axes, tangents).map(reach);
    let halves = [0.5 * (right + left), 0.5 * (above + below)];
    let away = (halves[0] / tangents[0]).max(halves[1] / tangents[1]);
    ([0.5 * (right - left), 0.5 * (above - below), away], halves)
}

/// The narrowest picture of all bodies from an eye so far along the direction towards the viewer, at least three times
/// as far as they reach from the origin: where the eye stands across it, and the tangent of half the angle that the
/// picture shows upwards, [`MARGIN`] included; `shape` is width by height.
pub fn fitting_from(bodies: &[Body], axes: &Axes, away: f64, shape: f64) -> ([f64; 2], f64) {
    let fits = |tangent: f64| fitting(bodies, axes, [tangent * shape, tangent]);
    let (mut tangent, mut across) = (0.25, [0.0; 2]);
    for _ in 0..STEPS {
        let ([x, y, fitted], _) = fits(tangent);
        // All would fit from `w / tangent + z` for what touches the sides at a height of w and a depth of z.
        tangent *= fitted / away;
        across = [x, y];
    }
    (across, tangent / (1.0 - MARGIN))
}
