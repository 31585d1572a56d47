//! A prepared object, whatever processor draws it.

use super::PreparedQuadric;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::ProcessorWords;
use imogene_scene::Unseen;
use serde::Serialize;
use std::sync::Arc;

/// One object: the words of its processor, and what is known of them.
#[derive(Clone, Debug)]
pub enum PreparedObject {
    /// Words of a quadric processor.
    Quadric(Box<PreparedQuadric>),
    /// The same words for a patch processor.
    Patch(Box<PreparedQuadric>),
    /// Words of any other processor, one or more.
    Parts(Box<PreparedParts>),
    /// No words: the object was left out of the frame.
    Unseen(Arc<Unseen>),
}

/// An object of processors whose picture has no bounds that are proven pixel by pixel.
#[derive(Clone, Debug)]
pub struct PreparedParts {
    /// Name in the scene.
    pub name: String,
    /// Words of each processor; none if nothing is on the screen.
    pub words: Vec<ProcessorWords>,
    /// The box around all of them.
    pub screen_box: ScreenBox,
    /// Bits that each accumulator needs where the object is drawn: the most of all processors.
    pub needed: Vec<NeededWord>,
    /// What a person should know.
    pub notes: Vec<String>,
    /// Greatest distance of a drawn depth of the quadric from the true one, in depth words, if it is known.
    pub depth_bound: Option<f64>,
}

/// An accumulator, the bits it has, and those that it needs.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct NeededWord {
    /// Which expression.
    pub word: String,
    /// Bits that hold its value wherever the object is drawn.
    pub needed: u32,
    /// Bits of the format.
    pub available: u32,
}

impl PreparedObject {
    /// Name in the scene.
    pub fn name(&self) -> &str {
        match self {
            Self::Quadric(object) | Self::Patch(object) => &object.name,
            Self::Parts(parts) => &parts.name,
            Self::Unseen(unseen) => &unseen.name,
        }
    }

    /// What a person should know.
    pub fn notes(&self) -> &[String] {
        match self {
            Self::Quadric(object) | Self::Patch(object) => &object.notes,
            Self::Parts(parts) => &parts.notes,
            Self::Unseen(_) => &[],
        }
    }

    /// Adds what a person should know.
    pub(super) fn add_note(&mut self, note: &str) {
        let notes = match self {
            Self::Quadric(object) | Self::Patch(object) => &mut object.notes,
            Self::Parts(parts) => &mut parts.notes,
            Self::Unseen(_) => return,
        };
        notes.push(note.to_owned());
    }

    /// Where the object can be on the screen.
    pub fn screen_box(&self) -> &ScreenBox {
        match self {
            Self::Quadric(object) | Self::Patch(object) => &object.words.screen_box,
            Self::Parts(parts) => &parts.screen_box,
            Self::Unseen(_) => &ScreenBox::EMPTY,
        }
    }

    /// The words and bounds of an object of the quadric or the patch processor.
    pub fn quadric(&self) -> Option<&PreparedQuadric> {
        match self {
            Self::Quadric(object) | Self::Patch(object) => Some(object),
            Self::Parts(_) | Self::Unseen(_) => None,
        }
    }

    /// The words of each of its processors.
    pub fn words(&self) -> Vec<ProcessorWords> {
        match self {
            Self::Quadric(object) => vec![ProcessorWords::Quadric(object.words.clone())],
            Self::Patch(object) => vec![ProcessorWords::Patch(object.words.clone())],
            Self::Parts(parts) => parts.words.clone(),
            Self::Unseen(_) => vec![],
        }
    }
}

impl PreparedParts {
    /// An object of which nothing is drawn.
    pub(super) fn unseen(name: &str, note: &str) -> PreparedParts {
        PreparedParts {
            name: name.to_owned(),
            words: vec![],
            screen_box: ScreenBox::EMPTY,
            needed: vec![],
            notes: vec![note.to_owned()],
            depth_bound: None,
        }
    }
}
