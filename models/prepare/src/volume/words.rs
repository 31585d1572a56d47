//! From a volume in the camera frame to words, with the proofs that objects have.

use super::found::VolumePlace;
use crate::context::Context;
use crate::depth::{Asked, Exact};
use crate::error::{PrepareError, too_large};
use crate::forms::LinearForm;
use crate::perspective::ScreenQuadric;
use crate::planes::PreparedPlane;
use crate::prepared::{Beginning, NeededWidths, PreparedVolume, RoundingBounds};
use crate::rounding::signed_bits;
use imogene_golden::object::facet::SUBPIXEL;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::volume::{
    MAX_SHIFT, VolumeKind, VolumePlane, VolumeQuadric, VolumeWords,
};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use num_traits::{Signed, Zero};

/// Of a pixel, that much two roundings of a corner take at most.
const CORNERS: f64 = (1 << SUBPIXEL) as f64;

/// A volume that meets nothing, and has no words yet.
pub(super) fn unseen(
    name: String,
    kind: VolumeKind,
    source: usize,
    caster: Option<(usize, Beginning)>,
) -> PreparedVolume {
    PreparedVolume {
        name,
        caster,
        words: VolumeWords {
            kind,
            source: source as u8,
            screen_box: ScreenBox::EMPTY,
            ..VolumeWords::default()
        },
        bounds: RoundingBounds::default(),
        needed: NeededWidths::default(),
        notes: vec!["meets nothing that can be seen".into()],
    }
}

/// The words of an unseen volume where objects can be seen, if it has a place there. The depth of the face that a
/// shadow begins at is off by so many counts at most.
pub(super) fn volume_words(
    unseen: PreparedVolume,
    place: &VolumePlace,
    face_error: f64,
    context: &Context,
) -> Result<PreparedVolume, PrepareError> {
    let VolumePlace { window, depths, .. } = *place;
    if window.is_empty() {
        return Ok(unseen);
    }
    let mut prepared = PreparedVolume {
        notes: vec![],
        ..unseen
    };
    if !place.is_everywhere {
        add_quadric(&mut prepared, place, context)?;
    }
    prepared.words.screen_box = window;
    for (index, plane) in place.planes.iter().enumerate() {
        let plane = plane.words((&window, &window), || depths, context);
        let refusal = |steep| PrepareError::VolumeSteepPlane(prepared.name.clone(), index, steep);
        let plane = plane.map_err(refusal)?;
        add_plane(&mut prepared, plane, index);
    }
    if prepared.words.kind == VolumeKind::Shadow {
        keep_off_beginning(&mut prepared, face_error);
        let proof = prove_planes(&mut prepared, context);
        proof.map_err(|error| error.in_volume(&prepared.name))?;
    }
    Ok(prepared)
}

fn add_quadric(
    prepared: &mut PreparedVolume,
    place: &VolumePlace,
    context: &Context,
) -> Result<(), PrepareError> {
    let refusal = || PrepareError::ViewerOnVolume(prepared.name.clone());
    let class = class_of(&place.screen).ok_or_else(refusal)?;
    let words = |shift| {
        let asked = Asked {
            quadric: &place.screen,
            class,
            at: (&place.window, &place.window),
            shift,
            context,
            exact: Exact::default(),
        };
        place.depth.words(&prepared.name, &asked)
    };
    let (shift, core) = finest(words).map_err(|error| error.in_volume(&prepared.name))?;
    prepared.words.quadric = Some(VolumeQuadric {
        class,
        f1: core.f1,
        f2: core.f2,
        shift,
    });
    (prepared.bounds, prepared.needed) = (core.bounds, core.needed);
    if shift > 0 {
        prepared.notes.push(format!(
            "passes near the viewer: the depths of its quadric are in units of 2^{shift} depth words"
        ));
    }
    Ok(())
}

/// The finest unit in which the quadric fits its words; the refusal is that of the coarsest.
fn finest<T>(words: impl Fn(u8) -> Result<T, PrepareError>) -> Result<(u8, T), PrepareError> {
    for shift in 0..MAX_SHIFT {
        match words(shift) {
            Err(PrepareError::TooLarge(..)) => {}
            other => return other.map(|found| (shift, found)),
        }
    }
    words(MAX_SHIFT).map(|found| (MAX_SHIFT, found))
}

/// How the unbounded quadric lies to the viewer; `None` if its depth is no square root.
fn class_of(quadric: &ScreenQuadric) -> Option<Class> {
    let eye = quadric.eye_value();
    match eye.is_positive() {
        _ if eye.is_zero() => quadric.is_free_of_depth().then_some(Class::Prism),
        true => Some(Class::Side),
        false => Some(Class::Front),
    }
}

fn add_plane(prepared: &mut PreparedVolume, plane: PreparedPlane, index: usize) {
    prepared.words.planes.push(VolumePlane {
        kind: plane.words.kind,
        depth: plane.words.depth,
    });
    prepared.bounds.planes.push(plane.bound);
    prepared.needed.plane = prepared.needed.plane.max(plane.needed);
    if plane.steep {
        prepared.notes.push(format!(
            "plane {index} is so steep that its half-plane form is used, proven equal at every depth of the objects on every pixel of the box"
        ));
    }
}

/// The margin keeps a lit face out of the volume that begins at it; it is one more than the words of face and volume
/// can be apart. Seen from its dark side a face lies at the end of such a volume, which is moved away by as much, so
/// that the face is all inside. Corners of a facet are rounded, and with them where it meets the next one: its margin
/// is what its depth changes over as much of the screen. Planes through the source separate parts of one shadow, where
/// a margin would leave a gap: it is taken off their constants again. On a perpendicular plane the margin has no hold;
/// where the volume begins at one, 1 off its constant makes it open.
fn keep_off_beginning(prepared: &mut PreparedVolume, face_error: f64) {
    let own = prepared.bounds.planes.first().copied().unwrap_or(0.0);
    let begins_at = prepared.caster.map(|(_, beginning)| beginning);
    let at_cut = matches!(begins_at, Some(Beginning::Cut(_) | Beginning::Facet(_)));
    let [first, others @ ..] = prepared.words.planes.as_mut_slice() else {
        return;
    };
    let own = match (first.kind, begins_at) {
        (PlaneKind::Perpendicular, _) => {
            first.depth.c -= 1;
            0.0
        }
        (_, Some(Beginning::Facet(_))) => {
            own + (first.depth.a.abs() + first.depth.b.abs()) as f64 / CORNERS
        }
        _ => own,
    };
    let margin = (own + face_error).floor() as u32 + 1;
    if first.kind == PlaneKind::Back && at_cut {
        first.depth.c += i128::from(margin);
    }
    for plane in others {
        if plane.kind == PlaneKind::Front {
            plane.depth.c -= i128::from(margin);
        }
    }
    prepared.words.margin = margin;
}

/// Once more, for the words as they are after the margin.
fn prove_planes(prepared: &mut PreparedVolume, context: &Context) -> Result<(), PrepareError> {
    let window = prepared.words.screen_box;
    for plane in &prepared.words.planes {
        let magnitude = LinearForm::of_words(&plane.depth).max_abs_on(&window);
        prepared.needed.plane = prepared.needed.plane.max(signed_bits(&magnitude));
        if prepared.needed.plane > context.format.plane {
            let (name, most) = (&prepared.name, context.format.plane);
            return Err(too_large(name, "a plane", &magnitude, most, &window));
        }
    }
    Ok(())
}
