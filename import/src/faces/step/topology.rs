//! Shells, faces, loops, edges and vertices (ISO 10303-42, clause 5).

use super::args::Args;
use super::curves::{Span, placed};
use super::exchange::{Entity, Exchange};
use super::placement::{Placement, point};
use super::surfaces::surface;
use super::units::Context;
use crate::ImportError;
use crate::faces::build::MAX_PARTS;
use crate::faces::model::{Edge, EdgeUse, Face, Solid, border};
use crate::faces::surface::Surface;
use crate::faces::vector::{Vector, dot, minus};
use std::collections::HashMap;

/// Most edges of all loops together.
const MAX_USES: usize = 200_000;

/// A representation where it is placed: its edges and vertices are its own.
#[derive(Debug)]
pub struct Space {
    context: Context,
    place: Placement,
    /// Edges by their number, or why they are none.
    edges: HashMap<u64, Result<usize, String>>,
    /// Vertices by their number.
    vertices: HashMap<u64, usize>,
}

impl Space {
    /// Of a context and a placement.
    pub fn new(context: Context, place: Placement) -> Self {
        Self {
            context,
            place,
            edges: HashMap::new(),
            vertices: HashMap::new(),
        }
    }
}

/// What has been read of the part.
#[derive(Debug)]
pub struct Topology<'e, 'a> {
    file: &'e Exchange<'a>,
    /// Edges.
    pub edges: Vec<Edge>,
    /// Faces.
    pub faces: Vec<Face>,
    /// Solids.
    pub solids: Vec<Solid>,
    /// Places of vertices in the spaces of their representations.
    vertices: Vec<Vector>,
    uses: usize,
}

impl<'e, 'a> Topology<'e, 'a> {
    /// Nothing yet.
    pub fn new(file: &'e Exchange<'a>) -> Self {
        Self {
            file,
            edges: vec![],
            faces: vec![],
            solids: vec![],
            vertices: vec![],
            uses: 0,
        }
    }

    fn too_many(&self, what: &str, most: usize) -> ImportError {
        self.file.source.unusable(
            format!("more than {most} {what}, parts that are placed often counted as often"),
            "a smaller assembly is needed",
        )
    }

    /// Adds the faces of shells as one solid.
    pub fn solid(
        &mut self,
        space: &mut Space,
        shells: &[&'e Entity<'a>],
        name: String,
        material: String,
    ) -> Result<(), ImportError> {
        let first = self.faces.len();
        for shell in shells {
            self.shell(space, shell)?;
        }
        self.solids.push(Solid {
            name,
            material,
            faces: (first..self.faces.len()).collect(),
        });
        Ok(())
    }

    fn shell(&mut self, space: &mut Space, entity: &'e Entity<'a>) -> Result<(), ImportError> {
        let oriented = ["ORIENTED_CLOSED_SHELL", "ORIENTED_OPEN_SHELL"];
        let plain = ["CLOSED_SHELL", "OPEN_SHELL", "CONNECTED_FACE_SET"];
        let (shell, outwards) = match self.file.find(entity, &oriented) {
            Some(args) => (args.named(2, &plain)?, args.flag(3)?),
            None => (self.file.need(entity, &plain)?, true),
        };
        for entity in shell.entities(1)? {
            let (face, own) = match self.file.find(entity, &["ORIENTED_FACE"]) {
                Some(args) => (args.entity(2)?, args.flag(3)?),
                None => (entity, true),
            };
            self.face(space, face, outwards == own)?;
        }
        Ok(())
    }

    /// A face; `outwards` says that its normal leaves the solid.
    fn face(
        &mut self,
        space: &mut Space,
        entity: &'e Entity<'a>,
        outwards: bool,
    ) -> Result<(), ImportError> {
        if self.faces.len() == MAX_PARTS {
            return Err(self.too_many("faces", MAX_PARTS));
        }
        let args = self.file.need(entity, &["ADVANCED_FACE", "FACE_SURFACE"])?;
        let same_sense = args.flag(3)?;
        let (mut surface, mut refused) =
            surface(self.file, args.entity(2)?, &space.context, &space.place)?;
        let mut loops = vec![];
        for bound in args.entities(1)? {
            let bound = self.file.need(bound, &["FACE_BOUND", "FACE_OUTER_BOUND"])?;
            match self.bound(space, &bound)? {
                Ok(uses) if uses.is_empty() => {}
                // The left of a loop is that of the face's own normal.
                Ok(uses) if same_sense => loops.push(uses),
                Ok(uses) => loops.push(reversed(uses)),
                Err(reason) => refused = refused.or(Some(reason)),
            }
        }
        let bare = border(loops.iter().flatten().copied()).is_empty();
        match &mut surface {
            // Its seam alone bounds nothing.
            Surface::Sphere { .. } if bare => loops.clear(),
            Surface::Other(_) => {}
            other if bare && refused.is_none() => {
                refused = Some(format!(
                    "it has no border, and a {} is endless",
                    other.name()
                ));
            }
            Surface::Cone { apex, axis, .. } if self.is_behind(&loops, *apex, *axis) => {
                *axis = axis.map(|v| 0.0 - v);
            }
            _ => {}
        }
        if refused.is_some() {
            surface = Surface::Other(surface.name().to_owned());
        }
        let label = args.text(0);
        self.faces.push(Face {
            name: if label.is_empty() || label == "NONE" {
                format!("#{}", entity.id)
            } else {
                format!("{label} #{}", entity.id)
            },
            surface,
            loops,
            reversed: same_sense != outwards,
            refused,
        });
        Ok(())
    }

    /// Whether edges are on the side of an apex from which the axis comes.
    fn is_behind(&self, loops: &[Vec<EdgeUse>], apex: Vector, axis: Vector) -> bool {
        let edges = border(loops.iter().flatten().copied());
        let points = edges
            .iter()
            .flat_map(|edge_use| self.edges[edge_use.edge].curve.sampled(8));
        points.map(|p| dot(minus(p, apex), axis)).sum::<f64>() < 0.0
    }

    /// The edges of a border, with its face on their left; none for a border that is a point.
    fn bound(
        &mut self,
        space: &mut Space,
        args: &Args<'e, 'a>,
    ) -> Result<Result<Vec<EdgeUse>, String>, ImportError> {
        let entity = args.entity(1)?;
        let forward = args.flag(2)?;
        if let Some(vertex) = self.file.find(entity, &["VERTEX_LOOP"]) {
            vertex.named(1, &["VERTEX_POINT"])?;
            return Ok(Ok(vec![]));
        }
        if self.file.find(entity, &["POLY_LOOP"]).is_some() {
            return Ok(Err("a border that is a POLY_LOOP is not read".into()));
        }
        let args = self
            .file
            .need(entity, &["EDGE_LOOP", "VERTEX_LOOP", "POLY_LOOP"])?;
        let mut uses = vec![];
        let mut refused = None;
        for entity in args.entities(1)? {
            self.uses += 1;
            if self.uses > MAX_USES {
                return Err(self.too_many("edges in loops", MAX_USES));
            }
            let oriented = self.file.need(entity, &["ORIENTED_EDGE"])?;
            let (edge, forward) = (oriented.entity(3)?, oriented.flag(4)?);
            match self.edge(space, edge)? {
                Ok(edge) => uses.push((EdgeUse { edge, forward }, entity.id)),
                Err(reason) => refused = refused.or(Some(reason)),
            }
        }
        if let Some(reason) = refused {
            return Ok(Err(reason));
        }
        self.check_chain(&args, &uses)?;
        let uses = uses.into_iter().map(|(edge_use, _)| edge_use).collect();
        Ok(Ok(if forward { uses } else { reversed(uses) }))
    }

    /// Refuses a loop whose edges do not follow each other.
    fn check_chain(&self, args: &Args, uses: &[(EdgeUse, u64)]) -> Result<(), ImportError> {
        if uses.is_empty() {
            return Err(args.error("it has no edge", "at least one edge is needed"));
        }
        let ends = |edge_use: EdgeUse| {
            let [from, to] = self.edges[edge_use.edge].vertices.unwrap_or_default();
            if edge_use.forward {
                [from, to]
            } else {
                [to, from]
            }
        };
        for (index, (edge_use, id)) in uses.iter().enumerate() {
            let (next, after) = uses[(index + 1) % uses.len()];
            if ends(*edge_use)[1] != ends(next)[0] {
                return Err(args.error(
                    format!("`#{id}` does not end where `#{after}` begins"),
                    "the edges of a loop follow each other from vertex to vertex and come back to the first",
                ));
            }
        }
        Ok(())
    }

    fn vertex(
        &mut self,
        space: &mut Space,
        args: &Args<'e, 'a>,
        index: usize,
    ) -> Result<usize, ImportError> {
        let vertex = args.named(index, &["VERTEX_POINT"])?;
        if let Some(known) = space.vertices.get(&vertex.entity.id) {
            return Ok(*known);
        }
        let place = point(self.file, vertex.entity(1)?, &space.context)?;
        self.vertices.push(place);
        let index = self.vertices.len() - 1;
        space.vertices.insert(vertex.entity.id, index);
        Ok(index)
    }

    fn edge(
        &mut self,
        space: &mut Space,
        entity: &'e Entity<'a>,
    ) -> Result<Result<usize, String>, ImportError> {
        if let Some(known) = space.edges.get(&entity.id) {
            return Ok(known.clone());
        }
        if self.edges.len() == MAX_PARTS {
            return Err(self.too_many("edges", MAX_PARTS));
        }
        let args = self.file.need(entity, &["EDGE_CURVE"])?;
        let vertices = [self.vertex(space, &args, 1)?, self.vertex(space, &args, 2)?];
        let span = Span {
            file: self.file,
            context: &space.context,
            ends: vertices.map(|index| self.vertices[index]),
            closed: vertices[0] == vertices[1],
            forward: args.flag(4)?,
        };
        let found = span.of(args.entity(3)?)?;
        let edge = found
            .map(|(kind, curve)| {
                self.edges.push(Edge {
                    name: format!("#{}", entity.id),
                    kind,
                    curve: placed(curve, &space.place),
                    vertices: Some(vertices),
                });
                self.edges.len() - 1
            })
            .map_err(|reason| format!("edge `#{}`: {reason}", entity.id));
        space.edges.insert(entity.id, edge.clone());
        Ok(edge)
    }
}

/// A loop the other way round.
fn reversed(uses: Vec<EdgeUse>) -> Vec<EdgeUse> {
    uses.into_iter()
        .rev()
        .map(|edge_use| EdgeUse {
            forward: !edge_use.forward,
            ..edge_use
        })
        .collect()
}
