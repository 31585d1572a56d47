//! `[camera]` as it stands in the file.

use super::{numbers, refuse_key, require};
use crate::scene::file::{Camera, upwards};
use serde::{Deserialize, Serialize};

/// The keys of `[camera]` as they stand in the file.
#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(in crate::scene) struct CameraKeys {
    kind: CameraKind,
    #[serde(deserialize_with = "numbers")]
    eye: [f64; 3],
    #[serde(deserialize_with = "numbers")]
    target: [f64; 3],
    #[serde(default = "upwards", deserialize_with = "numbers")]
    up: [f64; 3],
    viewer_distance: Option<f64>,
    view_height: f64,
    half_depth: Option<f64>,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
enum CameraKind {
    Perspective,
    Orthographic,
}

impl TryFrom<CameraKeys> for Camera {
    type Error = String;

    fn try_from(keys: CameraKeys) -> Result<Self, String> {
        let CameraKeys {
            kind,
            eye,
            target,
            up,
            viewer_distance,
            view_height,
            half_depth,
        } = keys;
        match kind {
            CameraKind::Perspective => {
                refuse_key(
                    half_depth.is_some(),
                    "half_depth",
                    "a perspective camera",
                    "`viewer_distance`",
                )?;
                Ok(Self::Perspective {
                    eye,
                    target,
                    up,
                    viewer_distance: require(
                        viewer_distance,
                        "a perspective camera",
                        "`viewer_distance`, from the eye to the screen plane",
                    )?,
                    view_height,
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
                    view_height,
                    half_depth: require(
                        half_depth,
                        "an orthographic camera",
                        "`half_depth`, the depth covered on each side of the screen plane",
                    )?,
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
            } => Self {
                kind: CameraKind::Perspective,
                eye,
                target,
                up,
                viewer_distance: Some(viewer_distance),
                view_height,
                half_depth: None,
            },
            Camera::Orthographic {
                eye,
                target,
                up,
                view_height,
                half_depth,
            } => Self {
                kind: CameraKind::Orthographic,
                eye,
                target,
                up,
                viewer_distance: None,
                view_height,
                half_depth: Some(half_depth),
            },
        }
    }
}
