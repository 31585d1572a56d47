//! The range of the depth word, chosen for a scene.
//!
//! What leaves the words of an object is most often the *other* root of its quadric, far from anything visible. In perspective the depth word is of first degree in the
//! inverse of the distance, so a root near the eye, or behind it, is a great number, whatever can be seen; how great follows from the near end alone.
//! So the range is chosen in two steps, by powers of two of what the camera suggests, which keeps it reproducible and most scenes as they are:
//!
//! 1. *What is seen fits.* The near end of a perspective view is nearer than everything on the screen, and of a solid about the eye nearer than its walls. It is kept
//!    if it is not more than 2^[`SPARE`] times nearer than it need be. An end so near that nothing behind it could be told apart is not taken: 2^[`DEEPEST`] is the
//!    most between it and the object that begins last. An orthographic view covers what the file asks for, or all that ends somewhere.
//! 2. *What is computed fits.* If f2 or f1 + r of a quadric leaves its word on the object's screen box, the range is widened, no further than helps and at most by
//!    2^[`WIDEST`]. What then still does not fit is drawn by a quotient ([`super::quotient`]).

use super::Context;
use super::extent::Extent;
use super::forms::QuadraticForm;
use super::perspective::{ScreenQuadric, full_depth, inverse_distance, project_plane};
use super::screen_box::{Cell, Existence, Region, Search};
use crate::format::Format;
use crate::object::quadric::ScreenBox;
use crate::rational::{integer, to_f64};
use crate::scene::{
    CutOff, DepthRange, End, FramedMesh, FramedObject, FramedQuadric, FramedScene, Object, Plane,
    Projection, Quadric, RangeOrigin, SceneError, SceneFile, Surface,
};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use rayon::prelude::*;
use std::ops::Range;

/// Powers of two between which content is looked for, from the near end that the camera suggests.
const LEVELS: Range<i32> = -24..24;
/// Most powers of two between the near end and the nearest point of the object that begins farthest away.
const DEEPEST: i32 = 10;
/// Powers of two by which a near end may be nearer than what is seen.
const SPARE: i32 = 2;
/// Most powers of two by which a range is widened for what is computed: a perspective one, and an orthographic one, which loses less by it.
const WIDEST: [i32; 2] = [4, 8];
/// Part of a word that the rounding of coefficients may take.
const MARGIN: f64 = 1e-4;

impl SceneFile {
    /// The scene in the camera frame of a picture of `width` by `height` pixels, with the range of the depth word that it names or that is chosen for it.
    ///
    /// # Errors
    ///
    /// What the checks of a scene refuse, such as a size that is out of range.
    pub fn frame(&self, width: u32, height: u32) -> Result<FramedScene, SceneError> {
        self.validate()?;
        frame_keeping(&self.flattened(), (width, height), |_, _| Ok(None))
    }
}

/// The same of a checked and flattened scene; `kept` hands out objects that are framed already, for the range that the camera suggests or names.
pub(crate) fn frame_keeping(
    scene: &SceneFile,
    size: (u32, u32),
    kept: impl Fn(&Object, usize) -> Result<Option<FramedObject>, SceneError> + Sync,
) -> Result<FramedScene, SceneError> {
    let suggested = DepthRange::of_camera(&scene.camera);
    let mut framed = scene.frame_within(&suggested, size, kept)?;
    let chosen = Depths::new(&framed).choose();
    if chosen.near != suggested.near || chosen.far != suggested.far {
        framed = scene.frame_within(&chosen, size, |_, _| Ok(None))?;
    }
    framed.range = chosen;
    Ok(framed)
}

/// A scene in the range that its camera suggests, as far as depth is concerned.
struct Depths<'a> {
    scene: &'a FramedScene,
    /// Depth in pixels that fills the word.
    full: f64,
    is_perspective: bool,
    bodies: Vec<Body>,
}

/// Where an object may be.
struct Body {
    /// In one of these parts of screen space, or anywhere if there is none; a solid about the eye stands for its walls.
    regions: Vec<Region>,
    /// Between these depths.
    reach: (f64, f64),
}

/// What the depth of a quadric computes on its box, in depths that fill the word.
struct Computed {
    f1: (f64, f64),
    /// Greatest magnitude, and greatest value, of f2.
    f2: (f64, f64),
}

/// What the words of a format hold, in depths that fill the depth word.
struct Limits {
    f1_and_root: f64,
    f2: f64,
}

impl Limits {
    fn of(format: &Format) -> Limits {
        let power = |bits: u32, of: u32| f64::exp2(f64::from(bits) - f64::from(of));
        Limits {
            f1_and_root: (1.0 - MARGIN) * power(format.sum, format.depth),
            f2: (1.0 - MARGIN) * power(format.quadratic + 1, 2 * format.depth),
        }
    }
}

/// A depth word over the greatest, as `shift + scale z` of a depth z that fills the word of another range.
#[derive(Clone, Copy)]
struct Change {
    shift: f64,
    scale: f64,
}

impl Change {
    /// To the range whose ends are 2^level times farther.
    fn to_level(level: i32, is_perspective: bool) -> Change {
        let factor = f64::exp2(f64::from(level));
        let (shift, scale) = match is_perspective {
            true => (1.0 - factor, factor),
            false => (0.0, factor.recip()),
        };
        Change { shift, scale }
    }

    /// The ends of the range in depths of the other.
    fn ends(&self) -> [f64; 2] {
        [-1.0, 1.0].map(|word| (word - self.shift) / self.scale)
    }
}

/// The part of screen space between two depths.
fn cell((width, height): (u32, u32), [near, far]: [f64; 2]) -> Cell {
    let (w, h) = (f64::from(width), f64::from(height));
    Cell::between(
        [-0.5 * w, -0.5 * h, near],
        [0.5 * w - 1.0, 0.5 * h - 1.0, far],
    )
}

impl Computed {
    /// The expressions of a quadric on a box of a picture whose depth word `full` pixels fill.
    fn on(
        quadric: &ScreenQuadric,
        window: &ScreenBox,
        (width, height): (u32, u32),
        full: f64,
    ) -> Computed {
        let half = |size: u32| -integer(i64::from(size)) / integer(2);
        let (x, y) = (half(width), half(height));
        let over = |value: &BigRational| to_f64(value) / full;
        let f1 = QuadraticForm::of_linear(&quadric.f1().about(&x, &y));
        let (least, greatest) = f1.range_on(window);
        let f1 = (over(&least), over(&greatest));
        let (least, greatest) = quadric.f2().about(&x, &y).range_on(window);
        let [least, greatest] = [least, greatest].map(|value| over(&value) / full);
        Computed {
            f1,
            f2: (least.abs().max(greatest.abs()), greatest),
        }
    }

    /// Do f2 and f1 + r stay in their words when depth changes so.
    fn fits(&self, Change { shift, scale }: Change, limits: &Limits) -> bool {
        let (low, high) = (shift + scale * self.f1.0, shift + scale * self.f1.1);
        let root = scale * self.f2.1.max(0.0).sqrt();
        scale * scale * self.f2.0 < limits.f2
            && low.abs().max(high.abs()) + root < limits.f1_and_root
    }
}

/// The range in which f2 and f1 + r of an object would stay in their words, as a clause of a refusal; nothing if none would do.
pub(super) fn remedy(quadric: &ScreenQuadric, region: &Region, context: &Context) -> String {
    let full = to_f64(&context.full_depth);
    let size = (context.width, context.height);
    let limits = Limits::of(&context.format);
    let fits = |steps: &i32| {
        let level = if context.perspective { -steps } else { *steps };
        let change = Change::to_level(level, context.perspective);
        // More of it is seen in a wider range.
        let cell = cell(size, change.ends().map(|end| full * end));
        let window = region.box_within(cell, size.0, size.1, Search::COARSE);
        Computed::on(quadric, &window, size, full).fits(change, &limits)
    };
    let Some(steps) = (1..60).find(fits) else {
        return String::new();
    };
    let level = if context.perspective { -steps } else { steps };
    let range = context.range.scaled(level);
    let near = to_f64(&range.near);
    match &range.far {
        None => format!("; `near = {near}` in the camera would do"),
        Some(far) => format!(
            "; `near = {near}` and `far = {}` in the camera, in the place of `half_depth`, would do",
            to_f64(far)
        ),
    }
}

impl<'a> Depths<'a> {
    fn new(scene: &'a FramedScene) -> Depths<'a> {
        let objects = scene.objects.par_iter();
        Depths {
            scene,
            full: to_f64(&full_depth(&scene.projection)),
            is_perspective: matches!(scene.projection, Projection::Perspective { .. }),
            bodies: objects
                .map(|object| body(object, &scene.projection))
                .collect(),
        }
    }

    fn size(&self) -> (u32, u32) {
        (self.scene.width, self.scene.height)
    }

    fn choose(&self) -> DepthRange {
        let suggested = &self.scene.range;
        let places: Vec<Option<Range<i32>>> = self
            .bodies
            .par_iter()
            .map(|body| self.levels(body))
            .collect();
        let level = match suggested.origin {
            RangeOrigin::Hand => 0,
            _ => self.widened(self.seen(&places)),
        };
        let mut range = suggested.scaled(level);
        range.cut = self.cut(&places, level);
        range
    }

    /// The level of the range in which all that is seen fits, as far as it can.
    fn seen(&self, places: &[Option<Range<i32>>]) -> i32 {
        if !self.is_perspective {
            if self.scene.range.origin == RangeOrigin::Camera {
                return 0;
            }
            let ends = places.iter().flatten().map(|levels| levels.end);
            return ends.filter(|&end| end < LEVELS.end).max().unwrap_or(0);
        }
        let begins = || places.iter().flatten().map(|levels| levels.start);
        let (Some(first), Some(last)) = (begins().min(), begins().max()) else {
            return 0;
        };
        match first {
            0..=SPARE => 0,
            _ => first.max(last - DEEPEST),
        }
    }

    /// The same, widened until f2 and f1 + r of as many objects as possible stay in their words.
    fn widened(&self, level: i32) -> i32 {
        let (step, widest) = match self.is_perspective {
            true => (-1, WIDEST[0]),
            false => (1, WIDEST[1]),
        };
        let computed = |search| -> Vec<Computed> {
            let objects = self.scene.objects.par_iter();
            objects
                .filter_map(|object| self.computed(object, level + step * widest, search))
                .collect()
        };
        let limits = Limits::of(&Format::BASE);
        let misfits = |computed: &[Computed], level: i32| {
            let change = Change::to_level(level, self.is_perspective);
            let fitting = computed.iter().filter(|c| c.fits(change, &limits));
            computed.len() - fitting.count()
        };
        // A box that is too large asks for too much, so what it says is believed only if it asks for nothing.
        if misfits(&computed(Search::COARSE), level) == 0 {
            return level;
        }
        let computed = computed(Search::FINE);
        let least = misfits(&computed, level + step * widest);
        let mut steps = 0..widest;
        let enough = steps.find(|steps| misfits(&computed, level + step * steps) <= least);
        level + step * enough.unwrap_or(widest)
    }

    /// The objects that an end of the range of a level cuts.
    fn cut(&self, places: &[Option<Range<i32>>], level: i32) -> Vec<CutOff> {
        let mut list = vec![];
        for ((object, body), levels) in self.scene.objects.iter().zip(&self.bodies).zip(places) {
            let mut add = |end| {
                list.push(CutOff {
                    object: object.name().to_owned(),
                    end,
                });
            };
            let Some(levels) = levels else { continue };
            if self.is_perspective {
                if levels.start < level || is_about_eye(object, &self.scene.projection) {
                    add(End::Near);
                }
            } else if levels.end > level {
                let beyond = |side: f64| {
                    (level..LEVELS.end).any(|level| self.is_met(body, self.shell(level, side)))
                };
                for (end, side) in [(End::Near, -1.0), (End::Far, 1.0)] {
                    if beyond(side) {
                        add(end);
                    }
                }
            }
        }
        list
    }

    /// The levels between which an object lies; nothing if none of it is on the screen. In perspective level n is 2^n near ends from the eye, else 2^n half depths from
    /// the screen plane.
    fn levels(&self, body: &Body) -> Option<Range<i32>> {
        if self.is_perspective {
            let distance = |level: i32| self.full * (1.0 - 2.0 / f64::exp2(f64::from(level)));
            let is_at = |&level: &i32| self.is_met(body, (distance(level), distance(level + 1)));
            let start = LEVELS.clone().find(is_at)?;
            return Some(start..start + 1);
        }
        let is_at = |&level: &i32| {
            [-1.0, 1.0]
                .into_iter()
                .any(|side| self.is_met(body, self.shell(level, side)))
        };
        let end = LEVELS.clone().rev().find(is_at)? + 1;
        Some(end - 1..end)
    }

    /// The depths of an orthographic level on one side.
    fn shell(&self, level: i32, side: f64) -> (f64, f64) {
        let inner = self.full * f64::exp2(f64::from(level));
        match side < 0.0 {
            true => (-2.0 * inner, -inner),
            false => (inner, 2.0 * inner),
        }
    }

    /// May something of an object be seen between two depths.
    fn is_met(&self, body: &Body, (near, far): (f64, f64)) -> bool {
        if body.reach.0 > far || body.reach.1 < near {
            return false;
        }
        let resolution = [1.0, 1.0, (far - near) / 64.0];
        let cell = cell(self.size(), [near, far]);
        let is_met = |region: &Region| region.existence(cell, resolution) == Existence::Possible;
        body.regions.is_empty() || body.regions.iter().any(is_met)
    }

    /// What an object's depth computes; nothing if it is no root, or nothing of it is on the screen in the range of a level.
    fn computed(&self, object: &FramedObject, level: i32, search: Search) -> Option<Computed> {
        let framed = match object {
            FramedObject::Quadric(q)
            | FramedObject::Patch(q)
            | FramedObject::FirstGeneration(q) => q,
            _ => return None,
        };
        let (quadric, planes) = on_screen(framed, &self.scene.projection);
        if quadric.eye_value().is_zero() {
            return None;
        }
        let ends = Change::to_level(level, self.is_perspective).ends();
        let size = self.size();
        let region = Region::new(&quadric.q, &planes, framed.surface);
        let tangent = planes.is_empty().then(|| Extent::of(&quadric.q)).flatten();
        let tangent = tangent.and_then(|extent| extent.screen_box(size.0, size.1, self.full));
        let window = tangent.unwrap_or_else(|| {
            let cell = cell(size, ends.map(|end| self.full * end));
            region.box_within(cell, size.0, size.1, search)
        });
        (!window.is_empty()).then(|| Computed::on(&quadric, &window, size, self.full))
    }
}

/// Quadric and planes after perspective.
fn on_screen(object: &FramedQuadric, projection: &Projection) -> (ScreenQuadric, Vec<Plane>) {
    let inverse = inverse_distance(projection);
    let planes = object.planes.iter();
    (
        ScreenQuadric::new(&object.quadric, &inverse),
        planes.map(|plane| project_plane(plane, &inverse)).collect(),
    )
}

fn body(object: &FramedObject, projection: &Projection) -> Body {
    let Some(framed) = object.cut_quadric() else {
        let FramedObject::Mesh(mesh) = object else {
            unreachable!("all but meshes are quadrics")
        };
        return between_corners(mesh, projection);
    };
    let (quadric, planes) = on_screen(&framed, projection);
    if is_about_eye(object, projection) {
        return Body {
            regions: walls(&quadric.q, &planes),
            reach: EVERYWHERE,
        };
    }
    let extent = planes.is_empty().then(|| Extent::of(&quadric.q)).flatten();
    Body {
        reach: extent.map_or(EVERYWHERE, |extent| {
            let Cell { centre, half } = extent.cell();
            (centre[2] - half[2], centre[2] + half[2])
        }),
        regions: vec![Region::new(&quadric.q, &planes, framed.surface)],
    }
}

const EVERYWHERE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

/// The faces of a solid: its quadric, and each plane from both sides.
fn walls(quadric: &Quadric, planes: &[Plane]) -> Vec<Region> {
    let of_planes = planes.iter().map(|plane| {
        let mut both = planes.to_vec();
        both.push(plane.opposite());
        Region::new(quadric, &both, Surface::Solid)
    });
    let own = (!quadric.is_everywhere()).then(|| Region::new(quadric, planes, Surface::Patch));
    own.into_iter().chain(of_planes).collect()
}

/// A solid that the eye of a perspective view is in.
fn is_about_eye(object: &FramedObject, projection: &Projection) -> bool {
    let (FramedObject::Quadric(framed) | FramedObject::Polyhedron(framed)) = object else {
        return false;
    };
    let (quadric, planes) = on_screen(framed, projection);
    matches!(projection, Projection::Perspective { .. })
        && framed.surface == Surface::Solid
        && !quadric.eye_value().is_positive()
        && planes.iter().all(|plane| !plane.c.is_negative())
}

/// The depths between which the corners of a mesh lie; a corner that is not in front of the eye is refused later.
fn between_corners(mesh: &FramedMesh, projection: &Projection) -> Body {
    let inverse = inverse_distance(projection);
    let depths = mesh.vertices.iter().filter_map(|[_, _, z]| {
        let share = integer(1) + z * &inverse;
        share.is_positive().then(|| to_f64(&(z / share)))
    });
    let depths: Vec<f64> = depths.collect();
    let least = depths.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Body {
        regions: vec![],
        reach: (least, greatest),
    }
}
