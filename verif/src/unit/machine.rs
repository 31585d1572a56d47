//! The coefficient store and the beam machine, fed over the load bus.

use super::decision::flat;
use super::description::{Description, WORDS, behind_valid, bit, late};
use super::object::plausible;
use crate::scene::golden::GoldenMachine;
use crate::signal::Signal;
use crate::stimulus::{each, mapped, word};
use crate::subject::{Inputs, Stimuli, Subject};
use imogene_contract::object::{BOX_COLUMNS, PLANES, words};
use imogene_contract::slots::FittedSlot;
use imogene_contract::{Request, Unit};
use imogene_golden::format::Format;
use imogene_golden::machine::decider::{Visible, latency as tree_latency};
use imogene_golden::machine::raster::RasterControl;
use imogene_golden::object::load_slot::held;
use imogene_golden::object::quadric::{QuadricWords, latency};
use imogene_golden::object::slot::ProcessorWords;
use imogene_hdl::Direction;
use imogene_rtl::emit::design;
use proptest::prelude::*;

/// Where the words of the box and the control word begin (`docs/architecture.md`, section 7).
const BOX: usize = BOX_COLUMNS as usize;
/// First column of a store that was never loaded, which makes its box empty.
const NEVER_LOADED: u64 = 4095;

/// Where each coefficient port of a processor lies on the load bus, in the order of the ports: address and lowest bit.
fn places(planes: usize) -> Vec<(usize, u32)> {
    let mut list: Vec<(usize, u32)> = (0..BOX).map(|address| (address, 0)).collect();
    list.extend([(BOX, 0), (BOX, 12), (BOX + 1, 0), (BOX + 1, 12)]);
    list.extend([(BOX + 2, 2), (BOX + 2, 0)]);
    list.extend((PLANES as usize..words(planes)).map(|address| (address, 0)));
    list
}

/// The ports of a processor for its words.
fn coefficients(depth_word: u32, planes: usize) -> Vec<Signal> {
    let processor = Request {
        planes: planes as u32,
        ..Request::of(Unit::QuadricProcessor, depth_word)
    };
    let circuit = design(&processor).expect("a legal request").top;
    let ports = circuit.ports_of(Direction::In).skip(WORDS);
    ports.map(Signal::of).collect()
}

/// The words of one slot.
#[derive(Clone)]
struct Slot(Vec<u64>);

impl Slot {
    fn new(planes: usize) -> Slot {
        let mut words = vec![0; words(planes)];
        words[BOX] = NEVER_LOADED;
        Slot(words)
    }

    /// Writes a word; an address beyond the last is ignored.
    fn write(&mut self, address: i64, data: i64) {
        if let Some(word) = self.0.get_mut(address as usize) {
            *word = data as u64;
        }
    }
}

pub(super) fn coefficient_store(format: Format, planes: usize) -> Description {
    let stated = coefficients(format.depth, planes);
    Description::new(writes, move || {
        let mut slot = Slot::new(planes);
        let (ports, places) = (stated.clone(), places(planes));
        move |i: &[i64]| {
            if bit(i[0]) {
                slot.write(i[1], i[2]);
            }
            let values = ports.iter().zip(&places);
            let values = values.map(|(port, (address, low))| port.value(slot.0[*address] >> low));
            values.map(Some).collect()
        }
    })
}

/// Writes to every address and just beyond, now and then none.
fn writes(subject: &Subject, clocks: usize) -> Stimuli {
    let addresses = subject.outputs.len() as i64;
    let write = prop_oneof![4 => Just(1i64), 1 => Just(0)].boxed();
    let address = prop_oneof![9 => 0..addresses, 1 => 0i64..256].boxed();
    each(vec![write, address, word(&subject.inputs[2])], clocks)
}

pub(super) fn beam(format: Format, objects: usize, planes: usize, rows: usize) -> Description {
    let pictures = move |subject: &_, clocks| pictures(subject, clocks, planes, objects);
    Description::new(pictures, move || {
        let mut machine = Machine {
            format,
            kind: FittedSlot::quadric(planes as u32),
            slots: vec![Slot::new(planes); objects],
            raster: RasterControl::default(),
            zone: None,
        };
        let clocks = 1 + latency(&format, planes, rows as u32) + tree_latency(objects);
        let mut late = late(clocks as usize);
        move |i: &[i64]| {
            // Before the first pixel can come out, valid is low as ever without one.
            behind_valid(Some(late.push(machine.clock(i)).flatten().map(flat)))
        }
    })
}

/// The golden machine: slots, raster and processors. Words do not change while a zone is drawn.
struct Machine {
    format: Format,
    /// What each slot is.
    kind: FittedSlot,
    slots: Vec<Slot>,
    raster: RasterControl,
    zone: Option<GoldenMachine>,
}

impl Machine {
    fn clock(&mut self, i: &[i64]) -> Option<Visible> {
        if bit(i[3])
            && let Some(slot) = self.slots.get_mut(i[4] as usize)
        {
            slot.write(i[5], i[6]);
        }
        let pixel = self.raster.clock(bit(i[0]), i[1] as u16, i[2] as u16)?;
        if pixel.start {
            let words = |slot: &Slot| match held(&slot.0, &self.format, &self.kind) {
                ProcessorWords::Quadric(words) => words,
                other => unreachable!("{other:?} in a slot of a quadric"),
            };
            let words: Vec<QuadricWords> = self.slots.iter().map(words).collect();
            self.zone = Some(GoldenMachine::new(&words, &self.format, i[1] as usize));
        }
        Some(self.zone.as_mut()?.pixel(None).0)
    }
}

/// Every slot loaded with a plausible object, the last one sometimes left alone; then one zone in `clocks` clocks.
fn pictures(subject: &Subject, clocks: usize, planes: usize, objects: usize) -> Stimuli {
    let data = subject.inputs[6].clone();
    let ports = coefficients(subject.outputs[1].width, planes);
    let values = proptest::collection::vec(plausible(&ports), objects);
    mapped(
        (values, 1i64..24, any::<bool>()),
        move |(values, width, skip_last)| {
            let mut list: Vec<Inputs> = Vec::new();
            let loaded = objects - usize::from(skip_last && objects > 1);
            for (object, values) in (0..).zip(&values[..loaded]) {
                // The words on the load bus that give the ports these values.
                let mut words = vec![0; words(planes)];
                for ((port, &value), (address, low)) in ports.iter().zip(values).zip(places(planes))
                {
                    words[address] |= port.bits(value) << low;
                }
                let load = |(address, bits)| vec![0, 0, 0, 1, object, address, data.value(bits)];
                list.extend((0..).zip(words).map(load));
            }
            let height = (clocks as i64 / width).clamp(1, 40);
            for clock in 0..clocks {
                list.push(vec![i64::from(clock == 0), width, height, 0, 0, 0, 0]);
            }
            list
        },
    )
}
