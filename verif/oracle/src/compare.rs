//! A golden picture held against the traced one.
//!
//! The *band* is where an edge is met within a pixel: a pixel is in it if one of the eight about it, or it, sees in
//! the traced picture another object, another face, another facet or the background. Outside it golden and traced
//! picture must show the same face of the same object; inside it they may differ. A thin facet that is between the
//! pixels for the tracer is seen at none of them; rounded, it may be seen. So a pixel is in the band as well if the
//! golden picture shows an object there of which a facet comes as near as its corners are rounded, at the depth of
//! that facet. Wherever they show the same face, their depths may differ by the proven bound of that face at that
//! pixel and no more.
//!
//! Two faces may coincide, as those of the cells that one CAD face is divided into, or of two objects that touch. A
//! pixel is *tied* if the face that the golden picture shows is there for the tracer as well, and nearer to the one
//! that it sees than the bounds of both allow to tell: rounded words cannot know which is first. Of a facet it is
//! enough that it is at one of the eight pixels about it, with the depth it has one pixel on, and that no nearer face
//! is seen: its corners are rounded.
//!
//! A pixel is *announced* if `imogene check` says beforehand, from the words alone, that rounding may change its face:
//! so an outline has its own stated band, wider than a pixel where the words are too short for the object.
//!
//! A transparent object is compared as if it were alone. Then the colours are compared, wherever the faces are the same
//! and no two of them are so near to each other that words cannot tell which is first.

mod colours;

use crate::bounds::Bounds;
use crate::colour::Colours;
use crate::trace::{Traced, TracedPixel, Tracer};
use imogene_analysis::bounds::Jury;
use imogene_golden::machine::frame::Frame;
use serde::Serialize;

/// Pixels that a corner of a facet is off at most, across and down: half a sixteenth.
const CORNER: f64 = 1.0 / 32.0;
/// Levels to which a colour is known that is said to be known.
pub const CLOSE_LEVELS: f64 = 4.0;
const LISTED: usize = 16;

/// What a pixel is; of several pictures the last of these. The first two show the same face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Mark {
    /// Alike, outside the band.
    Alike,
    /// Alike, in the band.
    Band,
    /// Different, in the band.
    Inside,
    /// Different, outside the band, of two faces that the words cannot tell apart.
    Tied,
    /// Different, outside the band, as the check says that it may be.
    Announced,
    /// Different, outside the band.
    Outside,
    /// The same face at a depth beyond its bound.
    Depth,
    /// The same faces in a colour beyond its bound.
    Colour,
}

/// A picture of opaque objects, or of one transparent object: as traced, as golden, and what is announced of it.
pub struct Pair<'a> {
    /// The traced one.
    pub traced: Traced,
    /// The golden one.
    pub golden: Frame,
    /// What is proven of its objects.
    pub jury: Jury<'a>,
}

/// The golden colours of a picture, and those of the tracer.
pub struct Painted {
    /// Red, green and blue of every pixel, row-major.
    pub golden: Vec<u8>,
    /// The rule.
    pub colours: Colours,
}

/// One side of a difference.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Seen {
    /// Index of the object, -1 for the background.
    pub object: i64,
    /// Number of the face.
    pub number: u8,
    /// Depth in depth words.
    pub depth: f64,
}

/// A pixel that must not differ and does.
#[derive(Clone, Debug, Serialize)]
pub struct Difference {
    /// Column.
    pub x: usize,
    /// Line.
    pub y: usize,
    /// What the golden picture shows.
    pub golden: Seen,
    /// What the tracer sees.
    pub traced: Seen,
    /// The depth bound, if both show the same face.
    pub bound: Option<f64>,
    /// Golden colour, and the least and greatest level of each component for the tracer, if that is what differs.
    pub colour: Option<([u8; 3], [[f64; 2]; 3])>,
}

/// What was found.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Comparison {
    /// Pixels of the picture.
    pub pixels: usize,
    /// Pixels at which the tracer sees an object that nothing is seen through.
    pub covered: usize,
    /// Pixels of transparent objects, hidden ones too: each is compared as if it were alone, and counts below.
    pub transparent: usize,
    /// Pixels that needed exact arithmetic.
    pub solved_exactly: usize,
    /// Pixels in the band.
    pub band: usize,
    /// Pixels in the band that differ.
    pub differences_inside: usize,
    /// Of these, pixels where one picture shows the background.
    pub mask_differences_inside: usize,
    /// Pixels outside the band that show the other one of two faces whose depths are within the bounds of both.
    pub tied: usize,
    /// Pixels outside the band that differ and of which the check says that rounding may change their face.
    pub announced: usize,
    /// Pixels outside the band that differ otherwise: none is allowed.
    pub differences_outside: usize,
    /// Pixels at which depths were compared.
    pub depths: usize,
    /// Pixels whose depth is beyond its bound: none is allowed.
    pub depths_beyond_bound: usize,
    /// Greatest difference of depths outside the band, in depth words.
    pub depth_error: f64,
    /// Greatest bound outside the band.
    pub depth_bound: f64,
    /// Greatest ratio of a difference of depths to its bound.
    pub depth_ratio: f64,
    /// Pixels at which colours were compared.
    pub colours: usize,
    /// Pixels whose colour is beyond its bound: none is allowed.
    pub colours_beyond_bound: usize,
    /// Of these, pixels known to within [`CLOSE_LEVELS`]; others are at outlines, in steep highlights or grazed.
    pub colours_known: usize,
    /// Greatest difference of a golden component from the middle of what is known there, in levels.
    pub colour_error: f64,
    /// The first differences that are not allowed.
    pub first: Vec<Difference>,
}

impl Comparison {
    /// True if nothing differs that must not.
    pub fn holds(&self) -> bool {
        self.differences_outside == 0
            && self.depths_beyond_bound == 0
            && self.colours_beyond_bound == 0
    }

    fn list(&mut self, difference: Difference) {
        if self.first.len() < LISTED {
            self.first.push(difference);
        }
    }
}

/// All pictures of a scene.
pub struct Pictures<'a> {
    /// Who drew the traced ones.
    pub tracer: Tracer,
    /// How far golden depths and normals may be off.
    pub bounds: Bounds,
    /// First that of the opaque objects, then one for each transparent object.
    pub pairs: Vec<Pair<'a>>,
    /// The colours, if the tracer has them.
    pub painted: Option<Painted>,
}

/// Compares the pictures of a scene; the marks are those of the pixels, row-major.
pub fn compare(pictures: &Pictures) -> (Comparison, Vec<Mark>) {
    let Pictures { tracer, bounds, .. } = pictures;
    let pairs = pictures.pairs.split_first();
    let (first, layers) = pairs.expect("there are opaque objects, or none");
    let covered = |pair: &Pair| pair.traced.pixels.iter().flatten().count();
    let mut found = Comparison {
        pixels: first.traced.pixels.len(),
        covered: covered(first),
        transparent: layers.iter().map(covered).sum(),
        solved_exactly: pictures.pairs.iter().map(|pair| pair.traced.solved).sum(),
        ..Comparison::default()
    };
    let judges = pictures.pairs.iter().map(|pair| Judge {
        tracer,
        bounds,
        pair,
    });
    let judges: Vec<Judge> = judges.collect();
    let width = first.traced.width;
    let mut marks = vec![Mark::Alike; found.pixels];
    for judge in &judges {
        for (index, mark) in marks.iter_mut().enumerate() {
            let at = (index % width, index / width);
            *mark = judge.pixel(&mut found, at).max(*mark);
        }
    }
    if let Some(painted) = &pictures.painted {
        found.add_colours(&judges, painted, &mut marks);
    }
    (found, marks)
}

/// Both pictures, and what their pixels are judged by.
struct Judge<'a> {
    tracer: &'a Tracer,
    bounds: &'a Bounds,
    pair: &'a Pair<'a>,
}

impl Judge<'_> {
    fn pixel(&self, found: &mut Comparison, (x, y): (usize, usize)) -> Mark {
        let index = y * self.pair.traced.width + x;
        let seen = self.pair.traced.pixels[index];
        let mut difference = self.difference((x, y), seen);
        let (one, other) = (difference.golden, difference.traced);
        let differs = (one.object, one.number) != (other.object, other.number);
        let in_band =
            is_in_band(&self.pair.traced, x, y) || (differs && self.is_grazed(&one, (x, y)));
        found.band += usize::from(in_band);
        if differs {
            if in_band {
                found.differences_inside += 1;
                let mask = (one.object < 0) != (other.object < 0);
                found.mask_differences_inside += usize::from(mask);
                return Mark::Inside;
            }
            if seen.is_some_and(|traced| self.is_tied(&one, &traced, (x, y))) {
                found.tied += 1;
                return Mark::Tied;
            }
            if self.pair.jury.is_undecided(x as i64, y as i64) {
                found.announced += 1;
                return Mark::Announced;
            }
            found.differences_outside += 1;
            found.list(difference);
            return Mark::Outside;
        }
        let alike = if in_band { Mark::Band } else { Mark::Alike };
        let Some(pixel) = seen else { return alike };
        if in_band && self.bounds.is_of_facets(pixel.object) {
            // A golden pixel does not say of which facet it is, and the one beside may be seen.
            return alike;
        }
        let bound = self.bound(&pixel, (x, y));
        let error = (one.depth - other.depth).abs();
        found.depths += 1;
        if !in_band {
            found.depth_error = found.depth_error.max(error);
            found.depth_bound = found.depth_bound.max(bound);
        }
        let slack = self.slack(&pixel);
        if bound > 0.0 {
            found.depth_ratio = found.depth_ratio.max((error - slack) / bound);
        }
        if error <= bound + slack {
            return alike;
        }
        found.depths_beyond_bound += 1;
        difference.bound = Some(bound);
        found.list(difference);
        Mark::Depth
    }

    fn difference(&self, (x, y): (usize, usize), seen: Option<TracedPixel>) -> Difference {
        let (index, golden) = (y * self.pair.traced.width + x, &self.pair.golden);
        Difference {
            x,
            y,
            golden: Seen {
                object: i64::from(golden.id[index]),
                number: golden.number[index],
                depth: golden.depth[index] as f64,
            },
            traced: Seen {
                object: seen.map_or(-1, |pixel| i64::from(pixel.object)),
                number: seen.map_or(0, |pixel| pixel.number),
                depth: seen.map_or(self.bounds.z_max, |pixel| self.depth(&pixel)),
            },
            bound: None,
            colour: None,
        }
    }

    /// The depth of a traced pixel in depth words.
    fn depth(&self, p: &TracedPixel) -> f64 {
        p.depth.middle() * self.bounds.z_max
    }

    fn bound(&self, p: &TracedPixel, (x, y): (usize, usize)) -> f64 {
        let at = (x as i64, y as i64);
        self.bounds.at(p.object, p.number, p.part, at)
    }

    /// How closely the tracer knows a depth, in depth words, and some units in the last place of the depth range: for
    /// differences in floating point, and for rotations, which the preparation computes by other formulas.
    fn slack(&self, pixel: &TracedPixel) -> f64 {
        let z_max = self.bounds.z_max;
        0.5 * pixel.depth.width() * z_max + 16.0 * f64::EPSILON * z_max
    }

    /// Whether the golden picture shows a face that is there at its depth, as near to the traced one as both bounds.
    fn is_tied(&self, golden: &Seen, traced: &TracedPixel, (x, y): (usize, usize)) -> bool {
        let Ok(object) = u32::try_from(golden.object) else {
            return false;
        };
        let bound = |p: &TracedPixel| self.bound(p, (x, y)) + self.slack(p);
        if let Some(other) = self.tracer.alone(object, x as u32, y as u32) {
            let (own, depth) = (bound(&other), self.depth(&other));
            let is_it = other.number == golden.number && (golden.depth - depth).abs() <= own;
            return is_it && (depth - self.depth(traced)).abs() <= own + bound(traced);
        }
        // Corners of a facet are on a grid, so that it may reach beyond its true edge.
        let mut about = (x.saturating_sub(1)..=x + 1)
            .flat_map(|u| (y.saturating_sub(1)..=y + 1).map(move |v| (u as u32, v as u32)));
        golden.depth <= self.depth(traced) + bound(traced)
            && about.any(|(u, v)| {
                let beside = self.tracer.alone(object, u, v);
                beside.is_some_and(|other| {
                    let reach = self.bounds.one_pixel_on(object, other.part);
                    let off = (golden.depth - self.depth(&other)).abs();
                    other.number == golden.number && reach.is_some_and(|reach| off <= reach)
                })
            })
    }

    /// Whether the golden picture shows, at its depth, a facet as near to the pixel as its corners may be off.
    fn is_grazed(&self, golden: &Seen, (x, y): (usize, usize)) -> bool {
        let object = u32::try_from(golden.object).ok();
        let Some(object) = object.filter(|&object| self.bounds.is_of_facets(object)) else {
            return false;
        };
        let place = (x as u32, y as u32);
        let near = self.tracer.facets_near(object, place, CORNER);
        near.into_iter().any(|(part, depth)| {
            let facet = TracedPixel {
                object,
                number: golden.number,
                part,
                depth,
            };
            let bound = self.bound(&facet, (x, y)) + self.slack(&facet);
            (golden.depth - self.depth(&facet)).abs() <= bound
        })
    }
}

/// Whether one of the pixels about a pixel sees something else than it does.
pub fn is_in_band(traced: &Traced, x: usize, y: usize) -> bool {
    let face = |index: usize| traced.pixels[index].map(|p| (p.object, p.number, p.part));
    let own = y * traced.width + x;
    let mut all = about(own, traced.width, traced.height);
    all.any(|index| face(index) != face(own))
}

/// A pixel of a picture and the eight about it, as far as there are such, row by row.
pub(crate) fn about(index: usize, width: usize, height: usize) -> impl Iterator<Item = usize> {
    let (x, y) = (index % width, index / width);
    let lines = y.saturating_sub(1)..=(y + 1).min(height - 1);
    let columns = x.saturating_sub(1)..=(x + 1).min(width - 1);
    lines.flat_map(move |v| columns.clone().map(move |u| v * width + u))
}
