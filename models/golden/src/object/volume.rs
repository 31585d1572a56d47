//! Shadow volumes and the light volumes of spots: which light sources reach the visible point of a pixel (source:
//! 3.2.1, 4.1.3).
//!
//! A volume is a quadric with cut planes, or planes alone. Its processor is given the visible depth and answers inside
//! or outside; it has no normals and hands on no depth.

use super::screen_box::ScreenBox;
use super::words::Expression::{First, Second};
use super::words::{Parts, Words};
use crate::format::Format;
use crate::unit::cut_plane::PlaneKind;
use crate::unit::depth_interval::Class;
use crate::unit::membership::{Point, in_half_space, in_quadric};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::quadric_pe::QuadricDepths;
use serde::{Deserialize, Serialize};

/// Greatest shift of a volume's quadric.
pub const MAX_SHIFT: u8 = 8;
/// Light sources that a pixel has flags for.
pub const SOURCES: u8 = 16;

/// What being inside means.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum VolumeKind {
    /// Inside, the source does not reach the point.
    #[default]
    Shadow,
    /// Only inside does the source, a spot, reach the point.
    Light,
}

impl VolumeKind {
    /// The flags of the sources after a volume of this kind that belongs to a source.
    ///
    /// Both kinds only take flags away, so neither the order of the volumes nor that of lights and shadows matters.
    #[inline]
    pub const fn after(self, source: u8, flags: u16, inside: bool) -> u16 {
        let dark = match self {
            VolumeKind::Shadow => inside,
            VolumeKind::Light => !inside,
        };
        if dark { flags & !(1 << source) } else { flags }
    }
}

/// Coefficient words of a plane of a volume.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct VolumePlane {
    /// How the plane lies to the viewer.
    pub kind: PlaneKind,
    /// Depth of the plane, or its signed half-plane value if perpendicular.
    pub depth: Linear,
}

/// Coefficient words of the quadric of a volume.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct VolumeQuadric {
    /// How the quadric lies to the viewer; a patch has no inside.
    pub class: Class,
    /// Linear part of the depth.
    pub f1: Linear,
    /// Discriminant part of the depth.
    pub f2: Quadratic,
    /// The unit of both is `2^shift` depth words, at most [`MAX_SHIFT`]: a shadow that passes near the viewer has
    /// depths far beyond the depth word.
    pub shift: u8,
}

impl VolumeQuadric {
    /// A quadric that every point is inside of.
    pub const EVERYWHERE: VolumeQuadric = VolumeQuadric {
        class: Class::Prism,
        f1: Linear::new(0, 0, 0),
        f2: Quadratic::new([0, 0, 0, 0, 0, 0]),
        shift: 0,
    };
}

/// All coefficient words of a volume for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct VolumeWords {
    /// Shadow or light.
    pub kind: VolumeKind,
    /// The source it belongs to, less than [`SOURCES`].
    pub source: u8,
    /// Where the volume can be on the screen.
    pub screen_box: ScreenBox,
    /// Counts that a point has to be behind the beginning of the volume; less than half the depth word.
    pub margin: u32,
    /// Its quadric; none in a polyhedral volume.
    pub quadric: Option<VolumeQuadric>,
    /// Its planes.
    pub planes: Vec<VolumePlane>,
}

impl VolumeWords {
    /// The same words as the registers of a format hold them; every accumulator takes the same values.
    pub fn wrapped(&self, format: &Format) -> VolumeWords {
        let mut words = self.clone();
        if let Some(q) = &mut words.quadric {
            q.f1 = q.f1.wrapped(format.pe1_width());
            q.f2 = q.f2.wrapped(format.pe2_width());
        }
        for plane in &mut words.planes {
            plane.depth = plane.depth.wrapped(format.plane);
        }
        words
    }

    /// The flags of the sources after this volume.
    #[inline]
    pub const fn after(&self, flags: u16, inside: bool) -> u16 {
        self.kind.after(self.source, flags, inside)
    }
}

/// Clocks from the visible depth to the answer of a volume with a quadric.
pub const FROM_DEPTH: u32 = 5;

/// Latency in clocks from the raster flags to the answer of a volume with a quadric; the visible depth enters `L`
/// clocks after them.
pub fn quadric_latency(format: &Format, rows_per_stage: u32) -> u32 {
    format.root_latency(rows_per_stage) + FROM_DEPTH
}

/// The same without a quadric; the visible depth enters with the flags.
pub const fn polyhedral_latency() -> u32 {
    4
}

impl Words for VolumeWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let planes = self.planes.iter_mut().map(|plane| First(&mut plane.depth));
        let quadric = self.quadric.iter_mut();
        let quadric = quadric.flat_map(|q| [First(&mut q.f1), Second(&mut q.f2)]);
        (vec![&mut self.screen_box], planes.chain(quadric).collect())
    }
}

impl VolumeWords {
    /// Is the visible depth `z` of pixel (x, y) inside the volume; the background (`z_max`) is not.
    pub fn holds(&self, x: i64, y: i64, z: i64, format: &Format) -> bool {
        let point = Point::new(z, self.margin);
        let in_plane = |plane: &VolumePlane| {
            let zp = plane.depth.wrapped_at(x, y, format.plane);
            in_half_space(plane.kind, zp as i64, point)
        };
        let in_quadric = |q: &VolumeQuadric| {
            let QuadricDepths { f2, near, far, .. } = QuadricDepths::at(&q.f1, &q.f2, x, y, format);
            in_quadric(q.class, near, far, f2 < 0, point.coarse(q.shift))
        };
        self.screen_box.contains(x, y)
            && point.is_surface(format)
            && self.planes.iter().all(in_plane)
            && self.quadric.as_ref().is_none_or(in_quadric)
    }
}
