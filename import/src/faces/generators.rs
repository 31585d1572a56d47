//! Straight lines of cylinders and cones as edges: one plane through two of them bounds a sector of any angle.

use super::model::Model;
use super::planes::Planes;
use super::surface::{Form, Surface};
use super::vector::{Vector, across, cross, dot, length, minus, unit};
use std::collections::HashMap;

/// The plane of each generator, by face and edge.
pub type Generators = HashMap<(usize, usize), usize>;

/// A generator of a face.
struct Line {
    edge: usize,
    /// From the axis to the line, length 1, across the axis.
    out: Vector,
    point: Vector,
    direction: Vector,
}

/// Pairs the generators of a face in the order of their angles; an odd one is paired with the first.
pub fn pair_generators(model: &Model, face: usize, planes: &mut Planes, found: &mut Generators) {
    let surface = &model.faces[face].surface;
    if !matches!(surface.form, Form::Cylinder(_) | Form::Cone(_)) {
        return;
    }
    let axis = surface.axis;
    let lines = lines(model, face);
    let distinct = distinct(&lines, axis);
    let mut plane_of = vec![None; distinct.len()];
    for first in (0..distinct.len()).step_by(2) {
        let a = &lines[distinct[first][0]];
        let second = (first + 1) % distinct.len();
        let normal = if second == first {
            // Alone: the plane through the axis.
            cross(axis, a.out)
        } else {
            common_normal(surface, a, &lines[distinct[second][0]])
        };
        // A straight edge on the axis is no generator, and has no plane.
        let plane = (length(normal) > 0.0).then(|| planes.find_or_add(a.point, unit(normal)));
        plane_of[first] = plane;
        if second > first {
            plane_of[second] = plane;
        }
    }
    for (group, plane) in distinct.iter().zip(plane_of) {
        let edges = group.iter().map(|line| (face, lines[*line].edge));
        found.extend(edges.filter_map(|edge| Some((edge, plane?))));
    }
}

fn lines(model: &Model, face: usize) -> Vec<Line> {
    let Surface { origin, axis, .. } = model.faces[face].surface;
    let mut lines = vec![];
    for edge_use in model.faces[face].border() {
        let edge = &model.edges[edge_use.edge];
        if !matches!(edge.curve, super::curve::Curve::Line { .. }) {
            continue;
        }
        let [from, to] = edge.curve.ends();
        let outs = [from, to].map(|p| across(minus(p, origin), axis));
        let far = usize::from(length(outs[0]) < length(outs[1]));
        lines.push(Line {
            edge: edge_use.edge,
            out: unit(outs[far]),
            point: [from, to][far],
            direction: unit(minus(to, from)),
        });
    }
    lines
}

/// Lines that are one and the same generator, in groups, by their angle.
fn distinct(lines: &[Line], axis: Vector) -> Vec<Vec<usize>> {
    let Some(first) = lines.first() else {
        return vec![];
    };
    let side = cross(axis, first.out);
    let angle = |k: usize| {
        let angle = dot(lines[k].out, side).atan2(dot(lines[k].out, first.out));
        super::vector::positive_angle(angle + 1e-9)
    };
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by(|i, j| angle(*i).total_cmp(&angle(*j)));
    let mut groups: Vec<Vec<usize>> = vec![];
    for k in order {
        match groups.last_mut() {
            Some(group) if angle(k) - angle(group[0]) <= 1e-8 => group.push(k),
            _ => groups.push(vec![k]),
        }
    }
    groups
}

fn common_normal(surface: &Surface, a: &Line, b: &Line) -> Vector {
    if surface.is_cone() {
        cross(a.direction, b.direction)
    } else {
        cross(surface.axis, minus(b.point, a.point))
    }
}
