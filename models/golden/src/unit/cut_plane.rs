//! The cut-plane unit: shortens a solid's depth interval, or removes faces of a patch, at one plane
//! (source: 2.4.2, comparisons of B.12).

use super::depth_interval::Interval;
use crate::format::Format;
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// How a plane lies to the viewer; decided once in the preparation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[repr(u8)]
pub enum PlaneKind {
    /// No plane: passes everything.
    #[default]
    None = 0,
    /// Normal towards the viewer: keeps depths at and behind the plane.
    Front = words::FRONT_PLANE as u8,
    /// Normal away from the viewer: keeps depths at and before the plane.
    Back = words::BACK_PLANE as u8,
    /// Plane along the line of sight: keeps the pixel where the plane's value is not negative.
    Perpendicular = words::PERPENDICULAR as u8,
}

impl PlaneKind {
    /// All of them, in the order of their words.
    pub const ALL: [PlaneKind; 4] = [Self::None, Self::Front, Self::Back, Self::Perpendicular];
}

/// The interval that is left after one plane of depth (or value) `zp`, already saturated.
///
/// Ties keep the object: a plane that only touches leaves a zero thickness; a plane at the present front or back
/// changes nothing, and the older face number stays.
#[inline]
pub fn cut(
    interval: Interval,
    kind: PlaneKind,
    zp: i64,
    number: u8,
    patch: bool,
    format: &Format,
) -> Interval {
    let Interval { zf, zb, nf, nb } = interval;
    let (front, back) = ((zf, nf), (zb, nb));
    match kind {
        PlaneKind::Perpendicular if zp < 0 => Interval::absent(format),
        PlaneKind::Front if zp <= zf => interval,
        PlaneKind::Front if zb < zp => Interval::absent(format),
        PlaneKind::Front if patch => Interval::new(back, back),
        PlaneKind::Front => Interval::new((zp, number), back),
        PlaneKind::Back if zb <= zp => interval,
        PlaneKind::Back if zp < zf => Interval::absent(format),
        PlaneKind::Back if patch => Interval::new(front, front),
        PlaneKind::Back => Interval::new(front, (zp, number)),
        _ => interval,
    }
}
