//! What is reported of an object of another processor than quadric or patch, which is held against the truth at every
//! pixel.

use super::jury::{Comparison, Judge, Jury};
use super::kind::quadric_kind;
use super::outline::{Presence, Silhouette};
use super::pixels::{Findings, Shown, Shows, Undecided, adrift_problem, unshown_problem};
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::ProcessorWords;
use imogene_prepare::{NeededWord, PreparedObject, PreparedScene};
use imogene_scene::FramedObject;
use rayon::prelude::*;
use serde::Serialize;

/// One object of a checked scene that another processor than quadric or patch draws.
#[derive(Clone, Debug, Serialize)]
pub struct PartsReport {
    /// Name in the scene.
    pub name: String,
    /// What it is, as in scene files.
    pub kind: &'static str,
    /// The processor that draws it.
    pub processor: &'static str,
    /// How many of them it takes.
    pub processors: usize,
    /// Where the object can be on the screen.
    pub screen_box: ScreenBox,
    /// Pixels at which a golden processor sees it, hidden or not.
    pub pixels: usize,
    /// Pixels of the golden picture that show it.
    pub visible_pixels: usize,
    /// Whether any does, and if not, why.
    pub shows: Shows,
    /// Whether its material mirrors light.
    pub highlights: bool,
    /// Bits that each accumulator needs.
    pub needed: Vec<NeededWord>,
    /// Bounds that hold at every pixel of the picture.
    pub bounds: PartsBounds,
    /// Pixels at which the golden object is not the true one.
    pub undecided: Undecided,
    /// What a person should know.
    pub problems: Vec<String>,
}

/// Bounds of one object.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct PartsBounds {
    /// Greatest depth error at any pixel at which both pictures show the same face, in depth words.
    pub depth_lsb: f64,
}

pub(super) fn report(
    framed: &FramedObject,
    object: &PreparedObject,
    judge: &Judge,
    prepared: &PreparedScene,
    jury: &Jury,
    shown: Shown,
) -> PartsReport {
    let words = object.words();
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
    let window = *object.screen_box();
    problems.extend(unshown_problem(&window, found.pixels));
    problems.extend(adrift_problem(&adrift));
    PartsReport {
        name: object.name().to_owned(),
        kind: kind(framed),
        processor: match words.first() {
            Some(ProcessorWords::Quotient(_)) => "quotient",
            _ => shown.processor,
        },
        processors: words.len(),
        screen_box: window,
        pixels: found.pixels,
        visible_pixels: shown.visible_pixels,
        shows: Shows::of(&window, found.pixels, shown.visible_pixels),
        highlights: shown.highlights,
        needed: match object {
            PreparedObject::Parts(parts) => parts.needed.clone(),
            _ => vec![],
        },
        bounds: PartsBounds {
            depth_lsb: found.depth,
        },
        undecided: found.undecided,
        problems,
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
