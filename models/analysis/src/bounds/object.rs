//! The check of one object: a golden pass over its screen box, with the bounds at every pixel.

use super::accumulators::{Accumulators, accumulators, plane_bits};
use super::contour::{Displacement, displacement};
use super::depth::{DepthTerms, depth_bound, worst_case, worst_terms};
use super::jury::Jury;
use super::kind::quadric_kind;
use super::normal::normal_bound;
use super::outline::{Presence, Silhouette};
use super::pixels::{Findings, Shown, Shows, Undecided, adrift_problem, unshown_problem};
use super::verdict::decide;
use imogene_golden::format::Format;
use imogene_golden::object::line::for_each_present;
use imogene_golden::object::quadric::{ObjectPixel, QuadricWords, ScreenBox};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{Class, FACE_NEAR_END};
use imogene_prepare::{NeededWidths, PreparedQuadric, PreparedScene};
use imogene_scene::{FramedQuadric, Surface};
use rayon::prelude::*;
use serde::Serialize;

/// One object of a checked scene that a quadric or a patch processor draws.
#[derive(Clone, Debug, Serialize)]
pub struct QuadricReport {
    /// Name in the scene.
    pub name: String,
    /// Type of the quadric, as in scene files.
    pub kind: &'static str,
    /// The processor that draws it.
    pub processor: &'static str,
    /// Volume or surface.
    pub surface: Surface,
    /// How the object lies to the viewer.
    pub class: Class,
    /// Number of cut planes.
    pub planes: usize,
    /// Where the object can be on the screen.
    pub screen_box: ScreenBox,
    /// Pixels at which the golden processor sees it, hidden or not.
    pub pixels: usize,
    /// Pixels of the golden picture that show it.
    pub visible_pixels: usize,
    /// Whether any does, and if not, why.
    pub shows: Shows,
    /// Whether its material mirrors light.
    pub highlights: bool,
    /// Whether it is of class front: the viewer is inside the unbounded quadric.
    pub front_view: bool,
    /// Whether it is a prism: the quadric does not depend on the depth.
    pub prism: bool,
    /// Whether the quadric is no curved surface: planes, a line, a point, or nothing.
    pub degenerate: bool,
    /// Indices of the cut planes that are half-planes of the screen.
    pub perpendicular_planes: Vec<usize>,
    /// Indices of the cut planes that change no pixel.
    pub planes_without_effect: Vec<usize>,
    /// Bits that each accumulator needs.
    pub needed: NeededWidths,
    /// Bits that the values take at the pixels of the box, exactly; `None` if the box is empty.
    pub accumulators: Option<Accumulators>,
    /// Bounds that hold at every pixel of the box.
    pub bounds: ObjectBounds,
    /// Pixels of the box that rounding could change.
    pub undecided: Undecided,
    /// What a person should know.
    pub problems: Vec<String>,
    /// The normal bounds that the scene's quantile is taken of.
    #[serde(skip)]
    pub(super) angles: Vec<f32>,
}

/// Bounds of one object.
#[derive(Clone, Debug, Default, Serialize)]
pub struct ObjectBounds {
    /// Rounding of f1, in depth words.
    pub f1: f64,
    /// Rounding of f2, in its last bit.
    pub f2: f64,
    /// Rounding of each plane, in its last bit.
    pub planes: Vec<f64>,
    /// Greatest depth error at any pixel at which the object is present, in depth words.
    pub depth_lsb: f64,
    /// The same in closed form, whatever the pixels.
    pub depth_lsb_closed_form: f64,
    /// The terms of the closed form that the quadric's faces add up, in depth words.
    pub depth_terms: DepthTerms,
    /// Greatest displacement of the silhouette, in pixels.
    pub silhouette_px: f64,
    /// True if the silhouette has a point without direction: the apex of a double cone, or an object that all but
    /// vanishes.
    pub silhouette_singular: bool,
    /// Greatest angle of a normal whose direction the words determine, in degrees.
    pub normal_deg: f64,
    /// 99.9 % of these normals are within this angle, in degrees.
    pub normal_deg_999: f64,
    /// Pixels whose normal the words do not determine.
    pub normals_undetermined: usize,
}

pub(super) fn review(
    framed: &FramedQuadric,
    object: &PreparedQuadric,
    prepared: &PreparedScene,
    jury: &Jury,
    shown: Shown,
) -> QuadricReport {
    let format = &prepared.format;
    let window = object.words.screen_box;
    let mut found = lines(&window)
        .map(|y| pass_line(object, format, y))
        .reduce(Findings::default, Findings::merged);
    let silhouette = displacement(object, format);
    let size = (prepared.width, prepared.height);
    let adrift = match silhouette.pixels {
        // No outline can be a pixel away, whatever its pixels show.
        pixels if pixels < 1.0 => vec![],
        _ => jury.adrift(&Silhouette {
            window,
            presence: std::mem::take(&mut found.presence),
            size,
        }),
    };
    found.undecided.adrift = adrift.len();
    let bounds = ObjectBounds {
        f1: object.bounds.f1,
        f2: object.bounds.f2,
        planes: object.bounds.planes.clone(),
        depth_lsb: found.depth,
        depth_lsb_closed_form: worst_case(&object.bounds),
        depth_terms: worst_terms(&object.bounds),
        silhouette_px: silhouette.pixels,
        silhouette_singular: silhouette.singular.is_some(),
        normal_deg: found.angles.iter().copied().fold(0.0, f32::max).into(),
        normal_deg_999: quantile_999(&mut found.angles),
        normals_undetermined: found.undetermined,
    };
    let without_effect = planes_without_effect(object, &found, format);
    QuadricReport {
        name: object.name.clone(),
        kind: quadric_kind(&framed.quadric),
        processor: shown.processor,
        surface: framed.surface,
        class: object.words.class,
        planes: framed.planes.len(),
        screen_box: window,
        pixels: found.pixels,
        visible_pixels: shown.visible_pixels,
        shows: Shows::of(&window, found.pixels, shown.visible_pixels),
        highlights: shown.highlights,
        front_view: object.words.class == Class::Front,
        prism: object.words.class == Class::Prism,
        degenerate: is_degenerate(quadric_kind(&framed.quadric)),
        perpendicular_planes: perpendicular_planes(&object.words),
        needed: object.needed.clone(),
        accumulators: accumulators(object, size, format),
        bounds,
        undecided: found.undecided,
        problems: problems(object, format, &without_effect, &found, silhouette, &adrift),
        planes_without_effect: without_effect,
        angles: found.angles,
    }
}

/// The angle that all but one in a thousand of the values stay within; zero if there are none.
pub(super) fn quantile_999(angles: &mut [f32]) -> f64 {
    if angles.is_empty() {
        return 0.0;
    }
    let index = (angles.len() * 999).div_ceil(1000) - 1;
    f64::from(*angles.select_nth_unstable_by(index, f32::total_cmp).1)
}

fn lines(window: &ScreenBox) -> impl ParallelIterator<Item = i64> + use<> {
    (window.y0..window.y1 + 1).into_par_iter()
}

fn pass_line(object: &PreparedQuadric, format: &Format, y: i64) -> Findings {
    let words = &object.words;
    let mut found = Findings::default();
    for_each_present(words, format, y, |x, pixel| {
        let f2 = words.f2_at(x, y, format);
        found.pixels += 1;
        found.near_end += usize::from(pixel.number == FACE_NEAR_END);
        found.depth = found.depth.max(depth_bound(object, pixel.number, f2));
        let angle = normal_bound(object, pixel.number, f2, pixel.normal);
        if angle < 180.0 {
            found.angles.push(angle as f32);
        } else {
            found.undetermined += 1;
        }
    });
    for x in words.screen_box.x0..=words.screen_box.x1 {
        let verdict = decide(object, format, x, y);
        found.undecided.count(&verdict);
        found.presence.push(Presence::of(&verdict));
    }
    found
}

fn problems(
    object: &PreparedQuadric,
    format: &Format,
    without_effect: &[usize],
    found: &Findings,
    silhouette: Displacement,
    adrift: &[(i64, i64)],
) -> Vec<String> {
    let mut problems = object.notes.clone();
    let window = &object.words.screen_box;
    problems.extend(unshown_problem(window, found.pixels));
    if found.near_end > 0 {
        problems.push(format!(
            "reaches nearer than the near end at {} pixels; a flat cap is drawn there",
            found.near_end
        ));
    }
    for (index, bits) in plane_bits(&object.words).into_iter().enumerate() {
        if bits > format.plane {
            problems.push(format!(
                "cut {index}, rounded, reaches {bits} bits on the screen box and wraps: the plane word has {}",
                format.plane
            ));
        }
    }
    for index in without_effect {
        problems.push(format!(
            "cut {index} changes no pixel of the screen box, which already leaves out what it removes beside the object"
        ));
    }
    if let Some((x, y)) = silhouette.singular {
        problems.push(format!(
            "the silhouette has no direction near pixel ({x}, {y}), as at the apex of a cone; it is displaced by at most {:.2} pixels",
            silhouette.pixels
        ));
    }
    problems.extend(adrift_problem(adrift));
    if found.undetermined > 0 {
        problems.push(format!(
            "the normal vanishes, or nearly, at {} pixels; its direction is not determined there",
            found.undetermined
        ));
    }
    problems
}

/// Kinds of quadrics that are no curved surface.
fn is_degenerate(kind: &str) -> bool {
    let kinds = [
        "plane_pair",
        "double_plane",
        "plane",
        "line",
        "point",
        "empty",
    ];
    kinds.contains(&kind)
}

fn perpendicular_planes(words: &QuadricWords) -> Vec<usize> {
    let is = |&index: &usize| words.planes[index].kind == PlaneKind::Perpendicular;
    (0..words.planes.len()).filter(is).collect()
}

/// None of an object that no pixel shows.
fn planes_without_effect(
    object: &PreparedQuadric,
    found: &Findings,
    format: &Format,
) -> Vec<usize> {
    let words = &object.words;
    let idle = |&index: &usize| {
        words.planes[index].kind != PlaneKind::None && is_without_effect(words, index, format)
    };
    let planes = 0..words.planes.len();
    planes
        .filter(|index| found.pixels > 0 && idle(index))
        .collect()
}

/// True if the golden processor sees the same on every pixel of the box without this plane.
fn is_without_effect(words: &QuadricWords, index: usize, format: &Format) -> bool {
    let mut without = words.clone();
    without.planes[index].kind = PlaneKind::None;
    lines(&words.screen_box).all(|y| line_of(words, format, y) == line_of(&without, format, y))
}

fn line_of(words: &QuadricWords, format: &Format, y: i64) -> Vec<(i64, ObjectPixel)> {
    let mut line = vec![];
    for_each_present(words, format, y, |x, pixel| line.push((x, pixel)));
    line
}
