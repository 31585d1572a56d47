//! Objects that nobody sees, found before anything of them is exact.
//!
//! Of a million balls a picture shows some ten thousand. Framing and preparing the others exactly takes most of the
//! time and of the memory, so they are left out first, on bounds in floating point that are proven ([`ball`],
//! [`outline`]): the picture, the range of the depth word and the words of everything else are those of the whole
//! scene. Only balls are left out, and only balls hide others; whatever a bound does not decide is kept.

mod ball;
mod buffer;
mod conic;
mod outline;
mod placed;
mod view;

use super::memory;
use super::range::{self, Depths, frame_keeping};
use super::witness::witnesses;
use ball::Ball;
use buffer::Buffer;
use imogene_algebra::rational::to_f64;
use imogene_golden::format::Format;
use imogene_scene::{
    Absence, Beam, DepthRange, FloatCamera, FramedObject, FramedScene, Light, Material, SceneError,
    SceneFile, Unseen,
};
use outline::{Outline, Span, WordErrors};
use placed::Placed;
use rayon::prelude::*;
use std::borrow::Cow;
use std::sync::Arc;
use view::{DepthWord, View};

/// Words per depth word of the format in which a range is chosen.
const RANGE_FORMAT: Format = Format::BASE;

/// What of a scene may be seen, before it is framed.
pub struct Seen<'a> {
    scene: Cow<'a, SceneFile>,
    size: (u32, u32),
    /// The range of the depth; `None` if all objects are kept.
    range: Option<DepthRange>,
    absent: Vec<Option<Absence>>,
    /// What was framed on the way, if it is framed in that range.
    framed: Option<FramedScene>,
}

impl<'a> Seen<'a> {
    /// Finds what may be seen of a picture of so many columns and lines; `done` is called about once for each of
    /// [`Framing::frame_steps`](crate::Framing::frame_steps), from any thread.
    /// Fails on what the checks of a scene refuse.
    pub fn of(
        file: &'a SceneFile,
        size: (u32, u32),
        format: &Format,
        done: &(impl Fn() + Sync),
    ) -> Result<Seen<'a>, SceneError> {
        file.validate()?;
        let scene = file.flattened();
        let keeps_all = scene.lights.iter().any(has_volumes)
            || !scene.solids.is_empty()
            || scene.materials.iter().any(Material::is_transparent);
        let (range, absent, framed) = if keeps_all {
            (None, vec![None; scene.objects.len()], None)
        } else {
            let balls = Balls::of(&scene, size)?;
            let (range, framed) = balls.range(&scene, done)?;
            let absent = balls.absent(&range, format);
            let is_same = framed.range.near == range.near && framed.range.far == range.far;
            (Some(range), absent, is_same.then_some(framed))
        };
        Ok(Seen {
            scene,
            size,
            range,
            absent,
            framed,
        })
    }

    /// Bytes of memory that framing and preparing it will take at most.
    pub fn memory(&self) -> u64 {
        let objects = self.scene.objects.iter().zip(&self.absent);
        let objects = objects.map(|(object, absent)| (object, absent.is_some()));
        memory::of_objects(&self.scene, objects)
    }

    /// The scene in the camera frame; `done` as in [`Seen::of`].
    /// Fails if an object cannot be had where it is placed.
    pub fn frame(self, done: &(impl Fn() + Sync)) -> Result<FramedScene, SceneError> {
        let Seen {
            scene,
            size,
            range,
            absent,
            framed: before,
        } = self;
        let Some(range) = range else {
            return frame_keeping(&scene, size, |_, _| Ok(None), done);
        };
        let mut framed = scene.frame_within(&range, size, |index, material| {
            let unseen = |why| {
                FramedObject::Unseen(Arc::new(Unseen {
                    name: scene.objects[index].name.as_str().into(),
                    material,
                    why,
                }))
            };
            let is_framed = |framed: &FramedScene| !framed.objects[index].is_unseen();
            let is_known = before.as_ref().is_some_and(is_framed);
            let why = absent[index].or(is_known.then_some(Absence::Hidden));
            Ok(why.map(unseen))
        })?;
        let known = before.into_iter().flat_map(|framed| framed.objects);
        for (index, known) in known.enumerate() {
            if absent[index].is_none() && !known.is_unseen() {
                framed.objects[index] = known;
            }
        }
        framed.range = range;
        Ok(framed)
    }
}

/// Has a light volumes of its own or of the objects in its way?
fn has_volumes(light: &Light) -> bool {
    light.shadows || matches!(light.beam, Beam::Spot { .. })
}

struct Balls {
    balls: Vec<Option<Ball>>,
    camera: FloatCamera,
    is_perspective: bool,
    size: (u32, u32),
}

struct Levels {
    /// It lies between these, if the ball has one at all; `None` if it surely has none.
    ends: Option<[i32; 2]>,
    /// It surely has one.
    is_certain: bool,
}

impl Balls {
    fn of(scene: &SceneFile, size: (u32, u32)) -> Result<Balls, SceneError> {
        let camera = FloatCamera::of(&scene.camera, size.1)?;
        let objects = scene.objects.par_iter();
        Ok(Balls {
            balls: objects.map(|object| Ball::of(object, &camera)).collect(),
            camera,
            is_perspective: scene.camera.is_perspective(),
            size,
        })
    }

    fn view(&self, range: &DepthRange, format: &Format) -> View<'_> {
        View {
            camera: &self.camera,
            width: self.size.0,
            height: self.size.1,
            depth: match self.is_perspective {
                true => DepthWord::Perspective {
                    near: to_f64(&range.near),
                },
                false => DepthWord::Orthographic {
                    middle: range.distance(0.0),
                    half: range.distance(1.0) - range.distance(0.0),
                },
            },
            z_max: format.z_max() as f64,
        }
    }

    /// The range of the depth that the whole scene has, and those objects that may decide it, framed in the range that
    /// is suggested.
    ///
    /// A ball that is not framed has no say in it: its level, if it has one, lies between those of others; no end cuts
    /// it; and f1 and f2 hold in their words, in this range and so in all wider ones, which only draw them nearer to
    /// the far end or to zero. A ball of which that is not certain is framed, and the range chosen again.
    fn range(
        &self,
        scene: &SceneFile,
        done: &(impl Fn() + Sync),
    ) -> Result<(DepthRange, FramedScene), SceneError> {
        let suggested = DepthRange::of_camera(&scene.camera);
        let view = self.view(&suggested, &RANGE_FORMAT);
        let estimate = |ball: &Option<Ball>| {
            let ball = ball.as_ref()?;
            let outline = Outline::of(ball, &view)?;
            Some(levels(ball, &outline, &view))
        };
        let witnesses = witnesses(scene, self.size.1, &suggested);
        let estimates: Vec<Option<Levels>> = self.balls.par_iter().map(estimate).collect();
        let mut is_exact: Vec<bool> = estimates.iter().map(Option::is_none).collect();
        let nobody = Arc::new(Unseen {
            name: "".into(),
            material: 0,
            why: Absence::Hidden,
        });
        loop {
            let framed = scene.frame_within(&suggested, self.size, |index, _| {
                let left_out = FramedObject::Unseen(nobody.clone());
                Ok((!is_exact[index]).then_some(left_out))
            })?;
            let left_out = estimates.iter().zip(&is_exact);
            let certain = left_out.filter_map(|(levels, is_exact)| {
                let levels = levels.as_ref()?;
                levels.ends.filter(|_| levels.is_certain && !is_exact)
            });
            let certain = certain.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]);
            let choice = Depths::new(&framed, &witnesses).choose(certain, done);
            let own = self.view(&suggested.scaled(choice.seen), &RANGE_FORMAT);
            let agrees = |levels: &Levels, ball: &Ball| {
                let is_usual = levels.ends.is_none_or(|[low, high]| {
                    let ends = choice.ends;
                    let within = ends.is_some_and(|[first, last]| low >= first && high <= last);
                    let is_whole = match self.is_perspective {
                        true => low >= choice.level,
                        false => high <= choice.level,
                    };
                    within && is_whole
                });
                is_usual && fits(ball, &own, &view)
            };
            let doubtful: Vec<usize> = (0..self.balls.len())
                .into_par_iter()
                .filter(|&index| {
                    let (Some(levels), Some(ball)) = (&estimates[index], &self.balls[index]) else {
                        return false;
                    };
                    !is_exact[index] && !agrees(levels, ball)
                })
                .collect();
            if doubtful.is_empty() {
                return Ok((choice.range, framed));
            }
            for index in doubtful {
                is_exact[index] = true;
            }
        }
    }

    fn absent(&self, range: &DepthRange, format: &Format) -> Vec<Option<Absence>> {
        let view = self.view(range, format);
        let placed = self.balls.par_iter();
        let placed: Vec<Option<Placed>> = placed
            .map(|ball| Placed::of(ball.as_ref()?, &view, format))
            .collect();
        let buffer = Buffer::of(&placed, &view);
        placed
            .par_iter()
            .map(|placed| {
                let placed = placed.as_ref()?;
                if placed.span == Span::Beside {
                    return Some(Absence::OffScreen);
                }
                buffer.hides(placed).then_some(Absence::Hidden)
            })
            .collect()
    }
}

/// The level of a ball in the range of the view.
fn levels(ball: &Ball, outline: &Outline, view: &View) -> Levels {
    let [low, high] = ball.along_view().map(|z| view.depth_in_pixels(z));
    // The search works with whole pixels of depth around it.
    let wide = [low - 1.01, high + 1.01];
    let ends = range::levels_met(wide, view.full_depth(), view.is_perspective());
    let is_inside = matches!(outline.span(view), Span::Inside(_)) && !view.is_behind(ball);
    let between = ([low, high], 0.01 + 2.0 * ball.spare * view.camera.pixels);
    let is_level =
        |level| range::is_level_of(level, between, view.full_depth(), view.is_perspective());
    Levels {
        is_certain: is_inside && ends.is_some_and(|[first, last]| first == last && is_level(first)),
        ends,
    }
}

/// True if f1 and f2 of a ball surely hold in their words in a range, on its box in the range that is suggested.
fn fits(ball: &Ball, own: &View, suggested: &View) -> bool {
    let (Some(outline), Some(located)) = (Outline::of(ball, own), Outline::of(ball, suggested))
    else {
        return false;
    };
    let window = match located.span(suggested) {
        _ if !located.is_within_ends(suggested, &own.screen()) => own.screen(),
        Span::Beside => return true,
        Span::Inside(window) => window,
        Span::Open => own.screen(),
    };
    let magnitudes = outline.magnitudes(&window, &WordErrors::NONE);
    magnitudes.fit(RANGE_FORMAT.sum, RANGE_FORMAT.quadratic)
}
