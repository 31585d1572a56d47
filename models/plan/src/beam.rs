//! The words that a machine is given for a scene, or why it cannot show it.

use super::description::MachineDescription;
use super::products::in_slots;
use super::zone::plan::{self, Part, PlanError};
use imogene_contract::object::{Kind, ProductSlots};
use imogene_contract::shading::MOST_MATERIALS;
use imogene_contract::slots::FittedSlot;
use imogene_golden::format::Format;
use imogene_golden::machine::shader::{LIGHT_ADDRESS, ShaderWords};
use imogene_golden::machine::zone::beat::{Beat, command, kind};
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_golden::object::load::LoadWord;
use imogene_golden::object::load_slot::load_slot;
use imogene_golden::object::load_volume::load_volume;
use imogene_golden::object::quadric::MAX_PLANES;
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::unused::empty_slot;
use imogene_golden::object::volume::{VolumePlane, VolumeWords};
use imogene_golden::object::words::Words;
use imogene_golden::slots::{own_kind, required, takes};
use imogene_golden::unit::lattice::Lattice;
use imogene_prepare::PreparedScene;
use imogene_prepare::lit_sphere::sphere_words;
use imogene_prepare::shader::{ShaderError, flat_words, material_numbers, shader_words};
use imogene_scene::FramedScene;
use thiserror::Error;

/// Why a machine cannot show a scene.
#[derive(Debug, Error)]
pub enum DisplayError {
    /// Too few processors, planes, lights or words.
    #[error(
        "the machine has too little for what it is to show; these lines in its description, in place of its own, would do:\n{0}"
    )]
    Needs(String),
    /// An object, or whose volume it is, with more planes than any processor has.
    #[error(
        "{0} has {1} planes, and no processor of a machine more than {MAX_PLANES}; fewer cuts of the object would do"
    )]
    Planes(String, usize),
    /// The zones cannot be planned, or an object is not for the processors of the machine.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The shading processor cannot be loaded.
    #[error(transparent)]
    Shader(#[from] ShaderError),
    /// Materials and lights with volumes that need more tables of lit-sphere shading than there are of the smallest
    /// side.
    #[error(
        "{0} materials, {1} lights with shadows: lit-sphere shading has {2} tables at most, one for each material and \
         twice as many for each of these lights; without lit_sphere the machine takes them"
    )]
    Tables(usize, usize, u32),
    /// The picture has another size than the screen, in samples.
    #[error("a picture of {}x{} on a screen of {}x{}; frame the scene for the screen", .0.0, .0.1, .1.0, .1.1)]
    Size((u32, u32), (u32, u32)),
}

pub(super) type Result<T, E = DisplayError> = std::result::Result<T, E>;

/// What the machine is told of colours: tables where it has them, and else those of materials alone where it has no
/// lights.
pub(super) fn shader(
    scene: &FramedScene,
    format: &Format,
    machine: &MachineDescription,
) -> Result<ShaderWords, ShaderError> {
    if let Some(sphere) = machine.lit_sphere {
        return sphere_words(scene, format, sphere.form(), machine.lights as u32);
    }
    match machine.lights {
        0 => flat_words(scene, format),
        _ => shader_words(scene, format),
    }
}

/// The words of the shading processor; lights that the scene has not got are dark.
pub(super) fn shading_words(shader: &ShaderWords, machine: &MachineDescription) -> Vec<(u16, u32)> {
    let lights = shader.sphere.as_ref().map_or(machine.lights as u16, |_| 0);
    // The colour of a light that sends nothing is black.
    let missing = shader.lights.len() as u16..lights;
    let first = missing.map(|light| LIGHT_ADDRESS + 16 * light);
    let dark = first.flat_map(|first| (first..first + 16).map(|address| (address, 0)));
    shader.load_words().into_iter().chain(dark).collect()
}

/// What the slots of a zone machine have to have: one that holds it for every part that is in no solid, and the most
/// planes of those that are in one, if there are any. A part is of the kind that the machine has, as in [`beam_slots`].
pub(super) fn zone_slots(
    prepared: &PreparedScene,
    slots: &[FittedSlot],
) -> Result<(Vec<FittedSlot>, Option<u32>)> {
    let name = |slot: &Slot| prepared.objects[slot.object].name().to_owned();
    let alone = prepared.slots_alone().into_iter().map(|slot| {
        let given = |given: &&FittedSlot| given.kind != Kind::Quadric && takes(given, &slot.words);
        let needed = |given| beam_slot(prepared, &slot, given).map(|part| part.needed);
        let (own, other) = (needed(slots.iter().find(given))?, needed(None)?);
        let is_there = |needed: &FittedSlot| slots.iter().any(|slot| slot.holds(needed));
        Ok::<_, DisplayError>(match is_there(&other) && !is_there(&own) {
            true => other,
            false => own,
        })
    });
    let members = prepared.solids.slots.iter().map(|slot| {
        let words = &slot.words;
        let words = words.on_quadric_processor(&prepared.format, MAX_PLANES);
        let words = words.map_err(|why| refused(name(slot), why))?;
        Ok(words.planes.len() as u32)
    });
    let members: Vec<u32> = members.collect::<Result<_>>()?;
    Ok((alone.collect::<Result<_>>()?, members.into_iter().max()))
}

/// Why an object has no words for a processor of quadrics.
fn refused(object: String, why: AsQuadricError) -> DisplayError {
    match why {
        AsQuadricError::Planes(needed, _) => {
            DisplayError::Planes(format!("object '{object}'"), needed)
        }
        why => PlanError::Object(object, why).into(),
    }
}

/// A part of a scene in a beam machine, with the number of its slot.
type Placed = (usize, Part);

/// The parts of the solids in the slots of products that are large enough for them, numbered among those.
pub(super) fn members(prepared: &PreparedScene, products: &[ProductSlots]) -> Vec<Placed> {
    let mut slots = prepared.solids.slots.iter();
    let (mut members, mut first) = (vec![], 0);
    for (own, product) in prepared.solids.products.iter().zip(products) {
        let [intersected, subtracted] = own.size();
        let own = slots.by_ref().take(intersected + subtracted);
        let own = own.map(|slot| Part::of(prepared, slot, slot.words.clone()));
        let own: Vec<Part> = own.collect();
        let own = in_slots(product, own.split_at(intersected).into());
        members.extend(own.into_iter().map(|(place, part)| (first + place, part)));
        first += product.count();
    }
    members
}

/// Parts of the scene, each with what its slot in a beam machine has to have: of the kind that the machine has, if that
/// is for it, else of quadrics, and where no processor of quadrics draws it, of its own kind.
pub(super) fn beam_slots(
    prepared: &PreparedScene,
    parts: &[Slot],
    slots: &[FittedSlot],
) -> Result<Vec<Part>> {
    let parts = parts.iter().enumerate();
    let parts = parts.map(|(place, slot)| beam_slot(prepared, slot, slots.get(place)));
    parts.collect()
}

fn beam_slot(prepared: &PreparedScene, slot: &Slot, given: Option<&FittedSlot>) -> Result<Part> {
    let words = &slot.words;
    let of_own_kind = || Ok(Part::of(prepared, slot, own_kind(words.clone())));
    if given.is_some_and(|given| given.kind != Kind::Quadric && takes(given, words)) {
        return of_own_kind();
    }
    match words.on_quadric_processor(&prepared.format, MAX_PLANES) {
        Ok(words) => Ok(Part::of(prepared, slot, ProcessorWords::Quadric(words))),
        Err(AsQuadricError::Processor(_) | AsQuadricError::GuardBits { .. })
            if required(words).is_some() =>
        {
            of_own_kind()
        }
        Err(why) => {
            let name = prepared.objects[slot.object].name().to_owned();
            Err(refused(name, why))
        }
    }
}

/// Words of every volume of the scene, for processors of so many planes.
pub(super) fn volumes(prepared: &PreparedScene, planes: usize) -> Result<Vec<VolumeWords>> {
    plan::volumes(prepared, planes, |volume, why| match why {
        AsQuadricError::Planes(needed, _) => DisplayError::Planes(volume, needed),
        why => PlanError::Volume(volume, why).into(),
    })
}

pub(super) fn placed(
    prepared: &PreparedScene,
    machine: &MachineDescription,
) -> Result<Vec<Placed>> {
    let (slots, first) = (machine.slots(), machine.slots_alone());
    let behind = slots.len() - machine.layers;
    let alone = beam_slots(prepared, &prepared.slots_alone(), &slots)?;
    let members = members(prepared, &machine.products.0).into_iter();
    let members = members.map(|(place, part)| (first + place, part));
    let layers = beam_slots(prepared, &prepared.layers, &slots[behind..])?;
    Ok((0..)
        .zip(alone)
        .chain(members)
        .chain((behind..).zip(layers))
        .collect())
}

/// The words of a frame of a beam machine that has these pixels of the picture. Of several graphics modules those come
/// first that are of one alone, and those of all modules last.
pub(super) fn frame_words(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
    pixels: &Lattice,
) -> Result<Vec<Beat>> {
    let lines = machine.lines_of_modules(pixels);
    let words = lines.iter();
    let words = words.map(|lines| module_words(scene, prepared, machine, lines));
    let words = words.collect::<Result<Vec<_>>>()?;
    let mut beats = match words.as_slice() {
        [words] => words.clone(),
        words => of_modules(words),
    };
    if let Some(beat) = beats.last_mut() {
        beat.last = true;
    }
    Ok(beats)
}

/// One list of words of the lists of several modules, which are of the same addresses.
fn of_modules(words: &[Vec<Beat>]) -> Vec<Beat> {
    let chosen = |modules: u64| Beat::command(command::MODULES, modules);
    let is_of_all = |place: usize| words.iter().all(|own| own[place] == words[0][place]);
    let places = 0..words[0].len();
    let (of_all, own): (Vec<usize>, Vec<usize>) = places.partition(|&place| is_of_all(place));
    let mut beats = vec![];
    for (module, words) in words.iter().enumerate() {
        beats.push(chosen(1 << module));
        beats.extend(own.iter().map(|&place| words[place]));
    }
    beats.push(chosen((1 << words.len()) - 1));
    beats.extend(of_all.into_iter().map(|place| words[0][place]));
    beats
}

/// The words of a graphics module, tables first; processors without an object are emptied.
fn module_words(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
    pixels: &Lattice,
) -> Result<Vec<Beat>> {
    let shader = shader(scene, &prepared.format, machine)?;
    let shader = match pixels.dy {
        1 => shader,
        _ => shader.on_lines(pixels.y0 as u16),
    };
    let shading = shading_words(&shader, machine);
    let materials = material_numbers(scene);
    let slots = machine.slots();
    let volumes = volumes(prepared, machine.volume_planes)?;
    let format = &prepared.format;
    let shading = shading.into_iter();
    let mut beats: Vec<Beat> = shading
        .map(|(address, word)| Beat::new(kind::SHADING, 0, address, word.into()))
        .collect();
    let mut is_empty = vec![true; slots.len()];
    for (place, part) in placed(prepared, machine)? {
        let weight = u64::from(part.weight.unwrap_or(0)) << MOST_MATERIALS.ilog2();
        let material = weight | u64::from(materials[part.object]);
        beats.push(Beat::new(kind::MATERIAL, 0, place as u16, material));
        let words = part.words.on(pixels);
        let words = load_slot(&words, format, slots.get(place).unwrap_or(&part.needed));
        beats.extend(words.iter().map(load(kind::OBJECT, place)));
        if let Some(is_empty) = is_empty.get_mut(place) {
            *is_empty = false;
        }
    }
    for ((place, slot), is_empty) in (0..).zip(&slots).zip(is_empty) {
        if is_empty {
            beats.push(load(kind::OBJECT, place)(&empty_slot(slot.kind)));
        }
    }
    for (place, words) in volumes.iter().enumerate() {
        let (mut words, planes) = (words.on(pixels), machine.volume_planes);
        words.planes.resize(planes, VolumePlane::default());
        let words = load_volume(&words, format, planes);
        beats.extend(words.iter().map(load(kind::VOLUME, place)));
    }
    Ok(beats)
}

fn load(kind: u8, place: usize) -> impl Fn(&LoadWord) -> Beat {
    move |word| Beat::new(kind, place as u8, word.address.into(), word.bits)
}
