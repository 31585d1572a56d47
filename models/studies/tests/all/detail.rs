//! What is left out of a scene and of its zones, against every pixel: bounds never contradict a pixel, and an exact
//! reduction changes none.

use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::object::line::for_each_present;
use imogene_golden::object::quadric::{
    MAX_PLANES, ObjectPixel, PlaneWords, QuadricWords, ScreenBox,
};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume::VolumeWords;
use imogene_golden::object::volume_line::for_each_inside;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::normal::NormalWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use imogene_plan::culling::all_planes;
use imogene_plan::culling::part::{Matter, matter, with_planes};
use imogene_plan::culling::reduce::{Fate, Reduced};
use imogene_plan::culling::volume::{Seen, matter_of_volume, volume_with_planes};
use imogene_plan::culling::zones::window_of;
use imogene_plan::split::Division;
use imogene_prepare::PreparedScene;
use imogene_studies::detail::{Changed, Report};
use imogene_testkit::{collection, file_prepared, scene_path};
use proptest::prelude::*;

const SIZE: (u32, u32) = (83, 61);

/// The base format with the guard bits that the depth of a facet needs.
fn with_facets() -> Format {
    Format::BASE.with_guards(10, 0).expect("guard bits")
}

/// What an object draws on a window of its box. Face numbers are left out: they count the planes.
fn drawn(words: &QuadricWords, window: ScreenBox, format: &Format) -> Vec<(i64, i64, ObjectPixel)> {
    let words = QuadricWords {
        screen_box: window,
        ..words.clone()
    };
    let mut pixels = vec![];
    for y in window.y0..=window.y1 {
        for_each_present(&words, format, y, |x, pixel| {
            pixels.push((x, y, ObjectPixel { number: 0, ..pixel }));
        });
    }
    pixels
}

/// Windows left out, planes left out, windows in which nothing is drawn.
#[derive(Default)]
struct Decided {
    windows: u64,
    absent: u64,
    undrawn: u64,
    planes: u64,
    idle: u64,
}

fn assert_sound(
    words: &QuadricWords,
    window: &ScreenBox,
    format: &Format,
    decided: &mut Decided,
    what: &str,
) {
    let truth = drawn(words, *window, format);
    decided.windows += 1;
    decided.undrawn += u64::from(truth.is_empty());
    decided.planes += words.planes.len() as u64;
    match matter(words, window, format) {
        Matter::Nothing => {
            assert!(truth.is_empty(), "{what}: {window:?} is not empty");
            decided.absent += 1;
        }
        Matter::With(planes) => {
            let left = with_planes(words, planes);
            decided.idle += (words.planes.len() - left.planes.len()) as u64;
            let same = drawn(&left, *window, format) == truth;
            assert!(same, "{what}: {window:?} differs with planes {planes:b}");
        }
    }
}

fn windows(side: u32, (width, height): (u32, u32)) -> Vec<ScreenBox> {
    let zones = Division::Zones {
        width: side,
        height: side,
    };
    zones.pieces(width, height).iter().map(window_of).collect()
}

fn parts(scene: &PreparedScene) -> Vec<QuadricWords> {
    let slots = scene.slots().into_iter();
    let words = |words: ProcessorWords| words.on_quadric_processor(&scene.format, MAX_PLANES).ok();
    slots.filter_map(|slot| words(slot.words)).collect()
}

#[test]
fn bounds_never_contradict_a_pixel_of_the_collection() {
    let mut decided = Decided::default();
    for path in collection() {
        let Some((_, scene)) = file_prepared(&path, SIZE, with_facets()) else {
            continue;
        };
        let what = path.display().to_string();
        for words in parts(&scene) {
            for side in [9, 32] {
                for window in windows(side, SIZE) {
                    let window = window.shared(&words.screen_box);
                    if !window.is_empty() {
                        assert_sound(&words, &window, &scene.format, &mut decided, &what);
                    }
                }
            }
        }
    }
    let Decided {
        windows,
        absent,
        undrawn,
        planes,
        idle,
    } = decided;
    assert!(windows > 10_000, "{windows} windows");
    // Of what a look at every pixel could leave out, bounds find most.
    assert!(
        10 * absent > 7 * undrawn,
        "{absent} of {undrawn} empty windows of {windows}"
    );
    assert!(4 * idle > planes, "{idle} of {planes} planes");
}

fn linear(range: i64) -> impl Strategy<Value = Linear> {
    let one = -range..=range;
    (one.clone(), one, -(range * 16)..=range * 16)
        .prop_map(|(a, b, c)| Linear::new(i128::from(a), i128::from(b), i128::from(c)))
}

const KINDS: [PlaneKind; 4] = [
    PlaneKind::None,
    PlaneKind::Front,
    PlaneKind::Back,
    PlaneKind::Perpendicular,
];

/// Words that no preparation made: registers wrap, planes cross, quadrics are of any size.
fn any_words() -> impl Strategy<Value = QuadricWords> {
    let plane =
        (0usize..4, linear(1 << 21), any::<[i16; 3]>()).prop_map(|(kind, depth, normal)| {
            PlaneWords {
                kind: KINDS[kind],
                depth,
                normal,
            }
        });
    let f2 =
        (proptest::array::uniform6(-(1i64 << 40)..1 << 40), 0u32..30).prop_map(|(q, small)| {
            let [a, b, c, d, e, f] = q.map(|v| i128::from(v >> small));
            Quadratic::new([a, b, c, 8 * d, 8 * e, 64 * f])
        });
    let corner = [[0i64..12, 0..12], [0..12, 0..12]];
    let ordered = |[a, b]: [i64; 2]| [a.min(b), a.max(b)];
    (
        0usize..4,
        (linear(1 << 22), 0u32..16),
        f2,
        proptest::collection::vec(plane, 0..=5),
        corner,
    )
        .prop_map(
            move |(class, (f1, small), f2, planes, [x, y])| QuadricWords {
                class: [Class::Side, Class::Front, Class::Patch, Class::Prism][class],
                screen_box: ScreenBox::of(ordered(x), ordered(y)),
                f1: Linear::new(f1.a >> small, f1.b >> small, f1.c >> small),
                f2,
                normal: NormalWords {
                    g: [f1; 3],
                    k: [3, 5, 7],
                    shift: 2,
                },
                planes,
            },
        )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn bounds_never_contradict_a_pixel_of_random_words(words in any_words(), guards in [0u32..=8, 0u32..=8]) {
        let format = Format::BASE.with_guards(guards[0], guards[1]).unwrap();
        assert_sound(&words, &words.screen_box, &format, &mut Decided::default(), "random");
    }
}

/// Answers of a volume for the surface of one object, pixel by pixel.
fn inside(
    volume: &VolumeWords,
    pixels: &[(i64, i64, ObjectPixel)],
    (width, height): (u32, u32),
    format: &Format,
) -> Vec<(i64, usize)> {
    let mut found = vec![];
    for y in 0..i64::from(height) {
        let mut depths = vec![format.z_max(); width as usize];
        for (x, _, pixel) in pixels.iter().filter(|pixel| pixel.1 == y) {
            depths[*x as usize] = pixel.zf;
        }
        for_each_inside(volume, format, y, &depths, |x| found.push((y, x)));
    }
    found
}

#[test]
fn bounds_never_contradict_a_volume_at_any_surface_point() {
    let size = (60, 45);
    let formats = [
        Format::BASE,
        Format::new(16).unwrap().with_guards(3, 5).unwrap(),
    ];
    for (path, format) in [
        ("shadows/robot", formats[0]),
        ("shadows/robot", formats[1]),
        ("../models/testkit/scenes/shadows", formats[0]),
    ] {
        let (_, scene) = file_prepared(&scene_path(path), size, format).expect("fits");
        let parts = parts(&scene);
        let (mut outside, mut truly, mut asked) = (0, 0, 0);
        for window in windows(15, size) {
            let shared = |words: &QuadricWords| words.screen_box.shared(&window);
            let here = parts.iter().map(|words| (words, shared(words)));
            for (words, window) in here.filter(|(_, window)| !window.is_empty()) {
                let planes = match matter(words, &window, &format) {
                    Matter::Nothing => continue,
                    Matter::With(planes) => planes,
                };
                let pixels = drawn(words, window, &format);
                let seen = [Seen::new(words, planes, window)];
                for volume in &scene.volumes {
                    let volume = volume.words.on_quadric_processor(MAX_PLANES);
                    let volume = volume.expect("a volume");
                    let truth = inside(&volume, &pixels, size, &format);
                    asked += 1;
                    truly += usize::from(truth.is_empty());
                    match matter_of_volume(&volume, &seen, &format) {
                        Matter::Nothing => {
                            outside += 1;
                            assert!(truth.is_empty(), "{path} {window:?}");
                        }
                        Matter::With(planes) => {
                            let left = volume_with_planes(&volume, planes);
                            let same = inside(&left, &pixels, size, &format) == truth;
                            assert!(same, "{path} {window:?} {planes:b}");
                        }
                    }
                }
            }
        }
        let found = format!("{path}: {outside} of {truly} of {asked}");
        assert!(2 * outside > truly && truly < asked, "{found}");
    }
}

#[test]
fn an_exact_reduction_changes_no_pixel_of_the_collection() {
    let (mut fewer_pixels, mut fewer_planes, mut nowhere) = (0, 0, 0);
    for path in collection() {
        let Some((framed, scene)) = file_prepared(&path, SIZE, Format::BASE) else {
            continue;
        };
        // What is looked at is each object by itself.
        if scene.refuse_composed().is_err() {
            continue;
        }
        let report = Report::of(&framed, &scene, 16, 0);
        let what = path.display();
        assert_eq!(report.changed, Changed::default(), "{what}");
        let work = report.work;
        assert!(work.object_pixels[1] <= work.object_pixels[0], "{what}");
        fewer_pixels += usize::from(work.object_pixels[1] < work.object_pixels[0]);
        fewer_planes += usize::from(work.planes[1] < work.planes[0]);
        let objects = &report.reduced.objects;
        nowhere += objects.iter().filter(|o| o.fate == Fate::Nowhere).count();
        for object in objects {
            assert_eq!(object.changed, 0, "{what}");
            assert_ne!(object.fate, Fate::TooSmall, "{what}");
        }
        let touches = report.loads;
        let in_order = [touches.pixels, touches.bounds, touches.boxes];
        assert!(in_order.is_sorted(), "{what}");
    }
    assert!(
        fewer_pixels > 20 && fewer_planes > 3 && nowhere > 3,
        "{fewer_pixels} {fewer_planes} {nowhere}"
    );
}

/// A processor with the bits that are counted draws every pixel; with one bit less, most objects are other.
#[test]
fn the_bits_that_an_object_needs_are_enough_and_not_too_many() {
    let (mut objects, mut tight) = (0, [0; 3]);
    for path in collection() {
        let Some((_, scene)) = file_prepared(&path, SIZE, Format::BASE) else {
            continue;
        };
        if scene.objects.len() > 100 {
            continue;
        }
        let (width, height) = (scene.width as usize, scene.height as usize);
        let frame = beam::render(&scene.slots(), &scene.format, width, height, || ());
        for object in Reduced::of(&scene, &frame, 0).objects {
            let (Some(bits), [words]) = (object.bits, &object.words[..]) else {
                continue;
            };
            let pixels = |format: &Format| {
                let mut pixels = vec![];
                for y in words.screen_box().y0..=words.screen_box().y1 {
                    words.for_each_present(format, y, |x, pixel| pixels.push((x, y, pixel)));
                }
                pixels
            };
            let truth = pixels(&scene.format);
            // A format with these words and everything else as it was: what the object's own processor could be.
            let narrow = Format {
                sum: bits.sum.max(2),
                quadratic: bits.quadratic.max(2),
                root: bits.root.max(scene.format.dropped_rows + 1),
                plane: bits.plane.max(2),
                ..scene.format
            };
            let what = format!("{}: {}", path.display(), object.name);
            assert!(pixels(&narrow) == truth, "{what} in {bits:?}");
            objects += 1;
            let less: [fn(&mut Format); 3] =
                [|f| f.sum -= 1, |f| f.quadratic -= 1, |f| f.plane -= 1];
            for (count, take) in tight.iter_mut().zip(less) {
                let mut format = narrow;
                take(&mut format);
                *count += usize::from(pixels(&format) != truth);
            }
        }
    }
    assert!(objects > 80, "{objects} objects");
    assert!(
        3 * tight[0] > 2 * objects && 3 * tight[1] > 2 * objects && 4 * tight[2] > objects,
        "{tight:?} of {objects}"
    );
}

/// With some pixels allowed, the picture changes at no more pixels than its objects do, and less work is left.
#[test]
fn a_reduction_that_may_change_pixels_says_how_many() {
    for (path, most_dropped) in [
        ("zones/molecule-480", 480),
        ("shadows/robot", 40),
        ("teapot", 10),
    ] {
        let (framed, scene) = file_prepared(&scene_path(path), SIZE, Format::BASE).expect("fits");
        let exact = Report::of(&framed, &scene, 16, 0);
        let mut before = exact.work;
        for pixels in [3, 12, 40] {
            let report = Report::of(&framed, &scene, 16, pixels);
            let objects = &report.reduced.objects;
            let own: u64 = objects.iter().map(|object| object.changed).sum();
            assert!(report.changed.pixels <= own, "{path}");
            for object in objects {
                let is_small = object.drawn > 0 && object.drawn < pixels;
                assert_eq!(object.fate == Fate::TooSmall, is_small, "{path}");
                assert!(object.changed <= pixels, "{path}: {}", object.name);
            }
            let dropped = objects.iter().filter(|o| o.fate == Fate::TooSmall).count();
            assert!(dropped <= most_dropped);
            let work = report.work;
            assert!(work.object_pixels[1] <= before.object_pixels[1], "{path}");
            assert!(work.planes[1] <= before.planes[1], "{path}");
            before = work;
        }
        assert!(
            before.objects[1] < exact.work.objects[1] || before.planes[1] < exact.work.planes[1],
            "{path}"
        );
    }
}

/// A mesh and a polyhedron keep their processors; words without planes stay as they are.
#[test]
fn all_planes_are_as_many_bits() {
    assert_eq!([0, 1, 12].map(all_planes), [0, 1, 0xfff]);
    let path = scene_path("processors/polyhedron");
    let (_, scene) = file_prepared(&path, SIZE, Format::BASE).expect("fits");
    let frame = beam::render(&scene.slots(), &scene.format, 83, 61, || ());
    // However many pixels may change, a polyhedron keeps a plane: its processor has at least one.
    let reduced = Reduced::of(&scene, &frame, 1);
    for words in reduced.objects.iter().flat_map(|object| &object.words) {
        if let ProcessorWords::Polyhedron(words) = words {
            assert!(!words.planes.is_empty());
        }
    }
}
