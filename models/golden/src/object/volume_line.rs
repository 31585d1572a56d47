//! Volumes over whole lines, for pictures: the same answers as [`super::volume`], in 64-bit arithmetic, visiting only
//! the pixels of the screen box at which something is seen.

use super::volume::VolumeWords;
use crate::format::{Format, wrap64};
use crate::unit::cut_plane::PlaneKind;
use crate::unit::depth_interval::Class;
use crate::unit::membership::{Point, in_half_space, in_quadric};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;

/// A first-degree accumulator at the current pixel; wraps at 64 bits, which keeps every narrower word exact.
#[derive(Clone, Copy, Default)]
struct Accumulator {
    value: i64,
    step: i64,
}

impl Accumulator {
    fn at(expression: &Linear, x: i64, y: i64) -> Accumulator {
        Accumulator {
            value: expression.wrapped_at(x, y, 64) as i64,
            step: expression.a as i64,
        }
    }

    #[inline(always)]
    fn next(&mut self) -> i64 {
        let value = self.value;
        self.value = value.wrapping_add(self.step);
        value
    }

    /// A second-degree accumulator: its step grows at every pixel.
    fn quadratic_at(expression: &Quadratic, x: i64, y: i64) -> Accumulator {
        let value = expression.wrapped_at(x, y, 64);
        Accumulator {
            value: value as i64,
            step: expression.wrapped_at(x + 1, y, 64).wrapping_sub(value) as i64,
        }
    }

    #[inline(always)]
    fn next_of_second_degree(&mut self, second_difference: i64) -> i64 {
        let value = self.next();
        self.step = self.step.wrapping_add(second_difference);
        value
    }
}

/// Calls `sink(x)` for every pixel of line `y` whose visible depth is inside the volume; `depths` are those of the
/// whole line.
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
    let mut quadric = words.quadric.map(|q| QuadricLine {
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

struct QuadricLine {
    class: Class,
    shift: u8,
    f1: Accumulator,
    f2: Accumulator,
    second_difference: i64,
}

impl QuadricLine {
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
        let root = format.root_of(radicand);
        let near = wrap64(linear - root, format.sum);
        let far = wrap64(linear + root, format.sum);
        in_quadric(self.class, near, far, false, point.coarse(self.shift))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::object::quadric::ScreenBox;
    use crate::object::volume::{MAX_SHIFT, VolumeKind, VolumePlane, VolumeQuadric};
    use crate::testing::{SIDE, class, kind, linear, quadratic, root_form, window};
    use imogene_contract::MachineWords;
    use proptest::prelude::*;

    fn plane() -> impl Strategy<Value = VolumePlane> {
        (kind(), linear(1 << 19, 1 << 19)).prop_map(|(kind, depth)| VolumePlane { kind, depth })
    }

    fn quadric() -> impl Strategy<Value = VolumeQuadric> {
        let f1 = linear(1 << 19, 1 << 19);
        let parts = (class(), f1, quadratic(), 0u8..=MAX_SHIFT);
        parts.prop_map(|(class, f1, f2, shift)| VolumeQuadric {
            class,
            f1,
            f2,
            shift,
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
                screen_box: ScreenBox::of([0, last], [0, 0]),
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
            let mut line = vec![false; depths.len()];
            for_each_inside(&words, &format, 0, &depths, |x| line[x] = true);
            for (x, (&got, &z)) in line.iter().zip(&depths).enumerate() {
                let expected = words.holds(x as i64, 0, z, &format);
                assert_eq!(got, expected, "f2 = {f}, depth {z}");
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
            screen_box in window(), guards in 0u32..=8, dropped_rows in 0u32..=8, root_form in root_form(16)
        ) {
            let words = VolumeWords {
                kind: VolumeKind::Shadow,
                source: 0,
                screen_box,
                margin,
                quadric,
                planes,
            };
            let widths = MachineWords {
                guard_linear: guards,
                guard_quadratic: guards,
                dropped_rows,
                root_form,
                ..Format::BASE.widths()
            };
            let format = Format::fitted(&widths).unwrap();
            for y in 0..SIDE {
                let mut line = [false; SIDE as usize];
                for_each_inside(&words, &format, y, &depths, |x| line[x] = true);
                for (x, got) in line.into_iter().enumerate() {
                    prop_assert_eq!(got, words.holds(x as i64, y, depths[x], &format));
                }
            }
        }
    }
}
