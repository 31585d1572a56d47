//! From the words of a face list to a model; every refusal names its line and column.

use super::assemble::{Parts, assemble};
use super::build_edge::EdgeBuilder;
use super::build_surface::surface;
use super::keys::{FORMAT_VERSION, FaceKeys, ListKeys, SolidKeys};
use super::model::{Edge, EdgeUse, Face, Model, Solid, Up};
use super::surface::Surface;
use super::vector::{Vector, distance};
use crate::{ImportError, Place};
use imogene_scene::Material;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use toml::Spanned;

/// Largest coordinate and radius, scene units: beyond it double precision has no micrometres left in a metre.
pub const MAX_NUMBER: f64 = 1e9;
/// Most faces, and most edges, of a list.
pub const MAX_PARTS: usize = 20_000;

/// The text of a file and how errors in it are reported.
pub struct Source<'a> {
    /// Name of the file.
    pub file: &'a str,
    /// Its text.
    pub text: &'a str,
}

impl Source<'_> {
    /// An error at a place of the text.
    pub fn error(
        &self,
        span: Range<usize>,
        problem: impl Into<String>,
        accepted: impl Into<String>,
    ) -> ImportError {
        let mut end = span.start.min(self.text.len());
        while !self.text.is_char_boundary(end) {
            end -= 1;
        }
        let before = &self.text[..end];
        let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
        ImportError::Malformed {
            file: self.file.to_owned(),
            place: Place {
                line: before.matches('\n').count() + 1,
                column: before[line_start..].chars().count() + 1,
            },
            problem: problem.into(),
            accepted: accepted.into(),
        }
    }

    /// Refuses numbers that are not finite or too large.
    pub fn check(&self, span: Range<usize>, values: &[f64]) -> Result<(), ImportError> {
        match values.iter().find(|v| v.is_nan() || v.abs() > MAX_NUMBER) {
            None => Ok(()),
            Some(value) => Err(self.error(
                span,
                format!("{value} is out of range"),
                format!(
                    "finite numbers from {:e} to {MAX_NUMBER:e} are possible",
                    -MAX_NUMBER
                ),
            )),
        }
    }
}

/// Reads the text of a face list.
pub fn build(source: &Source) -> Result<Model, ImportError> {
    let keys: ListKeys = toml::from_str(source.text).map_err(|error| {
        source.error(
            error.span().unwrap_or(0..0),
            error.message().trim_end().replace('\n', ", "),
            "a face list as docs/cad-faces.md describes it is needed",
        )
    })?;
    if *keys.format.as_ref() != FORMAT_VERSION {
        return Err(source.error(
            keys.format.span(),
            format!(
                "version {} of the format is not known",
                keys.format.as_ref()
            ),
            format!("this program reads `format = {FORMAT_VERSION}`"),
        ));
    }
    let vertices = vertices(source, &keys.vertices)?;
    let edges = edges(source, &keys, &vertices)?;
    let faces = faces(source, &keys.faces, &edges)?;
    let materials = materials(source, &keys.materials)?;
    let solids = solids(source, &keys.solids, &keys.faces, &materials)?;
    assemble(Parts {
        title: keys.title,
        up: Up::Y,
        precision: 0.0,
        uncertainty: 0.0,
        materials,
        edges,
        faces,
        solids,
    })
    .ok_or_else(|| ImportError::Unusable {
        file: source.file.to_owned(),
        problem: "the faces have no size".into(),
        accepted: "at least one face with edges, or a sphere, and a box around them of at least a millionth of a unit are needed".into(),
    })
}

/// Names and places of the vertices.
pub struct Vertices {
    index: HashMap<String, usize>,
    /// Their places.
    pub points: Vec<Vector>,
    /// Size of the box around them and the circles, for tolerances.
    pub size: f64,
}

impl Vertices {
    /// Index of a vertex by its name.
    pub fn find(&self, source: &Source, name: &Spanned<String>) -> Result<usize, ImportError> {
        self.index.get(name.as_ref()).copied().ok_or_else(|| {
            source.error(
                name.span(),
                format!("`{}` is not a vertex of this list", name.as_ref()),
                "the name of an entry of `[vertices]` is needed",
            )
        })
    }
}

fn vertices(
    source: &Source,
    keys: &BTreeMap<String, Spanned<[f64; 3]>>,
) -> Result<Vertices, ImportError> {
    let mut all = Vertices {
        index: HashMap::new(),
        points: vec![],
        size: 0.0,
    };
    for (name, place) in keys {
        source.check(place.span(), place.as_ref())?;
        all.index.insert(name.clone(), all.points.len());
        all.points.push(*place.as_ref());
    }
    if let Some(bounds) = hull(all.points.iter().copied()) {
        all.size = distance(bounds[0], bounds[1]);
    }
    Ok(all)
}

fn edges(source: &Source, keys: &ListKeys, vertices: &Vertices) -> Result<Vec<Edge>, ImportError> {
    if let Some(extra) = keys.edges.get(MAX_PARTS) {
        return Err(too_many(
            source,
            extra.name.span(),
            "edges",
            keys.edges.len(),
        ));
    }
    let mut names = HashMap::new();
    let mut edges = vec![];
    for key in &keys.edges {
        unique(source, &mut names, &key.name, "edge")?;
        edges.push(EdgeBuilder::new(source, key, vertices).edge()?);
    }
    Ok(edges)
}

fn too_many(source: &Source, span: Range<usize>, what: &str, count: usize) -> ImportError {
    source.error(
        span,
        format!("{count} {what}"),
        format!("at most {MAX_PARTS} are possible; a larger assembly is several lists"),
    )
}

/// Refuses an empty name and one that is taken.
fn unique(
    source: &Source,
    names: &mut HashMap<String, usize>,
    name: &Spanned<String>,
    what: &str,
) -> Result<(), ImportError> {
    let text = name.as_ref();
    if text.trim().is_empty() || text.starts_with('-') {
        return Err(source.error(
            name.span(),
            format!("`{text}` is no name of a {what}"),
            "a name that is not empty and does not begin with `-` is needed",
        ));
    }
    let index = names.len();
    if names.insert(text.clone(), index).is_some() {
        return Err(source.error(
            name.span(),
            format!("the name `{text}` is taken by an earlier {what}"),
            "every name must be unique",
        ));
    }
    Ok(())
}

fn faces(source: &Source, keys: &[FaceKeys], edges: &[Edge]) -> Result<Vec<Face>, ImportError> {
    if let Some(extra) = keys.get(MAX_PARTS) {
        return Err(too_many(source, extra.name.span(), "faces", keys.len()));
    }
    let by_name: HashMap<&str, usize> = edges
        .iter()
        .enumerate()
        .map(|(index, edge)| (edge.name.as_str(), index))
        .collect();
    let mut names = HashMap::new();
    let mut faces = vec![];
    for key in keys {
        unique(source, &mut names, &key.name, "face")?;
        let surface = surface(source, &key.surface)?;
        let mut loops = vec![];
        for list in &key.loops {
            loops.push(edge_loop(source, list, &by_name, edges)?);
        }
        if loops.is_empty()
            && !matches!(
                surface,
                Surface::Sphere { .. } | Surface::Torus { .. } | Surface::Other(_)
            )
        {
            return Err(source.error(
                key.name.span(),
                format!(
                    "face `{}` has no loop, and a {} is endless",
                    key.name.as_ref(),
                    surface.name()
                ),
                "`loops = [[\"edge\", ...], ...]` is needed; a whole sphere or torus alone has none",
            ));
        }
        faces.push(Face {
            name: key.name.as_ref().clone(),
            surface,
            loops,
            reversed: key.reversed,
            material: None,
            off: 0.0,
            refused: None,
        });
    }
    Ok(faces)
}

/// The edges of a loop, each of which begins where the one before it ends.
fn edge_loop(
    source: &Source,
    list: &Spanned<Vec<Spanned<String>>>,
    by_name: &HashMap<&str, usize>,
    edges: &[Edge],
) -> Result<Vec<EdgeUse>, ImportError> {
    let mut uses = vec![];
    for name in list.as_ref() {
        let (plain, forward) = match name.as_ref().strip_prefix('-') {
            Some(plain) => (plain, false),
            None => (name.as_ref().as_str(), true),
        };
        let Some(edge) = by_name.get(plain) else {
            return Err(source.error(
                name.span(),
                format!("`{plain}` is not an edge of this list"),
                "the name of an edge, with `-` in front if it is passed from its end to its start, is needed",
            ));
        };
        uses.push(EdgeUse {
            edge: *edge,
            forward,
        });
    }
    let Some(first) = uses.first() else {
        return Err(source.error(
            list.span(),
            "the loop has no edge",
            "at least one edge is needed",
        ));
    };
    if edges[first.edge].vertices.is_none() && uses.len() == 1 {
        return Ok(uses);
    }
    for (index, edge_use) in uses.iter().enumerate() {
        let next = uses[(index + 1) % uses.len()];
        let name = &list.as_ref()[index];
        let ends = |u: EdgeUse| {
            let vertices = edges[u.edge].vertices;
            vertices.map(|[a, b]| if u.forward { [a, b] } else { [b, a] })
        };
        let (Some([_, end]), Some([start, _])) = (ends(*edge_use), ends(next)) else {
            return Err(source.error(
                name.span(),
                format!(
                    "a closed edge stands in one loop with others, at `{}`",
                    name.as_ref()
                ),
                "a closed edge is a loop of its own",
            ));
        };
        if end != start {
            let after = list.as_ref()[(index + 1) % uses.len()].as_ref();
            return Err(source.error(
                name.span(),
                format!("`{}` does not end where `{after}` begins", name.as_ref()),
                "the edges of a loop follow each other from vertex to vertex and come back to the first",
            ));
        }
    }
    Ok(uses)
}

fn materials(source: &Source, keys: &[Spanned<Material>]) -> Result<Vec<Material>, ImportError> {
    let mut names = HashMap::new();
    for material in keys {
        let name = Spanned::new(material.span(), material.as_ref().name.clone());
        unique(source, &mut names, &name, "material")?;
        let m = material.as_ref();
        let shares = [m.ambient, m.diffuse, m.specular];
        let all = shares.iter().chain(&m.colour);
        if let Some(value) = all.into_iter().find(|v| !(0.0..=1.0).contains(*v)) {
            return Err(source.error(
                material.span(),
                format!("{value} in material `{}` is out of range", m.name),
                "colours and shares are numbers from 0 to 1",
            ));
        }
    }
    Ok(keys.iter().map(|m| m.as_ref().clone()).collect())
}

fn solids(
    source: &Source,
    keys: &[SolidKeys],
    faces: &[FaceKeys],
    materials: &[Material],
) -> Result<Vec<Solid>, ImportError> {
    let index: HashMap<&str, usize> = faces
        .iter()
        .enumerate()
        .map(|(index, face)| (face.name.as_ref().as_str(), index))
        .collect();
    let mut owners = vec![false; faces.len()];
    let mut names = HashMap::new();
    let mut solids = vec![];
    for key in keys {
        unique(source, &mut names, &key.name, "solid")?;
        if !materials.iter().any(|m| m.name == *key.material.as_ref()) {
            return Err(source.error(
                key.material.span(),
                format!("`{}` is not a material of this list", key.material.as_ref()),
                "the name of an entry of `[[materials]]` is needed",
            ));
        }
        let mut own = vec![];
        for name in &key.faces {
            let face = index.get(name.as_ref().as_str()).copied();
            let free = face.filter(|face| !std::mem::replace(&mut owners[*face], true));
            let Some(face) = free else {
                let problem = match face {
                    None => format!("`{}` is not a face of this list", name.as_ref()),
                    Some(_) => format!("face `{}` has a solid already", name.as_ref()),
                };
                return Err(source.error(
                    name.span(),
                    problem,
                    "every face belongs to exactly one solid",
                ));
            };
            own.push(face);
        }
        solids.push(Solid {
            name: key.name.as_ref().clone(),
            material: key.material.as_ref().clone(),
            faces: own,
        });
    }
    if let Some(lost) = owners.iter().position(|owned| !owned) {
        let name = &faces[lost].name;
        return Err(source.error(
            name.span(),
            format!("face `{}` belongs to no solid", name.as_ref()),
            "every face belongs to exactly one of `[[solids]]`",
        ));
    }
    Ok(solids)
}

/// Least and greatest coordinates of points; nothing without points.
pub fn hull(points: impl Iterator<Item = Vector>) -> Option<[Vector; 2]> {
    points.fold(None, |bounds, p| {
        let [low, high] = bounds.unwrap_or([p, p]);
        Some([
            std::array::from_fn(|k| p[k].min(low[k])),
            std::array::from_fn(|k| p[k].max(high[k])),
        ])
    })
}
