//! A whole solid as one volume: a quadric, its inside or its outside, cut by the planes of the plane faces.
//!
//! The form is not guessed but proven: on every surface of the solid the pieces that the AND of all half-spaces keeps
//! are the faces.

use super::cell::{Cell, Planes, Separator};
use super::courses::Courses;
use super::curve::Curve;
use super::model::{COINCIDENT, Model, border};
use super::parting::{EDGE, Parting};
use super::surface::Surface;
use super::task::Task;
use super::vector::{Vector, distance, dot, minus};
use imogene_scene::MAX_CUTS;

/// The half-spaces of a solid, and the surface of its quadric.
#[derive(Default)]
struct Body {
    surface: Option<Surface>,
    cell: Cell,
}

/// The one cell that is the whole solid, if there is one.
pub fn volume(model: &Model, solid: usize, courses: &Courses, planes: &Planes) -> Option<Cell> {
    let faces = &model.solids[solid].faces;
    let exact = |index: &usize| {
        let task = Task {
            model,
            courses,
            planes,
            index: *index,
        };
        task.deviation().is_ok_and(|off| off <= model.rounding())
    };
    if faces.is_empty() || !faces.iter().all(exact) {
        return None;
    }
    let mut body = body(model, faces, planes)?;
    if proven(model, faces, &body, planes) {
        return Some(body.cell);
    }
    // A cone goes on beyond its apex unless something keeps its other nappe off.
    let Surface { origin, axis, .. } = *body.surface.as_ref().filter(|own| own.is_cone())?;
    let nappes = planes.find_or_add(origin, axis);
    let positive = dot(planes.get(nappes).1, axis) > 0.0;
    body.cell.cuts.push((nappes, positive));
    let fits = body.cell.cuts.len() <= MAX_CUTS;
    (fits && proven(model, faces, &body, planes)).then_some(body.cell)
}

fn body(model: &Model, faces: &[usize], planes: &Planes) -> Option<Body> {
    let mut body = Body::default();
    let cuts = &mut body.cell.cuts;
    for face in faces.iter().map(|face| &model.faces[*face]) {
        if let Some((origin, normal)) = face.surface.plane() {
            let index = planes.find_or_add(origin, normal);
            let outwards = dot(planes.get(index).1, normal) > 0.0;
            let kept = (index, outwards == face.reversed);
            if cuts.contains(&(index, !kept.1)) {
                return None;
            }
            if !cuts.contains(&kept) {
                cuts.push(kept);
            }
            continue;
        }
        let implicit = face.surface.implicit()?.kept(face.reversed);
        let known = *body.cell.quadric.get_or_insert(implicit);
        let surface = body.surface.get_or_insert_with(|| face.surface.clone());
        let same = surface.same(&face.surface, COINCIDENT * model.size());
        let [a, b] = [known, implicit].map(|q| q.value(model.middle()) > 0.0);
        if !same || a != b {
            return None;
        }
    }
    (cuts.len() <= MAX_CUTS).then_some(body)
}

/// Whether the AND of all half-spaces keeps of every surface exactly its faces.
fn proven(model: &Model, faces: &[usize], body: &Body, planes: &Planes) -> bool {
    let is_flat = |face: &&usize| model.faces[**face].surface.is_plane();
    let (flat, curved): (Vec<usize>, Vec<usize>) = faces.iter().partition(is_flat);
    let on_quadric = curved.is_empty() || keeps(model, &curved, body, None, planes);
    let on_cut = |(index, (plane, _)): (usize, &(usize, bool))| {
        let (point, normal) = planes.get(*plane);
        let is_on = |face: &&usize| {
            let Surface { origin, axis, .. } = model.faces[**face].surface;
            let off = dot(minus(origin, point), normal).abs();
            let along = dot(axis, normal).abs() > 1.0 - 1e-12;
            along && off <= COINCIDENT * model.size()
        };
        let own: Vec<usize> = flat.iter().filter(is_on).copied().collect();
        // The plane between the nappes of a cone has no face of its own.
        own.is_empty() || keeps(model, &own, body, Some(index), planes)
    };
    on_quadric && body.cell.cuts.iter().enumerate().all(on_cut)
}

/// The same on one surface: that of cut number `cut`, or of the quadric.
fn keeps(model: &Model, faces: &[usize], body: &Body, cut: Option<usize>, planes: &Planes) -> bool {
    let surface = &model.faces[faces[0]].surface;
    let mut parting = Parting::default();
    let mut wanted: u128 = 0;
    for (index, (plane, positive)) in body.cell.cuts.iter().enumerate() {
        if Some(index) != cut {
            let separator = parting.push(planes.separator(*plane), Some(*plane), EDGE);
            wanted |= u128::from(*positive) << separator;
        }
    }
    let quadric = body.cell.quadric.filter(|_| cut.is_some());
    if let Some(quadric) = quadric {
        parting.quadric(quadric);
    }
    let loops = faces.iter().flat_map(|face| &model.faces[*face].loops);
    for edge_use in border(loops.flatten().copied()) {
        let curve = model.edges[edge_use.edge].curve.clone();
        let Some(separator) = carrier(model, &curve, &parting.separators, body) else {
            return false;
        };
        parting.border(separator, curve, edge_use.forward);
    }
    let samples = parting.samples(surface, model.size());
    samples.is_ok_and(|all| all.iter().all(|own| (own.sides == wanted) == own.inside))
}

/// The separator on which a curve lies.
fn carrier(model: &Model, curve: &Curve, separators: &[Separator], body: &Body) -> Option<usize> {
    let tolerance = COINCIDENT * model.size();
    let points = curve.sampled(16);
    let off = |separator: &Separator, p: Vector| match separator {
        Separator::Plane((normal, offset)) => Some((dot(*normal, p) - offset).abs()),
        Separator::Quadric(_) => Some(distance(p, body.surface.as_ref()?.nearest(p)?)),
    };
    let is_on = |own: &Separator, p: &Vector| off(own, *p).is_some_and(|off| off <= tolerance);
    let mut all = separators.iter();
    all.position(|own| points.iter().all(|p| is_on(own, p)))
}
