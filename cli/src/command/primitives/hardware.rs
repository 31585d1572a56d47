//! What the processors of a variant are made of and what they cost on a device.

use crate::failure::Failure;
use imogene_contract::{Request, Unit};
use imogene_golden::machine::decider;
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::words::Words;
use imogene_package::census::{Census, census};
use imogene_synth::table::{Measured, Table};
use serde::Serialize;
use std::collections::BTreeMap;

/// The published figures, compiled in.
const RESOURCES: &str = include_str!("../../../../docs/resources.json");
/// The device of the figures.
pub const TARGET: &str = "ecp5-45k";

/// The processors of a variant; the keys are stable.
#[derive(Clone, Debug, Serialize)]
pub struct Hardware {
    /// Processors, one for each part of an object.
    pub processors: usize,
    /// How many of each kind.
    pub kinds: BTreeMap<String, usize>,
    /// What they are made of.
    #[serde(flatten)]
    pub census: Census,
    /// LUT4 of all processors; none if a figure is not in the table.
    pub lut: Option<u64>,
    /// Flip-flops.
    pub ff: Option<u64>,
    /// Logic cells.
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

/// Processors of one kind: the unit with its planes or sides.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Kind {
    unit: &'static str,
    count: Option<(&'static str, usize)>,
}

impl Kind {
    fn of(words: &ProcessorWords) -> (Unit, Kind) {
        let (unit, count) = match words {
            ProcessorWords::Facet(words) => {
                (Unit::FacetProcessor, Some(("sides", words.edges.len())))
            }
            ProcessorWords::Sphere(_) => (Unit::SphereProcessor, None),
            ProcessorWords::Cylinder(_) => (Unit::CylinderProcessor, None),
            ProcessorWords::Quadric(words) => {
                (Unit::QuadricProcessor, Some(("planes", words.planes.len())))
            }
            _ => unreachable!("the comparison has no other processors"),
        };
        let unit_name = unit.name();
        (
            unit,
            Kind {
                unit: unit_name,
                count,
            },
        )
    }

    fn name(&self) -> String {
        match self.count {
            Some((what, count)) => format!("{}, {count} {what}", self.unit),
            None => self.unit.to_owned(),
        }
    }

    /// Its row of the published table.
    fn row<'a>(&self, rows: &'a [Measured]) -> Option<&'a Measured> {
        rows.iter().find(|row| {
            let has =
                |name: &str, value: usize| row.parameters.get(name).is_none_or(|&v| v == value);
            row.unit == self.unit
                && row.target == TARGET
                && has("format", 24)
                && has("rows-per-stage", 1)
                && self.count.is_none_or(|(what, count)| has(what, count))
        })
    }
}

/// The processors of these slots, on a screen of so many pixels.
pub fn of(slots: &[Slot], screen: u64) -> Result<Hardware, Failure> {
    let table: Table = serde_json::from_str(RESOURCES)?;
    let mut kinds: BTreeMap<Kind, (Unit, usize)> = BTreeMap::new();
    for slot in slots {
        let (unit, kind) = Kind::of(&slot.words);
        kinds.entry(kind).or_insert((unit, 0)).1 += 1;
    }
    let boxes: u64 = slots.iter().map(|s| s.words.screen_box().pixels()).sum();
    let mut sum = Hardware {
        processors: slots.len(),
        kinds: kinds.iter().map(|(k, (_, n))| (k.name(), *n)).collect(),
        census: Census::default(),
        lut: Some(0),
        ff: Some(0),
        cells: Some(0),
        dsp: Some(0),
        frame_clocks: 0,
        one_by_one_clocks: slots.len() as u64 * screen,
        one_by_one_box_clocks: boxes,
    };
    let mut latency = 0;
    for (kind, (unit, number)) in &kinds {
        let mut request = Request::new(*unit);
        match kind.count {
            Some(("planes", planes)) => request.planes = planes as u32,
            Some((_, sides)) => request.sides = sides as u32,
            None => (),
        }
        let parts = census(&request)?;
        sum.census.pe1 += number * parts.pe1;
        sum.census.pe2 += number * parts.pe2;
        sum.census.roots += number * parts.roots;
        sum.census.multipliers += number * parts.multipliers;
        latency = latency.max(request.latency() as u64);
        let figures = kind.row(&table.rows).map(|row| &row.figures);
        let add = |sum: &mut Option<u64>, figure: Option<u64>| {
            *sum = sum.zip(figure).map(|(sum, one)| sum + *number as u64 * one);
        };
        add(&mut sum.lut, figures.and_then(|f| f.lut));
        add(&mut sum.ff, figures.and_then(|f| f.ff));
        add(&mut sum.cells, figures.and_then(|f| f.cells));
        add(&mut sum.dsp, figures.and_then(|f| f.dsp));
    }
    // Raster control, processor, decider: as in the beam machine.
    let latency = 1 + latency + u64::from(decider::latency(slots.len().max(1)));
    sum.frame_clocks = screen + latency;
    sum.one_by_one_clocks += latency;
    sum.one_by_one_box_clocks += latency;
    Ok(sum)
}
