//! The family against its definition: `q^2 <= X < (q + 1)^2`, an oracle in big integers, and the figures of the
//! restatement.
//!
//! The exhaustive runs that take minutes are made when the environment variable `IMOGENE_FULL` is 1: all 32-bit
//! radicands, and every decision boundary of 48 bits. Otherwise the same tests run over 24 bits and a spread of
//! boundaries.

use imogene_contract::RootForm;
use imogene_golden::unit::root::polynomial::{self, root_length};
use imogene_golden::unit::root::{Method, Root, fast_root, iterative, restoring_root, root};
use num_bigint::BigUint;
use proptest::prelude::*;
use rayon::prelude::*;

const EXACT: [Method; 3] = [Method::Restoring, Method::NonRestoring, Method::Iterative];

fn is_full_run() -> bool {
    std::env::var("IMOGENE_FULL").is_ok_and(|value| value == "1")
}

/// Root and remainder as the definition states them; no square root is taken.
fn assert_definition(method: Method, radicand: u128, bits: u32) {
    let found = root(method, radicand, bits);
    let q = u128::from(found.root);
    let is_root = (q * q..(q + 1) * (q + 1)).contains(&radicand);
    let is_exact = is_root && found.remainder.map(u128::from) == Some(radicand - q * q);
    assert!(is_exact, "{method} of {radicand}: {found:?}");
}

fn assert_oracle(radicand: u128, bits: u32) {
    let oracle = BigUint::from(radicand).sqrt();
    let remainder = BigUint::from(radicand) - &oracle * &oracle;
    for method in EXACT {
        let found = root(method, radicand, bits);
        let found = (found.root.into(), found.remainder.map(BigUint::from));
        let expected = (oracle.clone(), Some(remainder.clone()));
        assert_eq!(found, expected, "{method} of {radicand}");
    }
    if radicand < 1 << 63 {
        assert_eq!(BigUint::from(fast_root(radicand as i64) as u64), oracle);
    }
}

#[test]
fn all_16_bit_radicands_and_all_widths_agree_with_the_oracle() {
    (0..1u128 << 16).for_each(|x| assert_oracle(x, 8));
    for bits in 1..=32 {
        assert_oracle((1 << (2 * bits)) - 1, bits);
    }
}

/// All radicands of 24 bits; all of 32 bits in the full run.
#[test]
fn all_radicands() {
    let bits = if is_full_run() { 16 } else { 12 };
    (0..1u64 << (2 * bits)).into_par_iter().for_each(|x| {
        for method in EXACT {
            assert_definition(method, u128::from(x), bits);
        }
    });
}

/// Every place where a 24-digit root can step wrongly: n^2 - 1, n^2 and n^2 + 2n for every n in the full run, for every
/// 61st otherwise.
///
/// A network whose root is monotone in the radicand and right at both ends of `[n^2, n^2 + 2n]` is right between them,
/// and the networks are monotone: with the digits of two radicands equal up to a row, the larger prefix minus the same
/// square is the larger partial remainder, so a digit never falls before it rises. The remainder follows from the root,
/// because each row keeps `prefix = root^2 + remainder`.
#[test]
fn decision_boundaries_of_48_bits() {
    let stride = if is_full_run() { 1 } else { 61 };
    (1..1u64 << 24)
        .into_par_iter()
        .filter(|n| n % stride == 1 % stride || *n > (1 << 24) - 1000)
        .map(u128::from)
        .for_each(|n| {
            for radicand in [n * n - 1, n * n, n * n + 2 * n] {
                for method in EXACT {
                    assert_definition(method, radicand, 24);
                }
            }
        });
}

#[test]
fn decision_boundaries_of_64_bits() {
    let roots = (1..3000u128)
        .chain((1u128 << 31) - 3000..(1 << 31))
        .chain((1..31).flat_map(|k| [(1u128 << k) - 1, 1 << k, (1 << k) + 1]));
    for n in roots {
        for radicand in [n * n - 1, n * n, n * n + 2 * n] {
            assert_oracle(radicand, 32);
        }
    }
}

/// Every place where the root by floating point can step wrongly, beside every root that is asked: all short ones, the
/// longest of all, those about powers of two, which are roots of radicands that doubles no longer hold, and a spread.
#[test]
fn fast_roots_step_where_squares_are() {
    const GREATEST: u64 = 3_037_000_499;
    let step = if is_full_run() { 11 } else { 4001 };
    let near_powers = (11..32).flat_map(|k| (1u64 << k) - 500..(1 << k) + 500);
    let ends = (1..2000).chain(GREATEST - 100_000..=GREATEST);
    let spread = (2000..GREATEST).step_by(step);
    for n in ends.chain(near_powers).chain(spread) {
        let at = |radicand: u64| fast_root(radicand.min(i64::MAX as u64) as i64) as u64;
        let square = n * n;
        let found = [square - 1, square, square + 1, square + 2 * n];
        assert_eq!(found.map(at), [n - 1, n, n, n], "about {n} squared");
    }
    assert!(GREATEST.pow(2) <= i64::MAX as u64 && (GREATEST + 1).pow(2) > i64::MAX as u64);
    assert_eq!(fast_root(0), 0);
    assert_eq!(fast_root(i64::MAX) as u64, GREATEST);
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
    for (radicand, expected, remainder) in vectors {
        for method in EXACT {
            let found = root(method, radicand, 24);
            assert_eq!((found.root, found.remainder), (expected, Some(remainder)));
        }
    }
}

#[test]
fn iterative_unit_takes_a_start_at_every_kth_clock_and_no_other() {
    let mut unit = iterative::IterativeRoot::new(8);
    let radicands: [u128; 3] = [65_535, 10_000, 3];
    for (index, radicand) in radicands.into_iter().enumerate() {
        for clock in 1..=8 {
            // Another radicand and start during the work change nothing.
            let shown = unit.clock(true, if clock == 1 { radicand } else { 77 });
            assert_eq!((shown.busy, shown.done), (clock < 8, clock == 8));
            if shown.done {
                let Root { root, remainder } = restoring_root(radicand, 8);
                assert_eq!((shown.root, shown.remainder), (root, remainder), "{index}");
            }
        }
    }
    let idle = unit.clock(false, 9);
    assert_eq!((idle.busy, idle.done, idle.root), (false, false, 1));
}

#[test]
fn fewer_digits_are_digits_of_the_exact_root() {
    for radicand in (0..1u128 << 20).step_by(7) {
        let exact = restoring_root(radicand, 10).root;
        for kept in 1..=10 {
            let mask = u64::MAX << (10 - kept);
            assert_eq!(root(Method::Rows { kept }, radicand, 10).root, exact & mask);
            let leading = root(Method::Leading { kept }, radicand, 10).root;
            assert!(leading <= exact && (exact - leading) << (kept - 1) <= exact);
        }
    }
}

#[test]
fn fifteenth_is_exact() {
    let ends = (0..1 << 20).chain((1 << 36) - (1 << 20)..1 << 36);
    for value in ends.chain((0..1 << 36).step_by(65_537)) {
        assert_eq!(polynomial::fifteenth(value), value / 15, "{value}");
    }
}

/// Greatest relative error in percent, without floors, after 0 to 4 corrections. `X` has an even or odd length by its
/// octave.
fn real_errors(estimate: fn(f64) -> f64) -> [f64; 5] {
    let mut greatest = [0.0f64; 5];
    for place in 0..=1_000_000u32 {
        let t = 0.25 + 0.75 * f64::from(place) / 1e6;
        let truth = t.sqrt();
        let mut root = estimate(t);
        for found in &mut greatest {
            *found = found.max(100.0 * (root - truth).abs() / truth);
            root -= (root * root - t) / 2.0;
        }
    }
    greatest
}

/// To a hundredth.
fn assert_close(found: [f64; 5], expected: [f64; 5]) {
    for (found, expected) in found.into_iter().zip(expected) {
        let off = (found - expected).abs();
        assert!(off <= 0.01 * expected, "{found} for {expected}");
    }
}

/// Restatement 4.2, the table in real arithmetic. The sign printed in the source errs by half: a model that copies it
/// fails here.
#[test]
fn real_errors_of_the_specification() {
    let linear = |t: f64| if t < 0.5 { t + 0.25 } else { 0.5 * t + 0.5 };
    assert_close(real_errors(linear), [6.066, 1.647, 0.473, 0.146, 0.050]);
    let quadratic = |t: f64| (-4.0 * t * t + 15.0 * t + 4.0) / 15.0;
    assert_close(real_errors(quadratic), [1.345, 0.532, 0.219, 0.093, 0.040]);
    let printed = |t: f64| (4.0 * t * t + 15.0 * t + 4.0) / 15.0;
    assert_close(real_errors(printed), [53.3, 14.2, 1.59, 0.79, 0.39]);
    for estimate in [polynomial::linear_estimate, polynomial::quadratic_estimate] {
        let top = estimate((1 << 48) - 1);
        let why = "the printed sign gives 1.53 of the root";
        assert!(top.abs_diff(1 << 24) <= 1, "{why}: {top}");
    }
}

/// Roots of all radicands of `2 bits` bits, by an estimate and so many corrections.
fn all_roots(bits: u32, estimate: fn(u128) -> u64, corrections: u32) -> Vec<u64> {
    (0..1u64 << (2 * bits))
        .into_par_iter()
        .map(|x| polynomial::corrected(x.into(), estimate(x.into()), corrections))
        .collect()
}

fn steps_down(roots: &[u64]) -> usize {
    roots.windows(2).filter(|pair| pair[1] < pair[0]).count()
}

fn worst_percent(roots: &[u64], first: usize) -> f64 {
    let relative = |(x, root): (usize, &u64)| {
        let truth = (x as f64).sqrt();
        100.0 * (*root as f64 - truth).abs() / truth
    };
    let roots = roots.iter().enumerate().skip(first);
    roots.map(relative).fold(0.0, f64::max)
}

/// The restatement squares the whole radicand where the network squares its upper half.
fn estimate_with_full_square(radicand: u128) -> u64 {
    let m = root_length(radicand);
    let fifteenfold = ((15 * radicand) >> m) + (4 << m) - ((4 * radicand * radicand) >> (3 * m));
    (fifteenfold / 15) as u64
}

/// Restatement 4.2: monotonicity, exhaustive on 16 and 24 bits, and the errors of short words.
#[test]
fn monotonicity_of_the_specification() {
    for bits in [8, 12] {
        for corrections in 0..=3 {
            let down = steps_down(&all_roots(bits, polynomial::linear_estimate, corrections));
            assert_eq!(down, 0, "linear + {corrections}, {bits} digits");
        }
    }
    let down = |bits, estimate: fn(u128) -> u64| {
        [0, 1, 2, 3].map(|corrections| steps_down(&all_roots(bits, estimate, corrections)))
    };
    assert_eq!(down(8, estimate_with_full_square), [91, 19, 2, 0]);
    assert_eq!(down(12, estimate_with_full_square), [1_884, 379, 101, 36]);
    assert_eq!(down(8, polynomial::quadratic_estimate), [104, 20, 1, 0]);

    let worst = |estimate, corrections| worst_percent(&all_roots(8, estimate, corrections), 4096);
    type Worst = (fn(u128) -> u64, &'static [f64]);
    let estimates: [Worst; 3] = [
        (polynomial::linear_estimate, &[6.07, 2.75, 2.05]),
        (estimate_with_full_square, &[2.61, 1.55]),
        (polynomial::quadratic_estimate, &[2.56, 1.55]),
    ];
    for (estimate, expected) in estimates {
        for (corrections, expected) in (0..).zip(expected) {
            assert!((worst(estimate, corrections) - expected).abs() < 0.01);
        }
    }
    let short = worst_percent(&all_roots(8, polynomial::linear_estimate, 0), 1);
    assert!((short - 42.26).abs() < 0.01, "radicand 3: {short}");
}

/// The one place where a correction needs a bit more than the root: the largest radicand rounds up.
#[test]
fn corrected_roots_need_one_bit_more() {
    for bits in [8, 16, 24, 32] {
        let top = (1u128 << (2 * bits)) - 1;
        let corrected = root(Method::Linear { corrections: 1 }, top, bits);
        assert_eq!(corrected.root, 1 << bits);
    }
}

proptest! {
    #[test]
    fn random_radicands(bits in 1u32..=32, value in any::<u128>()) {
        assert_oracle(value & ((1 << (2 * bits)) - 1), bits);
    }

    #[test]
    fn random_radicands_of_the_restoring_model(bits in 1u32..=48, value in any::<u128>()) {
        let radicand = value & ((1 << (2 * bits)) - 1);
        let found = restoring_root(radicand, bits);
        let oracle = BigUint::from(radicand).sqrt();
        prop_assert_eq!(&oracle * &oracle + found.remainder, BigUint::from(radicand));
        prop_assert_eq!(BigUint::from(found.root), oracle);
    }
}

/// Every short radicand that an f2 can be, and of longer ones those about the ends and the middles of their octaves,
/// where approximations are worst, and a spread.
fn radicands(bits: u32) -> Vec<u128> {
    let last = 1u128 << (2 * bits - 1);
    let middles = (0..2 * bits - 1).flat_map(|place| {
        let first = 1u128 << place;
        (0..8 * 61).map(move |part| first + first * part / (8 * 61))
    });
    let about = middles.flat_map(|x| [x.saturating_sub(1), x, x + 1]);
    (0..1 << 15).chain(about).filter(|x| *x < last).collect()
}

#[test]
fn forms_stay_within_the_errors_that_they_state() {
    let names = "restoring non-restoring linear0 linear1 linear2 quadratic0 quadratic1 quadratic2 leading1 leading7";
    for name in names.split(' ') {
        let form: RootForm = name.parse().unwrap();
        let mut closest: f64 = 0.0;
        for (bits, dropped) in [(12, 0), (16, 3), (24, 0), (24, 8), (32, 1)] {
            for radicand in radicands(bits) {
                let method = Method::of(form);
                let found = root(method, radicand >> (2 * dropped), bits - dropped).root << dropped;
                let truth = (radicand as f64).sqrt();
                let stated = form.error_at(truth, dropped);
                let off = (found as f64 - truth).abs();
                assert!(off <= stated, "{form} of {radicand}, {bits} bits: {found}");
                assert!(found < 1 << bits, "{form} of {radicand} in {bits} bits");
                closest = closest.max(off / stated);
            }
        }
        // A single digit is half off at most.
        assert!(closest > 0.49, "{form}: {closest}");
    }
}
