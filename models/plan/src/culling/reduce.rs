//! Objects without what no pixel shows of them: the box to the pixels that are drawn, planes that cut nothing, objects
//! that are nowhere; and, if some pixels may change, without what only so many show (source: Claux, III.3.2.1.3;
//! Coquillart, 3.4).

use super::part::in_box;
use super::precision::Bits;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::quadric::{ObjectPixel, PlaneWords, ScreenBox};
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE};
use imogene_prepare::{PreparedObject, PreparedScene};
use rayon::prelude::*;
use serde::Serialize;

/// What became of an object.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Fate {
    /// It is drawn.
    #[default]
    Drawn,
    /// It is at no pixel, alone on the screen.
    Nowhere,
    /// It is at fewer pixels than asked for.
    TooSmall,
}

/// One object, as it was and as it is.
#[derive(Clone, Debug, Default, Serialize)]
pub struct ReducedObject {
    /// Name in the scene.
    pub name: String,
    /// What became of it.
    pub fate: Fate,
    /// Processors that it had, and those that draw at least a pixel.
    pub processors: [u64; 2],
    /// Pixels that its processors visit: those of the boxes.
    pub visited: [u64; 2],
    /// Its cut planes.
    pub planes: [u64; 2],
    /// Depths of planes that are computed: planes times pixels visited.
    pub plane_depths: [u64; 2],
    /// Pixels at which its processors draw, alone on the screen; parts of a mesh count by themselves.
    pub drawn: u64,
    /// Pixels of the picture that show it.
    pub seen: u64,
    /// Pixels that it changed in being reduced, alone on the screen.
    pub changed: u64,
    /// Bits that it needs; none of a processor other than quadric and patch.
    pub bits: Option<Bits>,
    /// What is left of it.
    #[serde(skip)]
    pub words: Vec<ProcessorWords>,
    /// The numbers that its cut planes had.
    #[serde(skip)]
    faces: Vec<u8>,
}

/// A scene with only what its picture requires.
#[derive(Clone, Debug)]
pub struct Reduced {
    /// Its objects, in order; those that are not drawn have no words.
    pub objects: Vec<ReducedObject>,
}

impl Reduced {
    /// Reduces a scene whose frame is `frame`: an object at fewer than `pixels` pixels is left out, and planes of an
    /// object as long as no more than `pixels` of its pixels change. With 0 nothing changes.
    pub fn of(scene: &PreparedScene, frame: &Frame, pixels: u64) -> Reduced {
        let mut seen = vec![0; scene.objects.len()];
        for id in frame.id.iter().flat_map(|&id| usize::try_from(id)) {
            seen[id] += 1;
        }
        let objects = scene.objects.par_iter().zip(seen);
        let one = |(object, seen)| reduce(object, seen, &scene.format, pixels);
        Reduced {
            objects: objects.map(one).collect(),
        }
    }

    /// The processors of a machine that draws what is left; the ids are those of the scene.
    pub fn slots(&self) -> Vec<Slot> {
        let of = |(object, reduced): (usize, &ReducedObject)| {
            let words = reduced.words.clone().into_iter();
            words.map(move |words| Slot {
                object,
                words,
                weight: None,
            })
        };
        self.objects.iter().enumerate().flat_map(of).collect()
    }

    /// Gives the faces of a frame of [`Reduced::slots`] the numbers that they have in the scene.
    pub fn restore_faces(&self, frame: &mut Frame) {
        for (number, &id) in frame.number.iter_mut().zip(&frame.id) {
            if let Ok(id) = usize::try_from(id) {
                *number = old_number(&self.objects[id].faces, *number);
            }
        }
    }
}

/// The number of a face before planes were left out.
fn old_number(faces: &[u8], number: u8) -> u8 {
    match number.checked_sub(FACE_PLANE) {
        Some(plane) if number != FACE_NEAR_END => {
            faces.get(usize::from(plane)).copied().unwrap_or(number)
        }
        _ => number,
    }
}

/// A pixel of an object that is alone on the screen.
type Drawn = (i64, i64, ObjectPixel);

fn draw(words: &ProcessorWords, format: &Format) -> Vec<Drawn> {
    let window = words.screen_box();
    let mut drawn = vec![];
    for y in window.y0..=window.y1 {
        words.for_each_present(format, y, |x, pixel| drawn.push((x, y, pixel)));
    }
    drawn
}

fn box_around(drawn: &[Drawn]) -> ScreenBox {
    let boxes = drawn.iter().map(|&(x, y, _)| ScreenBox::of([x, x], [y, y]));
    boxes.fold(ScreenBox::EMPTY, |around, one| around.around(&one))
}

fn reduce(object: &PreparedObject, seen: u64, format: &Format, pixels: u64) -> ReducedObject {
    let before = object.words();
    let parts: Vec<Vec<Drawn>> = before.iter().map(|words| draw(words, format)).collect();
    let drawn: u64 = parts.iter().map(|drawn| drawn.len() as u64).sum();
    let mut reduced = ReducedObject {
        name: object.name().to_owned(),
        processors: [before.len() as u64, 0],
        drawn,
        seen,
        ..ReducedObject::default()
    };
    before.iter().for_each(|words| reduced.count(words, 0));
    if drawn == 0 || drawn < pixels {
        reduced.changed = drawn;
        reduced.fate = if drawn == 0 {
            Fate::Nowhere
        } else {
            Fate::TooSmall
        };
        return reduced;
    }
    for (words, drawn) in before.iter().zip(&parts) {
        if !drawn.is_empty() {
            let budget = pixels - reduced.changed.min(pixels);
            reduced.add(in_box(words, box_around(drawn)), drawn, format, budget);
        }
    }
    reduced
}

impl ReducedObject {
    /// Counts the work of some words as they were (0) or as they are (1).
    fn count(&mut self, words: &ProcessorWords, when: usize) {
        let (pixels, planes) = (words.screen_box().pixels(), planes_of(words).len() as u64);
        self.visited[when] += pixels;
        self.planes[when] += planes;
        self.plane_depths[when] += planes * pixels;
    }

    fn add(&mut self, words: ProcessorWords, drawn: &[Drawn], format: &Format, budget: u64) {
        let kept = PlaneSearch::new(&words, drawn, format).keep(budget);
        self.changed += kept.changed;
        self.count(&kept.words, 1);
        self.processors[1] += 1;
        if let ProcessorWords::Quadric(words) | ProcessorWords::Patch(words) = &kept.words {
            let bits = Bits::of(words, format);
            self.bits = Some(self.bits.map_or(bits, |others| others.or(bits)));
        }
        // An object with cut planes has one processor.
        self.faces = kept.faces;
        self.words.push(kept.words);
    }
}

/// The planes that can be left out; those of other processors are part of what they are.
fn planes_of(words: &ProcessorWords) -> &[PlaneWords] {
    match words {
        ProcessorWords::Quadric(words) | ProcessorWords::Patch(words) => &words.planes,
        ProcessorWords::Polyhedron(words) => &words.planes,
        _ => &[],
    }
}

fn without_plane(words: &ProcessorWords, plane: usize) -> ProcessorWords {
    let mut words = words.clone();
    match &mut words {
        ProcessorWords::Quadric(words) | ProcessorWords::Patch(words) => &mut words.planes,
        ProcessorWords::Polyhedron(words) => &mut words.planes,
        _ => return words,
    }
    .remove(plane);
    words
}

struct PlaneSearch<'a> {
    words: ProcessorWords,
    faces: Vec<u8>,
    changed: u64,
    drawn: &'a [Drawn],
    format: &'a Format,
}

impl<'a> PlaneSearch<'a> {
    fn new(words: &ProcessorWords, drawn: &'a [Drawn], format: &'a Format) -> Self {
        let faces = (FACE_PLANE..).take(planes_of(words).len()).collect();
        PlaneSearch {
            words: words.clone(),
            faces,
            changed: 0,
            drawn,
            format,
        }
    }

    /// Leaves out the plane that changes least as long as no more than `budget` pixels are other than they were. A
    /// polyhedron keeps one plane.
    fn keep(mut self, budget: u64) -> Self {
        let fewest = usize::from(matches!(self.words, ProcessorWords::Polyhedron(_)));
        while planes_of(&self.words).len() > fewest {
            let tried = (0..planes_of(&self.words).len()).map(|plane| self.without(plane));
            let Some(best) = tried.min_by_key(|tried| tried.changed) else {
                break;
            };
            if best.changed > budget {
                break;
            }
            self = best;
        }
        self
    }

    fn without(&self, plane: usize) -> Self {
        let mut faces = self.faces.clone();
        faces.remove(plane);
        let words = without_plane(&self.words, plane);
        let changed = difference(self.drawn, &draw(&words, self.format), &faces);
        PlaneSearch {
            words,
            faces,
            changed,
            ..*self
        }
    }
}

/// Pixels that are not the same in two drawings of an object, both line by line; `faces` are the old numbers of the
/// second one's planes.
fn difference(before: &[Drawn], after: &[Drawn], faces: &[u8]) -> u64 {
    let mut after = after.iter().copied().peekable();
    let mut differ = 0;
    for &(x, y, pixel) in before {
        while after.next_if(|&(u, v, _)| (v, u) < (y, x)).is_some() {
            differ += 1;
        }
        let same = after.next_if(|&(u, v, _)| (u, v) == (x, y));
        let same = same.is_some_and(|(_, _, new)| {
            let number = old_number(faces, new.number);
            ObjectPixel { number, ..new } == pixel
        });
        differ += u64::from(!same);
    }
    differ + after.count() as u64
}
