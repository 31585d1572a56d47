//! Cracks made on purpose, and how many of them the detector finds.
//!
//! A crack is a pixel that shows what lies behind the object that should be seen: the picture of the scene without it.
//! Three sorts: single pixels within a surface, lines one pixel wide across surfaces, and single pixels at joints,
//! where two objects are side by side. A pixel on the outline cannot be told from one beside it and gets none: all
//! eight about a crack show an object.

use crate::compare::about;
use crate::crack::{Buffers, DIRECTIONS, Rule, cracks, stepped};
use crate::run::drawn;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::PreparedScene;
use imogene_scene::DepthRange;
use serde::Serialize;
use std::collections::HashSet;

/// Where cracks are made.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Sort {
    /// Single pixels within a surface.
    Points,
    /// Lines one pixel wide.
    Lines,
    /// Single pixels between two objects.
    Joints,
}

/// Found and not found at one minimum distance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Score {
    /// Sort of cracks.
    pub sort: Sort,
    /// Minimum distance in scene units.
    pub min_distance: f64,
    /// Pixels made.
    pub made: usize,
    /// Of these, pixels that show something farther than their whole surrounding by the minimum distance.
    pub deep: usize,
    /// Pixels made and flagged.
    pub found: usize,
    /// Of the deep ones.
    pub deep_found: usize,
    /// Pixels flagged that were not made.
    pub others: usize,
    /// Pixels flagged in the picture as it was.
    pub before: usize,
}

impl Score {
    /// Share of the cracks that are found; 1 if none was made.
    pub fn recall(&self) -> f64 {
        share(self.found, self.made)
    }

    /// Share of the deep cracks that are found; 1 if none was made.
    pub fn deep_recall(&self) -> f64 {
        share(self.deep_found, self.deep)
    }

    /// Share of the flagged pixels that are cracks; 1 if none was flagged.
    pub fn precision(&self) -> f64 {
        share(self.found, self.found + self.others)
    }
}

fn share(part: usize, whole: usize) -> f64 {
    match whole {
        0 => 1.0,
        _ => part as f64 / whole as f64,
    }
}

/// Pictures in which cracks can be made.
pub struct Breakable {
    frame: Frame,
    without: Vec<Frame>,
    z_max: i64,
}

impl Breakable {
    /// Draws the scene, and once more without each of its objects.
    pub fn new(prepared: &PreparedScene) -> Breakable {
        let slots = prepared.slots();
        let without = |object: usize| {
            let rest = slots.iter().filter(|slot| slot.object != object);
            drawn(prepared, &rest.cloned().collect::<Vec<_>>())
        };
        Breakable {
            frame: prepared.frame(|| ()),
            without: (0..prepared.objects.len()).map(without).collect(),
            z_max: prepared.format.z_max(),
        }
    }

    /// The picture with about `count` cracks of a sort, placed by `seed`, and the pixels that they are.
    pub fn broken(&self, sort: Sort, count: usize, seed: u64) -> (Frame, Vec<usize>) {
        let (w, h) = (self.frame.width, self.frame.height);
        let mut random = seed;
        let mut marked = HashSet::new();
        for _ in 0..count * 50 {
            if marked.len() >= count || w < 3 || h < 3 {
                break;
            }
            let (x, y) = (next(&mut random, w), next(&mut random, h));
            let line: Vec<usize> = match sort {
                Sort::Points | Sort::Joints => vec![y * w + x],
                Sort::Lines => {
                    let direction = DIRECTIONS[next(&mut random, DIRECTIONS.len())];
                    let at = |k| stepped((x, y), direction, k, (w, h));
                    (0..24).filter_map(at).collect()
                }
            };
            let free = |index: &usize| {
                let about = self.about(*index);
                // Cracks that touch would be wider than one pixel.
                let apart = about.iter().all(|i| !marked.contains(i));
                let fits = match sort {
                    Sort::Points => self.objects(&about) == 1,
                    Sort::Joints => self.objects(&about) >= 2,
                    Sort::Lines => true,
                };
                about.len() == 9 && apart && fits && about.iter().all(|i| self.frame.id[*i] >= 0)
            };
            if line.iter().all(free) {
                marked.extend(line);
            }
        }
        let mut broken = self.frame.clone();
        let mut marked: Vec<usize> = marked.into_iter().collect();
        marked.sort_unstable();
        for &index in &marked {
            broken.take(index, &self.without[self.frame.id[index] as usize]);
        }
        (broken, marked)
    }

    fn about(&self, index: usize) -> Vec<usize> {
        about(index, self.frame.width, self.frame.height).collect()
    }

    fn objects(&self, pixels: &[usize]) -> usize {
        let ids: HashSet<i32> = pixels.iter().map(|i| self.frame.id[*i]).collect();
        ids.len()
    }

    /// Makes cracks and looks for them.
    pub fn score(
        &self,
        range: &DepthRange,
        sort: Sort,
        count: usize,
        seed: u64,
        rule: &Rule,
    ) -> Score {
        let buffers = |frame: &Frame| Buffers::new(frame, range, self.z_max);
        let (broken, made) = self.broken(sort, count, seed);
        let searched = buffers(&broken);
        let flagged = cracks(&searched, rule).into_iter();
        let flagged: HashSet<usize> = flagged.map(|c| c.y * broken.width + c.x).collect();
        let whole = buffers(&self.frame);
        let is_deep = |index: &&usize| {
            let own = searched.distance[**index];
            let about = self.about(**index);
            let mut others = about.iter().filter(|i| *i != *index);
            others.all(|i| own - whole.distance[*i] >= rule.min_distance)
        };
        let deep: Vec<&usize> = made.iter().filter(is_deep).collect();
        let found = made.iter().filter(|i| flagged.contains(i)).count();
        Score {
            sort,
            min_distance: rule.min_distance,
            made: made.len(),
            deep: deep.len(),
            found,
            deep_found: deep.iter().filter(|i| flagged.contains(**i)).count(),
            others: flagged.len() - found,
            before: cracks(&whole, rule).len(),
        }
    }
}

/// A whole number below `limit` from a generator of period 2^64 (Steele and others, splitmix).
fn next(state: &mut u64, limit: usize) -> usize {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    ((z ^ (z >> 31)) % limit as u64) as usize
}
