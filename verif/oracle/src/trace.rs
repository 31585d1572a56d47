//! A picture by rays: cells of pixels, quartered until few objects are left, then pixels, exactly where needed.
//!
//! An object leaves the list of a cell when intervals prove that it is nowhere on it, or behind another that is
//! everywhere on it. Nothing is left open: exact arithmetic always decides, so no pixel of the result is uncertain.

use crate::body::Body;
use crate::camera::Sight;
use crate::interval::Interval;
use crate::solid::{Member, SolidBody};
use crate::verdict::{Ends, Solved, Verdict};
use imogene_scene::{DepthRange, Material, Object, SceneFile};
use num_traits::Signed;
use rayon::prelude::*;

/// Side of the cells that are drawn side by side, in pixels.
const LARGEST: u32 = 64;
/// Side of cells that are not quartered further.
const SMALLEST: u32 = 4;
/// A depth known less closely, as a share of the greatest word, comes from the exact root: 2^-13 words of 24 bits.
const CLOSE: f64 = 1.0 / (1u64 << 36) as f64;

/// What is seen at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TracedPixel {
    /// Index of the object in the scene.
    pub object: u32,
    /// Number of its face: 0 and 1 the near and far side of a quadric, 2 + i its cut i, 15 the near end of the depth.
    pub number: u8,
    /// Facet of a mesh; 0 else.
    pub part: u32,
    /// Depth as a share of the greatest depth word, -1 to 1.
    pub depth: Interval,
}

/// A picture.
#[derive(Clone, Debug)]
pub struct Traced {
    /// Columns.
    pub width: usize,
    /// Lines.
    pub height: usize,
    /// Pixels, row-major; nothing where the background is seen.
    pub pixels: Vec<Option<TracedPixel>>,
    /// Pixels at which exact arithmetic was needed.
    pub solved: usize,
}

/// A scene, ready to be traced.
#[derive(Debug)]
pub struct Tracer {
    /// The lines of sight.
    pub sight: Sight,
    /// Bodies: objects, and facets of meshes.
    pub bodies: Vec<(u32, Body)>,
    /// Objects that something is seen through, in ascending order.
    pub glass: Vec<u32>,
    solids: Vec<SolidBody>,
    ends: Ends,
}

/// A pixel, and whether it was solved exactly.
type Drawn = (Option<TracedPixel>, bool);

impl Tracer {
    /// A scene that was read and checked, for a picture of `width` x `height` pixels whose depth words cover a range.
    pub fn new(scene: &SceneFile, range: &DepthRange, width: u32, height: u32) -> Tracer {
        let scene = scene.flattened();
        let sight = Sight::new(&scene.camera, range, width, height);
        let own = |(id, object)| -> Vec<(u32, Body)> {
            let bodies = Body::of(object, &sight).into_iter();
            bodies.map(|body| (id as u32, body)).collect()
        };
        let bodies: Vec<_> = scene.objects.par_iter().enumerate().map(own).collect();
        let solids = scene.solids.iter();
        let solids = solids.map(|solid| SolidBody::new(&solid.of, &scene.objects));
        let objects = (0..).zip(&scene.objects);
        let glass = objects.filter(|(_, object)| material(&scene, object).is_transparent());
        Tracer {
            glass: glass.map(|(id, _)| id).collect(),
            ends: sight.ends(),
            bodies: bodies.into_iter().flatten().collect(),
            solids: solids.collect(),
            sight,
        }
    }

    /// Draws all that nothing is seen through; `done` is called for each of [`Tracer::steps`], from any thread.
    pub fn draw(&self, done: impl Fn() + Sync) -> Traced {
        self.picture(&self.opaque(), done)
    }

    /// Draws one object alone.
    pub fn draw_alone(&self, object: u32) -> Traced {
        self.picture(&self.of(|id| id == object), || ())
    }

    fn opaque(&self) -> Vec<u32> {
        self.of(|id| !self.glass.contains(&id))
    }

    /// The indices of the bodies of some objects.
    fn of(&self, takes: impl Fn(u32) -> bool) -> Vec<u32> {
        let bodies = (0..).zip(&self.bodies);
        let own = bodies.filter(|(_, (id, _))| takes(*id));
        own.map(|(index, _)| index).collect()
    }

    fn picture(&self, all: &[u32], done: impl Fn() + Sync) -> Traced {
        let (width, height) = (self.sight.width, self.sight.height);
        let steps = |end: u32| (0..end).step_by(LARGEST as usize);
        let cells = steps(height).flat_map(|y| steps(width).map(move |x| (x, y)));
        let cells: Vec<(u32, u32)> = cells.collect();
        let drawn = cells.par_iter().map(|&(x, y)| {
            let to = [(x + LARGEST).min(width), (y + LARGEST).min(height)];
            let mut pixels = vec![];
            self.area([[x, y], to], all, &mut pixels);
            done();
            pixels
        });
        let drawn: Vec<Vec<((u32, u32), Drawn)>> = drawn.collect();
        let mut picture = Traced {
            width: width as usize,
            height: height as usize,
            pixels: vec![None; width as usize * height as usize],
            solved: 0,
        };
        for ((x, y), (pixel, solved)) in drawn.into_iter().flatten() {
            picture.pixels[(y * width + x) as usize] = pixel;
            picture.solved += usize::from(solved);
        }
        picture
    }

    /// What is seen at one pixel of all that nothing is seen through.
    pub fn at(&self, x: u32, y: u32) -> Option<TracedPixel> {
        self.pixel(x, y, &self.opaque()).0
    }

    /// What one object alone shows at a pixel, in exact arithmetic.
    pub fn alone(&self, object: u32, x: u32, y: u32) -> Option<TracedPixel> {
        // One of a solid is asked for with all others of it.
        let solid = self.solids.iter().find(|solid| solid.has(object));
        let list = self.of(|id| id == object || solid.is_some_and(|solid| solid.has(id)));
        self.solve(x, y, &list)
    }

    /// The facets of an object within `reach` of a pixel, across and down: number, and depth of the plane there.
    pub fn facets_near(&self, object: u32, (x, y): (u32, u32), reach: f64) -> Vec<(u32, Interval)> {
        let place = self.sight.place(x, y);
        let own = self.bodies.iter().filter(|(id, _)| *id == object);
        let near = own.filter_map(|(_, body)| match body {
            Body::Facet(facet) => Some((facet.part, facet.near(place, 2.0 * reach)?)),
            Body::Cut(_) => None,
        });
        near.map(|(part, t)| (part, self.sight.depth(t))).collect()
    }

    /// True for a body that is not seen by itself.
    fn is_member(&self, index: u32) -> bool {
        let (object, _) = self.bodies[index as usize];
        self.solids.iter().any(|solid| solid.has(object))
    }

    /// The parameters at which a line of sight is within `reach` of what is seen, which is a share of the depth, and
    /// the normal of what is seen; nothing for a facet.
    pub fn normal(
        &self,
        x: u32,
        y: u32,
        seen: &TracedPixel,
        reach: f64,
    ) -> Option<(Interval, [Interval; 3])> {
        let mut bodies = self.bodies.iter();
        let (_, body) = bodies.find(|(object, _)| *object == seen.object)?;
        let true_t = self.sight.parameter(seen.depth);
        let normal = body.normal(self.sight.place(x, y), seen.number, true_t)?;
        Some((self.sight.parameter(seen.depth.widened(reach)), normal))
    }

    /// Steps of [`Tracer::draw`], for a bar of its progress.
    pub fn steps(&self) -> u64 {
        let cells = |pixels: u32| u64::from(pixels.div_ceil(LARGEST));
        cells(self.sight.width) * cells(self.sight.height)
    }

    /// The bodies of a list that intervals do not rule out on an area, with what they say of them.
    fn left(&self, list: &[u32], [from, to]: Area) -> Vec<(u32, Verdict)> {
        let cell = self.sight.cell(from, to.map(|end| end - 1));
        let mut limit = f64::INFINITY;
        let mut left = vec![];
        for &index in list {
            let verdict = self.bodies[index as usize].1.decide(&cell);
            match verdict {
                Verdict::Absent => continue,
                Verdict::Hit { t, .. } if !self.is_member(index) => limit = limit.min(t.hi),
                _ => {}
            }
            left.push((index, verdict));
        }
        left.retain(|(_, verdict)| match verdict {
            Verdict::Hit { t, .. } => t.lo <= limit,
            Verdict::Open(from) => *from <= limit,
            Verdict::Absent => false,
        });
        left
    }

    fn area(&self, area: Area, list: &[u32], pixels: &mut Vec<((u32, u32), Drawn)>) {
        if list.is_empty() {
            return;
        }
        let left = self.left(list, area);
        let list: Vec<u32> = left.iter().map(|(index, _)| *index).collect();
        let [[x0, y0], [x1, y1]] = area;
        if x1 - x0 <= SMALLEST && y1 - y0 <= SMALLEST {
            for y in y0..y1 {
                for x in x0..x1 {
                    pixels.push(((x, y), self.pixel(x, y, &list)));
                }
            }
        } else {
            let (x, y) = ((x0 + x1).div_ceil(2), (y0 + y1).div_ceil(2));
            for (y0, y1) in [(y0, y), (y, y1)] {
                for (x0, x1) in [(x0, x), (x, x1)] {
                    if x0 < x1 && y0 < y1 {
                        self.area([[x0, y0], [x1, y1]], &list, pixels);
                    }
                }
            }
        }
    }

    fn pixel(&self, x: u32, y: u32, list: &[u32]) -> Drawn {
        let left = self.left(list, [[x, y], [x + 1, y + 1]]);
        if left.is_empty() {
            return (None, false);
        }
        if let [(index, Verdict::Hit { t, number, part })] = left[..]
            && !self.is_member(index)
        {
            let depth = self.sight.depth(t);
            if depth.width() <= CLOSE {
                let pixel = TracedPixel {
                    object: self.bodies[index as usize].0,
                    number,
                    part,
                    depth,
                };
                return (Some(pixel), false);
            }
        }
        let list: Vec<u32> = left.iter().map(|(index, _)| *index).collect();
        (self.solve(x, y, &list), true)
    }

    /// A pixel in exact arithmetic.
    fn solve(&self, x: u32, y: u32, list: &[u32]) -> Option<TracedPixel> {
        let (x, y) = self.sight.place(x, y);
        let (mut members, mut met): (Vec<Member>, Vec<(u32, Solved)>) = (vec![], vec![]);
        for &index in list {
            let (object, body) = &self.bodies[index as usize];
            if !self.is_member(index) {
                let first = body.solve(x, y, &self.ends);
                met.extend(first.map(|first| (*object, first)));
            } else if let Body::Cut(body) = body {
                members.push((*object, body));
            }
        }
        let solids = self.solids.iter();
        met.extend(solids.filter_map(|solid| solid.solve(&members, (x, y), &self.ends)));
        // The lists are in the order of the scene: of two equal depths the first object is seen.
        let nearest = met.into_iter().min_by(|a, b| a.1.t.compare(&b.1.t));
        nearest.map(|(object, found)| TracedPixel {
            object,
            number: found.number,
            part: found.part,
            depth: self.closely(&found),
        })
    }

    /// The depth of an exact hit, to within [`CLOSE`].
    fn closely(&self, found: &Solved) -> Interval {
        let mut bits = 64;
        loop {
            let (low, high) = found.t.between(bits);
            if !self.sight.perspective || low.is_positive() {
                let ends = [low, high].map(|t| Interval::about(&self.sight.exact_depth(&t)));
                let depth = Interval::new(ends[0].lo, ends[1].hi);
                if depth.width() <= CLOSE {
                    return depth;
                }
            }
            bits *= 2;
        }
    }
}

pub(crate) fn material<'a>(scene: &'a SceneFile, object: &Object) -> &'a Material {
    let mut materials = scene.materials.iter();
    let own = materials.find(|material| material.name == object.material);
    own.expect("checked: every material exists")
}

/// Pixels from one column and line to before another.
type Area = [[u32; 2]; 2];
