//! Faces of CAD parts: a list of faces on planes, cylinders, cones and spheres becomes quadrics with cut planes.
//!
//! Every face is reported *exact*, *approximated* with its deviation, or *rejected* with the reason.
//! `docs/cad-faces.md` is the user's page.

mod arc;
mod arrangement;
mod assemble;
mod bezier;
mod build;
mod build_edge;
mod build_surface;
mod canonical;
mod chart;
mod compile;
mod conics;
mod courses;
mod cover;
mod curve;
mod gap;
mod generators;
mod keys;
pub mod model;
mod orient;
mod plain;
mod plane_face;
mod planes;
mod polynomial;
mod report;
mod scene;
mod sheet;
mod slabs;
mod step;
mod surface;
mod terms;
mod torus;
pub mod vector;
mod volume;
mod words;

pub use compile::{Cell, Compiled, Verdict};
pub use curve::Curve;
pub use planes::{Planes, SharedPlane};
pub use scene::Compilation;
pub use step::Beside;
pub use surface::{Implicit, Surface};

use crate::{ImportError, Imported, Place};
use courses::Courses;
use imogene_studies::text::counted;
use model::Model;
use words::with_article;

/// What the user asks of the compiler.
#[derive(Clone, Copy, Debug, Default)]
pub struct FaceOptions {
    /// Largest deviation of an approximated border, scene units; a thousandth of the part's size if there is none.
    pub max_deviation: Option<f64>,
    /// Each face by itself, also where a whole solid is one volume.
    pub no_volumes: bool,
}

/// A part with all its solids compiled.
pub struct Part {
    /// The checked list.
    pub model: Model,
    /// The planes that cells refer to.
    pub planes: Planes,
    /// Each solid.
    pub solids: Vec<Compilation>,
    courses: Courses,
}

/// Share of the part's size that borders may be off by if the user does not say.
pub const DEFAULT_DEVIATION: f64 = 1e-3;
/// The same of tori: a silhouette shows more than a border.
pub const DEFAULT_BANDS: f64 = 2e-4;

/// Reads a face list and compiles it to a scene.
pub fn read(bytes: &[u8], file: &str, options: &FaceOptions) -> Result<Imported, ImportError> {
    imported(&compile(bytes, file, options)?, file, &[])
}

/// Reads a STEP file and compiles it to a scene; what the file says of itself is the entry `step` of the report.
/// `beside` opens the files of parts that are not in this one.
pub fn read_step(
    bytes: &[u8],
    file: &str,
    options: &FaceOptions,
    beside: Beside,
) -> Result<Imported, ImportError> {
    let (model, summary) = step::build(bytes, file, beside)?;
    let part = compile_model(model, options);
    debug_assert_eq!(summary.placed_faces, part.model.faces.len());
    let mut imported = imported(&part, file, &summary.missing)?;
    // What is missing first in one line, then in detail.
    imported.notes.splice(1..1, summary.notes());
    imported.report["step"] = serde_json::to_value(summary).expect("a summary has plain keys");
    Ok(imported)
}

fn imported(part: &Part, file: &str, missing: &[String]) -> Result<Imported, ImportError> {
    let (report, mut notes) = report::report(&part.model, &part.courses, &part.solids);
    let scene = scene::scene(&part.model, &part.planes, &part.solids);
    let unusable = |problem: String, accepted: &str| ImportError::Unusable {
        file: file.to_owned(),
        problem,
        accepted: accepted.to_owned(),
    };
    let mut scene = scene.ok_or_else(|| {
        unusable(
            format!("no face can be drawn: {}", notes.join("; ")),
            "at least one face on a plane, cylinder, cone, sphere or torus is needed",
        )
    })?;
    let parts = match missing.len() {
        0 => None,
        count => Some(counted(count, "part or placement")),
    };
    let lacks: Vec<String> = report.rejected().into_iter().chain(parts).collect();
    if !lacks.is_empty() {
        let name = file.rsplit(['/', '\\']).next().unwrap_or(file);
        scene.incomplete = Some(format!("{} of {name} missing", lacks.join(" and ")));
    }
    scene
        .validate()
        .map_err(|error| unusable(error.to_string(), "another part is needed"))?;
    let too_large = scene::look_from_elsewhere(&mut scene, &part.model);
    if !too_large.is_empty() {
        notes.push(format!(
            "too large for the words of the base format: {}",
            too_large.join(", ")
        ));
    }
    Ok(Imported {
        scene,
        report: serde_json::to_value(report).expect("a report has plain keys"),
        notes,
    })
}

/// Reads a face list and compiles each of its solids.
pub fn compile(bytes: &[u8], file: &str, options: &FaceOptions) -> Result<Part, ImportError> {
    let text = std::str::from_utf8(bytes).map_err(|error| {
        let before = &bytes[..error.valid_up_to()];
        let line = before.iter().filter(|b| **b == b'\n').count() + 1;
        let start = before
            .iter()
            .rposition(|b| *b == b'\n')
            .map_or(0, |p| p + 1);
        ImportError::Malformed {
            file: file.to_owned(),
            place: Place {
                line,
                column: String::from_utf8_lossy(&before[start..]).chars().count() + 1,
            },
            problem: "this byte is no UTF-8 text".into(),
            accepted: "a face list is a TOML text in UTF-8".into(),
        }
    })?;
    let model = build::build(&build::Source { file, text })?;
    Ok(compile_model(model, options))
}

/// Reads a STEP file without others beside it and compiles each of its solids.
pub fn compile_step(bytes: &[u8], file: &str, options: &FaceOptions) -> Result<Part, ImportError> {
    let (model, _) = step::build(bytes, file, &|_| None)?;
    Ok(compile_model(model, options))
}

fn compile_model(mut model: Model, options: &FaceOptions) -> Part {
    plain::plain(&mut model);
    orient::orient(&mut model);
    let asked = options
        .max_deviation
        .unwrap_or(DEFAULT_DEVIATION * model.size());
    let bands = options
        .max_deviation
        .unwrap_or(DEFAULT_BANDS * model.size());
    let mut planes = Planes::new(model::COINCIDENT * model.size());
    // The planes of faces first: an edge that lies in one takes its numbers.
    for face in &model.faces {
        if let Surface::Plane { origin, normal } = face.surface {
            planes.find_or_add(origin, normal);
        }
    }
    let courses = Courses::new(&model, &mut planes, asked, bands);
    let solids = (0..model.solids.len())
        .map(|solid| compile_solid(&model, solid, &courses, &mut planes, options))
        .collect();
    Part {
        model,
        planes,
        solids,
        courses,
    }
}

fn compile_solid(
    model: &Model,
    solid: usize,
    courses: &Courses,
    planes: &mut Planes,
    options: &FaceOptions,
) -> Compilation {
    if !options.no_volumes
        && model.one_material(solid)
        && let Some(cell) = volume::volume(model, solid, courses, planes)
    {
        return Compilation::Volume(cell);
    }
    let faces = model.solids[solid]
        .faces
        .iter()
        .map(|face| match &model.faces[*face].surface {
            _ if model.faces[*face].refused.is_some() => {
                Compiled::rejected(model.faces[*face].refused.clone().unwrap_or_default())
            }
            Surface::Plane { .. } => plane_face::plane_face(model, *face, courses, planes),
            Surface::Torus { .. } => torus::torus_face(model, *face, courses, planes),
            Surface::Other(name) => {
                Compiled::rejected(format!("{} is no quadric", with_article(name)))
            }
            _ => compile::quadric_face(model, *face, courses, planes),
        });
    Compilation::Faces(faces.collect())
}
