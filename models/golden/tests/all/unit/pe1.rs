use imogene_golden::format::wrap;
use imogene_golden::unit::pe1::{Linear, Pe1};
use num_bigint::BigInt;
use proptest::prelude::*;

fn raster(coefficients: Linear, width: u32, columns: usize, lines: usize) -> Vec<Vec<i128>> {
    let mut pe = Pe1::object_start(&coefficients, width);
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
        raster(Linear::new(3, -5, 7), 24, 5, 3),
        [[7, 10, 13, 16, 19], [2, 5, 8, 11, 14], [-3, 0, 3, 6, 9]]
    );
    assert_eq!(
        raster(Linear::new(8388607, -8388608, 1), 24, 4, 3),
        [
            [1, -8388608, -1, 8388606],
            [-8388607, 0, 8388607, -2],
            [1, -8388608, -1, 8388606]
        ]
    );
    assert_eq!(
        raster(Linear::new(4194304, 0, 0), 24, 5, 1),
        [[0, 4194304, -8388608, -4194304, 0]]
    );
}

proptest! {
    #[test]
    fn equals_the_exact_polynomial_modulo_its_width(
        a in any::<i64>(), b in any::<i64>(), c in any::<i64>(), width in 2u32..=64
    ) {
        let expression = Linear::new(a as i128, b as i128, c as i128);
        let modulus = BigInt::from(1) << width;
        for (y, line) in raster(expression, width, 7, 7).iter().enumerate() {
            for (x, &value) in line.iter().enumerate() {
                let difference = expression.exact_at(x as i64, y as i64) - value;
                prop_assert_eq!(difference % &modulus, BigInt::ZERO);
                prop_assert!(value == wrap(value, width));
                prop_assert_eq!(value, expression.wrapped_at(x as i64, y as i64, width));
            }
        }
    }
}
