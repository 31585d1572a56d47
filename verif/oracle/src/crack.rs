//! Cracks of a picture, from its depths and faces alone; no reference is needed (Claux, section IV.2.2).
//!
//! The printed rule: a pixel is flagged if two opposite neighbours of the eight about it are both nearer to the camera
//! by at least a minimum distance, and neither shows its face. Both sides, because beside an outline one side only is
//! nearer; another face, because a steep face is no crack.
//!
//! *Convex solids are never flagged.* In the space of column, line and depth word, in which a solid that is convex
//! before perspective is convex too, the point between two points of the front is inside or behind it: the pixel
//! between is covered, and not behind both.
//!
//! *Beyond the printed rule* (`width` above 1): a crack of w pixels is met by looking past it, at two pixels on a line
//! through the pixel, one on each side, at most w + 1 apart. The proof for convex solids is the same. Beyond it too, a
//! flagged pixel is told to be a crack or the end of a notch ([`Crack::notch`]): two outlines that meet at a sharp
//! angle leave a background one pixel wide, which the printed rule takes for a crack. (The measure
//! [`imogene_analysis::metrics`] calls by the same name compares with the true picture.)

use crate::compare::about;
use crate::repair::face;
use crate::trace::Tracer;
use imogene_golden::machine::frame::Frame;
use imogene_scene::{Camera, DepthRange};
use serde::Serialize;
use std::collections::HashMap;

/// Directions to one of each two opposite neighbours.
pub(crate) const DIRECTIONS: [(i64, i64); 4] = [(1, 0), (0, 1), (1, 1), (1, -1)];

/// What counts as a crack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rule {
    /// Least distance, in scene units along the view, by which both sides are nearer.
    pub min_distance: f64,
    /// Greatest width of a crack in pixels; 1 is the printed rule.
    pub width: usize,
}

/// What is searched: a distance from the observer and a face for every pixel, row-major.
#[derive(Clone, Debug, PartialEq)]
pub struct Buffers {
    /// Columns.
    pub width: usize,
    /// Lines.
    pub height: usize,
    /// Distance along the view in scene units; infinite for the background.
    pub distance: Vec<f64>,
    /// Object and number of the face; object -1 for the background.
    pub face: Vec<(i32, u8)>,
}

/// A flagged pixel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Crack {
    /// Column.
    pub x: usize,
    /// Line.
    pub y: usize,
    /// What is seen through it, -1 for the background.
    pub object: i32,
    /// The objects on both sides.
    pub sides: [i32; 2],
    /// It is the end of a *notch*: flagged pixels of its face lead to one of its face that is not flagged, as where two
    /// outlines meet at a sharp angle. A crack within a surface is closed.
    pub notch: bool,
    /// It is an *opening* of the scene: the ray tracer sees through it as well ([`mark_openings`]).
    pub opening: bool,
}

impl Crack {
    /// Neither the end of a notch nor an opening.
    pub fn is_of_the_drawing(&self) -> bool {
        !self.notch && !self.opening
    }
}

/// Asks a tracer of the same scene about what was found: a narrow gap between two parts looks like a crack.
pub fn mark_openings(found: &mut [Crack], tracer: &Tracer) {
    for crack in found.iter_mut().filter(|crack| !crack.notch) {
        let seen = tracer.at(crack.x as u32, crack.y as u32);
        crack.opening = seen.map_or(-1, |pixel| pixel.object as i32) == crack.object;
    }
}

impl Buffers {
    /// Those of a frame with depth words up to `z_max`.
    pub fn new(frame: &Frame, range: &DepthRange, z_max: i64) -> Buffers {
        let distance = |(word, id): (&i64, &i32)| {
            if *id < 0 {
                return f64::INFINITY;
            }
            range.distance(*word as f64 / z_max as f64)
        };
        Buffers {
            width: frame.width,
            height: frame.height,
            distance: frame.depth.iter().zip(&frame.id).map(distance).collect(),
            face: (0..frame.id.len()).map(|i| face(frame, i)).collect(),
        }
    }
}

/// Two pixels of a picture, in scene units: what a distance is unless another is asked for.
pub fn two_pixels(camera: &Camera, height: usize) -> f64 {
    2.0 * camera.view_height / height as f64
}

/// The flagged pixels, line by line.
pub fn cracks(buffers: &Buffers, rule: &Rule) -> Vec<Crack> {
    let pixels = (0..buffers.height).flat_map(|y| (0..buffers.width).map(move |x| (x, y)));
    let found = pixels.filter_map(|(x, y)| crack_at(buffers, rule, x, y));
    let mut found: Vec<Crack> = found.collect();
    mark_notches(buffers, &mut found);
    found
}

/// Goes through the flagged pixels from those that touch an unflagged one of their face.
fn mark_notches(buffers: &Buffers, found: &mut [Crack]) {
    let index = |c: &Crack| c.y * buffers.width + c.x;
    let flagged: HashMap<usize, usize> = found.iter().map(index).zip(0..).collect();
    let face = &buffers.face;
    let alike = |pixel: usize| {
        let about = about(pixel, buffers.width, buffers.height);
        about.filter(move |&other| other != pixel && face[other] == face[pixel])
    };
    let touches = |c: &Crack| alike(index(c)).any(|i| !flagged.contains_key(&i));
    let mut open: Vec<usize> = (0..found.len()).filter(|&k| touches(&found[k])).collect();
    while let Some(k) = open.pop() {
        if found[k].notch {
            continue;
        }
        found[k].notch = true;
        open.extend(alike(index(&found[k])).filter_map(|i| flagged.get(&i)));
    }
}

fn crack_at(buffers: &Buffers, rule: &Rule, x: usize, y: usize) -> Option<Crack> {
    let own = y * buffers.width + x;
    // The pixel on one side, so many steps away, if it is nearer and shows another face.
    let side = |direction, steps: i64| -> Option<i32> {
        let index = stepped((x, y), direction, steps, (buffers.width, buffers.height))?;
        let nearer = buffers.distance[own] - buffers.distance[index] >= rule.min_distance;
        (nearer && buffers.face[index] != buffers.face[own]).then_some(buffers.face[index].0)
    };
    let reach = rule.width as i64;
    for direction in DIRECTIONS {
        for before in 1..=reach {
            let Some(one) = side(direction, -before) else {
                continue;
            };
            let after = (1..=reach + 1 - before).find_map(|steps| side(direction, steps));
            if let Some(other) = after {
                return Some(Crack {
                    x,
                    y,
                    object: buffers.face[own].0,
                    sides: [one, other],
                    notch: false,
                    opening: false,
                });
            }
        }
    }
    None
}

/// The pixel so many steps away from another, if it is in the picture.
pub(crate) fn stepped(
    (x, y): (usize, usize),
    (u, v): (i64, i64),
    steps: i64,
    (width, height): (usize, usize),
) -> Option<usize> {
    let column = x.checked_add_signed((u * steps) as isize)?;
    let line = y.checked_add_signed((v * steps) as isize)?;
    (column < width && line < height).then_some(line * width + column)
}
