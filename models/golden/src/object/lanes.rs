//! The units of the quadric processor over pixels of a line side by side: the same values as [`super::quadric`].
//!
//! A lane is a pixel. Every unit is one loop over the lanes without a branch, which the compiler turns into vector
//! instructions: 64-bit words for f2 and the root, 32-bit words for what fits the depth word.

mod half;
mod ramp;

use super::quadric::{ObjectPixel, QuadricWords};
use crate::format::Format;
use crate::unit::depth_interval::{Class, FACE_NEAR, FACE_NEAR_END, FACE_PLANE};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use crate::unit::root::fast_root;
use half::{Depths, Ends, Half};
use ramp::{LANES, Pixels, Ramp, STEP};

/// What the units hand on, lane by lane.
#[repr(align(64))]
struct Block {
    radicand: [i64; LANES],
    root: [u32; LANES],
    depths: Depths,
    plane: [i32; LANES],
    /// Both halves of an object that is seen from inside.
    a: Half,
    b: Half,
    seen: Half,
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
        depths: Depths {
            f2: [0; LANES],
            near: [0; LANES],
            far: [0; LANES],
        },
        plane: [0; LANES],
        a: Half::NONE,
        b: Half::NONE,
        seen: Half::NONE,
        behind: [0; LANES],
        face: [0; LANES],
        normal: [[0; LANES]; 3],
    };

    /// Without a question if the object is in every lane from its first to its last: the loop of a simple sink becomes
    /// vector instructions then.
    #[inline(always)]
    fn hand_on(&self, format: &Format, pixels: &Pixels, sink: &mut impl FnMut(i64, ObjectPixel)) {
        let absent = format.z_max() as i32;
        let is_present = |&lane: &usize| self.seen.zf[lane] != absent;
        let first = pixels.lanes().find(is_present).unwrap_or(LANES);
        let last = pixels.lanes().rfind(is_present).unwrap_or(0);
        // As in [`Pixels::lanes`].
        let span = || first..(last + 1).min(LANES);
        let mut all_present = true;
        for lane in span() {
            all_present &= is_present(&lane);
        }
        if all_present {
            for lane in span() {
                sink(pixels.x + lane as i64, self.pixel(lane));
            }
            return;
        }
        for lane in span().filter(is_present) {
            sink(pixels.x + lane as i64, self.pixel(lane));
        }
    }

    #[inline(always)]
    fn pixel(&self, lane: usize) -> ObjectPixel {
        let [nx, ny, nz] = &self.normal;
        ObjectPixel {
            zf: self.seen.zf[lane].into(),
            zb: self.seen.zb[lane].into(),
            number: self.seen.number(lane),
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
        self.roots(format, pixels);
        self.sums(&words.f1, format, pixels);
        match class {
            Class::Side => self.interval(Class::Side, words, format, pixels),
            Class::Front => self.interval(Class::Front, words, format, pixels),
            Class::Patch => self.interval(Class::Patch, words, format, pixels),
            Class::Prism => self.interval(Class::Prism, words, format, pixels),
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
        let mut slope = along.wrapping_add(a.wrapping_mul(x)) << top;
        let mut signs = -1;
        for lane in pixels.lanes() {
            let further = slope.wrapping_mul(lane as i64);
            slope = slope.wrapping_add(a << top);
            let radicand = value.wrapping_add(further) >> (64 - format.quadratic);
            self.radicand[lane] = radicand;
            signs &= radicand;
        }
        signs < 0
    }

    /// Of no meaning where the radicand is negative.
    #[inline(always)]
    fn roots(&mut self, format: &Format, pixels: &Pixels) {
        for lane in pixels.lanes() {
            let radicand = self.radicand[lane];
            self.root[lane] = format.keep_rows(fast_root(radicand)) as u32;
            self.depths.f2[lane] = (radicand >> 32) as i32;
        }
        if !format.root_form.is_exact() {
            for lane in pixels.lanes() {
                self.root[lane] = format.root_of(self.radicand[lane]) as u32;
            }
        }
    }

    /// PE1 and both sums, saturated: in 32 bits if no sum can wrap or needs more.
    #[inline(always)]
    fn sums(&mut self, f1: &Linear, format: &Format, pixels: &Pixels) {
        let mut f1 = Ramp::at(f1, pixels, format.pe1_width());
        let most = (1 << (format.sum - 1).min(31)) - (1 << format.root);
        let Depths { near, far, .. } = &mut self.depths;
        if let Some(mut f1) = f1.within(most << format.guard_linear, pixels) {
            let ends = Ends::of(format);
            for lane in pixels.lanes() {
                let (linear, root) = (f1.next() >> format.guard_linear, self.root[lane] as i32);
                near[lane] = ends.saturate(linear.wrapping_sub(root));
                far[lane] = ends.saturate(linear.wrapping_add(root));
            }
            return;
        }
        let top = 64 - format.sum;
        for lane in pixels.lanes() {
            let (linear, root) = (f1.next() & (-1 << top), i64::from(self.root[lane]) << top);
            near[lane] = saturated(linear.wrapping_sub(root), format.sum, format);
            far[lane] = saturated(linear.wrapping_add(root), format.sum, format);
        }
    }

    /// The depth interval, the chain of planes, and the merge.
    #[inline(always)]
    fn interval(&mut self, class: Class, words: &QuadricWords, format: &Format, pixels: &Pixels) {
        let ends = &Ends::of(format);
        let is_patch = class == Class::Patch;
        let is_double = class == Class::Front;
        let Block {
            depths,
            plane: depth,
            a,
            b,
            seen,
            ..
        } = self;
        let front = if is_double { &mut *a } else { &mut *seen };
        front.open(class, false, depths, format, pixels);
        if is_double {
            b.open(class, true, depths, format, pixels);
        }
        for (plane, number) in words.planes.iter().zip(FACE_PLANE..) {
            plane_depths(&plane.depth, depth, format, pixels);
            front.cut(plane.kind, (depth, number), is_patch, ends, pixels);
            if is_double {
                b.cut(plane.kind, (depth, number), false, ends, pixels);
            }
        }
        if is_double {
            seen.merge(a, b, pixels);
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
            self.face[lane] = self.seen.number(lane);
        }
        for (plane, number) in words.planes.iter().zip(FACE_PLANE..) {
            self.constant_normal(number, plane.normal, pixels);
        }
        self.constant_normal(FACE_NEAR_END, [0, 0, -greatest], pixels);
    }

    #[inline(always)]
    fn quadric_normal(&mut self, k: usize, words: &QuadricWords, format: &Format, pixels: &Pixels) {
        let width = format.normal_linear;
        let mut g = Ramp::at(&words.normal.g[k], pixels, width).upper();
        let factor = i32::from(words.normal.k[k]);
        for lane in pixels.lanes() {
            let product = factor * self.behind[lane];
            let is_near = self.seen.number(lane) == FACE_NEAR;
            let change = if is_near { -product } else { product } >> format.product_fraction();
            let sum = g.next().wrapping_add(change << (32 - width));
            self.normal[k][lane] = (sum >> (32 - width + Format::NORMAL_FRACTION)) as i16;
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

/// PE1 of a plane, saturated.
#[inline(always)]
fn plane_depths(plane: &Linear, to: &mut [i32; LANES], format: &Format, pixels: &Pixels) {
    let mut depth = Ramp::at(plane, pixels, format.plane);
    if let Some(mut depth) = depth.within(1 << (format.plane - 1), pixels) {
        let ends = Ends::of(format);
        for lane in pixels.lanes() {
            to[lane] = ends.saturate(depth.next());
        }
        return;
    }
    for lane in pixels.lanes() {
        to[lane] = saturated(depth.next(), format.plane, format);
    }
}

/// As [`Ends::saturate`], of the word of `width` bits at the top of `word`. One that is no longer than a depth is
/// within the ends.
#[inline(always)]
fn saturated(word: i64, width: u32, format: &Format) -> i32 {
    if width <= format.depth {
        return (word >> 32) as i32 >> (32 - width);
    }
    let [low, max] = [format.plane_low(), format.z_max()].map(|end| end << (64 - width));
    let depth = word.max(low).min(max) << (width - format.depth);
    (depth >> 32) as i32 >> (32 - format.depth)
}
