//! A whole solid as one volume: a quadric, its inside or its outside, cut by the planes of the plane faces.
//!
//! The form is proven: on every surface of the solid the AND of all half-spaces keeps the faces and nothing else.

use super::arrangement::{EDGE, Parting};
use super::model::{COINCIDENT, border};
use super::task::{Part, Task};
use super::vector::{Vector, distance, dot, minus};
use super::{Cell, Curve, Model, Separator, Surface};
use imogene_scene::MAX_CUTS;

/// The half-spaces of a solid, and the surface of its quadric.
#[derive(Default)]
struct Body {
    surface: Option<Surface>,
    cell: Cell,
}

/// The one cell that is the whole solid, if there is one.
pub fn volume(part: &Part, solid: usize) -> Option<Cell> {
    let Part { model, planes, .. } = part;
    let faces = &model.solids[solid].faces;
    let exact = |&index: &usize| {
        let deviation = Task { part, index }.deviation();
        deviation.is_ok_and(|off| off <= model.rounding())
    };
    if faces.is_empty() || !faces.iter().all(exact) {
        return None;
    }
    let mut body = body(part, faces)?;
    if proven(part, faces, &body) {
        return Some(body.cell);
    }
    // A cone goes on beyond its apex unless something keeps its other nappe off.
    let Surface { origin, axis, .. } = *body.surface.as_ref().filter(|own| own.is_cone())?;
    let nappes = planes.find_or_add(origin, axis);
    let positive = dot(planes.get(nappes).1, axis) > 0.0;
    body.cell.cuts.push((nappes, positive));
    (body.cell.cuts.len() <= MAX_CUTS && proven(part, faces, &body)).then_some(body.cell)
}

fn body(part: &Part, faces: &[usize]) -> Option<Body> {
    let Part { model, planes, .. } = part;
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
        let [a, b] = [known, implicit].map(|q| q.value(model.middle()) > 0.0);
        if !surface.same(&face.surface, COINCIDENT * model.size()) || a != b {
            return None;
        }
    }
    (cuts.len() <= MAX_CUTS).then_some(body)
}

/// Whether the AND of all half-spaces keeps of every surface exactly its faces.
fn proven(part: &Part, faces: &[usize], body: &Body) -> bool {
    let Part { model, planes, .. } = part;
    let is_flat = |face: &&usize| model.faces[**face].surface.is_plane();
    let (flat, curved): (Vec<usize>, Vec<usize>) = faces.iter().partition(is_flat);
    let on_quadric = curved.is_empty() || keeps(part, &curved, body, None);
    let on_cut = |(index, (plane, _)): (usize, &(usize, bool))| {
        let (point, normal) = planes.get(*plane);
        let is_on = |face: &&usize| {
            let Surface { origin, axis, .. } = model.faces[**face].surface;
            let off = dot(minus(origin, point), normal).abs();
            dot(axis, normal).abs() > 1.0 - 1e-12 && off <= COINCIDENT * model.size()
        };
        let own: Vec<usize> = flat.iter().filter(is_on).copied().collect();
        // The plane between the nappes of a cone has no face of its own.
        own.is_empty() || keeps(part, &own, body, Some(index))
    };
    on_quadric && body.cell.cuts.iter().enumerate().all(on_cut)
}

/// The same on one surface: that of cut number `cut`, or of the quadric.
fn keeps(part: &Part, faces: &[usize], body: &Body, cut: Option<usize>) -> bool {
    let Part { model, planes, .. } = part;
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
