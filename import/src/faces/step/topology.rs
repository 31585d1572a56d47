//! Shells, faces, loops, edges and vertices (ISO 10303-42, clause 5).

use super::curves::{Span, placed};
use super::placement::{Placement, point};
use super::surfaces::surface;
use super::units::Context;
use crate::faces::build::MAX_PARTS;
use crate::faces::canonical::Found;
use crate::faces::cell::Made;
use crate::faces::model::{border, reversed};
use crate::faces::vector::{Vector, distance, dot, length, minus};
use crate::faces::{Curve, Edge, EdgeUse, Face, Form, Model, Solid, Surface};
use std::collections::HashMap;
use step21::{Args, Entity, Error, Result};

/// Share of a file's extent by which a surface may be off a quadric; what a part allows is known when it is read.
const CANONICAL: f64 = 1e-5;
/// Share of their distance from the origin, or of a millimetre, within which two vertices are at one place.
const SAME_PLACE: f64 = 1e-7;
/// Most edges of all loops together.
const MAX_USES: usize = 200_000;

/// A representation where it is placed: its edges and vertices are its own.
pub struct Space {
    pub context: Context,
    pub place: Placement,
    pub known: Known,
}

#[derive(Default)]
pub struct Known {
    /// Edges by their number, or why they are none.
    edges: HashMap<u64, Made<usize>>,
    vertices: HashMap<u64, usize>,
    /// Straight edges of polygons by the numbers of their points, the lower first.
    sides: HashMap<[u64; 2], usize>,
    surfaces: HashMap<u64, Found>,
}

type Loop = Vec<EdgeUse>;

pub const SHELLS: [&str; 3] = ["CLOSED_SHELL", "OPEN_SHELL", "CONNECTED_FACE_SET"];

/// What has been read of the part.
#[derive(Debug, Default)]
pub struct Topology {
    /// Its edges, faces, solids and materials.
    pub model: Model,
    /// Places of vertices in the spaces of their representations.
    vertices: Vec<Vector>,
    /// Edges, faces and edges in loops up to which this file may go.
    most: [usize; 3],
    uses: usize,
}

fn too_many(what: &str, most: usize) -> Error {
    Error::whole(
        format!("more than {most} {what}, parts that are placed often counted as often"),
        "a smaller assembly is needed",
    )
}

impl Topology {
    /// Goes on to another file, whose edges and faces are counted anew.
    pub fn next_file(&mut self) {
        let Model { edges, faces, .. } = &self.model;
        let [edges, faces] = [edges.len(), faces.len()].map(|count| count + MAX_PARTS);
        self.most = [edges, faces, self.uses + MAX_USES];
    }

    /// Adds the faces of shells as one solid; the numbers of each face and its shell.
    pub fn solid(
        &mut self,
        space: &mut Space,
        shells: &[Entity],
        name: String,
        material: String,
    ) -> Result<Vec<[u64; 2]>> {
        let first = self.model.faces.len();
        let mut origins = vec![];
        for shell in shells {
            origins.extend(self.shell(space, *shell)?);
        }
        self.model.solids.push(Solid {
            name,
            material,
            faces: (first..self.model.faces.len()).collect(),
        });
        Ok(origins)
    }

    /// Adds the faces of a shell; the numbers of each face and the shell.
    fn shell(&mut self, space: &mut Space, entity: Entity) -> Result<Vec<[u64; 2]>> {
        let oriented = ["ORIENTED_CLOSED_SHELL", "ORIENTED_OPEN_SHELL"];
        let (shell, outwards) = match entity.find(&oriented) {
            Some(args) => (args.named(2, &SHELLS)?, args.flag(3)?),
            None => (entity.need(&SHELLS)?, true),
        };
        let mut origins = vec![];
        for value in shell.list(1)? {
            if self.model.faces.len() == self.most[1] {
                return Err(too_many("faces", MAX_PARTS));
            }
            let (id, face) = match shell.as_entity(value) {
                Ok(entity) => (entity.id, self.face(space, entity, outwards)),
                Err(error) => (0, Err(error)),
            };
            // A bad face costs itself.
            let face = face.unwrap_or_else(|error| Face {
                name: format!("#{id}"),
                surface: Surface::other("face"),
                refused: Some(error.to_string()),
                ..Face::default()
            });
            self.model.faces.push(face);
            origins.push([id, entity.id]);
        }
        Ok(origins)
    }

    /// A face; `outwards` says that its normal leaves the solid.
    fn face(&mut self, space: &mut Space, mut entity: Entity, mut outwards: bool) -> Result<Face> {
        if let Some(args) = entity.find(&["ORIENTED_FACE"]) {
            outwards = outwards == args.flag(3)?;
            entity = args.entity(2)?;
        }
        let args = entity.need(&["ADVANCED_FACE", "FACE_SURFACE"])?;
        let same_sense = args.flag(3)?;
        let found = self.surface(space, args.entity(2)?)?;
        let (mut surface, mut refused) = (found.surface, found.refused);
        // The surface's own normal is that of the quadric from here on.
        let same_sense = same_sense != found.opposite;
        let mut loops = vec![];
        for bound in args.entities(1)? {
            let bound = bound.need(&["FACE_BOUND", "FACE_OUTER_BOUND"])?;
            match self.bound(space, &bound, same_sense)? {
                Ok(uses) if uses.is_empty() => {}
                Ok(uses) => loops.push(uses),
                Err(reason) => refused = refused.or(Some(reason)),
            }
        }
        let border = border(loops.iter().flatten().copied());
        match surface.form {
            // Its seam alone bounds nothing.
            Form::Sphere(_) | Form::Torus(..) if border.is_empty() => loops.clear(),
            Form::Other(_) => {}
            _ if border.is_empty() && refused.is_none() => {
                let name = surface.name();
                refused = Some(format!("it has no border, and a {name} is endless"));
            }
            Form::Cone(_) => {
                // The axis goes to the side of the apex on which the edges are.
                let height = |p: &Vector| dot(minus(*p, surface.origin), surface.axis);
                let places = self.model.places(&border, 8);
                if places.iter().map(height).sum::<f64>() < 0.0 {
                    surface.axis = surface.axis.map(|v| 0.0 - v);
                }
            }
            Form::Torus(major, minor) => {
                surface.form = self.nearer_part(&surface, major, minor, &loops);
            }
            _ => {}
        }
        if refused.is_some() {
            surface = Surface::other(surface.name());
        }
        let label = args.text(0);
        Ok(Face {
            name: match label.as_str() {
                "" | "NONE" => format!("#{}", entity.id),
                label => format!("{label} #{}", entity.id),
            },
            surface,
            loops,
            reversed: same_sense != outwards,
            material: None,
            off: found.off,
            refused,
        })
    }

    /// A surface; each is looked at once in a representation.
    fn surface(&mut self, space: &mut Space, entity: Entity) -> Result<Found> {
        if let Some(known) = space.known.surfaces.get(&entity.id) {
            return Ok(known.clone());
        }
        let tolerance = CANONICAL * space.context.extent;
        let found = surface(entity, &space.context, &space.place, tolerance, 0)?;
        space.known.surfaces.insert(entity.id, found.clone());
        Ok(found)
    }

    /// A torus that meets its axis has an outer and an inner part: that on which the border is.
    fn nearer_part(&self, torus: &Surface, major: f64, minor: f64, loops: &[Loop]) -> Form {
        let inner = Surface::new(torus.origin, torus.axis, Form::Torus(-major, minor));
        let off = |surface: &Surface| -> f64 {
            let points = self.model.places(loops.iter().flatten(), 8).into_iter();
            let distances = points.filter_map(|p| Some(distance(p, surface.nearest(p)?)));
            distances.sum()
        };
        match minor > major && off(&inner) < off(torus) {
            true => inner.form,
            false => torus.form.clone(),
        }
    }

    /// The edges of a border, with its face on their left; none for a border that is a point.
    fn bound(&mut self, space: &mut Space, args: &Args, same_sense: bool) -> Result<Made<Loop>> {
        let entity = args.entity(1)?;
        // The left of a loop is that of the face's own normal.
        let forward = args.flag(2)? == same_sense;
        let args = entity.need(&["EDGE_LOOP", "VERTEX_LOOP", "POLY_LOOP"])?;
        let uses = match args.record.name {
            "VERTEX_LOOP" => args.named(1, &["VERTEX_POINT"]).map(|_| Ok(vec![])),
            "POLY_LOOP" => self.polygon(space, &args).map(Ok),
            _ => self.edge_loop(space, &args),
        };
        Ok(uses?.map(|uses| if forward { uses } else { reversed(&uses) }))
    }

    fn edge_loop(&mut self, space: &mut Space, args: &Args) -> Result<Made<Loop>> {
        let mut uses = vec![];
        let mut refused = None;
        for entity in args.entities(1)? {
            self.uses += 1;
            if self.uses > self.most[2] {
                return Err(too_many("edges in loops", MAX_USES));
            }
            let oriented = entity.need(&["ORIENTED_EDGE"])?;
            let (edge, forward) = (oriented.entity(3)?, oriented.flag(4)?);
            match self.edge(space, edge)? {
                Ok(edge) => uses.push((EdgeUse { edge, forward }, entity.id)),
                Err(reason) => refused = refused.or(Some(reason)),
            }
        }
        let refused = refused.or_else(|| self.check_chain(args, &uses).err());
        let uses = uses.into_iter().map(|(edge_use, _)| edge_use).collect();
        Ok(refused.map_or(Ok(uses), Err))
    }

    /// The sides of a polygon; those that two polygons share are one edge.
    fn polygon(&mut self, space: &mut Space, args: &Args) -> Result<Loop> {
        let points = args.entities(1)?;
        let mut uses = vec![];
        for (index, from) in points.iter().enumerate() {
            let to = points[(index + 1) % points.len()];
            if self.model.edges.len() == self.most[0] {
                return Err(too_many("edges", MAX_PARTS));
            }
            let place = |entity| point(entity, &space.context);
            let ends = [place(*from)?, place(to)?].map(|p| space.place.point(p));
            if ends[0] == ends[1] {
                continue;
            }
            let key = [from.id.min(to.id), from.id.max(to.id)];
            let forward = from.id == key[0];
            let [from, to] = if forward { ends } else { [ends[1], ends[0]] };
            let edge = *space.known.sides.entry(key).or_insert_with(|| {
                let name = format!("#{}-#{}", key[0], key[1]);
                self.add(name, Curve::Line { from, to }, None)
            });
            uses.push(EdgeUse { edge, forward });
        }
        Ok(uses)
    }

    /// Why a loop is none: its edges do not follow each other. Two vertices at one place are one.
    fn check_chain(&self, args: &Args, uses: &[(EdgeUse, u64)]) -> Made<()> {
        let place = format!("`#{}` EDGE_LOOP", args.entity.id);
        if uses.is_empty() {
            return Err(format!(
                "{place}: it has no edge; at least one edge is needed"
            ));
        }
        let ends = |own: EdgeUse| {
            let [from, to] = self.model.edges[own.edge].vertices.unwrap_or_default();
            if own.forward { [from, to] } else { [to, from] }
        };
        for (index, (edge_use, id)) in uses.iter().enumerate() {
            let (next, after) = uses[(index + 1) % uses.len()];
            let [from, to] = [ends(*edge_use)[1], ends(next)[0]];
            if from != to && !self.same_place(from, to) {
                return Err(format!(
                    "{place}: `#{id}` does not end where `#{after}` begins; \
                     the edges of a loop follow each other from vertex to vertex and come back to the first"
                ));
            }
        }
        Ok(())
    }

    /// Two vertices that the digits of their file do not tell apart.
    fn same_place(&self, one: usize, other: usize) -> bool {
        let [p, q] = [self.vertices[one], self.vertices[other]];
        distance(p, q) <= SAME_PLACE * length(p).max(length(q)).max(1.0)
    }

    fn vertex(&mut self, space: &mut Space, args: &Args, index: usize) -> Result<usize> {
        let vertex = args.named(index, &["VERTEX_POINT"])?;
        if let Some(known) = space.known.vertices.get(&vertex.entity.id) {
            return Ok(*known);
        }
        let index = self.vertices.len();
        self.vertices
            .push(point(vertex.entity(1)?, &space.context)?);
        space.known.vertices.insert(vertex.entity.id, index);
        Ok(index)
    }

    fn edge(&mut self, space: &mut Space, entity: Entity) -> Result<Made<usize>> {
        if let Some(known) = space.known.edges.get(&entity.id) {
            return Ok(known.clone());
        }
        if self.model.edges.len() == self.most[0] {
            return Err(too_many("edges", MAX_PARTS));
        }
        let args = entity.need(&["EDGE_CURVE"])?;
        let vertices = [self.vertex(space, &args, 1)?, self.vertex(space, &args, 2)?];
        let span = Span {
            context: &space.context,
            ends: vertices.map(|index| self.vertices[index]),
            closed: vertices[0] == vertices[1] || self.same_place(vertices[0], vertices[1]),
            forward: args.flag(4)?,
        };
        let name = format!("#{}", entity.id);
        let curve = args.entity(3).map_err(String::from);
        let edge = match curve.and_then(|curve| span.of(curve)) {
            Ok(curve) => Ok(self.add(name, placed(curve, &space.place), Some(vertices))),
            // Other faces of the edge are refused with the same words.
            Err(reason) => Err(format!("edge `{name}`: {reason}")),
        };
        space.known.edges.insert(entity.id, edge.clone());
        Ok(edge)
    }

    /// The index of a new edge.
    fn add(&mut self, name: String, curve: Curve, vertices: Option<[usize; 2]>) -> usize {
        self.model.edges.push(Edge {
            name,
            curve,
            off: 0.0,
            vertices,
        });
        self.model.edges.len() - 1
    }
}
