//! What a preparation gives of a whole scene.

use super::error::{Missing, PrepareError};
use super::prepared::{NeededWidths, PreparedObject, PreparedQuadric, PreparedVolume};
use super::solids::PreparedSolids;
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::{Lighting, light};
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::volume::VolumeWords;
use imogene_golden::slots::required_of_quadric;
use num_rational::BigRational;
use std::collections::BTreeSet;

/// A scene as a machine of a format is loaded with it.
#[derive(Clone, Debug)]
pub struct PreparedScene {
    /// Widths of the machine.
    pub format: Format,
    /// Pixels per line.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// Depth words per pixel of depth: the scale that all depths of the scene share.
    pub depth_scale: BigRational,
    /// The objects in the order of the scene; the index is the id.
    pub objects: Vec<PreparedObject>,
    /// Solids made of objects.
    pub solids: PreparedSolids,
    /// Processors of transparent objects, in the order of their blends.
    pub layers: Vec<Slot>,
    /// The objects that are transparent.
    pub transparent: BTreeSet<usize>,
    /// Shadow volumes and the light volumes of spots, in the order of sources and objects.
    pub volumes: Vec<PreparedVolume>,
    /// What is left out of a picture that is drawn without what cannot be prepared
    /// ([`Options::without_refused`](crate::Options::without_refused)), objects first.
    pub missing: Vec<Missing>,
}

impl PreparedScene {
    /// The processors of a machine that draws the scene: in the order of the objects those that are in no solid, then
    /// those of the solids, then those of transparent objects.
    pub fn slots(&self) -> Vec<Slot> {
        let mut slots = self.slots_alone();
        slots.extend(self.solids.slots.iter().cloned());
        slots.extend(self.layers.iter().cloned());
        slots
    }

    /// The processors of the objects that are in no solid and not transparent.
    pub fn slots_alone(&self) -> Vec<Slot> {
        let of = |(object, prepared): (usize, &PreparedObject)| {
            let slot = move |words| Slot {
                object,
                words,
                weight: None,
            };
            prepared.words().into_iter().map(slot)
        };
        let objects = self.objects.iter().enumerate();
        let is_alone =
            |id: &usize| !self.solids.members.contains(id) && !self.transparent.contains(id);
        let alone = objects.filter(|(id, _)| is_alone(id));
        alone.flat_map(of).collect()
    }

    /// Refuses a scene with solids or transparent objects, for what looks at each object by itself.
    pub fn refuse_composed(&self) -> Result<(), PrepareError> {
        self.refuse_one_of(&self.solids.members)?;
        self.refuse_transparent()
    }

    /// Refuses a scene with transparent objects, for what does not blend.
    pub fn refuse_transparent(&self) -> Result<(), PrepareError> {
        self.refuse_one_of(&self.transparent)
    }

    fn refuse_one_of(&self, objects: &BTreeSet<usize>) -> Result<(), PrepareError> {
        let name = |&object: &usize| self.objects[object].name().to_owned();
        let first = objects.first().map(name);
        first.map_or(Ok(()), |name| Err(PrepareError::Composed(name)))
    }

    /// The words of its volumes.
    pub fn volume_words(&self) -> Vec<&VolumeWords> {
        self.volumes.iter().map(|volume| &volume.words).collect()
    }

    /// The frame that a beam machine draws of it; `line_done` is called once a line, from any thread.
    pub fn frame(&self, line_done: impl Fn() + Sync) -> Frame {
        let (width, height) = (self.width as usize, self.height as usize);
        beam::render(&self.slots(), &self.format, width, height, line_done)
    }

    /// The flags that its volumes leave of a frame; `line_done` is called once a line, from any thread.
    pub fn light(&self, frame: &Frame, line_done: impl Fn() + Sync) -> Lighting {
        light(frame, &self.volume_words(), &self.format, line_done)
    }

    /// The slots of the quadric processors that it requires.
    pub fn fitted_slots(&self) -> Vec<FittedSlot> {
        let slots = self.quadrics();
        slots.map(|(_, o)| required_of_quadric(&o.words)).collect()
    }

    /// The slot with as few bits as are proven to hold every value of a part of an object where it is drawn; those of
    /// the format where nothing is proven.
    pub fn in_needed(&self, slot: FittedSlot, object: usize, words: &ProcessorWords) -> FittedSlot {
        let words = match words {
            ProcessorWords::Quadric(words) | ProcessorWords::Patch(words) => words,
            ProcessorWords::Member(member) => member.own(),
            _ => return slot,
        };
        let is_own = |object: &&PreparedQuadric| {
            let own = &object.words;
            let forms = (&own.f1, &own.f2, &own.planes, own.screen_box);
            forms == (&words.f1, &words.f2, &words.planes, words.screen_box)
        };
        let object = self.objects.get(object).and_then(|object| object.quadric());
        match object.filter(is_own) {
            Some(object) => object.needed.slot(slot, &self.format.widths()),
            None => slot,
        }
    }

    /// The bits that its objects of the quadric and the patch processor need, and its shadow and light volumes.
    pub fn needed(&self) -> NeededWidths {
        let objects = self.quadrics().map(|(_, object)| &object.needed);
        let volumes = self.volumes.iter().map(|volume| &volume.needed);
        let all = objects.chain(volumes);
        all.fold(NeededWidths::default(), |most, one| most.or(one))
    }

    /// The objects of the quadric and the patch processor, the only ones with bounds; the index is the id.
    pub fn quadrics(&self) -> impl Iterator<Item = (usize, &PreparedQuadric)> {
        let objects = self.objects.iter().enumerate();
        objects.filter_map(|(id, object)| Some((id, object.quadric()?)))
    }
}
