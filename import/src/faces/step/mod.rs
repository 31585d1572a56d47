//! STEP files (ISO 10303-21) with boundary representations of AP203, AP214 and AP242.
//!
//! [`step21`] reads the structure of a file; the result is the model that a face list gives, in millimetres.

mod assembly;
mod colours;
mod curves;
mod placement;
mod spline;
mod surfaces;
mod topology;
mod units;

use super::model::Model;
use crate::error::{Error, ImportError, Result};
use crate::kit::Names;
use assembly::{Assembly, Placed};
use colours::{Colour, colours, material};
use imogene_files::text::counted;
use placement::Placement;
use serde::Serialize;
use std::collections::{BTreeMap, HashMap, HashSet};
use step21::{Entity, Exchange, Kind, Value, decoded};
use topology::{Known, SHELLS, Space, Topology};

/// Most files that place each other's parts.
const DEEPEST_FILE: usize = 8;

/// Reads the file of a name that stands beside the first; `None` if there is none.
pub type Beside<'b> = &'b dyn Fn(&str) -> Option<Vec<u8>>;

pub fn build(bytes: &[u8], beside: Beside) -> Result<(Model, Summary)> {
    let mut found = Found::default();
    read(&mut found, bytes, Placement::IN_PLACE, beside, 0)?;
    let (mut model, mut summary) = (found.topology.model, found.summary);
    if model.faces.is_empty() {
        let accepted =
            "a MANIFOLD_SOLID_BREP, BREP_WITH_VOIDS or SHELL_BASED_SURFACE_MODEL is needed";
        return Err(Error::whole(nothing(&summary), accepted));
    }
    summary.placed_faces = model.faces.len();
    if model.title.is_empty() {
        model.title = "A part".into();
    }
    model.z_up = true;
    let model = model.assembled().ok_or_else(|| {
        let accepted = "a box around them of at least a millionth of a millimetre is needed";
        Error::whole("the faces have no size", accepted)
    })?;
    Ok((model, summary))
}

fn nothing(summary: &Summary) -> String {
    if !summary.missing.is_empty() {
        return format!("no part is left: {}", summary.missing.join("; "));
    }
    let others: Vec<&str> = summary.left_out.keys().map(String::as_str).collect();
    format!("no shape representation has a face; its items are {others:?}")
}

/// Reads a file that is placed, and those whose parts it places.
fn read(found: &mut Found, file: &[u8], at: Placement, beside: Beside, depth: usize) -> Result<()> {
    let exchange = Exchange::parse(file)?;
    let assembly = Assembly::read(&exchange);
    let placed = assembly.placed()?;
    let (colours, grey) = colours(&exchange);
    let summary = &mut found.summary;
    if depth == 0 {
        summary.schema = schema(&exchange);
    }
    summary.entities += exchange.instances.len();
    summary.missing.extend(assembly.notes.iter().cloned());
    summary.missing.extend(grey);
    found.topology.next_file();
    let mut reader = Reader {
        found,
        assembly: &assembly,
        colours,
        seen: HashSet::new(),
        placed: HashMap::new(),
    };
    for part in &placed {
        reader.representation(part, at.after(&part.place));
    }
    reader.finish(&exchange);
    let title = &mut found.topology.model.title;
    if let Some(first) = placed.first().filter(|_| title.is_empty()) {
        *title = assembly.name(first.group).to_owned();
    }
    let mut done = HashSet::new();
    for part in placed.iter().filter(|part| done.insert(part.occurrence)) {
        for name in external(&exchange, assembly.product_of(part.group)) {
            let place = at.after(&part.place);
            let Some(bytes) = beside(&name).filter(|_| depth < DEEPEST_FILE) else {
                found.summary.missing.push(format!(
                    "part `{}` is in the file `{name}`, which is not beside this one",
                    assembly.name(part.group)
                ));
                continue;
            };
            let inner = read(found, &bytes, place, beside, depth + 1);
            let Summary { missing, files, .. } = &mut found.summary;
            let inner = inner.map_err(ImportError::of(&name));
            missing.extend(inner.err().map(|error| error.to_string()));
            if !files.contains(&name) {
                files.push(name);
            }
        }
    }
    Ok(())
}

/// The first words of the names of the schemas.
fn schema(file: &Exchange) -> Vec<String> {
    let record = file.header.iter().find(|r| r.name == "FILE_SCHEMA");
    let Some(Kind::List(names)) = record.and_then(|record| Some(&record.values.first()?.kind))
    else {
        return vec![];
    };
    let text = |value: &Value| match value.kind {
        Kind::Text(name) => Some(decoded(name)),
        _ => None,
    };
    let word = |name: String| name.split_whitespace().next().unwrap_or("").to_owned();
    names.iter().filter_map(text).map(word).collect()
}

/// The names of the files that have the shape of a product, without folders.
fn external(file: &Exchange, product: Option<u64>) -> Vec<String> {
    let mut names: Vec<String> = vec![];
    for reference in file.all(&["APPLIED_DOCUMENT_REFERENCE"]) {
        let items = reference.entities(2).unwrap_or_default();
        let own = items.iter().any(|item| Some(item.id) == product);
        let document = reference.entity(0).ok().filter(|_| own);
        let Some(document) = document.and_then(|entity| entity.find(&["DOCUMENT_FILE"])) else {
            continue;
        };
        let mut assigned = file.all(&["APPLIED_EXTERNAL_IDENTIFICATION_ASSIGNMENT"]);
        let assigned = assigned.find(|assigned| {
            let items = assigned.entities(3).unwrap_or_default();
            items.iter().any(|item| item.id == document.entity.id)
        });
        let path = assigned.unwrap_or(document).text(0);
        let name = path.rsplit(['/', '\\']).next().unwrap_or_default();
        if !name.is_empty() && !names.iter().any(|known| known == name) {
            names.push(name.to_owned());
        }
    }
    names
}

/// Items that have no faces of their own and are expected beside solids.
const SILENT: [&str; 3] = ["AXIS2_PLACEMENT_3D", "MAPPED_ITEM", "CARTESIAN_POINT"];

/// What has been found in a file and in those beside it.
#[derive(Default)]
struct Found {
    topology: Topology,
    summary: Summary,
    names: Names,
}

struct Reader<'f, 'a> {
    found: &'f mut Found,
    assembly: &'f Assembly<'a>,
    colours: HashMap<u64, Colour>,
    /// Items by the placement that has them already.
    seen: HashSet<(usize, u64)>,
    /// For each item that is drawn, how many faces it has.
    placed: HashMap<u64, usize>,
}

impl<'a> Reader<'_, 'a> {
    /// Reads the items of a representation where it is placed; those that cannot be read are missing.
    fn representation(&mut self, part: &Placed<'a>, place: Placement) {
        let own = part.representation;
        let context = self.assembly.context(&own);
        let (context, items) = match context.and_then(|context| Ok((context, own.list(1)?))) {
            Ok(read) => read,
            Err(error) => return self.leave_out(part, &error),
        };
        let mut space = Space {
            context,
            place,
            known: Known::default(),
        };
        for item in items {
            let item = own.as_entity(item);
            if let Err(error) = item.and_then(|item| self.item(part, &mut space, item)) {
                self.leave_out(part, &error);
            }
        }
    }

    fn leave_out(&mut self, part: &Placed, error: &Error) {
        let part = match self.assembly.name(part.group) {
            "" => "left out".into(),
            name => format!("part `{name}`"),
        };
        self.found.summary.missing.push(format!("{part}: {error}"));
    }

    fn item(&mut self, part: &Placed, space: &mut Space, item: Entity) -> Result<()> {
        if !self.seen.insert((part.occurrence, item.id)) {
            return Ok(());
        }
        let shells = shells(item)?;
        if shells.is_empty() {
            if item.find(&SILENT).is_none() {
                *self.found.summary.left_out.entry(item.name()).or_default() += 1;
            }
            return Ok(());
        }
        let model = &mut self.found.topology.model;
        model.uncertainty = model.uncertainty.max(space.context.uncertainty);
        model.precision = model.precision.max(space.context.precision);
        let first = model.faces.len();
        let name = self.name_of(self.assembly.name(part.group), item);
        let own = self.colours.get(&item.id).copied();
        let topology = &mut self.found.topology;
        let material = material(&mut topology.model.materials, own);
        let origins = topology.solid(space, &shells, name, material)?;
        self.placed.insert(item.id, origins.len());
        self.colour(own, first, &origins);
        Ok(())
    }

    fn finish(self, file: &Exchange) {
        let drawn: usize = self.placed.values().sum();
        let shells = file.all(&SHELLS);
        let faces = shells.flat_map(|shell| shell.list(1).unwrap_or_default());
        let faces = faces.filter_map(|face| match face.kind {
            Kind::Reference(id) => Some(id),
            _ => None,
        });
        let of_shells: HashSet<u64> = faces.collect();
        let summary = &mut self.found.summary;
        summary.faces += drawn;
        summary.unplaced_faces += of_shells.len().saturating_sub(drawn);
    }

    /// A name that no other solid has: that of the product, or the item's own.
    fn name_of(&mut self, product: &str, item: Entity) -> String {
        let record = item.records.first().filter(|_| item.records.len() == 1);
        let args = record.and_then(|record| item.find(&[record.name]));
        let label = args.map_or(String::new(), |args| args.text(0));
        let words = [product.trim(), &label];
        let plain = words.into_iter().find(|word| !word.is_empty());
        let plain = plain.map_or(format!("#{}", item.id), str::to_owned);
        let number = |name: &str, count| format!("{name} {count}");
        self.found.names.unique(plain, number)
    }

    /// The colours of faces that are not that of their solid: their own, or that of their shell.
    fn colour(&mut self, own: Option<Colour>, first: usize, origins: &[[u64; 2]]) {
        let of = |id: u64| self.colours.get(&id).copied();
        let model = &mut self.found.topology.model;
        for (face, [id, shell]) in model.faces[first..].iter_mut().zip(origins) {
            let colour = of(*id).or_else(|| of(*shell));
            if colour.is_some() && colour != own {
                face.material = Some(material(&mut model.materials, colour));
            }
        }
    }
}

fn shells(item: Entity) -> Result<Vec<Entity>> {
    if let Some(args) = item.find(&["SHELL_BASED_SURFACE_MODEL"]) {
        return args.entities(args.first());
    }
    if let Some(voids) = item.find(&["BREP_WITH_VOIDS"]) {
        let outer = voids.of("MANIFOLD_SOLID_BREP")?;
        let mut shells = vec![outer.entity(outer.first())?];
        shells.extend(voids.entities(2 * voids.first())?);
        return Ok(shells);
    }
    let solid = item.find(&["MANIFOLD_SOLID_BREP", "FACETED_BREP"]);
    solid.map_or(Ok(vec![]), |args| Ok(vec![args.entity(args.first())?]))
}

/// What the reader says of a file besides its model; the keys are stable.
#[derive(Debug, Default, Serialize)]
pub struct Summary {
    schema: Vec<String>,
    entities: usize,
    /// Faces of the file that are part of a shell, each counted once.
    faces: usize,
    /// The same, as often as their solids are placed: all faces of the model.
    pub placed_faces: usize,
    /// Faces of shells that no product places, as those of validation properties.
    unplaced_faces: usize,
    /// What is no shell and was left out: entities by their name.
    left_out: BTreeMap<String, usize>,
    /// Parts and placements that are missing, and why.
    pub missing: Vec<String>,
    /// Files beside this one whose parts are placed in it.
    files: Vec<String>,
}

impl Summary {
    pub fn notes(&self) -> Vec<String> {
        let left_out = self.left_out.iter();
        let left_out =
            left_out.map(|(name, count)| format!("{count} {name} left out: faces alone are drawn"));
        let mut notes: Vec<String> = left_out.collect();
        notes.extend(self.missing.iter().cloned());
        if self.unplaced_faces > 0 {
            notes.push(format!(
                "{} of properties left out: no product places them",
                counted(self.unplaced_faces, "face")
            ));
        }
        notes
    }
}
