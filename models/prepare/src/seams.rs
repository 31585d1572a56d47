//! Expressions that several objects have in common.
//!
//! The parts of a face meet at planes, and lie on quadrics, that both parts have. If each part rounded them about the
//! middle of its own box, their words would differ, and a pixel between the two roundings would belong to neither
//! part: a crack. So what cut objects share is rounded about the middle of the box around all of them and, where its
//! scale is free, scaled for that box; opposite sides of a plane then have the same words, or exactly opposite ones.
//! Objects whose boxes lie apart meet nowhere, and are left as they are.

use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{FramedObject, FramedQuadric};
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use rayon::prelude::*;
use std::collections::HashMap;

/// What the quadric, patch and polyhedron processors draw, which have their planes in the same form.
pub(super) fn cut(object: &FramedObject) -> Option<&FramedQuadric> {
    match object {
        FramedObject::Quadric(q) | FramedObject::Patch(q) | FramedObject::Polyhedron(q) => Some(q),
        _ => None,
    }
}

/// Where an object is on the screen, and where its expressions count.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Place {
    /// Its own box.
    pub window: ScreenBox,
    /// The box around all objects of its quadric that may meet it.
    pub quadric: ScreenBox,
    /// The same for each of its planes, on whichever side the objects are.
    pub planes: Vec<ScreenBox>,
}

impl Place {
    /// Of an object that shares nothing.
    pub fn alone(window: ScreenBox, planes: usize) -> Place {
        Place {
            window,
            quadric: window,
            planes: vec![window; planes],
        }
    }
}

/// Coefficients, the first that is not zero positive. Those of framed objects are integers without a common divisor,
/// so they are the same for both sides of a plane.
pub type Key = Vec<BigRational>;

pub(super) fn places(
    objects: &[FramedObject],
    windows: &[Option<ScreenBox>],
) -> Vec<Option<Box<Place>>> {
    let keys: Vec<Option<Box<Keys>>> = objects
        .par_iter()
        .zip(windows)
        .map(|(object, window)| {
            let seen = window.is_some_and(|window| !window.is_empty());
            let quadric = cut(object).filter(|_| seen)?;
            // An object without planes meets nothing.
            (!quadric.planes.is_empty()).then(|| Box::new(Keys::of(quadric)))
        })
        .collect();
    let mut shared: HashMap<&Key, Vec<ScreenBox>> = HashMap::new();
    for (keys, window) in keys.iter().zip(windows) {
        let (Some(keys), Some(window)) = (keys, window) else {
            continue;
        };
        for key in keys.planes.iter().chain(&keys.quadric) {
            join(shared.entry(key).or_default(), *window);
        }
    }
    let around = |key: &Key, window: &ScreenBox| {
        let mut boxes = shared[key].iter();
        *boxes.find(|b| b.touches(window)).expect("joined above")
    };
    let place = |index: usize| {
        let window = windows[index]?;
        let around = |key| around(key, &window);
        Some(Box::new(match &keys[index] {
            None => Place::alone(window, cut(&objects[index])?.planes.len()),
            Some(keys) => Place {
                window,
                quadric: keys.quadric.as_ref().map_or(window, around),
                planes: keys.planes.iter().map(around).collect(),
            },
        }))
    };
    (0..objects.len()).map(place).collect()
}

/// Adds a box to others that lie apart; those that it touches become one with it.
pub fn join(boxes: &mut Vec<ScreenBox>, mut added: ScreenBox) {
    while let Some(index) = boxes.iter().position(|b| b.touches(&added)) {
        added = added.around(&boxes.swap_remove(index));
    }
    boxes.push(added);
}

/// The keys of an object; those of planes have another length than those of quadrics.
struct Keys {
    /// Nothing for a polyhedron.
    quadric: Option<Key>,
    planes: Vec<Key>,
}

impl Keys {
    fn of(object: &FramedQuadric) -> Keys {
        let planes = object.planes.iter();
        let is_quadric = !object.quadric.is_everywhere();
        Keys {
            quadric: is_quadric.then(|| key(object.quadric.coefficients())),
            planes: planes.map(|p| key([&p.a, &p.b, &p.c, &p.d])).collect(),
        }
    }
}

/// The coefficients of a plane or a quadric, the same for both of its sides.
pub fn key<const N: usize>(coefficients: [&BigRational; N]) -> Key {
    let mut signs = coefficients.iter().filter(|value| !value.is_zero());
    let is_opposite = signs.next().is_some_and(|value| value.is_negative());
    let of = |value: &BigRational| if is_opposite { -value } else { value.clone() };
    coefficients.into_iter().map(of).collect()
}
