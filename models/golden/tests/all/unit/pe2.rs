use crate::common::*;
use imogene_golden::unit::pe2::Pe2;

fn scanned(coefficients: [i128; 6], width: u32, columns: usize, lines: usize) -> Vec<Vec<i128>> {
    let mut pe = Pe2::object_start(&Quadratic::new(coefficients), width);
    raster(columns, lines, |x, y| {
        if x == 0 && y > 0 {
            pe.line_step();
        }
        pe.pixel()
    })
}

#[test]
fn vectors_of_the_specification() {
    let [first, second] = [[6, 4, 6, 12, 22], [14, 13, 16, 23, 34]];
    let rows = [first, second, [28, 28, 32, 40, 52]];
    assert_eq!(scanned([2, 3, 1, -4, 5, 6], 48, 5, 3), rows);
    let circle = scanned([-1, -1, 0, 8, 8, -16], 48, 9, 5);
    assert_eq!(circle[0], [-16, -9, -4, -1, 0, -1, -4, -9, -16]);
    assert_eq!(circle[1], [-9, -2, 3, 6, 7, 6, 3, -2, -9]);
    assert_eq!(circle[4], [0, 7, 12, 15, 16, 15, 12, 7, 0]);
    let p = |n: u32| 1i128 << n;
    assert_eq!(
        scanned([p(47) - 1, -p(47), p(40), -p(46), p(46), -1], 48, 4, 3),
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
        let values = scanned(coefficients, width, 7, 7);
        check_modulo(&values, width, |x, y| (q.exact_at(x, y), q.wrapped_at(x, y, width)))?;
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
