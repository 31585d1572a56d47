//! The check of a whole scene.

use super::jury::Jury;
use super::light;
use super::needs::{ExactGuards, MachineNeeds, exact_guards, machine_needs};
use super::object::{review, review_parts};
use super::report::{ObjectBounds, ObjectReport, QuadricReport, Shows};
use crate::metrics::Spread;
use imogene_golden::format::Format;
use imogene_golden::object::slot::ProcessorWords;
use imogene_prepare::{NeededWidths, PreparedScene};
use imogene_scene::{FramedScene, RangeReport};
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
    /// Pixels at which rounding could change the visible object or face, or decides between two equally far.
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
        both.map(|(&open, &light)| u8::from(open) | u8::from(light) << 1)
            .collect()
    }
}

/// Checks a prepared scene; `prepared` must come from `scene`.
pub fn check(scene: &FramedScene, prepared: &PreparedScene) -> CheckReport {
    let jury = Jury::new(scene, prepared);
    let report = |(id, visible_pixels): (usize, usize)| {
        let (framed, object) = (&scene.objects[id], &prepared.objects[id]);
        let reviewed = match (framed.quadric(), object.quadric()) {
            (Some(framed), Some(quadric)) => review(framed, quadric, &jury),
            _ => review_parts(framed, object, jury.judge(id), &jury),
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
    let seen = visible_pixels(prepared).into_iter().enumerate();
    let objects: Vec<ObjectReport> = seen.map(report).collect();
    let needed = prepared.needed();
    let format = prepared.format;
    // The preparation proves the exact depth of a plane; what the rounded words reach is checked here.
    let planes_fit = |object: &ObjectReport| {
        let accumulators = object.quadric().and_then(|o| o.accumulators.as_ref());
        accumulators.is_none_or(|a| a.planes.iter().all(|&bits| bits <= format.plane))
    };
    let fits = needed.sum <= format.sum
        && needed.quadratic <= format.quadratic
        && needed.plane <= format.plane
        && objects.iter().all(planes_fit);
    let open = jury.undecided();
    let open_light = light::undecided(prepared, &jury);
    CheckReport {
        ok: fits && objects.iter().all(|o| o.undecided.adrift == 0),
        bounds: scene_bounds(&objects),
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

/// For every pixel, row-major, whether rounding could change the visible object or face ([`Jury::undecided`]).
pub fn undecided_pixels(scene: &FramedScene, prepared: &PreparedScene) -> Vec<bool> {
    Jury::new(scene, prepared).undecided()
}

fn scene_bounds(objects: &[ObjectReport]) -> SceneBounds {
    let depth = objects.iter().map(ObjectReport::depth_lsb);
    let quadrics = || objects.iter().filter_map(ObjectReport::quadric);
    let greatest = |of: fn(&ObjectBounds) -> f64| {
        let all = quadrics().map(|report| of(&report.bounds));
        all.fold(0.0, f64::max)
    };
    let angles = quadrics().flat_map(|report| report.angles.iter().copied().map(f64::from));
    let undetermined = quadrics().map(|report| report.bounds.normals_undetermined);
    SceneBounds {
        depth_lsb: depth.fold(0.0, f64::max),
        depth_lsb_closed_form: greatest(|b| b.depth_lsb_closed_form),
        silhouette_px: greatest(|b| b.silhouette_px),
        normal_deg: greatest(|b| b.normal_deg),
        normal_deg_999: Spread::of(angles.collect()).quantile_999,
        normals_undetermined: undetermined.sum(),
    }
}

/// The scene in short; objects by their names.
#[derive(Clone, Debug, Serialize)]
pub struct Summary {
    /// The narrowest machine; `None` if there are objects of other processors than quadric and patch.
    pub machine: Option<MachineNeeds>,
    /// Guard bits from which on rounding adds at most a depth word to a quadric's face and leaves no silhouette pixel
    /// open; nothing where none do.
    pub guards: Option<ExactGuards>,
    /// Objects that need the front-view path.
    pub front_view: Vec<String>,
    /// Prisms.
    pub prisms: Vec<String>,
    /// Quadrics that are no curved surface.
    pub degenerate: Vec<String>,
    /// Objects with planes that are half-planes of the screen.
    pub perpendicular_planes: Vec<String>,
    /// Objects with planes that change no pixel.
    pub planes_without_effect: Vec<String>,
    /// Objects that no pixel of the picture shows.
    pub never_shown: Vec<String>,
    /// Objects whose material does not mirror light.
    pub without_highlights: Vec<String>,
}

fn summary(scene: &FramedScene, prepared: &PreparedScene, objects: &[ObjectReport]) -> Summary {
    let all = |is: &dyn Fn(&ObjectReport) -> bool| -> Vec<String> {
        let found = objects.iter().filter(|o| is(o));
        found.map(|o| o.name.clone()).collect()
    };
    let quadrics = |is: fn(&QuadricReport) -> bool| all(&|o| o.quadric().is_some_and(is));
    Summary {
        machine: machine_needs(scene, prepared),
        guards: exact_guards(prepared),
        front_view: quadrics(|o| o.front_view),
        prisms: quadrics(|o| o.prism),
        degenerate: quadrics(|o| o.degenerate),
        perpendicular_planes: quadrics(|o| !o.perpendicular_planes.is_empty()),
        planes_without_effect: quadrics(|o| !o.planes_without_effect.is_empty()),
        never_shown: all(&|o| o.shows != Shows::Visible),
        without_highlights: all(&|o| !o.highlights),
    }
}

/// Pixels of the golden picture that show each object.
fn visible_pixels(prepared: &PreparedScene) -> Vec<usize> {
    let frame = prepared.frame(|| ());
    let mut pixels = vec![0; prepared.objects.len()];
    for id in frame.id.iter().flat_map(|&id| usize::try_from(id)) {
        pixels[id] += 1;
    }
    for layer in &frame.layers {
        let both = layer.depth.iter().zip(&frame.depth);
        pixels[layer.object] = both.filter(|(own, surface)| own < surface).count();
    }
    pixels
}
