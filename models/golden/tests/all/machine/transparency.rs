use imogene_golden::machine::transparency::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;

const FAR: i64 = 100;

fn whole(value: impl Into<BigInt>) -> BigRational {
    BigRational::from_integer(value.into())
}

/// `t front + (1 - t) behind` with `t = weight / 255`.
fn exact(front: u8, behind: &BigRational, weight: u8) -> BigRational {
    let t = BigRational::new(weight.into(), 255.into());
    &t * whole(front) + (whole(1) - &t) * behind
}

/// All weights and all pairs of components: the nearest integer, by an inequality of integers that says so.
#[test]
fn a_blend_is_exact_to_half_a_step() {
    for weight in 0..=255u8 {
        for front in 0..=255u8 {
            for behind in 0..=255u8 {
                let [t, c1, c2] = [weight, front, behind].map(i64::from);
                let error =
                    255 * i64::from(blend(front, behind, weight)) - (t * c1 + (255 - t) * c2);
                // Half a step is 127.5 of 255.
                assert!(error.abs() <= 127, "{front} over {behind} by {weight}");
            }
        }
    }
    for (weight, expected) in [(0, 200), (255, 10), (128, 105), (1, 199)] {
        assert_eq!(blend(10, 200, weight), expected);
    }
    let real = exact(10, &whole(200), 128);
    assert_eq!(real.round(), whole(105));
}

fn dark(depth: i64) -> Seen {
    let colour = [0; 3];
    Seen { depth, colour }
}

fn layer(depth: i64, level: u8, weight: u8) -> Layer {
    let colour = [level; 3];
    Layer {
        depth,
        colour,
        weight,
    }
}

#[test]
fn only_what_is_nearer_than_the_surface_is_seen() {
    let pixel = dark(10);
    let layer = |depth| layer(depth, 255, 255);
    assert_eq!(stage(pixel, layer(9)).colour, [255; 3]);
    assert_eq!(stage(pixel, layer(9)).depth, 10);
    assert_eq!(stage(pixel, layer(10)), pixel);
    assert_eq!(stage(dark(FAR), layer(FAR)), dark(FAR));
    assert_eq!(stage(dark(FAR), layer(FAR - 1)).colour, [255; 3]);
}

fn any_layer() -> impl Strategy<Value = Layer> {
    let depth = prop_oneof![4 => 0i64..20, 1 => Just(FAR)];
    (depth, any::<Colour>(), any::<u8>()).prop_map(|(depth, colour, weight)| Layer {
        depth,
        colour,
        weight,
    })
}

/// What is seen, from the surface forwards; of layers at equal depth the smaller index is nearer.
fn back_to_front(pixel: Seen, layers: &[Layer]) -> [BigRational; 3] {
    let mut visible: Vec<(i64, usize)> = layers.iter().map(|l| l.depth).zip(0..).collect();
    visible.retain(|&(depth, _)| depth < pixel.depth);
    visible.sort_by(|a, b| b.cmp(a));
    let mut colour = pixel.colour.map(whole);
    for (_, i) in visible {
        for (behind, front) in colour.iter_mut().zip(layers[i].colour) {
            *behind = exact(front, behind, layers[i].weight);
        }
    }
    colour
}

proptest! {
    /// Each stage adds half a step at most, and a blend passes on no more error than came to it.
    #[test]
    fn sorted_layers_are_exact_to_half_a_step_each(
        layers in proptest::collection::vec(any_layer(), 1..=MOST_LAYERS),
        depth in prop_oneof![0i64..20, Just(FAR)], colour in any::<Colour>(),
    ) {
        let pixel = Seen { depth, colour };
        let depths: Vec<Vec<i64>> = layers.iter().map(|l| vec![l.depth]).collect();
        let sorted = order(&depths, FAR).expect("one pixel has an order");
        let loaded: Vec<Layer> = sorted.iter().map(|&i| layers[i]).collect();
        let seen = pipeline(pixel, &loaded);
        let half_steps = whole(layers.len());
        for (found, real) in seen.colour.into_iter().zip(back_to_front(pixel, &layers)) {
            let error = whole(2) * (whole(found) - real);
            prop_assert!(error <= half_steps && -error <= half_steps);
        }
    }
}

#[test]
fn the_wrong_order_shows_another_colour() {
    let (far, near) = (layer(40, 0, 128), layer(30, 255, 128));
    assert_eq!(pipeline(dark(50), &[far, near]).colour, [128; 3]);
    assert_eq!(pipeline(dark(50), &[near, far]).colour, [64; 3]);
    assert_eq!(order(&[vec![30], vec![40]], FAR), Ok(vec![1, 0]));
}

#[test]
fn an_order_holds_on_all_pixels_of_a_zone() {
    // Object 1 behind 0 on one pixel, 2 behind 1 on another; an absent one says nothing.
    let depths = [vec![5, FAR, 7], vec![6, 8, FAR], vec![FAR, 9, FAR]];
    assert_eq!(order(&depths, FAR), Ok(vec![2, 1, 0]));
    assert_eq!(order(&[vec![FAR; 3], vec![4; 3]], FAR), Ok(vec![0, 1]));
    assert_eq!(order(&[vec![4], vec![4]], FAR), Ok(vec![1, 0]));
    assert_eq!(order(&[], FAR), Ok(vec![]));
}

#[test]
fn objects_that_cannot_be_sorted_are_named() {
    // Two that cross, beside one that does not.
    let crossing = [vec![1, 1], vec![5, 6], vec![6, 5]];
    let circle = order(&crossing, FAR).expect_err("they cross").circle;
    assert_eq!(circle.len(), 2);
    assert!(circle.contains(&1) && circle.contains(&2));
    // Three that overlap in a circle, no two of which cross.
    let around = [vec![5, FAR, 4], vec![4, 5, FAR], vec![FAR, 4, 5]];
    let circle = order(&around, FAR).expect_err("a circle").circle;
    assert_eq!(circle.len(), 3);
    for (place, &object) in circle.iter().enumerate() {
        let next = circle[(place + 1) % 3];
        let pixels = around[object].iter().zip(&around[next]);
        let mut shared = pixels.filter(|&(&a, &b)| a < FAR && b < FAR);
        assert!(shared.all(|(a, b)| a > b), "each is farther than the next");
    }
}
