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
const DIRECTIONS: [(i64, i64); 4] = [(1, 0), (0, 1), (1, 1), (1, -1)];

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

/// Asks a tracer of the same scene about what was found: the detector needs no reference, but a narrow gap between two
/// parts looks to it as a crack does.
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
    let mut found: Vec<Crack> = pixels
        .filter_map(|(x, y)| crack_at(buffers, rule, x, y))
        .collect();
    mark_notches(buffers, &mut found);
    found
}

/// Goes through the flagged pixels from those that touch an unflagged one of their face.
fn mark_notches(buffers: &Buffers, found: &mut [Crack]) {
    let index = |c: &Crack| c.y * buffers.width + c.x;
    let flagged: HashMap<usize, usize> = found.iter().map(index).zip(0..).collect();
    let alike = |pixel: usize| -> Vec<usize> {
        about(pixel, buffers.width, buffers.height)
            .filter(|&other| other != pixel && buffers.face[other] == buffers.face[pixel])
            .collect()
    };
    let touches = |c: &Crack| alike(index(c)).iter().any(|i| !flagged.contains_key(i));
    let mut open: Vec<usize> = (0..found.len()).filter(|&k| touches(&found[k])).collect();
    while let Some(k) = open.pop() {
        if found[k].notch {
            continue;
        }
        found[k].notch = true;
        let beside = alike(index(&found[k]));
        open.extend(beside.iter().filter_map(|i| flagged.get(i)));
    }
}

fn crack_at(buffers: &Buffers, rule: &Rule, x: usize, y: usize) -> Option<Crack> {
    let own = y * buffers.width + x;
    // The pixel on one side, so many steps away, if it is nearer and shows another face.
    let side = |(u, v): (i64, i64), steps: i64| -> Option<i32> {
        let column = usize::try_from(x as i64 + u * steps).ok()?;
        let line = usize::try_from(y as i64 + v * steps).ok()?;
        if column >= buffers.width || line >= buffers.height {
            return None;
        }
        let index = line * buffers.width + column;
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

#[cfg(test)]
mod tests {
    use super::*;

    const RULE: Rule = Rule {
        min_distance: 1.0,
        width: 1,
    };

    /// A wall of one face at distance 10, with what `behind` says behind the marked pixels.
    fn wall(width: usize, height: usize, marked: &[(usize, usize)], behind: (f64, i32)) -> Buffers {
        let mut buffers = Buffers {
            width,
            height,
            distance: vec![10.0; width * height],
            face: vec![(0, 0); width * height],
        };
        for (x, y) in marked {
            buffers.distance[y * width + x] = behind.0;
            buffers.face[y * width + x] = (behind.1, 0);
        }
        buffers
    }

    fn found(buffers: &Buffers, rule: Rule) -> Vec<(usize, usize)> {
        cracks(buffers, &rule).iter().map(|c| (c.x, c.y)).collect()
    }

    #[test]
    fn every_crack_one_pixel_wide_is_found_and_nothing_else() {
        // A point, a level line, an upright one, both diagonals, a staircase, and a block of four.
        let line = |u: i64, v: i64| -> Vec<(usize, usize)> {
            (0..5)
                .map(|k| ((8 + u * k) as usize, (8 + v * k) as usize))
                .collect()
        };
        let stairs = (0..8usize)
            .map(|k| (4 + k / 2, 4 + k.div_ceil(2)))
            .collect();
        let block = vec![(7, 7), (8, 7), (7, 8), (8, 8)];
        let lines = [(0, 0), (1, 0), (0, 1), (1, 1), (1, -1)].map(|(u, v)| line(u, v));
        for mut marked in lines.into_iter().chain([stairs, block]) {
            marked.sort_by_key(|(x, y)| (*y, *x));
            marked.dedup();
            for behind in [(f64::INFINITY, -1), (11.0, 1)] {
                assert_eq!(found(&wall(20, 20, &marked, behind), RULE), marked);
            }
            // Too little behind, or the same face.
            assert_eq!(found(&wall(20, 20, &marked, (10.9, 1)), RULE), []);
            assert_eq!(found(&wall(20, 20, &marked, (20.0, 0)), RULE), []);
        }
    }

    #[test]
    fn wider_cracks_need_the_wider_rule() {
        let band: Vec<(usize, usize)> = (0..20).flat_map(|y| [9, 10].map(|x| (x, y))).collect();
        let buffers = wall(20, 20, &band, (f64::INFINITY, -1));
        assert_eq!(found(&buffers, RULE), []);
        let wide = Rule { width: 2, ..RULE };
        assert_eq!(found(&buffers, wide), band);
        let three: Vec<(usize, usize)> =
            (0..20).flat_map(|y| [9, 10, 11].map(|x| (x, y))).collect();
        let buffers = wall(20, 20, &three, (f64::INFINITY, -1));
        assert_eq!(found(&buffers, wide), []);
        assert_eq!(found(&buffers, Rule { width: 3, ..RULE }), three);
    }

    /// A wedge of background that narrows to one pixel is flagged where it is narrow, and a crack within the surface is
    /// not taken for its end.
    #[test]
    fn the_end_of_a_notch_is_told_from_a_crack() {
        let wedge = (0..16usize).flat_map(|y| (10 - (16 - y) / 4..=10).map(move |x| (x, y)));
        let mut marked: Vec<(usize, usize)> = wedge.collect();
        marked.push((3, 15));
        let all = cracks(&wall(20, 20, &marked, (f64::INFINITY, -1)), &RULE);
        let (notches, closed): (Vec<&Crack>, Vec<&Crack>) = all.iter().partition(|c| c.notch);
        assert_eq!(
            closed.iter().map(|c| (c.x, c.y)).collect::<Vec<_>>(),
            [(3, 15)]
        );
        assert!(
            notches.len() >= 3 && notches.iter().all(|c| c.x == 10),
            "{all:?}"
        );
    }

    #[test]
    fn outlines_are_no_cracks() {
        let half: Vec<(usize, usize)> = (0..20)
            .flat_map(|y| (10..20).map(move |x| (x, y)))
            .collect();
        for width in 1..4 {
            let rule = Rule { width, ..RULE };
            assert_eq!(found(&wall(20, 20, &half, (f64::INFINITY, -1)), rule), []);
        }
    }
}
