//! The range of the depth word, chosen for a scene.
//!
//! What leaves the words of an object is most often the *other* root of its quadric, far from anything visible. In
//! perspective the depth word is of first degree in the inverse of the distance, so a root near the eye, or behind
//! it, is a great number, whatever can be seen; how great follows from the near end alone. So the range is chosen in
//! two steps, by powers of two of what the camera suggests, which keeps it reproducible and most scenes as they are:
//!
//! 1. *What is seen fits.* The near end of a perspective view is nearer than everything on the screen, and of a solid
//!    about the eye nearer than its walls. It is kept if it is not more than 2^[`SPARE`] times nearer than it need
//!    be. An end so near that nothing behind it could be told apart is not taken: 2^[`DEEPEST`] is the most between
//!    it and the object that begins last. An orthographic view covers what the file asks for, or all that ends
//!    somewhere.
//! 2. *What is computed fits.* If f2 or f1 + r of a quadric leaves its word on the object's screen box, the range is
//!    widened, no further than helps and at most by 2^[`WIDEST`]. What then still does not fit is drawn by a quotient
//!    ([`super::quotient`]).

mod levels;
mod words;

use super::context::{Context, Options};
use super::extent::Extent;
use super::perspective::on_screen;
use super::projected::tangent_box;
use super::screen_box::{Region, Search, screen_between};
use super::witness::witnesses;
use crate::cell::Cell;
use imogene_algebra::rational::{integer, to_f64};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{
    CutOff, DepthRange, End, FramedMesh, FramedObject, FramedScene, Plane, Quadric, RangeOrigin,
    SceneError, SceneFile, Surface,
};
use levels::{LEVELS, orthographic_shell, perspective_shell};
pub(super) use levels::{is_level_of, levels_met};
use num_traits::{Signed, Zero};
use rayon::prelude::*;
pub(super) use words::remedy;
use words::{Change, Computed, Limits};

/// Most powers of two between the near end and the nearest point of the object that begins farthest away.
const DEEPEST: i32 = 10;
/// Powers of two by which a near end may be nearer than what is seen.
const SPARE: i32 = 2;
/// Most powers of two by which a range is widened for what is computed: a perspective one, and an orthographic one,
/// which loses less by it.
const WIDEST: [i32; 2] = [4, 8];

/// A checked and flattened scene in the camera frame of a picture, in the range that its camera names or that is chosen
/// for it; `kept` hands out objects that are framed already, by their index, for
/// the range that the camera suggests or names.
pub(crate) fn frame_keeping(
    scene: &SceneFile,
    size: (u32, u32),
    kept: impl Fn(usize, usize) -> Result<Option<FramedObject>, SceneError> + Sync,
    done: &(impl Fn() + Sync),
) -> Result<FramedScene, SceneError> {
    let suggested = DepthRange::of_camera(&scene.camera);
    let mut framed = scene.frame_within(&suggested, size, kept)?;
    let witnesses = witnesses(scene, size.1, &suggested);
    let chosen = Depths::new(&framed, &witnesses).choose(None, done).range;
    if chosen.near != suggested.near || chosen.far != suggested.far {
        framed = scene.frame_within(&chosen, size, |_, _| Ok(None))?;
    }
    framed.range = chosen;
    Ok(framed)
}

/// A scene in the range that its camera suggests, as far as depth is concerned.
pub(super) struct Depths<'a> {
    scene: &'a FramedScene,
    context: Context,
    /// Depth in pixels that fills the word.
    full: f64,
    bodies: Vec<Body>,
}

/// A range, and how it was found.
pub(super) struct Choice {
    pub range: DepthRange,
    pub level: i32,
    /// The level in which all that is seen fits, before it was widened.
    pub seen: i32,
    /// Least and greatest level of all objects that count.
    pub ends: Option<[i32; 2]>,
}

/// Where an object may be.
struct Body {
    /// In one of these parts of screen space, or anywhere if there is none; a solid about the eye stands for its walls.
    regions: Vec<Region>,
    /// Between these depths.
    reach: (f64, f64),
    is_about_eye: bool,
    /// A point that may lie in one of the parts.
    witness: Option<[f64; 3]>,
}

impl Body {
    const NOWHERE: Body = Body {
        regions: vec![],
        reach: (f64::INFINITY, f64::NEG_INFINITY),
        is_about_eye: false,
        witness: None,
    };
}

const EVERYWHERE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

impl<'a> Depths<'a> {
    /// Of a scene in the range that is suggested, with points that may lie in its objects.
    pub fn new(scene: &'a FramedScene, witnesses: &[Option<[f64; 3]>]) -> Depths<'a> {
        // In depths that fill the word, all formats of the catalogue hold the same.
        let context = Context::of(scene, Format::BASE, Options::default());
        let objects = scene.objects.par_iter();
        Depths {
            scene,
            full: to_f64(&context.full_depth),
            bodies: objects
                .zip(witnesses)
                .map(|(object, witness)| Body {
                    witness: *witness,
                    ..body(object, &context)
                })
                .collect(),
            context,
        }
    }

    /// The range for the objects, and for others of which only the least and the greatest level is known.
    ///
    /// `done` is called about twice for each object.
    pub fn choose(&self, others: Option<[i32; 2]>, done: &(impl Fn() + Sync)) -> Choice {
        let suggested = &self.scene.range;
        let levels = self.bodies.par_iter().map(|body| {
            let level = self.level(body);
            done();
            level
        });
        let levels: Vec<Option<i32>> = levels.collect();
        let others = others.into_iter().flatten();
        let ends = self.ends(levels.iter().flatten().copied().chain(others));
        let (seen, level) = match suggested.origin {
            RangeOrigin::Hand => (0, 0),
            _ => {
                let seen = self.seen(ends);
                (seen, self.widened(seen, done))
            }
        };
        let mut range = suggested.scaled(level);
        range.cut = self.cut(&levels, level);
        Choice {
            range,
            level,
            seen,
            ends,
        }
    }

    /// Least and greatest of the levels; of an orthographic view only of those that end somewhere.
    fn ends(&self, levels: impl Iterator<Item = i32>) -> Option<[i32; 2]> {
        let levels = levels.filter(|&end| self.context.perspective || end < LEVELS.end);
        levels.fold(None, |ends, level| {
            let [first, last] = ends.unwrap_or([level; 2]);
            Some([first.min(level), last.max(level)])
        })
    }

    /// The level of the range in which all that is seen fits, as far as it can.
    fn seen(&self, ends: Option<[i32; 2]>) -> i32 {
        let is_named = !self.context.perspective && self.scene.range.origin == RangeOrigin::Camera;
        match ends {
            Some([_, last]) if !self.context.perspective && !is_named => last,
            Some([first, last]) if self.context.perspective && !(0..=SPARE).contains(&first) => {
                first.max(last - DEEPEST)
            }
            _ => 0,
        }
    }

    /// The same, widened until f2 and f1 + r of as many objects as possible stay in their words.
    fn widened(&self, level: i32, done: &(impl Fn() + Sync)) -> i32 {
        let (step, widest) = match self.context.perspective {
            true => (-1, WIDEST[0]),
            false => (1, WIDEST[1]),
        };
        let limits = Limits::of(&self.context.format);
        let own = Change::to_level(level, &self.context);
        let computed = |search| -> Vec<Computed> {
            let objects = self.scene.objects.par_iter();
            objects
                .filter_map(|object| {
                    let fits = |computed: &Computed| computed.fits(own, &limits);
                    let computed = self.computed(object, level + step * widest, search, &fits);
                    done();
                    computed
                })
                .collect()
        };
        let misfits = |computed: &[Computed], level: i32| {
            let change = Change::to_level(level, &self.context);
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
    fn cut(&self, levels: &[Option<i32>], level: i32) -> Vec<CutOff> {
        let objects = self.scene.objects.iter().zip(&self.bodies).zip(levels);
        objects
            .flat_map(|((object, body), own)| {
                let ends = own.map_or(vec![], |own| self.ends_that_cut(body, own, level));
                ends.into_iter().map(|end| CutOff {
                    object: object.name().to_owned(),
                    end,
                })
            })
            .collect()
    }

    fn ends_that_cut(&self, body: &Body, own: i32, level: i32) -> Vec<End> {
        if self.context.perspective {
            let is_cut = own < level || body.is_about_eye;
            return is_cut.then_some(End::Near).into_iter().collect();
        }
        let beyond = |(_, side): &(End, f64)| {
            (level..own).any(|level| self.is_met(body, self.shell(level, *side)))
        };
        let sides = [(End::Near, -1.0), (End::Far, 1.0)].into_iter();
        sides.filter(beyond).map(|(end, _)| end).collect()
    }

    /// The level of the range that an object asks for; `None` if none of it is on the screen. In perspective nothing
    /// of it is nearer than 2^level near ends; else nothing is farther than 2^level half depths from the screen
    /// plane.
    fn level(&self, body: &Body) -> Option<i32> {
        if self.context.perspective {
            let is_at = |&level: &i32| self.is_met(body, perspective_shell(level, self.full));
            return LEVELS.clone().find(is_at);
        }
        let is_at = |&level: &i32| {
            let mut sides = [-1.0, 1.0].into_iter();
            sides.any(|side| self.is_met(body, self.shell(level, side)))
        };
        LEVELS.clone().rev().find(is_at).map(|level| level + 1)
    }

    /// The depths between an orthographic level and the next, on one side.
    fn shell(&self, level: i32, side: f64) -> [f64; 2] {
        let [inner, outer] = orthographic_shell(level, self.full);
        match side < 0.0 {
            true => [-outer, -inner],
            false => [inner, outer],
        }
    }

    /// May something of an object be seen between two depths.
    fn is_met(&self, body: &Body, [near, far]: [f64; 2]) -> bool {
        if body.reach.0 > far || body.reach.1 < near {
            return false;
        }
        let resolution = [1.0, 1.0, (far - near) / 64.0];
        let cell = screen_between(self.scene.width, self.scene.height, [near, far]);
        let witness = body.witness.filter(|point| cell.holds(point));
        if witness.is_some_and(|point| body.regions.iter().any(|region| region.holds(point))) {
            return true;
        }
        let is_met = |region: &Region| region.may_be_in(cell, resolution);
        body.regions.is_empty() || body.regions.iter().any(is_met)
    }

    /// What an object's depth computes; `None` if it is no root, or nothing of it is on the screen in the range of a
    /// level, or if it fits wherever it is on the screen: then it fits in wider ranges, too, and need not be searched.
    fn computed(
        &self,
        object: &FramedObject,
        level: i32,
        search: Search,
        fits: &impl Fn(&Computed) -> bool,
    ) -> Option<Computed> {
        let (FramedObject::Quadric(framed)
        | FramedObject::Patch(framed)
        | FramedObject::FirstGeneration(framed)) = object
        else {
            return None;
        };
        let (quadric, planes) = on_screen(
            &framed.quadric,
            &framed.planes,
            &self.context.inverse_distance,
        );
        if quadric.eye_value().is_zero() {
            return None;
        }
        let on = |window: &ScreenBox| Computed::on(&quadric, window, &self.context);
        let (width, height) = (self.scene.width, self.scene.height);
        let window = match tangent_box(&quadric, &planes, &self.context) {
            Some(window) => window,
            None if fits(&on(&ScreenBox::of_screen(width, height))) => return None,
            None => {
                let ends = Change::to_level(level, &self.context).ends(&self.context);
                let region = Region::new(&quadric.q, &planes, framed.surface);
                region.box_within(screen_between(width, height, ends), width, height, search)
            }
        };
        (!window.is_empty()).then(|| on(&window))
    }
}

fn body(object: &FramedObject, context: &Context) -> Body {
    let framed = match (object, object.cut_quadric()) {
        (_, Some(framed)) => framed,
        (FramedObject::Mesh(mesh), None) => return between_corners(mesh, context),
        _ => return Body::NOWHERE,
    };
    let (quadric, planes) = on_screen(&framed.quadric, &framed.planes, &context.inverse_distance);
    let eye_is_inside =
        !quadric.eye_value().is_positive() && planes.iter().all(|plane| !plane.c.is_negative());
    if context.perspective && framed.surface == Surface::Solid && eye_is_inside {
        return Body {
            regions: walls(&quadric.q, &planes),
            reach: EVERYWHERE,
            is_about_eye: true,
            ..Body::NOWHERE
        };
    }
    let extent = planes.is_empty().then(|| Extent::of(&quadric.q)).flatten();
    let around = extent.and_then(|extent| extent.cell());
    Body {
        reach: around.map_or(EVERYWHERE, |Cell { centre, half }| {
            (centre[2] - half[2], centre[2] + half[2])
        }),
        regions: vec![Region::new(&quadric.q, &planes, framed.surface)],
        ..Body::NOWHERE
    }
}

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

/// The depths between which the corners of a mesh lie; a corner that is not in front of the eye is refused later.
fn between_corners(mesh: &FramedMesh, context: &Context) -> Body {
    let depths = mesh.vertices.iter().filter_map(|[_, _, z]| {
        let share = integer(1) + z * &context.inverse_distance;
        share.is_positive().then(|| to_f64(&(z / share)))
    });
    let depths: Vec<f64> = depths.collect();
    let least = depths.iter().copied().fold(f64::INFINITY, f64::min);
    let greatest = depths.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Body {
        reach: (least, greatest),
        ..Body::NOWHERE
    }
}
