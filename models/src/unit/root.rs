//! The square root network: floor root and remainder of a radicand, one digit per row (source: 2.3.3).

/// Root and remainder, `radicand = root^2 + remainder`, `0 <= remainder <= 2 root`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Root {
    /// floor(sqrt(radicand)).
    pub root: u64,
    /// radicand - root^2.
    pub remainder: u64,
}

/// The cellular array's recurrence, one row per root digit, most significant digit first.
///
/// `radicand` has `2 * root_bits` bits, `root_bits` is at most 63.
pub fn restoring_root(radicand: u128, root_bits: u32) -> Root {
    let mut root: u64 = 0;
    let mut remainder: u64 = 0;
    for row in (0..root_bits).rev() {
        let pair = (radicand >> (2 * row)) as u64 & 3;
        let partial = (u128::from(remainder) << 2) | u128::from(pair);
        let divisor = (u128::from(root) << 2) | 1;
        let digit = partial >= divisor;
        remainder = if digit { partial - divisor } else { partial } as u64;
        root = (root << 1) | u64::from(digit);
    }
    Root { root, remainder }
}

/// The same root through the processor's floating-point unit, for whole pictures.
///
/// Exact for every `radicand < 2^63`: the estimate is off by at most one, which the remainder shows.
#[inline]
pub fn fast_root(radicand: i64) -> i64 {
    let estimate = (radicand as f64).sqrt() as i64;
    let remainder = radicand.wrapping_sub(estimate.wrapping_mul(estimate));
    estimate - i64::from(remainder < 0) + i64::from(remainder > 2 * estimate)
}

#[cfg(test)]
mod tests {
    use super::*;
    use num_bigint::BigUint;
    use proptest::prelude::*;

    fn check(radicand: u128, bits: u32) {
        let oracle = BigUint::from(radicand).sqrt();
        let remainder = BigUint::from(radicand) - &oracle * &oracle;
        let got = restoring_root(radicand, bits);
        assert_eq!(BigUint::from(got.root), oracle, "root of {radicand}");
        assert_eq!(
            BigUint::from(got.remainder),
            remainder,
            "remainder of {radicand}"
        );
        if radicand < 1 << 63 {
            assert_eq!(BigUint::from(fast_root(radicand as i64) as u64), oracle);
        }
    }

    #[test]
    fn all_16_bit_radicands() {
        (0..1u128 << 16).for_each(|x| check(x, 8));
    }

    #[test]
    fn edge_vectors_of_the_specification() {
        let p = |n: u32| 1u128 << n;
        let vectors = [
            (0, 0, 0),
            (1, 1, 0),
            (2, 1, 1),
            (3, 1, 2),
            (4, 2, 0),
            (p(46) - 1, 8388607, 16777214),
            (p(46), 8388608, 0),
            (p(47) - 1, 11863283, 4817238),
            (p(48) - p(25), 16777214, 33554428),
            (p(48) - p(25) + 1, 16777215, 0),
            (p(48) - 1, 16777215, 33554430),
        ];
        for (radicand, root, remainder) in vectors {
            assert_eq!(restoring_root(radicand, 24), Root { root, remainder });
        }
    }

    /// Every place where the floor root can step wrongly, for a spread of roots and at the top of the range.
    #[test]
    fn decision_boundaries() {
        let roots = (1..3000u128)
            .chain((1u128 << 31) - 3000..(1 << 31))
            .chain((1..31).flat_map(|k| [(1u128 << k) - 1, 1 << k, (1 << k) + 1]));
        for n in roots {
            for radicand in [n * n - 1, n * n, n * n + 2 * n] {
                check(radicand, 32);
            }
        }
        let top = (1u128 << 63) - 1;
        assert_eq!(
            BigUint::from(fast_root(top as i64) as u64),
            BigUint::from(top).sqrt()
        );
    }

    proptest! {
        #[test]
        fn random_radicands(bits in 1u32..=48, value in any::<u128>()) {
            check(value & ((1 << (2 * bits)) - 1), bits);
        }
    }
}
