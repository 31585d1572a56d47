//! What a machine with a screen shows of a scene, and the words that it is given.

use super::description::{MachineDescription, MachineKind, Smoothing};
use super::needs;
use super::zone::plan::{PlanError, ZonePlan};
use super::zone::refine::Refinement;
use imogene_golden::machine::accumulator::{Accumulator, PassPixel};
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::machine::shader::{ShaderWords, shade_picture};
use imogene_golden::machine::zone::beat::{Beat, kind};
use imogene_golden::machine::zone::golden::{StreamError, ZoneMachineModel};
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_golden::object::load::load_words;
use imogene_golden::object::load_volume::load_volume;
use imogene_golden::object::paraboloid::plane_guard;
use imogene_golden::object::quadric::{MAX_PLANES, PlaneWords, QuadricWords};
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::unused;
use imogene_golden::object::volume::{VolumePlane, VolumeWords};
use imogene_prepare::PreparedScene;
use imogene_prepare::shader::{ShaderError, material_numbers, shader_words};
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
    /// More planes than any processor has.
    #[error(
        "{what} has {needed} planes, and no processor of a machine more than {MAX_PLANES}; fewer cuts of the object would do"
    )]
    Planes {
        /// The object, or whose volume it is.
        what: String,
        /// Its planes.
        needed: usize,
    },
    /// An object that its processors do not draw.
    #[error("object '{object}': {why}")]
    Object {
        /// Its name.
        object: String,
        /// Why not.
        why: AsQuadricError,
    },
    /// A facet whose depths are not in its words.
    #[error(
        "object '{object}': {why}; widths = {{ g1 = {enough} }} in the machine description is enough for every facet"
    )]
    Guards {
        /// Its name.
        object: String,
        /// Why not.
        why: AsQuadricError,
        /// Guard bits of f1 with which every facet is drawn.
        enough: u32,
    },
    /// A volume that its processors are not for.
    #[error("volume '{volume}': {why}")]
    Volume {
        /// Its name.
        volume: String,
        /// Why not.
        why: AsQuadricError,
    },
    /// The zones cannot be planned.
    #[error(transparent)]
    Plan(#[from] PlanError),
    /// The shading processor cannot be loaded.
    #[error(transparent)]
    Shader(#[from] ShaderError),
    /// The picture has another size than the screen.
    #[error("a picture of {}x{} on a screen of {}x{}; frame the scene for the screen", picture.0, picture.1, screen.0, screen.1)]
    Size {
        /// Of the picture.
        picture: (u32, u32),
        /// Of the screen, in samples.
        screen: (u32, u32),
    },
}

/// One image of a machine: the words that it is given and the picture that it then shows.
#[derive(Clone, Debug)]
pub struct Image {
    /// The command stream of a zone machine, or the words of a beam machine.
    pub beats: Vec<Beat>,
    /// Visible surfaces, at every sample.
    pub frame: Frame,
    /// Sources that reach them.
    pub lighting: Lighting,
    /// Red, green, blue of every pixel on the pins, row-major.
    pub picture: Vec<u8>,
    /// The plan of a zone machine.
    pub plan: Option<ZonePlan>,
}

/// The image of a prepared scene, without an overlay.
///
/// # Errors
///
/// When the machine has not the processors for the scene, or the picture another size than the screen.
pub fn image(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
) -> Result<Image, DisplayError> {
    refined_image(scene, prepared, machine, Refinement::Box)
}

/// The same picture; the host of a zone machine leaves out of each zone what the refinement finds.
///
/// # Errors
///
/// As [`image`].
pub fn refined_image(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
    refinement: Refinement,
) -> Result<Image, DisplayError> {
    check_size(scene, machine)?;
    needs::check(machine, &[(scene, prepared)])?;
    let shader = shader_words(scene, &prepared.format, None)?;
    let numbers = material_numbers(scene);
    match machine.machine {
        MachineKind::Zone => {
            let materials = numbers.iter().map(|&number| number.into()).collect();
            let shading = shading_words(&shader, machine);
            let plan = ZonePlan::of(prepared, machine.zone_machine())?
                .refined(refinement)
                .shaded(shading, materials)?;
            let beats: Vec<Beat> = plan.beats().collect();
            let mut golden = ZoneMachineModel::new(&prepared.format, &plan.machine);
            let size = (prepared.width as usize, prepared.height as usize);
            let (frame, lighting) = golden
                .frame(beats.iter().copied(), size.0, size.1)
                .unwrap_or_else(|error: StreamError| unreachable!("the stream of a plan: {error}"));
            let picture = finished(&frame, &lighting, &numbers, &shader, machine);
            Ok(Image {
                beats,
                frame,
                lighting,
                picture,
                plan: Some(plan),
            })
        }
        MachineKind::Beam => {
            let parts = parts(prepared, machine.planes)?;
            let slots: Vec<Slot> = parts
                .iter()
                .map(|(object, words)| Slot {
                    object: *object,
                    words: ProcessorWords::Quadric(words.clone()),
                })
                .collect();
            let (width, height) = (prepared.width as usize, prepared.height as usize);
            let frame = beam::render(&slots, &prepared.format, width, height, || ());
            let lighting = prepared.light(&frame, || ());
            let picture = finished(&frame, &lighting, &numbers, &shader, machine);
            Ok(Image {
                beats: beam_words(scene, prepared, machine)?,
                frame,
                lighting,
                picture,
                plan: None,
            })
        }
    }
}

fn check_size(scene: &FramedScene, machine: &MachineDescription) -> Result<(), DisplayError> {
    let picture = (scene.width, scene.height);
    match machine.drawn_size() {
        Some(screen) if screen != picture => Err(DisplayError::Size { picture, screen }),
        _ => Ok(()),
    }
}

/// The words of the shading processor; lights that the scene has not got are dark.
fn shading_words(shader: &ShaderWords, machine: &MachineDescription) -> Vec<(u16, u32)> {
    let missing = shader.lights.len()..machine.lights;
    let dark = missing.flat_map(|light| dark_light(light as u16));
    shader.load_words().into_iter().chain(dark).collect()
}

/// The words of a light that sends nothing: its colour is black.
fn dark_light(light: u16) -> impl Iterator<Item = (u16, u32)> {
    let first = imogene_golden::machine::shader::LIGHT_ADDRESS + 16 * light;
    (first..first + 16).map(|address| (address, 0))
}

/// The picture on the pins.
fn finished(
    frame: &Frame,
    lighting: &Lighting,
    materials: &[u8],
    shader: &ShaderWords,
    machine: &MachineDescription,
) -> Vec<u8> {
    let picture = shade_picture(frame, lighting, materials, shader);
    let picture = mean_of_samples(&picture, frame.width, machine.supersampling as usize);
    if machine.smoothing == Smoothing::None {
        return picture;
    }
    let pixels: Vec<[u8; 3]> = picture
        .chunks_exact(3)
        .map(|p| [p[0], p[1], p[2]])
        .collect();
    let width = frame.width / machine.supersampling as usize;
    let lines: Vec<Vec<[u8; 3]>> = pixels.chunks(width).map(<[_]>::to_vec).collect();
    let kernel = machine.smoothing.kernel();
    kernel.picture(&lines).concat().concat()
}

/// The picture whose pixels are the means of `samples x samples` of the given one.
fn mean_of_samples(picture: &[u8], width: usize, samples: usize) -> Vec<u8> {
    if samples == 1 {
        return picture.to_vec();
    }
    let columns = width / samples;
    let lines = picture.len() / 3 / width / samples;
    let mut sums = Accumulator::new(1);
    let mut mean = |x: usize, y: usize| {
        let mut mean = [0; 3];
        for pass in 0..samples * samples {
            let (column, line) = (samples * x + pass % samples, samples * y + pass / samples);
            let at = 3 * (line * width + column);
            let pixel = PassPixel {
                address: 0,
                first: pass == 0,
                last: pass + 1 == samples * samples,
                colour: [picture[at], picture[at + 1], picture[at + 2]],
            };
            mean = sums.add(&pixel, (samples * samples) as u32).unwrap_or(mean);
        }
        mean
    };
    let line = |y| (0..columns).map(move |x| (x, y));
    let places: Vec<(usize, usize)> = (0..lines).flat_map(line).collect();
    places.into_iter().flat_map(|(x, y)| mean(x, y)).collect()
}

/// Object and words of every part of the scene, for processors of so many planes.
pub(super) fn parts(
    prepared: &PreparedScene,
    planes: usize,
) -> Result<Vec<(usize, QuadricWords)>, DisplayError> {
    let part = |slot: Slot| {
        let words = slot.words.on_quadric_processor(&prepared.format, planes);
        let object = || prepared.objects[slot.object].name().to_owned();
        let words = words.map_err(|why| match why {
            AsQuadricError::Planes { needed, .. } => DisplayError::Planes {
                what: format!("object '{}'", object()),
                needed,
            },
            AsQuadricError::GuardBits { .. } => DisplayError::Guards {
                object: object(),
                why,
                enough: plane_guard(&prepared.format),
            },
            why => DisplayError::Object {
                object: object(),
                why,
            },
        })?;
        Ok((slot.object, words))
    };
    prepared.slots().into_iter().map(part).collect()
}

/// Words of every volume of the scene, for processors of so many planes.
pub(super) fn volumes(
    prepared: &PreparedScene,
    planes: usize,
) -> Result<Vec<VolumeWords>, DisplayError> {
    let volumes = prepared.volumes.iter().map(|volume| {
        let words = volume.words.on_quadric_processor(planes);
        words.map_err(|why| match why {
            AsQuadricError::Planes { needed, .. } => DisplayError::Planes {
                what: volume.name.clone(),
                needed,
            },
            why => DisplayError::Volume {
                volume: volume.name.clone(),
                why,
            },
        })
    });
    volumes.collect()
}

/// The words of a whole frame of a beam machine, tables first; processors without an object are emptied.
pub(super) fn beam_words(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
) -> Result<Vec<Beat>, DisplayError> {
    let shader = shader_words(scene, &prepared.format, None)?;
    let shading = shading_words(&shader, machine);
    let materials = material_numbers(scene);
    let parts = parts(prepared, machine.planes)?;
    let volumes = volumes(prepared, machine.volume_planes)?;
    let format = &prepared.format;
    let mut beats: Vec<Beat> = shading
        .iter()
        .map(|&(address, word)| Beat::new(kind::SHADING, 0, address, word.into()))
        .collect();
    let slots = machine.slots();
    for (place, (object, words)) in parts.iter().enumerate() {
        let planes = slots
            .get(place)
            .map_or(machine.planes, |slot| slot.planes as usize);
        let material = materials[*object].into();
        beats.push(Beat::new(kind::MATERIAL, 0, place as u16, material));
        let mut words = words.clone();
        words.planes.resize(planes, PlaneWords::default());
        let words = load_words(&words, format, planes);
        beats.extend(
            words
                .iter()
                .map(|w| Beat::new(kind::OBJECT, place as u8, w.address.into(), w.bits)),
        );
    }
    let nothing = unused::object_slot();
    for place in parts.len()..machine.objects {
        let address = nothing.address.into();
        beats.push(Beat::new(kind::OBJECT, place as u8, address, nothing.bits));
    }
    for (place, words) in volumes.iter().enumerate() {
        let mut words = words.clone();
        words
            .planes
            .resize(machine.volume_planes, VolumePlane::default());
        let words = load_volume(&words, format, machine.volume_planes);
        beats.extend(
            words
                .iter()
                .map(|w| Beat::new(kind::VOLUME, place as u8, w.address.into(), w.bits)),
        );
    }
    if let Some(beat) = beats.last_mut() {
        beat.last = true;
    }
    Ok(beats)
}
