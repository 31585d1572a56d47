//! The normal form against the tree, point by point; an object seen from behind against itself.

use imogene_golden::format::Format;
use imogene_golden::machine::csg::{Extent, front};
use imogene_golden::object::quadric::{PlaneWords, QuadricWords, ScreenBox};
use imogene_golden::object::words::Object;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_prepare::solids::{Product, normal_form, seen_from_behind};
use imogene_scene::Tree;
use proptest::prelude::*;
use std::collections::BTreeSet;

fn leaf(object: usize) -> Tree {
    Tree::Object(object)
}

fn or(a: Tree, b: Tree) -> Tree {
    Tree::Union(vec![a, b])
}

fn and(a: Tree, b: Tree) -> Tree {
    Tree::Intersection(vec![a, b])
}

fn less(a: Tree, b: Tree) -> Tree {
    Tree::Difference(vec![a, b])
}

fn form(tree: &Tree) -> Vec<Product> {
    normal_form(tree).expect("a small tree")
}

fn product(intersected: &[usize], subtracted: &[usize]) -> Product {
    Product {
        intersected: intersected.iter().copied().collect(),
        subtracted: subtracted.iter().copied().collect(),
    }
}

fn in_products(products: &[Product], inside: &dyn Fn(usize) -> bool) -> bool {
    products.iter().any(|p| {
        p.intersected.iter().all(|&o| inside(o)) && !p.subtracted.iter().any(|&o| inside(o))
    })
}

/// All memberships of a number of objects.
fn assert_same(tree: &Tree, products: &[Product], objects: usize) {
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
                list.extend([or, and, less].map(|join| join(a.clone(), b.clone())));
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
        (less(x(), or(y(), z())), less(less(x(), y()), z())),
        (and(x(), or(y(), z())), or(and(x(), y()), and(x(), z()))),
        (less(x(), and(y(), z())), or(less(x(), y()), less(x(), z()))),
        (and(x(), and(y(), z())), and(and(x(), y()), z())),
        (less(x(), less(y(), z())), or(less(x(), y()), and(x(), z()))),
        (and(x(), less(y(), z())), less(and(x(), y()), z())),
        (less(or(x(), y()), z()), or(less(x(), z()), less(y(), z()))),
        (and(or(x(), y()), z()), or(and(x(), z()), and(y(), z()))),
    ];
    for (before, after) in rules {
        assert_eq!(form(&before), form(&after), "{before:?}");
        assert_same(&before, &form(&after), 3);
    }
}

/// Every tree of up to five different objects, and every membership.
#[test]
fn the_normal_form_has_the_points_of_the_tree() {
    for count in 1..=5 {
        for tree in trees(0, count) {
            let products = form(&tree);
            assert_same(&tree, &products, count);
            assert!(
                products.iter().all(|p| !p.intersected.is_empty()),
                "{tree:?}"
            );
        }
    }
    let several = |count: usize| (0..count).map(leaf).collect::<Vec<Tree>>();
    for tree in [
        Tree::Union(several(4)),
        Tree::Intersection(several(4)),
        Tree::Difference(several(4)),
        less(leaf(4), Tree::Difference(several(4))),
    ] {
        assert_same(&tree, &form(&tree), 5);
    }
}

/// Figure 3.10 prints two products for `((A u B) ^ C) - (D ^ E)`; they are those of `- (D u E)`.
#[test]
fn the_printed_example_of_a_normal_form_is_wrong() {
    let [a, b, c, d, e] = [0, 1, 2, 3, 4];
    let solid = || and(or(leaf(a), leaf(b)), leaf(c));
    let tree = less(solid(), and(leaf(d), leaf(e)));
    let printed = [product(&[a, c], &[d, e]), product(&[b, c], &[d, e])];
    let inside = |object: usize| [a, c, d].contains(&object);
    assert!(tree.contains(&inside));
    assert!(!in_products(&printed, &inside));
    let pairs = [(a, d), (a, e), (b, d), (b, e)];
    let right = pairs.map(|(kept, taken)| product(&[kept, c], &[taken]));
    assert_eq!(form(&tree), right);
    assert_same(&tree, &right, 5);
    assert_eq!(form(&less(solid(), or(leaf(d), leaf(e)))), printed);
}

#[test]
fn products_without_points_or_within_others_are_left_out() {
    let [x, y] = [0, 1].map(|object| move || leaf(object));
    assert_eq!(form(&less(x(), x())), []);
    assert_eq!(form(&or(x(), and(x(), y()))), [product(&[0], &[])]);
    assert_eq!(form(&less(x(), less(x(), y()))), [product(&[0, 1], &[])]);
    let twice = or(less(x(), y()), less(x(), y()));
    assert_eq!(form(&twice), [product(&[0], &[1])]);
    // Sixteen pairs to choose from: 65 536 products.
    let pair = |n: usize| or(leaf(2 * n), leaf(2 * n + 1));
    assert_eq!(
        normal_form(&Tree::Intersection((0..16).map(pair).collect())),
        None
    );
}

/// What duplication costs: over all trees of so many different objects, the mean and the most of products, of
/// processors, and of places if all products have as many as the largest needs.
#[test]
fn cost_of_duplication() {
    let mut found = Vec::new();
    for count in 1..=6 {
        let forms: Vec<Vec<Product>> = trees(0, count).iter().map(form).collect();
        let processors = |form: &Vec<Product>| form.iter().flat_map(Product::size).sum();
        let needed: Vec<usize> = forms.iter().map(processors).collect();
        let products: Vec<usize> = forms.iter().map(Vec::len).collect();
        let padded = |form: &Vec<Product>| {
            let most = |side: usize| form.iter().map(|p| p.size()[side]).max().unwrap_or(0);
            form.len() * (most(0) + most(1))
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
    let page = include_str!("../../../../docs/architecture.md");
    for (leaves, trees, [products, most_products], [needed, most_needed], [places, most_places]) in
        expected
    {
        let [products, needed, places] =
            [products, needed, places].map(|n| format!("{}.{:02}", n / 100, n % 100));
        let row = format!(
            "| {leaves} | {trees} | {products} | {most_products} | {needed} | {most_needed} | {places} \
             | {most_places} |"
        );
        assert!(page.contains(&row), "docs/architecture.md has no row {row}");
    }
}

/// A random tree over objects that may come several times.
fn any_tree() -> impl Strategy<Value = Tree> {
    let leaf = (0usize..6).prop_map(Tree::Object);
    leaf.prop_recursive(3, 8, 3, |part| {
        (proptest::collection::vec(part, 2..4), 0u8..3).prop_map(|(parts, operation)| {
            match operation {
                0 => Tree::Union(parts),
                1 => Tree::Intersection(parts),
                _ => Tree::Difference(parts),
            }
        })
    })
}

const FAR: i64 = 7;

fn any_extent() -> impl Strategy<Value = Extent> {
    let interval = (0..FAR, 0..FAR).prop_map(|(a, b)| (a.min(b), a.max(b)));
    let interval = prop_oneof![9 => interval, 1 => Just((FAR, 0))];
    interval.prop_map(|(zf, zb)| Extent { zf, zb })
}

/// Words of a quadric on a few pixels and levels, with planes; a prism is a line of sight without ends.
fn any_words() -> impl Strategy<Value = QuadricWords> {
    let linear =
        || (-9i128..10, -9i128..10, -300i128..300).prop_map(|(a, b, c)| Linear::new(a, b, c));
    let plane = || {
        let kind = prop_oneof![
            Just(PlaneKind::Front),
            Just(PlaneKind::Back),
            Just(PlaneKind::Perpendicular)
        ];
        (kind, linear(), proptest::array::uniform3(any::<i16>())).prop_map(
            |(kind, depth, normal)| PlaneWords {
                kind,
                depth,
                normal,
            },
        )
    };
    let class = prop_oneof![4 => Just(Class::Side), 1 => Just(Class::Prism)];
    let f2 = -20_000i128..60_000;
    let g = [linear(), linear(), linear()];
    let planes = proptest::collection::vec(plane(), 0..4);
    (class, linear(), f2, g, planes).prop_map(|(class, f1, f2, g, planes)| QuadricWords {
        class,
        screen_box: ScreenBox::of([0, 3], [0, 3]),
        f1,
        f2: Quadratic::new([1, -2, 0, 3, -4, f2]),
        normal: NormalWords {
            g,
            k: [9, -7, 5],
            shift: 0,
        },
        planes,
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// From a tree to the depth that is seen, against a scan of the tree's points.
    #[test]
    fn the_nearest_product_is_the_front_of_the_tree(
        tree in any_tree(),
        objects in proptest::collection::vec(any_extent(), 6),
    ) {
        let of = |ids: &BTreeSet<usize>| ids.iter().map(|&id| objects[id]).collect::<Vec<Extent>>();
        let seen = form(&tree);
        let seen = seen.iter().filter_map(|p| front(&of(&p.intersected), &of(&p.subtracted), FAR));
        let holds = |object: usize, place: i64| {
            let Extent { zf, zb } = objects[object];
            zf < FAR && (2 * zf..=2 * zb).contains(&place)
        };
        let contains = |place: i64| tree.contains(&|object| holds(object, place));
        let expected = (0..FAR).find(|z| contains(2 * z) || contains(2 * z + 1));
        prop_assert_eq!(seen.map(|front| front.depth).min(), expected);
    }

    /// Seen from behind, an object has the same two depths, complemented; what is open at one end of the depth is open
    /// at the other.
    #[test]
    fn from_behind_an_object_is_where_it_is(words in any_words(), word in 10u32..=12) {
        let format = Format::new(word).expect("a depth word");
        let behind = seen_from_behind(&words);
        for (x, y) in [(0, 0), (3, 1), (2, 3)] {
            let (before, after) = (words.at(x, y, &format), behind.at(x, y, &format));
            prop_assert_eq!(before.zf == format.z_max(), after.zf == format.z_max());
            if before.zf == format.z_max() {
                continue;
            }
            let is_end = |z: i64| z.abs() >= format.z_max() - 1;
            prop_assert!(!after.zf == before.zb || is_end(before.zb), "{:?} {:?}", before, after);
            prop_assert!(!after.zb == before.zf || is_end(before.zf), "{:?} {:?}", before, after);
        }
    }
}
