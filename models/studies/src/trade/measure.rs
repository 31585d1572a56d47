//! One point: the scene prepared for it, drawn, and compared with the truth.

use super::design::Accuracy;
use crate::kit::words::narrowest;
use imogene_analysis::metrics::toggles::{Part, Toggles, count};
use imogene_analysis::metrics::{Drawing, Metrics, Truth, ZoneScene, measure as compare};
use imogene_contract::{MachineWords, object};
use imogene_golden::format::Format;
use imogene_golden::machine::fitted::{FittedMachine, FittedSlot};
use imogene_golden::object::quadric::QuadricWords;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{Options, PreparedScene, prepare_with};
use imogene_scene::FramedScene;

/// What is known of all points of the same pixels.
pub struct Measured {
    /// Every width.
    pub widths: MachineWords,
    /// How far the picture is from the truth.
    pub metrics: Metrics,
    /// The picture.
    pub rgb: Vec<u8>,
    /// The map of its errors.
    pub map: Vec<u8>,
    zones: Vec<ZoneScene>,
    catalogue: bool,
    is_whole: bool,
}

/// Draws and compares; the error says why the scene cannot be prepared.
pub fn measure(
    scene: &FramedScene,
    truth: &Truth,
    accuracy: &Accuracy,
) -> Result<Measured, String> {
    let (widths, zones) = prepared(scene, accuracy)?;
    let drawing = match zones.as_slice() {
        [whole] => Drawing::of(&whole.prepared, scene),
        zones => Drawing::in_zones(zones, scene),
    };
    let (metrics, map) = compare(truth, &drawing);
    Ok(Measured {
        widths,
        metrics,
        rgb: drawing.rgb,
        map,
        zones,
        catalogue: accuracy.catalogue,
        is_whole: accuracy.zone == 0,
    })
}

impl Measured {
    /// The machine with so many rows of the root network between registers.
    pub fn machine(&self, rows_per_stage: u32) -> FittedMachine {
        let prepared = &self.zones[0].prepared;
        let fitted = prepared.fitted_machine(rows_per_stage);
        if !self.catalogue {
            return fitted;
        }
        let most = fitted.slots.iter().map(|slot| slot.planes).max();
        let objects = fitted.slots.len();
        FittedMachine::uniform(&prepared.format, objects, most.unwrap_or(0), rows_per_stage)
    }

    /// Clocks of an image: one for each pixel and the latency; in zones, for each of them the latency again, while its
    /// last pixels leave, and one for each word that is loaded.
    pub fn clocks_per_frame(&self, machine: &FittedMachine) -> u64 {
        let prepared = &self.zones[0].prepared;
        if self.is_whole {
            return machine.clocks_per_frame(&prepared.format, prepared.width, prepared.height);
        }
        let words = |slot: &FittedSlot| object::words(slot.planes as usize) as u64;
        let load: u64 = machine.slots.iter().map(words).sum();
        let each = u64::from(machine.latency(&prepared.format)) + load;
        u64::from(prepared.width) * u64::from(prepared.height) + each * self.zones.len() as u64
    }

    /// Clocks from `go` to the first pixel.
    pub fn latency(&self, machine: &FittedMachine) -> u32 {
        machine.latency(&self.zones[0].prepared.format)
    }

    /// Bits that change from clock to clock.
    pub fn toggles(&self, rows_per_stage: u32) -> Toggles {
        let parts: Vec<Part> = self.zones.iter().map(part).collect();
        let prepared = &self.zones[0].prepared;
        count(&parts, &prepared.format, rows_per_stage, prepared.height)
    }
}

fn part(zone: &ZoneScene) -> Part<'_> {
    let words = |(_, object)| -> &QuadricWords {
        let object: &imogene_prepare::PreparedQuadric = object;
        &object.words
    };
    Part {
        slots: zone.prepared.quadrics().map(words).collect(),
        first: zone.first,
        size: zone.size,
    }
}

/// The scene prepared for each zone, in one format for all.
fn prepared(
    scene: &FramedScene,
    accuracy: &Accuracy,
) -> Result<(MachineWords, Vec<ZoneScene>), String> {
    if accuracy.catalogue {
        let format = Format::new(accuracy.depth).map_err(|e| e.to_string())?;
        let widths = format.widths();
        return Ok((widths, in_format(scene, accuracy, &widths)?));
    }
    let wide = accuracy.widest();
    let zones = |widths: &MachineWords| match in_format(scene, accuracy, widths) {
        Err(problem) if *widths == wide => Err(problem),
        zones => Ok(zones.ok()),
    };
    let found = narrowest(&wide, zones, |zone| zone.prepared.needed())?;
    Ok(found.expect("a refusal of the widest words is an error"))
}

/// The scene in a format, prepared for the whole screen or for each zone.
pub fn in_format(
    scene: &FramedScene,
    accuracy: &Accuracy,
    widths: &MachineWords,
) -> Result<Vec<ZoneScene>, String> {
    let format = Format::fitted(widths).map_err(|e| e.to_string())?;
    zones(scene, format, accuracy.zone).map_err(|e| e.to_string())
}

/// The scene prepared for zones of so many columns and lines, or once for the whole screen (0).
pub fn zones(
    scene: &FramedScene,
    format: Format,
    zone: u32,
) -> Result<Vec<ZoneScene>, imogene_prepare::error::PrepareError> {
    let (width, height) = (scene.width as usize, scene.height as usize);
    let whole = |prepared: PreparedScene| ZoneScene {
        first: (0, 0),
        size: (width, height),
        prepared,
    };
    if zone == 0 {
        return Ok(vec![whole(prepare_with(scene, format, Options::ROOTS)?)]);
    }
    let side = zone as usize;
    let mut all = vec![];
    for y in (0..height).step_by(side) {
        for x in (0..width).step_by(side) {
            let size = (side.min(width - x), side.min(height - y));
            let anchor = Anchor {
                x: (x + size.0 / 2) as i64,
                y: (y + size.1 / 2) as i64,
            };
            let options = Options {
                anchor: Some(anchor),
                ..Options::ROOTS
            };
            all.push(ZoneScene {
                first: (x, y),
                size,
                prepared: prepare_with(scene, format, options)?,
            });
        }
    }
    Ok(all)
}
