//! What can be said of an object on a window of pixels without visiting them: that it is absent, that a plane cuts
//! nothing, between which depths it lies.
//!
//! Every sentence is about the words as the processor computes with them, so it is exact or on the safe side:
//! first-degree expressions are taken at the corners, the discriminant line by line, and a register is believed only
//! where the true value fits it at every pixel of the window (source: Claux, III.3.2.2; Nyiri, 5.5).

use imogene_golden::format::Format;
use imogene_golden::object::quadric::{PlaneWords, QuadricWords, ScreenBox};
use imogene_golden::object::range::Range;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;

/// Which of an object's planes are there: bit i is set for plane i.
pub type Planes = u16;

/// All of so many planes.
pub const fn all_planes(count: usize) -> Planes {
    (1 << count) - 1
}

/// What of an object or a volume matters on a window.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Matter {
    /// Nothing: the object is at no pixel, or no surface point is inside the volume.
    Nothing,
    /// It does with these of its planes; the others cut nothing.
    With(Planes),
}

impl Matter {
    /// Of one with so many planes. `is_nothing` says whether it is nothing with these planes or, asked of another one,
    /// whether that is idle beside them.
    pub(super) fn of(count: usize, is_nothing: impl Fn(Planes, Option<usize>) -> bool) -> Matter {
        let mut planes = all_planes(count);
        if is_nothing(planes, None) {
            return Matter::Nothing;
        }
        // One after the other: what is left out is idle beside the planes that are still there.
        for index in 0..count {
            let without = planes & !(1 << index);
            if is_nothing(without, Some(index)) {
                planes = without;
            }
        }
        Matter::With(planes)
    }
}

/// Leaves these planes only, one after the other.
pub(super) fn keep<T>(list: &mut Vec<T>, planes: Planes) {
    let mut index = 0;
    list.retain(|_| {
        index += 1;
        planes >> (index - 1) & 1 == 1
    });
}

/// Linear part and greatest root of a quadric on a window, in units of `2^-g1` depth words, where both depths fit their
/// words.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roots {
    /// Linear part.
    pub f1: Linear,
    /// Greatest root.
    pub root: i128,
    /// Least root.
    pub least: i128,
}

/// Where the depth of an object lies on a window, by first-degree expressions in units of `2^-g1` depth words.
#[derive(Clone, Debug)]
pub(super) struct DepthBounds {
    /// It is nowhere before any of these.
    pub before: Vec<Linear>,
    /// It is nowhere behind any of these.
    pub behind: Vec<Linear>,
    /// At every pixel it is nowhere behind the farthest of these: the faces that can be seen. None if that is not
    /// known.
    pub fronts: Option<Vec<Linear>>,
}

impl Roots {
    /// Of the quadric `f1 -+ sqrt(f2)`; `None` if a register could wrap.
    pub fn of(f1: &Linear, radicand: &Range, window: &ScreenBox, format: &Format) -> Option<Roots> {
        let range = Range::of_linear(f1, window);
        let [_, root] = roots(radicand.high, format)?;
        let least = roots(radicand.low, format)?[0].max(0);
        let guard = format.guard_linear;
        let sums = Range {
            low: (range.low >> guard) - root,
            high: (range.high >> guard) + root,
        };
        let fits = range.fits(format.pe1_width()) && sums.fits(format.sum);
        fits.then_some(Roots {
            f1: *f1,
            root: root << guard,
            least: least << guard,
        })
    }

    /// Not above `near`, in units of `2^-g1`: what the guard bits drop is at most one unit less than a depth word.
    pub fn below_near(&self, format: &Format) -> Linear {
        let dropped = (1 << format.guard_linear) - 1;
        plus(&self.f1, -self.root - dropped)
    }

    /// Not below `near`.
    pub fn above_near(&self) -> Linear {
        plus(&self.f1, -self.least)
    }

    /// Not below `far`.
    pub fn above_far(&self) -> Linear {
        plus(&self.f1, self.root)
    }
}

/// A root that the network finds of no greater radicand, and one that it finds of no smaller one: an approximate root
/// can step down where its radicand grows, but stays within its error.
fn roots(radicand: i128, format: &Format) -> Option<[i128; 2]> {
    let radicand = i64::try_from(radicand.max(0)).ok()?;
    if format.root_form.is_exact() {
        return Some([format.root_of(radicand).into(); 2]);
    }
    let root = (radicand as f64).sqrt();
    let error = format.root_form.error_at(root, format.dropped_rows);
    // One more for the rounding of these numbers.
    Some([-1.0, 1.0].map(|sign| (root + sign * (error + 1.0)).round() as i128))
}

pub(super) fn plus(form: &Linear, constant: i128) -> Linear {
    Linear {
        c: form.c + constant,
        ..*form
    }
}

pub(super) fn times(form: &Linear, factor: i128) -> Linear {
    Linear::new(form.a * factor, form.b * factor, form.c * factor)
}

pub(super) fn difference(p: &Linear, q: &Linear, window: &ScreenBox) -> Range {
    Range::of_linear(&Linear::new(p.a - q.a, p.b - q.b, p.c - q.c), window)
}

/// The radicand on a window, guard bits dropped; `None` if its register could wrap.
pub(super) fn radicand(f2: &Quadratic, window: &ScreenBox, format: &Format) -> Option<Range> {
    let range = Range::of_quadratic(f2, window);
    let fits = range.fits(format.pe2_width());
    fits.then_some(range.dropped(format.guard_quadratic))
}

pub(super) struct PlaneOn {
    pub kind: PlaneKind,
    /// Its depth in units of `2^-g1` depth words.
    pub depth: Linear,
    /// Its depths in whole words.
    pub range: Range,
}

impl PlaneOn {
    /// None if its register could wrap.
    pub fn new(
        kind: PlaneKind,
        depth: &Linear,
        window: &ScreenBox,
        format: &Format,
    ) -> Option<PlaneOn> {
        let range = Range::of_linear(depth, window);
        range.fits(format.plane).then(|| PlaneOn {
            kind,
            depth: times(depth, 1 << format.guard_linear),
            range,
        })
    }
}

/// Numbers of these planes among so many.
pub(super) fn listed(planes: Planes, count: usize) -> impl Iterator<Item = usize> {
    (0..count).filter(move |index| planes >> index & 1 == 1)
}

pub(super) struct Surface<'a> {
    words: &'a QuadricWords,
    format: &'a Format,
    window: ScreenBox,
    radicand: Option<Range>,
    roots: Option<Roots>,
    /// Each plane on the window; none if its register could wrap.
    planes: Vec<Option<PlaneOn>>,
}

impl<'a> Surface<'a> {
    /// The object on a window that is not empty and lies in its screen box.
    pub fn new(words: &'a QuadricWords, format: &'a Format, window: &ScreenBox) -> Surface<'a> {
        let radicand = radicand(&words.f2, window, format);
        let has_depths = matches!(words.class, Class::Side | Class::Patch);
        let roots = radicand
            .filter(|_| has_depths)
            .and_then(|range| Roots::of(&words.f1, &range, window, format));
        let plane = |plane: &PlaneWords| PlaneOn::new(plane.kind, &plane.depth, window, format);
        Surface {
            words,
            format,
            window: *window,
            radicand,
            roots,
            planes: words.planes.iter().map(plane).collect(),
        }
    }

    fn known(&self, planes: Planes) -> impl Iterator<Item = (usize, &PlaneOn)> {
        let listed = listed(planes, self.planes.len());
        listed.filter_map(|index| Some((index, self.planes[index].as_ref()?)))
    }

    /// True only if the object with these planes is at no pixel of the window.
    pub fn is_absent(&self, planes: Planes) -> bool {
        let outside = self.words.class != Class::Front && self.radicand.is_some_and(|r| r.high < 0);
        outside
            || self.known(planes).any(|(_, plane)| self.removes_all(plane))
            || self.are_apart(planes)
    }

    fn removes_all(&self, plane: &PlaneOn) -> bool {
        match plane.kind {
            PlaneKind::None => false,
            PlaneKind::Front => self.is_far(plane, 1),
            PlaneKind::Back => self.is_near(plane, 1),
            PlaneKind::Perpendicular => plane.range.high < 0,
        }
    }

    /// True only if a plane is at or behind the far end, or so much behind the far root, at every pixel.
    fn is_far(&self, plane: &PlaneOn, by: i128) -> bool {
        let behind = |bound: Linear| difference(&plane.depth, &bound, &self.window).low >= by;
        plane.range.low >= self.format.z_max().into()
            || self.roots.is_some_and(|roots| behind(roots.above_far()))
    }

    /// True only if a plane is so much before the near end or the near root at every pixel.
    fn is_near(&self, plane: &PlaneOn, by: i128) -> bool {
        let before = |bound: Linear| difference(&plane.depth, &bound, &self.window).high <= -by;
        plane.range.high <= i128::from(self.format.z_low()) - by
            || self
                .roots
                .is_some_and(|roots| before(roots.below_near(self.format)))
    }

    /// A front plane lies behind a back plane at every pixel: nothing is between them.
    fn are_apart(&self, planes: Planes) -> bool {
        let of_kind = |wanted| {
            let known = self.known(planes).map(|(_, plane)| plane);
            known.filter(move |plane| plane.kind == wanted)
        };
        of_kind(PlaneKind::Front).any(|front| {
            of_kind(PlaneKind::Back)
                .any(|back| difference(&front.depth, &back.depth, &self.window).low > 0)
        })
    }

    /// True only if the object with these planes is the same without plane `index`, which is not among them, at every
    /// pixel of the window.
    pub fn is_idle(&self, index: usize, planes: Planes) -> bool {
        let Some(plane) = &self.planes[index] else {
            return self.words.planes[index].kind == PlaneKind::None;
        };
        let alone = match plane.kind {
            PlaneKind::None => true,
            PlaneKind::Front => self.is_near(plane, 0),
            PlaneKind::Back => self.is_far(plane, 0),
            PlaneKind::Perpendicular => plane.range.low >= 0,
        };
        // At equal depths the face is that of the first one in the chain.
        let mut others = self.known(planes);
        alone || others.any(|(other, by)| self.is_behind(by, plane, i128::from(other > index)))
    }

    /// One plane cuts at least as much as another of the same kind at every pixel, by this much.
    fn is_behind(&self, stronger: &PlaneOn, plane: &PlaneOn, by: i128) -> bool {
        let range = difference(&stronger.depth, &plane.depth, &self.window);
        match plane.kind {
            kind if kind != stronger.kind => false,
            PlaneKind::Front => range.low >= by,
            PlaneKind::Back => -range.high >= by,
            _ => false,
        }
    }

    /// Bounds of the depth at which the object is seen.
    pub fn depth_bounds(&self) -> DepthBounds {
        let mut bounds = DepthBounds {
            before: vec![self.constant(self.format.z_low())],
            behind: vec![self.constant(self.format.z_max())],
            fronts: self.fronts(),
        };
        if let Some(roots) = &self.roots {
            bounds.before.push(roots.below_near(self.format));
            bounds.behind.push(roots.above_far());
        }
        for plane in self.planes.iter().flatten() {
            match plane.kind {
                PlaneKind::Front => bounds.before.push(plane.depth),
                PlaneKind::Back => bounds.behind.push(plane.depth),
                _ => {}
            }
        }
        bounds
    }

    fn constant(&self, depth: i64) -> Linear {
        Linear::new(0, 0, i128::from(depth) << self.format.guard_linear)
    }

    /// A solid is seen at its near root or at a front plane, whichever is farther; a patch at its near root if no plane
    /// takes that away.
    fn fronts(&self) -> Option<Vec<Linear>> {
        let near_end = self.constant(self.format.z_low());
        let mut fronts = match self.words.class {
            Class::Side => vec![near_end, self.roots.as_ref()?.above_near()],
            Class::Prism => vec![near_end],
            Class::Patch => vec![self.near_of_patch()?],
            Class::Front => return None,
        };
        for (plane, known) in self.words.planes.iter().zip(&self.planes) {
            if plane.kind == PlaneKind::Front {
                fronts.push(known.as_ref()?.depth);
            }
        }
        Some(fronts)
    }

    fn near_of_patch(&self) -> Option<Linear> {
        let roots = self.roots.as_ref()?;
        let near_end = self.constant(self.format.z_low());
        let cuts = |plane: &PlaneWords| matches!(plane.kind, PlaneKind::Front | PlaneKind::Back);
        let is_there = difference(&roots.below_near(self.format), &near_end, &self.window).low >= 0;
        (is_there && !self.words.planes.iter().any(cuts)).then(|| roots.above_near())
    }
}
