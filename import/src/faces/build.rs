//! From the words of a face list to a model; every refusal names its line and column.

use super::curve::{Curve, Ellipse};
use super::keys::{EdgeKeys, FORMAT_VERSION, FaceKeys, ListKeys, Name, SurfaceKeys};
use super::model::{COINCIDENT, Edge, EdgeUse, Face, Model, Solid};
use super::surface::{Form, Surface};
use super::vector::{Vector, across, distance, frame, hull, length, minus, reach, unit};
use crate::error::{ImportError, Result, Source, unusable};
use imogene_scene::Material;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::fmt::Display;
use toml::Spanned;

/// Most faces, and most edges, of a list.
pub const MAX_PARTS: usize = 20_000;

pub fn build(source: Source) -> Result<Model> {
    let keys: ListKeys = toml::from_str(source.text).map_err(|error| {
        source.error_at(
            error.span().unwrap_or(0..0).start,
            error.message().trim_end().replace('\n', ", "),
            "a face list as docs/cad-faces.md describes it is needed",
        )
    })?;
    let version = *keys.format.as_ref();
    if version != FORMAT_VERSION {
        let problem = format!("version {version} of the format is not known");
        let accepted = format!("this program reads `format = {FORMAT_VERSION}`");
        return Err(source.error(&keys.format, problem, accepted));
    }
    let vertices = Vertices::of(source, &keys.vertices)?;
    let edges = edges(&source, &keys, &vertices)?;
    let faces = faces(&source, &keys.faces, &edges)?;
    let materials = materials(&source, &keys.materials)?;
    let solids = solids(&source, &keys, &materials)?;
    let model = Model {
        title: keys.title,
        materials,
        edges,
        faces,
        solids,
        ..Model::default()
    };
    let accepted = "at least one face with edges, or a sphere, and a box around them of at least a millionth of a unit are needed";
    let refused = || unusable(source.file, "the faces have no size", accepted);
    model.assembled().ok_or_else(refused)
}

/// Refuses too many parts by their names.
fn few<'k>(
    source: &Source,
    mut names: impl ExactSizeIterator<Item = &'k Name>,
    what: &str,
) -> Result<()> {
    let problem = format!("{} {what}", names.len());
    let accepted = format!("at most {MAX_PARTS} are possible; a larger assembly is several lists");
    let extra = names.nth(MAX_PARTS);
    extra.map_or(Ok(()), |name| Err(source.error(name, problem, accepted)))
}

/// Refuses an empty name and one that is taken.
fn unique(source: &Source, names: &mut HashSet<String>, name: &Name, what: &str) -> Result<()> {
    let text = name.as_ref();
    if text.trim().is_empty() || text.starts_with('-') {
        let accepted = "a name that is not empty and does not begin with `-` is needed";
        return Err(source.error(name, format!("`{text}` is no name of a {what}"), accepted));
    }
    if !names.insert(text.clone()) {
        let problem = format!("the name `{text}` is taken by an earlier {what}");
        return Err(source.error(name, problem, "every name must be unique"));
    }
    Ok(())
}

fn edges(source: &Source, keys: &ListKeys, vertices: &Vertices) -> Result<Vec<Edge>> {
    few(source, keys.edges.iter().map(|key| &key.name), "edges")?;
    let mut names = HashSet::new();
    let edge = |keys: &EdgeKeys| {
        unique(source, &mut names, &keys.name, "edge")?;
        keys.edge(vertices)
    };
    keys.edges.iter().map(edge).collect()
}

fn faces(source: &Source, keys: &[FaceKeys], edges: &[Edge]) -> Result<Vec<Face>> {
    few(source, keys.iter().map(|key| &key.name), "faces")?;
    let edge_names = edges.iter().map(|edge| edge.name.as_str());
    let by_name: HashMap<&str, usize> = edge_names.zip(0..).collect();
    let mut names = HashSet::new();
    let mut faces = vec![];
    for key in keys {
        unique(source, &mut names, &key.name, "face")?;
        let surface = surface(source, &key.surface)?;
        let name = key.name.as_ref().clone();
        let edge_loop = |list| edge_loop(source, list, &by_name, edges);
        let loops: Vec<Vec<EdgeUse>> = key.loops.iter().map(edge_loop).collect::<Result<_>>()?;
        let form = &surface.form;
        let is_endless = matches!(form, Form::Plane | Form::Cylinder(_) | Form::Cone(_));
        if loops.is_empty() && is_endless {
            let surface = surface.name();
            let problem = format!("face `{name}` has no loop, and a {surface} is endless");
            let accepted = "`loops = [[\"edge\", ...], ...]` is needed; a whole sphere or torus alone has none";
            return Err(source.error(&key.name, problem, accepted));
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

/// The edges of a loop, each of which begins where the one before it ends.
fn edge_loop(
    source: &Source,
    list: &Spanned<Vec<Name>>,
    by_name: &HashMap<&str, usize>,
    edges: &[Edge],
) -> Result<Vec<EdgeUse>> {
    let names = list.as_ref();
    let mut uses = vec![];
    for name in names {
        let text = name.as_ref().as_str();
        let plain = text.strip_prefix('-').unwrap_or(text);
        let forward = plain.len() == text.len();
        let edge = *by_name.get(plain).ok_or_else(|| source.error(
            name,
            format!("`{plain}` is not an edge of this list"),
            "the name of an edge, with `-` in front if it is passed from its end to its start, is needed",
        ))?;
        uses.push(EdgeUse { edge, forward });
    }
    let Some(first) = uses.first() else {
        return Err(source.error(list, "the loop has no edge", "at least one edge is needed"));
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
            return Err(source.error(name, problem, "a closed edge is a loop of its own"));
        };
        if end != start {
            let problem = format!("`{text}` does not end where `{after}` begins");
            let accepted = "the edges of a loop follow each other from vertex to vertex and come back to the first";
            return Err(source.error(name, problem, accepted));
        }
    }
    Ok(uses)
}

fn materials(source: &Source, keys: &[Spanned<Material>]) -> Result<Vec<Material>> {
    let mut names = HashSet::new();
    for material in keys {
        let m = material.as_ref();
        let name = Spanned::new(material.span(), m.name.clone());
        unique(source, &mut names, &name, "material")?;
        let [r, g, b] = m.colour;
        let shares = [m.ambient, m.diffuse, m.specular, r, g, b];
        if let Some(value) = shares.iter().find(|v| !(0.0..=1.0).contains(*v)) {
            let problem = format!("{value} in material `{}` is out of range", m.name);
            let accepted = "colours and shares are numbers from 0 to 1";
            return Err(source.error(material, problem, accepted));
        }
    }
    Ok(keys.iter().map(|m| m.as_ref().clone()).collect())
}

fn solids(source: &Source, keys: &ListKeys, materials: &[Material]) -> Result<Vec<Solid>> {
    let faces = keys.faces.iter().map(|face| face.name.as_ref().as_str());
    let index: HashMap<&str, usize> = faces.zip(0..).collect();
    let mut owned = vec![false; keys.faces.len()];
    let mut names = HashSet::new();
    let mut solids = vec![];
    for key in &keys.solids {
        unique(source, &mut names, &key.name, "solid")?;
        let material = key.material.as_ref();
        if !materials.iter().any(|m| m.name == *material) {
            let problem = format!("`{material}` is not a material of this list");
            let accepted = "the name of an entry of `[[materials]]` is needed";
            return Err(source.error(&key.material, problem, accepted));
        }
        let face = |name: &Name| {
            let text = name.as_ref();
            let problem = match index.get(text.as_str()) {
                Some(face) if !std::mem::replace(&mut owned[*face], true) => return Ok(*face),
                Some(_) => format!("face `{text}` has a solid already"),
                None => format!("`{text}` is not a face of this list"),
            };
            Err(source.error(name, problem, "every face belongs to exactly one solid"))
        };
        solids.push(Solid {
            name: key.name.as_ref().clone(),
            material: material.clone(),
            faces: key.faces.iter().map(face).collect::<Result<_, _>>()?,
        });
    }
    if let Some(lost) = owned.iter().position(|owned| !owned) {
        let name = &keys.faces[lost].name;
        let problem = format!("face `{}` belongs to no solid", name.as_ref());
        let accepted = "every face belongs to exactly one of `[[solids]]`";
        return Err(source.error(name, problem, accepted));
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

pub fn surface(source: &Source, keys: &Spanned<SurfaceKeys>) -> Result<Surface> {
    let own = keys.as_ref();
    let kind = own.kind.as_ref().as_str();
    let known = KINDS.iter().find(|(name, ..)| *name == kind);
    if known.is_none() && !OTHER_SURFACES.contains(&kind) {
        let others = OTHER_SURFACES.join(", ");
        let problem = format!("`{kind}` is not a kind of surface");
        let accepted = format!(
            "plane, cylinder, cone, sphere, and as names of what is not drawn {others}, are possible"
        );
        return Err(source.error(&own.kind, problem, accepted));
    }
    let (_, vectors, sizes) = *known.unwrap_or(&("", &[], &[]));
    let allowed = [vectors, sizes].concat();
    let given = own.given();
    if let Some(key) = given.iter().find(|key| !allowed.contains(*key)) {
        let accepted = match allowed.join(", ").as_str() {
            "" => "its name alone is possible".to_owned(),
            allowed => format!("it has {allowed}"),
        };
        return Err(source.error(keys, format!("a {kind} has no `{key}`"), accepted));
    }
    // A torus whose numbers are not all given is named only.
    if vectors.is_empty() || (kind == "torus" && given.len() < allowed.len()) {
        return Ok(Surface::other(kind));
    }
    let missing = |key: &str| {
        let problem = format!("a {kind} needs `{key}`");
        source.error(keys, problem, "this key is needed")
    };
    let vector = |key: &str| own.vector(key).ok_or_else(|| missing(key));
    let origin = source.point(vector(vectors[0])?)?;
    let axis = match vectors.get(1) {
        Some(key) => source.direction(vector(key)?)?,
        None => [0.0, 0.0, 1.0],
    };
    let size = |key: &&str| size(source, key, own.number(key).ok_or_else(|| missing(key))?);
    let numbers: Vec<f64> = sizes.iter().map(size).collect::<Result<_>>()?;
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
fn size(source: &Source, key: &str, value: &Spanned<f64>) -> Result<f64> {
    let number = *value.as_ref();
    if key != "half_angle" {
        source.lengths(value, &[number])?;
        return Ok(number);
    }
    if !(0.1..=89.9).contains(&number) {
        let problem = format!("{number} degrees between axis and surface is out of range");
        return Err(source.error(value, problem, "0.1 to 89.9 degrees are possible"));
    }
    Ok(number.to_radians())
}

/// Share of the size of the curve by which an end may miss its circle: the digits of a list written with six decimals.
pub const MISSED: f64 = 1e-5;
const MAX_POINTS: usize = 2000;

/// Kinds of edges with the keys that they have.
const EDGE_KINDS: [(&str, &[&str]); 4] = [
    ("line", &[]),
    ("circle", &["centre", "axis", "radius"]),
    ("ellipse", &["centre", "axis", "x", "radii"]),
    ("points", &["points"]),
];

/// Names and places of the vertices of a list.
pub struct Vertices<'a> {
    source: Source<'a>,
    index: HashMap<String, usize>,
    points: Vec<Vector>,
    /// Size of the box around them, for tolerances.
    size: f64,
}

impl<'a> Vertices<'a> {
    pub fn of(
        source: Source<'a>,
        keys: &BTreeMap<String, Spanned<Vector>>,
    ) -> Result<Vertices<'a>> {
        let points = keys.values().map(|p| source.point(p));
        let points: Vec<Vector> = points.collect::<Result<_>>()?;
        Ok(Vertices {
            source,
            index: keys.keys().cloned().zip(0..).collect(),
            size: hull(&points).map_or(0.0, |[low, high]| distance(low, high)),
            points,
        })
    }

    fn find(&self, name: &Spanned<String>) -> Result<usize> {
        self.index.get(name.as_ref()).copied().ok_or_else(|| {
            let problem = format!("`{}` is not a vertex of this list", name.as_ref());
            let accepted = "the name of an entry of `[vertices]` is needed";
            self.source.error(name, problem, accepted)
        })
    }
}

fn needed<T>(value: &Option<T>) -> &T {
    value.as_ref().expect("keys of the kind are checked")
}

impl EdgeKeys {
    pub fn edge(&self, all: &Vertices) -> Result<Edge> {
        let source = &all.source;
        let vertices = self.vertices(all)?;
        let kind = self.kind.as_ref();
        let Some((kind, allowed)) = EDGE_KINDS.iter().find(|(name, _)| name == kind) else {
            let problem = format!("`{kind}` is not a kind of edge");
            let accepted = "line, circle, ellipse and points are possible";
            return Err(source.error(&self.kind, problem, accepted));
        };
        for (key, is) in self.given() {
            if is && !allowed.contains(&key) {
                let problem = format!("`{key}` is no key of kind \"{kind}\"");
                return Err(self.error(source, problem, "only the keys of its kind are possible"));
            }
            if !is && allowed.contains(&key) {
                let problem = format!("kind \"{kind}\" needs `{key}`");
                return Err(self.error(source, problem, "this key is needed"));
            }
        }
        let ends = vertices.map(|ends| ends.map(|index| all.points[index]));
        let one_vertex = vertices.is_some_and(|[a, b]| a == b);
        let curve = match *kind {
            "line" => self.line(ends, all)?,
            "points" => self.points(ends, source)?,
            _ => {
                let ellipse = self.ellipse(ends, source)?;
                let missed = MISSED * ellipse.radii[0].max(ellipse.radii[1]);
                let arc = ellipse.arc(ends, one_vertex, [missed, 1e-7 * all.size]);
                arc.map_err(|(problem, accepted)| self.error(source, problem, accepted))?
            }
        };
        Ok(Edge {
            name: self.name.as_ref().clone(),
            vertices,
            curve,
            off: 0.0,
        })
    }

    fn error(&self, source: &Source, problem: impl Display, accepted: &str) -> ImportError {
        let name = &self.name;
        let problem = format!("edge `{}`: {problem}", name.as_ref());
        source.error(name, problem, accepted)
    }

    fn vertices(&self, all: &Vertices) -> Result<Option<[usize; 2]>> {
        let find = |name| all.find(name);
        match (&self.start, &self.end) {
            (None, None) => Ok(None),
            (Some(start), Some(end)) => Ok(Some([find(start)?, find(end)?])),
            _ => {
                let accepted = "both are needed, or none for a closed edge";
                Err(self.error(&all.source, "it has one of `start` and `end`", accepted))
            }
        }
    }

    fn line(&self, ends: Option<[Vector; 2]>, all: &Vertices) -> Result<Curve> {
        let source = &all.source;
        let Some([from, to]) = ends else {
            let accepted = "`start` and `end` are needed";
            return Err(self.error(source, "a line has two ends", accepted));
        };
        if distance(from, to) <= COINCIDENT * all.size {
            let accepted = "two vertices at different places are needed";
            return Err(self.error(source, "the line has no length", accepted));
        }
        Ok(Curve::Line { from, to })
    }

    /// A circle begins at its first end, wherever its frame does; an ellipse has its own frame.
    fn ellipse(&self, ends: Option<[Vector; 2]>, source: &Source) -> Result<Ellipse> {
        let centre = source.point(needed(&self.centre))?;
        let normal = source.direction(needed(&self.axis))?;
        let (x, radii) = if let Some(radius) = &self.radius {
            let radii = [*radius.as_ref(); 2];
            source.lengths(radius, &radii[..1])?;
            let x = match ends {
                Some([from, _]) => across(minus(from, centre), normal),
                None => frame(normal, 0.0)[0],
            };
            if length(x) <= COINCIDENT * radii[0] {
                let accepted = "a vertex on the circle is needed";
                return Err(self.error(source, "the start is the centre", accepted));
            }
            (x, radii)
        } else {
            let x = across(source.direction(needed(&self.x))?, normal);
            if length(x) < 1e-9 {
                let accepted = "a direction across it is needed";
                return Err(self.error(source, "`x` is along `axis`", accepted));
            }
            let radii = needed(&self.radii);
            source.lengths(radii, radii.as_ref())?;
            (x, *radii.as_ref())
        };
        Ok(Ellipse::new(centre, normal, unit(x), radii))
    }

    fn points(&self, ends: Option<[Vector; 2]>, source: &Source) -> Result<Curve> {
        let list = needed(&self.points);
        source.checked(list, list.as_ref().as_flattened())?;
        let mut points = list.as_ref().clone();
        if let Some([from, to]) = ends {
            points.insert(0, from);
            points.push(to);
        }
        let closed = ends.is_none();
        let least = if closed { 3 } else { 2 };
        if !(least..=MAX_POINTS).contains(&points.len()) {
            let problem = format!("{} points", points.len());
            let accepted = "at least three for a closed edge, with the ends at least two otherwise, and at most 2000 are possible";
            return Err(self.error(source, problem, accepted));
        }
        let size = reach(points.iter().copied(), points[0]);
        for k in 0..points.len() - usize::from(!closed) {
            if distance(points[k], points[(k + 1) % points.len()]) <= 1e-9 * size.max(1e-9) {
                let problem = format!("{:?} follows itself", points[k]);
                let accepted =
                    "different points are needed, and a closed edge does not repeat its first";
                return Err(self.error(source, problem, accepted));
            }
        }
        Ok(Curve::through(points, closed, COINCIDENT * size))
    }
}
