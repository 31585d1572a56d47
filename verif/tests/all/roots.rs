//! The parameters of the root networks, beyond the catalogue too: any number of digits kept, any number of corrections,
//! against the golden model on every radicand of a spread that holds each length and each decision boundary.

use imogene_circuits::arith::{square_root_leading, square_root_linear};
use imogene_circuits::arith::{square_root_quadratic, square_root_rows};
use imogene_golden::unit::root::{Method, root};
use imogene_hdl::{Bits, Value};
use imogene_verif::engine::circuit::Circuit;

/// Small radicands, and those about the squares and powers of two of each length.
fn radicands(bits: u32) -> Vec<u64> {
    let last = u64::MAX >> (64 - 2 * bits);
    let mut found: Vec<u64> = (0..600).collect();
    for place in 2..2 * bits {
        let first = 1u64 << place;
        let (third, half) = (first / 3, first / 2);
        let spread = [0, 1, third, half, half + 1, first - 2, first - 1];
        found.extend(spread.map(|offset| first + offset));
        let n =
            1u64.checked_shl(place / 2).unwrap_or(1) + (u64::from(place) * 37) % (1 << (place / 2));
        found.extend([n * n - 1, n * n, n * n + 2 * n]);
    }
    found.extend([last, last - 1, last / 2]);
    found.retain(|radicand| *radicand <= last);
    found
}

/// Streams the radicands through a free running unit and compares each result.
fn check(method: Method, bits: u32, build: impl Fn(Bits) -> Bits) {
    let mut circuit = Circuit::of(|| build(Bits::input(2 * bits)));
    let radicands = radicands(bits);
    let latency = method.latency(bits, 1) as usize;
    for clock in 0..radicands.len() + latency - 1 {
        let radicand = radicands.get(clock).copied().unwrap_or(0);
        circuit.clock(&[radicand as i64]);
        if let Some(given) = (clock + 1).checked_sub(latency) {
            let given = radicands[given];
            let expected = root(method, given.into(), bits).root;
            let found = circuit.value("root") as u64;
            assert_eq!(found, expected, "{method} of {given}, {bits} bits");
        }
    }
}

#[test]
fn every_number_of_corrections() {
    for corrections in 0..=3 {
        for bits in [16, 24, 32] {
            let linear = |radicand| square_root_linear("top", radicand, corrections);
            check(Method::Linear { corrections }, bits, linear);
            let quadratic = |radicand| square_root_quadratic("top", radicand, corrections);
            check(Method::Quadratic { corrections }, bits, quadratic);
        }
    }
}

/// The bits of the excess on which the corrections of the circuits count: of roots of 9 to 11 digits every one, of
/// longer ones those of a spread, where floors take less beside the radicand.
#[test]
fn the_excess_before_a_correction_is_short() {
    let within = |bits: u32, radicand: u64| {
        for corrections in 0..=3 {
            let excess = |method| {
                let root = root(method, radicand.into(), bits).root;
                i128::from(root).pow(2) - i128::from(radicand)
            };
            let most = |places: u32| 1i128 << (2 * bits - places);
            let (linear, quadratic) = match corrections {
                0 => (-most(4)..=most(4), most(6)),
                _ => (0..=most(5) - 1, most(7)),
            };
            let found = excess(Method::Linear { corrections });
            assert!(
                linear.contains(&found),
                "{found} of {radicand}, {bits} bits"
            );
            let found = excess(Method::Quadratic { corrections });
            assert!(
                found.abs() < quadratic,
                "{found} of {radicand}, {bits} bits"
            );
        }
    };
    for bits in 9..=11 {
        (0..1 << (2 * bits)).for_each(|radicand| within(bits, radicand));
    }
    for bits in [12, 16, 24, 31] {
        radicands(bits)
            .into_iter()
            .for_each(|radicand| within(bits, radicand));
    }
}

#[test]
fn every_number_of_digits() {
    for kept in 1..=24 {
        let rows = |radicand| square_root_rows("top", radicand, kept, 1);
        check(Method::Rows { kept }, 24, rows);
        let leading = |radicand| square_root_leading("top", radicand, kept, 1);
        check(Method::Leading { kept }, 24, leading);
    }
}
