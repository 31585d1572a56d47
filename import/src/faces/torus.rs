//! Faces on a torus: the cells of its bands of cones.

use super::cell::{Compiled, Made};
use super::chart::Chart;
use super::compile::Task;
use super::planes::Planes;
use super::rings::{MOST, Rings};

/// Compiles a face that lies on a torus.
pub fn torus_face(task: Task, planes: &mut Planes) -> Made<Compiled> {
    if task.courses.max_deviation == 0.0 {
        return Err("a torus is not exact, and a deviation of 0 is accepted".into());
    }
    let (surface, most) = (&task.face().surface, task.courses.bands);
    let rings = Rings::of(task.model, surface, most).zip(Chart::of(surface, None));
    let (rings, chart) = rings
        .ok_or_else(|| format!("more than {MOST} bands would be needed to be within {most:.3e}"))?;
    let off = task.deviation()?;
    let parting = task.parting(planes)?;
    let cells = task.slabs(&parting, &rings.bands(&chart), None, planes);
    task.compiled(cells, off.max(rings.deviation))
}
