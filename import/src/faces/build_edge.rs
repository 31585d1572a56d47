//! Edges from their words.

use super::arc::{Ellipse, Tolerance};
use super::build::{Source, Vertices};
use super::build_surface::{direction, positive};
use super::curve::Curve;
use super::keys::EdgeKeys;
use super::model::{COINCIDENT, Edge};
use super::vector::{Vector, across, distance, frame, length, minus, unit};
use crate::ImportError;
use toml::Spanned;

/// Share of the size of the curve by which an end may miss its circle: the digits of a list written with six decimals.
pub const MISSED: f64 = 1e-5;
/// Most points of one edge.
const MAX_POINTS: usize = 2000;

/// Makes one edge.
pub struct EdgeBuilder<'a> {
    source: &'a Source<'a>,
    keys: &'a EdgeKeys,
    vertices: &'a Vertices,
}

impl<'a> EdgeBuilder<'a> {
    /// Of these words.
    pub fn new(source: &'a Source, keys: &'a EdgeKeys, vertices: &'a Vertices) -> Self {
        Self {
            source,
            keys,
            vertices,
        }
    }

    /// The edge.
    pub fn edge(&self) -> Result<Edge, ImportError> {
        let ends = self.ends()?;
        let (kind, allowed): (&'static str, &[&str]) = match self.keys.kind.as_ref().as_str() {
            "line" => ("line", &[]),
            "circle" => ("circle", &["centre", "axis", "radius"]),
            "ellipse" => ("ellipse", &["centre", "axis", "x", "radii"]),
            "points" => ("points", &["points"]),
            other => {
                return Err(self.source.error(
                    self.keys.kind.span(),
                    format!("`{other}` is not a kind of edge"),
                    "line, circle, ellipse and points are possible",
                ));
            }
        };
        self.refuse_others(allowed)?;
        let curve = match kind {
            "line" => self.line(ends)?,
            "circle" => self.circle(ends)?,
            "ellipse" => self.ellipse(ends)?,
            _ => self.points(ends)?,
        };
        Ok(Edge {
            name: self.keys.name.as_ref().clone(),
            kind,
            vertices: ends,
            curve,
            off: 0.0,
        })
    }

    fn error(&self, problem: String, accepted: &str) -> ImportError {
        let name = &self.keys.name;
        self.source.error(
            name.span(),
            format!("edge `{}`: {problem}", name.as_ref()),
            accepted,
        )
    }

    fn refuse_others(&self, allowed: &[&str]) -> Result<(), ImportError> {
        let k = self.keys;
        let given = [
            ("centre", k.centre.is_some()),
            ("axis", k.axis.is_some()),
            ("radius", k.radius.is_some()),
            ("x", k.x.is_some()),
            ("radii", k.radii.is_some()),
            ("points", k.points.is_some()),
        ];
        let wrong = given.iter().find(|(key, is)| *is != allowed.contains(key));
        match wrong {
            None => Ok(()),
            Some((key, true)) => Err(self.error(
                format!("`{key}` is no key of kind \"{}\"", k.kind.as_ref()),
                "only the keys of its kind are possible",
            )),
            Some((key, false)) => Err(self.error(
                format!("kind \"{}\" needs `{key}`", k.kind.as_ref()),
                "this key is needed",
            )),
        }
    }

    fn ends(&self) -> Result<Option<[usize; 2]>, ImportError> {
        match (&self.keys.start, &self.keys.end) {
            (None, None) => Ok(None),
            (Some(start), Some(end)) => Ok(Some([
                self.vertices.find(self.source, start)?,
                self.vertices.find(self.source, end)?,
            ])),
            _ => Err(self.error(
                "it has one of `start` and `end`".into(),
                "both are needed, or none for a closed edge",
            )),
        }
    }

    fn points_of(&self, ends: Option<[usize; 2]>) -> Option<[Vector; 2]> {
        ends.map(|ends| ends.map(|index| self.vertices.points[index]))
    }

    fn line(&self, ends: Option<[usize; 2]>) -> Result<Curve, ImportError> {
        let Some([from, to]) = self.points_of(ends) else {
            return Err(self.error("a line has two ends".into(), "`start` and `end` are needed"));
        };
        if distance(from, to) <= COINCIDENT * self.vertices.size {
            return Err(self.error(
                "the line has no length".into(),
                "two vertices at different places are needed",
            ));
        }
        Ok(Curve::Line { from, to })
    }

    fn vector(&self, value: &Option<Spanned<[f64; 3]>>) -> Result<Vector, ImportError> {
        let value = value.as_ref().expect("keys of the kind are checked");
        self.source.check(value.span(), value.as_ref())?;
        Ok(*value.as_ref())
    }

    fn direction(&self, value: &Option<Spanned<[f64; 3]>>) -> Result<Vector, ImportError> {
        direction(
            self.source,
            value.as_ref().expect("keys of the kind are checked"),
        )
    }

    fn circle(&self, ends: Option<[usize; 2]>) -> Result<Curve, ImportError> {
        let centre = self.vector(&self.keys.centre)?;
        let normal = self.direction(&self.keys.axis)?;
        let radius = self
            .keys
            .radius
            .as_ref()
            .expect("keys of the kind are checked");
        let radius = positive(self.source, radius)?;
        let x = match self.points_of(ends) {
            Some([from, _]) => across(minus(from, centre), normal),
            None => frame(normal, 0.0)[0],
        };
        if length(x) <= COINCIDENT * radius {
            return Err(self.error(
                "the start is the centre".into(),
                "a vertex on the circle is needed",
            ));
        }
        self.arc(ends, centre, normal, unit(x), [radius; 2])
    }

    fn ellipse(&self, ends: Option<[usize; 2]>) -> Result<Curve, ImportError> {
        let centre = self.vector(&self.keys.centre)?;
        let normal = self.direction(&self.keys.axis)?;
        let x = across(self.direction(&self.keys.x)?, normal);
        if length(x) < 1e-9 {
            return Err(self.error(
                "`x` is along `axis`".into(),
                "a direction across it is needed",
            ));
        }
        let radii = self
            .keys
            .radii
            .as_ref()
            .expect("keys of the kind are checked");
        for radius in radii.as_ref() {
            positive(self.source, &Spanned::new(radii.span(), *radius))?;
        }
        self.arc(ends, centre, normal, unit(x), *radii.as_ref())
    }

    fn arc(
        &self,
        ends: Option<[usize; 2]>,
        centre: Vector,
        normal: Vector,
        x: Vector,
        radii: [f64; 2],
    ) -> Result<Curve, ImportError> {
        let ellipse = Ellipse {
            centre,
            normal,
            x,
            radii,
        };
        let tolerance = Tolerance {
            missed: MISSED * radii[0].max(radii[1]),
            shortest: 1e-7 * self.vertices.size,
        };
        let one_vertex = ends.is_some_and(|[a, b]| a == b);
        ellipse
            .arc(self.points_of(ends), one_vertex, tolerance)
            .map_err(|(problem, accepted)| self.error(problem, accepted))
    }

    fn points(&self, ends: Option<[usize; 2]>) -> Result<Curve, ImportError> {
        let list = self
            .keys
            .points
            .as_ref()
            .expect("keys of the kind are checked");
        for point in list.as_ref() {
            self.source.check(list.span(), point)?;
        }
        let mut points = list.as_ref().clone();
        if let Some([from, to]) = self.points_of(ends) {
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
        let first = points[0];
        let size = points
            .iter()
            .fold(0.0_f64, |most, p| most.max(distance(*p, first)));
        let pairs = points.len() - usize::from(!closed);
        for k in 0..pairs {
            if distance(points[k], points[(k + 1) % points.len()]) <= 1e-9 * size.max(1e-9) {
                return Err(self.error(
                    format!("{:?} follows itself", points[k]),
                    "different points are needed, and a closed edge does not repeat its first",
                ));
            }
        }
        Ok(Curve::through(points, closed, COINCIDENT * size))
    }
}
