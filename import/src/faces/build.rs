//! From the words of a face list to a model; every refusal names its line and column.

use super::keys::*;
use super::model::COINCIDENT;
use super::vector::{Vector, across, distance, frame, hull, length, minus, reach, unit};
use super::{Curve, Edge, EdgeUse, Ellipse, Face, Form, Model, Solid, Surface};
use crate::error::{Error, Result};
use imogene_scene::Material;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::fmt::Display;
use toml::Spanned;

/// Most faces, and most edges, of a list.
pub const MAX_PARTS: usize = 20_000;

pub fn build(text: &str) -> Result<Model> {
    let read = toml::from_str(text).map_err(|error| {
        let problem = error.message().trim_end().replace('\n', ", ");
        let accepted = "a face list as docs/cad-faces.md describes it is needed";
        Flaw::new(error.span().unwrap_or(0..0), [problem, accepted.to_owned()])
    });
    let model = read.and_then(model).map_err(|flaw| {
        let [problem, accepted] = flaw.as_ref();
        Error::at(text.as_bytes(), flaw.span().start, problem, accepted)
    })?;
    let accepted = "at least one face with edges, or a sphere, and a box around them of at least a millionth of a unit are needed";
    let refused = || Error::whole("the faces have no size", accepted);
    model.assembled().ok_or_else(refused)
}

fn model(keys: ListKeys) -> Checked<Model> {
    let version = *keys.format.as_ref();
    if version != FORMAT_VERSION {
        let problem = format!("version {version} of the format is not known");
        let accepted = format!("this program reads `format = {FORMAT_VERSION}`");
        return Err(flaw(&keys.format, problem, accepted));
    }
    let edges = edges(&keys, &Vertices::of(&keys.vertices)?)?;
    let faces = faces(&keys.faces, &edges)?;
    let materials = materials(&keys.materials)?;
    let solids = solids(&keys, &materials)?;
    Ok(Model {
        title: keys.title,
        materials,
        edges,
        faces,
        solids,
        ..Model::default()
    })
}

/// Refuses too many parts by their names.
fn few<'k>(mut names: impl ExactSizeIterator<Item = &'k Name>, what: &str) -> Checked<()> {
    let problem = format!("{} {what}", names.len());
    let accepted = format!("at most {MAX_PARTS} are possible; a larger assembly is several lists");
    let extra = names.nth(MAX_PARTS);
    extra.map_or(Ok(()), |name| Err(flaw(name, problem, accepted)))
}

/// Refuses an empty name and one that is taken.
fn unique(names: &mut HashSet<String>, name: &Name, what: &str) -> Checked<()> {
    let text = name.as_ref();
    if text.trim().is_empty() || text.starts_with('-') {
        let accepted = "a name that is not empty and does not begin with `-` is needed";
        let problem = format!("`{text}` is no name of a {what}");
        return Err(flaw(name, problem, accepted));
    }
    if !names.insert(text.clone()) {
        let problem = format!("the name `{text}` is taken by an earlier {what}");
        return Err(flaw(name, problem, "every name must be unique"));
    }
    Ok(())
}

fn edges(keys: &ListKeys, vertices: &Vertices) -> Checked<Vec<Edge>> {
    few(keys.edges.iter().map(|key| &key.name), "edges")?;
    let mut names = HashSet::new();
    let edge = |keys: &EdgeKeys| {
        unique(&mut names, &keys.name, "edge")?;
        keys.edge(vertices)
    };
    keys.edges.iter().map(edge).collect()
}

fn faces(keys: &[FaceKeys], edges: &[Edge]) -> Checked<Vec<Face>> {
    few(keys.iter().map(|key| &key.name), "faces")?;
    let edge_names = edges.iter().map(|edge| edge.name.as_str());
    let by_name: HashMap<&str, usize> = edge_names.zip(0..).collect();
    let mut names = HashSet::new();
    let mut faces = vec![];
    for key in keys {
        unique(&mut names, &key.name, "face")?;
        let surface = surface(&key.surface)?;
        let name = key.name.as_ref().clone();
        let edge_loop = |list| edge_loop(list, &by_name, edges);
        let loops: Vec<Vec<EdgeUse>> = key.loops.iter().map(edge_loop).collect::<Checked<_>>()?;
        let form = &surface.form;
        if loops.is_empty() && matches!(form, Form::Plane | Form::Cylinder(_) | Form::Cone(_)) {
            let surface = surface.name();
            let problem = format!("face `{name}` has no loop, and a {surface} is endless");
            let accepted = "`loops = [[\"edge\", ...], ...]` is needed; a whole sphere or torus alone has none";
            return Err(flaw(&key.name, problem, accepted));
        }
        faces.push(Face {
            name,
            surface,
            loops,
            reversed: key.reversed,
            ..Face::default()
        });
    }
    Ok(faces)
}

fn edge_loop(
    list: &Spanned<Vec<Name>>,
    by_name: &HashMap<&str, usize>,
    edges: &[Edge],
) -> Checked<Vec<EdgeUse>> {
    let names = list.as_ref();
    let mut uses = vec![];
    for name in names {
        let text = name.as_ref().as_str();
        let plain = text.strip_prefix('-').unwrap_or(text);
        let forward = plain.len() == text.len();
        let edge = *by_name.get(plain).ok_or_else(|| flaw(
            name,
            format!("`{plain}` is not an edge of this list"),
            "the name of an edge, with `-` in front if it is passed from its end to its start, is needed",
        ))?;
        uses.push(EdgeUse { edge, forward });
    }
    let Some(first) = uses.first() else {
        let accepted = "at least one edge is needed";
        return Err(flaw(list, "the loop has no edge", accepted));
    };
    if edges[first.edge].vertices.is_none() && uses.len() == 1 {
        return Ok(uses);
    }
    let ends = |own: EdgeUse| {
        let vertices = edges[own.edge].vertices;
        vertices.map(|[a, b]| if own.forward { [a, b] } else { [b, a] })
    };
    for (index, name) in names.iter().enumerate() {
        let next = (index + 1) % uses.len();
        let (text, after) = (name.as_ref(), names[next].as_ref());
        let (Some([_, end]), Some([start, _])) = (ends(uses[index]), ends(uses[next])) else {
            let problem = format!("a closed edge stands in one loop with others, at `{text}`");
            return Err(flaw(name, problem, "a closed edge is a loop of its own"));
        };
        if end != start {
            let problem = format!("`{text}` does not end where `{after}` begins");
            let accepted = "the edges of a loop follow each other from vertex to vertex and come back to the first";
            return Err(flaw(name, problem, accepted));
        }
    }
    Ok(uses)
}

fn materials(keys: &[Spanned<Material>]) -> Checked<Vec<Material>> {
    let mut names = HashSet::new();
    for material in keys {
        let m = material.as_ref();
        let name = Spanned::new(material.span(), m.name.clone());
        unique(&mut names, &name, "material")?;
        let [r, g, b] = m.colour;
        let shares = [m.ambient, m.diffuse, m.specular, r, g, b];
        if let Some(value) = shares.iter().find(|v| !(0.0..=1.0).contains(*v)) {
            let problem = format!("{value} in material `{}` is out of range", m.name);
            let accepted = "colours and shares are numbers from 0 to 1";
            return Err(flaw(material, problem, accepted));
        }
    }
    Ok(keys.iter().map(|m| m.as_ref().clone()).collect())
}

fn solids(keys: &ListKeys, materials: &[Material]) -> Checked<Vec<Solid>> {
    let faces = keys.faces.iter().map(|face| face.name.as_ref().as_str());
    let index: HashMap<&str, usize> = faces.zip(0..).collect();
    let mut owned = vec![false; keys.faces.len()];
    let mut names = HashSet::new();
    let mut solids = vec![];
    for key in &keys.solids {
        unique(&mut names, &key.name, "solid")?;
        let material = key.material.as_ref();
        if !materials.iter().any(|m| m.name == *material) {
            let problem = format!("`{material}` is not a material of this list");
            let accepted = "the name of an entry of `[[materials]]` is needed";
            return Err(flaw(&key.material, problem, accepted));
        }
        let face = |name: &Name| {
            let text = name.as_ref();
            let problem = match index.get(text.as_str()) {
                Some(face) if !std::mem::replace(&mut owned[*face], true) => return Ok(*face),
                Some(_) => format!("face `{text}` has a solid already"),
                None => format!("`{text}` is not a face of this list"),
            };
            let accepted = "every face belongs to exactly one solid";
            Err(flaw(name, problem, accepted))
        };
        solids.push(Solid {
            name: key.name.as_ref().clone(),
            material: material.clone(),
            faces: key.faces.iter().map(face).collect::<Checked<_>>()?,
        });
    }
    if let Some(lost) = owned.iter().position(|owned| !owned) {
        let name = &keys.faces[lost].name;
        let problem = format!("face `{}` belongs to no solid", name.as_ref());
        let accepted = "every face belongs to exactly one of `[[solids]]`";
        return Err(flaw(name, problem, accepted));
    }
    Ok(solids)
}

/// Surfaces that are named and not drawn: they are no quadrics.
const OTHER_SURFACES: [&str; 6] = [
    "torus",
    "fillet",
    "bspline",
    "extrusion",
    "revolution",
    "other",
];

/// Kinds of surfaces with their keys: a point, a direction if there is one, and sizes.
const KINDS: [(&str, &[&str], &[&str]); 5] = [
    ("plane", &["origin", "normal"], &[]),
    ("cylinder", &["origin", "axis"], &["radius"]),
    ("cone", &["apex", "axis"], &["half_angle"]),
    ("sphere", &["centre"], &["radius"]),
    ("torus", &["centre", "axis"], &["major", "minor"]),
];

pub fn surface(keys: &Spanned<SurfaceKeys>) -> Checked<Surface> {
    let own = keys.as_ref();
    let kind = own.kind.as_ref().as_str();
    let known = KINDS.iter().find(|(name, ..)| *name == kind);
    if known.is_none() && !OTHER_SURFACES.contains(&kind) {
        let others = OTHER_SURFACES.join(", ");
        let problem = format!("`{kind}` is not a kind of surface");
        let accepted = format!(
            "plane, cylinder, cone, sphere, and as names of what is not drawn {others}, are possible"
        );
        return Err(flaw(&own.kind, problem, accepted));
    }
    let (_, vectors, sizes) = *known.unwrap_or(&("", &[], &[]));
    let allowed = [vectors, sizes].concat();
    let given = own.given();
    if let Some(key) = given.iter().find(|key| !allowed.contains(*key)) {
        let accepted = match allowed.join(", ").as_str() {
            "" => "its name alone is possible".to_owned(),
            allowed => format!("it has {allowed}"),
        };
        return Err(flaw(keys, format!("a {kind} has no `{key}`"), accepted));
    }
    // A torus whose numbers are not all given is named only.
    if vectors.is_empty() || (kind == "torus" && given.len() < allowed.len()) {
        return Ok(Surface::other(kind));
    }
    let missing = |key: &str| {
        let problem = format!("a {kind} needs `{key}`");
        flaw(keys, problem, "this key is needed")
    };
    let vector = |key: &str| own.vector(key).ok_or_else(|| missing(key));
    let origin = point(vector(vectors[0])?)?;
    let axis = match vectors.get(1) {
        Some(key) => direction(vector(key)?)?,
        None => [0.0, 0.0, 1.0],
    };
    let size = |key: &&str| size(key, own.number(key).ok_or_else(|| missing(key))?);
    let numbers: Vec<f64> = sizes.iter().map(size).collect::<Checked<_>>()?;
    let form = match (kind, &numbers[..]) {
        ("cylinder", [radius]) => Form::Cylinder(*radius),
        ("cone", [angle]) => Form::Cone(*angle),
        ("sphere", [radius]) => Form::Sphere(*radius),
        (_, [major, minor]) => Form::Torus(*major, *minor),
        _ => Form::Plane,
    };
    Ok(Surface::new(origin, axis, form))
}

/// A length above 0, or the angle of a cone in radians.
fn size(key: &str, value: &Spanned<f64>) -> Checked<f64> {
    let number = *value.as_ref();
    if key != "half_angle" {
        return lengths(value, &[number]).map(|()| number);
    }
    if !(0.1..=89.9).contains(&number) {
        let problem = format!("{number} degrees between axis and surface is out of range");
        return Err(flaw(value, problem, "0.1 to 89.9 degrees are possible"));
    }
    Ok(number.to_radians())
}

/// Share of the size of the curve by which an end may miss its circle: the digits of a list written with six decimals.
pub const MISSED: f64 = 1e-5;
const MAX_POINTS: usize = 2000;

const EDGE_KINDS: [(&str, &[&str]); 4] = [
    ("line", &[]),
    ("circle", &["centre", "axis", "radius"]),
    ("ellipse", &["centre", "axis", "x", "radii"]),
    ("points", &["points"]),
];

pub struct Vertices {
    index: HashMap<String, usize>,
    points: Vec<Vector>,
    /// Size of the box around them, for tolerances.
    size: f64,
}

impl Vertices {
    pub fn of(keys: &BTreeMap<String, Spanned<Vector>>) -> Checked<Vertices> {
        let points = keys.values().map(point);
        let points: Vec<Vector> = points.collect::<Checked<_>>()?;
        Ok(Vertices {
            index: keys.keys().cloned().zip(0..).collect(),
            size: hull(&points).map_or(0.0, |[low, high]| distance(low, high)),
            points,
        })
    }

    fn find(&self, name: &Spanned<String>) -> Checked<usize> {
        self.index.get(name.as_ref()).copied().ok_or_else(|| {
            let problem = format!("`{}` is not a vertex of this list", name.as_ref());
            let accepted = "the name of an entry of `[vertices]` is needed";
            flaw(name, problem, accepted)
        })
    }
}

fn needed<T>(value: &Option<T>) -> &T {
    value.as_ref().expect("keys of the kind are checked")
}

impl EdgeKeys {
    pub fn edge(&self, all: &Vertices) -> Checked<Edge> {
        let vertices = match (&self.start, &self.end) {
            (None, None) => None,
            (Some(start), Some(end)) => Some([all.find(start)?, all.find(end)?]),
            _ => {
                let accepted = "both are needed, or none for a closed edge";
                return Err(self.error("it has one of `start` and `end`", accepted));
            }
        };
        let kind = self.kind.as_ref();
        let Some((kind, allowed)) = EDGE_KINDS.iter().find(|(name, _)| name == kind) else {
            let problem = format!("`{kind}` is not a kind of edge");
            let accepted = "line, circle, ellipse and points are possible";
            return Err(flaw(&self.kind, problem, accepted));
        };
        for (key, is) in self.given() {
            if is && !allowed.contains(&key) {
                let problem = format!("`{key}` is no key of kind \"{kind}\"");
                return Err(self.error(problem, "only the keys of its kind are possible"));
            }
            if !is && allowed.contains(&key) {
                let problem = format!("kind \"{kind}\" needs `{key}`");
                return Err(self.error(problem, "this key is needed"));
            }
        }
        let ends = vertices.map(|ends| ends.map(|index| all.points[index]));
        let curve = match *kind {
            "line" => self.line(ends, all)?,
            "points" => self.points(ends)?,
            _ => {
                let ellipse = self.ellipse(ends)?;
                let missed = MISSED * ellipse.radii[0].max(ellipse.radii[1]);
                let one_vertex = vertices.is_some_and(|[a, b]| a == b);
                let arc = ellipse.arc(ends, one_vertex, [missed, 1e-7 * all.size]);
                arc.map_err(|(problem, accepted)| self.error(problem, accepted))?
            }
        };
        Ok(Edge {
            name: self.name.as_ref().clone(),
            vertices,
            curve,
            off: 0.0,
        })
    }

    fn error(&self, problem: impl Display, accepted: &str) -> Flaw {
        let name = &self.name;
        let problem = format!("edge `{}`: {problem}", name.as_ref());
        flaw(name, problem, accepted)
    }

    fn line(&self, ends: Option<[Vector; 2]>, all: &Vertices) -> Checked<Curve> {
        let Some([from, to]) = ends else {
            return Err(self.error("a line has two ends", "`start` and `end` are needed"));
        };
        if distance(from, to) <= COINCIDENT * all.size {
            let accepted = "two vertices at different places are needed";
            return Err(self.error("the line has no length", accepted));
        }
        Ok(Curve::Line { from, to })
    }

    /// A circle begins at its first end, wherever its frame does; an ellipse has its own frame.
    fn ellipse(&self, ends: Option<[Vector; 2]>) -> Checked<Ellipse> {
        let centre = point(needed(&self.centre))?;
        let normal = direction(needed(&self.axis))?;
        let (x, radii) = if let Some(radius) = &self.radius {
            let radii = [*radius.as_ref(); 2];
            lengths(radius, &radii[..1])?;
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
            let x = across(direction(needed(&self.x))?, normal);
            if length(x) < 1e-9 {
                return Err(self.error("`x` is along `axis`", "a direction across it is needed"));
            }
            let radii = needed(&self.radii);
            lengths(radii, radii.as_ref())?;
            (x, *radii.as_ref())
        };
        Ok(Ellipse::new(centre, normal, unit(x), radii))
    }

    fn points(&self, ends: Option<[Vector; 2]>) -> Checked<Curve> {
        let list = needed(&self.points);
        checked(list, list.as_ref().as_flattened())?;
        let mut points = list.as_ref().clone();
        if let Some([from, to]) = ends {
            points.insert(0, from);
            points.push(to);
        }
        let closed = ends.is_none();
        let least = if closed { 3 } else { 2 };
        if !(least..=MAX_POINTS).contains(&points.len()) {
            let accepted = "at least three for a closed edge, with the ends at least two otherwise, and at most 2000 are possible";
            return Err(self.error(format!("{} points", points.len()), accepted));
        }
        let size = reach(points.iter().copied(), points[0]);
        for k in 0..points.len() - usize::from(!closed) {
            if distance(points[k], points[(k + 1) % points.len()]) <= 1e-9 * size.max(1e-9) {
                let accepted =
                    "different points are needed, and a closed edge does not repeat its first";
                return Err(self.error(format!("{:?} follows itself", points[k]), accepted));
            }
        }
        Ok(Curve::through(points, closed, COINCIDENT * size))
    }
}
