//! What is proven of every object of a scene at every pixel, whatever processor draws it.

use super::depth::Range;
use super::outline::{Presence, Silhouette};
use super::truth::{Columns, True, Truth};
use super::verdict::{Contest, Verdict, decide};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::depth_interval::FACE_PLANE;
use imogene_prepare::{PreparedObject, PreparedQuadric, PreparedScene};
use imogene_scene::{FramedObject, FramedScene};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// What is proven of the objects of a scene: which pixels of its picture rounding leaves open.
pub struct Jury<'a> {
    pub(super) prepared: &'a PreparedScene,
    judges: Vec<Judge<'a>>,
    transparent: BTreeSet<usize>,
}

pub(super) enum Judge<'a> {
    /// From the rounding bounds of its words.
    Words(&'a PreparedQuadric, Format),
    /// Nothing of it is on the screen.
    Nothing,
    /// From the truth at each pixel.
    Truth(Box<Comparison>),
}

/// The words of processors without bounds, and the truth beside them.
pub(super) struct Comparison {
    words: Vec<ProcessorWords>,
    window: ScreenBox,
    truth: Truth,
    format: Format,
    /// Numbers of the two plane faces of the first generation, which counts them as front and back.
    plane_faces: Option<[u8; 2]>,
}

/// The golden face at a pixel, if there is one, and the true one.
#[derive(Clone, Copy, Debug)]
pub(super) struct Compared {
    golden: Option<(u8, i64)>,
    truth: True,
}

impl<'a> Jury<'a> {
    /// `prepared` must come from `scene`.
    pub fn new(scene: &FramedScene, prepared: &'a PreparedScene) -> Jury<'a> {
        let objects = scene.objects.par_iter().zip(&prepared.objects);
        let judge = |(framed, object): (&FramedObject, &'a PreparedObject)| {
            Judge::new(framed, object, scene, &prepared.format)
        };
        Jury {
            prepared,
            judges: objects.map(judge).collect(),
            transparent: prepared.transparent.clone(),
        }
    }

    /// By the rounding bounds of the words alone: opaque objects of the quadric and the patch processor.
    pub fn of_words(prepared: &'a PreparedScene) -> Jury<'a> {
        Jury::of_some_words(prepared, |id| !prepared.transparent.contains(&id))
    }

    /// The same of one object alone.
    pub fn of_words_alone(prepared: &'a PreparedScene, object: usize) -> Jury<'a> {
        Jury::of_some_words(prepared, |id| id == object)
    }

    fn of_some_words(prepared: &'a PreparedScene, takes: impl Fn(usize) -> bool) -> Jury<'a> {
        let judge = |(id, object): (usize, &'a PreparedObject)| match object.quadric() {
            Some(quadric) if takes(id) => Judge::Words(quadric, prepared.format),
            _ => Judge::Nothing,
        };
        Jury {
            prepared,
            judges: prepared.objects.iter().enumerate().map(judge).collect(),
            transparent: BTreeSet::new(),
        }
    }

    pub(super) fn judge(&self, id: usize) -> &Judge<'a> {
        &self.judges[id]
    }

    /// For every pixel of the picture, row-major, whether rounding could change the visible object or face;
    /// everywhere else golden and true picture are proven to show the same face of the same object.
    pub fn undecided(&self) -> Vec<bool> {
        let lines = (0..i64::from(self.prepared.height)).into_par_iter();
        let contests = lines.flat_map_iter(|y| self.line(y));
        contests.map(|contest| !contest.is_decided()).collect()
    }

    /// The same for one pixel.
    pub fn is_undecided(&self, x: i64, y: i64) -> bool {
        !self.contests(y, x..=x)[0].is_decided()
    }

    /// The pixels of a box at which the outline of an object is adrift and not hidden behind something else.
    pub(super) fn adrift(&self, window: ScreenBox, presence: Vec<Presence>) -> Vec<(i64, i64)> {
        let silhouette = Silhouette {
            window,
            presence,
            size: (self.prepared.width, self.prepared.height),
        };
        let mut adrift = silhouette.adrift();
        adrift.retain(|&(x, y)| self.is_undecided(x, y));
        adrift
    }

    pub(super) fn line(&self, y: i64) -> Vec<Contest> {
        self.contests(y, 0..=i64::from(self.prepared.width) - 1)
    }

    fn contests(&self, y: i64, columns: Columns) -> Vec<Contest> {
        let first = *columns.start();
        let count = columns.clone().count();
        let mut contests = vec![Contest::EMPTY; count];
        let mut layers: Vec<Vec<Verdict>> = vec![vec![]; count];
        for (id, judge) in self.judges.iter().enumerate() {
            let is_layer = self.transparent.contains(&id);
            judge.for_each(y, columns.clone(), |x, verdict| {
                let place = (x - first) as usize;
                match is_layer {
                    true => layers[place].push(verdict),
                    false => contests[place].enter(id, &verdict),
                }
            });
        }
        if !self.transparent.is_empty() {
            let both = contests.iter_mut().zip(&layers);
            both.for_each(|(contest, layers)| contest.see_through(layers));
        }
        contests
    }
}

impl<'a> Judge<'a> {
    fn new(
        framed: &FramedObject,
        object: &'a PreparedObject,
        scene: &FramedScene,
        format: &Format,
    ) -> Judge<'a> {
        if let Some(quadric) = object.quadric() {
            return Judge::Words(quadric, *format);
        }
        let words = object.words();
        if framed.is_unseen() {
            return Judge::Nothing;
        }
        // A mesh may be there where its rounded facets are not; any other object is nowhere beside its box.
        if words.is_empty() && !matches!(framed, FramedObject::Mesh(_)) {
            return Judge::Nothing;
        }
        let truth = Truth::new(framed, scene, format);
        let window = match truth.window() {
            Some(own) => {
                let both = own.around(object.screen_box());
                both.in_zone(0, 0, scene.width.into(), scene.height.into())
            }
            None => *object.screen_box(),
        };
        let is_first_generation = matches!(words.first(), Some(ProcessorWords::FirstGeneration(_)));
        let face = |index: Option<usize>| FACE_PLANE + index.unwrap_or(0) as u8;
        Judge::Truth(Box::new(Comparison {
            plane_faces: is_first_generation.then(|| truth.front_and_back().map(face)),
            words,
            window,
            truth,
            format: *format,
        }))
    }

    /// Where the object can be; beside it is absent.
    pub fn window(&self) -> ScreenBox {
        match self {
            Judge::Words(object, _) => object.words.screen_box,
            Judge::Nothing => ScreenBox::EMPTY,
            Judge::Truth(comparison) => comparison.window,
        }
    }

    /// Calls `sink` for the pixels of a line between two columns that lie in the window.
    pub fn for_each(&self, y: i64, columns: Columns, mut sink: impl FnMut(i64, Verdict)) {
        let window = self.window();
        if window.is_empty() || !(window.y0..=window.y1).contains(&y) {
            return;
        }
        let columns = window.x0.max(*columns.start())..=window.x1.min(*columns.end());
        match self {
            Judge::Nothing => {}
            Judge::Words(object, format) => {
                columns.for_each(|x| sink(x, decide(object, format, x, y)));
            }
            Judge::Truth(comparison) => {
                let line = (*columns.start()..).zip(comparison.line(y, columns));
                line.for_each(|(x, found)| sink(x, found.verdict()));
            }
        }
    }
}

impl Comparison {
    /// Golden and true picture of a part of a line.
    pub fn line(&self, y: i64, columns: Columns) -> Vec<Compared> {
        let first = *columns.start();
        let golden = None;
        let truth = self.truth.line(y, columns).into_iter();
        let mut line: Vec<Compared> = truth.map(|truth| Compared { golden, truth }).collect();
        for words in &self.words {
            words.for_each_present(&self.format, y, |x, pixel| {
                let index = usize::try_from(x - first).ok();
                let Some(found) = index.and_then(|index| line.get_mut(index)) else {
                    return;
                };
                if found.golden.is_none_or(|(_, z)| pixel.zf < z) {
                    found.golden = Some((self.number(pixel.number), pixel.zf));
                }
            });
        }
        line
    }

    fn number(&self, number: u8) -> u8 {
        let index = number.checked_sub(FACE_PLANE).map(usize::from);
        match (self.plane_faces, index) {
            (Some(faces), Some(index)) => faces[index],
            _ => number,
        }
    }
}

impl Compared {
    /// The object is absent or shows one face in both pictures, or the pixel is open.
    pub fn verdict(&self) -> Verdict {
        match (self.golden, self.truth) {
            (None, None) => Verdict::Absent,
            (Some((number, z)), Some((face, depth))) if number == face => {
                let z = z as f64;
                Verdict::Face(face, Range::new(depth.low.min(z), depth.high.max(z)))
            }
            (golden, truth) => {
                let golden = golden.map_or(f64::INFINITY, |(_, z)| z as f64);
                Verdict::Undecided {
                    nearest: golden.min(truth.map_or(f64::INFINITY, |(_, depth)| depth.low)),
                    silhouette: truth.is_none() || golden.is_infinite(),
                }
            }
        }
    }

    /// How far the golden depth is from the true one at most, where both pictures show one face.
    pub fn depth_error(&self) -> Option<f64> {
        let ((number, z), (face, depth)) = self.golden.zip(self.truth)?;
        let z = z as f64;
        (number == face).then(|| (z - depth.low).max(depth.high - z))
    }

    /// Whether the golden picture shows it.
    pub fn is_drawn(&self) -> bool {
        self.golden.is_some()
    }
}
