use imogene_golden::machine::shader::SphereTables;
use imogene_golden::machine::shader::lit_sphere::{coordinates, nearest};
use imogene_golden::machine::shader::{Pixel, ShaderWords};
use proptest::prelude::*;

fn words() -> ShaderWords {
    ShaderWords {
        depth: 24,
        size: [640, 480],
        distance: 1,
        ..ShaderWords::default()
    }
}

proptest! {
    /// Against the map in real numbers: a normal towards the viewer or away from it has one place.
    #[test]
    fn a_direction_has_its_place(normal in any::<[i16; 3]>()) {
        prop_assume!(normal[2] != 0);
        let pixel = Pixel { x: 0, y: 0, depth: 0, material: 0, normal, flags: 0 };
        let found = coordinates(&words(), &pixel);
        let [x, y, z] = normal.map(f64::from);
        let side = if z > 0.0 { -1.0 } else { 1.0 };
        let length = x.abs() + y.abs() + z.abs();
        for (found, exact) in found.into_iter().zip([x + y, x - y]) {
            let exact = 32768.0 * (1.0 + side * exact / length);
            prop_assert!((found as f64 - exact).abs() < 4.0, "{found} {exact}");
        }
    }
}

proptest! {
    /// Against the map in fractions: half of a coordinate from the corner is in the square of the entry, and the rim is
    /// in the last one.
    #[test]
    fn a_direction_is_in_the_square_of_its_entry(normal in any::<[i16; 3]>(), places in 4u32..8) {
        let pixel = Pixel { x: 0, y: 0, depth: 0, material: 0, normal, flags: 0 };
        let found = nearest(&words(), &pixel, places);
        let side = if normal[2] > 0 { -1 } else { 1 };
        let [x, y, z] = normal.map(|part| side * i128::from(part));
        let length = x.abs() + y.abs() + z.abs();
        for (found, part) in found.into_iter().zip([x + y, x - y]) {
            let (found, squares) = (found as i128, 1i128 << places);
            let is_before = squares * (part + length) < 2 * length * (found + 1);
            prop_assert!(2 * length * found <= squares * (part + length));
            prop_assert!(is_before || found + 1 == squares, "{found} {part} {length}");
        }
    }
}

/// Every colour of a table that is of first degree is met exactly, up to its rounding.
#[test]
fn between_entries_levels_are_of_first_degree() {
    let mut tables = SphereTables::dark(4, 1, 0);
    for line in 0..16 {
        for column in 0..16 {
            tables.entries[16 * line + column] = [64 * column as u16, 64 * line as u16, 1020];
        }
    }
    for x in (-20_000..20_000i16).step_by(613) {
        for y in (-20_000..20_000i16).step_by(431) {
            let pixel = Pixel {
                x: 0,
                y: 0,
                depth: 0,
                material: 0,
                normal: [x, y, -9000],
                flags: 0,
            };
            let at = coordinates(&words(), &pixel).map(|at| at as f64 / 65536.0 * 15.0 * 16.0);
            let [red, green, blue] = tables.colour(&words(), &pixel);
            assert!((f64::from(red) - at[0]).abs() < 0.65, "{red} {at:?}");
            assert!((f64::from(green) - at[1]).abs() < 0.65, "{green} {at:?}");
            assert_eq!(blue, 255);
        }
    }
}
