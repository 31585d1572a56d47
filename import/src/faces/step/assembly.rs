//! Representations, and where they are placed in each other (ISO 10303-43, -44).

use super::placement::{Placement, placement};
use super::units::{Context, context};
use indexmap::IndexMap;
use std::collections::{HashMap, HashSet};
use step21::{Args, Entity, Error, Exchange, Result};

const DEEPEST: usize = 64;
const MOST_PLACED: usize = 10_000;

#[derive(Clone, Copy, Debug)]
pub struct Placed<'a> {
    pub representation: Args<'a>,
    pub place: Placement,
    /// Its number among those of its kind, from 0.
    pub group: usize,
    /// Which placement of its group this is.
    pub occurrence: usize,
}

/// A representation inside another.
#[derive(Clone, Copy, Debug)]
struct Link {
    child: usize,
    place: Placement,
    /// The entity that says so, for messages.
    id: u64,
}

/// A representation and a placement in it that comes to be where one of another is, the inner first.
type Ends = [(usize, Placement); 2];

/// The representations of a file. Those that a relationship without a placement joins are one group.
pub struct Assembly<'a> {
    file: &'a Exchange<'a>,
    /// Without units.
    context: Context,
    /// By the numbers of their entities.
    representations: IndexMap<u64, Args<'a>>,
    group: Vec<usize>,
    links: HashMap<usize, Vec<Link>>,
    /// Products by their groups: the number and the name.
    products: HashMap<usize, (u64, String)>,
    /// Groups that describe a property of a product or of an aspect of its shape, and are no part.
    properties: HashSet<usize>,
    /// Groups that are placed by words that cannot be followed.
    lost: HashSet<usize>,
    /// Why placements are left out.
    pub notes: Vec<String>,
}

const PLACING: [&str; 2] = [
    "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION",
    "SHAPE_REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION",
];
const PLACED: &str = "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION";
/// What says of what a representation is.
const DEFINING: [&str; 2] = [
    "SHAPE_DEFINITION_REPRESENTATION",
    "PROPERTY_DEFINITION_REPRESENTATION",
];

impl<'a> Assembly<'a> {
    pub fn read(file: &'a Exchange<'a>) -> Self {
        let mut all = Assembly {
            file,
            context: Context::of(file),
            representations: IndexMap::new(),
            group: vec![],
            links: HashMap::new(),
            products: HashMap::new(),
            properties: HashSet::new(),
            lost: HashSet::new(),
            notes: vec![],
        };
        for entity in file.entities() {
            let is_shape = |name: &str| name.ends_with("SHAPE_REPRESENTATION") && name != PLACED;
            let Some(record) = entity.records.iter().find(|r| is_shape(r.name)) else {
                continue;
            };
            let whole = entity.complex.then_some("REPRESENTATION");
            if let Some(args) = entity.find(&[whole.unwrap_or(record.name)]) {
                all.group.push(all.representations.len());
                all.representations.insert(entity.id, args);
            }
        }
        all.join();
        all.name_products();
        all.place_components();
        all.place_mapped();
        all
    }

    /// Keeps what was found, and says why something was not.
    fn keep<T>(&mut self, what: &str, found: Result<T>) -> Option<T> {
        let found = found.map_err(|error| self.notes.push(format!("{what}: {error}")));
        found.ok()
    }

    /// The number of a representation.
    fn index(&self, entity: Entity) -> Option<usize> {
        self.representations.get_index_of(&entity.id)
    }

    /// The two representations of a relationship, whichever of its subtypes says so; `None` if one is not of a shape.
    fn relation(&self, args: &Args<'a>) -> Result<Option<[usize; 2]>> {
        let args = args.of("REPRESENTATION_RELATIONSHIP")?;
        let ends = [args.entity(2)?, args.entity(3)?].map(|end| self.index(end));
        Ok(ends[0].zip(ends[1]).map(<[usize; 2]>::from))
    }

    /// Relationships without a placement: joined representations are a group, with the number of the first of them.
    fn join(&mut self) {
        let names = [
            "SHAPE_REPRESENTATION_RELATIONSHIP",
            "REPRESENTATION_RELATIONSHIP",
        ];
        let joined = self.file.all(&names);
        for args in joined.filter(|args| args.entity.find(&PLACING).is_none()) {
            let ends = self.relation(&args);
            if let Some(Some(ends)) = self.keep("a relationship is left out", ends) {
                let [one, other] = ends.map(|end| self.first(end));
                self.group[one.max(other)] = one.min(other);
            }
        }
        for index in 0..self.group.len() {
            self.group[index] = self.first(index);
        }
    }

    /// The first of the representations that are joined with one; the way to it is shortened.
    fn first(&mut self, mut index: usize) -> usize {
        while self.group[index] != index {
            self.group[index] = self.group[self.group[index]];
            index = self.group[index];
        }
        index
    }

    /// The product of a representation, or that it has none: CAD systems hang shapes on properties for validation.
    fn name_products(&mut self) {
        for args in self.file.all(&DEFINING) {
            // Words that name no representation name no part either.
            let Ok(Some(index)) = args.entity(1).map(|entity| self.index(entity)) else {
                continue;
            };
            let group = self.group[index];
            if let Some(product) = product(&args) {
                self.products.entry(group).or_insert(product);
            } else {
                self.properties.insert(group);
            }
        }
    }

    pub fn context(&self, representation: &Args) -> Result<Context> {
        context(representation.maybe(2)?, self.context)
    }

    /// `NEXT_ASSEMBLY_USAGE_OCCURRENCE` and what places it.
    fn place_components(&mut self) {
        let file = self.file;
        let usages = file.all(&[PLACED]);
        let wholes: HashMap<u64, u64> = usages.filter_map(|args| usage(&args)).collect();
        for placed in file.all(&PLACING) {
            let child = self.relation(&placed).ok().flatten().map(|ends| ends[0]);
            let ends = self.component(&placed, &wholes);
            self.link("a component is left out", placed.entity.id, ends, child);
        }
    }

    /// Keeps where the entity of a number places something; a child whose place is not known is lost.
    fn link(&mut self, what: &str, id: u64, found: Result<Option<Ends>>, child: Option<usize>) {
        if found.is_err() {
            self.lost.extend(child.map(|child| self.group[child]));
        }
        if let Some(Some([(child, own), (parent, there)])) = self.keep(what, found) {
            let child = self.group[child];
            let place = there.after(&own.inverse());
            let links = self.links.entry(self.group[parent]).or_default();
            links.push(Link { child, place, id });
        }
    }

    fn component(&self, placed: &Args<'a>, wholes: &HashMap<u64, u64>) -> Result<Option<Ends>> {
        let Some([first, second]) = self.relation(placed)? else {
            return Ok(None);
        };
        let last = if placed.entity.complex { 0 } else { 4 };
        let operator = placed.named(last, &["ITEM_DEFINED_TRANSFORMATION"])?;
        let inner = self.frame(first, &operator, 2)?;
        let mut ends = [inner, self.frame(second, &operator, 3)?];
        // The first is the component, unless its product is the one that uses.
        let whole = wholes.get(&placed.entity.id).copied();
        if whole.is_some() && whole == self.product_of(self.group[first]) {
            ends.reverse();
        }
        Ok(Some(ends))
    }

    fn place_mapped(&mut self) {
        for index in 0..self.representations.len() {
            let own = self.representations[index];
            // Items that cannot be read are reported where the solids are.
            let items = own.list(1).unwrap_or_default().iter();
            let items = items.filter_map(|item| own.as_entity(item).ok());
            for item in items.filter_map(|item| item.find(&["MAPPED_ITEM"])) {
                let map = item.named(1, &["REPRESENTATION_MAP"]);
                let source = map.and_then(|map| map.entity(1)).ok();
                let child = source.and_then(|entity| self.index(entity));
                let ends = self.mapped(index, &item);
                self.link("a mapped item is left out", item.entity.id, ends, child);
            }
        }
    }

    fn mapped(&self, index: usize, item: &Args<'a>) -> Result<Option<Ends>> {
        let map = item.named(1, &["REPRESENTATION_MAP"])?;
        let Some(source) = self.index(map.entity(1)?) else {
            return Ok(None);
        };
        let inner = self.frame(source, &map, 0)?;
        Ok(Some([inner, self.frame(index, item, 2)?]))
    }

    /// A representation with a placement in it that is named.
    fn frame(&self, index: usize, args: &Args, place: usize) -> Result<(usize, Placement)> {
        let context = self.context(&self.representations[index])?;
        Ok((index, placement(args.entity(place)?, &context)?))
    }

    pub fn product_of(&self, group: usize) -> Option<u64> {
        self.products.get(&group).map(|(id, _)| *id)
    }

    /// The name of the product of a group; empty if it has none.
    pub fn name(&self, group: usize) -> &str {
        self.products.get(&group).map_or("", |(_, name)| name)
    }

    /// What is placed in nothing else: the products; in a file without products, all that describes no property.
    fn roots(&self) -> Vec<usize> {
        let links = self.links.values().flatten();
        let mut inner: HashSet<usize> = links.map(|link| link.child).collect();
        inner.extend(&self.lost);
        let is_part = |group: &usize| match self.products.is_empty() {
            true => !self.properties.contains(group),
            false => self.products.contains_key(group),
        };
        let groups = (0..self.group.len()).filter(|index| self.group[*index] == *index);
        let outer = groups.filter(|group| !inner.contains(group));
        outer.filter(is_part).collect()
    }

    /// All representations where they are placed, whole assemblies first.
    pub fn placed(&self) -> Result<Vec<Placed<'a>>> {
        let roots = self.roots().into_iter().rev();
        let in_place = roots.map(|group| (group, Placement::IN_PLACE, 0, 0));
        let mut waiting: Vec<(usize, Placement, usize, u64)> = in_place.collect();
        let mut members = vec![vec![]; self.group.len()];
        for (index, group) in self.group.iter().enumerate() {
            members[*group].push(index);
        }
        let mut placed = vec![];
        let mut occurrence = 0;
        while let Some((group, place, depth, id)) = waiting.pop() {
            if depth > DEEPEST || placed.len() > MOST_PLACED {
                let at = self.file.get(id).map_or(0, |entity| entity.at);
                let problem =
                    format!("`#{id}` places a part in itself, or too many parts in each other");
                let accepted = format!(
                    "at most {DEEPEST} assemblies in each other and {MOST_PLACED} placements are possible"
                );
                return Err(Error::at(self.file.bytes, at, problem, accepted));
            }
            placed.extend(members[group].iter().map(|index| Placed {
                representation: self.representations[*index],
                place,
                group,
                occurrence,
            }));
            occurrence += 1;
            let links = self.links.get(&group).into_iter().flatten().rev();
            waiting.extend(links.map(|l| (l.child, place.after(&l.place), depth + 1, l.id)));
        }
        match self.representations.values().next() {
            Some(first) if placed.is_empty() => Err(first.error(
                "it is placed in itself, or in nothing that is a part",
                "parts that contain each other in one direction are needed",
            )),
            _ => Ok(placed),
        }
    }
}

/// The relationship that places a usage, and the product that uses.
fn usage(args: &Args) -> Option<(u64, u64)> {
    let shape = args.named(1, &["PRODUCT_DEFINITION_SHAPE"]).ok()?;
    let usage = shape.entity(2).ok()?;
    let usage = usage.find(&["NEXT_ASSEMBLY_USAGE_OCCURRENCE"])?;
    Some((args.entity(0).ok()?.id, usage.entity(3).ok()?.id))
}

/// The number and the name of the product whose shape a representation is.
fn product(args: &Args) -> Option<(u64, String)> {
    let names = [
        "PRODUCT_DEFINITION",
        "PRODUCT_DEFINITION_WITH_ASSOCIATED_DOCUMENTS",
    ];
    let shape = args.entity(0).ok()?.find(&["PRODUCT_DEFINITION_SHAPE"])?;
    let definition = shape.entity(2).ok()?.find(&names)?;
    let formations = [
        "PRODUCT_DEFINITION_FORMATION",
        "PRODUCT_DEFINITION_FORMATION_WITH_SPECIFIED_SOURCE",
    ];
    // A product may have no words for its name.
    let name = || {
        let formation = definition.entity(2).ok()?.find(&formations)?;
        let product = formation.entity(2).ok()?.find(&["PRODUCT"])?;
        let names = [product.text(1), product.text(0)];
        names.into_iter().find(|name| !name.is_empty())
    };
    Some((definition.entity.id, name().unwrap_or_default()))
}
