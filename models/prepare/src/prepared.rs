//! What a preparation gives of each object and volume: words, and what is known of them.

use super::forms::{LinearForm, QuadraticForm};
use super::rounding::Anchor;
use imogene_contract::slots::FittedSlot;
use imogene_contract::{MachineWords, RootForm};
use imogene_golden::format::Format;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::VolumeWords;
use imogene_golden::unit::root::{Method, fast_root, root};
use imogene_scene::Unseen;
use serde::Serialize;
use std::sync::Arc;

/// One object of the quadric or the patch processor: words, and what is known of them.
#[derive(Clone, Debug)]
pub struct PreparedQuadric {
    /// Name in the scene.
    pub name: String,
    /// Coefficient words for the whole screen; [`for_zone`](imogene_golden::object::words::Words::for_zone) gives those
    /// of a zone.
    pub words: QuadricWords,
    /// The unrounded expressions.
    pub exact: ExactForms,
    /// Pixel about which f1 and f2 were rounded: the middle of the box, or of all boxes of objects that share the
    /// quadric.
    pub anchor: Anchor,
    /// Greatest error of each expression on the screen box.
    pub bounds: RoundingBounds,
    /// Bits that each accumulator needs on the screen box.
    pub needed: NeededWidths,
    /// What a person should know: edge-on, off screen, seen from inside, perpendicular planes.
    pub notes: Vec<String>,
}

/// The expressions in depth words without guard bits, before rounding, in pixel columns and lines.
#[derive(Clone, Debug)]
pub struct ExactForms {
    /// Linear part of the depth.
    pub f1: LinearForm,
    /// Discriminant part of the depth.
    pub f2: QuadraticForm,
    /// Depth or half-plane value of each plane.
    pub planes: Vec<LinearForm>,
}

/// Greatest distance of each rounded expression from the exact one on the screen box, in the last bit of the word
/// without guard bits.
///
/// These are maxima of the true residuals of the coefficients, exact and then rounded up to `f64`. The guard bits,
/// which f1 and f2 drop downwards at the outputs of their processors, take up to `dropped_f1` and `dropped_f2` more.
#[derive(Clone, Debug, Default, Serialize)]
pub struct RoundingBounds {
    /// Of f1 with its guard bits.
    pub f1: f64,
    /// Of f2 with its guard bits.
    pub f2: f64,
    /// Of each plane.
    pub planes: Vec<f64>,
    /// Of the linear part of each normal component: the greatest of the three.
    pub normal: f64,
    /// Most that dropping the guard bits takes from f1: `1 - 2^-g1`.
    pub dropped_f1: f64,
    /// Most that dropping the guard bits takes from f2: `1 - 2^-g2`. The root does not feel it:
    /// `floor(sqrt(floor(q))) = floor(sqrt(q))`.
    pub dropped_f2: f64,
    /// Binary places of the product `K r` below the last bit of a normal's linear part.
    pub product_fraction: u32,
    /// Last digits of the root that are not computed.
    pub dropped_rows: u32,
    /// How the root is taken.
    #[serde(skip_serializing_if = "RootForm::is_usual")]
    pub root_form: RootForm,
    /// Not below any root of a computed f2 on the screen box.
    #[serde(skip)]
    pub greatest_root: f64,
}

impl RoundingBounds {
    /// The root that the network finds of a computed f2.
    pub fn root_of(&self, f2: i64) -> i64 {
        let (f2, dropped) = (f2.max(0), self.dropped_rows);
        if self.root_form.is_exact() {
            return fast_root(f2) >> dropped << dropped;
        }
        let digits = root(Method::of(self.root_form), f2 as u128 >> (2 * dropped), 32);
        (digits.root << dropped) as i64
    }

    /// Most that the root which the network finds is from the true one of its radicand, which is `root`.
    pub fn root_error(&self, root: f64) -> f64 {
        self.root_form.error_at(root, self.dropped_rows)
    }

    /// Bounds of a format before any coefficient is known: only the guard bits that it drops.
    pub fn of_format(format: &Format) -> RoundingBounds {
        let dropped = |guards: u32| 1.0 - 0.5f64.powi(guards as i32);
        RoundingBounds {
            dropped_f1: dropped(format.guard_linear),
            dropped_f2: dropped(format.guard_quadratic),
            product_fraction: format.product_fraction(),
            dropped_rows: format.dropped_rows,
            root_form: format.root_form,
            // Roots stay half a bit below their word.
            greatest_root: f64::exp2(f64::from(format.root) - 0.5),
            ..RoundingBounds::default()
        }
    }
}

/// Two's complement bits, guard bits not counted, that hold the true value on every pixel of the screen box.
#[derive(Clone, Debug, Default, Serialize)]
pub struct NeededWidths {
    /// f1 - r and f1 + r.
    pub sum: u32,
    /// f2.
    pub quadratic: u32,
    /// The widest plane.
    pub plane: u32,
}

impl NeededWidths {
    /// The greater of each.
    pub fn or(&self, other: &NeededWidths) -> NeededWidths {
        NeededWidths {
            sum: self.sum.max(other.sum),
            quadratic: self.quadratic.max(other.quadratic),
            plane: self.plane.max(other.plane),
        }
    }

    /// The narrowest words of a fitted machine that hold what is needed; the others are those of `wide`.
    pub fn narrowed(&self, wide: &MachineWords) -> MachineWords {
        let least = wide.least_root();
        MachineWords {
            root: self.quadratic.div_ceil(2).max(least).min(wide.root),
            plane: self.plane.clamp(wide.depth, wide.plane),
            ..*wide
        }
    }

    /// A slot of a machine of these words with as few bits as hold what is needed.
    pub fn slot(&self, slot: FittedSlot, machine: &MachineWords) -> FittedSlot {
        slot.in_words(&self.narrowed(machine), machine)
    }
}

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
    fn parts(&self) -> (&str, &[String], &ScreenBox) {
        match self {
            Self::Quadric(own) | Self::Patch(own) => (&own.name, &own.notes, &own.words.screen_box),
            Self::Parts(parts) => (&parts.name, &parts.notes, &parts.screen_box),
            Self::Unseen(unseen) => (&unseen.name, &[], &ScreenBox::EMPTY),
        }
    }

    /// Name in the scene.
    pub fn name(&self) -> &str {
        self.parts().0
    }

    /// What a person should know.
    pub fn notes(&self) -> &[String] {
        self.parts().1
    }

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
        self.parts().2
    }

    /// The words and bounds of an object of the quadric or the patch processor.
    pub fn quadric(&self) -> Option<&PreparedQuadric> {
        match self {
            Self::Quadric(object) | Self::Patch(object) => Some(object),
            Self::Parts(_) | Self::Unseen(_) => None,
        }
    }

    /// True if its errors have bounds: it is of the quadric or the patch processor, or not drawn.
    pub fn has_bounds(&self) -> bool {
        !matches!(self, Self::Parts(_))
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

/// Where a part of a shadow begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beginning {
    /// At the polar plane of the source, which bounds the lit part of the quadric.
    PolarPlane,
    /// At this cut plane.
    Cut(usize),
    /// At this facet of a mesh.
    Facet(usize),
}

/// One volume: words, and what is known of them.
#[derive(Clone, Debug)]
pub struct PreparedVolume {
    /// Whose it is, as messages say it: `the shadow of object 'lid' from lights[0], part 1 of 3`.
    pub name: String,
    /// Index of the object whose shadow it is, and where it begins; nothing for a spot.
    pub caster: Option<(usize, Beginning)>,
    /// Coefficient words for the whole screen.
    pub words: VolumeWords,
    /// Greatest error of each expression on the screen box, the margin not counted.
    pub bounds: RoundingBounds,
    /// Bits that each accumulator needs on the screen box.
    pub needed: NeededWidths,
    /// What a person should know.
    pub notes: Vec<String>,
}
