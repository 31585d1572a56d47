//! The quotient processor: a quadric that the eye lies on, or one that is seen along an asymptotic direction (thesis section 2.1.1: c' = 0; thesis of Coquillart,
//! section 2.5: the ruled cell of a terrain).
//!
//! Along a line of sight the equation of such a quadric is of first degree, `2 B(x, y) z + T(x, y) = 0`, so the depth is one quotient and no root. A pe2 gives
//! the numerator `-T`, a pe1 the denominator `2 B`, and the array of [`crate::unit::quotient`] the depth word. The planes cut it as they cut any other object.
//!
//! Where the denominator is zero the line of sight meets a surface nowhere (or lies in it): a patch is absent there, a solid everywhere or nowhere. Quotients outside
//! the depth word lie nearer than the near end, or behind the eye.

use super::quadric::{ObjectPixel, PlaneWords, ScreenBox};
use crate::format::Format;
use crate::unit::cut_plane::cut;
use crate::unit::interval::{FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE, Interval};
use crate::unit::normal::{NormalWords, select};
use crate::unit::pe1::{Linear, Pe1};
use crate::unit::pe2::{Pe2, Quadratic};
use crate::unit::plane_depth::saturate;
use crate::unit::quotient::{Quotient, restoring_quotient};
use serde::{Deserialize, Serialize};

/// Width of the numerator's processor: every depth word times every denominator.
pub const fn numerator_width(format: &Format) -> u32 {
    format.depth + denominator_width(format)
}

/// Width of the denominator's processor: that of a plane.
pub const fn denominator_width(format: &Format) -> u32 {
    format.plane
}

/// All coefficient words of one object for one zone.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct QuotientWords {
    /// Where the object can be on the screen.
    pub screen_box: ScreenBox,
    /// The volume where `denominator z <= numerator`, not only the surface.
    pub solid: bool,
    /// Number of the surface's face: that of the near root, or that of the far one if the other root has gone to the near side.
    pub face: u8,
    /// `-T`, in depth words times the unit of the denominator.
    pub numerator: Quadratic,
    /// `2 B`, in a unit of its own.
    pub denominator: Linear,
    /// Normal at the depth `normal_from`, and its change with the depth behind that, negated for a near face as the normal unit takes it.
    pub normal: NormalWords,
    /// No point of the object that is seen is nearer.
    pub normal_from: i64,
    /// Cut planes in the order of the chain.
    pub planes: Vec<PlaneWords>,
}

impl QuotientWords {
    /// The words of the same object for a zone of `width` x `height` pixels whose first pixel is (x0, y0) of the present one: moved, not rounded again.
    pub fn for_zone(&self, x0: i64, y0: i64, width: i64, height: i64) -> QuotientWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.in_zone(x0, y0, width, height);
        words.numerator = self.numerator.from_zone(x0, y0);
        words.denominator = self.denominator.from_zone(x0, y0);
        words.normal.g = self.normal.g.map(|g| g.from_zone(x0, y0));
        for plane in &mut words.planes {
            plane.depth = plane.depth.from_zone(x0, y0);
        }
        words
    }
}

impl QuotientWords {
    /// The words of the same object on the lines `first, first + step, first + 2 step, ..` alone, which are counted 0, 1, 2, ..
    pub fn every_line(&self, step: i64, first: i64) -> QuotientWords {
        let mut words = self.clone();
        words.screen_box = self.screen_box.every_line(step, first);
        words.numerator = self.numerator.every_line(step, first);
        words.denominator = self.denominator.every_line(step, first);
        words.normal.g = self.normal.g.map(|g| g.every_line(step, first));
        for plane in &mut words.planes {
            plane.depth = plane.depth.every_line(step, first);
        }
        words
    }
}

/// The processor running over a zone, pixel by pixel.
#[derive(Clone, Debug)]
pub struct QuotientProcessor {
    format: Format,
    words: QuotientWords,
    normals: Vec<[i16; 3]>,
    numerator: Pe2,
    denominator: Pe1,
    planes: Vec<Pe1>,
    g: [Pe1; 3],
    x: i64,
    y: i64,
}

impl QuotientProcessor {
    /// Zone start: all elementary processors load their words; the next pixel is (0, 0) of the zone.
    pub fn zone_start(words: &QuotientWords, format: &Format) -> QuotientProcessor {
        let plane = |p: &PlaneWords| Pe1::object_start(&p.depth, format.plane);
        let g = |g: &Linear| Pe1::object_start(g, format.normal_linear);
        QuotientProcessor {
            format: *format,
            normals: words.planes.iter().map(|p| p.normal).collect(),
            numerator: Pe2::object_start(&words.numerator, numerator_width(format)),
            denominator: Pe1::object_start(&words.denominator, denominator_width(format)),
            planes: words.planes.iter().map(plane).collect(),
            g: words.normal.g.each_ref().map(g),
            words: words.clone(),
            x: 0,
            y: 0,
        }
    }

    /// Line step: the next pixel is the first of the next line.
    pub fn line_step(&mut self) {
        self.numerator.line_step();
        self.denominator.line_step();
        self.planes.iter_mut().for_each(Pe1::line_step);
        self.g.iter_mut().for_each(Pe1::line_step);
        self.x = 0;
        self.y += 1;
    }

    /// What the processor hands on for the next pixel of the line.
    pub fn pixel(&mut self) -> ObjectPixel {
        let format = self.format;
        let (numerator, denominator) = (self.numerator.pixel(), self.denominator.pixel());
        let quotient = restoring_quotient(numerator, denominator, format.depth);
        let mut face = match self.words.screen_box.contains(self.x, self.y) {
            true if self.words.solid => solid(quotient, numerator, denominator, &format),
            true => surface(quotient, self.words.face, &format),
            false => Interval::absent(&format),
        };
        self.x += 1;
        for (i, plane) in self.words.planes.iter().enumerate() {
            let depth = saturate(self.planes[i].pixel() as i64, &format);
            let number = FACE_PLANE + i as u8;
            face = cut(face, plane.kind, depth, number, !self.words.solid, &format);
        }
        let g = std::array::from_fn(|k| self.g[k].pixel() as i64);
        let behind = (face.zf - self.words.normal_from).max(0);
        let present = face.is_present(&format);
        ObjectPixel {
            zf: face.zf,
            zb: face.zb,
            number: face.nf,
            normal: select(
                face.nf,
                present,
                g,
                behind,
                &self.words.normal,
                &self.normals,
                &format,
            ),
        }
    }
}

/// The one face of a surface.
fn surface(quotient: Quotient, face: u8, format: &Format) -> Interval {
    match quotient {
        Quotient::Word(z) if z >= format.z_low() && z < format.z_max() => Interval {
            zf: z,
            zb: z,
            nf: face,
            nb: face,
        },
        _ => Interval::absent(format),
    }
}

/// The part of the line of sight where `denominator z <= numerator`.
fn solid(quotient: Quotient, numerator: i128, denominator: i128, format: &Format) -> Interval {
    let (low, end) = (format.z_low(), format.z_max());
    let all = Interval {
        zf: low,
        zb: end,
        nf: FACE_NEAR_END,
        nb: FACE_NEAR_END,
    };
    let ends_here = denominator > 0;
    match quotient {
        Quotient::None if numerator >= 0 => all,
        Quotient::Word(z) if ends_here && z >= end => all,
        Quotient::Word(z) if !ends_here && z < low => all,
        Quotient::Above if ends_here => all,
        Quotient::Below if !ends_here => all,
        Quotient::Word(z) if ends_here && z >= low => Interval {
            zb: z,
            nb: FACE_FAR,
            ..all
        },
        Quotient::Word(z) if !ends_here && z < end => Interval {
            zf: z,
            nf: FACE_NEAR,
            ..all
        },
        _ => Interval::absent(format),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit::cut_plane::PlaneKind;
    use num_bigint::BigInt;
    use proptest::prelude::*;

    const SIDE: i64 = 16;

    fn words() -> impl Strategy<Value = QuotientWords> {
        let factor = -12i128..12;
        let second = [
            factor.clone(),
            factor.clone(),
            factor.clone(),
            factor.clone(),
            factor,
            -900i128..900,
        ];
        let first = [-3i128..=3, -3..=3, -20..=20];
        let plane = (0..3u8, -9i128..9, -9i128..9, -120i128..120);
        (
            second,
            first,
            any::<bool>(),
            prop::collection::vec(plane, 0..3),
        )
            .prop_map(
                |([a, b, c, d, e, f], [p, q, r], solid, planes)| QuotientWords {
                    screen_box: ScreenBox {
                        x0: 1,
                        x1: SIDE - 2,
                        y0: 0,
                        y1: SIDE - 1,
                    },
                    solid,
                    face: FACE_NEAR,
                    numerator: Quadratic { a, b, c, d, e, f },
                    denominator: Linear::new(p, q, r),
                    normal: NormalWords::default(),
                    normal_from: 0,
                    planes: planes
                        .into_iter()
                        .map(|(kind, a, b, c)| PlaneWords {
                            kind: [PlaneKind::Front, PlaneKind::Back, PlaneKind::Perpendicular]
                                [usize::from(kind)],
                            depth: Linear::new(a, b, c),
                            normal: [0; 3],
                        })
                        .collect(),
                },
            )
    }

    /// Does the definition hold at a depth word: the volume somewhere in the depths that it is the floor of, or the surface there, and every plane.
    fn holds(words: &QuotientWords, x: i64, y: i64, z: i64) -> bool {
        let (n, d) = (
            words.numerator.exact_at(x, y),
            words.denominator.exact_at(x, y),
        );
        let at = |z: i64| &d * BigInt::from(z);
        let zero = BigInt::ZERO;
        let there = match (words.solid, d > zero) {
            (true, _) if d < zero => at(z + 1) < n,
            (true, _) => at(z) <= n,
            (false, _) if d == zero => false,
            // floor(n / d) = z
            (false, true) => at(z) <= n && n < at(z + 1),
            (false, false) => at(z) >= n && n > at(z + 1),
        };
        there
            && words.planes.iter().all(|plane| {
                let depth = plane.depth.exact_at(x, y);
                match plane.kind {
                    PlaneKind::Front => BigInt::from(z) >= depth,
                    PlaneKind::Back => BigInt::from(z) <= depth,
                    _ => depth >= BigInt::ZERO,
                }
            })
    }

    proptest! {
        #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

        /// Against the definition at every depth of a short word: the first depth at which it holds is the front.
        #[test]
        fn shows_the_first_depth_of_its_definition(words in words()) {
            let format = Format { depth: 8, ..Format::BASE };
            let mut processor = QuotientProcessor::zone_start(&words, &format);
            for y in 0..SIDE {
                if y > 0 {
                    processor.line_step();
                }
                for x in 0..SIDE {
                    let pixel = processor.pixel();
                    let inside = words.screen_box.contains(x, y);
                    let mut depths = format.z_low()..format.z_max();
                    let first = depths.find(|&z| inside && holds(&words, x, y, z));
                    prop_assert_eq!(pixel.zf, first.unwrap_or(format.z_max()), "pixel ({}, {})", x, y);
                }
            }
        }

        #[test]
        fn zones_are_coefficient_changes(words in words(), x0 in 0i64..8, y0 in 0i64..8) {
            let format = Format::BASE;
            let mut whole = QuotientProcessor::zone_start(&words, &format);
            let pixels: Vec<Vec<ObjectPixel>> = (0..SIDE).map(|y| {
                if y > 0 {
                    whole.line_step();
                }
                (0..SIDE).map(|_| whole.pixel()).collect()
            }).collect();
            let zone = words.for_zone(x0, y0, SIDE - x0, SIDE - y0);
            let mut part = QuotientProcessor::zone_start(&zone, &format);
            for y in y0..SIDE {
                if y > y0 {
                    part.line_step();
                }
                for x in x0..SIDE {
                    prop_assert_eq!(part.pixel(), pixels[y as usize][x as usize]);
                }
            }
        }
    }
}
