//! Solids made of objects by union, intersection and difference (source: Chaillou, III.1.1.4).

use super::keys::text_or_table;
use serde::{Deserialize, Deserializer, Serialize};

/// Most objects that the tree of a solid names.
pub(super) const MAX_LEAVES: usize = 64;

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
