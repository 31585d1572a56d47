//! STEP files (ISO 10303-21) with boundary representations of AP203, AP214 and AP242.
//!
//! The structure of the file is read by [`exchange`], what its entities mean by the other modules; the result is the model that a face list gives. Lengths become
//! millimetres.

mod args;
mod assembly;
mod colours;
mod curves;
mod exchange;
mod flatten;
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
use super::model::{Model, Up};
use crate::ImportError;
use args::Args;
use assembly::{Assembly, Placed};
use colours::{Colour, Palette, colours};
use exchange::{Entity, Exchange};
use flatten::flatten;
use serde::Serialize;
use source::Source;
use std::collections::{BTreeMap, HashMap};
use topology::{Space, Topology};

/// What the reader says of a file besides its model; the keys are stable.
#[derive(Debug, Serialize)]
pub struct Summary {
    /// What the header calls the schema.
    pub schema: Vec<String>,
    /// Number of entities.
    pub entities: usize,
    /// What is no shell and was left out: entities by their name.
    pub left_out: BTreeMap<String, usize>,
    /// Solids whose faces have colours that differ.
    pub many_colours: Vec<String>,
}

impl Summary {
    /// Lines for a person.
    pub fn notes(&self) -> Vec<String> {
        let mut notes: Vec<String> = self
            .left_out
            .iter()
            .map(|(name, count)| format!("{count} {name} left out: faces alone are drawn"))
            .collect();
        for solid in &self.many_colours {
            notes.push(format!(
                "solid `{solid}`: the colours of single faces are left out"
            ));
        }
        notes
    }
}

/// Items that have no faces of their own and are expected beside solids.
const SILENT: [&str; 3] = ["AXIS2_PLACEMENT_3D", "MAPPED_ITEM", "CARTESIAN_POINT"];

/// Reads a STEP file.
pub fn build(bytes: &[u8], file: &str) -> Result<(Model, Summary), ImportError> {
    let source = Source { file, bytes };
    let exchange = Exchange::parse(source)?;
    let mut reader = Reader {
        file: &exchange,
        colours: colours(&exchange)?,
        palette: Palette::default(),
        topology: Topology::new(&exchange),
        names: HashMap::new(),
        uncertainty: 0.0,
        summary: Summary {
            schema: schema(&exchange),
            entities: exchange.entities.len(),
            left_out: BTreeMap::new(),
            many_colours: vec![],
        },
    };
    let assembly = Assembly::read(&exchange)?;
    let placed = assembly.placed()?;
    for part in &placed {
        reader.representation(&assembly, part)?;
    }
    let title = placed
        .first()
        .map_or("", |part| assembly.name(part.group))
        .to_owned();
    let Reader {
        mut topology,
        palette,
        summary,
        uncertainty,
        ..
    } = reader;
    if topology.faces.is_empty() {
        let others: Vec<&str> = summary.left_out.keys().map(String::as_str).collect();
        return Err(source.unusable(
            format!("no shape representation has a face; its items are {others:?}"),
            "a MANIFOLD_SOLID_BREP, BREP_WITH_VOIDS or SHELL_BASED_SURFACE_MODEL is needed",
        ));
    }
    flatten(&mut topology.edges, &topology.faces, uncertainty);
    let parts = Parts {
        title: if title.is_empty() {
            "A part".into()
        } else {
            title
        },
        up: Up::Z,
        materials: palette.materials,
        edges: topology.edges,
        faces: topology.faces,
        solids: topology.solids,
    };
    let model = assemble(parts).ok_or_else(|| {
        source.unusable(
            "the faces have no size",
            "a box around them of at least a millionth of a millimetre is needed",
        )
    })?;
    Ok((model, summary))
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

struct Reader<'e, 'a> {
    file: &'e Exchange<'a>,
    colours: HashMap<u64, Colour>,
    palette: Palette,
    topology: Topology<'e, 'a>,
    /// Names of solids that are taken, and how often.
    names: HashMap<String, usize>,
    /// The greatest of the representations that have faces, millimetres.
    uncertainty: f64,
    summary: Summary,
}

impl<'e, 'a> Reader<'e, 'a> {
    fn representation(
        &mut self,
        assembly: &Assembly<'e, 'a>,
        part: &Placed<'e, 'a>,
    ) -> Result<(), ImportError> {
        let items = part.representation.entities(1)?;
        let context = assembly.context(&part.representation)?;
        let mut space = Space::new(context, part.place);
        for item in items {
            let shells = self.shells(item)?;
            if shells.is_empty() {
                if !SILENT
                    .iter()
                    .any(|name| self.file.find(item, &[name]).is_some())
                {
                    *self.summary.left_out.entry(item.name()).or_default() += 1;
                }
                continue;
            }
            self.uncertainty = self.uncertainty.max(context.uncertainty);
            let name = self.name_of(assembly.name(part.group), item);
            let colour = self.colour(item, &shells, &name)?;
            let material = self.palette.material(colour);
            self.topology.solid(&mut space, &shells, name, material)?;
        }
        Ok(())
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
        let mut name = plain.clone();
        while self.names.contains_key(&name) {
            let count = self.names.entry(plain.clone()).or_insert(1);
            *count += 1;
            name = format!("{plain} {count}");
        }
        self.names.insert(name.clone(), 1);
        name
    }

    /// The colour of a solid: its own, or that of all its faces.
    fn colour(
        &mut self,
        item: &Entity,
        shells: &[&'e Entity<'a>],
        name: &str,
    ) -> Result<Option<Colour>, ImportError> {
        if self.colours.is_empty() {
            return Ok(None);
        }
        let mut of_faces = vec![];
        for shell in shells {
            of_faces.push(self.colours.get(&shell.id).copied());
            if let Some(args) = self.file.find(shell, &["CLOSED_SHELL", "OPEN_SHELL"]) {
                for face in args.entities(1)? {
                    of_faces.push(self.colours.get(&face.id).copied());
                }
            }
        }
        let own = self.colours.get(&item.id).copied();
        let found: Vec<Colour> = of_faces.into_iter().flatten().collect();
        let first = found.first().copied();
        if found.iter().any(|colour| Some(*colour) != own.or(first)) {
            self.summary.many_colours.push(name.to_owned());
        }
        Ok(own.or(first))
    }
}

/// Where the parameters of a record begin: after the name of a simple one.
fn first_of(args: &Args) -> usize {
    usize::from(!args.entity.complex)
}
