//! STEP files (ISO 10303-21) with boundary representations of AP203, AP214 and AP242.
//!
//! The structure of the file is read by [`exchange`], what its entities mean by the other modules; the result is the
//! model that a face list gives. Lengths become millimetres.

mod args;
mod assembly;
mod colours;
mod curves;
mod exchange;
mod external;
mod freeform;
mod knots;
mod placement;
mod source;
mod spline;
mod surfaces;
mod text;
mod token;
mod topology;
mod units;

use super::assemble::{Parts, assemble};
use super::model::{Edge, Face, Model, Solid, Up};
use crate::ImportError;
use args::Args;
use assembly::{Assembly, Placed};
use colours::{Colour, Palette, colours};
use exchange::{Entity, Exchange};
use external::external;
use imogene_studies::text::counted;
use placement::Placement;
use serde::Serialize;
use source::Source;
use std::collections::{BTreeMap, HashMap, HashSet};
use topology::{SHELLS, Space, Topology};

/// What the reader says of a file besides its model; the keys are stable.
#[derive(Debug, Default, Serialize)]
pub struct Summary {
    /// What the header calls the schema.
    pub schema: Vec<String>,
    /// Number of entities.
    pub entities: usize,
    /// Faces of the file that are part of a shell, each counted once.
    pub faces: usize,
    /// The same, as often as their solids are placed: all faces of the model.
    pub placed_faces: usize,
    /// Faces of shells that no product places, as those of validation properties.
    pub unplaced_faces: usize,
    /// What is no shell and was left out: entities by their name.
    pub left_out: BTreeMap<String, usize>,
    /// Parts and placements that are missing, and why.
    pub missing: Vec<String>,
    /// Files beside this one whose parts are placed in it.
    pub files: Vec<String>,
}

impl Summary {
    /// Lines for a person.
    pub fn notes(&self) -> Vec<String> {
        let mut notes: Vec<String> = self
            .left_out
            .iter()
            .map(|(name, count)| format!("{count} {name} left out: faces alone are drawn"))
            .collect();
        notes.extend(self.missing.iter().cloned());
        if self.unplaced_faces > 0 {
            notes.push(format!(
                "{} of properties left out: no product places them",
                counted(self.unplaced_faces, "face")
            ));
        }
        notes
    }

    fn add(&mut self, other: Summary) {
        self.entities += other.entities;
        self.faces += other.faces;
        self.placed_faces += other.placed_faces;
        self.unplaced_faces += other.unplaced_faces;
        for (name, count) in other.left_out {
            *self.left_out.entry(name).or_default() += count;
        }
        self.missing.extend(other.missing);
        self.files.extend(other.files);
    }
}

/// Items that have no faces of their own and are expected beside solids.
const SILENT: [&str; 3] = ["AXIS2_PLACEMENT_3D", "MAPPED_ITEM", "CARTESIAN_POINT"];
/// Most files that place each other's parts.
const DEEPEST_FILE: usize = 8;

/// Reads the file of a name that stands beside the first; nothing if there is none.
pub type Beside<'b> = &'b dyn Fn(&str) -> Option<Vec<u8>>;

/// Reads a STEP file.
pub fn build(bytes: &[u8], file: &str, beside: Beside) -> Result<(Model, Summary), ImportError> {
    let source = Source { file, bytes };
    let mut found = Found::default();
    let mut summary = found.read(source, Placement::IN_PLACE, beside, 0)?;
    if found.faces.is_empty() {
        return Err(source.unusable(
            nothing(&summary),
            "a MANIFOLD_SOLID_BREP, BREP_WITH_VOIDS or SHELL_BASED_SURFACE_MODEL is needed",
        ));
    }
    summary.placed_faces = found.faces.len();
    let parts = Parts {
        title: if found.title.is_empty() {
            "A part".into()
        } else {
            found.title
        },
        up: Up::Z,
        precision: found.precision,
        uncertainty: found.uncertainty,
        materials: found.palette.materials,
        edges: found.edges,
        faces: found.faces,
        solids: found.solids,
    };
    let model = assemble(parts).ok_or_else(|| {
        source.unusable(
            "the faces have no size",
            "a box around them of at least a millionth of a millimetre is needed",
        )
    })?;
    Ok((model, summary))
}

/// Why a file has no face.
fn nothing(summary: &Summary) -> String {
    if !summary.missing.is_empty() {
        return format!("no part is left: {}", summary.missing.join("; "));
    }
    let others: Vec<&str> = summary.left_out.keys().map(String::as_str).collect();
    format!("no shape representation has a face; its items are {others:?}")
}

/// What has been found in a file and in those beside it.
#[derive(Default)]
struct Found {
    title: String,
    palette: Palette,
    edges: Vec<Edge>,
    faces: Vec<Face>,
    solids: Vec<Solid>,
    /// Names of solids that are taken, and how often.
    names: HashMap<String, usize>,
    /// The greatest of the representations that have faces, millimetres.
    uncertainty: f64,
    /// What the digits of coordinates leave open, millimetres.
    precision: f64,
}

impl Found {
    fn read(
        &mut self,
        source: Source,
        base: Placement,
        beside: Beside,
        depth: usize,
    ) -> Result<Summary, ImportError> {
        let exchange = Exchange::parse(source)?;
        let assembly = Assembly::read(&exchange);
        let placed = assembly.placed()?;
        let (colours, grey) = colours(&exchange);
        let mut reader = Reader {
            file: &exchange,
            colours,
            found: self,
            topology: Topology::new(&exchange),
            seen: HashSet::new(),
            placed: HashMap::new(),
            summary: Summary {
                schema: schema(&exchange),
                entities: exchange.entities.len(),
                missing: assembly.notes.clone(),
                ..Summary::default()
            },
        };
        reader.summary.missing.extend(grey);
        for part in &placed {
            let place = base.after(&part.place);
            if let Err(error) = reader.representation(&assembly, part, place) {
                reader.leave_out(assembly.name(part.group), &error);
            }
        }
        let mut summary = reader.finish();
        if self.title.is_empty() {
            let first = placed.first();
            self.title = first
                .map_or("", |part| assembly.name(part.group))
                .to_owned();
        }
        let mut done = HashSet::new();
        for part in &placed {
            if !done.insert(part.occurrence) {
                continue;
            }
            for name in external(&exchange, assembly.product_of(part.group)) {
                let place = base.after(&part.place);
                let other = beside(&name).filter(|_| depth < DEEPEST_FILE);
                let Some(bytes) = other else {
                    summary.missing.push(format!(
                        "part `{}` is in the file `{name}`, which is not beside this one",
                        assembly.name(part.group)
                    ));
                    continue;
                };
                let inner = Source {
                    file: &name,
                    bytes: &bytes,
                };
                match self.read(inner, place, beside, depth + 1) {
                    Ok(inner) => summary.add(inner),
                    Err(error) => summary.missing.push(error.to_string()),
                }
                if !summary.files.contains(&name) {
                    summary.files.push(name);
                }
            }
        }
        Ok(summary)
    }
}

/// The first words of the names of the schemas.
fn schema(file: &Exchange) -> Vec<String> {
    let record = file.header.iter().find(|r| r.name == "FILE_SCHEMA");
    let names = record.and_then(|record| match &record.values.first()?.kind {
        exchange::Kind::List(values) => Some(values),
        _ => None,
    });
    names
        .into_iter()
        .flatten()
        .filter_map(|value| match value.kind {
            exchange::Kind::Text(name) => Some(text::decoded(name)),
            _ => None,
        })
        .map(|name| name.split_whitespace().next().unwrap_or("").to_owned())
        .collect()
}

struct Reader<'f, 'e, 'a> {
    file: &'e Exchange<'a>,
    colours: HashMap<u64, Colour>,
    found: &'f mut Found,
    topology: Topology<'e, 'a>,
    /// Items by the placement that has them already.
    seen: HashSet<(usize, u64)>,
    /// For each item that is drawn, how many faces it has.
    placed: HashMap<u64, usize>,
    summary: Summary,
}

impl<'e, 'a> Reader<'_, 'e, 'a> {
    fn representation(
        &mut self,
        assembly: &Assembly<'e, 'a>,
        part: &Placed<'e, 'a>,
        place: Placement,
    ) -> Result<(), ImportError> {
        let context = assembly.context(&part.representation)?;
        let mut space = Space::new(context, place);
        for item in part.representation.list(1)? {
            let solid = part
                .representation
                .as_entity(item)
                .and_then(|item| self.item(assembly, part, &mut space, item));
            if let Err(error) = solid {
                self.leave_out(assembly.name(part.group), &error);
            }
        }
        Ok(())
    }

    fn item(
        &mut self,
        assembly: &Assembly<'e, 'a>,
        part: &Placed<'e, 'a>,
        space: &mut Space,
        item: &'e Entity<'a>,
    ) -> Result<(), ImportError> {
        if !self.seen.insert((part.occurrence, item.id)) {
            return Ok(());
        }
        let shells = self.shells(item)?;
        if shells.is_empty() {
            let silent = |name: &&str| self.file.find(item, &[name]).is_some();
            if !SILENT.iter().any(silent) {
                *self.summary.left_out.entry(item.name()).or_default() += 1;
            }
            return Ok(());
        }
        self.found.uncertainty = self.found.uncertainty.max(space.uncertainty());
        self.found.precision = self.found.precision.max(space.precision(self.file));
        let name = self.name_of(assembly.name(part.group), item);
        let own = self.colours.get(&item.id).copied();
        let material = self.found.palette.material(own);
        let first = self.topology.faces.len();
        self.topology.solid(space, &shells, name, material)?;
        self.colour(own, &shells, first);
        self.placed
            .insert(item.id, self.topology.faces.len() - first);
        Ok(())
    }

    fn leave_out(&mut self, part: &str, error: &ImportError) {
        let detail = error.detail();
        self.summary.missing.push(if part.is_empty() {
            format!("left out: {detail}")
        } else {
            format!("part `{part}`: {detail}")
        });
    }

    /// Moves what was read to what has been found.
    fn finish(mut self) -> Summary {
        let Topology {
            mut edges,
            mut faces,
            mut solids,
            ..
        } = self.topology;
        self.summary.faces = self.placed.values().sum();
        let of_shells: HashSet<u64> = self
            .file
            .all(&SHELLS)
            .filter_map(|shell| shell.list(1).ok())
            .flatten()
            .filter_map(|face| match face.kind {
                exchange::Kind::Reference(id) => Some(id),
                _ => None,
            })
            .collect();
        self.summary.unplaced_faces = of_shells.len().saturating_sub(self.summary.faces);
        let (first_edge, first_face) = (self.found.edges.len(), self.found.faces.len());
        for edge_use in faces
            .iter_mut()
            .flat_map(|face| face.loops.iter_mut().flatten())
        {
            edge_use.edge += first_edge;
        }
        for face in solids.iter_mut().flat_map(|solid| &mut solid.faces) {
            *face += first_face;
        }
        self.found.edges.append(&mut edges);
        self.found.faces.append(&mut faces);
        self.found.solids.append(&mut solids);
        self.summary
    }

    /// The shells of an item; none if it is of another kind.
    fn shells(&self, item: &'e Entity<'a>) -> Result<Vec<&'e Entity<'a>>, ImportError> {
        let find = |names: &[&str]| self.file.find(item, names);
        if let Some(args) = find(&["SHELL_BASED_SURFACE_MODEL"]) {
            return args.entities(first_of(&args));
        }
        if let Some(voids) = find(&["BREP_WITH_VOIDS"]) {
            let (outer, index) = if item.complex {
                (
                    self.file.need(item, &["MANIFOLD_SOLID_BREP"])?.entity(0)?,
                    0,
                )
            } else {
                (voids.entity(1)?, 2)
            };
            let mut shells = vec![outer];
            shells.extend(voids.entities(index)?);
            return Ok(shells);
        }
        match find(&["MANIFOLD_SOLID_BREP", "FACETED_BREP"]) {
            Some(args) => Ok(vec![args.entity(first_of(&args))?]),
            None => Ok(vec![]),
        }
    }

    /// A name that no other solid has: that of the product, or the item's own.
    fn name_of(&mut self, product: &str, item: &Entity) -> String {
        let label = match &item.records[..] {
            [record] => match record.values.first().map(|value| &value.kind) {
                Some(exchange::Kind::Text(label)) => text::decoded(label),
                _ => String::new(),
            },
            _ => String::new(),
        };
        let words = [product.trim(), label.trim()];
        let plain = words.into_iter().find(|word| !word.is_empty());
        let plain = plain.map_or(format!("#{}", item.id), str::to_owned);
        let names = &mut self.found.names;
        let mut name = plain.clone();
        while names.contains_key(&name) {
            let count = names.entry(plain.clone()).or_insert(1);
            *count += 1;
            name = format!("{plain} {count}");
        }
        names.insert(name.clone(), 1);
        name
    }

    /// The colours of faces that are not that of their solid: their own, or that of their shell.
    fn colour(&mut self, own: Option<Colour>, shells: &[&'e Entity<'a>], first: usize) {
        if self.colours.is_empty() {
            return;
        }
        let of_shells: Vec<Option<Colour>> = shells
            .iter()
            .map(|shell| self.colours.get(&shell.id).copied())
            .collect();
        for index in first..self.topology.faces.len() {
            let (face, shell) = self.topology.origins[index];
            let colour = self.colours.get(&face).copied().or(of_shells[shell]);
            if colour.is_some() && colour != own {
                let material = self.found.palette.material(colour);
                self.topology.faces[index].material = Some(material);
            }
        }
    }
}

/// Where the parameters of a record begin: after the name of a simple one.
fn first_of(args: &Args) -> usize {
    usize::from(!args.entity.complex)
}
