//! The quotient processor: a quadric that the eye lies on, or one that is seen along an asymptotic direction (thesis
//! section 2.1.1: c' = 0; thesis of Coquillart, section 2.5: the ruled cell of a terrain).
//!
//! Along a line of sight the equation of such a quadric is of first degree, `2 B(x, y) z + T(x, y) = 0`, so the depth
//! is one quotient and no root. A pe2 gives the numerator `-T`, a pe1 the denominator `2 B`, and the array of
//! [`crate::unit::quotient`] the depth word. The planes cut it as they cut any other object.
//!
//! A quadric that the eye *nearly* lies on has two depths, of which one is too great for any word wherever it cannot
//! be seen: `C z^2 + 2 B z + T = 0` with a small C. With the root of the discriminant the denominator becomes
//! `2 B +- 2 sqrt(B^2 - C T)`, of the sign of B, so that nothing cancels; `-2 T` over it is the depth that stays, and
//! it over `-2 C` the one that leaves. Both saturate, and from there on the object is one of two roots like any
//! other.
//!
//! Where the denominator is zero the line of sight meets a surface nowhere (or lies in it): a patch is absent there, a
//! solid everywhere or nowhere. Quotients outside the depth word lie nearer than the near end, or behind the eye.

use super::paraboloid::one_face;
use super::quadric::{PlaneWords, after_root, face_normal};
use super::screen_box::ScreenBox;
use super::words::Expression::{First, Second};
use super::words::{Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::cut_plane::cut;
use crate::unit::depth_interval::{
    Class, FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE, Interval, halves,
};
use crate::unit::merge::merge;
use crate::unit::normal::NormalWords;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::quotient::{Quotient, restoring_quotient};
use imogene_contract::words;
use serde::{Deserialize, Serialize};

/// Widths of the processors of a quotient.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuotientWidths {
    /// Of the denominator: that of a plane, or eight bits more if a root is added to it. In hardware, which has no such
    /// root, the numerator is shorter than the widest word.
    pub denominator: u32,
    /// Of the numerator: every depth word times every denominator.
    pub numerator: u32,
    /// Of the discriminant: the square of the denominator.
    pub discriminant: u32,
}

/// Widths of the processors in a format.
pub const fn widths(format: &Format, has_root: bool) -> QuotientWidths {
    let alone = words::denominator(format.plane, format.depth);
    let denominator = if has_root { format.plane + 8 } else { alone };
    QuotientWidths {
        denominator,
        numerator: format.depth + denominator,
        discriminant: 2 * denominator,
    }
}

/// Latency in clocks from the raster flags to the outputs of a processor of one depth: a row for each digit, what a
/// quadric processor has behind its root, and two more for signs and the least word.
pub fn latency(format: &Format, planes: usize, rows_per_stage: u32) -> u32 {
    format.depth.div_ceil(rows_per_stage) + 2 + after_root(planes)
}

/// All coefficient words of one object for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct QuotientWords {
    /// Where the object can be on the screen.
    pub screen_box: ScreenBox,
    /// The volume where `denominator z <= numerator`, not only the surface.
    pub solid: bool,
    /// `-T`, in depth words times the unit of the denominator.
    pub numerator: Quadratic,
    /// `2 B`, in a unit of its own.
    pub denominator: Linear,
    /// What a quadric of two depths has besides.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub root: Option<QuotientRoot>,
    /// Normal at the depth `normal_from`, and its change with the depth behind that, negated for a near face as the
    /// normal unit takes it.
    pub normal: NormalWords,
    /// No point of the object that is seen is nearer.
    pub normal_from: i64,
    /// Cut planes in the order of the chain.
    pub planes: Vec<PlaneWords>,
}

/// What makes two depths of one quotient.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct QuotientRoot {
    /// `4 (B^2 - C T)`, in the square of the denominator's unit.
    pub discriminant: Quadratic,
    /// `2 C`, in denominators to the depth word, with `fraction` binary places; not zero, its sign is that of the
    /// quadric at the eye.
    pub leading: i64,
    /// Binary places of `leading`.
    pub fraction: u32,
}

/// Both depths of a quadric at a pixel, and the denominator that they have in common.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct QuotientDepths {
    /// The depth that stays however small C is, saturated.
    pub inner: i64,
    /// The one that leaves, saturated.
    pub outer: i64,
    /// `2 B +- sqrt(4 (B^2 - C T))`.
    pub denominator: i128,
}

impl QuotientRoot {
    /// The depths where the processors hand on these values; `None` if the line of sight misses the quadric.
    pub fn depths(
        &self,
        numerator: i128,
        denominator: i128,
        discriminant: i128,
        format: &Format,
    ) -> Option<QuotientDepths> {
        let root = u128::try_from(discriminant).ok()?.isqrt() as i128;
        let away = if denominator < 0 { -root } else { root };
        let both = denominator + away;
        let word = |quotient| match quotient {
            Quotient::Below => format.plane_low(),
            Quotient::Word(z) => z.clamp(format.plane_low(), format.z_max()),
            Quotient::Above => format.z_max(),
            // Both depths are where the denominator vanishes.
            Quotient::None => 0,
        };
        let of = |n, d| word(restoring_quotient(n, d, format.depth));
        Some(QuotientDepths {
            inner: of(2 * numerator, both),
            outer: of(-(both << self.fraction), i128::from(self.leading)),
            denominator: both,
        })
    }
}

impl QuotientWords {
    /// Widths of its processors.
    pub fn widths(&self, format: &Format) -> QuotientWidths {
        widths(format, self.root.is_some())
    }

    /// How an object of two depths lies to the viewer.
    fn class(&self, root: &QuotientRoot) -> Class {
        match (self.solid, root.leading > 0) {
            (false, _) => Class::Patch,
            (true, true) => Class::Side,
            (true, false) => Class::Front,
        }
    }

    /// Both depths at a pixel of an object that has two; `None` if the line of sight misses it.
    pub fn depths_at(&self, x: i64, y: i64, format: &Format) -> Option<QuotientDepths> {
        let (root, widths) = (self.root.as_ref()?, self.widths(format));
        root.depths(
            self.numerator.wrapped_at(x, y, widths.numerator),
            self.denominator.wrapped_at(x, y, widths.denominator),
            root.discriminant.wrapped_at(x, y, widths.discriminant),
            format,
        )
    }
}

impl Words for QuotientWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let root = self.root.iter_mut().map(|root| &mut root.discriminant);
        let second = root.chain([&mut self.numerator]).map(Second);
        let planes = self.planes.iter_mut().map(|plane| &mut plane.depth);
        let first = planes.chain(&mut self.normal.g);
        let first = first.chain([&mut self.denominator]);
        let all = first.map(First).chain(second);
        (vec![&mut self.screen_box], all.collect())
    }
}

impl Object for QuotientWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let (mut a, mut b) = self.interval(x, y, format);
        for (plane, number) in self.planes.iter().zip(FACE_PLANE..) {
            let depth = plane.depth_at(x, y, format);
            let one = |half| cut(half, plane.kind, depth, number, !self.solid, format);
            (a, b) = (one(a), one(b));
        }
        let face = merge(a, b);
        let g = self.normal.linear_at(x, y, format);
        let behind = (face.zf - self.normal_from).max(0);
        let words = self.normal_of(face.nf);
        let normal = || face_normal(face.nf, g, behind, &words, &self.planes, format);
        ObjectPixel::of(face, normal, format)
    }
}

impl QuotientWords {
    /// The depth interval of a pixel before the planes, both halves.
    fn interval(&self, x: i64, y: i64, format: &Format) -> (Interval, Interval) {
        let absent = Interval::absent(format);
        if !self.screen_box.contains(x, y) {
            return (absent, absent);
        }
        if let Some(root) = &self.root {
            let class = self.class(root);
            return match self.depths_at(x, y, format) {
                None => halves(class, 0, 0, true, format),
                Some(QuotientDepths { inner, outer, .. }) => {
                    halves(class, inner.min(outer), inner.max(outer), false, format)
                }
            };
        }
        let widths = self.widths(format);
        let numerator = self.numerator.wrapped_at(x, y, widths.numerator);
        let denominator = self.denominator.wrapped_at(x, y, widths.denominator);
        let quotient = restoring_quotient(numerator, denominator, format.depth);
        let face = match self.solid {
            true => solid(quotient, numerator, denominator, format),
            false => match quotient {
                Quotient::Word(z) => one_face(z, FACE_NEAR, true, format),
                _ => absent,
            },
        };
        (face, absent)
    }

    /// The words of the normal as the normal unit takes them for a face: of two depths it is asked for the change
    /// behind `normal_from` of either.
    fn normal_of(&self, face: u8) -> NormalWords {
        let mut words = self.normal;
        if face == FACE_FAR && self.root.is_some() {
            words.k = words.k.map(|k| -k);
        }
        words
    }
}

/// The part of the line of sight where `denominator z <= numerator`.
fn solid(quotient: Quotient, numerator: i128, denominator: i128, format: &Format) -> Interval {
    let (low, end) = (format.z_low(), format.z_max());
    let (near, far) = ((low, FACE_NEAR_END), (end, FACE_NEAR_END));
    let all = Interval::new(near, far);
    let ends_here = denominator > 0;
    match quotient {
        Quotient::None if numerator >= 0 => all,
        Quotient::Word(z) if ends_here && z >= end => all,
        Quotient::Word(z) if !ends_here && z < low => all,
        Quotient::Above if ends_here => all,
        Quotient::Below if !ends_here => all,
        Quotient::Word(z) if ends_here && z >= low => Interval::new(near, (z, FACE_FAR)),
        Quotient::Word(z) if !ends_here && z < end => Interval::new((z, FACE_NEAR), far),
        _ => Interval::absent(format),
    }
}
