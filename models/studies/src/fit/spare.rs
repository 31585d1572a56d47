//! Cut planes that an object can do without: the order in which it loses them, and what each costs.

use super::frames::{Frame, wide};
use imogene_golden::machine::frame::Frame as Picture;
use imogene_golden::object::quadric::ObjectPixel;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::depth_interval::FACE_PLANE;
use imogene_prepare::{Framing, LocatedScene, Options};
use imogene_scene::SceneFile;
use std::collections::BTreeMap;

/// Pixels that show the loss of a plane, after those lost before it, in the worst frame; its index among the cuts.
type SparePlane = (u64, usize);

pub(super) struct View<'a> {
    picture: &'a Picture,
    object: i32,
    /// The scene with this object alone.
    file: SceneFile,
    size: (u32, u32),
    /// What it draws with all of its planes.
    whole: Pixels,
}

/// Pixels of an object by line and column.
type Pixels = BTreeMap<(i64, i64), ObjectPixel>;

impl<'a> View<'a> {
    /// Of the object with an index in a frame, which a golden machine of long words draws so; none if it has no planes
    /// that it could lose.
    pub(super) fn of(
        index: usize,
        frame: &Frame,
        file: &SceneFile,
        picture: &'a Picture,
    ) -> Option<View<'a>> {
        let name = frame.scene.objects[index].name();
        let own = file.objects.iter().find(|object| object.name == name)?;
        let planes = own.cuts.len();
        if planes == 0 {
            return None;
        }
        let mut file = file.clone();
        file.objects.retain(|object| object.name == name);
        file.solids.clear();
        let size = (frame.scene.width, frame.scene.height);
        let whole = drawn(&file, size, planes)?;
        Some(View {
            picture,
            object: i32::try_from(index).expect("an index of an object"),
            file,
            size,
            whole,
        })
    }

    /// Pixels that change with these planes alone; none where no machine draws it so.
    fn changed(&self, kept: &[usize]) -> Option<u64> {
        let mut file = self.file.clone();
        let cuts = &self.file.objects[0].cuts;
        file.objects[0].cuts = kept.iter().map(|&plane| cuts[plane].clone()).collect();
        let after = drawn(&file, self.size, kept.len())?;
        // The number of a face when all planes were there.
        let number = |number: u8| {
            let plane = number.checked_sub(FACE_PLANE).map(usize::from);
            let plane = plane.and_then(|plane| kept.get(plane));
            plane.map_or(number, |&plane| FACE_PLANE + plane as u8)
        };
        let lost = self.whole.keys().filter(|at| !after.contains_key(at));
        let lost = lost.filter(|at| self.is_seen(at)).count();
        let other = after.iter().filter(|(at, pixel)| {
            let before = self.whole.get(at);
            let is_same = before.is_some_and(|before| before.number == number(pixel.number));
            !is_same && (self.is_seen(at) || pixel.zf < self.picture.depth[self.index(at)])
        });
        Some((lost + other.count()) as u64)
    }

    fn index(&self, (y, x): &(i64, i64)) -> usize {
        *y as usize * self.size.0 as usize + *x as usize
    }

    fn is_seen(&self, at: &(i64, i64)) -> bool {
        self.picture.id[self.index(at)] == self.object
    }
}

/// What a scene of one object draws; none where no machine draws it, or its processor is not one of so many planes that
/// can be left out.
fn drawn(file: &SceneFile, size: (u32, u32), planes: usize) -> Option<Pixels> {
    let scene = file.frame(size.0, size.1).ok()?;
    let located = LocatedScene::new(&scene);
    let prepared = located.prepare(&scene, wide(), Options::HARDWARE).ok()?;
    let [slot] = &prepared.slots()[..] else {
        return None;
    };
    let own = match &slot.words {
        ProcessorWords::Quadric(words) | ProcessorWords::Patch(words) => words.planes.len(),
        ProcessorWords::Polyhedron(words) => words.planes.len(),
        _ => return None,
    };
    let window = slot.words.screen_box();
    let mut pixels = Pixels::new();
    for y in window.y0..=window.y1 {
        slot.words
            .for_each_present(&prepared.format, y, |x, pixel| {
                pixels.insert((y, x), pixel);
            });
    }
    (own == planes).then_some(pixels)
}

/// The planes that an object can lose, the one that is missed least first, as long as fewer than `over` pixels of every
/// frame are other than they were. Its views are those of all frames.
pub(super) fn spare_planes(views: &[View], over: u64) -> Vec<SparePlane> {
    let mut kept: Vec<usize> = (0..views[0].file.objects[0].cuts.len()).collect();
    let mut spare: Vec<SparePlane> = vec![];
    while !kept.is_empty() {
        let without = |plane: usize| kept.iter().copied().filter(move |kept| *kept != plane);
        let tried = kept.iter().filter_map(|&plane| {
            let left: Vec<usize> = without(plane).collect();
            let mut most = 0;
            for view in views {
                most = view.changed(&left)?.max(most);
            }
            Some((most, plane))
        });
        let least = tried.min_by_key(|(pixels, _)| *pixels);
        let Some((pixels, least)) = least.filter(|(pixels, _)| *pixels < over) else {
            break;
        };
        // Two planes can make up for a third: it still goes after those that it was missed less than.
        let before = spare.last().map_or(0, |(pixels, _)| *pixels);
        kept.retain(|plane| *plane != least);
        spare.push((pixels.max(before), least));
    }
    spare
}
