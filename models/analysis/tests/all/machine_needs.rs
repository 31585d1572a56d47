//! The narrowest machine that the check states: every scene prepares in it to the same picture, and in no narrower one.

use imogene_analysis::bounds::{
    CheckReport, Shows, accumulators, check, depth_bound, exact_guards, machine_needs,
};
use imogene_contract::MachineWords;
use imogene_contract::slots;
use imogene_golden::format::Format;
use imogene_golden::widths;
use imogene_prepare::Framing;
use imogene_prepare::error::PrepareError;
use imogene_prepare::{PreparedQuadric, PreparedScene, prepare};
use imogene_scene::FramedScene;
use imogene_testkit::{scene_file, scenes_in};
use num_bigint::BigInt;
use num_traits::Signed;
use std::path::Path;

fn framed(name: &str) -> FramedScene {
    let framed = scene_file(name).frame(160, 120);
    framed.expect("can be framed")
}

fn scenes(folder: &str) -> Vec<(String, FramedScene)> {
    let name = |path: &Path| path.file_stem().expect("a name").to_string_lossy().into();
    let framed = |path: &Path| framed(path.to_str().expect("a path"));
    let paths = scenes_in(folder);
    paths.iter().map(|p| (name(p), framed(p))).collect()
}

fn in_widths(scene: &FramedScene, widths: &MachineWords) -> Result<PreparedScene, PrepareError> {
    prepare(scene, Format::fitted(widths).expect("a machine"))
}

/// One bit less is no machine, or the scene is refused in it.
fn assert_refused(scene: &FramedScene, less: &MachineWords, name: &str) {
    if let Ok(format) = Format::fitted(less) {
        let refused = prepare(scene, format);
        assert!(refused.is_err(), "{name} prepares in {less:?}");
    }
}

#[test]
fn every_scene_prepares_in_its_narrowest_machine_to_the_same_picture_and_in_no_narrower_one() {
    let scenes = scenes("");
    assert!(scenes.len() >= 15);
    for (name, scene) in scenes {
        for depth in [16, 24] {
            let format = Format::new(depth).expect("in the catalogue");
            let wide = prepare(&scene, format).expect("fits");
            let needs = machine_needs(&scene, &wide).expect("quadrics alone");
            let narrow = widths::parse(&needs.widths).expect("widths");
            println!("{name}: {}", needs.widths);
            assert_eq!((narrow.depth, narrow.normal), (depth, 16));
            let prepared = in_widths(&scene, &narrow).expect("stated to fit");
            assert_eq!(prepared.frame(|| ()), wide.frame(|| ()), "{name}");
            let slots = slots::parse(&needs.slots).expect("slots");
            assert_eq!(slots, prepared.fitted_slots(), "{name}");
            let root = MachineWords {
                root: narrow.root - 1,
                ..narrow
            };
            assert_refused(&scene, &root, &name);
            let plane = MachineWords {
                plane: narrow.plane - 1,
                ..narrow
            };
            assert_refused(&scene, &plane, &name);
        }
    }
}

/// Where a form is scaled to its word a shorter word would hold other integers: it is kept, and said why.
#[test]
fn words_that_are_scaled_are_not_shortened() {
    let scene = framed("extremes/axis-along-the-ray");
    let wide = prepare(&scene, Format::BASE).expect("fits");
    let report = check(&scene, &wide);
    assert!(!report.summary.prisms.is_empty());
    let needs = report.summary.machine.expect("quadrics alone");
    assert_eq!(widths::parse(&needs.widths).expect("widths").root, 24);
    let limit = &needs.root_limit;
    assert!(limit.contains("scaled to their widths"), "{limit}");
}

/// Widths that are not those of the catalogue stay as they are: guard bits, normals, dropped digits of the root.
#[test]
fn other_widths_are_kept() {
    let scene = framed("teapot");
    let text = "depth=20,root=20,plane=32,normal=13,g1=2,g2=4,dropped=3";
    let format = Format::fitted(&widths::parse(text).expect("widths")).expect("a machine");
    let wide = prepare(&scene, format).expect("fits");
    let needs = machine_needs(&scene, &wide).expect("quadrics alone");
    let kept = "normal=13,g1=2,g2=4,dropped=3";
    assert!(needs.widths.ends_with(kept), "{}", needs.widths);
    let narrow = widths::parse(&needs.widths).expect("widths");
    assert!(narrow.root < 20 && narrow.plane < 32, "{}", needs.widths);
    let prepared = in_widths(&scene, &narrow).expect("stated to fit");
    assert_eq!(prepared.frame(|| ()), wide.frame(|| ()));
    // In its own narrowest machine a scene needs exactly that.
    assert_eq!(machine_needs(&scene, &prepared), Some(needs));
}

fn checked(path: &str) -> CheckReport {
    let scene = framed(path);
    check(&scene, &prepare(&scene, Format::BASE).expect("fits"))
}

#[test]
fn other_processors_have_no_fitted_machine() {
    let report = checked("processors/polyhedron.toml");
    assert_eq!(report.summary.machine, None);
    assert!(report.summary.never_shown.is_empty());
}

/// Two's complement bits of the longest of some integers; `None` if there are none.
fn bits(values: &[BigInt]) -> Option<u32> {
    let of = |v: &BigInt| {
        let magnitude = if v.is_negative() { -v - 1 } else { v.clone() };
        magnitude.bits() as u32 + 1
    };
    values.iter().map(of).max()
}

/// All values of an object at all pixels of its box.
#[derive(Default)]
struct Values {
    f1: Vec<BigInt>,
    f2: Vec<BigInt>,
    near: Vec<BigInt>,
    far: Vec<BigInt>,
    planes: Vec<Vec<BigInt>>,
    linear: [Vec<BigInt>; 3],
    sums: [Vec<BigInt>; 3],
}

impl Values {
    fn of(object: &PreparedQuadric, format: &Format) -> Values {
        let mut values = Values {
            planes: vec![vec![]; object.words.planes.len()],
            ..Values::default()
        };
        for (x, y) in object.words.screen_box.each() {
            values.add(object, format, (x, y));
        }
        values
    }

    fn add(&mut self, object: &PreparedQuadric, format: &Format, (x, y): (i64, i64)) {
        let words = &object.words;
        let f1 = words.f1.exact_at(x, y) >> format.guard_linear;
        let f2 = words.f2.exact_at(x, y) >> format.guard_quadratic;
        for (plane, words) in self.planes.iter_mut().zip(&words.planes) {
            plane.push(words.depth.exact_at(x, y));
        }
        for (linear, g) in self.linear.iter_mut().zip(&words.normal.g) {
            linear.push(g.exact_at(x, y));
        }
        self.f1.push(f1.clone());
        self.f2.push(f2.clone());
        if f2.is_negative() {
            return;
        }
        let root: BigInt = f2.sqrt() >> format.dropped_rows << format.dropped_rows;
        self.near.push(&f1 - &root);
        self.far.push(f1 + &root);
        let factors = words.normal.g.iter().zip(words.normal.k);
        for (sums, (g, k)) in self.sums.iter_mut().zip(factors) {
            let product: BigInt = (&root >> words.normal.shift) * k;
            for product in [-&product, product] {
                sums.push(g.exact_at(x, y) + (product >> format.product_fraction()));
            }
        }
    }
}

/// All values at all pixels, one by one in big integers, fit the bits that are stated, and one bit less does not hold
/// them.
#[test]
fn accumulators_are_exactly_as_long_as_the_values_at_the_pixels() {
    let formats = ["depth=24", "depth=18,normal=12,g1=2,g2=5,dropped=2"];
    for name in ["teapot", "cut-sphere", "front-view", "molecule"] {
        let file = scene_file(name);
        let scene = file.frame(48, 36).expect("can be framed");
        for text in formats {
            let format = Format::fitted(&widths::parse(text).expect("widths")).expect("a machine");
            let prepared = prepare(&scene, format).expect("fits");
            for (_, object) in prepared.quadrics() {
                assert_exact(object, &format);
            }
        }
    }
}

fn assert_exact(object: &PreparedQuadric, format: &Format) {
    let name = &object.name;
    let found = accumulators(object, (48, 36), format).expect("on the screen");
    let values = Values::of(object, format);
    let three = |v: &[Vec<BigInt>; 3]| v.each_ref().map(|v| bits(v).expect("pixels"));
    assert_eq!(Some(found.f1), bits(&values.f1), "{name}");
    assert_eq!(Some(found.f2), bits(&values.f2), "{name}");
    assert_eq!(found.f1_minus_r, bits(&values.near), "{name}");
    assert_eq!(found.f1_plus_r, bits(&values.far), "{name}");
    let planes: Vec<u32> = values.planes.iter().filter_map(|v| bits(v)).collect();
    assert_eq!(found.planes, planes, "{name}");
    assert_eq!(found.normal_linear, Some(three(&values.linear)), "{name}");
    assert_eq!(found.normal_sum, Some(three(&values.sums)), "{name}");
    let root = found.root.expect("has roots");
    let greatest = values.f2.iter().max().expect("pixels");
    let limit = |root: u32| BigInt::from(1) << (2 * root - 1);
    assert!(*greatest < limit(root), "{name}");
    assert!(root == 1 || *greatest >= limit(root - 1), "{name}");
}

/// With the guard bits that are stated, and with more, no sign of f2 is open and no face is farther off than its floors
/// and one word.
#[test]
fn guard_bits_that_leave_nothing_to_rounding_do() {
    let mut tried = 0;
    for (name, scene) in scenes("") {
        for depth in [16, 20, 24] {
            let format = Format::new(depth).expect("in the catalogue");
            let wide = prepare(&scene, format).expect("fits");
            let Some(guards) = exact_guards(&wide) else {
                println!("{name}, {depth} bits: none");
                continue;
            };
            println!("{name}, {depth} bits: {guards:?}");
            for (g1, g2) in [(guards.g1, guards.g2), (guards.g1 + 1, guards.g2 + 2)] {
                let Ok(format) = format.with_guards(g1, g2) else {
                    continue;
                };
                let prepared = prepare(&scene, format).expect("fits");
                assert_decided(&scene, &prepared, &name);
                tried += 1;
            }
        }
    }
    assert!(tried > 40, "{tried}");
}

fn assert_decided(scene: &FramedScene, prepared: &PreparedScene, name: &str) {
    let report = check(scene, prepared);
    assert_eq!(report.summary.guards, exact_guards(prepared), "{name}");
    for (report, object) in report.objects.iter().zip(&prepared.objects) {
        assert_eq!(report.undecided.silhouette, 0, "{name}: {}", report.name);
        let object = object.quadric().expect("a quadric");
        for (x, y) in object.words.screen_box.each() {
            let f2 = object.words.f2_at(x, y, &prepared.format);
            for face in [0, 1] {
                // The floor of the root, the dropped guard bits, and one word.
                let bound = depth_bound(object, face, f2.max(0));
                let near = f2 < 0 || bound <= 3.0;
                assert!(near, "{name}: {} ({x}, {y}) {bound}", report.name);
            }
        }
    }
}

#[test]
fn front_views_and_specks_are_named() {
    let front = checked("front-view.toml");
    assert!(!front.summary.front_view.is_empty());
    let speck = checked_at_its_size("extremes/between-pixels.toml");
    let shows: Vec<Shows> = speck.objects.iter().map(|o| o.shows).collect();
    assert_eq!(shows, [Shows::EmptyBox]);
    assert_eq!(speck.summary.never_shown, ["dot"]);
}

fn checked_at_its_size(path: &str) -> CheckReport {
    let file = scene_file(path);
    let (width, height) = (file.image.width, file.image.height);
    let scene = file.frame(width, height).expect("can be framed");
    check(&scene, &prepare(&scene, Format::BASE).expect("fits"))
}
