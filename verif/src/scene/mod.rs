//! Co-simulation of a whole scene: a beam machine against the golden machine, every output on every clock.
//!
//! The screen is cut into bands, one for each thread: zones, as of a machine with several graphics modules (2.4.4).

mod band;
pub(crate) mod golden;
pub mod slots;
pub mod volumes;
pub mod zone;

use crate::engine::design::DesignError;
use crate::engine::machine::MachineDesign;
use crate::engine::{Engine, processor_signals};
use crate::report::Report;
use crate::subject::Inputs;
use crate::waveform::{PlaceError, WaveformRequest, WindowStart};
use band::{Band, Part};
use imogene_contract::slots::FittedSlot;
use imogene_contract::{Request, Unit};
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::load::load_words;
use imogene_golden::object::quadric::{MAX_PLANES, PlaneWords, QuadricWords};
use imogene_golden::object::words::Words;
use imogene_prepare::{PreparedObject, PreparedScene};
use imogene_rtl::emit::machine::MachineRequest;
use rayon::prelude::*;
use std::fmt;
use std::str::FromStr;
use std::sync::Arc;
use std::time::Instant;
use thiserror::Error;

/// Most objects of a beam machine.
pub const MAX_OBJECTS: usize = 256;

/// A wrong bit in one coefficient word of the hardware, to see that the co-simulation finds it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Slot.
    pub object: u8,
    /// Load address.
    pub address: u8,
    /// Bit of the word.
    pub bit: u8,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.object, self.address, self.bit)
    }
}

impl FromStr for Fault {
    type Err = String;

    fn from_str(text: &str) -> Result<Fault, String> {
        let numbers: Option<Vec<u8>> = text.split(':').map(|part| part.parse().ok()).collect();
        match numbers.as_deref() {
            Some(&[object, address, bit]) => Ok(Fault {
                object,
                address,
                bit,
            }),
            _ => Err("expected OBJECT:ADDRESS:BIT, three numbers below 256, such as 0:2:5".into()),
        }
    }
}

/// How to run.
#[derive(Clone, Debug)]
pub struct Options {
    /// Rows of the root network per register stage.
    pub rows_per_stage: usize,
    /// Threads, each with an engine of its own.
    pub threads: usize,
    /// Waveforms of the band in which the window begins.
    pub trace: Option<WaveformRequest>,
    /// Slot whose inside they show.
    pub traced: usize,
    /// Fault put into the hardware.
    pub fault: Option<Fault>,
}

impl Options {
    /// A run without waveforms and faults.
    pub fn plain(rows_per_stage: usize, threads: usize) -> Options {
        Options {
            rows_per_stage,
            threads,
            trace: None,
            traced: 0,
            fault: None,
        }
    }
}

/// Why a scene cannot be co-simulated.
#[derive(Debug, Error)]
pub enum CosimError {
    /// More objects than slots, or none.
    #[error("the scene has {0} objects; a beam machine takes 1 to {MAX_OBJECTS}")]
    Objects(usize),
    /// More planes than a processor can have.
    #[error("an object has {0} cut planes; a quadric processor takes at most {MAX_PLANES}")]
    Planes(usize),
    /// An object of a processor that the machine does not have.
    #[error(
        "object '{0}' is not drawn by a quadric processor, and a beam machine has no other; each of its processors runs by itself"
    )]
    Processor(String),
    /// Rows per stage out of range, and the rows of the network.
    #[error("rows-per-stage is {0}; accepted: 1 to {1}")]
    Rows(usize, u32),
    /// A slot, address or bit that does not exist; the slots of the machine, and the words of a slot.
    #[error(
        "fault {0} names no coefficient bit of this machine; accepted: OBJECT below {1}, ADDRESS below {2}, BIT below the width of that word"
    )]
    Fault(Fault, usize, usize),
    /// The machine cannot be compiled.
    #[error(transparent)]
    Design(#[from] DesignError),
    /// A place to trace from that the picture does not have.
    #[error(transparent)]
    TracedPlace(#[from] PlaceError),
    /// A slot to trace that does not exist, and the last one.
    #[error("there is no object {0} to trace; accepted: 0 to {1}")]
    TracedObject(usize, usize),
    /// There is no hardware of the processor of an object, where each runs by itself.
    #[error(
        "object '{0}': the viewer so nearly lies on its quadric that its depth is a quotient with a root in it, for which there is no hardware; \
         move the camera, or draw the scene with --model golden or exact"
    )]
    NoHardware(String),
    /// Widths that processors have in a machine alone.
    #[error(
        "only a beam machine takes --guards and --widths, and it draws 1 to 256 quadrics; \
         give --format, or render with --model golden or exact; \
         a zone machine draws facets with guard bits (imogene machine)"
    )]
    OwnWords,
}

/// The slots that a scene needs, with so many rows of the root network between registers: all of one shape.
pub fn slots_for(scene: &PreparedScene, rows: usize) -> Result<Vec<FittedSlot>, CosimError> {
    let count = scene.objects.len();
    if !(1..=MAX_OBJECTS).contains(&count) {
        return Err(CosimError::Objects(count));
    }
    let words = quadric_words(scene)?;
    let planes = words.iter().map(|w| w.planes.len()).max().unwrap_or(0);
    if planes > MAX_PLANES {
        return Err(CosimError::Planes(planes));
    }
    let limit = scene.format.root_rows();
    if !(1..=limit as usize).contains(&rows) {
        return Err(CosimError::Rows(rows, limit));
    }
    Ok(vec![FittedSlot::quadric(planes as u32); count])
}

/// The words of a scene of quadric processors alone.
fn quadric_words(scene: &PreparedScene) -> Result<Vec<&QuadricWords>, CosimError> {
    fn words(object: &PreparedObject) -> Result<&QuadricWords, CosimError> {
        match object {
            PreparedObject::Quadric(quadric) => Ok(&quadric.words),
            other => Err(CosimError::Processor(other.name().to_owned())),
        }
    }
    scene.objects.iter().map(words).collect()
}

/// The unit that draws a scene in one zone, and the clocks in which it is loaded and draws.
pub fn unit(scene: &PreparedScene, rows: usize) -> Result<(Request, Vec<Inputs>), CosimError> {
    let slots = slots_for(scene, rows)?;
    let [width, height] = [scene.width, scene.height].map(i64::from);
    let (planes, rows) = (slots[0].planes, rows as u32);
    let mut clocks: Vec<Inputs> = vec![];
    for (object, (words, slot)) in (0..).zip(quadric_words(scene)?.into_iter().zip(&slots)) {
        let words = with_planes(words, slot).for_zone(0, 0, width, height);
        let words = load_words(&words, &scene.format, planes as usize).into_iter();
        clocks.extend(words.map(|w| vec![0, 0, 0, 1, object, w.address.into(), w.bits as i64]));
    }
    let latency = i64::from(beam::latency(&slots, &scene.format, rows));
    let scan = |clock| vec![i64::from(clock == 0), width, height, 0, 0, 0, 0];
    clocks.extend((0..width * height + latency).map(scan));
    let request = Request {
        objects: slots.len() as u32,
        planes,
        rows_per_stage: rows,
        root_form: scene.format.root_form,
        ..Request::of(Unit::Beam, scene.format.depth)
    };
    Ok((request, clocks))
}

/// Runs the scene through the hardware in an engine and compares with the golden machine.
///
/// `pixel_done` is called once a pixel, from any thread. Returns the report and the frame that the *hardware* drew.
pub fn run(
    scene: &PreparedScene,
    options: &Options,
    engine: Engine,
    pixel_done: impl Fn() + Sync,
) -> Result<(Report, Frame), CosimError> {
    let rows = options.rows_per_stage;
    let slots = slots_for(scene, rows)?;
    let planes = slots[0].planes as usize;
    check(options, scene, planes, quadric_words(scene)?[0])?;
    let inside = processor_signals(&scene.format, planes, rows);
    let nets = options.trace.as_ref().map_or(&[][..], |trace| &trace.nets);
    let request = MachineRequest::fitted(scene.format.widths(), rows, slots.clone());
    let design = MachineDesign::compile(engine, &request, inside, nets)?;
    let (mut report, frame) = run_on(&design, &slots, scene, options, pixel_done)?;
    report.engine = engine.name().into();
    Ok((report, frame))
}

/// The same through a compiled machine of these slots, in whose words `scene` was prepared.
pub fn run_on(
    design: &Arc<MachineDesign>,
    slots: &[FittedSlot],
    scene: &PreparedScene,
    options: &Options,
    pixel_done: impl Fn() + Sync,
) -> Result<(Report, Frame), CosimError> {
    let started = Instant::now();
    let words = quadric_words(scene)?.into_iter().zip(slots);
    let words = words.map(|(words, slot)| with_planes(words, slot));
    let words: Vec<QuadricWords> = words.collect();
    let latency = beam::latency(slots, &scene.format, options.rows_per_stage as u32);
    let bands = bands(scene, design, &words, latency as usize, options);
    let run = |band: &Band| band::run(band, &pixel_done);
    let parts: Vec<Part> = bands.par_iter().map(run).collect();
    let mut report = Report::default();
    let mut frame = Frame::background(scene.width as usize, 0, scene.format.z_max());
    for (part, lines, trace) in parts {
        report.absorb(part);
        frame.height += lines.height;
        frame.depth.extend(lines.depth);
        frame.id.extend(lines.id);
        frame.number.extend(lines.number);
        frame.normal.extend(lines.normal);
        report.trace = report.trace.or(trace.filter(|trace| !trace.is_empty()));
    }
    report.timed(started.elapsed().as_secs_f64());
    Ok((report, frame))
}

/// The words with as many planes as their slot has.
fn with_planes(words: &QuadricWords, slot: &FittedSlot) -> QuadricWords {
    let mut words = words.clone();
    let planes = slot.planes as usize;
    words.planes.resize(planes, PlaneWords::default());
    words
}

/// The screen in a band for each thread, or fewer: each has a line, and is long enough for the waveforms. `words` are
/// those of each slot, with all its planes; the first pixel comes `latency` clocks after `go`.
fn bands<'a>(
    scene: &'a PreparedScene,
    machine: &'a Arc<MachineDesign>,
    words: &[QuadricWords],
    latency: usize,
    options: &'a Options,
) -> Vec<Band<'a>> {
    let (width, height) = (scene.width as usize, scene.height as usize);
    let most = options.threads;
    let long = options.trace.as_ref().map_or(most, |request| {
        let clocks = request.clocks.max(1) as usize;
        (width * height / clocks).max(most)
    });
    let begin = options.trace.as_ref().map(|request| match request.from {
        // The middle line of the object.
        WindowStart::Usual => {
            let b = &words[options.traced].screen_box;
            Some((0, ((b.y0 + b.y1) / 2).max(0) as usize))
        }
        WindowStart::At(place) => Some((place.column, place.line)),
        WindowStart::Mismatch => None,
    });
    let trace = |first: usize, lines: usize| {
        let begin = begin?;
        // The last band has what begins behind the picture.
        let is_within =
            |(_, line): (usize, usize)| (first..first + lines).contains(&line.min(height - 1));
        begin.is_none_or(is_within).then_some(begin)
    };
    let count = most.min(long).clamp(1, height);
    let band = |k: usize| {
        let first = k * height / count;
        let lines = (k + 1) * height / count - first;
        let zone =
            |words: &QuadricWords| words.for_zone(0, first as i64, width as i64, lines as i64);
        Band {
            scene,
            machine,
            latency,
            objects: words.iter().map(zone).collect(),
            first_line: first,
            lines,
            options,
            trace: trace(first, lines),
        }
    };
    (0..count).map(band).collect()
}

/// Refuses what the machine or the picture does not have. `words` are those of any object, in a slot of so many planes.
fn check(
    options: &Options,
    scene: &PreparedScene,
    planes: usize,
    words: &QuadricWords,
) -> Result<(), CosimError> {
    let objects = scene.objects.len();
    if options.trace.is_some() && options.traced >= objects {
        return Err(CosimError::TracedObject(options.traced, objects - 1));
    }
    if let Some(fault) = options.fault {
        let words = load_words(words, &scene.format, planes);
        let word = words.get(usize::from(fault.address));
        let is_there = word.is_some_and(|word| u32::from(fault.bit) < word.width);
        if usize::from(fault.object) >= objects || !is_there {
            return Err(CosimError::Fault(fault, objects, words.len()));
        }
    }
    if let Some(WindowStart::At(place)) = options.trace.as_ref().map(|request| request.from) {
        if let Some(frame) = place.frame.filter(|frame| *frame > 1) {
            return Err(PlaceError::Frame(frame).into());
        }
        place.check(scene.width as usize, scene.height as usize)?;
    }
    Ok(())
}
