//! Headroom against single pixels in big rationals, and against the words that a format with guard bits is loaded with.

use imogene_algebra::rational::{integer, power_of_two, to_f64};
use imogene_analysis::bounds::headroom::{FEWEST, Headroom, bits_above, headroom, summaries};
use imogene_golden::format::Format;
use imogene_golden::unit::root::fast_root;
use imogene_prepare::{Framing, prepare};
use imogene_scene::FramedScene;
use imogene_testkit::scene_file;
use num_rational::BigRational;
use num_traits::Signed;

fn scene(name: &str, width: u32, height: u32) -> FramedScene {
    let framed = scene_file(name).frame(width, height);
    framed.expect("a valid size")
}

fn guarded(depth: u32, guards: u32) -> Format {
    let format = Format::new(depth).expect("in the catalogue");
    format.with_guards(0, guards).expect("within limits")
}

/// Wrong signs of a format with guard bits, pixel by pixel from the words it is loaded with.
fn counted(scene: &FramedScene, format: Format) -> u64 {
    let prepared = prepare(scene, format).expect("fits");
    let mut errors = 0;
    for (_, object) in prepared.quadrics() {
        for (x, y) in object.words.screen_box.each() {
            let truth = object.exact.f2.at(&integer(x), &integer(y));
            let computed = object.words.f2_at(x, y, &format);
            errors += u64::from((computed < 0) != truth.is_negative());
        }
    }
    errors
}

/// The smallest number of guard bits is that at which formats with guard bits stop to err.
#[test]
fn formats_with_the_confirmed_guard_bits_have_no_error_and_with_one_less_they_have() {
    for (name, depth) in [("cone", 16), ("teapot", 16), ("cut-sphere", 20)] {
        let scene = scene(name, 96, 72);
        let found = headroom(&prepare(&scene, guarded(depth, 0)).expect("fits"));
        println!("{name}, {depth} bits: {found:?}");
        assert_eq!(found.silhouette_errors, counted(&scene, guarded(depth, 0)));
        let confirmed = found.confirmed.expect("no ties in these scenes");
        assert!(confirmed <= found.derived);
        if confirmed > 0 {
            let bits = confirmed as u32;
            assert_eq!(counted(&scene, guarded(depth, bits)), 0);
            let less = counted(&scene, guarded(depth, bits - 1));
            assert_eq!(less, found.errors_with_one_less);
        }
        let derived = found.derived.max(0) as u32;
        assert_eq!(counted(&scene, guarded(depth, derived)), 0);
    }
}

#[test]
fn a_bit_more_halves_the_risk() {
    assert_eq!(bits_above(0.9), 0);
    assert_eq!(bits_above(1.0), 1);
    assert_eq!(bits_above(0.2), -2);
    assert_eq!(bits_above(1000.0), 10);
    assert_eq!(bits_above(0.0), FEWEST);
}

#[test]
fn depth_errors_are_those_of_exact_pixels() {
    let scene = scene("ellipsoid", 48, 36);
    for depth in [16, 24] {
        let format = guarded(depth, 0);
        let prepared = prepare(&scene, format).expect("fits");
        let found = headroom(&prepared);
        let mut worst = 0.0f64;
        for (_, object) in prepared.quadrics() {
            for (x, y) in object.words.screen_box.each() {
                let (px, py) = (integer(x), integer(y));
                let truth = object.exact.f2.at(&px, &py);
                let f2 = object.words.f2_at(x, y, &format);
                if truth.is_negative() || f2 < 0 {
                    continue;
                }
                // 60 bits below the point.
                let root = (truth * power_of_two(120)).floor().to_integer().sqrt();
                let root = BigRational::from_integer(root) / power_of_two(60);
                let f1 = object.exact.f1.at(&px, &py);
                let computed = object.words.f1_at(x, y, &format);
                let own = fast_root(f2);
                let both = [(computed - own, &f1 - &root), (computed + own, &f1 + &root)];
                for (depth, truth) in both {
                    if depth >= format.z_low() && depth < format.z_max() {
                        worst = worst.max(to_f64(&(integer(depth) - truth)).abs());
                    }
                }
            }
        }
        let off = (worst - found.depth_max_lsb).abs();
        assert!(off < 1e-6, "{worst}, {found:?}");
        assert!(found.depth_rms_lsb < found.depth_max_lsb && found.depth_rms_lsb > 0.0);
    }
}

#[test]
fn a_summary_takes_the_worst_scene() {
    let row = |errors, depth, confirmed| Headroom {
        width: 8,
        height: 6,
        depth_word: 24,
        pixels: 10,
        silhouette_errors: errors,
        ties: 0,
        depth_max_lsb: depth,
        depth_rms_lsb: 3.0,
        depths: 5,
        derived: 4,
        confirmed,
        errors_with_one_less: 2,
    };
    let rows = [
        row(0, 5.0, Some(-3)),
        row(7, 4.0, Some(1)),
        row(0, 1.0, Some(1)),
    ];
    let found = &summaries(&rows)[..];
    assert_eq!(found.len(), 1);
    let all = &found[0];
    assert_eq!((all.pixels, all.silhouette_errors), (30, 7));
    assert_eq!(all.scenes_with_errors, 1);
    assert_eq!((all.confirmed, all.errors_with_one_less), (Some(1), 4));
    assert_eq!((all.depth_max_lsb, all.depth_rms_lsb), (5.0, 3.0));
    let tied = summaries(&[row(0, 1.0, None), row(0, 1.0, Some(1))]);
    assert_eq!(tied[0].confirmed, None);
}
