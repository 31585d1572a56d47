//! What is reported of an object of another processor than quadric or patch, which is held against the truth at every
//! pixel.

use super::jury::{Comparison, Judge, Jury};
use super::kind::quadric_kind;
use super::outline::{Presence, Silhouette};
use super::pixels::{Findings, adrift_problem, unshown_problem};
use super::report::{Detail, PartsBounds, PartsReport, Reviewed};
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::{PreparedObject, PreparedScene};
use imogene_scene::FramedObject;
use rayon::prelude::*;

pub(super) fn report(
    framed: &FramedObject,
    object: &PreparedObject,
    judge: &Judge,
    prepared: &PreparedScene,
    jury: &Jury,
) -> Reviewed {
    let mut found = match judge {
        Judge::Truth(comparison) => findings(comparison, &judge.window()),
        Judge::Words(..) | Judge::Nothing => Findings::default(),
    };
    let adrift = jury.adrift(&Silhouette {
        window: judge.window(),
        presence: std::mem::take(&mut found.presence),
        size: (prepared.width, prepared.height),
    });
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

fn findings(comparison: &Comparison, window: &ScreenBox) -> Findings {
    let line = |y: i64| {
        let mut found = Findings::default();
        for compared in comparison.line(y, window.x0..=window.x1) {
            let verdict = compared.verdict();
            found.pixels += usize::from(compared.is_drawn());
            found.depth = found.depth.max(compared.depth_error().unwrap_or(0.0));
            found.undecided.count(&verdict);
            found.presence.push(Presence::of(&verdict));
        }
        found
    };
    let lines = (window.y0..window.y1 + 1).into_par_iter();
    lines.map(line).reduce(Findings::default, Findings::merged)
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
