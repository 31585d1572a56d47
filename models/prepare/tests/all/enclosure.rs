use imogene_algebra::rational::integer;
use imogene_prepare::cell::Cell;
use imogene_prepare::screen_box::{Region, Search};
use imogene_scene::{Plane, Quadric, Surface};
use proptest::prelude::*;

/// `|p x n|^2 <= r^2 |n|^2` about a point, between two planes across n.
fn stick() -> impl Strategy<Value = (Quadric, Vec<Plane>)> {
    let axis = [-5i64..=5, -5..=5, 1..=5];
    let middle = [-90i64..=90, -90..=90, -90..=90];
    (axis, middle, 2i64..20, [1i64..40, 1..40]).prop_map(|(n, m, radius, ends)| {
        let square: i64 = n.iter().map(|v| v * v).sum();
        let entry = |i: usize, j: usize| i64::from(i == j) * square - n[i] * n[j];
        let linear: [i64; 3] =
            std::array::from_fn(|i| -(0..3).map(|j| entry(i, j) * m[j]).sum::<i64>());
        let constant = -(0..3).map(|i| linear[i] * m[i]).sum::<i64>();
        let [a, b, c] = [0, 1, 2].map(|i| entry(i, i));
        let [g, h, i] = linear;
        let (d, e, f) = (entry(0, 1), entry(0, 2), entry(1, 2));
        let j = constant - radius * radius * square;
        let along: i64 = (0..3).map(|i| n[i] * m[i]).sum();
        let plane = |sign: i64, end: i64| {
            let [a, b, c] = n.map(|v| integer(sign * v));
            let d = integer(-sign * along - end * n[2]);
            Plane { a, b, c, d }
        };
        let planes = vec![plane(1, ends[0]), plane(-1, ends[1])];
        let quadric = Quadric::from_array([a, b, c, d, e, f, g, h, i, j].map(integer));
        (quadric, planes)
    })
}

proptest! {
    /// Nothing is outside the cell, and the cell is at most three times as long on each side as what it encloses.
    #[test]
    fn holds_all_of_a_stick_and_little_more((quadric, planes) in stick()) {
        let region = Region::new(&quadric, &planes, Surface::Solid);
        let around = region.enclosure.expect("two planes close a cylinder");
        let open = Region::unenclosed(&quadric, &planes, Surface::Solid);
        let all = Cell::between([-400.0; 3], [400.0; 3]);
        for axis in 0..3 {
            let (low, high) = open.range_within(all, axis, Search::FINE).expect("it is not empty");
            let [first, last] = [-1.0, 1.0].map(|s| around.centre[axis] + s * around.half[axis]);
            // The search ends at cells of 0.2 that may meet the stick, so its ends lie outside by a diagonal or so.
            prop_assert!(first <= low + 0.6 && last >= high - 0.6, "{first} {last} {low} {high}");
            prop_assert!(last - first <= 3.0 * (high - low) + 4.0, "{first} {last} {low} {high}");
        }
        prop_assert!(region.may_be_in(all, [1.0; 3]));
        prop_assert_eq!(region.screen_box(400, 400, 400.0), open.screen_box(400, 400, 400.0));
    }
}
