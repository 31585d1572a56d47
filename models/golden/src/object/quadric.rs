//! The quadric object processor of the second generation, any number of cut planes (source: 2.4.2).

pub use super::screen_box::ScreenBox;
use super::words::Expression::{First, Second};
pub use super::words::ObjectPixel;
use super::words::{Object, Parts, Words};
use crate::format::Format;
use crate::unit::cut_plane::{PlaneKind, cut};
use crate::unit::depth_interval::{Class, FACE_PLANE, Interval, halves};
use crate::unit::half_spaces::tree_levels;
use crate::unit::merge::merge;
use crate::unit::normal::{NormalWords, select};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::plane_depth::saturate;
use crate::unit::quadric_pe::QuadricDepths;
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// Largest number of cut planes of one object.
pub const MAX_PLANES: usize = words::MOST_PLANES as usize;

/// Coefficient words of one cut plane.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct PlaneWords {
    /// How the plane lies to the viewer.
    pub kind: PlaneKind,
    /// Depth of the plane, or its signed half-plane value if perpendicular.
    pub depth: Linear,
    /// Constant normal.
    pub normal: [i16; 3],
}

impl PlaneWords {
    /// A plane of a kind with its depth and its normal.
    pub const fn new(kind: PlaneKind, depth: Linear, normal: [i16; 3]) -> PlaneWords {
        PlaneWords {
            kind,
            depth,
            normal,
        }
    }

    /// Depth, or value, at a pixel of the zone, saturated.
    pub(super) fn depth_at(&self, x: i64, y: i64, format: &Format) -> i64 {
        saturate(self.depth.wrapped_at(x, y, format.plane) as i64, format)
    }
}

/// All coefficient words of one object for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct QuadricWords {
    /// How the object lies to the viewer.
    pub class: Class,
    /// Where the object can be on the screen; outside it is absent whatever the accumulators hold.
    pub screen_box: ScreenBox,
    /// Linear part of the depth, in units of `2^-g1` depth words.
    pub f1: Linear,
    /// Discriminant part of the depth, in units of `2^-g2` of its last bit; its sign is the silhouette.
    pub f2: Quadratic,
    /// Normal of the quadric.
    pub normal: NormalWords,
    /// Cut planes in the order of the chain.
    pub planes: Vec<PlaneWords>,
}

impl QuadricWords {
    /// f1 at a pixel of the zone, guard bits dropped.
    #[inline]
    pub fn f1_at(&self, x: i64, y: i64, format: &Format) -> i64 {
        format.drop_linear(self.f1.wrapped_at(x, y, format.pe1_width()) as i64)
    }

    /// f2 at a pixel of the zone, guard bits dropped.
    #[inline]
    pub fn f2_at(&self, x: i64, y: i64, format: &Format) -> i64 {
        format.drop_quadratic(self.f2.wrapped_at(x, y, format.pe2_width()) as i64)
    }

    /// The same words as the registers of a format hold them; every accumulator takes the same values.
    pub fn wrapped(&self, format: &Format) -> QuadricWords {
        let mut words = self.clone();
        words.f1 = self.f1.wrapped(format.pe1_width());
        words.f2 = self.f2.wrapped(format.pe2_width());
        words.normal.g = self.normal.g.map(|g| g.wrapped(format.normal_linear));
        for plane in &mut words.planes {
            plane.depth = plane.depth.wrapped(format.plane);
        }
        words
    }
}

impl Words for QuadricWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let depth = [First(&mut self.f1), Second(&mut self.f2)].into_iter();
        let planes = self.planes.iter_mut().map(|plane| &mut plane.depth);
        let linear = self.normal.g.iter_mut().chain(planes);
        let all = depth.chain(linear.map(First));
        (vec![&mut self.screen_box], all.collect())
    }
}

/// Every value inside the processor at one pixel, under the names of the hardware; for traces and for finding a fault.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Probe {
    /// Values of the core.
    pub depths: QuadricDepths,
    /// Value of each plane, not saturated.
    pub plane: Vec<i64>,
    /// What the planes leave of half A and half B.
    pub halves: (Interval, Interval),
    /// After the merge of the halves.
    pub merged: Interval,
    /// Linear parts of the normal.
    pub g: [i64; 3],
    /// What is handed on.
    pub output: ObjectPixel,
}

/// Latency in clocks from the raster flags to the outputs of a quadric processor.
pub fn latency(format: &Format, planes: usize, rows_per_stage: u32) -> u32 {
    format.root_latency(rows_per_stage) + after_root(planes)
}

/// What of the latency is not the root's: the sums, both roots within the depth word, comparisons with the limits of
/// the planes, which are found in a tree, the choice, the normal. Up to four planes are as fast as the roots.
pub fn after_root(planes: usize) -> u32 {
    11 + tree_levels(planes).saturating_sub(2)
}

impl QuadricWords {
    /// The values at pixel (x, y) of the zone, with everything in between.
    pub fn probe_at(&self, x: i64, y: i64, format: &Format) -> Probe {
        let depths = QuadricDepths::at(&self.f1, &self.f2, x, y, format);
        let (f2, root, near, far) = (depths.f2, depths.root, depths.near, depths.far);
        let whole = match self.screen_box.contains(x, y) {
            true => halves(self.class, near, far, f2 < 0, format),
            false => (Interval::absent(format), Interval::absent(format)),
        };
        let value = |plane: &PlaneWords| plane.depth.wrapped_at(x, y, format.plane) as i64;
        let plane: Vec<i64> = self.planes.iter().map(value).collect();
        let (a, b) = self.chain(whole, &plane, format);
        let merged = merge(a, b);
        let g = self.normal.linear_at(x, y, format);
        let normal = || face_normal(merged.nf, g, root, &self.normal, &self.planes, format);
        Probe {
            depths,
            plane,
            halves: (a, b),
            merged,
            g,
            output: ObjectPixel::of(merged, normal, format),
        }
    }

    /// Both halves after all planes.
    fn chain(
        &self,
        whole: (Interval, Interval),
        values: &[i64],
        format: &Format,
    ) -> (Interval, Interval) {
        let patch = self.class == Class::Patch;
        let planes = self.planes.iter().zip(values).zip(FACE_PLANE..);
        planes.fold(whole, |(a, b), ((plane, &value), number)| {
            let zp = saturate(value, format);
            let one = |half| cut(half, plane.kind, zp, number, patch, format);
            (one(a), one(b))
        })
    }
}

impl Object for QuadricWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        if self.screen_box.contains(x, y) {
            self.probe_at(x, y, format).output
        } else {
            // Nothing is there, and no plane changes that.
            ObjectPixel::absent(format)
        }
    }
}

/// The normal of a face that is there: of a plane, of the near end's cap, or of the quadric.
pub(super) fn face_normal(
    face: u8,
    g: [i64; 3],
    behind: i64,
    words: &NormalWords,
    planes: &[PlaneWords],
    format: &Format,
) -> [i16; 3] {
    let plane = face.checked_sub(FACE_PLANE).map(usize::from);
    let plane = plane.and_then(|plane| planes.get(plane));
    let other = || select(face, true, g, behind, words, &[], format);
    plane.map_or_else(other, |plane| plane.normal)
}
