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
    let planes = words.planes.iter();
    let planes = planes.map(|p| (p.kind, Accumulator::at(&p.depth, x0, y)));
    let mut planes: Vec<(PlaneKind, Accumulator)> = planes.collect();
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
