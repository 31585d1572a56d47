//! What a machine with a screen shows of a scene, and the words that it is given.

pub use super::beam::DisplayError;
use super::beam::{Result, beam_slots, frame_words, shader, shading_words};
use super::description::{MachineDescription, MachineKind, Smoothing};
use super::needs;
use super::zone::plan::ZonePlan;
use super::zone::refine::Refinement;
use imogene_golden::machine::accumulator::{Accumulator, PassPixel};
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::machine::shader::{ShaderWords, shade_picture};
use imogene_golden::machine::zone::beat::Beat;
use imogene_golden::machine::zone::golden::{StreamError, ZoneMachineModel};
use imogene_golden::object::slot::Slot;
use imogene_golden::unit::lattice::Lattice;
use imogene_prepare::PreparedScene;
use imogene_prepare::shader::material_numbers;
use imogene_scene::FramedScene;
use thiserror::Error;

/// An image with other tables than the first.
#[derive(Debug, Error)]
#[error(
    "lights or materials are other ones than in the first image: lit_sphere has one table of them for all; lights in its place are loaded with each image"
)]
pub struct OtherTables {
    /// Its place among the images.
    pub image: usize,
}

/// Checks that one machine shows all images: their tables stand in its memories from the beginning.
/// Fails when the tables of an image are other ones than those of the first.
pub fn check_tables(images: &[Image]) -> Result<(), OtherTables> {
    let mut pairs = images.iter().map(|image| image.tables != images[0].tables);
    let other = pairs.position(|is_other| is_other);
    other.map_or(Ok(()), |image| Err(OtherTables { image }))
}

/// One image of a machine: the words that it is given and the picture that it then shows, or a field of it.
#[derive(Clone, Debug)]
pub struct Image {
    /// The pixels of the picture that it shows.
    pub pixels: Lattice,
    /// The command stream of a zone machine, or the words of a beam machine.
    pub beats: Vec<Beat>,
    /// Visible surfaces, at every sample.
    pub frame: Frame,
    /// Sources that reach them.
    pub lighting: Lighting,
    /// Red, green, blue of every pixel on the pins, row-major.
    pub picture: Vec<u8>,
    /// The entries of the tables of lit-sphere shading, in words; none without.
    pub tables: Vec<u64>,
    /// The plan of a zone machine.
    pub plan: Option<ZonePlan>,
}

/// The image of a prepared scene, or its first field, without an overlay.
/// Fails when the machine has not the processors for the scene, or the picture another size than the screen.
pub fn image(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
) -> Result<Image> {
    let mut images = images(scene, prepared, machine, Refinement::Box)?;
    Ok(images.swap_remove(0))
}

/// The images of a prepared scene: both fields of an interlaced machine, else one. The host of a zone machine leaves
/// out of each zone what the refinement finds.
/// Fails as [`image`] does.
pub fn images(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
    refinement: Refinement,
) -> Result<Vec<Image>> {
    let picture = (scene.width, scene.height);
    if let Some(screen) = machine.drawn_size().filter(|screen| *screen != picture) {
        return Err(DisplayError::Size(picture, screen));
    }
    needs::check(machine, &[(scene, prepared)])?;
    let shader = shader(scene, &prepared.format, machine)?;
    let numbers = material_numbers(scene);
    let (width, height) = (prepared.width as usize, prepared.height as usize);
    let fields = machine.fields();
    let (beats, frame, lighting, plan) = match machine.machine {
        MachineKind::Zone => {
            let plan = zone_plan(scene, prepared, machine, refinement)?;
            let beats: Vec<Beat> = plan.beats().collect();
            let (frame, lighting) = ZoneMachineModel::new(&prepared.format, &plan.machine)
                .frame(beats.iter().copied(), width, height)
                .unwrap_or_else(|error: StreamError| unreachable!("the stream of a plan: {error}"));
            (vec![beats], frame, lighting, Some(plan))
        }
        MachineKind::Beam => {
            let parts = beam_slots(prepared, &prepared.slots_alone(), &machine.slots())?;
            let alone = parts.into_iter().map(|part| Slot {
                object: part.object,
                words: part.words,
                weight: part.weight,
            });
            let layers = prepared.layers.iter().cloned();
            let members = prepared.solids.slots.iter().cloned();
            let slots: Vec<Slot> = alone.chain(members).chain(layers).collect();
            let frame = beam::render(&slots, &prepared.format, width, height, || ());
            let lighting = prepared.light(&frame, || ());
            let beats = fields.iter();
            let beats = beats.map(|pixels| frame_words(scene, prepared, machine, pixels));
            (beats.collect::<Result<_>>()?, frame, lighting, None)
        }
    };
    let tables = shader.sphere.iter().flat_map(|sphere| sphere.load_words());
    let image = Image {
        pixels: fields[0],
        tables: tables.map(|(_, word)| word.into()).collect(),
        picture: finished(&frame, &lighting, &numbers, &shader, machine),
        beats: vec![],
        frame,
        lighting,
        plan,
    };
    let images = fields.into_iter().zip(beats).map(|(pixels, beats)| Image {
        pixels,
        beats,
        ..image.clone()
    });
    Ok(images.collect())
}

/// The plan of a frame of a zone machine, with the words of its shading processor.
/// Fails when the scene cannot be planned or shaded.
pub fn zone_plan(
    scene: &FramedScene,
    prepared: &PreparedScene,
    machine: &MachineDescription,
    refinement: Refinement,
) -> Result<ZonePlan> {
    let shading = shading_words(&shader(scene, &prepared.format, machine)?, machine);
    let materials = material_numbers(scene).into_iter().map(u32::from).collect();
    let plan = ZonePlan::of(prepared, machine.zone_machine())?;
    Ok(plan.refined(refinement).shaded(shading, materials)?)
}

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
    let (pixels, _) = picture.as_chunks::<3>();
    let width = frame.width / machine.supersampling as usize;
    let lines: Vec<Vec<[u8; 3]>> = pixels.chunks(width).map(<[_]>::to_vec).collect();
    machine.smoothing.kernel().picture(&lines).concat().concat()
}

/// The picture whose pixels are the means of `samples x samples` of the given one, of so many samples a line.
pub fn mean_of_samples(picture: &[u8], width: usize, samples: usize) -> Vec<u8> {
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
