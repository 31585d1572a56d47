//! Conversion in software: a scalar program visits every pixel of an object's box, with forward differences as the processors have them (source: chapter 5).
//!
//! The kind of a plane and the class of the quadric are the same at all pixels, so no test of them is counted.

use super::quadric::Kind;
use crate::evaluate::count::{Counted, Counter};

/// What a scan came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scan {
    /// Pixels that show the object.
    pub inside: u64,
    /// Other pixels of the box.
    pub outside: u64,
    /// Weighted operations at the former.
    pub inside_cost: u64,
    /// At the latter.
    pub outside_cost: u64,
    /// Of steps from line to line.
    pub line_cost: u64,
    /// Lines.
    pub lines: u64,
    /// Depths, line by line; none where the object is not seen.
    pub depths: Vec<Option<f64>>,
}

impl Scan {
    /// Pixels of the box.
    pub fn pixels(&self) -> u64 {
        self.inside + self.outside
    }

    /// All operations.
    pub fn total(&self) -> u64 {
        self.inside_cost + self.outside_cost + self.line_cost
    }

    /// Mean operations at a pixel that shows the object.
    pub fn per_inside(&self) -> f64 {
        self.inside_cost as f64 / self.inside as f64
    }

    /// Mean operations at another pixel.
    pub fn per_outside(&self) -> f64 {
        self.outside_cost as f64 / self.outside as f64
    }

    /// Operations of a line's step.
    pub fn per_line(&self) -> f64 {
        self.line_cost as f64 / self.lines as f64
    }

    /// All operations for each pixel that shows the object.
    pub fn per_covered(&self) -> f64 {
        self.total() as f64 / self.inside as f64
    }
}

/// First-degree forward differences.
struct Linear<'c> {
    across: Counted<'c>,
    down: Counted<'c>,
    line: Counted<'c>,
    value: Counted<'c>,
}

impl<'c> Linear<'c> {
    fn new([across, down, line]: [Counted<'c>; 3]) -> Linear<'c> {
        Linear {
            across,
            down,
            line,
            value: line,
        }
    }

    fn pixel_step(&mut self) {
        self.value = self.value + self.across;
    }

    fn line_step(&mut self) {
        self.line = self.line + self.down;
        self.value = self.line;
    }
}

/// Second-degree ones: two additions a pixel, three a line.
struct Quadratic<'c> {
    a2: Counted<'c>,
    b2: Counted<'c>,
    c: Counted<'c>,
    line_first: Counted<'c>,
    line_step: Counted<'c>,
    line: Counted<'c>,
    step: Counted<'c>,
    value: Counted<'c>,
}

impl<'c> Quadratic<'c> {
    /// Of a x^2 + b y^2 + c xy + d x + e y + f; the differences are formed in the preparation.
    fn new(counter: &'c Counter, [a, b, c, d, e, f]: [f64; 6]) -> Quadratic<'c> {
        let first = counter.number(d + a);
        let value = counter.number(f);
        Quadratic {
            a2: counter.number(2.0 * a),
            b2: counter.number(2.0 * b),
            c: counter.number(c),
            line_first: first,
            line_step: counter.number(e + b),
            line: value,
            step: first,
            value,
        }
    }

    fn pixel_step(&mut self) {
        self.value = self.value + self.step;
        self.step = self.step + self.a2;
    }

    fn line_step(&mut self) {
        self.line = self.line + self.line_step;
        self.line_step = self.line_step + self.b2;
        self.line_first = self.line_first + self.c;
        self.value = self.line;
        self.step = self.line_first;
    }
}

/// Visits a square box; `pixel` gives the depth and steps on, `line` steps to the next line.
fn scan<S>(
    counter: &Counter,
    side: u64,
    mut state: S,
    pixel: impl Fn(&mut S) -> Option<f64>,
    line: impl Fn(&mut S),
) -> Scan {
    let mut found = Scan::default();
    for _ in 0..side {
        for _ in 0..side {
            let before = counter.tally().weighted();
            let depth = pixel(&mut state);
            let cost = counter.tally().weighted() - before;
            if depth.is_some() {
                found.inside += 1;
                found.inside_cost += cost;
            } else {
                found.outside += 1;
                found.outside_cost += cost;
            }
            found.depths.push(depth);
        }
        let before = counter.tally().weighted();
        line(&mut state);
        found.line_cost += counter.tally().weighted() - before;
        found.lines += 1;
    }
    found
}

/// A facet on a box of so many pixels a side: sides not negative inside, depth, three components of the normal. Each pixel inside is compared with a z-buffer.
pub fn facet(counter: &Counter, side: u64, expressions: [[f64; 3]; 7]) -> Scan {
    let state = expressions.map(|e| Linear::new(counter.numbers(e)));
    let far = counter.number(f64::MAX);
    let pixel = |state: &mut [Linear<'_>; 7]| {
        let inside = state[..3].iter().all(|e| !e.value.is_negative());
        let depth = state[3].value;
        let seen = inside && depth.is_below(far);
        state.iter_mut().for_each(Linear::pixel_step);
        seen.then_some(depth.value)
    };
    scan(counter, side, state, pixel, |state| {
        state.iter_mut().for_each(Linear::line_step)
    })
}

/// A quadric and its planes in pixels of its box.
#[derive(Clone, Debug)]
pub struct Object {
    /// Linear part of the depth.
    pub f1: [f64; 3],
    /// Factors of x^2, y^2, xy, x, y and 1.
    pub f2: [f64; 6],
    /// Kind and expression: a depth, or not negative where a perpendicular plane keeps.
    pub planes: Vec<(Kind, [f64; 3])>,
    /// Linear parts of the normal and factors of the root.
    pub normal: ([[f64; 3]; 3], [f64; 3]),
}

struct State<'c> {
    f1: Linear<'c>,
    f2: Quadratic<'c>,
    planes: Vec<(Kind, Linear<'c>)>,
    g: [Linear<'c>; 3],
    k: [Counted<'c>; 3],
}

impl<'c> State<'c> {
    fn new(counter: &'c Counter, object: &Object) -> State<'c> {
        let linear = |e: [f64; 3]| Linear::new(counter.numbers(e));
        State {
            f1: linear(object.f1),
            f2: Quadratic::new(counter, object.f2),
            planes: object
                .planes
                .iter()
                .map(|(kind, e)| (*kind, linear(*e)))
                .collect(),
            g: object.normal.0.map(linear),
            k: counter.numbers(object.normal.1),
        }
    }

    fn linear(&mut self) -> impl Iterator<Item = &mut Linear<'c>> {
        let planes = self.planes.iter_mut().map(|(_, plane)| plane);
        planes.chain(&mut self.g).chain([&mut self.f1])
    }

    fn pixel_step(&mut self) {
        self.linear().for_each(Linear::pixel_step);
        self.f2.pixel_step();
    }

    fn line_step(&mut self) {
        self.linear().for_each(Linear::line_step);
        self.f2.line_step();
    }

    /// The normal of the quadric at one of its faces.
    fn normal(&self, signed_root: Counted<'c>) -> [Counted<'c>; 3] {
        std::array::from_fn(|k| self.g[k].value + self.k[k] * signed_root)
    }
}

/// A solid seen from the side: its interval is cut by plane after plane.
pub fn solid(counter: &Counter, side: u64, object: &Object) -> Scan {
    let far = counter.number(f64::MAX);
    let pixel = |state: &mut State<'_>| {
        let depth = front_of_solid(state, far).map(|z| z.value);
        state.pixel_step();
        depth
    };
    scan(
        counter,
        side,
        State::new(counter, object),
        pixel,
        State::line_step,
    )
}

fn front_of_solid<'c>(state: &State<'c>, far: Counted<'c>) -> Option<Counted<'c>> {
    if state.f2.value.is_negative() {
        return None;
    }
    let root = state.f2.value.root();
    let (mut zf, mut zb) = (state.f1.value - root, state.f1.value + root);
    let mut is_quadric = true;
    for (kind, plane) in &state.planes {
        let zp = plane.value;
        match kind {
            Kind::Perpendicular if zp.is_negative() => return None,
            Kind::Front if zf.is_below(zp) => {
                if zb.is_below(zp) {
                    return None;
                }
                zf = zp;
                is_quadric = false;
            }
            Kind::Back if zp.is_below(zb) => {
                if zp.is_below(zf) {
                    return None;
                }
                zb = zp;
            }
            _ => {}
        }
    }
    if !zf.is_below(far) {
        return None;
    }
    if is_quadric {
        state.normal(-root);
    }
    Some(zf)
}

/// A patch: the near face if all planes keep it, else the far one.
pub fn patch(counter: &Counter, side: u64, object: &Object) -> Scan {
    let far = counter.number(f64::MAX);
    let pixel = |state: &mut State<'_>| {
        let depth = face_of_patch(state, far).map(|z| z.value);
        state.pixel_step();
        depth
    };
    scan(
        counter,
        side,
        State::new(counter, object),
        pixel,
        State::line_step,
    )
}

fn face_of_patch<'c>(state: &State<'c>, far: Counted<'c>) -> Option<Counted<'c>> {
    if state.f2.value.is_negative() {
        return None;
    }
    let root = state.f2.value.root();
    for signed in [-root, root] {
        let z = state.f1.value + signed;
        let keeps = |(kind, plane): &(Kind, Linear<'c>)| match kind {
            Kind::Front => !z.is_below(plane.value),
            Kind::Back => !plane.value.is_below(z),
            Kind::Perpendicular => !plane.value.is_negative(),
        };
        if state.planes.iter().all(keeps) {
            if !z.is_below(far) {
                return None;
            }
            state.normal(signed);
            return Some(z);
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evaluate::software::{FACET, ball};

    fn at([a, b, c]: [f64; 3], x: f64, y: f64) -> f64 {
        a * x + b * y + c
    }

    /// Every pixel by direct evaluation and intersection of half-spaces, without differences and without a chain. The numbers are whole or quarters and below 2^20,
    /// so that differences and values are the same.
    #[test]
    fn scans_find_what_direct_evaluation_finds() {
        let counter = Counter::default();
        let side = 40;
        let object = ball(side, 4);
        let (found_solid, found_patch) = (
            solid(&counter, side, &object),
            patch(&counter, side, &object),
        );
        assert!(found_patch.inside > 300 && found_patch.outside > 300);
        for (index, (solid, patch)) in found_solid
            .depths
            .iter()
            .zip(&found_patch.depths)
            .enumerate()
        {
            let (x, y) = ((index as u64 % side) as f64, (index as u64 / side) as f64);
            let terms = [x * x, y * y, x * y, x, y, 1.0];
            let f2: f64 = object.f2.iter().zip(terms).map(|(v, t)| v * t).sum();
            let faces = [-1.0, 1.0].map(|sign| at(object.f1, x, y) + sign * f2.sqrt());
            let sides = |kind: Kind| {
                let planes = object.planes.iter().filter(move |(k, _)| *k == kind);
                planes.map(move |(_, e)| at(*e, x, y))
            };
            let open = f2 >= 0.0 && sides(Kind::Perpendicular).all(|v| v >= 0.0);
            let near = sides(Kind::Front).fold(f64::NEG_INFINITY, f64::max);
            let far = sides(Kind::Back).fold(f64::INFINITY, f64::min);
            let (front, back) = (faces[0].max(near), faces[1].min(far));
            let expected = (open && front <= back).then_some(front);
            assert_eq!(*solid, expected, "{x} {y}");
            let face = faces.into_iter().find(|&z| open && near <= z && z <= far);
            assert_eq!(*patch, face, "{x} {y}");
        }
    }

    #[test]
    fn a_facet_covers_the_pixels_within_its_sides() {
        let counter = Counter::default();
        let found = facet(&counter, 20, FACET);
        // Half of the box with the diagonal.
        assert_eq!((found.inside, found.outside), (210, 190));
        for (index, depth) in found.depths.iter().enumerate() {
            let (x, y) = ((index % 20) as f64, (index / 20) as f64);
            let expected = (x + y <= 19.0).then(|| at(FACET[3], x, y));
            assert_eq!(*depth, expected);
        }
    }
}
