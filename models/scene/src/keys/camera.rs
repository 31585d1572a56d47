//! `[camera]` as it stands in the file.

use super::{numbers, refuse_key, require};
use crate::camera::{
    LONGEST_FOCAL, NARROWEST_FIELD, SHORTEST_FOCAL, WIDEST_FIELD, height_of_field, height_of_focal,
};
use crate::file::{Camera, Step, upwards};
use crate::group::Node;
use serde::{Deserialize, Serialize};

/// The keys of `[camera]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CameraKeys {
    kind: CameraKind,
    #[serde(deserialize_with = "numbers")]
    eye: [f64; 3],
    #[serde(deserialize_with = "numbers")]
    target: [f64; 3],
    #[serde(default = "upwards", deserialize_with = "numbers")]
    up: [f64; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    viewer_distance: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    view_height: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    focal: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    field_of_view: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    half_depth: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    near: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    far: Option<f64>,
    #[serde(
        default,
        skip_serializing_if = "is_whole",
        deserialize_with = "numbers"
    )]
    sample_at: [f64; 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    name: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    group: Option<String>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    place: Vec<Step>,
}

fn is_whole(sample_at: &[f64; 2]) -> bool {
    *sample_at == [0.0; 2]
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CameraKind {
    Perspective,
    Orthographic,
}

/// The keys that say how much of the screen plane the picture shows.
struct Window {
    height: Option<f64>,
    focal: Option<f64>,
    field: Option<f64>,
}

impl Window {
    /// Height in scene units of the window at a distance.
    fn of_perspective(&self, distance: f64) -> Result<f64, String> {
        match (self.height, self.focal, self.field) {
            (Some(height), None, None) => Ok(height),
            (None, Some(focal), None) => {
                let what = ["focal length", "millimetres"];
                within("focal", what, focal, [SHORTEST_FOCAL, LONGEST_FOCAL])?;
                Ok(height_of_focal(distance, focal))
            }
            (None, None, Some(degrees)) => {
                let what = ["vertical field of view", "degrees"];
                within("field_of_view", what, degrees, [NARROWEST_FIELD, WIDEST_FIELD])?;
                Ok(height_of_field(distance, degrees))
            }
            (None, None, None) => Err(
                "missing field `view_height`: a perspective camera needs the height of its window in the screen plane, or `focal` or `field_of_view` instead"
                    .into(),
            ),
            _ => Err(
                "a perspective camera takes one of `view_height`, `focal`, `field_of_view`; found several"
                    .into(),
            ),
        }
    }

    /// Height in scene units of a parallel view.
    fn of_parallel_view(&self) -> Result<f64, String> {
        let wanted = "`view_height`, the height of the picture in scene units";
        for (key, value) in [("focal", self.focal), ("field_of_view", self.field)] {
            refuse_key(value.is_some(), key, "an orthographic camera", wanted)?;
        }
        let missing = "missing field `view_height`: an orthographic camera";
        require(self.height, missing, wanted)
    }
}

/// Both ends of the depth of an orthographic camera, or none.
fn ends(
    near: Option<f64>,
    far: Option<f64>,
    half_depth: Option<f64>,
) -> Result<Option<[f64; 2]>, String> {
    match (near, far, half_depth) {
        (None, None, _) => Ok(None),
        (Some(near), Some(far), None) => Ok(Some([near, far])),
        (Some(_), Some(_), Some(_)) => Err(
            "an orthographic camera takes `half_depth`, or `near` and `far`; found all three"
                .into(),
        ),
        _ => Err(
            "an orthographic camera takes both `near` and `far`, distances from the screen plane away from the observer, or none of them"
                .into(),
        ),
    }
}

fn within(
    key: &str,
    [what, unit]: [&str; 2],
    value: f64,
    [least, most]: [f64; 2],
) -> Result<(), String> {
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
        let window = Window {
            height: keys.view_height,
            focal: keys.focal,
            field: keys.field_of_view,
        };
        let CameraKeys {
            kind,
            eye,
            target,
            up,
            viewer_distance,
            view_height,
            half_depth,
            near,
            far,
            sample_at,
            ..
        } = keys;
        let node = Node {
            name: keys.name,
            group: keys.group,
            visible: true,
            place: keys.place,
        };
        match kind {
            CameraKind::Perspective => {
                refuse_key(
                    half_depth.is_some(),
                    "half_depth",
                    "a perspective camera",
                    "`viewer_distance`",
                )?;
                refuse_key(
                    far.is_some(),
                    "far",
                    "a perspective camera",
                    "`near` alone; its depth reaches to infinity",
                )?;
                let viewer_distance = match (viewer_distance, view_height) {
                    (Some(distance), _) => distance,
                    // Seen under an angle, the window may stand anywhere.
                    (None, None) => 1.0,
                    (None, Some(_)) => {
                        return Err("missing field `viewer_distance`: a perspective camera with `view_height` needs the distance \
                                    from the eye to the screen plane, on which that height is measured; \
                                    `field_of_view` or `focal` need none"
                            .into());
                    }
                };
                Ok(Self::Perspective {
                    eye,
                    target,
                    up,
                    viewer_distance,
                    view_height: window.of_perspective(viewer_distance)?,
                    near,
                    sample_at,
                    node,
                })
            }
            CameraKind::Orthographic => {
                refuse_key(
                    viewer_distance.is_some(),
                    "viewer_distance",
                    "an orthographic camera",
                    "`half_depth`",
                )?;
                Ok(Self::Orthographic {
                    eye,
                    target,
                    up,
                    view_height: window.of_parallel_view()?,
                    half_depth,
                    ends: ends(near, far, half_depth)?,
                    sample_at,
                    node,
                })
            }
        }
    }
}

impl From<Camera> for CameraKeys {
    fn from(camera: Camera) -> Self {
        match camera {
            Camera::Perspective {
                eye,
                target,
                up,
                viewer_distance,
                view_height,
                near,
                sample_at,
                node,
            } => Self {
                kind: CameraKind::Perspective,
                eye,
                target,
                up,
                viewer_distance: Some(viewer_distance),
                view_height: Some(view_height),
                focal: None,
                field_of_view: None,
                half_depth: None,
                near,
                far: None,
                sample_at,
                name: node.name,
                group: node.group,
                place: node.place,
            },
            Camera::Orthographic {
                eye,
                target,
                up,
                view_height,
                half_depth,
                ends,
                sample_at,
                node,
            } => Self {
                kind: CameraKind::Orthographic,
                eye,
                target,
                up,
                viewer_distance: None,
                view_height: Some(view_height),
                focal: None,
                field_of_view: None,
                half_depth,
                near: ends.map(|[near, _]| near),
                far: ends.map(|[_, far]| far),
                sample_at,
                name: node.name,
                group: node.group,
                place: node.place,
            },
        }
    }
}
