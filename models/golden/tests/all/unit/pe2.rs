use imogene_golden::format::wrap;
use imogene_golden::unit::pe2::{Pe2, Quadratic};
use num_bigint::BigInt;
use proptest::prelude::*;

fn raster(coefficients: [i128; 6], width: u32, columns: usize, lines: usize) -> Vec<Vec<i128>> {
    let mut pe = Pe2::object_start(&Quadratic::new(coefficients), width);
    (0..lines)
        .map(|line| {
            if line > 0 {
                pe.line_step();
            }
            (0..columns).map(|_| pe.pixel()).collect()
        })
        .collect()
}

#[test]
fn vectors_of_the_specification() {
    assert_eq!(
        raster([2, 3, 1, -4, 5, 6], 48, 5, 3),
        [
            [6, 4, 6, 12, 22],
            [14, 13, 16, 23, 34],
            [28, 28, 32, 40, 52]
        ]
    );
    let circle = raster([-1, -1, 0, 8, 8, -16], 48, 9, 5);
    assert_eq!(circle[0], [-16, -9, -4, -1, 0, -1, -4, -9, -16]);
    assert_eq!(circle[1], [-9, -2, 3, 6, 7, 6, 3, -2, -9]);
    assert_eq!(circle[4], [0, 7, 12, 15, 16, 15, 12, 7, 0]);
    let p = |n: u32| 1i128 << n;
    assert_eq!(
        raster([p(47) - 1, -p(47), p(40), -p(46), p(46), -1], 48, 4, 3),
        [
            [-1, 70368744177662, 140737488355323, -70368744177674],
            [
                -70368744177665,
                1099511627774,
                72567767433211,
                -137438953472010
            ],
            [
                140737488355327,
                -68169720922114,
                4398046511099,
                76965813944310
            ]
        ]
    );
}

/// The IMOGENE datapath adds before it outputs and starts at (1, 1): the same polynomial one pixel later.
#[test]
fn imogene_origin_is_one_pixel_later() {
    let q = Quadratic::new([2, 3, 1, -4, 5, 6]);
    let shifted = q.from_zone(1, 1);
    let values: Vec<i128> = (0..5).map(|x| shifted.wrapped_at(x, 0, 48)).collect();
    assert_eq!(values, [13, 16, 23, 34, 49]);
}

proptest! {
    #[test]
    fn equals_the_exact_polynomial_modulo_its_width(
        v in proptest::array::uniform6(any::<i64>()), width in 2u32..=64
    ) {
        let coefficients = v.map(i128::from);
        let q = Quadratic::new(coefficients);
        let modulus = BigInt::from(1) << width;
        for (y, line) in raster(coefficients, width, 7, 7).iter().enumerate() {
            for (x, &value) in line.iter().enumerate() {
                let difference = q.exact_at(x as i64, y as i64) - value;
                prop_assert_eq!(difference % &modulus, BigInt::ZERO);
                prop_assert!(value == wrap(value, width));
                prop_assert_eq!(value, q.wrapped_at(x as i64, y as i64, width));
            }
        }
    }

    #[test]
    fn zones_and_interleaved_lines_are_coefficient_changes(
        v in proptest::array::uniform6(-1_000_000i64..1_000_000), k in -500i64..500, l in -500i64..500,
        x in 0i64..64, y in 0i64..64
    ) {
        let q = Quadratic::new(v.map(i128::from));
        prop_assert_eq!(q.from_zone(k, l).exact_at(x, y), q.exact_at(x + k, y + l));
    }
}
