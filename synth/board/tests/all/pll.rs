use imogene_board::{Board, Dividers, Pll};
use num_rational::Ratio;
use num_traits::Signed;

const MEGA: i128 = 1_000_000;

/// Is the frequency between these numbers of kHz?
fn within(hertz: Ratio<i128>, least: i128, most: i128) -> bool {
    (Ratio::from(1000 * least)..=Ratio::from(1000 * most)).contains(&hertz)
}

#[test]
fn the_clock_of_the_ulx3s_is_exact() {
    let board = Board::named("ulx3s-85").expect("a board");
    let pll = Pll::of(&board, 25_175_000).expect("a clock");
    assert_eq!(pll.pixel_hertz * 140, Ratio::from(25 * MEGA * 141));
    assert!((pll.deviation_percent() - 0.0142).abs() < 1e-4);
    // 74.25 MHz: 371.25 MHz for the pairs.
    let pll = Pll::of(&board, 74_250_000).expect("a clock");
    assert!(pll.deviation_percent().abs() < 0.5);
}

/// No other dividers within the limits come nearer: all of them, one by one.
#[test]
fn no_dividers_of_the_ecp5_come_nearer() {
    let wanted = 25_175_000i128;
    let board = Board::named("ulx3s-85").expect("a board");
    let pll = Pll::of(&board, 25_175_000).expect("a clock");
    let mut nearest: Option<Ratio<i128>> = None;
    for reference in 1..=8 {
        for product in 1..=80 * 128 {
            for fast in 1..=25 {
                let oscillator = Ratio::new(25 * MEGA * product, reference);
                let is_fed = |l: i128| within(oscillator / l, 3_125, 400_000);
                let is_made = (1..=128).any(|l| product % l == 0 && product / l <= 80 && is_fed(l));
                if within(oscillator, 400_000, 800_000) && is_made {
                    let distance = (oscillator / (5 * fast) - wanted).abs();
                    nearest = Some(nearest.map_or(distance, |least| least.min(distance)));
                }
            }
        }
    }
    assert_eq!(Some((pll.pixel_hertz - wanted).abs()), nearest);
}

/// 27 MHz / 3 x 14 for the words, the nearest of all: no other quotient up to 64 / 64 is within 0.1 %.
#[test]
fn the_clock_of_a_tang_nano_is_the_nearest_quotient() {
    for name in ["tang-nano-9k", "tang-nano-20k"] {
        let pll = Pll::of(&Board::named(name).expect("a board"), 25_175_000).expect("a clock");
        assert_eq!(pll.pixel_hertz, Ratio::from(25_200_000));
        let quotients = (1..=64).flat_map(|over| (1..=64).map(move |by| Ratio::new(by, over)));
        let distance = |quotient: Ratio<i128>| (quotient * 27 * MEGA / 5 - 25_175_000).abs();
        let nearest = quotients.map(distance).min().expect("a quotient");
        assert_eq!(nearest, Ratio::from(25_000));
    }
}

/// The example of icepll's own documentation: 60 MHz of 12 MHz.
#[test]
fn dividers_of_the_ice40() {
    let text = include_str!("../../../../boards/hx8k-evb.toml");
    let board = Board::parse(&text.replace("100_000_000", "12_000_000"), "mine").expect("a board");
    let found = Pll::of(&board, 60_000_000).expect("a clock").dividers;
    let expected = [("divr", 0), ("divf", 79), ("divq", 4), ("filter", 1)];
    assert_eq!(found, Dividers::from(expected));
}

/// 100 MHz x 9 / 35.75: no other dividers within the limits of the MMCM come nearer, all of them one by one.
#[test]
fn no_dividers_of_the_7_series_come_nearer() {
    let wanted = 25_175_000i128;
    let board = Board::named("basys3").expect("a board");
    let pll = Pll::of(&board, 25_175_000).expect("a clock");
    let mut nearest = Ratio::from(wanted);
    for reference in 1..=10 {
        // In eighths; the oscillator from 600 to 1200 MHz.
        for feedback in (48 * reference..=96 * reference).filter(|eighths| *eighths <= 512) {
            for output in 16..=1024 {
                let product = 100 * MEGA * feedback;
                // Much farther than the nearest is no candidate.
                if (product - wanted * reference * output).abs() < 2_000 * reference * output {
                    let distance = (Ratio::new(product, reference * output) - wanted).abs();
                    nearest = nearest.min(distance);
                }
            }
        }
    }
    assert_eq!((pll.pixel_hertz - wanted).abs(), nearest);
}
