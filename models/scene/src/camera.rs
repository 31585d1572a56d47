//! The observer: where it looks, the window of its picture, how pictures follow from that, and its keys in the file.
//!
//! The window may be given as on a photographic camera, by focal length or field of view.

use super::error::SceneError;
use super::group::Node;
use super::keys::{is_default, numbers, present, refuse_keys, require, upwards};
use super::limits::check_up;
use super::step::Step;
use super::transform::Transform;
use imogene_algebra::matrix::image;
use imogene_algebra::rational::{from_decimal, integer, to_f64};
use imogene_algebra::vector::{cross, minus, normalised};
use num_rational::BigRational;
use serde::{Deserialize, Serialize};

/// Height in millimetres of the film that focal lengths are for: 24 x 36.
const FILM_HEIGHT: i64 = 24;
/// Shortest focal length in millimetres; its vertical field of view is 170.5 degrees.
pub(super) const SHORTEST_FOCAL: f64 = 1.0;
/// Longest focal length in millimetres; its vertical field of view is 0.14 degrees.
pub(super) const LONGEST_FOCAL: f64 = 10_000.0;
/// Narrowest vertical field of view in degrees.
const NARROWEST_FIELD: f64 = 0.1;
/// Widest vertical field of view in degrees; at 180 the window has no end.
const WIDEST_FIELD: f64 = 170.0;

/// The observer: it looks from `eye` towards `target`, with `up` upwards in the picture.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "CameraKeys", into = "CameraKeys")]
pub struct Camera {
    /// The observer's eye, or a point in the direction that a parallel view is seen from.
    pub eye: [f64; 3],
    /// A point on the optical axis, seen in the middle of the picture.
    pub target: [f64; 3],
    /// A direction seen upwards.
    pub up: [f64; 3],
    /// Height, in scene units, of the window that the picture shows of the screen plane.
    pub view_height: f64,
    /// How it projects on the screen plane.
    pub lens: Lens,
    /// Where pixels are sampled: columns to the right and lines down from whole coordinates.
    pub sample_at: [f64; 2],
    /// Name, group and place.
    pub node: Node,
}

/// How a camera projects.
#[derive(Clone, Debug, PartialEq)]
pub enum Lens {
    /// Central projection on the screen plane at `viewer_distance` in front of the eye.
    Perspective {
        /// Distance from the eye to the screen plane, in scene units.
        viewer_distance: f64,
        /// Distance from the eye at which the depth word begins; chosen for the scene if not given.
        near: Option<f64>,
    },
    /// Parallel projection on the screen plane through `target`.
    Orthographic {
        /// Depth, in scene units, to be covered in front of and behind the screen plane, or more if the objects need
        /// it; chosen for the scene if not given.
        half_depth: Option<f64>,
        /// Where the depth word begins and ends, from the screen plane away from the observer; in the place of
        /// `half_depth`.
        ends: Option<[f64; 2]>,
    },
}

/// Height of the window at a distance through a lens: `24 mm : focal = height : distance`, rounded once to `f64`.
///
/// This is `d = r / tan(phi / 2)` with the half height of the film, 12 mm, as r and the focal length as d (course
/// section 3.3, equation 1.7). The other way round it gives the focal length of a height.
fn on_film(distance: f64, focal: f64) -> f64 {
    if !distance.is_finite() || focal == 0.0 {
        // Refused with its own message when the scene is checked.
        return distance;
    }
    to_f64(&(from_decimal(distance) * integer(FILM_HEIGHT) / from_decimal(focal)))
}

impl Camera {
    /// An observer of a window at a distance, with everything else as it is without its key.
    pub fn perspective(
        [eye, target, up]: [[f64; 3]; 3],
        viewer_distance: f64,
        view_height: f64,
    ) -> Camera {
        Camera {
            eye,
            target,
            up,
            view_height,
            lens: Lens::Perspective {
                viewer_distance,
                near: None,
            },
            sample_at: [0.0; 2],
            node: Node::default(),
        }
    }

    /// Distance from the eye to the screen plane; none in a parallel view.
    pub fn viewer_distance(&self) -> Option<f64> {
        match self.lens {
            Lens::Perspective {
                viewer_distance: distance,
                ..
            } => Some(distance),
            Lens::Orthographic { .. } => None,
        }
    }

    /// Whether its lines of sight meet in the eye.
    pub fn is_perspective(&self) -> bool {
        self.viewer_distance().is_some()
    }

    /// The focal length in millimetres that shows the same window on a film 24 mm high; none for a parallel view.
    pub fn focal(&self) -> Option<f64> {
        let distance = self.viewer_distance();
        distance.map(|distance| on_film(distance, self.view_height))
    }

    /// Takes another lens: the window changes its height, the eye and the screen plane stay. A parallel view has no
    /// lens and stays as it is.
    pub fn set_focal(&mut self, focal: f64) {
        if let Some(distance) = self.viewer_distance() {
            self.view_height = on_film(distance, focal);
        }
    }
}

/// Where a camera stands in the scene, exactly.
pub(super) struct Sight {
    pub eye: [BigRational; 3],
    pub target: [BigRational; 3],
    view: [f64; 3],
    pub up: [f64; 3],
}

impl Sight {
    pub fn of(camera: &Camera) -> Result<Sight, SceneError> {
        let mut sight = Sight {
            eye: camera.eye.map(from_decimal),
            target: camera.target.map(from_decimal),
            view: minus(camera.target, camera.eye),
            up: camera.up,
        };
        if !camera.node.place.is_empty() {
            let placed = Transform::placement(&camera.node.place);
            sight.eye = placed.point(&sight.eye);
            sight.target = placed.point(&sight.target);
            sight.view = minus(&sight.target, &sight.eye).map(|v| to_f64(&v));
            sight.up = placed
                .vector(&camera.up.map(from_decimal))
                .map(|v| to_f64(&v));
            let name = camera.node.name.as_deref().unwrap_or_default();
            check_up(format_args!("camera `{name}`, up"), sight.view, sight.up)?;
        }
        Ok(sight)
    }

    /// Directions to the right, down and along the view.
    pub fn axes(&self) -> [[f64; 3]; 3] {
        let forward = normalised(self.view);
        let right = normalised(cross(forward, normalised(self.up)));
        [right, cross(forward, right), forward]
    }

    /// The frame with its origin at `origin`, z along the view, and `up` towards -y.
    pub fn frame(&self, origin: &[BigRational; 3], pixels_per_unit: &BigRational) -> Transform {
        let to_origin = Transform::translation(origin.each_ref().map(|value| -value));
        let turned = Transform::linear(self.axes()).after(&to_origin);
        Transform::scaling(std::array::from_fn(|_| pixels_per_unit.clone())).after(&turned)
    }
}

/// A camera in floating point: how pixels and distances follow from a point of the scene.
pub struct FloatCamera {
    /// The eye of a perspective camera, the target of an orthographic one.
    pub origin: [f64; 3],
    /// To the right, down and along the view; the framed scene takes these very numbers as exact.
    pub axes: [[f64; 3]; 3],
    /// Pixels for one scene unit: at a distance of one unit from the eye, or everywhere.
    pub pixels: f64,
    /// Where pixels are sampled: columns and lines from whole coordinates.
    pub sample_at: [f64; 2],
}

impl FloatCamera {
    /// A point of the scene from the origin, along the axes.
    pub fn seen(&self, point: [f64; 3]) -> [f64; 3] {
        image(&self.axes, &minus(point, self.origin))
    }

    /// The camera of a picture of so many lines.
    pub fn of(camera: &Camera, height: u32) -> Result<FloatCamera, SceneError> {
        let sight = Sight::of(camera)?;
        let (origin, pixels) = match camera.viewer_distance() {
            Some(distance) => (&sight.eye, distance / camera.view_height),
            None => (&sight.target, camera.view_height.recip()),
        };
        Ok(FloatCamera {
            origin: origin.each_ref().map(to_f64),
            axes: sight.axes(),
            pixels: pixels * f64::from(height),
            sample_at: camera.sample_at,
        })
    }
}

#[derive(Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct CameraKeys {
    kind: CameraKind,
    #[serde(deserialize_with = "numbers")]
    eye: [f64; 3],
    #[serde(deserialize_with = "numbers")]
    target: [f64; 3],
    #[serde(default = "upwards", deserialize_with = "numbers")]
    up: [f64; 3],
    viewer_distance: Option<f64>,
    view_height: Option<f64>,
    focal: Option<f64>,
    field_of_view: Option<f64>,
    half_depth: Option<f64>,
    near: Option<f64>,
    far: Option<f64>,
    #[serde(
        default,
        skip_serializing_if = "is_default",
        deserialize_with = "numbers"
    )]
    sample_at: [f64; 2],
    name: Option<String>,
    group: Option<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    place: Vec<Step>,
}

#[derive(Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CameraKind {
    #[default]
    Perspective,
    Orthographic,
}

impl CameraKeys {
    fn perspective(&self) -> Result<(Lens, f64), String> {
        let owner = "a perspective camera";
        refuse_keys(present!(self; half_depth), owner, "`viewer_distance`")?;
        let wanted = "`near` alone; its depth reaches to infinity";
        refuse_keys(present!(self; far), owner, wanted)?;
        let missing = "missing field `viewer_distance`: a perspective camera with `view_height` needs the distance \
                       from the eye to the screen plane, on which that height is measured; \
                       `field_of_view` or `focal` need none";
        // Seen under an angle, the window may stand anywhere.
        let anywhere = self.view_height.is_none().then_some(1.0);
        let viewer_distance = self.viewer_distance.or(anywhere).ok_or(missing)?;
        let lens = Lens::Perspective {
            viewer_distance,
            near: self.near,
        };
        Ok((lens, self.window_at(viewer_distance)?))
    }

    /// Height of the window at a distance from the eye.
    fn window_at(&self, distance: f64) -> Result<f64, String> {
        match (self.view_height, self.focal, self.field_of_view) {
            (Some(height), None, None) => Ok(height),
            (None, Some(focal), None) => {
                let what = ["focal", "focal length", "millimetres"];
                within(what, focal, [SHORTEST_FOCAL, LONGEST_FOCAL])?;
                Ok(on_film(distance, focal))
            }
            (None, None, Some(degrees)) => {
                let what = ["field_of_view", "vertical field of view", "degrees"];
                within(what, degrees, [NARROWEST_FIELD, WIDEST_FIELD])?;
                Ok(2.0 * distance * (0.5 * degrees).to_radians().tan())
            }
            (None, None, None) => {
                let problem = "missing field `view_height`: a perspective camera needs the height of its window in \
                               the screen plane, or `focal` or `field_of_view` instead";
                Err(problem.into())
            }
            _ => {
                let keys = "`view_height`, `focal`, `field_of_view`";
                Err(format!(
                    "a perspective camera takes one of {keys}; found several"
                ))
            }
        }
    }

    fn orthographic(&self) -> Result<(Lens, f64), String> {
        let owner = "an orthographic camera";
        refuse_keys(present!(self; viewer_distance), owner, "`half_depth`")?;
        let wanted = "`view_height`, the height of the picture in scene units";
        refuse_keys(present!(self; focal, field_of_view), owner, wanted)?;
        let missing = "missing field `view_height`: an orthographic camera";
        let view_height = require(self.view_height, missing, wanted)?;
        let lens = Lens::Orthographic {
            half_depth: self.half_depth,
            ends: self.ends()?,
        };
        Ok((lens, view_height))
    }

    /// Both ends of the depth of an orthographic camera, or none.
    fn ends(&self) -> Result<Option<[f64; 2]>, String> {
        let problem = match (self.near, self.far, self.half_depth) {
            (None, None, _) => return Ok(None),
            (Some(near), Some(far), None) => return Ok(Some([near, far])),
            (Some(_), Some(_), Some(_)) => "`half_depth`, or `near` and `far`; found all three",
            _ => {
                "both `near` and `far`, distances from the screen plane away from the observer, or none of them"
            }
        };
        Err(format!("an orthographic camera takes {problem}"))
    }
}

fn within([key, what, unit]: [&str; 3], value: f64, [least, most]: [f64; 2]) -> Result<(), String> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(format!(
        "{key}: {value} is out of range; a {what} from {least} to {most} {unit} is possible"
    ))
}

impl TryFrom<CameraKeys> for Camera {
    type Error = String;

    fn try_from(keys: CameraKeys) -> Result<Self, String> {
        // With the height of the window in scene units.
        let (lens, view_height) = match keys.kind {
            CameraKind::Perspective => keys.perspective()?,
            CameraKind::Orthographic => keys.orthographic()?,
        };
        Ok(Camera {
            eye: keys.eye,
            target: keys.target,
            up: keys.up,
            view_height,
            lens,
            sample_at: keys.sample_at,
            node: Node {
                name: keys.name,
                group: keys.group,
                visible: true,
                place: keys.place,
            },
        })
    }
}

impl From<Camera> for CameraKeys {
    fn from(camera: Camera) -> Self {
        let mut keys = CameraKeys {
            eye: camera.eye,
            target: camera.target,
            up: camera.up,
            view_height: Some(camera.view_height),
            sample_at: camera.sample_at,
            name: camera.node.name,
            group: camera.node.group,
            place: camera.node.place,
            ..CameraKeys::default()
        };
        match camera.lens {
            Lens::Perspective {
                viewer_distance,
                near,
            } => (keys.viewer_distance, keys.near) = (Some(viewer_distance), near),
            Lens::Orthographic { half_depth, ends } => {
                (keys.kind, keys.half_depth) = (CameraKind::Orthographic, half_depth);
                [keys.near, keys.far] =
                    ends.map_or([None; 2], |[near, far]| [Some(near), Some(far)]);
            }
        }
        keys
    }
}
