//! The patch processor: a surface, cut by planes that decide in parallel (source: 2.4.3, 5.2.1).
//!
//! It hands on what the quadric processor hands on for an object of class patch, from less hardware and `N` clocks earlier: no second half,
//! no merge, no plane normals, and one selection of a depth in the place of a chain.

use super::quadric::{ObjectPixel, QuadricWords};
use crate::format::Format;
use crate::unit::interval::Interval;
use crate::unit::normal::select;
use crate::unit::patch_decider::{Faces, decide, kept, visible};
use crate::unit::pe1::Pe1;
use crate::unit::plane_depth::saturate;
use crate::unit::quadric_pe::{QuadricDepths, QuadricPe};

/// Latency in clocks from the raster flags to the outputs; the same for any number of planes.
pub fn latency(format: &Format, rows_per_stage: u32) -> u32 {
    format.root_rows().div_ceil(rows_per_stage) + 7
}

/// Every value inside the processor at one pixel.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PatchProbe {
    /// Value of the f1 processor, guard bits dropped.
    pub f1: i64,
    /// Value of the f2 processor, guard bits dropped.
    pub f2: i64,
    /// Root of f2; of no meaning where f2 is negative.
    pub root: i64,
    /// f1 - root.
    pub near: i64,
    /// f1 + root.
    pub far: i64,
    /// Faces between the ends of the depth word.
    pub visible: Faces,
    /// Saturated value of each plane.
    pub plane: Vec<i64>,
    /// Signals of each plane.
    pub kept: Vec<Faces>,
    /// The decision.
    pub decided: Interval,
    /// Linear parts of the normal.
    pub g: [i64; 3],
    /// What is handed on.
    pub output: ObjectPixel,
}

/// The processor running over a zone, pixel by pixel.
///
/// Its words are those of a quadric; the class and the normals of the planes are not read.
#[derive(Clone, Debug)]
pub struct PatchProcessor {
    format: Format,
    words: QuadricWords,
    core: QuadricPe,
    planes: Vec<Pe1>,
    g: [Pe1; 3],
    x: i64,
    y: i64,
}

impl PatchProcessor {
    /// Zone start: all elementary processors load their words; the next pixel is (0, 0) of the zone.
    pub fn zone_start(words: &QuadricWords, format: &Format) -> PatchProcessor {
        let plane = |p: &super::quadric::PlaneWords| Pe1::object_start(&p.depth, format.plane);
        PatchProcessor {
            format: *format,
            words: words.clone(),
            core: QuadricPe::object_start(&words.f1, &words.f2, format),
            planes: words.planes.iter().map(plane).collect(),
            g: words
                .normal
                .g
                .map(|g| Pe1::object_start(&g, format.normal_linear)),
            x: 0,
            y: 0,
        }
    }

    /// Line step: the next pixel is the first of the next line.
    pub fn line_step(&mut self) {
        self.core.line_step();
        self.planes.iter_mut().for_each(Pe1::line_step);
        self.g.iter_mut().for_each(Pe1::line_step);
        self.x = 0;
        self.y += 1;
    }

    /// The values of the next pixel of the line, with everything in between.
    pub fn probe(&mut self) -> PatchProbe {
        let format = self.format;
        let QuadricDepths {
            f1,
            f2,
            root,
            near,
            far,
        } = self.core.pixel(&format);
        let there = f2 >= 0 && self.words.screen_box.contains(self.x, self.y);
        let visible = visible(near, far, there, &format);
        let depth = |pe: &mut Pe1| saturate(pe.pixel() as i64, &format);
        let plane: Vec<i64> = self.planes.iter_mut().map(depth).collect();
        let signals = |(p, &zp): (&super::quadric::PlaneWords, &i64)| kept(p.kind, zp, near, far);
        let kept: Vec<Faces> = self.words.planes.iter().zip(&plane).map(signals).collect();
        let left = kept.iter().copied().fold(visible, Faces::and);
        let decided = decide(near, far, left, &format);
        let g = std::array::from_fn(|k| self.g[k].pixel() as i64);
        let present = decided.is_present(&format);
        self.x += 1;
        PatchProbe {
            f1,
            f2,
            root,
            near,
            far,
            visible,
            plane,
            kept,
            decided,
            g,
            output: ObjectPixel {
                zf: decided.zf,
                zb: decided.zb,
                number: decided.nf,
                normal: select(
                    decided.nf,
                    present,
                    g,
                    root,
                    &self.words.normal,
                    &[],
                    &self.format,
                ),
            },
        }
    }

    /// What the processor hands on for the next pixel of the line.
    pub fn pixel(&mut self) -> ObjectPixel {
        self.probe().output
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::object::quadric::{PlaneWords, QuadricProcessor, ScreenBox};
    use crate::unit::cut_plane::PlaneKind;
    use crate::unit::interval::Class;
    use crate::unit::normal::NormalWords;
    use crate::unit::pe1::Linear;
    use crate::unit::pe2::Quadratic;
    use proptest::prelude::*;

    const SIDE: i64 = 24;

    fn linear(most: i128) -> impl Strategy<Value = Linear> {
        let one = move || -most..=most;
        (one(), one(), -20 * most..=20 * most).prop_map(|(a, b, c)| Linear::new(a, b, c))
    }

    fn plane() -> impl Strategy<Value = PlaneWords> {
        let kind = prop_oneof![
            Just(PlaneKind::None),
            Just(PlaneKind::Front),
            Just(PlaneKind::Back),
            Just(PlaneKind::Perpendicular),
        ];
        (kind, linear(40)).prop_map(|(kind, depth)| PlaneWords {
            kind,
            depth,
            normal: [1, 2, 3],
        })
    }

    fn words() -> impl Strategy<Value = QuadricWords> {
        // Radii and depths of the size of the zone, so that planes, roots and ends meet at many pixels.
        let f2 = (-900i128..=60, -900i128..=60, 0i128..200_000);
        let parts = (
            linear(40),
            f2,
            [linear(9000), linear(9000), linear(9000)],
            any::<[i16; 3]>(),
            0u8..4,
            prop::collection::vec(plane(), 0..=5),
        );
        parts.prop_map(|(f1, (a, b, f), g, k, shift, planes)| QuadricWords {
            class: Class::Patch,
            screen_box: ScreenBox {
                x0: 1,
                x1: SIDE - 2,
                y0: 0,
                y1: SIDE - 3,
            },
            f1,
            f2: Quadratic {
                a,
                b,
                c: 3,
                d: -SIDE as i128 * a,
                e: -SIDE as i128 * b,
                f: f + (a + b) * 144,
            },
            normal: NormalWords { g, k, shift },
            planes,
        })
    }

    /// The words of a patch, moved in depth to an end of the word.
    fn moved(mut words: QuadricWords, by: i128) -> QuadricWords {
        words.f1.c += by;
        for plane in &mut words.planes {
            if plane.kind != PlaneKind::Perpendicular {
                plane.depth.c += by;
            }
        }
        words
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(400))]
        #[test]
        fn hands_on_what_the_quadric_processor_does(
            words in words(), depth in prop_oneof![Just(16u32), Just(24)], end in -1i128..=1
        ) {
            let format = Format::new(depth).unwrap();
            let words = moved(words, end * format.z_max() as i128);
            let mut patch = PatchProcessor::zone_start(&words, &format);
            let mut chain = QuadricProcessor::zone_start(&words, &format);
            for y in 0..SIDE {
                if y > 0 {
                    patch.line_step();
                    chain.line_step();
                }
                for x in 0..SIDE {
                    prop_assert_eq!(patch.pixel(), chain.pixel(), "pixel ({}, {})", x, y);
                }
            }
        }
    }

    #[test]
    fn planes_do_not_lengthen_the_pipeline() {
        let format = Format::BASE;
        assert_eq!(latency(&format, 1), 31);
        assert_eq!(
            latency(&format, 2),
            super::super::quadric::latency(&format, 0, 2)
        );
    }

    /// The cut cylinder of the restatement of the source (6.7), its column for patches; format 24.
    #[test]
    fn cut_cylinder_of_the_specification() {
        let plane = |kind, depth| PlaneWords {
            kind,
            depth,
            normal: [0; 3],
        };
        let words = QuadricWords {
            class: Class::Patch,
            screen_box: ScreenBox {
                x0: 0,
                x1: 719,
                y0: 0,
                y1: 539,
            },
            f1: Linear::new(0, 0, 1_897_423),
            f2: Quadratic {
                a: -41_886_147,
                d: 30_158_026_029,
                f: -5_179_122_380_046,
                ..Default::default()
            },
            normal: NormalWords::default(),
            planes: vec![
                plane(PlaneKind::Front, Linear::new(0, 0, 1_677_721)),
                plane(PlaneKind::Back, Linear::new(0, -104_858, 36_700_156)),
                plane(PlaneKind::Back, Linear::new(0, 104_858, -19_922_942)),
            ],
        };
        let zmax = Format::BASE.z_max();
        let expected = [
            ((360, 270), 2_396_744, 1),
            ((400, 270), 2_324_394, 1),
            ((360, 330), zmax, 0),
            ((360, 337), zmax, 0),
            ((430, 270), 1_687_471, 0),
            ((435, 270), 1_780_322, 0),
            ((440, 270), zmax, 0),
        ];
        for ((x, y), zf, number) in expected {
            let zone = words.for_zone(x, y, 1, 1);
            let pixel = PatchProcessor::zone_start(&zone, &Format::BASE).pixel();
            assert_eq!((pixel.zf, pixel.number), (zf, number), "pixel ({x}, {y})");
        }
    }
}
