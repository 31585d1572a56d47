//! Curves of edges (ISO 10303-42, clause 4.4), cut at their vertices.

use super::placement::{Placement, conic, line};
use super::spline::Spline;
use super::units::Context;
use crate::faces::build::MISSED;
use crate::faces::model::COINCIDENT;
use crate::faces::vector::*;
use crate::faces::{Arc, Curve, Ellipse, PlaneOf, Polyline};
use step21::{Args, Entity, Result, with_article};

/// Most curves that are defined by each other.
const LONGEST_CHAIN: usize = 8;
/// Steps of a hyperbola or parabola.
const CONIC_STEPS: usize = 64;
/// Steps of a spline: four to a piece.
const SPLINE_STEPS: std::ops::RangeInclusive<usize> = 48..=256;

/// The course of an edge, or why it has none.
pub type Found = Result<Curve, String>;

/// An edge between its vertices, in the space of its representation, millimetres.
#[derive(Clone, Copy, Debug)]
pub struct Span<'a> {
    pub context: &'a Context,
    pub ends: [Vector; 2],
    /// Both are one vertex.
    pub closed: bool,
    /// The edge runs as its curve does.
    pub forward: bool,
}

impl<'a> Span<'a> {
    /// The part of a curve between the ends.
    pub fn of(mut self, mut entity: Entity<'a>) -> Found {
        for _ in 0..LONGEST_CHAIN {
            let on_surface = ["SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"];
            if let Some(args) = entity.find(&on_surface) {
                entity = args.entity(1)?;
            } else if let Some(args) = entity.find(&["TRIMMED_CURVE"]) {
                self.forward ^= !args.flag(4)?;
                entity = args.entity(1)?;
            } else if Spline::is_one(entity) {
                return self.spline(entity);
            } else if let Some(args) = entity.find(&["LINE"]) {
                return self.line(&args);
            } else if let Some(args) = entity.find(&["CIRCLE", "ELLIPSE"]) {
                return self.ellipse(&args);
            } else if let Some(args) = entity.find(&["HYPERBOLA", "PARABOLA"]) {
                return self.open_conic(&args);
            } else {
                let names = entity.name();
                if !names.contains("CURVE") && !names.contains("POLYLINE") {
                    entity.need(&["LINE", "CIRCLE", "ELLIPSE", "curve"])?;
                    return Err(names);
                }
                return Err(format!("{} is not read", with_article(&names)));
            }
        }
        let (id, name) = (entity.id, entity.name());
        let problem = format!("`#{id}` {name}: it is defined by itself, or by too many others");
        let accepted = format!("at most {LONGEST_CHAIN} curves defined by each other are possible");
        Err(entity.error(problem, accepted).into())
    }

    /// How far an end may miss a curve of this size, by its digits and the file's uncertainty, and its least length.
    fn tolerance(&self, size: f64) -> [f64; 2] {
        let [from, to] = self.ends;
        let numbers = COINCIDENT * length(from).max(length(to)).max(size);
        let missed = MISSED * size.max(self.context.extent);
        [missed.max(self.context.uncertainty).max(numbers), numbers]
    }

    fn line(&self, args: &Args<'a>) -> Found {
        let (origin, course) = line(args, self.context)?;
        let [from, to] = self.ends;
        let [missed, shortest] = self.tolerance(distance(from, to));
        if distance(from, to) <= shortest {
            return Err("it is straight and has no length".into());
        }
        let off = |p: Vector| length(across(minus(p, origin), course));
        on_curve(off(from).max(off(to)), missed)?;
        Ok(Curve::Line { from, to })
    }

    fn ellipse(&self, args: &Args<'a>) -> Found {
        let (place, [first, second]) = conic(args, self.context)?;
        let [x, _, z] = place.axes;
        let normal = if self.forward { z } else { opposite(z) };
        let towards = across(minus(self.ends[0], place.origin), normal);
        let is_off = args.record.name == "CIRCLE" && length(towards) > COINCIDENT * first;
        let x = if is_off { unit(towards) } else { x };
        let ellipse = Ellipse::new(place.origin, normal, x, [first, second]);
        let tolerance = self.tolerance(first.max(second));
        let arc = ellipse.arc(Some(self.ends), self.closed, tolerance);
        arc.map_err(|(problem, _)| problem)
    }

    /// A hyperbola or a parabola: points on it, evenly in its parameter.
    fn open_conic(&self, args: &Args<'a>) -> Found {
        let (place, [first, second]) = conic(args, self.context)?;
        let hyperbola = args.record.name == "HYPERBOLA";
        let at = |t: f64| {
            let (x, y) = if hyperbola {
                (first * t.cosh(), second * t.sinh())
            } else {
                (first * t * t, 2.0 * first * t)
            };
            place.point([x, y, 0.0])
        };
        let parameter = |p: Vector| {
            let y = dot(minus(p, place.origin), place.axes[1]);
            match hyperbola {
                true => (y / second).asinh(),
                false => y / (2.0 * first),
            }
        };
        let [from, to] = self.ends.map(parameter);
        let [missed, _] = self.tolerance(distance(self.ends[0], self.ends[1]));
        let [off, other] = [0, 1].map(|k| distance(at([from, to][k]), self.ends[k]));
        on_curve(off.max(other), missed)?;
        let step = |k: usize| from + (to - from) * k as f64 / CONIC_STEPS as f64;
        self.through((0..=CONIC_STEPS).map(|k| at(step(k))).collect(), false)
    }

    fn spline(&self, entity: Entity) -> Found {
        let spline = Spline::read(entity, self.context)?;
        let [low, high] = spline.domain();
        let [(start, off), (end, other)] = self.ends.map(|p| spline.nearest(p));
        // How far the curve goes from the start of the edge.
        let place = |k| spline.at(low + (high - low) * f64::from(k) / 32.0);
        let [missed, _] = self.tolerance(reach((0..=32).map(place), self.ends[0]));
        on_curve(off.max(other), missed)?;
        let comes_back = distance(spline.at(low), spline.at(high)) <= missed;
        let (mut from, mut to) = match self.forward {
            true => (start, end),
            false => (end, start),
        };
        if self.closed || to <= from {
            if !comes_back {
                return Err("its spline does not run from its start to its end".into());
            }
            // Both ends of the parameter are one place.
            if from >= high {
                from = low;
            }
            if to <= from {
                to += high - low;
            }
            if self.closed {
                to = from + (high - low);
            }
        }
        let steps = (4 * spline.pieces()).clamp(*SPLINE_STEPS.start(), *SPLINE_STEPS.end());
        let place = |k: usize| {
            let u = from + (to - from) * k as f64 / steps as f64;
            if u > high { u - (high - low) } else { u }
        };
        let mut points: Vec<Vector> = (0..=steps).map(|k| spline.at(place(k))).collect();
        if self.closed {
            points.pop();
        }
        if !self.forward {
            points.reverse();
            // A closed one still begins at its vertex.
            if self.closed {
                points.rotate_right(1);
            }
        }
        self.through(points, self.closed)
    }

    /// The curve through points, of which those that repeat the one before are left out.
    fn through(&self, mut points: Vec<Vector>, closed: bool) -> Found {
        let size = reach(points.iter().copied(), points[0]);
        let [_, least] = self.tolerance(size);
        if !closed {
            let last = points.len() - 1;
            points[0] = self.ends[0];
            points[last] = self.ends[1];
        }
        points.dedup_by(|next, kept| distance(*next, *kept) <= least);
        let is_short = points.len() < if closed { 3 } else { 2 };
        if is_short || points.iter().flatten().any(|v| !v.is_finite()) {
            return Err("it has no length".into());
        }
        Ok(Curve::through(points, closed, COINCIDENT * size))
    }
}

/// Refuses ends that are farther off their curve than they may be.
fn on_curve(off: f64, missed: f64) -> Result<(), String> {
    match off > missed {
        true => Err(format!("an end is {off:e} off the curve")),
        false => Ok(()),
    }
}

pub fn placed(curve: Curve, place: &Placement) -> Curve {
    let turned = |(p, n): PlaneOf| (place.point(p), place.direction(n));
    match curve {
        Curve::Line { from, to } => Curve::Line {
            from: place.point(from),
            to: place.point(to),
        },
        Curve::Arc(arc) => Curve::Arc(Arc {
            ellipse: Ellipse {
                centre: place.point(arc.ellipse.centre),
                normal: place.direction(arc.ellipse.normal),
                x: place.direction(arc.ellipse.x),
                ..arc.ellipse
            },
            ..arc
        }),
        Curve::Points(line) => Curve::Points(Polyline {
            points: line.points.iter().map(|p| place.point(*p)).collect(),
            plane: line.plane.map(turned),
            ..line
        }),
    }
}
