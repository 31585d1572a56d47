//! Co-simulation of a whole scene: a beam machine against the golden machine, every output on every clock.
//!
//! The screen is cut into bands, one for each thread; each band is a zone of its own with its own coefficients, as in a
//! machine with several graphics modules (source: 2.4.4).

mod band;
pub mod fitted;
pub(crate) mod golden;
mod request;
pub mod slots;
pub mod volumes;
pub mod zone;

use crate::engine::beam::BeamDesign;
use crate::engine::{Engine, MachineOutputs, MachineShape};
use crate::report::Report;
use crate::signal::Signal;
pub use request::{CosimError, Fault, MAX_OBJECTS, Options, WaveformRequest, WindowStart};

use band::{Band, Part};
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::load::load_words;
use imogene_golden::object::quadric::{MAX_PLANES, PlaneWords, QuadricWords};
use imogene_golden::object::words::Words;
use imogene_prepare::{PreparedObject, PreparedScene};
use request::middle_line;
use std::time::Instant;

/// The machine that a scene needs.
pub fn shape_of(scene: &PreparedScene, rows_per_stage: usize) -> Result<MachineShape, CosimError> {
    let count = scene.objects.len();
    if !(1..=MAX_OBJECTS).contains(&count) {
        return Err(CosimError::Objects { count });
    }
    let words = quadric_words(scene)?;
    let planes = words.iter().map(|w| w.planes.len()).max().unwrap_or(0);
    if planes > MAX_PLANES {
        return Err(CosimError::Planes { count: planes });
    }
    let limit = scene.format.root_rows();
    if !(1..=limit as usize).contains(&rows_per_stage) {
        return Err(CosimError::Rows {
            value: rows_per_stage,
            limit,
        });
    }
    Ok(MachineShape {
        format: scene.format,
        objects: count,
        planes,
        rows_per_stage,
    })
}

/// The words of a scene of quadric processors alone.
fn quadric_words(scene: &PreparedScene) -> Result<Vec<&QuadricWords>, CosimError> {
    fn words(object: &PreparedObject) -> Result<&QuadricWords, CosimError> {
        match object {
            PreparedObject::Quadric(quadric) => Ok(&quadric.words),
            other => Err(CosimError::Processor {
                object: other.name().to_owned(),
            }),
        }
    }
    scene.objects.iter().map(words).collect()
}

/// Latency in clocks from `go` to the first pixel of a machine.
pub fn latency(scene: &PreparedScene, shape: &MachineShape) -> u32 {
    use imogene_golden::machine::decider;
    use imogene_golden::object::quadric;
    1 + quadric::latency(&scene.format, shape.planes, shape.rows_per_stage as u32)
        + decider::latency(shape.objects)
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
    let shape = shape_of(scene, options.rows_per_stage)?;
    let all_words = quadric_words(scene)?;
    check_requests(options, &shape, all_words[0])?;
    check_window(options, scene)?;
    // Every slot has the same chain; planes that an object does not use are of kind none.
    let planes = vec![shape.planes; all_words.len()];
    let bands = Bands {
        scene,
        words: fitted_to(&all_words, &planes),
        outputs: MachineOutputs::signals(&scene.format.widths()),
        latency: latency(scene, &shape) as usize,
        options,
    };
    let design = BeamDesign::compile(engine, &shape)?;
    let (mut report, frame) = bands.run(&design, pixel_done);
    report.engine = engine.name().into();
    Ok((report, frame))
}

/// The words with as many planes as each slot has.
fn fitted_to(words: &[&QuadricWords], planes: &[usize]) -> Vec<QuadricWords> {
    let one = |(words, &planes): (&&QuadricWords, &usize)| {
        let mut words = (*words).clone();
        words.planes.resize(planes, PlaneWords::default());
        words
    };
    words.iter().zip(planes).map(one).collect()
}

/// A machine over the whole screen, cut into bands.
struct Bands<'a> {
    scene: &'a PreparedScene,
    words: Vec<QuadricWords>,
    outputs: Vec<Signal>,
    latency: usize,
    options: &'a Options,
}

impl Bands<'_> {
    /// Runs every band on a machine of its own; the report counts the clocks of all bands, each with its latency.
    fn run(&self, design: &BeamDesign, pixel_done: impl Fn() + Sync) -> (Report, Frame) {
        let started = Instant::now();
        let bands = self.cut(self.options.threads);
        let parts: Vec<Part> = std::thread::scope(|scope| {
            let pixel_done = &pixel_done;
            let run =
                |band| scope.spawn(move || band::run(band, &mut design.machine(), pixel_done));
            let handles: Vec<_> = bands.iter().map(run).collect();
            let join = |handle: std::thread::ScopedJoinHandle<'_, _>| {
                handle
                    .join()
                    .unwrap_or_else(|panic| std::panic::resume_unwind(panic))
            };
            handles.into_iter().map(join).collect()
        });
        let mut report = Report::default();
        let width = self.scene.width as usize;
        let mut frame = Frame::background(width, 0, self.scene.format.z_max());
        for (part, lines, trace) in parts {
            report.absorb(part);
            append(&mut frame, lines);
            report.trace = report.trace.or(trace.filter(|trace| !trace.is_empty()));
        }
        report.timed(started.elapsed().as_secs_f64());
        (report, frame)
    }

    /// The screen in so many bands, or fewer: each with a line at least, and long enough for the waveforms asked for.
    fn cut(&self, most: usize) -> Vec<Band<'_>> {
        let Bands { scene, options, .. } = *self;
        let (width, height) = (scene.width as usize, scene.height as usize);
        let long = options.trace.as_ref().map_or(most, |request| {
            let clocks = request.clocks.max(1) as usize;
            (width * height / clocks).max(options.threads)
        });
        let parts = split(height, most.min(long));
        let begin = options
            .trace
            .as_ref()
            .map(|request| request.begin(|| middle_line(&self.words[request.object])));
        let is_traced = |first: usize, lines: usize| match begin {
            // The last band has what begins behind the picture.
            Some(Some((_, line))) => (first..first + lines).contains(&line.min(height - 1)),
            Some(None) => true,
            None => false,
        };
        let band = |(first, lines): (usize, usize)| {
            let zone =
                |words: &QuadricWords| words.for_zone(0, first as i64, width as i64, lines as i64);
            Band {
                scene,
                outputs: self.outputs.clone(),
                latency: self.latency,
                objects: self.words.iter().map(zone).collect(),
                first_line: first,
                lines,
                fault: options.fault,
                trace: options.trace.as_ref().filter(|_| is_traced(first, lines)),
            }
        };
        parts.into_iter().map(band).collect()
    }
}

fn check_window(options: &Options, scene: &PreparedScene) -> Result<(), CosimError> {
    let (width, height) = (scene.width as usize, scene.height as usize);
    match options.trace.as_ref().map(|request| request.from) {
        Some(WindowStart::Pixel(column, line)) if column >= width || line >= height => {
            Err(CosimError::TracedPixel {
                column,
                line,
                width,
                height,
            })
        }
        _ => Ok(()),
    }
}

/// `words` are those of any object.
fn check_requests(
    options: &Options,
    shape: &MachineShape,
    words: &QuadricWords,
) -> Result<(), CosimError> {
    if let Some(request) = &options.trace
        && request.object >= shape.objects
    {
        return Err(CosimError::TracedObject {
            object: request.object,
            objects: shape.objects,
        });
    }
    if let Some(f) = options.fault {
        let words = load_words(words, &shape.format, shape.planes);
        let word = words.get(usize::from(f.address));
        let is_there = word.is_some_and(|word| u32::from(f.bit) < word.width);
        if usize::from(f.object) >= shape.objects || !is_there {
            return Err(CosimError::Fault {
                object: f.object,
                address: f.address,
                bit: f.bit,
                objects: shape.objects,
                addresses: words.len(),
            });
        }
    }
    Ok(())
}

/// First line and number of lines of each band.
fn split(height: usize, bands: usize) -> Vec<(usize, usize)> {
    let bands = bands.clamp(1, height);
    (0..bands)
        .map(|k| {
            let first = k * height / bands;
            (first, (k + 1) * height / bands - first)
        })
        .collect()
}

fn append(frame: &mut Frame, lines: Frame) {
    frame.height += lines.height;
    frame.depth.extend(lines.depth);
    frame.id.extend(lines.id);
    frame.number.extend(lines.number);
    frame.normal.extend(lines.normal);
}
