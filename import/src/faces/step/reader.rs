//! From the items of representations to solids.

use super::assembly::{Assembly, Placed};
use super::colours::{Colour, material};
use super::placement::Placement;
use super::topology::{Known, Origin, SHELLS, Space, Topology};
use crate::kit::Names;
use imogene_files::text::counted;
use serde::Serialize;
use std::collections::{BTreeMap, HashMap, HashSet};
use step21::{Entity, Error, Exchange, Kind, Result};

/// Items that have no faces of their own and are expected beside solids.
const SILENT: [&str; 3] = ["AXIS2_PLACEMENT_3D", "MAPPED_ITEM", "CARTESIAN_POINT"];

/// What has been found in a file and in those beside it.
#[derive(Default)]
pub struct Found {
    pub topology: Topology,
    pub summary: Summary,
    names: Names,
}

/// Of a file.
pub struct Reader<'f, 'a> {
    /// What is found is added to it.
    pub found: &'f mut Found,
    pub assembly: &'f Assembly<'a>,
    pub colours: HashMap<u64, Colour>,
    /// Items by the placement that has them already.
    pub seen: HashSet<(usize, u64)>,
    /// For each item that is drawn, how many faces it has.
    pub placed: HashMap<u64, usize>,
}

impl<'a> Reader<'_, 'a> {
    /// Reads the items of a representation where it is placed; those that cannot be read are missing.
    pub fn representation(&mut self, part: &Placed<'a>, place: Placement) {
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
        self.colour(own, &shells, first, &origins);
        Ok(())
    }

    pub fn finish(self, file: &Exchange) {
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
    fn colour(&mut self, own: Option<Colour>, shells: &[Entity], first: usize, origins: &[Origin]) {
        let of = |id: u64| self.colours.get(&id).copied();
        let model = &mut self.found.topology.model;
        for (face, (id, shell)) in model.faces[first..].iter_mut().zip(origins) {
            let colour = of(*id).or_else(|| of(shells[*shell].id));
            if colour.is_some() && colour != own {
                face.material = Some(material(&mut model.materials, colour));
            }
        }
    }
}

/// The shells of an item; none if it is of another kind.
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
    /// What the header calls the schema.
    pub schema: Vec<String>,
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
