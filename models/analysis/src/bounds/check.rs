//! The check of a whole scene.

use super::jury::Jury;
use super::object::{quantile_999, review};
use super::pixels::Shows;
use super::report::{ObjectBounds, ObjectReport};
use super::summary::{Summary, summary, visible_pixels};
use super::{light, parts};
use imogene_golden::format::Format;
use imogene_golden::object::slot::ProcessorWords;
use imogene_prepare::{NeededWidths, PreparedObject, PreparedScene};
use imogene_scene::{FramedObject, FramedScene, RangeReport};
use serde::Serialize;

/// What a scene needs of a machine, and the bounds that hold for its picture.
#[derive(Clone, Debug, Serialize)]
pub struct CheckReport {
    /// True if every accumulator is wide enough and no outline that is seen may be a pixel or more away from the true
    /// one. Other problems are for a person to judge and do not make a check fail.
    pub ok: bool,
    /// Bounds of the whole picture.
    pub bounds: SceneBounds,
    /// Widths of the format, and those that the scene needs.
    pub widths: Widths,
    /// The range of the depth word: which distances it tells apart, and what a word is.
    pub range: RangeReport,
    /// Pixels of the picture at which rounding could change the visible object or face, or decides between two that
    /// are equally far.
    pub undecided_pixels: usize,
    /// What the scene needs and has, in short.
    pub summary: Summary,
    /// Other pixels at which rounding could change which light sources reach what is seen.
    pub undecided_light_pixels: usize,
    /// For every pixel, row-major, whether object or face is undecided.
    #[serde(skip)]
    pub open: Vec<bool>,
    /// The same of the light.
    #[serde(skip)]
    pub open_light: Vec<bool>,
    /// Objects in the order of the scene.
    pub objects: Vec<ObjectReport>,
}

/// Bounds of the whole picture.
#[derive(Clone, Copy, Debug, Default, Serialize)]
pub struct SceneBounds {
    /// Greatest depth error at any pixel at which an object is present, in depth words.
    pub depth_lsb: f64,
    /// The same in closed form, whatever the pixels: e1 + sqrt(e2) + 1, or the bound of a plane.
    pub depth_lsb_closed_form: f64,
    /// Greatest displacement of a silhouette, in pixels.
    pub silhouette_px: f64,
    /// Greatest angle of a normal whose direction the words determine, in degrees.
    pub normal_deg: f64,
    /// 99.9 % of these normals are within this angle, in degrees.
    pub normal_deg_999: f64,
    /// Pixels whose normal the words do not determine.
    pub normals_undetermined: usize,
}

/// Widths in bits.
#[derive(Clone, Debug, Serialize)]
pub struct Widths {
    /// What the machine has.
    pub format: Format,
    /// What the scene needs: the greatest over its objects.
    pub needed: NeededWidths,
}

impl CheckReport {
    /// A mark for every pixel, row-major: 1 where object or face is undecided, 2 where the light is.
    pub fn marks(&self) -> Vec<u8> {
        let both = self.open.iter().zip(&self.open_light);
        let marks = both.map(|(&open, &light)| u8::from(open) | u8::from(light) << 1);
        marks.collect()
    }
}

/// Checks a prepared scene; `prepared` must come from `scene`.
pub fn check(scene: &FramedScene, prepared: &PreparedScene) -> CheckReport {
    let seen = visible_pixels(prepared);
    let jury = Jury::new(scene, prepared);
    let drawn = scene.objects.iter().zip(&prepared.objects).zip(seen);
    type Drawn<'a> = ((&'a FramedObject, &'a PreparedObject), usize);
    let report = |(id, ((framed, object), visible_pixels)): (usize, Drawn)| {
        let reviewed = match (framed.quadric(), object.quadric()) {
            (Some(framed), Some(quadric)) => review(framed, quadric, prepared, &jury),
            _ => parts::report(framed, object, jury.judge(id), prepared, &jury),
        };
        let (screen_box, pixels) = (*object.screen_box(), reviewed.found.pixels);
        ObjectReport {
            name: object.name().to_owned(),
            kind: reviewed.kind,
            processor: match object.words().first() {
                Some(ProcessorWords::Quotient(_)) => "quotient",
                _ => framed.processor(),
            },
            screen_box,
            pixels,
            visible_pixels,
            shows: Shows::of(&screen_box, pixels, visible_pixels),
            highlights: scene.materials[framed.material()].specular > 0.0,
            undecided: reviewed.found.undecided,
            problems: reviewed.problems,
            detail: reviewed.detail,
        }
    };
    let objects: Vec<ObjectReport> = drawn.enumerate().map(report).collect();
    let bounds = scene_bounds(&objects);
    let held = objects.iter().all(|object| object.undecided.adrift == 0);
    let needed = prepared.needed();
    let format = prepared.format;
    let fits = needed.sum <= format.sum
        && needed.quadratic <= format.quadratic
        && needed.plane <= format.plane
        && objects.iter().all(|o| planes_fit(o, &format));
    let open = jury.undecided();
    let open_light = light::undecided(prepared, &jury);
    CheckReport {
        ok: fits && held,
        bounds,
        widths: Widths { format, needed },
        range: scene.range.report(format.z_max()),
        summary: summary(scene, prepared, &objects),
        undecided_pixels: open.iter().filter(|&&open| open).count(),
        undecided_light_pixels: open_light.iter().filter(|&&open| open).count(),
        open,
        open_light,
        objects,
    }
}

/// For every pixel of the picture, row-major, whether rounding could change the visible object or face
/// ([`Jury::undecided`]).
pub fn undecided_pixels(scene: &FramedScene, prepared: &PreparedScene) -> Vec<bool> {
    Jury::new(scene, prepared).undecided()
}

/// The preparation proves the exact depth of a plane; what the rounded words reach is checked here.
fn planes_fit(object: &ObjectReport, format: &Format) -> bool {
    let accumulators = object.quadric().and_then(|o| o.accumulators.as_ref());
    accumulators.is_none_or(|a| a.planes.iter().all(|&bits| bits <= format.plane))
}

fn scene_bounds(objects: &[ObjectReport]) -> SceneBounds {
    let depth = objects.iter().map(ObjectReport::depth_lsb);
    let quadrics = || objects.iter().filter_map(ObjectReport::quadric);
    let greatest = |of: fn(&ObjectBounds) -> f64| {
        let all = quadrics().map(|report| of(&report.bounds));
        all.fold(0.0, f64::max)
    };
    let angles = quadrics().flat_map(|report| report.angles.iter().copied());
    let undetermined = quadrics().map(|report| report.bounds.normals_undetermined);
    SceneBounds {
        depth_lsb: depth.fold(0.0, f64::max),
        depth_lsb_closed_form: greatest(|b| b.depth_lsb_closed_form),
        silhouette_px: greatest(|b| b.silhouette_px),
        normal_deg: greatest(|b| b.normal_deg),
        normal_deg_999: quantile_999(&mut angles.collect::<Vec<f32>>()),
        normals_undetermined: undetermined.sum(),
    }
}
