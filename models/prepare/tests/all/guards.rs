//! Guard bits: dropped once, downwards, at the outputs of the two elementary processors.

use imogene_golden::format::Format;
use imogene_golden::object::line::for_each_present;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_golden::unit::root::fast_root;
use imogene_prepare::prepare as prepare_for;
use imogene_scene::Surface;
use imogene_testkit::*;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};
use proptest::prelude::*;

fn guarded(depth: u32, linear: u32, quadratic: u32) -> Format {
    let format = Format::new(depth).expect("in the catalogue");
    format
        .with_guards(linear, quadratic)
        .expect("within limits")
}

/// A line of pixels whose f1 is `f1` and whose f2 is `f2` plus the column, both in units of their last guard bit.
fn line(class: Class, f1: i128, f2: i128) -> QuadricWords {
    QuadricWords {
        class,
        screen_box: ScreenBox {
            x0: 0,
            x1: 63,
            y0: 0,
            y1: 0,
        },
        f1: Linear::new(0, 0, f1),
        f2: Quadratic {
            d: 1,
            f: f2,
            ..Quadratic::default()
        },
        normal: Default::default(),
        planes: vec![],
    }
}

/// -1/16 of the last bit of f2 is negative. Dropped towards zero it would be present, with a root of zero.
#[test]
fn a_radicand_just_below_zero_is_absent() {
    let format = guarded(24, 2, 4);
    let words = line(Class::Side, 0, -20);
    let mut seen = vec![];
    for_each_present(&words, &format, 0, |x, _| seen.push(x));
    assert_eq!(seen, (20..64).collect::<Vec<_>>());
    let naive = (0..64).filter(|x| (x - 20) / 16 >= 0).count();
    assert_eq!(naive, 64 - 20 + 15);
}

/// -1/4 of a depth word is dropped to -1, not to 0.
#[test]
fn f1_is_dropped_downwards() {
    let format = guarded(24, 2, 4);
    for (f1, dropped) in [(-5, -2), (-4, -1), (-1, -1), (0, 0), (3, 0), (4, 1)] {
        let probe = line(Class::Side, f1, 16 * 9).probe_at(0, 0, &format);
        let found = [probe.depths.f1, probe.depths.near, probe.depths.far];
        assert_eq!(found, [0, -3, 3].map(|root| dropped + root));
    }
}

/// The greatest words that the proof of range lets through use every bit of the wider processors.
#[test]
fn processors_hold_the_range_of_their_guard_bits() {
    let format = guarded(24, 4, 8);
    let most = (1i128 << 55) - 64;
    let words = line(Class::Side, -(1 << 27), most);
    let depths = words.probe_at(0, 0, &format).depths;
    assert_eq!(depths.f2, ((1i64 << 55) - 64) >> 8);
    assert_eq!(depths.f1, -(1 << 23));
    assert_eq!(depths.root, fast_root(depths.f2));
}

/// Largest and mean error of the near root of a ball, in depth words, from exact rationals.
fn depth_error(format: Format) -> (f64, f64) {
    let ball = ball([20, -10, 300], 100, &[]);
    let prepared = prepare_for(&scene(vec![ball]), format).expect("fits");
    let object = first(&prepared);
    let (mut worst, mut sum, mut count) = (0.0f64, 0.0, 0);
    for y in (object.words.screen_box.y0..=object.words.screen_box.y1).step_by(7) {
        for_each_present(&object.words, &format, y, |x, pixel| {
            let at = (
                BigRational::from(BigInt::from(x)),
                BigRational::from(BigInt::from(y)),
            );
            let f2 = object.exact.f2.at(&at.0, &at.1);
            if f2.is_negative() {
                return;
            }
            // The root with 40 bits below the point.
            let root = (f2 * BigRational::from(BigInt::from(1) << 80))
                .floor()
                .to_integer()
                .sqrt();
            let root = BigRational::new(root, BigInt::from(1) << 40);
            let true_depth = object.exact.f1.at(&at.0, &at.1) - root;
            let off = BigRational::from(BigInt::from(pixel.zf)) - true_depth;
            let off = off.abs().to_f64().expect("a finite error");
            worst = worst.max(off);
            sum += off;
            count += 1;
        });
    }
    (worst, sum / f64::from(count))
}

/// Without guard bits coefficient rounding dominates; with enough of them only the two floors are left: less than one
/// word on a near root.
#[test]
fn guard_bits_reduce_the_depth_error_to_the_floors() {
    for depth in [16, 20, 24] {
        let without = depth_error(guarded(depth, 0, 0));
        let some = depth_error(guarded(depth, 2, 4));
        let many = depth_error(guarded(depth, 10, 16));
        println!("{depth} bits: {without:?}, guards 2:4 {some:?}, guards 10:16 {many:?}");
        assert!(some.0 < 0.75 * without.0 && some.1 < without.1);
        assert!(many.0 < some.0 && many.1 < some.1);
    }
    // On 24 bits these guards leave the coefficients less than 1/8 of a word.
    assert!(depth_error(guarded(24, 10, 16)).0 < 1.125);
}

/// The refusal names the widths without guard bits: a scene that does not fit is not saved by them, one that fits is
/// not lost.
#[test]
fn guard_bits_change_no_range() {
    for depth in Format::CATALOGUE {
        let base = Format::new(depth).expect("in the catalogue");
        let guards = (64 - base.quadratic).min(imogene_contract::words::MOST_GUARD);
        let wide = base.with_guards(4, guards).expect("within limits");
        for radius in [100, 290] {
            let ball = |name| object(name, Surface::Solid, sphere([0, 0, -451], radius), &[]);
            let [plain, guarded] = [base, wide]
                .map(|format| prepare_for(&scene(vec![ball("ball")]), format).expect("fits"));
            let (a, b) = (&first(&plain).needed, &first(&guarded).needed);
            assert_eq!((a.sum, a.quadratic), (b.sum, b.quadratic));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// floor(q1) -+ r = floor(q1 -+ r), since r is an integer, and floor(sqrt(floor(q2))) = floor(sqrt(q2)).
    #[test]
    fn dropping_before_the_root_and_before_the_sum_changes_nothing(p1 in -(1i64 << 40)..1 << 40, p2 in 0i64..i64::MAX, g1 in 0u32..=16, g2 in 0u32..=16) {
        let r = fast_root(p2 >> g2);
        prop_assert_eq!((p1 >> g1) - r, (p1 - (r << g1)) >> g1);
        prop_assert_eq!((p1 >> g1) + r, (p1 + (r << g1)) >> g1);
        // r <= sqrt(p2 / 2^g2) < r + 1
        let (p2, r) = (i128::from(p2), i128::from(r));
        prop_assert!((r * r) << g2 <= p2 && p2 < ((r + 1) * (r + 1)) << g2);
    }
}
