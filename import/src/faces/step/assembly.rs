//! Representations, and where they are placed in each other (ISO 10303-43, -44).

use super::args::Args;
use super::exchange::{Entity, Exchange};
use super::placement::{Placement, placement};
use super::units::{Context, context};
use crate::ImportError;
use std::collections::{HashMap, HashSet};

/// Most representations inside each other.
const DEEPEST: usize = 64;
/// Most placements of representations.
const MOST_PLACED: usize = 10_000;

/// A representation where it is placed.
#[derive(Clone, Copy, Debug)]
pub struct Placed<'e, 'a> {
    /// The representation.
    pub representation: Args<'e, 'a>,
    /// Where it is.
    pub place: Placement,
    /// Its number among those of its kind, from 0.
    pub group: usize,
}

/// A representation inside another.
#[derive(Clone, Copy, Debug)]
struct Link {
    child: usize,
    place: Placement,
    /// The entity that says so, for messages.
    id: u64,
}

/// The representations of a file. Those that a relationship without a placement joins are one group.
#[derive(Debug)]
pub struct Assembly<'e, 'a> {
    file: &'e Exchange<'a>,
    representations: Vec<Args<'e, 'a>>,
    index: HashMap<u64, usize>,
    group: Vec<usize>,
    links: HashMap<usize, Vec<Link>>,
    /// Products by their groups: the number and the name.
    products: HashMap<usize, (u64, String)>,
}

fn is_shape(name: &str) -> bool {
    name.ends_with("SHAPE_REPRESENTATION") && name != "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION"
}

impl<'e, 'a> Assembly<'e, 'a> {
    /// Of a file.
    pub fn read(file: &'e Exchange<'a>) -> Result<Self, ImportError> {
        let mut all = Assembly {
            file,
            representations: vec![],
            index: HashMap::new(),
            group: vec![],
            links: HashMap::new(),
            products: HashMap::new(),
        };
        for entity in &file.entities {
            let Some(record) = entity.records.iter().find(|r| is_shape(r.name)) else {
                continue;
            };
            let name = if entity.complex {
                "REPRESENTATION"
            } else {
                record.name
            };
            if let Some(args) = file.find(entity, &[name]) {
                all.index.insert(entity.id, all.representations.len());
                all.group.push(all.representations.len());
                all.representations.push(args);
            }
        }
        all.join()?;
        all.name_products()?;
        all.place_components()?;
        all.place_mapped()?;
        Ok(all)
    }

    fn find(&self, entity: &Entity) -> Option<usize> {
        self.index.get(&entity.id).map(|index| self.group[*index])
    }

    /// Relationships without a placement: joined representations are a group, with the number of the first of them.
    fn join(&mut self) -> Result<(), ImportError> {
        let names = [
            "SHAPE_REPRESENTATION_RELATIONSHIP",
            "REPRESENTATION_RELATIONSHIP",
        ];
        for args in self.file.all(&names) {
            if args.entity.complex {
                continue;
            }
            let ends = [args.entity(2)?, args.entity(3)?];
            if let [Some(one), Some(other)] = ends.map(|end| self.index.get(&end.id).copied()) {
                let (one, other) = (self.first(one), self.first(other));
                self.group[one.max(other)] = one.min(other);
            }
        }
        for index in 0..self.group.len() {
            self.group[index] = self.first(index);
        }
        Ok(())
    }

    /// The first of the representations that are joined with one; the way to it is shortened.
    fn first(&mut self, mut index: usize) -> usize {
        while self.group[index] != index {
            self.group[index] = self.group[self.group[index]];
            index = self.group[index];
        }
        index
    }

    /// What product a representation is of.
    fn name_products(&mut self) -> Result<(), ImportError> {
        for args in self.file.all(&["SHAPE_DEFINITION_REPRESENTATION"]) {
            let Some(group) = self.find(args.entity(1)?) else {
                continue;
            };
            let shape = self
                .file
                .find(args.entity(0)?, &["PRODUCT_DEFINITION_SHAPE"]);
            let Some(shape) = shape else { continue };
            let names = [
                "PRODUCT_DEFINITION",
                "PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS",
            ];
            let Some(definition) = self.file.find(shape.entity(2)?, &names) else {
                continue;
            };
            let formations = [
                "PRODUCT_DEFINITION_FORMATION",
                "PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE",
            ];
            let mut name = String::new();
            if let Some(formation) = self.file.find(definition.entity(2)?, &formations)
                && let Some(product) = self.file.find(formation.entity(2)?, &["PRODUCT"])
            {
                name = product.text(1);
                if name.is_empty() {
                    name = product.text(0);
                }
            }
            self.products.insert(group, (definition.entity.id, name));
        }
        Ok(())
    }

    /// The context of a representation.
    pub fn context(&self, representation: &Args<'e, 'a>) -> Result<Context, ImportError> {
        match representation.maybe(2)? {
            Some(entity) => context(self.file, entity),
            None => Ok(Context::default()),
        }
    }

    /// `NEXT_ASSEMBLY_USAGE_OCCURRENCE` and what places it.
    fn place_components(&mut self) -> Result<(), ImportError> {
        // For each relationship the product that is the assembly.
        let mut wholes = HashMap::new();
        for args in self.file.all(&["CONTEXT_DEPENDENT_SHAPE_REPRESENTATION"]) {
            let shape = args.named(1, &["PRODUCT_DEFINITION_SHAPE"])?;
            let usage = self
                .file
                .find(shape.entity(2)?, &["NEXT_ASSEMBLY_USAGE_OCCURRENCE"]);
            if let Some(usage) = usage {
                wholes.insert(args.entity(0)?.id, usage.entity(3)?.id);
            }
        }
        for placed in self
            .file
            .all(&["REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION"])
        {
            let args = self
                .file
                .need(placed.entity, &["REPRESENTATION_RELATIONSHIP"])?;
            let ends = [args.entity(2)?, args.entity(3)?];
            let [Some(first), Some(second)] = ends.map(|end| self.index.get(&end.id).copied())
            else {
                continue;
            };
            let operator = placed.named(0, &["ITEM_DEFINED_TRANSFORMATION"])?;
            let mut frames = [Placement::IN_PLACE; 2];
            for (k, index) in [first, second].into_iter().enumerate() {
                let context = self.context(&self.representations[index])?;
                frames[k] = placement(self.file, operator.entity(2 + k)?, &context)?;
            }
            // The first is the component, unless its product is the one that uses.
            let whole = wholes.get(&placed.entity.id);
            let product = self.products.get(&self.group[first]).map(|(id, _)| id);
            let swapped = whole.is_some() && whole == product;
            let (child, parent) = if swapped { (1, 0) } else { (0, 1) };
            let groups = [self.group[first], self.group[second]];
            self.links.entry(groups[parent]).or_default().push(Link {
                child: groups[child],
                place: frames[parent].after(&frames[child].inverse()),
                id: placed.entity.id,
            });
        }
        Ok(())
    }

    /// `MAPPED_ITEM`.
    fn place_mapped(&mut self) -> Result<(), ImportError> {
        for index in 0..self.representations.len() {
            let own = self.representations[index];
            for item in own.entities(1)? {
                let Some(item) = self.file.find(item, &["MAPPED_ITEM"]) else {
                    continue;
                };
                let map = item.named(1, &["REPRESENTATION_MAP"])?;
                let Some(source) = self.index.get(&map.entity(1)?.id).copied() else {
                    continue;
                };
                let inner = self.context(&self.representations[source])?;
                let origin = placement(self.file, map.entity(0)?, &inner)?;
                let target = placement(self.file, item.entity(2)?, &self.context(&own)?)?;
                let link = Link {
                    child: self.group[source],
                    place: target.after(&origin.inverse()),
                    id: item.entity.id,
                };
                self.links.entry(self.group[index]).or_default().push(link);
            }
        }
        Ok(())
    }

    /// The name of the product of a group; empty if it has none.
    pub fn name(&self, group: usize) -> &str {
        self.products.get(&group).map_or("", |(_, name)| name)
    }

    /// All representations where they are placed, whole assemblies first.
    pub fn placed(&self) -> Result<Vec<Placed<'e, 'a>>, ImportError> {
        let children: HashSet<usize> = self
            .links
            .values()
            .flatten()
            .map(|link| link.child)
            .collect();
        let mut waiting: Vec<(usize, Placement, usize, u64)> = (0..self.group.len())
            .rev()
            .filter(|index| self.group[*index] == *index && !children.contains(index))
            .map(|group| (group, Placement::IN_PLACE, 0, 0))
            .collect();
        let mut members = vec![vec![]; self.group.len()];
        for (index, group) in self.group.iter().enumerate() {
            members[*group].push(index);
        }
        let mut placed = vec![];
        let mut seen = vec![false; self.group.len()];
        while let Some((group, place, depth, id)) = waiting.pop() {
            if depth > DEEPEST || placed.len() > MOST_PLACED {
                let at = self.file.get(id).map_or(0, |entity| entity.at);
                return Err(self.file.source.error(
                    at,
                    format!("`#{id}` places a part in itself, or too many parts in each other"),
                    format!("at most {DEEPEST} assemblies in each other and {MOST_PLACED} placements are possible"),
                ));
            }
            seen[group] = true;
            for index in &members[group] {
                placed.push(Placed {
                    representation: self.representations[*index],
                    place,
                    group,
                });
            }
            for link in self.links.get(&group).into_iter().flatten().rev() {
                waiting.push((link.child, place.after(&link.place), depth + 1, link.id));
            }
        }
        match (0..self.group.len()).find(|index| !seen[self.group[*index]]) {
            None => Ok(placed),
            Some(index) => Err(self.representations[index].error(
                "it is placed in itself",
                "parts that contain each other in one direction are needed",
            )),
        }
    }
}
