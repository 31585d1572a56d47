//! Counts and verdicts of a compiled part.

use super::courses::Courses;
use super::task::Part;
use super::{Compilation, Curve, Model, Verdict};
use imogene_files::text::counted;
use indexmap::IndexMap;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// The report of an import; its keys are stable.
#[derive(Debug, Default, Serialize)]
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

pub fn report(part: &Part) -> (Report, Vec<String>) {
    let Part { model, courses, .. } = part;
    let mut report = Report {
        solids: model.solids.len(),
        max_deviation: courses.max_deviation,
        edges: edges(model, courses),
        ..Report::default()
    };
    for (index, compilation) in part.solids.iter().enumerate() {
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
                    let own = &faces[position];
                    let is_plane = face.surface.is_plane();
                    let form = if is_plane { "flat" } else { "patch" };
                    (form, &own.verdict, &own.cells[..])
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
            self.faces.push(FaceReport {
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
            });
        }
    }

    /// What is not drawn, by kinds of surfaces; `None` if all is.
    pub fn rejected(&self) -> Option<String> {
        let some = self.counts.iter().filter(|(_, counts)| counts.rejected > 0);
        let kind = |(kind, counts): (&String, &Counts)| format!("{} {kind}", counts.rejected);
        let kinds: Vec<String> = some.map(kind).collect();
        let (rejected, all) = (self.total.rejected, counted(self.faces.len(), "face"));
        (!kinds.is_empty()).then(|| format!("{rejected} of {all} ({})", kinds.join(", ")))
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

const MOST_NAMES: usize = 4;

/// The summary first, then what is rejected by its reasons, and the worst of what is approximated.
fn notes(report: &Report) -> Vec<String> {
    let total = &report.total;
    let mut notes = vec![format!(
        "{} of {}: {} exact, {} approximated, {} rejected",
        counted(report.faces.len(), "face"),
        counted(report.solids, "solid"),
        total.exact,
        total.approximated,
        total.rejected
    )];
    let mut reasons: IndexMap<(&str, String), Vec<(&str, &str)>> = IndexMap::new();
    for face in &report.faces {
        if let Some(reason) = &face.reason {
            let kind = (face.surface.as_str(), without_numbers(reason));
            reasons.entry(kind).or_default().push((&face.name, reason));
        }
    }
    for ((surface, kind), faces) in &reasons {
        let (first, reason) = faces[0];
        if faces.len() == 1 {
            notes.push(format!("face `{first}` ({surface}): rejected, {reason}"));
            continue;
        }
        let same = faces.iter().all(|(_, other)| *other == reason);
        notes.push(format!(
            "{} ({surface}): rejected, {}: {}",
            counted(faces.len(), "face"),
            if same { reason } else { kind },
            listed(faces)
        ));
    }
    let deviations = report.faces.iter().filter_map(|f| Some((f.deviation?, f)));
    if let Some((off, face)) = deviations.max_by(|a, b| a.0.total_cmp(&b.0)) {
        notes.push(format!(
            "{} approximated: face `{}` ({}) is off by at most {off:.3e}, the others by no more",
            total.approximated, face.name, face.surface
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

/// The names of the first of some faces, and how many more there are.
fn listed(faces: &[(&str, &str)]) -> String {
    let first = faces.iter().take(MOST_NAMES);
    let first: Vec<String> = first.map(|(name, _)| format!("`{name}`")).collect();
    match faces.len().saturating_sub(MOST_NAMES) {
        0 => first.join(", "),
        more => format!("{} and {more} more", first.join(", ")),
    }
}
