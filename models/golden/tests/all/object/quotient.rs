use crate::common::*;
use imogene_golden::object::quotient::QuotientWords;
use imogene_golden::object::words::Words;
use num_bigint::BigInt;

fn words() -> impl Strategy<Value = QuotientWords> {
    let factors = [(); 5].map(|()| -12i128..12);
    let denominator = [-3i128..=3, -3..=3, -20..=20];
    let kind = prop::sample::select(&PlaneKind::ALL[1..]);
    let plane = (kind, -9i128..9, -9i128..9, -120i128..120);
    let plane =
        plane.prop_map(|(kind, a, b, c)| PlaneWords::new(kind, Linear::new(a, b, c), [0; 3]));
    let planes = prop::collection::vec(plane, 0..3);
    let parts = (factors, -900i128..900, denominator, any::<bool>(), planes);
    parts.prop_map(
        |([a, b, c, d, e], f, [p, q, r], solid, planes)| QuotientWords {
            screen_box: ScreenBox::of([1, SIDE - 2], [0, SIDE - 1]),
            solid,
            numerator: Quadratic::new([a, b, c, d, e, f]),
            denominator: Linear::new(p, q, r),
            root: None,
            normal: NormalWords::default(),
            normal_from: 0,
            planes,
        },
    )
}

/// Does the definition hold at a depth word: the volume somewhere in the depths that it is the floor of, or the
/// surface there, and every plane.
fn holds(words: &QuotientWords, x: i64, y: i64, z: i64) -> bool {
    let n = words.numerator.exact_at(x, y);
    let d = words.denominator.exact_at(x, y);
    let at = |z: i64| &d * BigInt::from(z);
    let zero = BigInt::ZERO;
    let there = match (words.solid, d > zero) {
        (true, _) if d < zero => at(z + 1) < n,
        (true, _) => at(z) <= n,
        (false, _) if d == zero => false,
        // floor(n / d) = z
        (false, true) => at(z) <= n && n < at(z + 1),
        (false, false) => at(z) >= n && n > at(z + 1),
    };
    there
        && words.planes.iter().all(|plane| {
            let depth = plane.depth.exact_at(x, y);
            match plane.kind {
                PlaneKind::Front => BigInt::from(z) >= depth,
                PlaneKind::Back => BigInt::from(z) <= depth,
                _ => depth >= BigInt::ZERO,
            }
        })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 60, failure_persistence: None, ..ProptestConfig::default() })]

    /// Against the definition at every depth of a short word: the first depth at which it holds is the front.
    #[test]
    fn shows_the_first_depth_of_its_definition(words in words()) {
        let format = Format { depth: 8, ..Format::BASE };
        for (x, y) in pixels() {
            let inside = words.screen_box.contains(x, y);
            let mut depths = format.z_low()..format.z_max();
            let first = depths.find(|&z| inside && holds(&words, x, y, z));
            let found = words.at(x, y, &format).zf;
            prop_assert_eq!(found, first.unwrap_or(format.z_max()), "pixel ({}, {})", x, y);
        }
    }

    #[test]
    fn zones_are_coefficient_changes(words in words(), x0 in 0i64..8, y0 in 0i64..8) {
        let format = Format::BASE;
        let zone = words.for_zone(x0, y0, SIDE - x0, SIDE - y0);
        for (x, y) in pixels().filter(|&(x, y)| x >= x0 && y >= y0) {
            prop_assert_eq!(zone.at(x - x0, y - y0, &format), words.at(x, y, &format));
        }
    }
}
