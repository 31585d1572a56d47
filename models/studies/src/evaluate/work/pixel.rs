//! Conversion in software: a scalar program visits every pixel of an object's box, with forward differences as the
//! processors have them (source: chapter 5).
//!
//! The kind of a plane and the class of the quadric are the same at all pixels, so no test of them is counted.

use super::quadric::Kind;
use crate::evaluate::count::{Counted, cost, number, numbers};
use serde_json::{Value, json};

/// What a scan came to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Scan {
    /// Pixels of the box that do not show the object, and that do.
    pub pixels: [u64; 2],
    /// Weighted operations at each of both.
    costs: [u64; 2],
    line_cost: u64,
    lines: u64,
    /// Depths, line by line; none where the object is not seen.
    pub depths: Vec<Option<f64>>,
}

impl Scan {
    /// Mean operations at a pixel inside and outside and of a line's step, all, all for each pixel inside, and these in
    /// percent of the box.
    pub fn figures(&self) -> Value {
        let [outside, inside] = self.pixels.map(|count| count as f64);
        let [outside_cost, inside_cost] = self.costs.map(|cost| cost as f64);
        let total = (self.costs.iter().sum::<u64>() + self.line_cost) as f64;
        json!({
            "inside": inside_cost / inside,
            "outside": outside_cost / outside,
            "line": self.line_cost as f64 / self.lines as f64,
            "total": total,
            "covered": total / inside,
            "percent": 100.0 * inside / (inside + outside),
        })
    }
}

struct Linear {
    across: Counted,
    down: Counted,
    line: Counted,
    value: Counted,
}

impl Linear {
    fn new(expression: [f64; 3]) -> Linear {
        let [across, down, line] = numbers(expression);
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
struct Quadratic {
    step: Linear,
    b2: Counted,
    line_step: Counted,
    line: Counted,
    value: Counted,
}

impl Quadratic {
    /// Of a x^2 + b y^2 + c xy + d x + e y + f; the differences are formed in the preparation.
    fn new([a, b, c, d, e, f]: [f64; 6]) -> Quadratic {
        let [b2, line_step, line] = numbers([2.0 * b, e + b, f]);
        Quadratic {
            step: Linear::new([2.0 * a, c, d + a]),
            b2,
            line_step,
            line,
            value: line,
        }
    }

    fn pixel_step(&mut self) {
        self.value = self.value + self.step.value;
        self.step.pixel_step();
    }

    fn line_step(&mut self) {
        self.line = self.line + self.line_step;
        self.line_step = self.line_step + self.b2;
        self.value = self.line;
        self.step.line_step();
    }
}

/// Visits a square box; `pixel` gives the depth and steps on, `line` steps to the next line.
fn scan<S>(
    side: u64,
    mut state: S,
    pixel: impl Fn(&mut S) -> Option<f64>,
    line: impl Fn(&mut S),
) -> Scan {
    let mut found = Scan::default();
    for _ in 0..side {
        for _ in 0..side {
            let mut depth = None;
            let done = cost(|| depth = pixel(&mut state)).weighted();
            let inside = usize::from(depth.is_some());
            found.pixels[inside] += 1;
            found.costs[inside] += done;
            found.depths.push(depth);
        }
        found.line_cost += cost(|| line(&mut state)).weighted();
        found.lines += 1;
    }
    found
}

/// Half of a box of 20 x 20 pixels, with the diagonal: sides, depth, normal.
pub const FACET: [[f64; 3]; 7] = [
    [1.0, 0.0, 0.0],
    [0.0, 1.0, 0.0],
    [-1.0, -1.0, 19.0],
    [3.0, -2.0, 500.0],
    [4.0, 0.0, -40.0],
    [0.0, 4.0, -40.0],
    [0.0, 0.0, -100.0],
];

/// A facet on a box of so many pixels a side: sides not negative inside, depth, three components of the normal. Each
/// pixel inside is compared with a z-buffer.
pub fn facet(side: u64, expressions: [[f64; 3]; 7]) -> Scan {
    let far = number(f64::MAX);
    let pixel = |state: &mut [Linear; 7]| {
        let inside = state[..3].iter().all(|e| !e.value.is_negative());
        let depth = state[3].value;
        let seen = inside && depth.is_below(far);
        state.iter_mut().for_each(Linear::pixel_step);
        seen.then_some(depth.value)
    };
    let line = |state: &mut [Linear; 7]| state.iter_mut().for_each(Linear::line_step);
    scan(side, expressions.map(Linear::new), pixel, line)
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
    normal: ([[f64; 3]; 3], [f64; 3]),
}

/// A ball that fills a box of so many pixels, cut by up to four planes: one from the front, one from the back, two
/// along the line of sight.
pub fn ball(side: u64, planes: usize) -> Object {
    let middle = (side as f64 - 1.0) / 2.0;
    let radius = side as f64 / 2.0;
    let all = [
        (Kind::Front, [0.5, 0.25, -0.8 * radius - 0.75 * middle]),
        (Kind::Back, [-0.25, 0.5, 0.85 * radius - 0.25 * middle]),
        (Kind::Perpendicular, [1.0, 0.0, -2.0]),
        (Kind::Perpendicular, [0.0, -1.0, side as f64 - 3.0]),
    ];
    let constant = radius * radius - 2.0 * middle * middle;
    Object {
        f1: [0.0, 0.0, 0.0],
        f2: [-1.0, -1.0, 0.0, 2.0 * middle, 2.0 * middle, constant],
        planes: all[..planes].to_vec(),
        normal: (
            [[1.0, 0.0, -middle], [0.0, 1.0, -middle], [0.0, 0.0, 0.0]],
            [0.0, 0.0, 1.0],
        ),
    }
}

struct State {
    f1: Linear,
    f2: Quadratic,
    planes: Vec<(Kind, Linear)>,
    g: [Linear; 3],
    k: [Counted; 3],
    far: Counted,
}

impl State {
    fn linear(&mut self) -> impl Iterator<Item = &mut Linear> {
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
    fn normal(&self, signed_root: Counted) -> [Counted; 3] {
        std::array::from_fn(|k| self.g[k].value + self.k[k] * signed_root)
    }

    /// The root of f2; nothing outside the silhouette.
    fn root(&self) -> Option<Counted> {
        let outside = self.f2.value.is_negative();
        (!outside).then(|| self.f2.value.root())
    }
}

fn object(side: u64, object: &Object, depth: impl Fn(&State) -> Option<Counted>) -> Scan {
    let pixel = |state: &mut State| {
        let depth = depth(state).map(|z| z.value);
        state.pixel_step();
        depth
    };
    let planes = object.planes.iter();
    let state = State {
        f1: Linear::new(object.f1),
        f2: Quadratic::new(object.f2),
        planes: planes.map(|(kind, e)| (*kind, Linear::new(*e))).collect(),
        g: object.normal.0.map(Linear::new),
        k: numbers(object.normal.1),
        far: number(f64::MAX),
    };
    scan(side, state, pixel, State::line_step)
}

/// A solid seen from the side: its interval is cut by plane after plane.
pub fn solid(side: u64, solid: &Object) -> Scan {
    object(side, solid, |state| {
        let root = state.root()?;
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
        if !zf.is_below(state.far) {
            return None;
        }
        if is_quadric {
            state.normal(-root);
        }
        Some(zf)
    })
}

/// A patch: the near face if all planes keep it, else the far one.
pub fn patch(side: u64, patch: &Object) -> Scan {
    object(side, patch, |state| {
        let root = state.root()?;
        let kept = |signed: &Counted| {
            let z = state.f1.value + *signed;
            let keeps = |(kind, plane): &(Kind, Linear)| match kind {
                Kind::Front => !z.is_below(plane.value),
                Kind::Back => !plane.value.is_below(z),
                Kind::Perpendicular => !plane.value.is_negative(),
            };
            state.planes.iter().all(keeps).then_some((*signed, z))
        };
        let (signed, z) = [-root, root].iter().find_map(kept)?;
        if !z.is_below(state.far) {
            return None;
        }
        state.normal(signed);
        Some(z)
    })
}
