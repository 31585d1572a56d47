//! Volumes over whole lines, for pictures: the same answers as [`super::volume`], in 64-bit arithmetic, visiting only the pixels of the screen box
//! at which something is seen.

use super::line::Accumulator;
use super::volume::VolumeWords;
use crate::format::{Format, wrap64};
use crate::unit::cut_plane::PlaneKind;
use crate::unit::interval::Class;
use crate::unit::membership::{Point, in_half_space, in_quadric};
use crate::unit::root::fast_root;

/// Calls `sink(x)` for every pixel of line `y` whose visible depth is inside the volume; `depths` are those of the whole line.
pub fn for_each_inside(
    words: &VolumeWords,
    format: &Format,
    y: i64,
    depths: &[i64],
    mut sink: impl FnMut(usize),
) {
    let window = &words.screen_box;
    if window.is_empty() || y < window.y0 || y > window.y1 {
        return;
    }
    let x0 = window.x0;
    let mut quadric = words.quadric.map(|q| Quadric {
        class: q.class,
        shift: q.shift,
        f1: Accumulator::at(&q.f1, x0, y),
        f2: Accumulator::quadratic_at(&q.f2, x0, y),
        second_difference: q.f2.a.wrapping_mul(2) as i64,
    });
    let mut planes: Vec<(PlaneKind, Accumulator)> = words
        .planes
        .iter()
        .map(|p| (p.kind, Accumulator::at(&p.depth, x0, y)))
        .collect();
    for x in x0..=window.x1 {
        let point = Point::new(depths[x as usize], words.margin);
        let in_planes = planes.iter_mut().fold(true, |all, (kind, plane)| {
            let zp = wrap64(plane.next(), format.plane);
            all & in_half_space(*kind, zp, point)
        });
        let seen = point.is_surface(format) && in_planes;
        let inside = match &mut quadric {
            Some(quadric) => quadric.holds(point, seen, format),
            None => seen,
        };
        if inside {
            sink(x as usize);
        }
    }
}

struct Quadric {
    class: Class,
    shift: u8,
    f1: Accumulator,
    f2: Accumulator,
    second_difference: i64,
}

impl Quadric {
    /// Steps to the next pixel; the root is taken only if the answer depends on it.
    #[inline(always)]
    fn holds(&mut self, point: Point, asked: bool, format: &Format) -> bool {
        let f1 = self.f1.next();
        let f2 = self.f2.next_of_second_degree(self.second_difference);
        if !asked {
            return false;
        }
        let radicand = format.drop_quadratic(wrap64(f2, format.pe2_width()));
        let negative = radicand < 0;
        if negative || self.class == Class::Prism {
            return in_quadric(self.class, 0, 0, negative, point);
        }
        let linear = format.drop_linear(wrap64(f1, format.pe1_width()));
        let root = format.keep_rows(fast_root(radicand));
        let near = wrap64(linear - root, format.sum);
        let far = wrap64(linear + root, format.sum);
        in_quadric(self.class, near, far, false, point.coarse(self.shift))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::object::quadric::ScreenBox;
    use crate::object::volume::{
        MAX_SHIFT, VolumeKind, VolumePlane, VolumeProcessor, VolumeQuadric,
    };
    use crate::unit::pe1::Linear;
    use crate::unit::pe2::Quadratic;
    use imogene_contract::MachineWords;
    use proptest::prelude::*;

    fn linear(range: i64) -> impl Strategy<Value = Linear> {
        let one = -range..=range;
        (one.clone(), one.clone(), one)
            .prop_map(|(a, b, c)| Linear::new(a as i128, b as i128, c as i128))
    }

    fn plane() -> impl Strategy<Value = VolumePlane> {
        (0usize..4, linear(1 << 19)).prop_map(|(kind, depth)| {
            use PlaneKind::*;
            let kind = [None, Front, Back, Perpendicular][kind];
            VolumePlane { kind, depth }
        })
    }

    fn quadric() -> impl Strategy<Value = VolumeQuadric> {
        let f2 = (any::<[i32; 3]>(), any::<[i64; 3]>()).prop_map(|(q, l)| Quadratic {
            a: q[0] as i128,
            b: q[1] as i128,
            c: q[2] as i128,
            d: (l[0] >> 22) as i128,
            e: (l[1] >> 22) as i128,
            f: (l[2] >> 17) as i128,
        });
        (0usize..4, linear(1 << 19), f2, 0u8..=MAX_SHIFT).prop_map(|(class, f1, f2, shift)| {
            VolumeQuadric {
                class: [Class::Side, Class::Front, Class::Patch, Class::Prism][class],
                f1,
                f2,
                shift,
            }
        })
    }

    /// Roots without their last digits, at every depth around them.
    #[test]
    fn lines_drop_the_digits_that_the_processor_drops() {
        let widths = MachineWords {
            dropped_rows: 2,
            ..Format::BASE.widths()
        };
        let format = Format::fitted(&widths).unwrap();
        let depths: Vec<i64> = (-12..=12).collect();
        let last = depths.len() as i64 - 1;
        let mut inside = 0;
        for f in 0..100 {
            let words = VolumeWords {
                kind: VolumeKind::Shadow,
                source: 0,
                screen_box: ScreenBox {
                    x0: 0,
                    x1: last,
                    y0: 0,
                    y1: 0,
                },
                margin: 0,
                quadric: Some(VolumeQuadric {
                    class: Class::Side,
                    f2: Quadratic {
                        f,
                        ..Quadratic::default()
                    },
                    ..VolumeQuadric::EVERYWHERE
                }),
                planes: vec![],
            };
            let mut processor = VolumeProcessor::zone_start(&words, &format);
            let mut line = vec![false; depths.len()];
            for_each_inside(&words, &format, 0, &depths, |x| line[x] = true);
            for (&got, &z) in line.iter().zip(&depths) {
                assert_eq!(got, processor.pixel(z), "f2 = {f}, depth {z}");
                inside += usize::from(got);
            }
        }
        // Roots 0 to 9 become 0, 4 and 8.
        assert_eq!(inside, 16 + 48 * 9 + 36 * 17);
    }

    proptest! {
        #[test]
        fn lines_equal_the_processor_pixel_by_pixel(
            quadric in proptest::option::of(quadric()), planes in proptest::collection::vec(plane(), 0..=5),
            depths in proptest::collection::vec(-(1i64 << 23) + 1..1 << 23, 20), margin in 0u32..1000,
            b in [0i64..20, 0..20, 0..20, 0..20], guards in 0u32..=8, dropped_rows in 0u32..=8
        ) {
            let words = VolumeWords {
                kind: VolumeKind::Shadow,
                source: 0,
                screen_box: ScreenBox {
                    x0: b[0].min(b[1]), x1: b[0].max(b[1]), y0: b[2].min(b[3]), y1: b[2].max(b[3]),
                },
                margin,
                quadric,
                planes,
            };
            let widths = MachineWords {
                guard_linear: guards,
                guard_quadratic: guards,
                dropped_rows,
                ..Format::BASE.widths()
            };
            let format = Format::fitted(&widths).unwrap();
            let mut processor = VolumeProcessor::zone_start(&words, &format);
            for y in 0..20 {
                if y > 0 {
                    processor.line_step();
                }
                let mut line = [false; 20];
                for_each_inside(&words, &format, y, &depths, |x| line[x] = true);
                for (got, &z) in line.into_iter().zip(&depths) {
                    prop_assert_eq!(got, processor.pixel(z));
                }
            }
        }
    }
}
