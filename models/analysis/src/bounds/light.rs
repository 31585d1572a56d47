//! At which pixels rounding could change which light sources reach what is seen.
//!
//! Like presence and face, membership in a volume is compared by ranges: that of the visible depth, in which the true
//! and the golden one lie, and those of the volume's words. The margin of a shadow widens them, with one exception: a
//! face is never in a shadow that begins at it, and always in one that it bounds from behind, which is what the
//! margin is proven for.

use super::depth::{Range, both, certain, face_ranges};
use super::jury::Jury;
use super::verdict::{Contest, Seen};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::QuadricWords;
use imogene_golden::object::volume::VolumeKind;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{Class, FACE_PLANE};
use imogene_prepare::volume::{Beginning, PreparedVolume};
use imogene_prepare::{PreparedScene, RoundingBounds};
use rayon::prelude::*;

/// For every pixel, row-major, whether a flag of its light is open; false where object or face are.
pub(super) fn undecided(prepared: &PreparedScene, jury: &Jury) -> Vec<bool> {
    let pixels = prepared.width as usize * prepared.height as usize;
    if prepared.volumes.is_empty() {
        return vec![false; pixels];
    }
    let volumes: Vec<Volume> = prepared.volumes.iter().map(Volume::new).collect();
    let line = |y: i64| {
        let is_open = |(contest, x): (Contest, i64)| {
            let seen = contest.winner.filter(|_| contest.is_decided());
            seen.is_some_and(|seen| is_open(&volumes, &seen, &prepared.format, (x, y)))
        };
        let contests = jury.line(y).into_iter().zip(0..);
        contests.map(is_open).collect::<Vec<bool>>()
    };
    let lines = (0..i64::from(prepared.height)).into_par_iter();
    lines.flat_map_iter(line).collect()
}

/// Whether any source may reach the point in one picture alone; behind one volume a source is dark.
fn is_open(volumes: &[Volume], seen: &Seen, format: &Format, at: (i64, i64)) -> bool {
    let (mut dark, mut open) = (0u16, 0u16);
    for volume in volumes {
        let words = &volume.prepared.words;
        let bit = 1 << words.source;
        match volume.holds(seen, format, at) {
            Some(inside) if inside == (words.kind == VolumeKind::Shadow) => dark |= bit,
            Some(_) => {}
            None => open |= bit,
        }
    }
    open & !dark != 0
}

struct Volume<'a> {
    prepared: &'a PreparedVolume,
    /// Its quadric, as that of an object.
    quadric: Option<(QuadricWords, f64)>,
}

impl Volume<'_> {
    fn new(prepared: &PreparedVolume) -> Volume<'_> {
        let words = &prepared.words;
        let quadric = words.quadric.map(|q| {
            let words = QuadricWords {
                class: q.class,
                screen_box: words.screen_box,
                f1: q.f1,
                f2: q.f2,
                normal: Default::default(),
                planes: vec![],
            };
            (words, f64::from(1u32 << q.shift))
        });
        Volume { prepared, quadric }
    }

    /// Whether the point is inside, in the true and in the golden picture; `None` if that is open.
    fn holds(&self, seen: &Seen, format: &Format, (x, y): (i64, i64)) -> Option<bool> {
        let words = &self.prepared.words;
        if !words.screen_box.contains(x, y) {
            return Some(false);
        }
        let mut all = Some(true);
        let parts = words.planes.iter().zip(&self.prepared.bounds.planes);
        for (index, (plane, &bound)) in parts.enumerate() {
            let value = plane.depth.wrapped_at(x, y, format.plane) as i64;
            let value = Range::around(value, bound + f64::from(words.margin));
            let kept = match plane.kind {
                PlaneKind::None => Some(true),
                PlaneKind::Front if index == 0 && self.begins_at(seen) => Some(false),
                PlaneKind::Back if index == 0 && self.begins_at(seen) => Some(true),
                PlaneKind::Front => self.is_behind(&seen.depth, &value),
                PlaneKind::Back => seen.depth.is_before(&value),
                PlaneKind::Perpendicular => value.not_negative(),
            };
            all = both(all, kept);
        }
        both(all, self.in_quadric(&seen.depth, format, (x, y)))
    }

    fn begins_at(&self, seen: &Seen) -> bool {
        match self.prepared.caster {
            Some((object, Beginning::Cut(index))) => {
                seen.id == object && usize::from(seen.number) == usize::from(FACE_PLANE) + index
            }
            _ => false,
        }
    }

    fn in_quadric(&self, depth: &Range, format: &Format, (x, y): (i64, i64)) -> Option<bool> {
        let Some((words, unit)) = &self.quadric else {
            return Some(true);
        };
        let bounds: &RoundingBounds = &self.prepared.bounds;
        let f2 = words.f2_at(x, y, format);
        let met = Range::of_dropped(f2, bounds.f2, bounds.dropped_f2).not_negative();
        let (near, far) = face_ranges(words.f1_at(x, y, format), f2, bounds);
        // In depth words; the golden point is cut to the unit, which takes less than one.
        let [near, far] =
            [near, far].map(|r| Range::new((r.low - 1.0) * unit, (r.high + 1.0) * unit));
        let not = |known: Option<bool>| known.map(|known| !known);
        let behind_near = self.is_behind(depth, &near);
        let before_far = depth.is_before(&far);
        match words.class {
            Class::Prism => met,
            Class::Side => both(met, both(behind_near, before_far)),
            Class::Front => {
                let behind = not(depth.is_before(&near));
                let between = both(behind, not(self.is_behind(depth, &far)));
                not(both(met, between))
            }
            Class::Patch => Some(false),
        }
    }

    /// Whether a point is behind where the volume begins, the margin kept.
    fn is_behind(&self, point: &Range, start: &Range) -> Option<bool> {
        let margin = f64::from(self.prepared.words.margin);
        certain(start.high < point.low - margin, point.below(start))
    }
}
