//! The check of one object: a golden pass over its screen box, with the bounds at every pixel.

use super::accumulators::{accumulators, plane_bits};
use super::contour::{Displacement, displacement};
use super::depth::{depth_bound, worst_case, worst_terms};
use super::jury::Jury;
use super::kind::quadric_kind;
use super::normal::normal_bound;
use super::outline::{Presence, Silhouette};
use super::pixels::{Findings, adrift_problem, unshown_problem};
use super::report::{Detail, ObjectBounds, QuadricReport, Reviewed};
use super::verdict::decide;
use imogene_golden::format::Format;
use imogene_golden::object::line::for_each_present;
use imogene_golden::object::quadric::{ObjectPixel, QuadricWords, ScreenBox};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{Class, FACE_NEAR_END};
use imogene_prepare::{PreparedQuadric, PreparedScene};
use imogene_scene::FramedQuadric;
use rayon::prelude::*;

pub(super) fn review(
    framed: &FramedQuadric,
    object: &PreparedQuadric,
    prepared: &PreparedScene,
    jury: &Jury,
) -> Reviewed {
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
    let kind = quadric_kind(&framed.quadric);
    let report = QuadricReport {
        surface: framed.surface,
        class: object.words.class,
        planes: framed.planes.len(),
        front_view: object.words.class == Class::Front,
        prism: object.words.class == Class::Prism,
        degenerate: is_degenerate(kind),
        perpendicular_planes: perpendicular_planes(&object.words),
        needed: object.needed.clone(),
        accumulators: accumulators(object, size, format),
        bounds,
        planes_without_effect: planes_without_effect(object, &found, format),
        angles: std::mem::take(&mut found.angles),
    };
    let without_effect = &report.planes_without_effect;
    Reviewed {
        kind,
        problems: problems(object, format, without_effect, &found, silhouette, &adrift),
        found,
        detail: Detail::Quadric(Box::new(report)),
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
    matches!(
        kind,
        "plane_pair" | "double_plane" | "plane" | "line" | "point" | "empty"
    )
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
    let is_shown = found.pixels > 0;
    let planes = 0..words.planes.len();
    planes.filter(|at| is_shown && idle(at)).collect()
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
