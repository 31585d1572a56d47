//! The units of the quadric processor over pixels of a line side by side: the same values as [`super::quadric`].
//!
//! A lane is a pixel. Every unit is one loop over the lanes without a branch, which the compiler turns into vector
//! instructions: 64-bit words for the elementary processors and the root, 32-bit words for what fits the depth word.

use super::quadric::{ObjectPixel, PlaneWords, QuadricWords};
use crate::format::{Format, wrap64};
use crate::unit::cut_plane::{PlaneKind, cut};
use crate::unit::depth_interval::{Class, FACE_NEAR, FACE_NEAR_END, FACE_PLANE, Interval, halves};
use crate::unit::merge::merge;
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::plane_depth::saturate;
use crate::unit::root::fast_root;
use std::ops::Range;

/// Most pixels side by side. Shorter loops would be unrolled, and then not become vector instructions.
const LANES: usize = 64;

/// Lanes in use are a multiple of this, so that no loop has a rest; those beyond the screen box are not handed on.
const STEP: usize = 16;

/// The pixels that the lanes hold: the first one, and how many lanes are in use.
struct Pixels {
    x: i64,
    y: i64,
    used: usize,
}

impl Pixels {
    #[inline(always)]
    fn lanes(&self) -> Range<usize> {
        // The compiler sees here that no index is out of its array.
        0..self.used.min(LANES)
    }
}

/// A first-degree expression from the first lane on. The word stands at the top of 64 bits, where it wraps by itself.
struct Ramp {
    value: i64,
    step: i64,
}

impl Ramp {
    #[inline(always)]
    fn at(expression: &Linear, pixels: &Pixels, width: u32) -> Ramp {
        let Linear { a, b, c } = *expression;
        let line = (b as i64).wrapping_mul(pixels.y).wrapping_add(c as i64);
        let value = (a as i64).wrapping_mul(pixels.x).wrapping_add(line);
        Ramp {
            value: value << (64 - width),
            step: (a as i64) << (64 - width),
        }
    }

    #[inline(always)]
    fn next(&mut self) -> i64 {
        let value = self.value;
        self.value = value.wrapping_add(self.step);
        value
    }
}

/// A depth interval in each lane. Both depths fit 32 bits; the number of the back face stands above that of the front.
struct Half {
    zf: [i32; LANES],
    zb: [i32; LANES],
    faces: [u32; LANES],
}

impl Half {
    const NONE: Half = Half {
        zf: [0; LANES],
        zb: [0; LANES],
        faces: [0; LANES],
    };

    #[inline(always)]
    fn get(&self, lane: usize) -> Interval {
        let faces = self.faces[lane];
        let front = (self.zf[lane].into(), faces as u8);
        Interval::new(front, (self.zb[lane].into(), (faces >> 8) as u8))
    }

    #[inline(always)]
    fn set(&mut self, lane: usize, Interval { zf, zb, nf, nb }: Interval) {
        (self.zf[lane], self.zb[lane]) = (zf as i32, zb as i32);
        self.faces[lane] = u32::from(nb) << 8 | u32::from(nf);
    }
}

/// What the units hand on, lane by lane.
struct Block {
    radicand: [i64; LANES],
    root: [i64; LANES],
    plane: [i32; LANES],
    a: Half,
    b: Half,
    behind: [i32; LANES],
    face: [u8; LANES],
    normal: [[i16; LANES]; 3],
}

/// Calls `sink(x, pixel)` for every pixel of line `y`, which the screen box meets, at which the object is present.
#[inline(always)]
pub(super) fn draw_line(
    words: &QuadricWords,
    format: &Format,
    y: i64,
    mut sink: impl FnMut(i64, ObjectPixel),
) {
    let mut block = Block::NONE;
    let window = &words.screen_box;
    for x in (window.x0..=window.x1).step_by(LANES) {
        let inside = ((window.x1 - x + 1) as usize).min(LANES);
        let used = inside.next_multiple_of(STEP);
        if block.draw(words, format, &Pixels { x, y, used }) {
            block.hand_on(format, &Pixels { x, y, used: inside }, &mut sink);
        }
    }
}

impl Block {
    const NONE: Block = Block {
        radicand: [0; LANES],
        root: [0; LANES],
        plane: [0; LANES],
        a: Half::NONE,
        b: Half::NONE,
        behind: [0; LANES],
        face: [0; LANES],
        normal: [[0; LANES]; 3],
    };

    /// Without a question if the object is in every lane: the loop of a simple sink becomes vector instructions then.
    #[inline(always)]
    fn hand_on(&self, format: &Format, pixels: &Pixels, sink: &mut impl FnMut(i64, ObjectPixel)) {
        let absent = format.z_max() as i32;
        let mut all_present = true;
        for lane in pixels.lanes() {
            all_present &= self.a.zf[lane] != absent;
        }
        if all_present {
            for lane in pixels.lanes() {
                sink(pixels.x + lane as i64, self.pixel(lane));
            }
            return;
        }
        for lane in pixels.lanes() {
            if self.a.zf[lane] != absent {
                sink(pixels.x + lane as i64, self.pixel(lane));
            }
        }
    }

    #[inline(always)]
    fn pixel(&self, lane: usize) -> ObjectPixel {
        let Interval { zf, zb, nf, .. } = self.a.get(lane);
        let [nx, ny, nz] = &self.normal;
        ObjectPixel {
            zf,
            zb,
            number: nf,
            normal: [nx[lane], ny[lane], nz[lane]],
        }
    }

    /// All units; false if the object is in none of the lanes because every line of sight misses it.
    #[inline(always)]
    fn draw(&mut self, words: &QuadricWords, format: &Format, pixels: &Pixels) -> bool {
        let class = words.class;
        let all_negative = self.radicands(&words.f2, format, pixels);
        if all_negative && class != Class::Front {
            return false;
        }
        match class {
            Class::Side => self.open(Class::Side, &words.f1, format, pixels),
            Class::Front => self.open(Class::Front, &words.f1, format, pixels),
            Class::Patch => self.open(Class::Patch, &words.f1, format, pixels),
            Class::Prism => self.open(Class::Prism, &words.f1, format, pixels),
        }
        for (plane, number) in words.planes.iter().zip(FACE_PLANE..) {
            self.plane(plane, format, pixels);
            match plane.kind {
                PlaneKind::None => (),
                PlaneKind::Front => self.cut(class, PlaneKind::Front, number, format, pixels),
                PlaneKind::Back => self.cut(class, PlaneKind::Back, number, format, pixels),
                PlaneKind::Perpendicular => {
                    self.cut(class, PlaneKind::Perpendicular, number, format, pixels)
                }
            }
        }
        if class == Class::Front {
            for lane in pixels.lanes() {
                self.a.set(lane, merge(self.a.get(lane), self.b.get(lane)));
            }
        }
        self.normals(words, format, pixels);
        true
    }

    /// PE2: along a line, `f(x + i) = f(x) + i (slope + a i)`. True if it is negative in all lanes.
    #[inline(always)]
    fn radicands(&mut self, f2: &Quadratic, format: &Format, pixels: &Pixels) -> bool {
        let &Quadratic { a, b, c, d, e, f } = f2;
        let (a, b, c, d, e, f) = (a as i64, b as i64, c as i64, d as i64, e as i64, f as i64);
        let &Pixels { x, y, .. } = pixels;
        let top = 64 - format.pe2_width();
        let along = a
            .wrapping_mul(x)
            .wrapping_add(c.wrapping_mul(y))
            .wrapping_add(d);
        let down = b
            .wrapping_mul(y)
            .wrapping_add(e)
            .wrapping_mul(y)
            .wrapping_add(f);
        let value = along.wrapping_mul(x).wrapping_add(down) << top;
        let mut slope = Ramp {
            value: along.wrapping_add(a.wrapping_mul(x)) << top,
            step: a << top,
        };
        let mut signs = -1;
        for lane in pixels.lanes() {
            let further = slope.next().wrapping_mul(lane as i64);
            let radicand = value.wrapping_add(further) >> (64 - format.quadratic);
            self.radicand[lane] = radicand;
            signs &= radicand;
        }
        signs < 0
    }

    /// The root, PE1, both sums and the depth interval in one loop: while a root is taken, other work goes on.
    #[inline(always)]
    fn open(&mut self, class: Class, f1: &Linear, format: &Format, pixels: &Pixels) {
        let mut f1 = Ramp::at(f1, pixels, format.pe1_width());
        for lane in pixels.lanes() {
            let linear = f1.next() >> (64 - format.sum);
            let radicand = self.radicand[lane];
            let root = format.keep_rows(fast_root(radicand));
            self.root[lane] = root;
            let near = wrap64(linear.wrapping_sub(root), format.sum);
            let far = wrap64(linear.wrapping_add(root), format.sum);
            let (a, b) = halves(class, near, far, radicand < 0, format);
            self.a.set(lane, a);
            if class == Class::Front {
                self.b.set(lane, b);
            }
        }
    }

    #[inline(always)]
    fn plane(&mut self, plane: &PlaneWords, format: &Format, pixels: &Pixels) {
        let mut depth = Ramp::at(&plane.depth, pixels, format.plane);
        for lane in pixels.lanes() {
            self.plane[lane] = saturate(depth.next() >> (64 - format.plane), format) as i32;
        }
    }

    #[inline(always)]
    fn cut(&mut self, class: Class, kind: PlaneKind, number: u8, format: &Format, pixels: &Pixels) {
        let patch = class == Class::Patch;
        for lane in pixels.lanes() {
            let zp = self.plane[lane].into();
            self.a
                .set(lane, cut(self.a.get(lane), kind, zp, number, patch, format));
        }
        if class == Class::Front {
            for lane in pixels.lanes() {
                let zp = self.plane[lane].into();
                self.b
                    .set(lane, cut(self.b.get(lane), kind, zp, number, false, format));
            }
        }
    }

    /// The normal unit: of the quadric everywhere, then of each plane and of the cap where they are seen.
    #[inline(always)]
    fn normals(&mut self, words: &QuadricWords, format: &Format, pixels: &Pixels) {
        let greatest = format.greatest_normal();
        for lane in pixels.lanes() {
            self.behind[lane] =
                (self.root[lane] >> words.normal.shift) as i32 & i32::from(greatest);
        }
        for k in 0..3 {
            self.quadric_normal(k, words, format, pixels);
        }
        for lane in pixels.lanes() {
            self.face[lane] = self.a.faces[lane] as u8;
        }
        for (plane, number) in words.planes.iter().zip(FACE_PLANE..) {
            self.constant_normal(number, plane.normal, pixels);
        }
        self.constant_normal(FACE_NEAR_END, [0, 0, -greatest], pixels);
    }

    #[inline(always)]
    fn quadric_normal(&mut self, k: usize, words: &QuadricWords, format: &Format, pixels: &Pixels) {
        let width = format.normal_linear;
        let Ramp { value, step } = Ramp::at(&words.normal.g[k], pixels, width);
        // At the top of 32 bits, which are enough for it.
        let (mut g, step) = ((value >> 32) as i32, (step >> 32) as i32);
        let factor = i32::from(words.normal.k[k]);
        for lane in pixels.lanes() {
            let product = factor * self.behind[lane];
            let is_near = self.a.faces[lane] as u8 == FACE_NEAR;
            let change = if is_near { -product } else { product } >> format.product_fraction();
            let sum = g.wrapping_add(change << (32 - width));
            self.normal[k][lane] = (sum >> (32 - width + Format::NORMAL_FRACTION)) as i16;
            g = g.wrapping_add(step);
        }
    }

    #[inline(always)]
    fn constant_normal(&mut self, number: u8, [x, y, z]: [i16; 3], pixels: &Pixels) {
        let [nx, ny, nz] = &mut self.normal;
        for lane in pixels.lanes() {
            let before = (nx[lane], ny[lane], nz[lane]);
            let is_seen = self.face[lane] == number;
            (nx[lane], ny[lane], nz[lane]) = if is_seen { (x, y, z) } else { before };
        }
    }
}
