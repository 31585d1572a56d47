//! Solids made of convex ones by union, intersection and difference (source: Chaillou, III.1.1.4 and IV.3.5).
//!
//! The host turns a tree into a union of products: objects intersected, objects taken away. Every product has
//! processors of its own, so that nothing has to be distributed at the pixel rate; an object that several products name
//! is loaded several times.

use std::collections::BTreeSet;

/// A tree of operations over objects, which are named by their index.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Tree {
    /// An object.
    Leaf(usize),
    /// In either.
    Union(Box<Tree>, Box<Tree>),
    /// In both.
    Intersection(Box<Tree>, Box<Tree>),
    /// In the first and not in the second.
    Difference(Box<Tree>, Box<Tree>),
}

impl Tree {
    /// Is a point in the solid, if `inside` tells for every object?
    pub fn contains(&self, inside: &dyn Fn(usize) -> bool) -> bool {
        match self {
            Tree::Leaf(object) => inside(*object),
            Tree::Union(a, b) => a.contains(inside) || b.contains(inside),
            Tree::Intersection(a, b) => a.contains(inside) && b.contains(inside),
            Tree::Difference(a, b) => a.contains(inside) && !b.contains(inside),
        }
    }
}

/// Objects intersected and objects taken away from what they have in common.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Literals {
    /// Those that contain every point of the product; one at least in the normal form of a tree.
    pub intersected: BTreeSet<usize>,
    /// Those that contain none.
    pub subtracted: BTreeSet<usize>,
}

impl Literals {
    /// Processors that the product needs.
    pub fn processors(&self) -> usize {
        self.intersected.len() + self.subtracted.len()
    }

    fn and(&self, other: &Literals) -> Literals {
        Literals {
            intersected: &self.intersected | &other.intersected,
            subtracted: &self.subtracted | &other.subtracted,
        }
    }

    fn is_empty(&self) -> bool {
        !self.intersected.is_disjoint(&self.subtracted)
    }

    /// Every point of the other product is one of this.
    fn covers(&self, other: &Literals) -> bool {
        self.intersected.is_subset(&other.intersected)
            && self.subtracted.is_subset(&other.subtracted)
    }
}

/// The normal form of a tree: products whose union it is. Products without points, and those that lie in another, are
/// left out.
///
/// It is what the rules of the source come to, of which each carries a difference or an intersection over a union, with
/// `X - Y` for `X` and not `Y`.
pub fn normal_form(tree: &Tree) -> Vec<Literals> {
    pruned(products(tree, false))
}

/// Products of a tree or of its complement.
fn products(tree: &Tree, complement: bool) -> Vec<Literals> {
    match (tree, complement) {
        (Tree::Leaf(object), _) => {
            let mut literals = Literals::default();
            let side = if complement {
                &mut literals.subtracted
            } else {
                &mut literals.intersected
            };
            side.insert(*object);
            vec![literals]
        }
        (Tree::Union(a, b), false) => either(products(a, false), products(b, false)),
        (Tree::Union(a, b), true) => both(&products(a, true), &products(b, true)),
        (Tree::Intersection(a, b), false) => both(&products(a, false), &products(b, false)),
        (Tree::Intersection(a, b), true) => either(products(a, true), products(b, true)),
        (Tree::Difference(a, b), false) => both(&products(a, false), &products(b, true)),
        (Tree::Difference(a, b), true) => either(products(a, true), products(b, false)),
    }
}

fn either(a: Vec<Literals>, b: Vec<Literals>) -> Vec<Literals> {
    pruned([a, b].concat())
}

fn both(a: &[Literals], b: &[Literals]) -> Vec<Literals> {
    pruned(a.iter().flat_map(|a| b.iter().map(|b| a.and(b))).collect())
}

fn pruned(list: Vec<Literals>) -> Vec<Literals> {
    let distinct: BTreeSet<Literals> = list.into_iter().filter(|p| !p.is_empty()).collect();
    let lies_in_another = |p: &Literals| distinct.iter().any(|other| other != p && other.covers(p));
    distinct
        .iter()
        .filter(|p| !lies_in_another(p))
        .cloned()
        .collect()
}

/// What a processor hands on of its convex object at a pixel, with the face that can be seen: the front of an
/// intersected object, the back of one taken away.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Primitive {
    /// Front depth; the far end of the format where the object is absent.
    pub zf: i64,
    /// Back depth.
    pub zb: i64,
    /// Index of the object.
    pub id: u8,
    /// Number of the face.
    pub number: u8,
}

/// A product at a pixel.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Product {
    /// Objects intersected, one at least.
    pub intersected: Vec<Primitive>,
    /// Objects taken away.
    pub subtracted: Vec<Primitive>,
}

/// What the decider hands on. The order is that of the choice between products: the least one is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Shown {
    /// Depth; the far end of the format where nothing is seen.
    pub depth: i64,
    /// The face is the back of an object taken away: its normal is to be turned.
    pub is_back: bool,
    /// Index of the object whose face it is, 0 where nothing is seen.
    pub id: u8,
    /// Number of the face, 0 where nothing is seen.
    pub number: u8,
}

impl Shown {
    fn face(of: &Primitive, depth: i64, is_back: bool) -> Shown {
        Shown {
            depth,
            is_back,
            id: of.id,
            number: of.number,
        }
    }
}

/// Places on the line of sight: `2 z` is the point at depth z, `2 z + 1` all that lies between it and the next.
/// Intervals have both ends.
fn holds(primitive: &Primitive, place: i64, z_max: i64) -> bool {
    primitive.zf < z_max && (2 * primitive.zf..=2 * primitive.zb).contains(&place)
}

impl Product {
    fn contains(&self, place: i64, z_max: i64) -> bool {
        let at = |p: &Primitive| holds(p, place, z_max);
        self.intersected.iter().all(at) && !self.subtracted.iter().any(at)
    }

    /// The first point of the product, or the first one with points of it just behind.
    pub fn front(&self, z_max: i64) -> Option<Shown> {
        // A front lies at a face.
        let fronts = self.intersected.iter().map(|p| p.zf);
        let backs = self.subtracted.iter().map(|p| p.zb);
        let faces: BTreeSet<i64> = fronts.chain(backs).filter(|&z| z < z_max).collect();
        let is_seen = |&z: &i64| {
            [2 * z, 2 * z + 1]
                .iter()
                .any(|&place| self.contains(place, z_max))
        };
        let depth = faces.into_iter().find(is_seen)?;
        let fronts = self.intersected.iter().filter(|p| p.zf == depth);
        let front = fronts.map(|p| Shown::face(p, depth, false)).min();
        let backs = self.subtracted.iter();
        let backs = backs.filter(|p| p.zb == depth && p.zf < p.zb);
        front.or_else(|| backs.map(|p| Shown::face(p, depth, true)).min())
    }
}

/// The face that is seen of the union of all products.
pub fn decide(products: &[Product], z_max: i64) -> Shown {
    let nothing = Shown {
        depth: z_max,
        is_back: false,
        id: 0,
        number: 0,
    };
    let fronts = products.iter().filter_map(|p| p.front(z_max));
    fronts.min().unwrap_or(nothing)
}

/// Clocks after the intersected objects at which those taken away are used: the tree of the intersection comes first.
pub const fn skew(intersected: usize) -> usize {
    levels(intersected)
}

/// Latency in clocks from the intersected objects: the intersection, one clock for the candidates, the choice among all
/// of them.
pub const fn latency(products: usize, intersected: usize, subtracted: usize) -> u32 {
    (levels(intersected) + 1 + levels(products * (1 + subtracted))) as u32
}

const fn levels(inputs: usize) -> usize {
    inputs.next_power_of_two().trailing_zeros() as usize
}

#[cfg(test)]
mod tests;
