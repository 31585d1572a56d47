//! What is reported of an object whose processor has no bounds that are proven pixel by pixel.

use super::kind::quadric_kind;
use super::summary::Shows;
use crate::format::Format;
use crate::object::quadric::ScreenBox;
use crate::object::slot::ProcessorWords;
use crate::prepare::{NeededWord, PreparedObject};
use crate::scene::FramedObject;
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
    /// What a person should know.
    pub problems: Vec<String>,
}

pub(super) fn report(
    framed: &FramedObject,
    object: &PreparedObject,
    format: &Format,
) -> PartsReport {
    let words = object.words();
    let window = *object.screen_box();
    let pixels = pixels(&words, &window, format);
    let mut problems = object.notes().to_vec();
    if pixels == 0 && !window.is_empty() {
        problems.push(
            "no pixel shows it: it falls between the pixels, or its planes leave nothing".into(),
        );
    }
    PartsReport {
        name: object.name().to_owned(),
        kind: kind(framed),
        processor: match words.first() {
            Some(ProcessorWords::Quotient(_)) => "quotient",
            _ => framed.processor(),
        },
        processors: words.len(),
        screen_box: window,
        pixels,
        // Of the whole picture, which the caller knows.
        visible_pixels: 0,
        shows: Shows::EmptyBox,
        highlights: false,
        needed: match object {
            PreparedObject::Parts(parts) => parts.needed.clone(),
            PreparedObject::Quadric(_) | PreparedObject::Patch(_) => vec![],
        },
        problems,
    }
}

fn pixels(words: &[ProcessorWords], window: &ScreenBox, format: &Format) -> usize {
    let mut count = 0;
    for y in window.y0..=window.y1 {
        let mut line = vec![false; (window.x1 - window.x0 + 1).max(0) as usize];
        for one in words {
            one.for_each_present(format, y, |x, _| line[(x - window.x0) as usize] = true);
        }
        count += line.into_iter().filter(|&seen| seen).count();
    }
    count
}

fn kind(framed: &FramedObject) -> &'static str {
    match framed {
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
