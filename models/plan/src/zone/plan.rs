//! The host's plan of a frame: zones, their objects and volumes, and the passes that draw, light and show them.

use crate::culling::Planes;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::sample::Sample;
use imogene_golden::machine::zone::{ID_BITS, MAX_PICTURE, ZoneMachine, ZoneMachineError};
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::slot::Slot;
use imogene_golden::object::volume::{VolumeKind, VolumeWords};
use imogene_golden::object::words::Words;
use imogene_prepare::PreparedScene;
use std::collections::BTreeMap;
use thiserror::Error;

/// Why a scene cannot be drawn by a zone machine.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum PlanError {
    /// No machine is like this.
    #[error(transparent)]
    Machine(#[from] ZoneMachineError),
    /// A picture that is not whole pixels.
    #[error("a picture of {0} x {1} samples for pixels of {2} x {2}: both have to be a multiple")]
    PartOfPixel(u32, u32, u32),
    /// An object that its processors cannot draw.
    #[error("object '{object}': {why}")]
    Object {
        /// Name of the object.
        object: String,
        /// What is wrong.
        why: AsQuadricError,
    },
    /// A volume that its processors cannot answer for.
    #[error("{volume}: {why}")]
    Volume {
        /// Whose it is.
        volume: String,
        /// What is wrong.
        why: AsQuadricError,
    },
    /// Volumes without a processor.
    #[error(
        "the scene has {0} shadow and light volumes and the machine no volume processor; accepted is at least one"
    )]
    NoVolumeProcessor(usize),
    /// More objects than ids.
    #[error("{0} objects: an id has {ID_BITS} bits; accepted are up to {most}", most = 1 << ID_BITS)]
    Objects(usize),
    /// More pixels than coordinates.
    #[error("a picture of {0} x {1} pixels; accepted are up to {MAX_PICTURE} each way")]
    Picture(u32, u32),
    /// Materials of other objects.
    #[error("{given} materials for {objects} objects; one is needed for each object")]
    Materials {
        /// In the list.
        given: usize,
        /// Of the scene.
        objects: usize,
    },
}

/// What one object processor draws.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// Index of its object in the scene, the id of its pixels; the parts of a mesh have the same.
    pub object: u16,
    /// Words for the whole screen.
    pub words: QuadricWords,
}

/// A rectangle of the screen, and what can be seen in it at one sample of its pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Zone {
    /// First column.
    pub x0: u32,
    /// First line.
    pub y0: u32,
    /// Columns.
    pub width: u32,
    /// Lines.
    pub height: u32,
    /// The sample; a zone is there once for each.
    pub sample: Sample,
    /// Indices of the parts whose box touches the zone, ascending.
    pub parts: Vec<u32>,
    /// Indices of the volumes that matter here, ascending; none if there is no part.
    pub volumes: Vec<u32>,
    /// Of each part of which not all planes are sent: those that are.
    pub part_planes: BTreeMap<u32, Planes>,
    /// The same of volumes.
    pub volume_planes: BTreeMap<u32, Planes>,
}

impl Zone {
    /// The words of a part or a volume for the zone at its sample.
    pub(super) fn moved<W: Words + Clone>(&self, words: &W) -> W {
        let [x0, y0, width, height] = [self.x0, self.y0, self.width, self.height].map(i64::from);
        let words = words.on(&self.sample.pixels());
        words.for_zone(x0, y0, width, height)
    }
}

/// One pass of the machine over a zone.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pass<'a> {
    /// Parts go through the object processors into the buffer.
    Draw {
        /// The buffer holds nothing of this zone yet.
        first: bool,
        /// Their indices; part i of the list is loaded into processor i.
        parts: &'a [u32],
    },
    /// The buffer's depths go through the volume processors into its flags.
    Light {
        /// All sources reach everything before.
        first: bool,
        /// Indices of the volumes; volume i of the list is loaded into processor i.
        volumes: &'a [u32],
    },
    /// The buffer is shaded and goes out.
    Show {
        /// There was a light pass.
        lit: bool,
        /// There was a draw pass.
        drawn: bool,
        /// The frame ends with this zone.
        last: bool,
    },
}

/// A frame of a zone machine.
#[derive(Clone, Debug)]
pub struct ZonePlan {
    /// Widths of the words.
    pub format: Format,
    /// The machine.
    pub machine: ZoneMachine,
    /// Samples per line.
    pub width: u32,
    /// Lines of samples.
    pub height: u32,
    /// What there is to draw, by ascending object.
    pub parts: Vec<Part>,
    /// Shadow and light volumes, for the whole screen.
    pub volumes: Vec<VolumeWords>,
    /// The zones, line of zones by line of zones, each once for every sample.
    pub zones: Vec<Zone>,
    /// Words of the shading processor, address and data.
    pub shading: Vec<(u16, u32)>,
    /// Index of the material of each object; empty if nothing shades.
    pub materials: Vec<u32>,
    objects: usize,
}

impl ZonePlan {
    /// The plan of a prepared scene, whose pixels are the samples of the machine.
    pub fn of(scene: &PreparedScene, machine: ZoneMachine) -> Result<ZonePlan, PlanError> {
        machine.check()?;
        let side = 1..=MAX_PICTURE;
        if !side.contains(&scene.width) || !side.contains(&scene.height) {
            return Err(PlanError::Picture(scene.width, scene.height));
        }
        if scene.width % machine.samples + scene.height % machine.samples > 0 {
            return Err(PlanError::PartOfPixel(
                scene.width,
                scene.height,
                machine.samples,
            ));
        }
        if scene.objects.len() > 1 << ID_BITS {
            return Err(PlanError::Objects(scene.objects.len()));
        }
        let parts = parts(scene, machine.planes, |object, why| PlanError::Object {
            object,
            why,
        })?;
        if machine.volume_processors == 0 && !scene.volumes.is_empty() {
            return Err(PlanError::NoVolumeProcessor(scene.volumes.len()));
        }
        let volumes = volumes(scene, machine.volume_planes, |volume, why| {
            PlanError::Volume { volume, why }
        })?;
        let mut plan = ZonePlan {
            format: scene.format,
            machine,
            width: scene.width,
            height: scene.height,
            zones: zones(scene.width, scene.height, &machine),
            parts,
            volumes,
            shading: vec![],
            materials: vec![],
            objects: scene.objects.len(),
        };
        plan.assign();
        Ok(plan)
    }

    /// The same frame for a machine that shades: the words of its shading processor, and the index of each object's
    /// material.
    pub fn shaded(
        self,
        shading: Vec<(u16, u32)>,
        materials: Vec<u32>,
    ) -> Result<ZonePlan, PlanError> {
        if materials.len() != self.objects {
            return Err(PlanError::Materials {
                given: materials.len(),
                objects: self.objects,
            });
        }
        Ok(ZonePlan {
            shading,
            materials,
            ..self
        })
    }

    /// The passes over one of its zones, in order.
    pub fn passes<'a>(
        &self,
        zone: &'a Zone,
        last: bool,
    ) -> impl Iterator<Item = Pass<'a>> + use<'a> {
        let draws = zone.parts.chunks(self.machine.object_processors);
        let draws = draws.enumerate().map(|(batch, parts)| Pass::Draw {
            first: batch == 0,
            parts,
        });
        // Without volumes there may be no volume processor.
        let lights = zone.volumes.chunks(self.machine.volume_processors.max(1));
        let lights = lights.enumerate().map(|(batch, volumes)| Pass::Light {
            first: batch == 0,
            volumes,
        });
        let show = Pass::Show {
            lit: !zone.volumes.is_empty(),
            drawn: !zone.parts.is_empty(),
            last,
        };
        draws.chain(lights).chain([show])
    }

    /// Parts and volumes to the zones that they matter in.
    fn assign(&mut self) {
        let zones_of = {
            let (machine, width) = (self.machine, self.width);
            move |window: &ScreenBox| zones_of(window, width, &machine)
        };
        let seen = |window: &ScreenBox| !window.is_empty();
        for (index, part) in self.parts.iter().enumerate() {
            let window = &part.words.screen_box;
            if seen(window) {
                for zone in zones_of(window) {
                    self.zones[zone].parts.push(index as u32);
                }
            }
        }
        for (index, volume) in self.volumes.iter().enumerate() {
            let add = |zone: &mut Zone| {
                if !zone.parts.is_empty() {
                    zone.volumes.push(index as u32);
                }
            };
            match volume.kind {
                // Outside of it is dark, also outside its box.
                VolumeKind::Light => self.zones.iter_mut().for_each(add),
                VolumeKind::Shadow if seen(&volume.screen_box) => {
                    for zone in zones_of(&volume.screen_box) {
                        add(&mut self.zones[zone]);
                    }
                }
                VolumeKind::Shadow => {}
            }
        }
    }
}

/// Indices of the zones that a box of samples touches, on a screen of `width` samples per line.
fn zones_of(window: &ScreenBox, width: u32, machine: &ZoneMachine) -> Vec<usize> {
    let of = machine.samples;
    let columns = (width / of).div_ceil(machine.zone_width);
    let span = |first: i64, last: i64, size: u32| {
        let size = i64::from(size);
        (first / size) as u32..=(last / size) as u32
    };
    let mut zones = vec![];
    for (place, sample) in Sample::all(of).enumerate() {
        let window = window.on(&sample.pixels());
        if window.is_empty() {
            continue;
        }
        for v in span(window.y0, window.y1, machine.zone_height) {
            for u in span(window.x0, window.x1, machine.zone_width) {
                zones.push(((v * columns + u) * of * of) as usize + place);
            }
        }
    }
    zones
}

/// Object and words of every part of a scene, for processors of so many planes; `refused` says of an object why not.
pub(crate) fn parts<E>(
    scene: &PreparedScene,
    planes: usize,
    refused: impl Fn(String, AsQuadricError) -> E,
) -> Result<Vec<Part>, E> {
    let part = |slot: Slot| {
        let words = match slot.weight {
            Some(_) => Err(AsQuadricError::Transparent),
            None => slot.words.on_quadric_processor(&scene.format, planes),
        };
        let name = || scene.objects[slot.object].name().to_owned();
        Ok(Part {
            object: slot.object as u16,
            words: words.map_err(|why| refused(name(), why))?,
        })
    };
    scene.slots().into_iter().map(part).collect()
}

/// The same of every volume.
pub(crate) fn volumes<E>(
    scene: &PreparedScene,
    planes: usize,
    refused: impl Fn(String, AsQuadricError) -> E,
) -> Result<Vec<VolumeWords>, E> {
    let volumes = scene.volumes.iter().map(|volume| {
        let words = volume.words.on_quadric_processor(planes);
        words.map_err(|why| refused(volume.name.clone(), why))
    });
    volumes.collect()
}

/// The screen cut into zones, once for every sample, without anything in them.
fn zones(width: u32, height: u32, machine: &ZoneMachine) -> Vec<Zone> {
    let (width, height) = (width / machine.samples, height / machine.samples);
    let mut zones = vec![];
    for y0 in (0..height).step_by(machine.zone_height as usize) {
        for x0 in (0..width).step_by(machine.zone_width as usize) {
            zones.extend(Sample::all(machine.samples).map(|sample| Zone {
                x0,
                y0,
                width: machine.zone_width.min(width - x0),
                height: machine.zone_height.min(height - y0),
                sample,
                parts: vec![],
                volumes: vec![],
                part_planes: BTreeMap::new(),
                volume_planes: BTreeMap::new(),
            }));
        }
    }
    zones
}
