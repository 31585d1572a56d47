//! Edges from their words.

use super::curve::{Curve, Ellipse, Tolerance};
use super::keys::{EdgeKeys, Source};
use super::model::{COINCIDENT, Edge};
use super::vector::{Vector, across, distance, frame, hull, length, minus, reach, unit};
use crate::{ImportError, Result};
use std::collections::{BTreeMap, HashMap};
use toml::Spanned;

/// Share of the size of the curve by which an end may miss its circle: the digits of a list written with six decimals.
pub const MISSED: f64 = 1e-5;
const MAX_POINTS: usize = 2000;

/// Kinds of edges with the keys that they have.
const KINDS: [(&str, &[&str]); 4] = [
    ("line", &[]),
    ("circle", &["centre", "axis", "radius"]),
    ("ellipse", &["centre", "axis", "x", "radii"]),
    ("points", &["points"]),
];

/// Names and places of the vertices.
pub struct Vertices {
    index: HashMap<String, usize>,
    points: Vec<Vector>,
    /// Size of the box around them, for tolerances.
    size: f64,
}

impl Vertices {
    pub fn of(source: &Source, keys: &BTreeMap<String, Spanned<Vector>>) -> Result<Vertices> {
        let points = keys.values().map(|p| source.point(p));
        let points: Vec<Vector> = points.collect::<Result<_>>()?;
        Ok(Vertices {
            index: keys.keys().cloned().zip(0..).collect(),
            size: hull(&points).map_or(0.0, |[low, high]| distance(low, high)),
            points,
        })
    }

    fn find(&self, source: &Source, name: &Spanned<String>) -> Result<usize> {
        self.index.get(name.as_ref()).copied().ok_or_else(|| {
            let problem = format!("`{}` is not a vertex of this list", name.as_ref());
            let accepted = "the name of an entry of `[vertices]` is needed";
            source.error(name, problem, accepted)
        })
    }
}

pub struct EdgeBuilder<'a> {
    pub source: &'a Source<'a>,
    pub keys: &'a EdgeKeys,
    pub vertices: &'a Vertices,
}

fn needed<T>(value: &Option<T>) -> &T {
    value.as_ref().expect("keys of the kind are checked")
}

impl EdgeBuilder<'_> {
    pub fn edge(&self) -> Result<Edge> {
        let vertices = self.vertices()?;
        let kind = self.keys.kind.as_ref();
        let Some((kind, allowed)) = KINDS.iter().find(|(name, _)| name == kind) else {
            let problem = format!("`{kind}` is not a kind of edge");
            let accepted = "line, circle, ellipse and points are possible";
            return Err(self.source.error(&self.keys.kind, problem, accepted));
        };
        for (key, is) in self.keys.given() {
            if is && !allowed.contains(&key) {
                let problem = format!("`{key}` is no key of kind \"{kind}\"");
                return Err(self.error(problem, "only the keys of its kind are possible"));
            }
            if !is && allowed.contains(&key) {
                let problem = format!("kind \"{kind}\" needs `{key}`");
                return Err(self.error(problem, "this key is needed"));
            }
        }
        let ends = vertices.map(|ends| ends.map(|index| self.vertices.points[index]));
        let one_vertex = vertices.is_some_and(|[a, b]| a == b);
        let curve = match *kind {
            "line" => self.line(ends)?,
            "points" => self.points(ends)?,
            _ => {
                let ellipse = self.ellipse(ends)?;
                let tolerance = Tolerance {
                    missed: MISSED * ellipse.radii[0].max(ellipse.radii[1]),
                    shortest: 1e-7 * self.vertices.size,
                };
                let arc = ellipse.arc(ends, one_vertex, tolerance);
                arc.map_err(|(problem, accepted)| self.error(problem, accepted))?
            }
        };
        Ok(Edge {
            name: self.keys.name.as_ref().clone(),
            vertices,
            curve,
            off: 0.0,
        })
    }

    fn error(&self, problem: impl std::fmt::Display, accepted: &str) -> ImportError {
        let name = &self.keys.name;
        let problem = format!("edge `{}`: {problem}", name.as_ref());
        self.source.error(name, problem, accepted)
    }

    fn vertices(&self) -> Result<Option<[usize; 2]>> {
        let find = |name| self.vertices.find(self.source, name);
        match (&self.keys.start, &self.keys.end) {
            (None, None) => Ok(None),
            (Some(start), Some(end)) => Ok(Some([find(start)?, find(end)?])),
            _ => {
                let accepted = "both are needed, or none for a closed edge";
                Err(self.error("it has one of `start` and `end`", accepted))
            }
        }
    }

    fn line(&self, ends: Option<[Vector; 2]>) -> Result<Curve> {
        let Some([from, to]) = ends else {
            return Err(self.error("a line has two ends", "`start` and `end` are needed"));
        };
        if distance(from, to) <= COINCIDENT * self.vertices.size {
            let accepted = "two vertices at different places are needed";
            return Err(self.error("the line has no length", accepted));
        }
        Ok(Curve::Line { from, to })
    }

    /// A circle begins at its first end, wherever its frame does; an ellipse has its own frame.
    fn ellipse(&self, ends: Option<[Vector; 2]>) -> Result<Ellipse> {
        let centre = self.source.point(needed(&self.keys.centre))?;
        let normal = self.source.direction(needed(&self.keys.axis))?;
        let (x, radii) = if let Some(radius) = &self.keys.radius {
            let radii = [*radius.as_ref(); 2];
            self.source.lengths(radius, &radii[..1])?;
            let x = match ends {
                Some([from, _]) => across(minus(from, centre), normal),
                None => frame(normal, 0.0)[0],
            };
            if length(x) <= COINCIDENT * radii[0] {
                let accepted = "a vertex on the circle is needed";
                return Err(self.error("the start is the centre", accepted));
            }
            (x, radii)
        } else {
            let x = across(self.source.direction(needed(&self.keys.x))?, normal);
            if length(x) < 1e-9 {
                return Err(self.error("`x` is along `axis`", "a direction across it is needed"));
            }
            let radii = needed(&self.keys.radii);
            self.source.lengths(radii, radii.as_ref())?;
            (x, *radii.as_ref())
        };
        Ok(Ellipse {
            centre,
            normal,
            x: unit(x),
            radii,
        })
    }

    fn points(&self, ends: Option<[Vector; 2]>) -> Result<Curve> {
        let list = needed(&self.keys.points);
        self.source.checked(list, list.as_ref().as_flattened())?;
        let mut points = list.as_ref().clone();
        if let Some([from, to]) = ends {
            points.insert(0, from);
            points.push(to);
        }
        let closed = ends.is_none();
        let least = if closed { 3 } else { 2 };
        if !(least..=MAX_POINTS).contains(&points.len()) {
            return Err(self.error(
                format!("{} points", points.len()),
                "at least three for a closed edge, with the ends at least two otherwise, and at most 2000 are possible",
            ));
        }
        let size = reach(points.iter().copied(), points[0]);
        for k in 0..points.len() - usize::from(!closed) {
            if distance(points[k], points[(k + 1) % points.len()]) <= 1e-9 * size.max(1e-9) {
                let problem = format!("{:?} follows itself", points[k]);
                let accepted =
                    "different points are needed, and a closed edge does not repeat its first";
                return Err(self.error(problem, accepted));
            }
        }
        Ok(Curve::through(points, closed, COINCIDENT * size))
    }
}
