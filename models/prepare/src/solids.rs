//! Solids as unions of products, each with the words of its objects (source: Chaillou, III.1.1.4 and IV.3.5).
//!
//! The host turns a tree into a union of products: objects intersected, objects taken away. Every product has
//! processors of its own, so that nothing has to be distributed at the pixel rate; an object that several products name
//! is loaded several times.

use super::context::Context;
use super::error::PrepareError;
use super::prepared::PreparedObject;
use imogene_contract::words::{MOST_MEMBERS, MOST_OBJECTS};
use imogene_golden::object::member::MemberWords;
use imogene_golden::object::quadric::{MAX_PLANES, PlaneWords, QuadricWords, ScreenBox};
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_scene::{FramedScene, FramedSolid, Tree};
use std::collections::BTreeSet;

/// Most processors of all solids: a machine has no more.
const MOST_LOADED: usize = MOST_OBJECTS as usize;

/// Objects intersected and objects taken away from what they have in common.
#[derive(Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Product {
    /// Those that contain every point of the product; one at least in the normal form of a tree.
    pub intersected: BTreeSet<usize>,
    /// Those that contain none.
    pub subtracted: BTreeSet<usize>,
}

impl Product {
    fn and(&self, other: &Product) -> Product {
        Product {
            intersected: &self.intersected | &other.intersected,
            subtracted: &self.subtracted | &other.subtracted,
        }
    }

    fn is_empty(&self) -> bool {
        !self.intersected.is_disjoint(&self.subtracted)
    }

    /// Every point of the other product is one of this.
    fn covers(&self, other: &Product) -> bool {
        self.intersected.is_subset(&other.intersected)
            && self.subtracted.is_subset(&other.subtracted)
    }

    /// How many objects it intersects, and how many it takes away.
    pub fn size(&self) -> [usize; 2] {
        [self.intersected.len(), self.subtracted.len()]
    }
}

/// The normal form of a tree: products whose union it is. Products without points, and those that lie in another, are
/// left out.
///
/// It is what the rules of the source come to, of which each carries a difference or an intersection over a union, with
/// `X - Y` for `X` and not `Y`.
/// `None` if an operation on the way has far more products than can be loaded.
pub fn normal_form(tree: &Tree) -> Option<Vec<Product>> {
    products(tree, false)
}

/// Products of a tree or of its complement.
fn products(tree: &Tree, complement: bool) -> Option<Vec<Product>> {
    match tree {
        Tree::Object(object) => {
            let mut product = Product::default();
            let side = match complement {
                true => &mut product.subtracted,
                false => &mut product.intersected,
            };
            side.insert(*object);
            Some(vec![product])
        }
        Tree::Union(parts) if complement => intersection(parts, |_| true),
        Tree::Union(parts) => union(parts, |_| false),
        Tree::Intersection(parts) if complement => union(parts, |_| true),
        Tree::Intersection(parts) => intersection(parts, |_| false),
        // The first, and not the others.
        Tree::Difference(parts) if complement => union(parts, |place| place == 0),
        Tree::Difference(parts) => intersection(parts, |place| place > 0),
    }
}

/// Products of the union of parts, of those by their place that are asked for the complement.
fn union(parts: &[Tree], complement: impl Fn(usize) -> bool) -> Option<Vec<Product>> {
    let each = parts.iter().enumerate();
    let each = each.map(|(place, part)| products(part, complement(place)));
    Some(pruned(each.collect::<Option<Vec<_>>>()?.concat()))
}

/// The same of their intersection.
fn intersection(parts: &[Tree], complement: impl Fn(usize) -> bool) -> Option<Vec<Product>> {
    let mut all = vec![Product::default()];
    for (place, part) in parts.iter().enumerate() {
        let own = products(part, complement(place))?;
        if all.len() * own.len() > 16 * MOST_LOADED {
            return None;
        }
        let pairs = all.iter().flat_map(|a| own.iter().map(|b| a.and(b)));
        all = pruned(pairs.collect());
    }
    Some(all)
}

fn pruned(list: Vec<Product>) -> Vec<Product> {
    let distinct: BTreeSet<Product> = list.into_iter().filter(|p| !p.is_empty()).collect();
    let lies_in_another = |p: &Product| distinct.iter().any(|other| other != p && other.covers(p));
    let kept = distinct.iter().filter(|p| !lies_in_another(p));
    kept.cloned().collect()
}

/// The solids of a scene as a machine is loaded with them.
#[derive(Clone, Debug, Default)]
pub struct PreparedSolids {
    /// Products of all of them.
    pub products: Vec<Product>,
    /// The objects that are not seen by themselves.
    pub members: BTreeSet<usize>,
    /// Processors of the members, product by product: those of the objects intersected, then those of the objects
    /// taken away.
    pub slots: Vec<Slot>,
}

impl PreparedSolids {
    pub(super) fn of(
        scene: &FramedScene,
        objects: &[PreparedObject],
        context: &Context,
    ) -> Result<PreparedSolids, PrepareError> {
        let mut solids = PreparedSolids::default();
        for solid in &scene.solids {
            refuse_shadows(scene, solid)?;
            let too_many = || PrepareError::Products(solid.name.clone());
            let products = normal_form(&solid.tree).ok_or_else(too_many)?;
            for product in products {
                let size = product.size();
                if size.into_iter().any(|count| count > MOST_MEMBERS as usize) {
                    return Err(PrepareError::Product(solid.name.clone(), size));
                }
                let members = product.intersected.iter().chain(&product.subtracted);
                let members: Vec<usize> = members.copied().collect();
                let words = members
                    .iter()
                    .map(|&id| words(&objects[id], solid, context));
                let words = words.collect::<Result<Vec<QuadricWords>, _>>()?;
                solids.load(product, &members, &words);
            }
            solids.members.extend(solid.tree.objects());
            if solids.slots.len() > MOST_LOADED {
                return Err(too_many());
            }
        }
        Ok(solids)
    }

    fn load(&mut self, product: Product, members: &[usize], words: &[QuadricWords]) {
        let intersected = product.intersected.len();
        let behind = words[intersected..].iter().map(seen_from_behind);
        let objects: Vec<QuadricWords> =
            words[..intersected].iter().cloned().chain(behind).collect();
        let slots = members.iter().enumerate().map(|(place, &object)| {
            let words = MemberWords {
                objects: objects.clone(),
                intersected,
                place,
            };
            let words = ProcessorWords::Member(Box::new(words));
            Slot {
                object,
                words,
                weight: None,
            }
        });
        self.slots.extend(slots);
        self.products.push(product);
    }
}

/// A shadow volume of a member would be that of the whole object.
fn refuse_shadows(scene: &FramedScene, solid: &FramedSolid) -> Result<(), PrepareError> {
    let Some(light) = scene.sources.iter().position(|source| source.shadows) else {
        return Ok(());
    };
    let members = solid.tree.objects().into_iter();
    let mut members = members.map(|id| &scene.objects[id]);
    match members.find(|object| object.caster().is_some()) {
        Some(object) => {
            let (solid, object) = (solid.name.clone(), object.name().to_owned());
            Err(PrepareError::SolidShadow(solid, object, light))
        }
        None => Ok(()),
    }
}

fn words(
    object: &PreparedObject,
    solid: &FramedSolid,
    context: &Context,
) -> Result<QuadricWords, PrepareError> {
    let refused = |problem: String| {
        PrepareError::Member(solid.name.clone(), object.name().to_owned(), problem)
    };
    // What is nowhere on the screen has no words.
    let Some(words) = object.words().into_iter().next() else {
        return Ok(QuadricWords {
            screen_box: ScreenBox::EMPTY,
            ..QuadricWords::default()
        });
    };
    let words = words.on_quadric_processor(&context.format, MAX_PLANES);
    let words = words.map_err(|why| refused(why.to_string()))?;
    match twice_met(&words, context) {
        Some((x, y)) => Err(refused(format!(
            "is met twice by the line of sight of pixel ({x}, {y}); cut one of its two parts off, or make an object of each"
        ))),
        None => Ok(words),
    }
}

/// A pixel whose line of sight meets an object in two pieces.
fn twice_met(words: &QuadricWords, context: &Context) -> Option<(i64, i64)> {
    let format = &context.format;
    let is_met_twice = |&(x, y): &(i64, i64)| {
        let (a, b) = words.probe_at(x, y, format).halves;
        a.is_present(format) && b.is_present(format)
    };
    match words.class {
        Class::Front => words.screen_box.each().find(is_met_twice),
        _ => None,
    }
}

/// The words of an object seen from behind: every depth is the complement of what it was, so that the back is in
/// front. Normals point inwards, as those of a hole do.
pub fn seen_from_behind(words: &QuadricWords) -> QuadricWords {
    let plane = |plane: &PlaneWords| {
        let (kind, depth) = match plane.kind {
            PlaneKind::Front => (PlaneKind::Back, complement(&plane.depth)),
            PlaneKind::Back => (PlaneKind::Front, complement(&plane.depth)),
            kind => (kind, plane.depth),
        };
        PlaneWords {
            kind,
            depth,
            normal: plane.normal.map(|part| part.saturating_neg()),
        }
    };
    let mut behind = words.clone();
    behind.f1 = complement(&words.f1);
    behind.normal.g = words.normal.g.each_ref().map(complement);
    behind.planes = words.planes.iter().map(plane).collect();
    behind
}

/// `-v - 1` for every value v: no value leaves the word of the original.
fn complement(linear: &Linear) -> Linear {
    Linear::new(-linear.a, -linear.b, -linear.c - 1)
}
