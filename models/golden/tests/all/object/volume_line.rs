use crate::common::*;
use imogene_golden::object::volume::MAX_SHIFT;
use imogene_golden::object::volume_line::for_each_inside;

fn plane() -> impl Strategy<Value = VolumePlane> {
    (kind(), linear(1 << 19, 1 << 19)).prop_map(|(kind, depth)| VolumePlane { kind, depth })
}

fn quadric() -> impl Strategy<Value = VolumeQuadric> {
    let f1 = linear(1 << 19, 1 << 19);
    let parts = (class(), f1, quadratic(), 0u8..=MAX_SHIFT);
    parts.prop_map(|(class, f1, f2, shift)| VolumeQuadric {
        class,
        f1,
        f2,
        shift,
    })
}

/// Roots without their last digits, at every depth around them.
#[test]
fn lines_drop_the_digits_that_the_processor_drops() {
    let format = fitted(|widths| widths.dropped_rows = 2);
    let depths: Vec<i64> = (-12..=12).collect();
    let last = depths.len() as i64 - 1;
    let mut inside = 0;
    for f in 0..100 {
        let quadric = VolumeQuadric {
            class: Class::Side,
            f2: Quadratic::new([0, 0, 0, 0, 0, f]),
            ..VolumeQuadric::EVERYWHERE
        };
        let words = VolumeWords {
            screen_box: ScreenBox::of([0, last], [0, 0]),
            quadric: Some(quadric),
            ..VolumeWords::default()
        };
        let mut line = vec![false; depths.len()];
        for_each_inside(&words, &format, 0, &depths, |x| line[x] = true);
        for (x, (&got, &z)) in line.iter().zip(&depths).enumerate() {
            let expected = words.holds(x as i64, 0, z, &format);
            assert_eq!(got, expected, "f2 = {f}, depth {z}");
            inside += usize::from(got);
        }
    }
    // Roots 0 to 9 become 0, 4 and 8.
    assert_eq!(inside, 16 + 48 * 9 + 36 * 17);
}

proptest! {
    #[test]
    fn lines_equal_the_processor_pixel_by_pixel(
        quadric in proptest::option::of(quadric()), planes in proptest::collection::vec(plane(), 0..=5),
        depths in proptest::collection::vec(-(1i64 << 23) + 1..1 << 23, 20), margin in 0u32..1000,
        screen_box in window(), guards in 0u32..=8, dropped_rows in 0u32..=8, root_form in root_form(16)
    ) {
        let words = VolumeWords { screen_box, margin, quadric, planes, ..VolumeWords::default() };
        let format = fitted(|widths| {
            (widths.guard_linear, widths.guard_quadratic) = (guards, guards);
            (widths.dropped_rows, widths.root_form) = (dropped_rows, root_form);
        });
        for y in 0..SIDE {
            let mut line = [false; SIDE as usize];
            for_each_inside(&words, &format, y, &depths, |x| line[x] = true);
            for (x, got) in line.into_iter().enumerate() {
                prop_assert_eq!(got, words.holds(x as i64, y, depths[x], &format));
            }
        }
    }
}
