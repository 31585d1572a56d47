//! Can a surface of a zone be inside a volume, and which of the volume's planes matter there?
//!
//! A volume whose box meets the zone is most often far before or behind everything that is seen there. The depth of
//! what is seen is not known before it is drawn, but it lies between the depths of the objects of the zone, object by
//! object: that is enough to leave most volumes out.

use super::blocks::everywhere;
use super::part::with_planes;
use super::surface::{
    DepthBounds, Matter, PlaneOn, Planes, Roots, Surface, difference, keep, listed, plus, radicand,
    times,
};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::range::Range;
use imogene_golden::object::volume::{VolumeQuadric, VolumeWords};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;

/// Something that can be seen in a zone.
#[derive(Clone, Debug)]
pub struct Seen {
    /// Its words.
    pub words: QuadricWords,
    /// Its pixels in the zone: a window in its screen box.
    pub window: ScreenBox,
}

impl Seen {
    /// A part of which these planes matter on a window of its pixels.
    pub fn new(words: &QuadricWords, planes: Planes, window: ScreenBox) -> Seen {
        Seen {
            words: with_planes(words, planes),
            window,
        }
    }
}

/// What of a volume matters to these objects, by bounds alone: [`Matter::Nothing`] if no surface point is inside;
/// without planes that are left out the answer is the same at every surface point.
pub fn matter_of_volume(words: &VolumeWords, seen: &[Seen], format: &Format) -> Matter {
    Matter::of(words.planes.len(), |planes, idle| {
        seen.iter().all(|seen| {
            let window = seen.window.shared(&words.screen_box);
            everywhere(&window, &|w| {
                let near = Near::new(words, seen, format, w);
                near.is_outside(planes) || idle.is_some_and(|index| near.keeps_all(index))
            })
        })
    })
}

/// The same volume with these planes only.
pub fn volume_with_planes(words: &VolumeWords, planes: Planes) -> VolumeWords {
    let mut left = words.clone();
    keep(&mut left.planes, planes);
    left
}

struct Near<'a> {
    volume: &'a VolumeWords,
    format: &'a Format,
    window: ScreenBox,
    surface: DepthBounds,
}

impl<'a> Near<'a> {
    fn new(volume: &'a VolumeWords, seen: &Seen, format: &'a Format, window: &ScreenBox) -> Self {
        Near {
            volume,
            format,
            window: *window,
            surface: Surface::new(&seen.words, format, window).depth_bounds(),
        }
    }

    /// True only if the surface is at or behind the expression at every pixel, which then has no reason to leave a
    /// point out.
    fn is_behind(&self, depth: &Linear) -> bool {
        let behind = |bound: &Linear| difference(bound, depth, &self.window).low >= 0;
        self.surface.before.iter().any(behind)
    }

    /// True only if the surface is before the expression, not at it, at every pixel.
    fn is_before(&self, depth: &Linear) -> bool {
        let before = |bound: &Linear| difference(bound, depth, &self.window).high < 0;
        let surface = &self.surface;
        let fronts = surface.fronts.as_ref();
        surface.behind.iter().any(before) || fronts.is_some_and(|all| all.iter().all(before))
    }

    fn margin(&self) -> i128 {
        i128::from(self.volume.margin) << self.format.guard_linear
    }

    fn plane(&self, index: usize) -> Option<PlaneOn> {
        let plane = &self.volume.planes[index];
        PlaneOn::new(plane.kind, &plane.depth, &self.window, self.format)
    }

    /// True only if no point of the surface is inside the volume with these planes.
    fn is_outside(&self, planes: Planes) -> bool {
        let mut listed = listed(planes, self.volume.planes.len());
        let quadric = self.volume.quadric.as_ref();
        quadric.is_some_and(|quadric| self.misses(quadric))
            || listed.any(|index| self.removes_all(index))
    }

    fn removes_all(&self, index: usize) -> bool {
        let Some(PlaneOn { kind, depth, range }) = self.plane(index) else {
            return false;
        };
        match kind {
            PlaneKind::None => false,
            PlaneKind::Front => self.is_before(&plus(&depth, self.margin())),
            // Behind, not at: a unit more.
            PlaneKind::Back => self.is_behind(&plus(&depth, 1)),
            PlaneKind::Perpendicular => range.high < 0,
        }
    }

    /// True only if the plane keeps every point of the surface.
    fn keeps_all(&self, index: usize) -> bool {
        let Some(PlaneOn { kind, depth, range }) = self.plane(index) else {
            return self.volume.planes[index].kind == PlaneKind::None;
        };
        match kind {
            PlaneKind::None => true,
            PlaneKind::Front => self.is_behind(&plus(&depth, self.margin())),
            PlaneKind::Back => self.is_before(&plus(&depth, 1)),
            PlaneKind::Perpendicular => range.low >= 0,
        }
    }

    /// True only if no point of the surface is inside the quadric.
    fn misses(&self, quadric: &VolumeQuadric) -> bool {
        let Some(radicand) = radicand(&quadric.f2, &self.window, self.format) else {
            return false;
        };
        match quadric.class {
            Class::Patch => true,
            Class::Prism => radicand.high < 0,
            Class::Front => false,
            Class::Side => radicand.high < 0 || self.misses_roots(quadric, &radicand),
        }
    }

    /// Before its near depth, or behind its far depth, at every pixel. The depths of a volume are in units of `2^shift`
    /// depth words, and a point is in one of them downwards: it is behind the far depth from the next unit on.
    fn misses_roots(&self, quadric: &VolumeQuadric, radicand: &Range) -> bool {
        let Some(roots) = Roots::of(&quadric.f1, radicand, &self.window, self.format) else {
            return false;
        };
        let unit = 1 << quadric.shift;
        let near = times(&roots.below_near(self.format), unit);
        let next = 1 << self.format.guard_linear;
        let far = times(&plus(&roots.above_far(), next), unit);
        self.is_before(&plus(&near, self.margin())) || self.is_behind(&far)
    }
}
