//! Solids made of objects by union, intersection and difference (source: Chaillou, III.1.1.4).

use super::error::SceneError;
use super::file::SceneFile;
use super::keys::text_or_table;
use super::limits::{Checked, check_count, check_name, check_new, unless};
use super::names::known;
use super::shape::{Processor, Shape, Surface};
use serde::{Deserialize, Deserializer, Serialize};
use std::collections::HashSet;

/// Most objects that the tree of a solid names.
pub const MAX_LEAVES: usize = 64;

/// A solid: its objects are not seen by themselves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Solid {
    /// Unique among solids.
    pub name: String,
    /// What it is made of.
    pub of: Operation,
}

/// An operation on objects, named or made by operations.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Operation {
    /// In any of them.
    Union(Vec<Operand>),
    /// In all of them.
    Intersection(Vec<Operand>),
    /// In the first and in none of the others.
    Difference(Vec<Operand>),
}

/// What an operation takes.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(untagged)]
pub enum Operand {
    /// An object, by its name.
    Object(String),
    /// The outcome of another operation.
    Operation(Operation),
}

impl<'de> Deserialize<'de> for Operand {
    fn deserialize<D: Deserializer<'de>>(input: D) -> Result<Operand, D::Error> {
        let wanted = "the name of an object, or { union = [..] }, { intersection = [..] } or { difference = [..] }";
        text_or_table(input, wanted, Operand::Object, Operand::Operation)
    }
}

impl Operation {
    /// Its operands.
    pub fn operands(&self) -> &[Operand] {
        match self {
            Self::Union(list) | Self::Intersection(list) | Self::Difference(list) => list,
        }
    }

    /// The names of its objects, in their order, as often as they are named.
    pub fn names<'a>(&'a self) -> Vec<&'a str> {
        let names = |operand: &'a Operand| match operand {
            Operand::Object(name) => vec![name.as_str()],
            Operand::Operation(operation) => operation.names(),
        };
        self.operands().iter().flat_map(names).collect()
    }
}

/// The tree of a solid over the objects of a framed scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tree {
    /// An object, by its index.
    Object(usize),
    /// In any of them; of none, nothing.
    Union(Vec<Tree>),
    /// In all of them.
    Intersection(Vec<Tree>),
    /// In the first and in none of the others.
    Difference(Vec<Tree>),
}

impl Tree {
    /// Of an operation, if `index` tells the index of an object that is there.
    pub(super) fn of(operation: &Operation, index: &impl Fn(&str) -> Option<usize>) -> Tree {
        let tree = |operand: &Operand| match operand {
            Operand::Object(name) => index(name).map_or(Tree::Union(vec![]), Tree::Object),
            Operand::Operation(operation) => Tree::of(operation, index),
        };
        let parts = operation.operands().iter().map(tree).collect();
        match operation {
            Operation::Union(_) => Tree::Union(parts),
            Operation::Intersection(_) => Tree::Intersection(parts),
            Operation::Difference(_) => Tree::Difference(parts),
        }
    }

    /// Is a point in the solid, if `inside` tells for every object?
    pub fn contains(&self, inside: &dyn Fn(usize) -> bool) -> bool {
        let within = |tree: &Tree| tree.contains(inside);
        match self {
            Tree::Object(object) => inside(*object),
            Tree::Union(parts) => parts.iter().any(within),
            Tree::Intersection(parts) => parts.iter().all(within),
            Tree::Difference(parts) => {
                let (first, others) = parts.split_first().expect("checked: no empty difference");
                within(first) && !others.iter().any(within)
            }
        }
    }

    /// Its objects, as often as they are named.
    pub fn objects(&self) -> Vec<usize> {
        match self {
            Tree::Object(object) => vec![*object],
            Tree::Union(parts) | Tree::Intersection(parts) | Tree::Difference(parts) => {
                parts.iter().flat_map(Tree::objects).collect()
            }
        }
    }
}

/// A solid of a framed scene.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FramedSolid {
    /// Its name.
    pub name: String,
    /// What it is made of.
    pub tree: Tree,
}

impl SceneFile {
    /// The solids of a flat scene; an object that is not visible is nowhere.
    pub(super) fn framed_solids(&self) -> Vec<FramedSolid> {
        let index = |name: &str| self.objects.iter().position(|object| object.name == name);
        let framed = |solid: &Solid| FramedSolid {
            name: solid.name.clone(),
            tree: Tree::of(&solid.of, &index),
        };
        self.solids.iter().map(framed).collect()
    }

    pub(super) fn check_solids(&self) -> Checked {
        let mut names = HashSet::new();
        for (index, solid) in self.solids.iter().enumerate() {
            check_name(&format!("solids[{index}].name"), &solid.name)?;
            let place = format!("solid `{}`", solid.name);
            check_new(names.insert(&solid.name), &place, "solid")?;
            check_operation(&place, &solid.of)?;
            let named = solid.of.names();
            check_count(&place, named.len(), "objects are named in it", MAX_LEAVES)?;
            let mut named = named.into_iter();
            named.try_for_each(|name| self.check_member(&place, name))?;
        }
        Ok(())
    }

    /// Refuses what is no volume along every line of sight, or is not drawn by a quadric processor.
    fn check_member(&self, place: &str, name: &str) -> Checked {
        let place = format!("{place}, object `{name}`");
        let Some(object) = self.objects.iter().find(|object| object.name == name) else {
            let names = self.objects.iter().map(|o| o.name.as_str());
            let (problem, accepted) = ("there is no such object", known(names, "`[[objects]]`"));
            return Err(SceneError::value(place, problem, accepted));
        };
        let is_volume = object.mode == Surface::Solid
            && !matches!(
                object.shape,
                Shape::Mesh(_) | Shape::TetrahedronPatch { .. }
            );
        unless(is_volume, || {
            let accepted = "solids are made of objects with `mode = \"solid\"`";
            (place.clone(), "it is a surface without inside", accepted)
        })?;
        let is_drawn = matches!(object.processor, None | Some(Processor::Quadric));
        unless(is_drawn, || {
            let accepted =
                "objects of solids have the quadric processor, which is theirs if none is given";
            (place, "its processor hands on no back", accepted)
        })
    }
}

fn check_operation(place: &str, operation: &Operation) -> Checked {
    unless(operation.operands().len() >= 2, || {
        let accepted = "a union, an intersection or a difference has two operands at least";
        (place, "an operation has too few operands", accepted)
    })?;
    let mut operands = operation.operands().iter();
    operands.try_for_each(|operand| match operand {
        Operand::Operation(operation) => check_operation(place, operation),
        Operand::Object(_) => Ok(()),
    })
}
