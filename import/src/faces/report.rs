//! Counts and verdicts of a compiled part.

use super::cell::{Compilation, Verdict};
use super::courses::Courses;
use super::curve::Curve;
use super::model::Model;
use super::surface::Form;
use imogene_files::text::counted;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// The report of an import; its keys are stable.
#[derive(Debug, Serialize)]
pub struct Report {
    solids: usize,
    max_deviation: f64,
    faces: Vec<FaceReport>,
    /// By kind of surface.
    counts: BTreeMap<String, Counts>,
    total: Counts,
    /// Number of faces by the number of different planes that bound them; faces that are drawn one by one.
    planes_per_face: BTreeMap<usize, usize>,
    /// Number of objects by the number of their cuts, the two planes of a flat face among them.
    cuts_per_object: BTreeMap<usize, usize>,
    edges: EdgeCounts,
}

#[derive(Debug, Serialize)]
struct FaceReport {
    name: String,
    solid: String,
    surface: String,
    verdict: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    deviation: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
    /// `volume`: the whole solid is one object; `patch`; `flat`: a solid without thickness.
    #[serde(skip_serializing_if = "Option::is_none")]
    form: Option<&'static str>,
    objects: usize,
    planes: usize,
    edges: usize,
}

#[derive(Clone, Copy, Debug, Default, Serialize)]
struct Counts {
    exact: usize,
    approximated: usize,
    rejected: usize,
}

/// Edges by what they are.
#[derive(Debug, Default, Serialize)]
struct EdgeCounts {
    total: usize,
    straight: usize,
    planar: usize,
    /// In no plane.
    spatial: usize,
    /// Planar pieces of those that were taken apart.
    pieces: usize,
}

/// The report of a part and its lines for a person.
pub fn report(model: &Model, courses: &Courses, solids: &[Compilation]) -> (Report, Vec<String>) {
    let mut report = Report {
        solids: model.solids.len(),
        max_deviation: courses.max_deviation,
        faces: vec![],
        counts: BTreeMap::new(),
        total: Counts::default(),
        planes_per_face: BTreeMap::new(),
        cuts_per_object: BTreeMap::new(),
        edges: edges(model, courses),
    };
    for (index, compilation) in solids.iter().enumerate() {
        report.solid(model, index, compilation);
    }
    let notes = notes(&report);
    (report, notes)
}

impl Report {
    fn solid(&mut self, model: &Model, index: usize, compilation: &Compilation) {
        let solid = &model.solids[index];
        if let Compilation::Volume(cell) = compilation {
            *self.cuts_per_object.entry(cell.cuts.len()).or_default() += 1;
        }
        for (position, face) in solid.faces.iter().enumerate() {
            let face = &model.faces[*face];
            let (form, verdict, cells) = match compilation {
                Compilation::Volume(_) => ("volume", &Verdict::Exact, &[][..]),
                Compilation::Faces(faces) => {
                    let form = match face.surface.form {
                        Form::Plane => "flat",
                        _ => "patch",
                    };
                    (form, &faces[position].verdict, &faces[position].cells[..])
                }
            };
            let planes = cells.iter().flat_map(|cell| &cell.cuts);
            let planes: BTreeSet<usize> = planes.map(|(plane, _)| *plane).collect();
            let surface = face.surface.name();
            let counts = self.counts.entry(surface.to_owned()).or_default();
            let (verdict, deviation, reason) = match verdict {
                Verdict::Exact => ("exact", None, None),
                Verdict::Approximated(off) => ("approximated", Some(*off), None),
                Verdict::Rejected(reason) => ("rejected", None, Some(reason.clone())),
            };
            for counts in [counts, &mut self.total] {
                match verdict {
                    "exact" => counts.exact += 1,
                    "approximated" => counts.approximated += 1,
                    _ => counts.rejected += 1,
                }
            }
            if form != "volume" && reason.is_none() {
                *self.planes_per_face.entry(planes.len()).or_default() += 1;
            }
            for cell in cells {
                let cuts = cell.cuts.len() + if cell.flat.is_some() { 2 } else { 0 };
                *self.cuts_per_object.entry(cuts).or_default() += 1;
            }
            let line = FaceReport {
                name: face.name.clone(),
                solid: solid.name.clone(),
                surface: surface.to_owned(),
                verdict,
                deviation,
                form: reason.is_none().then_some(form),
                reason,
                objects: cells.len(),
                planes: planes.len(),
                edges: face.loops.iter().flatten().count(),
            };
            self.faces.push(line);
        }
    }
}

fn edges(model: &Model, courses: &Courses) -> EdgeCounts {
    let mut counts = EdgeCounts::default();
    for (index, edge) in model.edges.iter().enumerate() {
        counts.total += 1;
        match (&edge.curve, edge.curve.plane()) {
            (Curve::Line { .. }, _) => counts.straight += 1,
            (_, Some(_)) => counts.planar += 1,
            (_, None) => {
                counts.spatial += 1;
                counts.pieces += courses.of(index).map_or(0, |course| course.pieces.len());
            }
        }
    }
    counts
}

/// Most names that a line for a person has.
const MOST_NAMES: usize = 4;

/// The summary first, then what is rejected by its reasons, and the worst of what is approximated.
fn notes(report: &Report) -> Vec<String> {
    let Counts {
        exact,
        approximated,
        rejected,
    } = report.total;
    let mut notes = vec![format!(
        "{} of {}: {exact} exact, {approximated} approximated, {rejected} rejected",
        counted(report.faces.len(), "face"),
        counted(report.solids, "solid")
    )];
    let mut reasons: Vec<(&FaceReport, String, Vec<&str>, bool)> = vec![];
    for face in &report.faces {
        let Some(reason) = &face.reason else { continue };
        let kind = without_numbers(reason);
        match reasons
            .iter_mut()
            .find(|(first, known, ..)| first.surface == face.surface && *known == kind)
        {
            Some((first, _, names, same)) => {
                names.push(&face.name);
                *same &= first.reason == face.reason;
            }
            None => reasons.push((face, kind, vec![&face.name], true)),
        }
    }
    for (first, kind, names, same) in &reasons {
        let surface = &first.surface;
        let reason = first.reason.as_deref().unwrap_or_default();
        notes.push(match &names[..] {
            [name] => format!("face `{name}` ({surface}): rejected, {reason}"),
            names => format!(
                "{} ({surface}): rejected, {}: {}",
                counted(names.len(), "face"),
                if *same { reason } else { kind },
                listed(names)
            ),
        });
    }
    let deviations = report.faces.iter().filter_map(|f| Some((f.deviation?, f)));
    if let Some((off, face)) = deviations.max_by(|a, b| a.0.total_cmp(&b.0)) {
        notes.push(format!(
            "{approximated} approximated: face `{}` ({}) is off by at most {off:.3e}, the others by no more",
            face.name, face.surface
        ));
    }
    notes
}

/// A reason with `...` for the numbers and names of its own face.
fn without_numbers(reason: &str) -> String {
    let own = |word: &str| word.contains(|c: char| c == '#' || c.is_ascii_digit());
    let shown = |word| if own(word) { "..." } else { word };
    reason.split(' ').map(shown).collect::<Vec<_>>().join(" ")
}

/// The first of some names, and how many more there are.
fn listed(names: &[&str]) -> String {
    let first = names.iter().take(MOST_NAMES);
    let first: Vec<String> = first.map(|name| format!("`{name}`")).collect();
    match names.len().saturating_sub(MOST_NAMES) {
        0 => first.join(", "),
        more => format!("{} and {more} more", first.join(", ")),
    }
}

impl Report {
    /// What is not drawn, by kinds of surfaces; `None` if all is.
    pub fn rejected(&self) -> Option<String> {
        let some = self.counts.iter().filter(|(_, counts)| counts.rejected > 0);
        let kind = |(kind, counts): (&String, &Counts)| format!("{} {kind}", counts.rejected);
        let kinds: Vec<String> = some.map(kind).collect();
        let (rejected, all) = (self.total.rejected, counted(self.faces.len(), "face"));
        (!kinds.is_empty()).then(|| format!("{rejected} of {all} ({})", kinds.join(", ")))
    }
}
