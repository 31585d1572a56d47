use imogene_studies::evaluate::count::{cost, number, numbers};
use imogene_studies::evaluate::work::lighting::{Colours, Place, light, power};

#[test]
fn powers() {
    for exponent in 1..=128 {
        let tally = cost(|| {
            let found = power(number(1.0625), exponent).value;
            let expected = 1.0625f64.powi(exponent as i32);
            // At most 12 products, each rounded at 2^-53.
            assert!((found / expected - 1.0).abs() < 1e-13, "{exponent}");
        });
        assert!(tally.multiplications <= 12);
    }
}

#[test]
fn a_mirror_shows_the_source() {
    let colours = Colours {
        ambient: numbers([0.5; 3]),
        diffuse: numbers([0.25, 0.5, 0.0]),
        specular: numbers([1.0, 0.0, 2.0]),
        exponent: 9,
    };
    // Normal (0, 0, 2), source and viewer at 3-4-5 on both sides of it.
    let point = numbers([0.0, 0.0, 0.0]);
    let normal = numbers([0.0, 0.0, 2.0]);
    let source = Place::Near(numbers([3.0, 0.0, 4.0]));
    let viewer = Place::Near(numbers([-6.0, 0.0, 8.0]));
    let found = light(point, normal, &source, &viewer, &colours).map(|v| v.value);
    for (found, expected) in found.into_iter().zip([1.7, 0.9, 2.5]) {
        // A dozen operations on numbers near 1.
        assert!((found - expected).abs() < 1e-14);
    }
    // From below nothing is lit.
    let below = Place::Far(numbers([0.0, 0.0, -1.0]));
    let dark = light(point, normal, &below, &viewer, &colours).map(|v| v.value);
    assert_eq!(dark[1], 0.5);
}
