//! The parameters of the root networks, beyond the catalogue too: any number of digits kept, any number of corrections, against the golden
//! model on every radicand of a spread that holds each length and each decision boundary.

use imogene_models::unit::root::{Method, root};
use imogene_rtl::step::step;
use imogene_rtl::unit::square_root_leading::SquareRootLeading;
use imogene_rtl::unit::square_root_linear::SquareRootLinear;
use imogene_rtl::unit::square_root_quadratic::SquareRootQuadratic;
use imogene_rtl::unit::square_root_rows::SquareRootRows;
use imogene_rtl::word::Word;
use rust_hdl::core::prelude::Block;

/// Small radicands, and those about the squares and powers of two of each length.
fn radicands(bits: u32) -> Vec<u64> {
    let last = u64::MAX >> (64 - 2 * bits);
    let mut found: Vec<u64> = (0..600).collect();
    for place in 2..2 * bits {
        let first = 1u64 << place;
        let spread = [
            0,
            1,
            first / 3,
            first / 2,
            first / 2 + 1,
            first - 2,
            first - 1,
        ];
        found.extend(spread.map(|offset| first + offset));
        let n = 1u64.checked_shl(place / 2).unwrap_or(1) + (place as u64 * 37) % (1 << (place / 2));
        found.extend([n * n - 1, n * n, n * n + 2 * n]);
    }
    found.extend([last, last - 1, last / 2]);
    found.retain(|radicand| *radicand <= last);
    found
}

/// Streams the radicands through a free running unit and compares each result.
macro_rules! check {
    ($block:expr, $method:expr, $bits:expr) => {{
        let (mut block, method, bits) = ($block, $method, $bits);
        block.connect_all();
        let radicands = radicands(bits);
        let latency = method.latency(bits, 1) as usize;
        for clock in 0..radicands.len() + latency - 1 {
            let radicand = radicands.get(clock).copied().unwrap_or(0);
            block.radicand.next = Word::new(radicand);
            step(&mut block);
            if let Some(given) = (clock + 1).checked_sub(latency) {
                let expected = root(method, radicands[given].into(), bits).root;
                let found = block.root.val().get();
                assert_eq!(
                    found, expected,
                    "{method} of {}, {bits} bits",
                    radicands[given]
                );
            }
        }
    }};
}

#[test]
fn every_number_of_corrections() {
    for corrections in 0..=3 {
        let method = Method::Linear { corrections };
        let count = corrections as usize;
        check!(SquareRootLinear::<32, 16, 17>::new(count), method, 16);
        check!(SquareRootLinear::<48, 24, 25>::new(count), method, 24);
        check!(SquareRootLinear::<64, 32, 33>::new(count), method, 32);
        let method = Method::Quadratic { corrections };
        check!(
            SquareRootQuadratic::<32, 16, 17, 28>::new(count),
            method,
            16
        );
        check!(
            SquareRootQuadratic::<48, 24, 25, 36>::new(count),
            method,
            24
        );
        check!(
            SquareRootQuadratic::<64, 32, 33, 44>::new(count),
            method,
            32
        );
    }
}

#[test]
fn every_number_of_digits() {
    for kept in 1..=24 {
        let count = kept as usize;
        let method = Method::Rows { kept };
        check!(SquareRootRows::<48, 24, 25, 26>::new(count, 1), method, 24);
        let method = Method::Leading { kept };
        check!(
            SquareRootLeading::<48, 24, 25, 26>::new(count, 1),
            method,
            24
        );
    }
}
