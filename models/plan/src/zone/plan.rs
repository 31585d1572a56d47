//! The host's plan of a frame: zones, their objects and volumes, and the passes that draw, light and show them.

pub use super::error::PlanError;
use super::error::Result;
pub use super::share::Part;
use super::share::{layers, parts, shared_out};
use crate::culling::Planes;
use crate::culling::zones::window_of;
pub use crate::products::{ZoneProduct, in_passes};
use crate::split::Division;
use imogene_golden::format::Format;
use imogene_golden::machine::zone::sample::Sample;
use imogene_golden::machine::zone::{ID_BITS, MAX_PICTURE, ZoneMachine};
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::volume::{VolumeKind, VolumeWords};
use imogene_golden::object::words::Words;
use imogene_prepare::PreparedScene;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// A rectangle of the screen, and what can be seen in it at one sample of its pixels.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Zone {
    /// Its pixels on the screen.
    pub window: ScreenBox,
    /// The sample; a zone is there once for each.
    pub sample: Sample,
    /// Indices of the parts that are in no solid and whose box touches the zone, ascending.
    pub parts: Vec<u32>,
    /// Products of which the boxes of all objects intersected share a place in the zone.
    pub products: Vec<ZoneProduct>,
    /// Indices of the transparent objects whose box touches the zone.
    pub layers: Vec<usize>,
    /// Indices of the volumes that matter here, ascending; none if there is nothing to draw.
    pub volumes: Vec<u32>,
    /// Of each part of which not all planes are sent: those that are.
    pub part_planes: BTreeMap<u32, Planes>,
    /// The same of volumes.
    pub volume_planes: BTreeMap<u32, Planes>,
}

impl Zone {
    /// True if there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.parts.is_empty() && self.products.is_empty()
    }

    /// The parts that are sent to it, those of products as often as these name them.
    pub fn all_parts(&self) -> impl Iterator<Item = u32> + '_ {
        let members = self.products.iter().flat_map(ZoneProduct::parts);
        self.parts.iter().copied().chain(members)
    }

    /// The words of a part or a volume for the zone at its sample.
    pub(super) fn moved<W: Words + Clone>(&self, words: &W) -> W {
        self.in_zone(&words.on(&self.sample.pixels()))
    }

    /// The same of words that are those of its sample.
    pub(super) fn in_zone<W: Words + Clone>(&self, words: &W) -> W {
        let (ScreenBox { x0, y0, .. }, [width, height]) = (self.window, self.window.size());
        words.for_zone(x0, y0, width, height)
    }
}

/// One pass of the machine over a zone.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Pass<'a> {
    /// Parts go through the object processors into the buffer.
    Draw {
        /// The buffer holds nothing of this zone yet.
        first: bool,
        /// Processors, and the index of the part that each is loaded with.
        parts: Vec<(usize, u32)>,
    },
    /// The buffer's depths go through the volume processors into its flags.
    Light {
        /// All sources reach everything before.
        first: bool,
        /// Indices of the volumes; volume i of the list is loaded into processor i.
        volumes: &'a [u32],
    },
    /// The buffer is shaded, and goes out with what is transparent before it.
    Show {
        /// Indices of the transparent objects, each for the processor of the same number.
        layers: &'a [usize],
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
    /// What there is to draw: by ascending object what is in no solid, then the objects of solids, product by product.
    pub parts: Vec<Part>,
    /// The transparent objects, the farthest first.
    pub layers: Vec<Part>,
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
    pub fn of(scene: &PreparedScene, machine: ZoneMachine) -> Result<ZonePlan> {
        machine.check()?;
        let side = 1..=MAX_PICTURE;
        if !side.contains(&scene.width) || !side.contains(&scene.height) {
            return Err(PlanError::Picture(scene.width, scene.height));
        }
        if scene.width % machine.samples + scene.height % machine.samples > 0 {
            let samples = machine.samples;
            return Err(PlanError::PartOfPixel(scene.width, scene.height, samples));
        }
        if scene.objects.len() > 1 << ID_BITS {
            return Err(PlanError::Objects(scene.objects.len()));
        }
        let sizes = scene.solids.products.iter().map(|product| product.size());
        let sizes: Vec<[usize; 2]> = sizes.collect();
        let alone = scene.slots_alone().len();
        check_places(&machine, alone, &sizes)?;
        let parts = parts(scene, &machine)?;
        let layers = layers(scene, &machine)?;
        if machine.volume_processors == 0 && !scene.volumes.is_empty() {
            return Err(PlanError::NoVolumeProcessor(scene.volumes.len()));
        }
        let volumes = volumes(scene, machine.volume_planes, PlanError::Volume)?;
        let mut plan = ZonePlan {
            format: scene.format,
            width: scene.width,
            height: scene.height,
            zones: zones(scene.width, scene.height, &machine),
            machine,
            parts,
            layers,
            volumes,
            shading: vec![],
            materials: vec![],
            objects: scene.objects.len(),
        };
        for index in 0..alone {
            for zone in plan.zones_of(plan.parts[index].words.screen_box()) {
                plan.zones[zone].parts.push(index as u32);
            }
        }
        let mut first = alone;
        for [intersected, subtracted] in sizes {
            let middle = first + intersected;
            plan.assign_product(first..middle, middle..middle + subtracted);
            first = middle + subtracted;
        }
        plan.assign_volumes();
        for index in 0..plan.layers.len() {
            for zone in plan.zones_of(plan.layers[index].words.screen_box()) {
                plan.zones[zone].layers.push(index);
            }
        }
        Ok(plan)
    }

    /// The same frame for a machine that shades: the words of its shading processor, and the index of each object's
    /// material.
    pub fn shaded(self, shading: Vec<(u16, u32)>, materials: Vec<u32>) -> Result<ZonePlan> {
        if materials.len() != self.objects {
            return Err(PlanError::Materials(materials.len(), self.objects));
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
        let draws = self.draws(zone).into_iter().enumerate();
        let draws = draws.map(|(batch, parts)| Pass::Draw {
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
            layers: &zone.layers,
            lit: !zone.volumes.is_empty(),
            drawn: !zone.is_empty(),
            last,
        };
        draws.chain(lights).chain([show])
    }

    /// Draw passes of a frame.
    pub fn draw_passes(&self) -> usize {
        self.zones.iter().map(|zone| self.draws(zone).len()).sum()
    }

    /// Processors and parts of each draw pass over a zone. Objects go in their order, products as there is a place.
    fn draws(&self, zone: &Zone) -> Vec<Vec<(usize, u32)>> {
        // Without objects that are in no solid there may be no processor for them.
        let mut draws = shared_out(&self.parts, &zone.parts, &self.machine);
        let products = in_passes(&self.machine, &zone.products);
        draws.resize(draws.len().max(products.len()), vec![]);
        for (draw, members) in draws.iter_mut().zip(products) {
            draw.extend(members);
        }
        draws
    }

    /// A product to the zones where the boxes of all that it intersects share a place, each object that it takes away
    /// to those of them where it shares it.
    fn assign_product(&mut self, intersected: Range<usize>, subtracted: Range<usize>) {
        let window = |part: &Part| *part.words.screen_box();
        let boxes = self.parts[intersected.clone()].iter().map(window);
        let common = boxes.reduce(|all, one| all.shared(&one));
        let common = common.unwrap_or(ScreenBox::EMPTY);
        let reached = |part| BTreeSet::from_iter(self.zones_of(&common.shared(&window(part))));
        let taken_away = self.parts[subtracted.clone()].iter().map(reached);
        let taken_away: Vec<BTreeSet<usize>> = taken_away.collect();
        for zone in self.zones_of(&common) {
            let own = subtracted.clone().zip(&taken_away);
            let own = own.filter(|(_, zones)| zones.contains(&zone));
            self.zones[zone].products.push(ZoneProduct {
                intersected: intersected.clone().map(|part| part as u32).collect(),
                subtracted: own.map(|(part, _)| part as u32).collect(),
            });
        }
    }

    fn assign_volumes(&mut self) {
        for (index, volume) in self.volumes.iter().enumerate() {
            let zones = match volume.kind {
                // Outside of it is dark, also outside its box.
                VolumeKind::Light => (0..self.zones.len()).collect(),
                VolumeKind::Shadow => self.zones_of(&volume.screen_box),
            };
            for zone in zones {
                if !self.zones[zone].is_empty() {
                    self.zones[zone].volumes.push(index as u32);
                }
            }
        }
    }

    /// Indices of the zones that a box of samples touches.
    fn zones_of(&self, window: &ScreenBox) -> Vec<usize> {
        let (machine, of) = (&self.machine, self.machine.samples);
        let columns = (self.width / of).div_ceil(machine.zone_width);
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
}

/// Refuses a machine without a processor for objects in no solid, or without a product as large as one of the scene's.
fn check_places(machine: &ZoneMachine, alone: usize, products: &[[usize; 2]]) -> Result {
    if machine.alone() == 0 && alone > 0 {
        return Err(PlanError::NoObjectProcessor(alone));
    }
    let has_place = |size: &[usize; 2]| machine.products.iter().any(|slots| slots.hold(*size));
    match products.iter().find(|size| !has_place(size)) {
        Some(&large) => Err(PlanError::NoProduct(large)),
        None => Ok(()),
    }
}

/// Words of every volume, for processors of so many planes.
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
    let division = Division::Zones {
        width: machine.zone_width,
        height: machine.zone_height,
    };
    let pieces = division.pieces(width / machine.samples, height / machine.samples);
    let zones = pieces.into_iter().flat_map(|piece| {
        Sample::all(machine.samples).map(move |sample| Zone {
            window: window_of(&piece),
            sample,
            ..Zone::default()
        })
    });
    zones.collect()
}
