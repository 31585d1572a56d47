//! The normal form against the tree, point by point; the front of a product against a scan of all places.

use super::*;
use proptest::prelude::*;
use std::ops::{BitAnd, BitOr, Sub};

fn leaf(object: usize) -> Tree {
    Tree::Leaf(object)
}

impl BitOr for Tree {
    type Output = Tree;
    fn bitor(self, other: Tree) -> Tree {
        Tree::Union(Box::new(self), Box::new(other))
    }
}

impl BitAnd for Tree {
    type Output = Tree;
    fn bitand(self, other: Tree) -> Tree {
        Tree::Intersection(Box::new(self), Box::new(other))
    }
}

impl Sub for Tree {
    type Output = Tree;
    fn sub(self, other: Tree) -> Tree {
        Tree::Difference(Box::new(self), Box::new(other))
    }
}

fn literals(intersected: &[usize], subtracted: &[usize]) -> Literals {
    Literals {
        intersected: intersected.iter().copied().collect(),
        subtracted: subtracted.iter().copied().collect(),
    }
}

fn in_products(products: &[Literals], inside: &dyn Fn(usize) -> bool) -> bool {
    products.iter().any(|p| {
        p.intersected.iter().all(|&o| inside(o)) && !p.subtracted.iter().any(|&o| inside(o))
    })
}

/// All memberships of a number of objects.
fn assert_same(tree: &Tree, products: &[Literals], objects: usize) {
    for assignment in 0u32..1 << objects {
        let inside = |object: usize| assignment >> object & 1 == 1;
        let (wanted, found) = (tree.contains(&inside), in_products(products, &inside));
        assert_eq!(found, wanted, "{tree:?} at {assignment:b}");
    }
}

/// All trees over objects `first..first + count` in their order, with every operation at every place.
fn trees(first: usize, count: usize) -> Vec<Tree> {
    if count == 1 {
        return vec![leaf(first)];
    }
    let mut list = Vec::new();
    for left in 1..count {
        for a in trees(first, left) {
            for b in trees(first + left, count - left) {
                list.push(a.clone() | b.clone());
                list.push(a.clone() & b.clone());
                list.push(a.clone() - b.clone());
            }
        }
    }
    list
}

/// The rules of the source's figure 3.9, each side a tree.
#[test]
fn the_rules_of_normalisation_hold() {
    let [x, y, z] = [0, 1, 2].map(|object| move || leaf(object));
    let rules = [
        (x() - (y() | z()), x() - y() - z()),
        (x() & (y() | z()), (x() & y()) | (x() & z())),
        (x() - (y() & z()), (x() - y()) | (x() - z())),
        (x() & (y() & z()), (x() & y()) & z()),
        (x() - (y() - z()), (x() - y()) | (x() & z())),
        (x() & (y() - z()), (x() & y()) - z()),
        ((x() | y()) - z(), (x() - z()) | (y() - z())),
        ((x() | y()) & z(), (x() & z()) | (y() & z())),
    ];
    for (before, after) in rules {
        assert_eq!(normal_form(&before), normal_form(&after), "{before:?}");
        assert_same(&before, &normal_form(&after), 3);
    }
}

/// Every tree of up to five different objects, and every membership.
#[test]
fn the_normal_form_has_the_points_of_the_tree() {
    for count in 1..=5 {
        for tree in trees(0, count) {
            let products = normal_form(&tree);
            assert_same(&tree, &products, count);
            assert!(
                products.iter().all(|p| !p.intersected.is_empty()),
                "{tree:?}"
            );
        }
    }
}

/// Figure 3.10 prints two products for `((A u B) ^ C) - (D ^ E)`; they are those of `- (D u E)`.
#[test]
fn the_printed_example_of_a_normal_form_is_wrong() {
    let [a, b, c, d, e] = [0, 1, 2, 3, 4];
    let solid = (leaf(a) | leaf(b)) & leaf(c);
    let tree = solid.clone() - (leaf(d) & leaf(e));
    let printed = [literals(&[a, c], &[d, e]), literals(&[b, c], &[d, e])];
    let inside = |object: usize| [a, c, d].contains(&object);
    assert!(tree.contains(&inside));
    assert!(!in_products(&printed, &inside));
    let right = [
        literals(&[a, c], &[d]),
        literals(&[a, c], &[e]),
        literals(&[b, c], &[d]),
        literals(&[b, c], &[e]),
    ];
    assert_eq!(normal_form(&tree), right);
    assert_same(&tree, &right, 5);
    let united = solid - (leaf(d) | leaf(e));
    assert_eq!(normal_form(&united), printed);
}

#[test]
fn products_without_points_or_within_others_are_left_out() {
    let [x, y] = [0, 1].map(|object| move || leaf(object));
    assert_eq!(normal_form(&(x() - x())), []);
    let absorbed = x() | (x() & y());
    assert_eq!(normal_form(&absorbed), [literals(&[0], &[])]);
    let again = x() - (x() - y());
    assert_eq!(normal_form(&again), [literals(&[0, 1], &[])]);
    let twice = (x() - y()) | (x() - y());
    assert_eq!(normal_form(&twice), [literals(&[0], &[1])]);
}

/// What duplication costs: over all trees of so many different objects, the mean and the most of products, of
/// processors, and of places in a decider that has as many in each product as the largest needs.
#[test]
fn cost_of_duplication() {
    let mut found = Vec::new();
    for count in 1..=6 {
        let forms: Vec<Vec<Literals>> = trees(0, count).iter().map(normal_form).collect();
        let processors = |form: &Vec<Literals>| form.iter().map(Literals::processors).sum();
        let needed: Vec<usize> = forms.iter().map(processors).collect();
        let products: Vec<usize> = forms.iter().map(Vec::len).collect();
        let padded = |form: &Vec<Literals>| {
            let most = |side: fn(&Literals) -> usize| form.iter().map(side).max().unwrap_or(0);
            form.len() * (most(|p| p.intersected.len()) + most(|p| p.subtracted.len()))
        };
        let places: Vec<usize> = forms.iter().map(padded).collect();
        // In hundredths, rounded.
        let mean =
            |list: &[usize]| (100 * list.iter().sum::<usize>() + list.len() / 2) / list.len();
        let most = |list: &[usize]| *list.iter().max().expect("a tree");
        found.push((
            count,
            forms.len(),
            [mean(&products), most(&products)],
            [mean(&needed), most(&needed)],
            [mean(&places), most(&places)],
        ));
    }
    let expected = [
        (1, 1, [100, 1], [100, 1], [100, 1]),
        (2, 3, [133, 2], [200, 2], [200, 2]),
        (3, 18, [172, 3], [328, 4], [361, 6]),
        (4, 135, [216, 4], [490, 8], [583, 12]),
        (5, 1134, [266, 6], [692, 12], [871, 20]),
        (6, 10206, [322, 9], [943, 24], [1235, 40]),
    ];
    assert_eq!(found, expected);
    let page = include_str!("../../../../../docs/architecture.md");
    for (leaves, trees, [products, most_products], [needed, most_needed], [places, most_places]) in
        expected
    {
        let [products, needed, places] =
            [products, needed, places].map(|n| format!("{}.{:02}", n / 100, n % 100));
        let row = format!(
            "| {leaves} | {trees} | {products} | {most_products} | {needed} | {most_needed} | {places} | {most_places} |"
        );
        assert!(page.contains(&row), "docs/architecture.md has no row {row}");
    }
}

/// Far end of the small scale of levels.
const FAR: i64 = 7;

fn primitive(id: usize, (zf, zb): (i64, i64)) -> Primitive {
    Primitive {
        zf,
        zb,
        id: id as u8,
        number: 0,
    }
}

/// Every interval on levels 0 to `levels - 1`, sheets too, and an absent object.
fn intervals(levels: i64) -> Vec<(i64, i64)> {
    let mut list = vec![(FAR, 0)];
    for zf in 0..levels {
        list.extend((zf..levels).map(|zb| (zf, zb)));
    }
    list
}

/// The first level that is in, or that has something in just behind it, of all levels.
fn scan(contains: impl Fn(i64) -> bool) -> Option<i64> {
    (0..FAR).find(|z| contains(2 * z) || contains(2 * z + 1))
}

/// Calls `visit` with every choice of one interval for each object.
fn for_each_choice(objects: usize, levels: i64, mut visit: impl FnMut(&[Primitive])) {
    let list = intervals(levels);
    for mut number in 0..list.len().pow(objects as u32) {
        let choice: Vec<Primitive> = (0..objects)
            .map(|id| {
                let interval = list[number % list.len()];
                number /= list.len();
                primitive(id, interval)
            })
            .collect();
        visit(&choice);
    }
}

fn product(intersected: &[Primitive], subtracted: &[Primitive]) -> Product {
    Product {
        intersected: intersected.to_vec(),
        subtracted: subtracted.to_vec(),
    }
}

/// The candidates are enough: the front of the intersection and the backs of what is taken away, each tested against
/// all others.
fn candidates(product: &Product) -> Option<i64> {
    let front = product.intersected.iter().map(|p| p.zf).max()?;
    let back = product.intersected.iter().map(|p| p.zb).min()?;
    let is_free = |z: i64| !product.subtracted.iter().any(|p| p.zf <= z && z < p.zb);
    let touches = |p: &Primitive| p.zf <= front && front == p.zb;
    let is_sheet_free = front < back || !product.subtracted.iter().any(touches);
    let is_front_seen = front < FAR && front <= back && is_free(front) && is_sheet_free;
    let backs = product
        .subtracted
        .iter()
        .filter(|p| p.zf < p.zb)
        .map(|p| p.zb);
    let backs = backs.filter(|&z| front < z && z < back && is_free(z));
    is_front_seen
        .then_some(front)
        .into_iter()
        .chain(backs)
        .min()
}

#[test]
fn the_front_is_the_first_candidate_that_survives() {
    for (intersected, subtracted, levels) in [
        (1, 0, 5),
        (1, 1, 5),
        (2, 1, 5),
        (1, 2, 5),
        (2, 2, 4),
        (1, 3, 4),
    ] {
        for_each_choice(intersected + subtracted, levels, |choice| {
            let (intersected, subtracted) = choice.split_at(intersected);
            let product = product(intersected, subtracted);
            let expected = scan(|place| product.contains(place, FAR));
            assert_eq!(candidates(&product), expected, "{product:?}");
            assert_eq!(product.front(FAR).map(|s| s.depth), expected, "{product:?}");
        });
    }
}

/// One chain of cells that move the front behind what covers it.
fn moved(front: i64, subtracted: &[Primitive]) -> i64 {
    let cell = |z, p: &Primitive| if p.zf <= z && z < p.zb { p.zb } else { z };
    subtracted.iter().fold(front, cell)
}

/// Objects taken away may uncover each other in a cascade: a chain needs them sorted, and no order is right on all
/// pixels.
#[test]
fn a_chain_of_cells_is_not_enough() {
    let solid = primitive(0, (0, 6));
    let [near, far] = [primitive(1, (0, 3)), primitive(2, (3, 5))];
    let product = |subtracted: &[Primitive]| product(&[solid], subtracted);
    for order in [[near, far], [far, near]] {
        assert_eq!(product(&order).front(FAR).map(|s| s.depth), Some(5));
    }
    assert_eq!(moved(0, &[near, far]), 5);
    assert_eq!(moved(0, &[far, near]), 3);
    // As many passes as objects are: each but the last moves the front for good.
    for_each_choice(3, 5, |choice| {
        let front = (0..3).fold(0, |front, _| moved(front, choice));
        let mut whole = product(choice);
        whole.intersected = vec![primitive(9, (0, 6))];
        assert_eq!(whole.front(FAR).map(|s| s.depth), Some(front));
    });
}

#[test]
fn faces_and_ties() {
    let at = |zf, zb, id, number| Primitive { zf, zb, id, number };
    let shown = |depth, is_back, id, number| Shown {
        depth,
        is_back,
        id,
        number,
    };
    let nothing = shown(FAR, false, 0, 0);
    type Case<'a> = (&'a [Primitive], &'a [Primitive], Shown);
    let cases: [Case; 7] = [
        // Of two fronts at one depth the smaller id; of two backs likewise.
        (
            &[at(2, 5, 8, 1), at(2, 6, 3, 2)],
            &[],
            shown(2, false, 3, 2),
        ),
        (
            &[at(0, 6, 1, 1)],
            &[at(0, 3, 9, 4), at(0, 3, 7, 5)],
            shown(3, true, 7, 5),
        ),
        // What ends where the solid begins takes nothing away, and what ends where the solid ends leaves nothing.
        (&[at(3, 6, 9, 1)], &[at(0, 3, 1, 2)], shown(3, false, 9, 1)),
        (&[at(0, 6, 9, 1)], &[at(0, 6, 1, 2)], nothing),
        // A solid of no thickness is there, unless something touches it; of no thickness, nothing is taken away.
        (&[at(4, 4, 9, 1)], &[], shown(4, false, 9, 1)),
        (&[at(4, 4, 9, 1)], &[at(0, 4, 1, 2)], nothing),
        (&[at(0, 6, 9, 1)], &[at(0, 0, 1, 2)], shown(0, false, 9, 1)),
    ];
    for (intersected, subtracted, expected) in cases {
        assert_eq!(decide(&[product(intersected, subtracted)], FAR), expected);
    }
    // Between products a front goes before a back, then the smaller id.
    let cut = product(&[at(0, 6, 1, 1)], &[at(0, 3, 2, 2)]);
    let other = product(&[at(3, 5, 7, 3)], &[]);
    for products in [[cut.clone(), other.clone()], [other, cut]] {
        assert_eq!(decide(&products, FAR), shown(3, false, 7, 3));
    }
    assert_eq!(decide(&[], FAR), nothing);
}

#[test]
fn latency_counts_the_two_trees_and_the_candidates() {
    let shapes = [(1, 1, 0), (1, 1, 1), (2, 2, 2), (4, 3, 2)];
    assert_eq!(shapes.map(|(g, i, s)| latency(g, i, s)), [1, 2, 5, 7]);
    assert_eq!([1, 2, 3, 4, 5].map(skew), [0, 1, 2, 2, 3]);
}

/// A random tree over objects that may come several times.
fn any_tree() -> impl Strategy<Value = Tree> {
    (1usize..=6).prop_flat_map(|count| {
        let objects = proptest::collection::vec(0usize..6, count);
        let operations =
            proptest::collection::vec((0u8..3, any::<prop::sample::Index>()), count - 1);
        (objects, operations).prop_map(|(objects, operations)| {
            let mut parts: Vec<Tree> = objects.into_iter().map(leaf).collect();
            for (operation, place) in operations {
                let place = place.index(parts.len() - 1);
                let b = parts.remove(place + 1);
                let a = std::mem::replace(&mut parts[place], leaf(0));
                parts[place] = match operation {
                    0 => a | b,
                    1 => a & b,
                    _ => a - b,
                };
            }
            parts.remove(0)
        })
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// From a tree of up to six leaves to the depth that is seen, against a scan of the tree's points.
    #[test]
    fn the_decider_sees_the_front_of_the_tree(
        tree in any_tree(),
        choice in proptest::collection::vec(proptest::sample::select(intervals(FAR)), 6),
    ) {
        let objects: Vec<Primitive> =
            choice.into_iter().enumerate().map(|(id, interval)| primitive(id, interval)).collect();
        let products: Vec<Product> = normal_form(&tree)
            .iter()
            .map(|p| Product {
                intersected: p.intersected.iter().map(|&o| objects[o]).collect(),
                subtracted: p.subtracted.iter().map(|&o| objects[o]).collect(),
            })
            .collect();
        let expected = scan(|place| tree.contains(&|object| holds(&objects[object], place, FAR)));
        prop_assert_eq!(decide(&products, FAR).depth, expected.unwrap_or(FAR));
    }
}
