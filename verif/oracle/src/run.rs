//! One scene from its file to the comparison of golden and traced picture.

use crate::bounds::Bounds;
use crate::compare::{Comparison, Mark, compare};
use crate::trace::Tracer;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_prepare::{Framing, PreparedScene, prepare};
use imogene_scene::{FramedScene, SceneError, SceneFile};
use std::time::Instant;

/// What came of a scene.
pub enum Outcome {
    /// The preparation refuses it, with this reason: there is no golden picture.
    Refused(String),
    /// Both pictures were drawn.
    Compared(Box<Compared>),
}

/// Both pictures of a scene.
pub struct Compared {
    /// What was found.
    pub comparison: Comparison,
    /// The golden picture.
    pub golden: Frame,
    /// What each pixel is, row-major.
    pub marks: Vec<Mark>,
    /// Seconds of the tracer.
    pub trace_seconds: f64,
    /// The scene as it was framed, and its words.
    pub scene: (FramedScene, PreparedScene),
}

/// Draws a scene by the golden model and by the tracer, and compares; `progress` gets the number of steps, once for
/// each of them.
///
/// # Errors
///
/// When the scene cannot be framed, such as at a size that is out of range.
pub fn run(
    scene: &SceneFile,
    width: u32,
    height: u32,
    format: Format,
    progress: &(impl Fn(u64) + Sync),
) -> Result<Outcome, SceneError> {
    let framed = scene.frame(width, height)?;
    let prepared = match prepare(&framed, format) {
        Ok(prepared) => prepared,
        Err(reason) => return Ok(Outcome::Refused(reason.to_string())),
    };
    let started = Instant::now();
    let tracer = Tracer::new(scene, &framed.range, width, height);
    let steps = tracer.steps();
    let traced = tracer.draw(|| progress(steps));
    let trace_seconds = started.elapsed().as_secs_f64();
    let bounds = match Bounds::new(&framed, &prepared, tracer.bodies()) {
        Ok(bounds) => bounds,
        Err(reason) => return Ok(Outcome::Refused(reason.to_string())),
    };
    let (columns, lines) = (width as usize, height as usize);
    let golden = beam::render(&prepared.slots(), &format, columns, lines, || ());
    let (comparison, marks) = compare(&tracer, &traced, &golden, &bounds, &prepared);
    Ok(Outcome::Compared(Box::new(Compared {
        comparison,
        golden,
        marks,
        trace_seconds,
        scene: (framed, prepared),
    })))
}
