use imogene_golden::format::Format;
use imogene_golden::unit::root::{Method, root};
use imogene_studies::root_errors::{F1, F2, WORDS_PER_PIXEL, cost, error, sphere, table};

#[test]
fn sphere_words_are_the_rounded_truth() {
    // Second difference and slope of the real depth's linear part give back the words.
    let square = 3361.0 / 2000.0;
    let per_pixel = -WORDS_PER_PIXEL / 50.0 / square;
    assert_eq!(per_pixel.round() as i128, F1.a);
    let scale = WORDS_PER_PIXEL * WORDS_PER_PIXEL;
    let a = scale * (1.0 / 2500.0 / square - 1.0) / square;
    assert_eq!(a.round() as i128, F2.a);
}

/// The floors weigh most in the lowest octaves, which are searched closely.
fn percent(method: Method) -> f64 {
    let off = |radicand: u128| {
        let truth = (radicand as f64).sqrt();
        100.0 * (root(method, radicand, 24).root as f64 - truth).abs() / truth
    };
    let lowest = (1u128 << 23..1 << 25).step_by(61).map(off);
    lowest.fold(error(method, 24).max_percent, f64::max)
}

/// Restatement 4.2: integer versions on 48 bits, from 2^23 on.
#[test]
fn integer_errors_of_the_specification() {
    let linear = [6.066, 1.681, 0.507];
    for (corrections, expected) in (0..).zip(linear) {
        let off = percent(Method::Linear { corrections }) - expected;
        assert!(off.abs() < 0.002, "linear + {corrections}: {off}");
    }
    let quadratic = [1.364, 0.540, 0.221];
    for (corrections, expected) in (0..).zip(quadratic) {
        let off = percent(Method::Quadratic { corrections }) - expected;
        assert!(off.abs() < 0.003, "quadratic + {corrections}: {off}");
    }
    let counts = |method| error(method, 24).max_lsb.round() as i64;
    assert!((counts(Method::Linear { corrections: 2 }) - 56_078).abs() <= 2);
    assert!((counts(Method::Quadratic { corrections: 1 }) - 53_930).abs() <= 2);
    let twelve = error(Method::Leading { kept: 12 }, 24);
    assert!(twelve.max_percent < 0.0489 && (twelve.mean_percent - 0.016).abs() < 0.002);
}

/// Restatement 4.3, the table of depth errors: method, greatest error in counts, mean in pixels.
const SPHERE_TABLE: [(Method, f64, f64); 7] = [
    (Method::Restoring, 54.0, 0.0048),
    (Method::Leading { kept: 12 }, 98.0, 0.0038),
    (Method::Linear { corrections: 0 }, 22_533.0, 0.82),
    (Method::Linear { corrections: 1 }, 6_150.0, 0.21),
    (Method::Linear { corrections: 2 }, 1_802.0, 0.063),
    (Method::Quadratic { corrections: 0 }, 4_413.0, 0.21),
    (Method::Quadratic { corrections: 1 }, 1_656.0, 0.065),
];

#[test]
fn sphere_depths_of_the_specification() {
    for (method, counts, mean) in SPHERE_TABLE {
        let found = sphere(method);
        assert_eq!(found.pixels, 18_707);
        let off = [found.max_counts - counts, found.mean_px - mean].map(f64::abs);
        assert!(off[0] <= 2.0 && off[1] < 0.03 * mean, "{method}: {found:?}");
    }
}

/// Restatement 4.3, the knob table, which sampled one pixel in nine: every pixel is at least as bad.
#[test]
fn sphere_knobs_of_the_specification() {
    let leading = [(6, 0.97, 0.41), (8, 0.24, 0.099), (10, 0.057, 0.022)];
    let rows = [
        (8, 7.81, 3.83),
        (10, 1.95, 0.97),
        (12, 0.48, 0.24),
        (16, 0.027, 0.011),
    ];
    let leading = leading.map(|(kept, max, mean)| (Method::Leading { kept }, max, mean));
    let rows = rows.map(|(kept, max, mean)| (Method::Rows { kept }, max, mean));
    for (method, max, mean) in leading.into_iter().chain(rows) {
        let found = sphere(method);
        for (found, expected) in [(found.max_px, max), (found.mean_px, mean)] {
            let off = (found - expected).abs();
            assert!(off < 0.05 * expected, "{method}: {found} {expected}");
        }
    }
}

#[test]
fn cells_of_the_specification() {
    let cells = |method| cost(method, 24).adder_cells;
    let eight = Method::Rows { kept: 8 };
    assert_eq!((cells(Method::Restoring), cells(eight)), (347, 51));
    // A correction squares a root and a bit.
    let corrected = Method::Linear { corrections: 1 };
    let products = [16, 24, 32].map(|root_bits| cost(corrected, root_bits).multipliers);
    assert_eq!(products, [1, 3, 6]);
}

#[test]
fn the_table_tells_exact_monotone_and_bounded_apart() {
    for format in Format::CATALOGUE.map(|depth| Format::new(depth).unwrap()) {
        for row in table(&format) {
            if row.exact {
                let most = row.error.max_lsb;
                assert!(most <= 1.0 && row.steps.largest == 1, "{row:?}");
            }
            let bounded = matches!(row.method, Method::Quadratic { .. });
            assert!(row.steps.monotone || bounded, "{row:?}");
            assert_eq!(row.sphere.is_some(), format == Format::BASE);
        }
    }
}
