//! Faces of CAD parts: a list of faces on planes, cylinders, cones and spheres becomes quadrics with cut planes.
//!
//! Every face is *exact*, *approximated* with its deviation, or *rejected* with the reason; see `docs/cad-faces.md`.

mod arrangement;
pub mod bezier;
mod build;
mod canonical;
mod cell;
pub mod chart;
mod correct;
pub mod courses;
pub mod cover;
mod curve;
mod curved_face;
mod keys;
mod meetings;
pub mod model;
mod parting;
mod plane_face;
pub mod polynomial;
mod report;
mod rings;
mod scene;
mod slabs;
mod step;
mod surface;
mod task;
pub mod vector;
mod volume;

pub use cell::{Cell, Compilation, Compiled, Planes, Separator, Verdict};
pub use cover::Sample;
pub use curve::{Arc, Curve, Ellipse, PlaneOf, Polyline};
pub use step::Beside;
pub use surface::{Form, Implicit, Surface};
pub use task::Part;

use crate::error::{Error, ImportError, Result, text};
use crate::kit::Imported;
use cell::Made;
use chart::Chart;
use courses::Courses;
use curved_face::{quadric_face, torus_face};
use imogene_files::text::counted;
use model::{Edge, EdgeUse, Face, Model, Solid};
use step21::with_article;
use task::Task;

/// What the user asks of the compiler.
#[derive(Clone, Copy, Debug, Default)]
pub struct FaceOptions {
    /// Largest deviation of an approximated border, scene units; a thousandth of the part's size if there is none.
    pub max_deviation: Option<f64>,
    /// Each face by itself, also where a whole solid is one volume.
    pub no_volumes: bool,
}

/// Share of the part's size that borders may be off by if the user does not say.
const DEFAULT_DEVIATION: f64 = 1e-3;
/// The same of tori: a silhouette shows more than a border.
const DEFAULT_BANDS: f64 = 2e-4;

/// Reads a face list and compiles it to a scene.
pub fn read(bytes: &[u8], file: &str, options: &FaceOptions) -> Result<Imported, ImportError> {
    imported(&compile(bytes, file, options)?, file, &[]).map_err(ImportError::of(file))
}

/// Reads a STEP file and compiles it to a scene; what the file says of itself is the entry `step` of the report.
/// `beside` opens the files of parts that are not in this one.
pub fn read_step(
    bytes: &[u8],
    file: &str,
    options: &FaceOptions,
    beside: Beside,
) -> Result<Imported, ImportError> {
    let refused = ImportError::of(file);
    let (model, summary) = step::build(bytes, beside).map_err(&refused)?;
    let part = compile_model(model, options);
    debug_assert_eq!(summary.placed_faces, part.model.faces.len());
    let mut imported = imported(&part, file, &summary.missing).map_err(&refused)?;
    // What is missing first in one line, then in detail.
    imported.notes.splice(1..1, summary.notes());
    imported.report["step"] = serde_json::to_value(summary).expect("a summary has plain keys");
    Ok(imported)
}

fn imported(part: &Part, file: &str, missing: &[String]) -> Result<Imported> {
    let (report, mut notes) = report::report(part);
    let mut scene = scene::scene(part).ok_or_else(|| {
        let problem = format!("no face can be drawn: {}", notes.join("; "));
        let accepted = "at least one face on a plane, cylinder, cone, sphere or torus is needed";
        Error::whole(problem, accepted)
    })?;
    let parts = (!missing.is_empty()).then(|| counted(missing.len(), "part or placement"));
    let lacks: Vec<String> = report.rejected().into_iter().chain(parts).collect();
    if !lacks.is_empty() {
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
        scene.incomplete = Some(format!("{} of {name} missing", lacks.join(" and ")));
    }
    let valid = scene.validate();
    valid.map_err(|error| Error::whole(error, "another part is needed"))?;
    let too_large = scene::look_from_elsewhere(&mut scene, &part.model);
    if !too_large.is_empty() {
        let names = too_large.join(", ");
        let note = format!("too large for the words of the base format: {names}");
        notes.push(note);
    }
    Ok(Imported {
        scene,
        report: serde_json::to_value(report).expect("a report has plain keys"),
        notes,
    })
}

/// Reads a face list and compiles each of its solids.
pub fn compile(bytes: &[u8], file: &str, options: &FaceOptions) -> Result<Part, ImportError> {
    let list = text(bytes, "a face list is a TOML text in UTF-8");
    let model = list.and_then(build::build).map_err(ImportError::of(file))?;
    Ok(compile_model(model, options))
}

/// Reads a STEP file without others beside it and compiles each of its solids.
pub fn compile_step(bytes: &[u8], file: &str, options: &FaceOptions) -> Result<Part, ImportError> {
    let (model, _) = step::build(bytes, &|_| None).map_err(ImportError::of(file))?;
    Ok(compile_model(model, options))
}

fn compile_model(mut model: Model, options: &FaceOptions) -> Part {
    correct::plain(&mut model);
    correct::orient(&mut model);
    let size = model.size();
    let [asked, bands] = [DEFAULT_DEVIATION, DEFAULT_BANDS]
        .map(|share| options.max_deviation.unwrap_or(share * size));
    let planes = Planes::new(model::COINCIDENT * size);
    // The planes of faces first: an edge that lies in one takes its numbers.
    for (origin, normal) in model.faces.iter().filter_map(|face| face.surface.plane()) {
        planes.find_or_add(origin, normal);
    }
    let courses = Courses::new(&model, &planes, asked, bands);
    let solids = 0..model.solids.len();
    let mut part = Part {
        model,
        planes,
        courses,
        solids: vec![],
    };
    let compiled = |solid| compile_solid(&part, solid, options.no_volumes);
    part.solids = solids.map(compiled).collect();
    part
}

fn compile_solid(part: &Part, solid: usize, no_volumes: bool) -> Compilation {
    let material = |face: usize| part.model.material(solid, face);
    let mut pairs = part.model.solids[solid].faces.windows(2);
    let is_tried = !no_volumes && pairs.all(|pair| material(pair[0]) == material(pair[1]));
    if let Some(Some(cell)) = is_tried.then(|| volume::volume(part, solid)) {
        return Compilation::Volume(cell);
    }
    let compiled = |&index: &usize| {
        let task = Task { part, index };
        let face = task.face();
        let made = match (&face.refused, &face.surface.form) {
            (Some(reason), _) => Err(reason.clone()),
            (_, Form::Plane) => plane_face::plane_face(task),
            (_, Form::Torus(..)) => torus_face(task),
            (_, Form::Other(name)) => Err(format!("{} is no quadric", with_article(name))),
            _ => quadric_face(task),
        };
        made.unwrap_or_else(|reason| Compiled {
            verdict: Verdict::Rejected(reason),
            cells: vec![],
        })
    };
    let faces = part.model.solids[solid].faces.iter();
    Compilation::Faces(faces.map(compiled).collect())
}
