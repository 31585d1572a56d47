//! What the processors of a variant are made of and what they cost on a device.

use crate::failure::Result;
use imogene_contract::Request;
use imogene_golden::format::Format;
use imogene_golden::machine::decider;
use imogene_golden::object::slot::Slot;
use imogene_package::census::{Census, census};
use imogene_synth::table::{Measured, Table};
use imogene_verif::unit::words::processor;
use serde::Serialize;
use std::collections::{BTreeMap, HashMap};

/// The published figures, compiled in.
const RESOURCES: &str = include_str!("../../../../docs/resources.json");
/// The device of the figures.
pub const TARGET: &str = "ecp5-45k";

/// The processors of a variant; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct Hardware {
    /// Processors, one for each part of an object.
    pub processors: usize,
    pub kinds: BTreeMap<String, usize>,
    /// What they are made of.
    #[serde(flatten)]
    pub census: Census,
    /// LUT4 of all processors; none if a figure is not in the table.
    pub lut: Option<u64>,
    pub ff: Option<u64>,
    pub cells: Option<u64>,
    /// Multiplier blocks.
    pub dsp: Option<u64>,
    /// Clocks of a frame if all processors work at once: pixels and latency.
    pub frame_clocks: u64,
    /// Clocks if one processor of each kind draws all its parts one after the other over the whole screen.
    pub one_by_one_clocks: u64,
    /// The same if it visits the screen box of each part alone.
    pub one_by_one_box_clocks: u64,
}

/// What processors of one kind are called: the unit, with its planes or sides.
fn name(request: &Request) -> String {
    let unit = request.unit.name();
    let mut options = request.options().into_iter();
    match options.find(|(option, _)| *option != "rows-per-stage") {
        Some((what, count)) => format!("{unit}, {count} {what}"),
        None => unit.to_owned(),
    }
}

/// Their row of the published table.
fn row<'a>(request: &Request, rows: &'a [Measured]) -> Option<&'a Measured> {
    let options = [("format", request.depth_word)].into_iter();
    let options: Vec<_> = options.chain(request.options()).collect();
    rows.iter().find(|row| {
        let has = |name: &str, wanted: u32| {
            let value = row.parameters.get(name);
            value.is_none_or(|&v| v == wanted as usize)
        };
        let mut options = options.iter();
        row.unit == request.unit.name()
            && row.target == TARGET
            && options.all(|&(name, wanted)| has(name, wanted))
    })
}

/// The processors of these slots, on a screen of so many pixels.
pub fn of(slots: &[Slot], screen: u64) -> Result<Hardware> {
    let table: Table = serde_json::from_str(RESOURCES)?;
    let mut kinds: HashMap<Request, usize> = HashMap::new();
    for slot in slots {
        let loaded = processor(&slot.words, &Format::BASE);
        let loaded = loaded.expect("the comparison has processors with hardware");
        *kinds.entry(loaded.request).or_default() += 1;
    }
    let boxes: u64 = slots.iter().map(|s| s.words.screen_box().pixels()).sum();
    let mut all = Census::default();
    let mut sums = [Some(0); 4];
    let mut slowest = 0;
    for (request, number) in &kinds {
        let parts = census(request)?;
        all.pe1 += number * parts.pe1;
        all.pe2 += number * parts.pe2;
        all.roots += number * parts.roots;
        all.multipliers += number * parts.multipliers;
        slowest = slowest.max(request.latency() as u64);
        let figures = row(request, &table.rows).map(|row| &row.figures);
        let figures = figures.map_or([None; 4], |f| [f.lut, f.ff, f.cells, f.dsp]);
        for (sum, figure) in sums.iter_mut().zip(figures) {
            *sum = sum.zip(figure).map(|(sum, one)| sum + *number as u64 * one);
        }
    }
    let [lut, ff, cells, dsp] = sums;
    // Raster control, processor, decider: as in the beam machine.
    let latency = 1 + slowest + u64::from(decider::latency(slots.len().max(1)));
    Ok(Hardware {
        processors: slots.len(),
        kinds: kinds.iter().map(|(kind, n)| (name(kind), *n)).collect(),
        census: all,
        lut,
        ff,
        cells,
        dsp,
        frame_clocks: screen + latency,
        one_by_one_clocks: slots.len() as u64 * screen + latency,
        one_by_one_box_clocks: boxes + latency,
    })
}
