//! What is known of a scene's objects before it is prepared, from the one before.

use super::cell::Cell;
use super::prepared::{PreparedObject, PreparedVolume};
use super::seams::Place;
use imogene_golden::object::quadric::ScreenBox;
use imogene_scene::{FramedObject, FramedScene};
use num_rational::BigRational;

/// Least and greatest x, y and z of screen space at which an object is seen.
pub(super) type Bounds = ([f64; 3], [f64; 3]);

pub(super) struct KeptObject {
    pub framed: FramedObject,
    pub place: Option<Box<Place>>,
    /// Without the notes on its shadow.
    pub prepared: PreparedObject,
    /// Where it is seen, if that was asked for.
    pub seen: Option<Option<Bounds>>,
    pub shadows: Vec<KeptShadow>,
}

pub(super) struct KeptShadow {
    pub source: usize,
    pub point: [BigRational; 4],
    pub volumes: Vec<PreparedVolume>,
}

/// What is known of a scene before it is prepared.
pub(super) struct Known<'a> {
    pub objects: Vec<Option<&'a KeptObject>>,
    pub receivers: Option<Cell>,
}

impl Known<'_> {
    pub fn nothing(scene: &FramedScene) -> Known<'static> {
        Known {
            objects: scene.objects.iter().map(|_| None).collect(),
            receivers: None,
        }
    }

    /// The screen box of a cut quadric.
    pub fn window(&self, index: usize) -> Option<ScreenBox> {
        let place = self.objects[index]?.place.as_ref();
        place.map(|place| place.window)
    }

    /// Forgets the objects whose expressions now count in other boxes than before.
    pub fn forget_moved(&mut self, places: &[Option<Box<Place>>]) {
        for (known, place) in self.objects.iter_mut().zip(places) {
            *known = known.filter(|kept| kept.place == *place);
        }
    }
    /// The shadow of an object from a source, if what is seen takes the same room.
    pub fn shadow(
        &self,
        source: usize,
        object: usize,
        point: &[BigRational; 4],
        receivers: &Cell,
    ) -> Option<Vec<PreparedVolume>> {
        if self.receivers.as_ref() != Some(receivers) {
            return None;
        }
        let mut shadows = self.objects[object]?.shadows.iter();
        let same = shadows.find(|kept| kept.source == source && kept.point == *point)?;
        let mut volumes = same.volumes.clone();
        for volume in &mut volumes {
            // Objects before it may have been hidden or shown.
            if let Some((caster, _)) = &mut volume.caster {
                *caster = object;
            }
        }
        Some(volumes)
    }
}
