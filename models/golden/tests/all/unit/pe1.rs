use crate::common::*;
use imogene_golden::unit::pe1::Pe1;

fn scanned(coefficients: Linear, width: u32, columns: usize, lines: usize) -> Vec<Vec<i128>> {
    let mut pe = Pe1::object_start(&coefficients, width);
    raster(columns, lines, |x, y| {
        if x == 0 && y > 0 {
            pe.line_step();
        }
        pe.pixel()
    })
}

#[test]
fn vectors_of_the_specification() {
    let rows = [[7, 10, 13, 16, 19], [2, 5, 8, 11, 14], [-3, 0, 3, 6, 9]];
    assert_eq!(scanned(Linear::new(3, -5, 7), 24, 5, 3), rows);
    let even = [1, -8388608, -1, 8388606];
    let rows = [even, [-8388607, 0, 8388607, -2], even];
    let linear = Linear::new(8388607, -8388608, 1);
    assert_eq!(scanned(linear, 24, 4, 3), rows);
    let row = [0, 4194304, -8388608, -4194304, 0];
    assert_eq!(scanned(Linear::new(4194304, 0, 0), 24, 5, 1), [row]);
}

proptest! {
    #[test]
    fn equals_the_exact_polynomial_modulo_its_width(
        a in any::<i64>(), b in any::<i64>(), c in any::<i64>(), width in 2u32..=64
    ) {
        let expression = Linear::new(i128::from(a), i128::from(b), i128::from(c));
        let values = scanned(expression, width, 7, 7);
        check_modulo(&values, width, |x, y| (expression.exact_at(x, y), expression.wrapped_at(x, y, width)))?;
    }
}
