use imogene_algebra::rational::integer;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::extent::Extent;
use imogene_prepare::screen_box::Region;
use imogene_scene::{Quadric, Surface};
use num_traits::ToPrimitive;
use proptest::prelude::*;

/// `k ((x - x0)^2 a + (y - y0)^2 b + (z - z0)^2 c + shear) = r`, an ellipsoid because the shear is smaller than
/// the squares.
fn ellipsoid() -> impl Strategy<Value = Quadric> {
    (
        [1i64..9, 1..9, 1..9],
        [-1i64..=1, -1..=1, -1..=1],
        [-60i64..60, -60..60, -40..40],
        1i64..4000,
    )
        .prop_map(|([a, b, c], [d, e, f], [x, y, z], r)| {
            let (a, b, c) = (a + 2, b + 2, c + 2);
            let (g, h, i) = (
                -(a * x + d * y + e * z),
                -(d * x + b * y + f * z),
                -(e * x + f * y + c * z),
            );
            let j = -(g * x + h * y + i * z) - r;
            Quadric::from_array([a, b, c, d, e, f, g, h, i, j].map(integer))
        })
}

/// Does the line of sight through a point of the screen meet the ellipsoid: the discriminant of its equation in z.
fn is_met([a, b, c, d, e, f, g, h, i, j]: [i64; 10], x: i64, y: i64) -> bool {
    let linear = e * x + f * y + i;
    let rest = (a * x + 2 * (d * y + g)) * x + (b * y + 2 * h) * y + j;
    linear * linear >= c * rest
}

proptest! {
    /// The box is the smallest that holds every pixel at which the ellipsoid is met, and lies in the box of the
    /// search.
    #[test]
    fn is_the_box_of_the_covered_pixels(q in ellipsoid()) {
        let (width, height, depth) = (320u32, 260u32, 200.0);
        let searched = Region::new(&q, &[], Surface::Solid)
            .screen_box(width, height, depth);
        let found = Extent::of(&q).expect("an ellipsoid").screen_box(width, height, depth);
        let found = found.expect("on the screen and within the depths");
        let (left, top) = (i64::from(width) / 2, i64::from(height) / 2);
        let whole = q.coefficients().map(|v| v.to_integer().to_i64().expect("small"));
        let mut tight: Option<ScreenBox> = None;
        for y in 0..i64::from(height) {
            for x in 0..i64::from(width) {
                if is_met(whole, x - left, y - top) {
                    prop_assert!(found.contains(x, y));
                    let b = tight.get_or_insert(ScreenBox { x0: x, x1: x, y0: y, y1: y });
                    *b = ScreenBox { x0: b.x0.min(x), x1: b.x1.max(x), y0: b.y0.min(y), y1: b.y1.max(y) };
                }
            }
        }
        // A side can touch the ellipsoid between two pixels of its column; then the box is one pixel larger there,
        // never more.
        if let Some(b) = tight {
            prop_assert!(found.x0 >= b.x0 - 1 && found.x1 <= b.x1 + 1);
            prop_assert!(found.y0 >= b.y0 - 1 && found.y1 <= b.y1 + 1);
        }
        if !found.is_empty() {
            prop_assert!(searched.x0 <= found.x0 && found.x1 <= searched.x1);
            prop_assert!(searched.y0 <= found.y0 && found.y1 <= searched.y1);
            prop_assert!(searched.x0 >= found.x0 - 1 && searched.x1 <= found.x1 + 1);
            prop_assert!(searched.y0 >= found.y0 - 1 && searched.y1 <= found.y1 + 1);
        }
    }
}

#[test]
fn sides_that_touch_pixel_centres_belong_to_the_box() {
    let sphere = |x: i64, r: i64| {
        let [one, zero] = [1, 0].map(integer);
        let q = [
            one.clone(),
            one.clone(),
            one,
            zero.clone(),
            zero.clone(),
            zero.clone(),
            integer(-x),
            zero.clone(),
            zero,
            integer(x * x - r * r),
        ];
        Extent::of(&Quadric::from_array(q)).expect("an ellipsoid")
    };
    let on = |x, r| sphere(x, r).screen_box(100, 80, 40.0);
    let boxed = |x0, x1, y0, y1| Some(ScreenBox { x0, x1, y0, y1 });
    assert_eq!(on(0, 10), boxed(40, 60, 30, 50));
    assert_eq!(on(-40, 10), boxed(0, 20, 30, 50));
    // Past the left side, past the near end, and wholly off the screen.
    assert_eq!(on(-41, 10), None);
    assert_eq!(on(0, 41), None);
    assert_eq!(on(90, 10), Some(ScreenBox::EMPTY));
    // A paraboloid is not closed, and an ellipsoid without a point has no extent.
    let open = [1, 1, 0, 0, 0, 0, 0, 0, 1, 0].map(integer);
    assert!(Extent::of(&Quadric::from_array(open)).is_none());
    let nowhere = [1, 1, 1, 0, 0, 0, 0, 0, 0, 1].map(integer);
    assert!(Extent::of(&Quadric::from_array(nowhere)).is_none());
}
