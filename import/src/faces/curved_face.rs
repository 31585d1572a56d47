//! Faces on quadrics and tori.

use super::arrangement::Parting;
use super::cover::Term;
use super::model::COINCIDENT;
use super::parting::terms;
use super::rings::{Band, MOST, Rings};
use super::slabs;
use super::task::{Part, Task};
use super::vector::*;
use super::{Cell, Chart, Compiled, Curve, EdgeUse, Made, PlaneOf};
use imogene_scene::MAX_CUTS;

pub fn quadric_face(task: Task) -> Made<Compiled> {
    let surface = &task.face().surface;
    let none = || format!("a {} is no quadric", surface.name());
    let implicit = surface.implicit().ok_or_else(none)?;
    let deviation = task.deviation()?;
    let border = task.parting()?;
    let mut parting = border.clone();
    parting.split(&task.part.planes, &between_loops(task));
    let cell = |parting: &Parting, term: &Term| Cell {
        quadric: Some(implicit),
        flat: None,
        cuts: parting.cuts(term),
    };
    let cells = match terms(task, &mut parting, MAX_CUTS) {
        Ok(terms) => Ok(terms.iter().map(|term| cell(&parting, term)).collect()),
        Err(_) => slabs::cells(task, &border, &Band::whole(surface), None),
    };
    task.compiled(cells, deviation)
}

pub fn torus_face(task: Task) -> Made<Compiled> {
    let Part { model, courses, .. } = task.part;
    if courses.max_deviation == 0.0 {
        return Err("a torus is not exact, and a deviation of 0 is accepted".into());
    }
    let (surface, most) = (&task.face().surface, courses.bands);
    let rings = Rings::of(model, surface, most)
        .ok_or_else(|| format!("more than {MOST} bands would be needed to be within {most:.3e}"))?;
    let off = task.deviation()?;
    let bands = rings.bands(&Chart::of(surface, None));
    let cells = slabs::cells(task, &task.parting()?, &bands, None);
    task.compiled(cells, off.max(rings.deviation))
}

/// Planes halfway between loops with edges that are taken apart: the bounds of one have nothing to do with the other.
fn between_loops(task: Task) -> Vec<PlaneOf> {
    let model = &task.part.model;
    let spatial = |own: &EdgeUse| matches!(&model.edges[own.edge].curve, Curve::Points(line) if line.plane.is_none());
    let loops = task.face().loops.iter();
    let own = loops.filter(|own| own.iter().any(spatial));
    let middles: Vec<Vector> = own.map(|own| mean(&model.places(own, 16))).collect();
    let mut planes = vec![];
    for (index, p) in middles.iter().enumerate().take(8) {
        for q in middles[index + 1..].iter().take(8) {
            let apart = minus(*q, *p);
            if length(apart) > COINCIDENT * model.size() {
                planes.push((times(0.5, plus(*p, *q)), unit(apart)));
            }
        }
    }
    planes
}
