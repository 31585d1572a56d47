//! Bands, parts of a surface between two parallels, and those of cones for a torus, which meet in circles of it.
//!
//! The bands are the same for all faces of one torus, and at quarters of a turn for all tori with one radius of the
//! tube. A circle about the tube becomes the chords of the bands for the plane face beside it.

use super::vector::{Vector, dot, minus, range};
use super::{Chart, Curve, Face, Form, Implicit, Model, Surface};
use std::f64::consts::{FRAC_PI_2, TAU};

/// Share of its height by which a band goes on under or over the next, so that the rounding of both leaves no pixel to
/// neither. Out there a chord is a twelfth of the deviation off.
pub const OVERLAP: f64 = 0.02;

/// A part of the surface between two parallels, drawn as one quadric.
pub struct Band {
    /// Its quadric; nothing on a plane.
    pub quadric: Option<Implicit>,
    /// Least and greatest v.
    pub ends: [f64; 2],
    /// Share of its height by which it goes on beyond the border of its face, within the deviation.
    pub beyond: f64,
}

impl Band {
    pub fn whole(surface: &Surface) -> Vec<Band> {
        vec![Band {
            quadric: surface.implicit(),
            ends: [f64::NEG_INFINITY, f64::INFINITY],
            beyond: 0.0,
        }]
    }
}

/// Most bands of a quarter of the tube.
const MAX_BANDS: f64 = 1e5;
/// Most bands of one torus.
pub const MOST: usize = 1000;
/// Angles nearer than this are one, radians.
const SAME_ANGLE: f64 = 1e-7;

/// The bands of a torus, by the angles between them.
pub struct Rings {
    /// Ascending, from 0 up to a whole turn, the first again at the end.
    angles: Vec<f64>,
    /// Greatest angle of a band; what is wider between two angles is reached by no face.
    step: f64,
    /// How far the cones are inside the torus, scene units.
    pub deviation: f64,
}

impl Rings {
    /// Within a deviation; edges that are parallels of the torus are between bands.
    pub fn of(model: &Model, surface: &Surface, max_deviation: f64) -> Option<Rings> {
        let Form::Torus(_, minor) = surface.form else {
            return None;
        };
        // Half the angle of a chord of this sagitta.
        let half = (1.0 - (max_deviation / minor).min(0.25)).acos();
        let count = (0.5 * FRAC_PI_2 / half).ceil().clamp(1.0, MAX_BANDS);
        let step = FRAC_PI_2 / count;
        let (edges, ranges) = reached(model, surface, &Chart::of(surface, None));
        let ends = |k: &usize| [*k as f64 * step, (*k + 1) as f64 * step];
        let is_reached = |k: &usize| {
            let [low, high] = ends(k);
            let turn = |from: f64| ((from - high) / TAU).ceil() * TAU;
            ranges.iter().any(|[from, to]| low + turn(*from) <= *to)
        };
        let wanted: Vec<usize> = (0..4 * count as usize).filter(is_reached).collect();
        if wanted.len() > MOST {
            return None;
        }
        // A whole turn is none.
        let turned = |v: f64| if v >= TAU - SAME_ANGLE { 0.0 } else { v };
        let mut angles: Vec<f64> = wanted.iter().flat_map(ends).map(turned).collect();
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|next, kept| *next - *kept <= SAME_ANGLE);
        for v in edges {
            let off = |angle: &f64| {
                let off = (angle - v).rem_euclid(TAU);
                off.min(TAU - off)
            };
            if angles.iter().all(|angle| off(angle) > SAME_ANGLE) {
                angles.push(v.rem_euclid(TAU));
            }
        }
        angles.sort_by(f64::total_cmp);
        angles.push(angles[0] + TAU);
        Some(Rings {
            angles,
            step,
            deviation: minor * (1.0 - (0.5 * step).cos()),
        })
    }

    pub fn bands(&self, chart: &Chart) -> Vec<Band> {
        let band = |pair: &[f64]| {
            let [(out, up), (other, higher)] = [pair[0], pair[1]].map(|v| chart.meridian(v));
            Some(Band {
                quadric: Some(chart.chord(pair[0], pair[1])?.implicit()?),
                ends: [pair[0], pair[1]],
                beyond: OVERLAP.min(0.5 * self.deviation / (other - out).hypot(higher - up)),
            })
        };
        let pairs = self.angles.windows(2);
        let narrow = pairs.filter(|pair| pair[1] - pair[0] <= self.step + SAME_ANGLE);
        narrow.filter_map(band).collect()
    }
}

/// The angles of edges that are parallels of a torus, and all that its faces reach over.
fn reached(model: &Model, surface: &Surface, chart: &Chart) -> (Vec<f64>, Vec<[f64; 2]>) {
    let same = |face: &&Face| face.surface.same(surface, model.rounding());
    let (mut parallels, mut ranges) = (vec![], vec![]);
    for face in model.faces.iter().filter(same) {
        if face.loops.is_empty() {
            ranges.push([0.0, TAU]);
        }
        for edge_use in face.loops.iter().flatten() {
            let path = chart.path(&model.edges[edge_use.edge].curve.sampled(32));
            let range = range(path.iter().map(|[_, v]| *v));
            if range[1] - range[0] <= SAME_ANGLE {
                parallels.push(path[0][1]);
            }
            ranges.push(range);
        }
    }
    // A face goes from the lowest to the highest of its borders only if these, or a seam, join them.
    if ranges.iter().all(|[low, high]| high - low <= SAME_ANGLE) {
        ranges.push([0.0, TAU]);
    }
    (parallels, ranges)
}

/// The chords of an edge about the tube of a torus, from its start to its end; nothing for other edges.
pub fn chords(model: &Model, edge: usize, max_deviation: f64) -> Option<(Vec<Curve>, f64)> {
    let curve = &model.edges[edge].curve;
    let Curve::Arc(arc) = curve else { return None };
    let of_torus = |face: &usize| {
        let surface = &model.faces[*face].surface;
        let Form::Torus(_, minor) = surface.form else {
            return None;
        };
        let (ellipse, off) = (&arc.ellipse, model.rounding());
        let about = ellipse.radii.iter().all(|r| (r - minor).abs() <= off);
        (about && dot(ellipse.normal, surface.axis).abs() <= 1e-9).then_some(surface)
    };
    let surface = model.users[edge].iter().find_map(of_torus)?;
    let rings = Rings::of(model, surface, max_deviation)?;
    let chart = Chart::of(surface, None);
    let path = chart.path(&curve.sampled(96));
    let first = path[0];
    // A circle about the tube is one line u = constant.
    if path.iter().any(|[u, _]| (u - first[0]).abs() > 1e-6) {
        return None;
    }
    let (from, to) = (first[1], path[path.len() - 1][1]);
    let (low, high) = (from.min(to) + SAME_ANGLE, from.max(to) - SAME_ANGLE);
    let turns = [-TAU, 0.0, TAU].into_iter();
    let turned = turns.flat_map(|turn| rings.angles[1..].iter().map(move |v| v + turn));
    let mut inner: Vec<f64> = turned.filter(|v| *v > low && *v < high).collect();
    inner.sort_by(f64::total_cmp);
    if to < from {
        inner.reverse();
    }
    let angles = [vec![from], inner, vec![to]].concat();
    let mut points: Vec<Vector> = angles.iter().map(|v| chart.point(first[0], *v)).collect();
    let last = points.len() - 1;
    [points[0], points[last]] = curve.ends();
    let pairs = points.windows(2).map(|pair| (pair[0], pair[1]));
    let lines = pairs.filter(|(from, to)| minus(*from, *to) != [0.0; 3]);
    let lines = lines.map(|(from, to)| Curve::Line { from, to });
    Some((lines.collect(), rings.deviation))
}
