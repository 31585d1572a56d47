//! The quadric processor over whole lines, for pictures: the same values as [`super::quadric`], in 64-bit arithmetic,
//! visiting only the pixels of the screen box.

use super::quadric::{MAX_PLANES, ObjectPixel, PlaneWords, QuadricWords};
use crate::format::{Format, wrap64};
use crate::unit::cut_plane::cut;
use crate::unit::depth_interval::{Class, FACE_PLANE, halves};
use crate::unit::merge::merge;
use crate::unit::normal::select;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::plane_depth::saturate;
use crate::unit::root::fast_root;

/// A first-degree accumulator at the current pixel; wraps at 64 bits, which keeps every narrower word exact.
#[derive(Clone, Copy, Default)]
pub(super) struct Accumulator {
    value: i64,
    step: i64,
}

impl Accumulator {
    pub(super) fn at(expression: &Linear, x: i64, y: i64) -> Accumulator {
        Accumulator {
            value: expression.wrapped_at(x, y, 64) as i64,
            step: expression.a as i64,
        }
    }

    #[inline(always)]
    pub(super) fn next(&mut self) -> i64 {
        let value = self.value;
        self.value = value.wrapping_add(self.step);
        value
    }

    /// A second-degree accumulator: its step grows at every pixel.
    pub(super) fn quadratic_at(expression: &Quadratic, x: i64, y: i64) -> Accumulator {
        let value = expression.wrapped_at(x, y, 64);
        Accumulator {
            value: value as i64,
            step: expression.wrapped_at(x + 1, y, 64).wrapping_sub(value) as i64,
        }
    }

    #[inline(always)]
    pub(super) fn next_of_second_degree(&mut self, second_difference: i64) -> i64 {
        let value = self.next();
        self.step = self.step.wrapping_add(second_difference);
        value
    }
}

/// Calls `sink(x, pixel)` for every pixel of line `y` (zone coordinates) at which the object is present, left to right.
pub fn for_each_present(
    words: &QuadricWords,
    format: &Format,
    y: i64,
    sink: impl FnMut(i64, ObjectPixel),
) {
    let window = &words.screen_box;
    if window.is_empty() || y < window.y0 || y > window.y1 {
        return;
    }
    match words.planes.len() {
        0 => run::<0>(words, format, y, sink),
        1 => run::<1>(words, format, y, sink),
        2 => run::<2>(words, format, y, sink),
        3 => run::<3>(words, format, y, sink),
        4 => run::<4>(words, format, y, sink),
        _ => run::<MAX_PLANES>(words, format, y, sink),
    }
}

fn run<const N: usize>(
    words: &QuadricWords,
    format: &Format,
    y: i64,
    mut sink: impl FnMut(i64, ObjectPixel),
) {
    let window = words.screen_box;
    let x0 = window.x0;
    let mut f1 = Accumulator::at(&words.f1, x0, y);
    let mut f2 = Accumulator::quadratic_at(&words.f2, x0, y);
    let second_difference = words.f2.a.wrapping_mul(2) as i64;
    let mut g = words.normal.g.map(|g| Accumulator::at(&g, x0, y));
    let planes: [PlaneWords; N] =
        std::array::from_fn(|i| words.planes.get(i).copied().unwrap_or_default());
    let mut depths = planes.map(|p| Accumulator::at(&p.depth, x0, y));
    let normals = planes.map(|p| p.normal);
    let seen_where_negative = words.class == Class::Front;
    let patch = words.class == Class::Patch;
    for x in x0..=window.x1 {
        let value = f2.next_of_second_degree(second_difference);
        let radicand = format.drop_quadratic(wrap64(value, format.pe2_width()));
        let linear = format.drop_linear(wrap64(f1.next(), format.pe1_width()));
        let zp: [i64; N] =
            std::array::from_fn(|i| saturate(wrap64(depths[i].next(), format.plane), format));
        let normal_linear: [i64; 3] = std::array::from_fn(|k| g[k].next());
        let negative = radicand < 0;
        if negative && !seen_where_negative {
            continue;
        }
        let root = if negative {
            0
        } else {
            format.keep_rows(fast_root(radicand))
        };
        let near = wrap64(linear - root, format.sum);
        let far = wrap64(linear + root, format.sum);
        let (mut a, mut b) = halves(words.class, near, far, negative, format);
        for i in 0..N {
            let number = FACE_PLANE + i as u8;
            a = cut(a, planes[i].kind, zp[i], number, patch, format);
            if seen_where_negative {
                b = cut(b, planes[i].kind, zp[i], number, patch, format);
            }
        }
        let front = merge(a, b);
        if front.is_present(format) {
            let normal = || {
                let g = normal_linear;
                select(front.nf, true, g, root, &words.normal, &normals, format)
            };
            sink(x, ObjectPixel::of(front, normal, format));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::object::words::Object;
    use crate::testing::{SIDE, class, kind, linear, quadratic, window};
    use crate::unit::normal::NormalWords;
    use proptest::prelude::*;

    fn words() -> impl Strategy<Value = QuadricWords> {
        let g = || linear(1 << 22, 1 << 22);
        let normal = ([g(), g(), g()], any::<[i16; 3]>(), 0u8..16)
            .prop_map(|(g, k, shift)| NormalWords { g, k, shift });
        let plane = (kind(), g(), any::<[i16; 3]>()).prop_map(|(kind, depth, normal)| PlaneWords {
            kind,
            depth,
            normal,
        });
        let planes = prop::collection::vec(plane, 0..=6);
        let f1 = linear(1 << 24, 1 << 24);
        let parts = (class(), window(), f1, quadratic(), normal, planes);
        parts.prop_map(|(class, screen_box, f1, f2, normal, planes)| QuadricWords {
            class,
            screen_box,
            f1,
            f2,
            normal,
            planes,
        })
    }

    proptest! {
        #[test]
        fn lines_equal_the_processor_pixel_by_pixel(words in words(), depth in 0usize..5, guards in [0u32..=16, 0u32..=16]) {
            let base = Format::new(Format::CATALOGUE[depth]).unwrap();
            // The 32-bit word leaves no room for guard bits of f2, and the 28-bit word for 8.
            let quadratic = guards[1].min(64 - base.quadratic);
            let linear = guards[0].min(base.quadratic + quadratic - base.sum);
            let format = base.with_guards(linear, quadratic).unwrap();
            for y in 0..SIDE {
                let mut line = [None; SIDE as usize];
                for_each_present(&words, &format, y, |x, pixel| line[x as usize] = Some(pixel));
                for (x, got) in line.into_iter().enumerate() {
                    let expected = words.at(x as i64, y, &format);
                    prop_assert_eq!(expected, words.probe_at(x as i64, y, &format).output);
                    prop_assert_eq!(got, (expected.zf != format.z_max()).then_some(expected));
                }
            }
        }
    }
}
