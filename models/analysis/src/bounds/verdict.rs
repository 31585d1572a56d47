//! Whether the rounding bounds decide what an object shows at a pixel.
//!
//! Every number that the machine compares is replaced by the range in which both the true and the computed one lie.
//! Where the ranges are apart, true and computed picture agree on presence and face; where they overlap the pixel
//! is *undecided*.

use super::depth::{Range, both, certain, face_ranges};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::PlaneWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{Class, FACE_FAR, FACE_NEAR, FACE_NEAR_END, FACE_PLANE};
use imogene_prepare::PreparedQuadric;

/// What is proven of one object at one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Verdict {
    /// Certainly absent, in the true and in the golden picture.
    Absent,
    /// Certainly this face, with the range of its depth.
    Face(u8, Range),
    /// The rounding could change presence or face; the depth, if any, is not below this.
    Undecided {
        nearest: f64,
        /// True if the sign of f2 itself is open, false if only a comparison with a plane or an end is.
        silhouette: bool,
    },
}

pub(super) type Bounded = (u8, Range);

/// The values of one object at one pixel, each with the range in which true and computed one lie.
pub(super) struct Pixel {
    pub class: Class,
    /// Some(true) if the line of sight certainly meets the quadric, Some(false) if it certainly does not.
    pub seen: Option<bool>,
    pub near: Range,
    pub far: Range,
    pub planes: Vec<(PlaneKind, Range)>,
    /// The near end.
    pub near_end: f64,
    /// The far end, at which nothing is drawn any more.
    pub far_end: f64,
}

/// Decides a pixel of the object's screen box; outside the box the object is proven absent.
pub(super) fn decide(object: &PreparedQuadric, format: &Format, x: i64, y: i64) -> Verdict {
    let (words, bounds) = (&object.words, &object.bounds);
    if !words.screen_box.contains(x, y) {
        return Verdict::Absent;
    }
    let f2 = words.f2_at(x, y, format);
    let seen = Range::of_dropped(f2, bounds.f2, bounds.dropped_f2).not_negative();
    if seen == Some(false) && words.class != Class::Front {
        return Verdict::Absent;
    }
    let (near, far) = face_ranges(words.f1_at(x, y, format), f2, bounds);
    let planes = words.planes.iter().zip(&bounds.planes);
    let plane = |(plane, &bound): (&PlaneWords, &f64)| {
        let value = plane.depth.wrapped_at(x, y, format.plane);
        (plane.kind, Range::around(value as i64, bound))
    };
    Pixel {
        class: words.class,
        seen,
        near,
        far,
        planes: planes.map(plane).collect(),
        near_end: format.z_low() as f64,
        far_end: format.z_max() as f64,
    }
    .decide()
}

impl Pixel {
    pub fn decide(&self) -> Verdict {
        let sides = self.half_planes();
        if sides == Some(false) {
            return Verdict::Absent;
        }
        let verdict = match self.class {
            Class::Side => self.side(),
            Class::Front => self.front(),
            Class::Patch => self.patch(),
            Class::Prism => match (self.seen, self.convex(&self.entries(), self.exit())) {
                (Some(false), _) => Verdict::Absent,
                (None, Verdict::Face(_, depth)) => self.undecided(depth.low),
                (_, line) => line,
            },
        };
        match verdict {
            Verdict::Face(_, depth) if sides.is_none() => self.undecided(depth.low),
            other => other,
        }
    }

    fn undecided(&self, nearest: f64) -> Verdict {
        Verdict::Undecided {
            nearest,
            silhouette: self.seen.is_none(),
        }
    }

    fn planes_of(&self, kind: PlaneKind) -> impl Iterator<Item = (usize, Range)> + '_ {
        let planes = self.planes.iter().enumerate();
        planes.filter_map(move |(i, plane)| (plane.0 == kind).then_some((i, plane.1)))
    }

    fn half_planes(&self) -> Option<bool> {
        let mut all = Some(true);
        for (_, value) in self.planes_of(PlaneKind::Perpendicular) {
            all = both(all, value.not_negative());
        }
        all
    }

    /// The near end and the front planes: the ray is kept behind the farthest of them.
    fn entries(&self) -> Vec<Bounded> {
        let planes = self.planes_of(PlaneKind::Front);
        let planes = planes.map(|(i, depth)| (FACE_PLANE + i as u8, depth));
        let near_end = (FACE_NEAR_END, Range::point(self.near_end));
        std::iter::once(near_end).chain(planes).collect()
    }

    /// The ray is kept before the nearest back plane.
    fn exit(&self) -> Range {
        let depths = self.planes_of(PlaneKind::Back).map(|(_, depth)| depth);
        depths.fold(Range::point(f64::INFINITY), |exit, depth| exit.min(&depth))
    }

    /// The solid between the farthest of `entries` and `exit`.
    fn convex(&self, entries: &[Bounded], exit: Range) -> Verdict {
        let entry = farthest(entries);
        if exit.below(&entry) || entry.low >= self.far_end {
            return Verdict::Absent;
        }
        let behind_all = entry.not_above(&exit) && entry.high < self.far_end;
        match winner(entries) {
            Some((number, depth)) if behind_all => Verdict::Face(number, depth),
            _ => self.undecided(entry.low),
        }
    }

    fn side(&self) -> Verdict {
        if self.seen == Some(false) {
            return Verdict::Absent;
        }
        // Near and far root share the error of f1 and are never compared with each other.
        let mut entries = self.entries();
        let ends = farthest(&entries);
        if self.far.below(&ends) {
            return Verdict::Absent;
        }
        entries.push((FACE_NEAR, self.near));
        let certain = self.seen == Some(true) && ends.not_above(&self.far);
        match self.convex(&entries, self.exit()) {
            Verdict::Face(_, depth) if !certain => self.undecided(depth.low),
            other => other,
        }
    }

    /// Solid outside the two roots: before the near root, or behind the far root.
    fn front(&self) -> Verdict {
        let entries = self.entries();
        let line = self.convex(&entries, self.exit());
        let entry = farthest(&entries);
        let before_or_behind = entry.not_above(&self.near) || self.far.below(&entry);
        if line == Verdict::Absent || self.seen == Some(false) || before_or_behind {
            return line;
        }
        let between = self.near.below(&entry) && entry.below(&self.far);
        if self.seen == Some(true) && between {
            let mut behind = entries;
            behind.push((FACE_FAR, self.far));
            return self.convex(&behind, self.exit());
        }
        self.undecided(entry.low)
    }

    /// The first of the two roots that every plane and both ends keep.
    fn patch(&self) -> Verdict {
        if self.seen == Some(false) {
            return Verdict::Absent;
        }
        let keeps = [self.near, self.far].map(|face| self.keeps_face(face));
        match (keeps, self.seen) {
            ([Some(false), Some(false)], _) => Verdict::Absent,
            ([Some(true), _], Some(true)) => Verdict::Face(FACE_NEAR, self.near),
            ([Some(false), Some(true)], Some(true)) => Verdict::Face(FACE_FAR, self.far),
            ([Some(false), _], _) => self.undecided(self.far.low),
            _ => self.undecided(self.near.low),
        }
    }

    fn keeps_face(&self, face: Range) -> Option<bool> {
        let entry = farthest(&self.entries());
        let exit = self.exit();
        let kept = entry.not_above(&face) && face.not_above(&exit) && face.high < self.far_end;
        let gone = face.below(&entry) || exit.below(&face) || face.low >= self.far_end;
        certain(kept, gone)
    }
}

fn farthest(faces: &[Bounded]) -> Range {
    let farthest = faces.iter().map(|f| f.1).reduce(|a, b| a.max(&b));
    farthest.expect("the near end is always there")
}

/// The face that is certainly the farthest, if there is one.
fn winner(faces: &[Bounded]) -> Option<Bounded> {
    let all = faces.iter().enumerate();
    let last = all.max_by(|(_, a), (_, b)| a.1.low.total_cmp(&b.1.low));
    let (index, best) = last.expect("the near end is always there");
    let mut others = faces.iter().enumerate().filter(|(i, _)| *i != index);
    let alone = others.all(|(_, face)| face.1.below(&best.1));
    alone.then_some(*best)
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Seen {
    pub id: usize,
    pub number: u8,
    pub depth: Range,
}

/// What is proven of the whole picture at one pixel, object by object.
///
/// The nearest decided face wins if every other object is certainly farther; two that may be equally far are open, as
/// a tie is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Contest {
    /// The decided face that is surely no farther than any other decided one.
    pub winner: Option<Seen>,
    /// The two objects that may be the nearest ones, and how near.
    nearest: [(f64, usize); 2],
    /// What is seen through, or its order, is open.
    open_before: bool,
}

impl Contest {
    pub const EMPTY: Contest = Contest {
        winner: None,
        nearest: [(f64::INFINITY, usize::MAX); 2],
        open_before: false,
    };

    /// Takes part with what is known of object `id`.
    pub fn enter(&mut self, id: usize, verdict: &Verdict) {
        let low = match verdict {
            Verdict::Absent => return,
            &Verdict::Face(number, depth) => {
                if self.winner.is_none_or(|best| depth.high < best.depth.high) {
                    self.winner = Some(Seen { id, number, depth });
                }
                depth.low
            }
            Verdict::Undecided { nearest, .. } => *nearest,
        };
        let [first, second] = &mut self.nearest;
        if low < first.0 || first.1 == usize::MAX {
            (*second, *first) = (*first, (low, id));
        } else if low < second.0 || second.1 == usize::MAX {
            *second = (low, id);
        }
    }

    /// Takes what is known of the transparent objects, once all others have taken part: each must be decided unless it
    /// is hidden, and apart in depth from what is behind it.
    pub fn see_through(&mut self, layers: &[Verdict]) {
        let surface = self.winner.map(|seen| seen.depth);
        let limit = surface.map_or(f64::INFINITY, |depth| depth.high);
        let mut ranges: Vec<Range> = surface.into_iter().collect();
        for layer in layers {
            match layer {
                Verdict::Absent => {}
                Verdict::Undecided { nearest, .. } => self.open_before |= *nearest <= limit,
                Verdict::Face(_, depth) if depth.low > limit => {}
                Verdict::Face(_, depth) => {
                    let meets = |other: &Range| depth.low <= other.high && other.low <= depth.high;
                    self.open_before |= ranges.iter().any(meets);
                    ranges.push(*depth);
                }
            }
        }
    }

    /// True if object and face are the same in the true and in the golden picture, and all that is seen through.
    pub fn is_decided(&self) -> bool {
        let winner = self.winner.map(|seen| (seen.id, seen.depth.high));
        let (winner, limit) = winner.unwrap_or((usize::MAX, f64::INFINITY));
        if self.open_before {
            return false;
        }
        let mut others = self.nearest.iter().filter(|(_, id)| *id != winner);
        others.all(|&(low, id)| id == usize::MAX || low > limit)
    }
}
