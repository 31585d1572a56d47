//! The check of one object: a pass over its screen box, with the bounds, or beside the truth, at every pixel.

use super::accumulators::{accumulators, plane_bits};
use super::contour::{Displacement, displacement};
use super::depth::{depth_bound, worst_case, worst_terms};
use super::jury::{Judge, Jury};
use super::kind::quadric_kind;
use super::normal::normal_bound;
use super::outline::Presence;
use super::report::{
    Detail, Findings, ObjectBounds, PartsBounds, PartsReport, QuadricReport, Reviewed,
    adrift_problem, unshown_problem,
};
use super::verdict::decide;
use crate::metrics::Spread;
use imogene_golden::format::Format;
use imogene_golden::object::line::for_each_present;
use imogene_golden::object::quadric::{ObjectPixel, QuadricWords, ScreenBox};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::{Class, FACE_NEAR_END};
use imogene_prepare::{PreparedObject, PreparedQuadric};
use imogene_scene::{FramedObject, FramedQuadric};
use rayon::prelude::*;

pub(super) fn review(framed: &FramedQuadric, object: &PreparedQuadric, jury: &Jury) -> Reviewed {
    let prepared = jury.prepared;
    let format = &prepared.format;
    let window = object.words.screen_box;
    let line = |y| pass_line(object, format, y);
    let found = lines(&window).map(line);
    let mut found = found.reduce(Findings::default, Findings::merged);
    let silhouette = displacement(object, format);
    let adrift = match silhouette.pixels {
        // No outline can be a pixel away, whatever its pixels show.
        pixels if pixels < 1.0 => vec![],
        _ => jury.adrift(window, std::mem::take(&mut found.presence)),
    };
    found.undecided.adrift = adrift.len();
    let angles = Spread::of(found.angles.iter().copied().map(f64::from).collect());
    let bounds = ObjectBounds {
        f1: object.bounds.f1,
        f2: object.bounds.f2,
        planes: object.bounds.planes.clone(),
        depth_lsb: found.depth,
        depth_lsb_closed_form: worst_case(&object.bounds),
        depth_terms: worst_terms(&object.bounds),
        silhouette_px: silhouette.pixels,
        silhouette_singular: silhouette.singular.is_some(),
        normal_deg: angles.max,
        normal_deg_999: angles.quantile_999,
        normals_undetermined: found.undetermined,
    };
    let kind = quadric_kind(&framed.quadric);
    let words = &object.words;
    // None of an object that no pixel shows.
    let is_idle = |&index: &usize| {
        found.pixels > 0
            && words.planes[index].kind != PlaneKind::None
            && is_without_effect(words, index, format)
    };
    let idle: Vec<usize> = (0..words.planes.len()).filter(is_idle).collect();
    let problems = problems(object, format, &idle, &found, silhouette, &adrift);
    let planes = object.words.planes.iter().enumerate();
    let perpendicular = planes.filter(|(_, plane)| plane.kind == PlaneKind::Perpendicular);
    let report = QuadricReport {
        surface: framed.surface,
        class: object.words.class,
        planes: framed.planes.len(),
        front_view: object.words.class == Class::Front,
        prism: object.words.class == Class::Prism,
        degenerate: matches!(
            kind,
            "plane_pair" | "double_plane" | "plane" | "line" | "point" | "empty"
        ),
        perpendicular_planes: perpendicular.map(|(index, _)| index).collect(),
        needed: object.needed.clone(),
        accumulators: accumulators(object, (prepared.width, prepared.height), format),
        bounds,
        planes_without_effect: idle,
        angles: std::mem::take(&mut found.angles),
    };
    Reviewed {
        kind,
        problems,
        found,
        detail: Detail::Quadric(Box::new(report)),
    }
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

/// Of an object of another processor than quadric or patch, which is held against the truth at every pixel.
pub(super) fn review_parts(
    framed: &FramedObject,
    object: &PreparedObject,
    judge: &Judge,
    jury: &Jury,
) -> Reviewed {
    let window = judge.window();
    let line = |y: i64| {
        let mut found = Findings::default();
        let Judge::Truth(comparison) = judge else {
            return found;
        };
        for compared in comparison.line(y, window.x0..=window.x1) {
            let verdict = compared.verdict();
            found.pixels += usize::from(compared.is_drawn());
            found.depth = found.depth.max(compared.depth_error().unwrap_or(0.0));
            found.undecided.count(&verdict);
            found.presence.push(Presence::of(&verdict));
        }
        found
    };
    let found = lines(&window).map(line);
    let mut found = found.reduce(Findings::default, Findings::merged);
    let adrift = jury.adrift(window, std::mem::take(&mut found.presence));
    found.undecided.adrift = adrift.len();
    let mut problems = object.notes().to_vec();
    problems.extend(unshown_problem(object.screen_box(), found.pixels));
    problems.extend(adrift_problem(&adrift));
    let report = PartsReport {
        processors: object.words().len(),
        needed: match object {
            PreparedObject::Parts(parts) => parts.needed.clone(),
            _ => vec![],
        },
        bounds: PartsBounds {
            depth_lsb: found.depth,
        },
    };
    Reviewed {
        kind: kind(framed),
        found,
        problems,
        detail: Detail::Parts(report),
    }
}

fn kind(framed: &FramedObject) -> &'static str {
    match framed {
        FramedObject::Unseen(_) => "unseen",
        FramedObject::Polyhedron(_) => "polyhedron",
        FramedObject::Mesh(_) => "mesh",
        FramedObject::Sphere(_) | FramedObject::CurvedSphere(_) => "sphere",
        FramedObject::Cylinder(_) => "elliptic_cylinder",
        FramedObject::Quadric(q)
        | FramedObject::Patch(q)
        | FramedObject::FirstGeneration(q)
        | FramedObject::CurvedFacet(q) => quadric_kind(&q.quadric),
    }
}
