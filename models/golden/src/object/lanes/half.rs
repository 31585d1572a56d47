//! Depth intervals of all lanes: opened, cut and merged.

use super::ramp::{LANES, Pixels};
use crate::format::Format;
use crate::unit::cut_plane::PlaneKind;
use crate::unit::depth_interval::{Class, FACE_FAR, FACE_NEAR_END, Interval, halves};

const FAR: i32 = FACE_FAR as i32;
/// The number of the cap has four bits, all ones. As -1 it is below all others, which may then take its place.
const CAP: i32 = -1;

pub(super) struct Ends {
    low: i32,
    max: i32,
}

impl Ends {
    #[inline(always)]
    pub(super) fn of(format: &Format) -> Ends {
        Ends {
            low: format.z_low() as i32,
            max: format.z_max() as i32,
        }
    }

    /// As [`crate::unit::plane_depth::saturate`].
    #[inline(always)]
    pub(super) fn saturate(&self, depth: i32) -> i32 {
        depth.max(self.low - 1).min(self.max)
    }
}

/// What an interval is opened with. Both depths are saturated, which changes no interval; of `f2` the sign is right.
#[repr(align(64))]
pub(super) struct Depths {
    pub(super) f2: [i32; LANES],
    pub(super) near: [i32; LANES],
    pub(super) far: [i32; LANES],
}

/// An interval in each lane, or an absent object: its front is at the far end, and all else is of no meaning.
///
/// All words are of 32 bits, so that no loop packs them. The greater or the lesser of the old and a new word is kept:
/// a choice by anything else would become a store under a mask, which takes many clocks with AVX2 on some processors.
#[repr(align(64))]
pub(super) struct Half {
    pub(super) zf: [i32; LANES],
    pub(super) zb: [i32; LANES],
    nf: [i32; LANES],
    /// Kept for patches alone: nothing is told of the back face of a solid.
    nb: [i32; LANES],
}

impl Half {
    pub(super) const NONE: Half = Half {
        zf: [0; LANES],
        zb: [0; LANES],
        nf: [0; LANES],
        nb: [0; LANES],
    };

    /// Number of the front face.
    #[inline(always)]
    pub(super) fn number(&self, lane: usize) -> u8 {
        self.nf[lane] as u8 & FACE_NEAR_END
    }

    /// Half A, or half B of an object that is seen from inside.
    #[inline(always)]
    pub(super) fn open(
        &mut self,
        class: Class,
        is_b: bool,
        depths: &Depths,
        format: &Format,
        pixels: &Pixels,
    ) {
        for lane in pixels.lanes() {
            let (near, far) = (depths.near[lane].into(), depths.far[lane].into());
            let (a, b) = halves(class, near, far, depths.f2[lane] < 0, format);
            let Interval { zf, zb, nf, nb } = if is_b { b } else { a };
            (self.zf[lane], self.zb[lane]) = (zf as i32, zb as i32);
            self.nf[lane] = if nf == FACE_NEAR_END { CAP } else { nf.into() };
            if class == Class::Patch {
                self.nb[lane] = nb.into();
            }
        }
    }

    /// As [`crate::unit::cut_plane::cut`], for planes whose numbers grow, and patches whose front faces have the lesser
    /// number if there are two.
    #[inline(always)]
    pub(super) fn cut(
        &mut self,
        kind: PlaneKind,
        (plane, number): (&[i32; LANES], u8),
        patch: bool,
        ends: &Ends,
        pixels: &Pixels,
    ) {
        let &Ends { low, max } = ends;
        match kind {
            PlaneKind::None => (),
            PlaneKind::Front => {
                for lane in pixels.lanes() {
                    let (zp, zf, zb) = (plane[lane], self.zf[lane], self.zb[lane]);
                    let (z, n) = if patch {
                        (zb, self.nb[lane])
                    } else {
                        (zp, number.into())
                    };
                    let z = if zp > zb { max } else { z };
                    self.zf[lane] = zf.max(if zp > zf { z } else { low });
                    self.nf[lane] = self.nf[lane].max(if zp > zf { n } else { CAP });
                }
            }
            PlaneKind::Back => {
                for lane in pixels.lanes() {
                    let (zp, zf, zb) = (plane[lane], self.zf[lane], self.zb[lane]);
                    let z = if patch { zf } else { zp };
                    self.zf[lane] = zf.max(if zp < zf.min(zb) { max } else { low });
                    self.zb[lane] = zb.min(if zp < zb { z } else { max });
                    if patch {
                        let n = if zp < zb { self.nf[lane] } else { FAR };
                        self.nb[lane] = self.nb[lane].min(n);
                    }
                }
            }
            PlaneKind::Perpendicular => {
                for lane in pixels.lanes() {
                    let limit = if plane[lane] < 0 { max } else { low };
                    self.zf[lane] = self.zf[lane].max(limit);
                }
            }
        }
    }

    /// As [`crate::unit::merge::merge`].
    #[inline(always)]
    pub(super) fn merge(&mut self, a: &Half, b: &Half, pixels: &Pixels) {
        for lane in pixels.lanes() {
            let is_a = a.zf[lane] <= b.zf[lane];
            self.zf[lane] = if is_a { a.zf[lane] } else { b.zf[lane] };
            self.zb[lane] = if is_a { a.zb[lane] } else { b.zb[lane] };
            self.nf[lane] = if is_a { a.nf[lane] } else { b.nf[lane] };
        }
    }
}
