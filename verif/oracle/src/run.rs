//! One scene from its file to the comparison of golden and traced picture.

use crate::bounds::Bounds;
use crate::colour::Colours;
use crate::compare::{Comparison, Mark, Painted, Pair, Pictures, compare};
use crate::trace::{Traced, Tracer};
use imogene_analysis::bounds::Jury;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::machine::shader::shade_picture;
use imogene_golden::object::slot::Slot;
use imogene_prepare::error::PrepareError;
use imogene_prepare::shader::{material_numbers, shader_words};
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

/// Draws a scene by golden model and tracer, and compares; each step tells `progress` how many there are.
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
    let traced = trace(scene, &framed, progress);
    let trace_seconds = started.elapsed().as_secs_f64();
    let mut pictures = match pictures(traced, scene, &framed, &prepared) {
        Ok(pictures) => pictures,
        Err(reason) => return Ok(Outcome::Refused(reason.to_string())),
    };
    let (comparison, marks) = compare(&pictures);
    let golden = pictures.pairs.swap_remove(0).golden;
    drop(pictures);
    Ok(Outcome::Compared(Box::new(Compared {
        comparison,
        golden,
        marks,
        trace_seconds,
        scene: (framed, prepared),
    })))
}

/// A tracer and what it has drawn: what nothing is seen through, then each transparent object alone.
pub type Drawn = (Tracer, Vec<Traced>);

/// Traces a scene in the size of its frame.
pub fn trace(scene: &SceneFile, framed: &FramedScene, progress: &(impl Fn(u64) + Sync)) -> Drawn {
    let tracer = Tracer::new(scene, &framed.range, framed.width, framed.height);
    let steps = tracer.steps();
    let mut all = vec![tracer.draw(|| progress(steps))];
    all.extend(tracer.glass.iter().map(|id| tracer.draw_alone(*id)));
    (tracer, all)
}

/// Golden pictures beside the traced ones.
///
/// # Errors
///
/// When the bounds of an object cannot be had.
pub fn pictures<'a>(
    (tracer, traced): Drawn,
    scene: &SceneFile,
    framed: &FramedScene,
    prepared: &'a PreparedScene,
) -> Result<Pictures<'a>, PrepareError> {
    let mut traced = traced.into_iter();
    let opaque = traced.next().map(|traced| Pair {
        traced,
        jury: Jury::of_words(prepared),
        golden: prepared.frame(|| ()),
    });
    let glass = traced.zip(&tracer.glass);
    let glass = glass.map(|(traced, &object)| alone(prepared, object as usize, traced));
    let pairs: Vec<Pair> = opaque.into_iter().chain(glass).collect();
    let golden = &pairs[0].golden;
    // What the shading processor cannot hold has no golden colours.
    let words = shader_words(framed, &prepared.format).ok();
    let colours = Colours::new(scene, &tracer.sight).zip(words);
    let painted = colours.map(|(colours, words)| Painted {
        golden: shade_picture(
            golden,
            &Lighting::full(golden),
            &material_numbers(framed),
            &words,
        ),
        colours,
    });
    Ok(Pictures {
        bounds: Bounds::new(framed, prepared, &tracer.bodies)?,
        painted,
        tracer,
        pairs,
    })
}

/// The golden picture of some slots of a scene.
pub(crate) fn drawn(prepared: &PreparedScene, slots: &[Slot]) -> Frame {
    let [columns, lines] = [prepared.width, prepared.height].map(|pixels| pixels as usize);
    beam::render(slots, &prepared.format, columns, lines, || ())
}

/// A transparent object alone, and as if it were opaque, so that the golden frame says which faces it shows.
fn alone(prepared: &PreparedScene, object: usize, traced: Traced) -> Pair<'_> {
    let own = prepared.layers.iter().filter(|slot| slot.object == object);
    let opaque = own.map(|slot| Slot {
        weight: None,
        ..slot.clone()
    });
    Pair {
        traced,
        golden: drawn(prepared, &opaque.collect::<Vec<Slot>>()),
        jury: Jury::of_words_alone(prepared, object),
    }
}
