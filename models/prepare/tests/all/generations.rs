//! Scenes drawn by the first and by the second generation: every pixel at which they differ, and why.
//!
//! The chain of the second generation compares depths, which are rounded; the first generation asks the signs of conics
//! and lines, which are exact in a prepared scene. So there are two reasons: the word of a plane is the integer of a
//! face (a tie, which both break in their own way), or the words of the chain put a plane on the other side of a face
//! than the exact expressions do, within their proven bounds.

use imogene_algebra::rational::integer;
use imogene_golden::format::Format;
use imogene_golden::object::first_generation::{ContourPlane, FirstGenerationWords};
use imogene_golden::object::quadric::{ObjectPixel, QuadricWords};
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_prepare::Framing;
use imogene_prepare::error::PrepareError;
use imogene_prepare::forms::LinearForm;
use imogene_prepare::{PreparedObject, PreparedQuadric, PreparedScene, prepare, prepare_for_roots};
use imogene_scene::{FramedObject, FramedScene, SceneFile};
use imogene_testkit::scene_file;
use num_traits::Signed;

/// Depth words.
const FORMATS: [u32; 5] = [16, 20, 24, 28, 32];
/// Most pixels of the collection's scene that differ, of 41 thousand.
const MOST: [usize; 5] = [240, 30, 3, 0, 0];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reason {
    /// A plane stands exactly at a face.
    Tie,
    /// A plane is within the bounds of a face, and the words have it on the other side.
    Rounding,
}

/// Pixels at which an object is compared, and at which its two pictures differ.
#[derive(Debug, Default)]
struct Tally {
    /// Pixels at which either sees the object.
    pixels: usize,
    /// The face's number alone, because of a tie.
    tie_of_numbers: usize,
    /// Depth or presence, because of a tie.
    tie_of_faces: usize,
    /// The face's number alone, because of rounding.
    rounded_numbers: usize,
    /// Depth or presence, because of rounding.
    rounded_faces: usize,
}

impl Tally {
    fn add(&mut self, reason: Reason, faces: bool) {
        *match (reason, faces) {
            (Reason::Tie, false) => &mut self.tie_of_numbers,
            (Reason::Tie, true) => &mut self.tie_of_faces,
            (Reason::Rounding, false) => &mut self.rounded_numbers,
            (Reason::Rounding, true) => &mut self.rounded_faces,
        } += 1;
    }

    fn differing(&self) -> usize {
        self.tie_of_numbers + self.tie_of_faces + self.rounded_numbers + self.rounded_faces
    }
}

/// The same scene for the quadric processor.
fn second_generation(scene: &FramedScene) -> FramedScene {
    let mut scene = scene.clone();
    for object in &mut scene.objects {
        let FramedObject::FirstGeneration(quadric) = object else {
            panic!("{} is not of the first generation", object.name());
        };
        *object = FramedObject::Quadric(quadric.clone());
    }
    scene
}

/// What a processor hands on at each pixel of the screen; nothing where the object is absent.
fn picture(words: &ProcessorWords, prepared: &PreparedScene) -> Vec<Option<ObjectPixel>> {
    let (width, height) = (prepared.width as usize, prepared.height as usize);
    let mut pixels = vec![None; width * height];
    for (y, line) in pixels.chunks_mut(width).enumerate() {
        words.for_each_present(&prepared.format, y as i64, |x, pixel| {
            line[x as usize] = Some(pixel);
        });
    }
    pixels
}

/// A plane as both generations have it.
struct Plane<'a> {
    contour: &'a ContourPlane,
    /// Index in the chain, and its bound.
    index: usize,
    /// -1 for the front plane, whose line is f1 - zp, and 1 for the back plane.
    side: i64,
}

fn planes<'a>(first: &'a FirstGenerationWords, second: &QuadricWords) -> [Plane<'a>; 2] {
    let index = |kind| second.planes.iter().position(|p| p.kind == kind);
    let index = |kind| index(kind).expect("a front plane and a back plane");
    [
        Plane {
            contour: &first.front,
            index: index(PlaneKind::Front),
            side: -1,
        },
        Plane {
            contour: &first.back,
            index: index(PlaneKind::Back),
            side: 1,
        },
    ]
}

/// The signs of the conic and of the line of a plane, from the unrounded expressions.
fn exact_signs(second: &PreparedQuadric, plane: &Plane, x: i64, y: i64) -> (bool, bool) {
    let at = |form: &LinearForm| form.at(&integer(x), &integer(y));
    let exact = &second.exact;
    let apart = at(&exact.planes[plane.index]) - at(&exact.f1);
    let f2 = exact.f2.at(&integer(x), &integer(y));
    let polar = &apart * integer(plane.side);
    (&apart * &apart <= f2, !polar.is_negative())
}

/// Why the generations may differ at a pixel; `None` if they may not.
fn reason(
    first: &FirstGenerationWords,
    second: &PreparedQuadric,
    (x, y): (i64, i64),
    format: &Format,
) -> Option<Reason> {
    let words = &second.words;
    let (f1, f2) = (words.f1_at(x, y, format), words.f2_at(x, y, format));
    let root = f2.max(0).isqrt();
    let bounds = &second.bounds;
    let mut found = None;
    for plane in planes(first, words) {
        let zp = words.planes[plane.index]
            .depth
            .wrapped_at(x, y, format.plane) as i64;
        if zp == f1 - root || zp == f1 + root {
            return Some(Reason::Tie);
        }
        let apart = i128::from(zp) - i128::from(f1);
        let conic = plane.contour.conic.wrapped_at(x, y, format.quadratic) >= 0;
        let polar = plane.contour.polar.wrapped_at(x, y, format.plane) >= 0;
        let (exact_conic, exact_polar) = exact_signs(second, &plane, x, y);
        assert_eq!((conic, polar), (exact_conic, exact_polar));
        let conic_of_words = apart * apart <= i128::from(f2);
        let polar_of_words = apart * i128::from(plane.side) >= 0;
        let linear = bounds.planes[plane.index] + bounds.f1 + bounds.dropped_f1;
        let rounded = linear + (bounds.f2 + bounds.dropped_f2).sqrt() + 1.0;
        if conic != conic_of_words {
            let distance = (apart.abs() - i128::from(root)).abs();
            assert!(distance as f64 <= rounded, "{distance} beyond {rounded}");
            found = Some(Reason::Rounding);
        }
        if polar != polar_of_words {
            assert!(apart.abs() as f64 <= linear, "{apart} beyond {linear}");
            found = Some(Reason::Rounding);
        }
    }
    found
}

/// Compares one object, adding what differs; the pixels that differ.
fn compare_object(
    name: &str,
    first: &FirstGenerationWords,
    second: &PreparedQuadric,
    prepared: &PreparedScene,
    tally: &mut Tally,
) -> Vec<usize> {
    let ours = picture(&ProcessorWords::FirstGeneration(first.clone()), prepared);
    let theirs = picture(&ProcessorWords::Quadric(second.words.clone()), prepared);
    let width = prepared.width as usize;
    let mut differing = vec![];
    for (index, (ours, theirs)) in ours.iter().zip(&theirs).enumerate() {
        tally.pixels += usize::from(ours.is_some() || theirs.is_some());
        let shown = |p: &Option<ObjectPixel>| p.map(|p| (p.zf, p.number, p.normal));
        if shown(ours) == shown(theirs) {
            continue;
        }
        let depth = |p: &Option<ObjectPixel>| p.map(|p| p.zf);
        let faces = depth(ours) != depth(theirs);
        let (x, y) = ((index % width) as i64, (index / width) as i64);
        let Some(why) = reason(first, second, (x, y), &prepared.format) else {
            panic!("{name} at ({x}, {y}): {ours:?} and {theirs:?}, no plane is at a face");
        };
        tally.add(why, faces);
        differing.push(index);
    }
    differing
}

/// Compares all objects and the decided frames of a scene.
fn compare(scene: &FramedScene, format: Format, tally: &mut Tally) -> bool {
    let second = prepare_for_roots(&second_generation(scene), format);
    let first = match prepare(scene, format) {
        Ok(first) => first,
        // Seen from inside or side-on; other refusals are those of the words that both have.
        Err(PrepareError::FirstGeneration { .. }) => return false,
        Err(other) => {
            assert_eq!(Some(other), second.err());
            return false;
        }
    };
    let second = second.expect("fits the chain too");
    let mut known = vec![];
    for (ours, theirs) in first.objects.iter().zip(&second.objects) {
        let words = ours.words();
        let (Some(ProcessorWords::FirstGeneration(words)), PreparedObject::Quadric(theirs)) =
            (words.first(), theirs)
        else {
            // Nothing of it is on the screen.
            assert!(words.is_empty() && theirs.screen_box().is_empty());
            continue;
        };
        let name = format!("{}: {}", scene.title, theirs.name);
        known.extend(compare_object(&name, words, theirs, &first, tally));
    }
    let (ours, theirs) = (first.frame(|| ()), second.frame(|| ()));
    for index in 0..ours.depth.len() {
        let face = |f: &imogene_golden::machine::frame::Frame| {
            (
                f.depth[index],
                f.id[index],
                f.number[index],
                f.normal[index],
            )
        };
        assert!(face(&ours) == face(&theirs) || known.contains(&index));
    }
    true
}

/// The scene of the collection in every format.
#[test]
fn the_scene_of_the_first_generation_differs_only_where_a_plane_is_at_a_face() {
    let scene = scene_file("processors/first-generation");
    let scene = scene.frame(480, 360).expect("a valid size");
    for (depth, most) in FORMATS.into_iter().zip(MOST) {
        let mut tally = Tally::default();
        let format = Format::new(depth).expect("a format");
        assert!(compare(&scene, format, &mut tally));
        eprintln!("depth word {depth}: {tally:?}");
        assert!(tally.pixels > 30_000);
        assert!(tally.differing() <= most, "{tally:?}");
    }
}

const CAMERAS: [(&str, &str); 2] = [
    (
        "perspective",
        "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nviewer_distance = 10\nview_height = 4",
    ),
    (
        "parallel",
        "kind = \"orthographic\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nview_height = 4\nhalf_depth = 4",
    ),
];

const SHAPES: [&str; 6] = [
    "kind = \"sphere\"\nradius = 1",
    "kind = \"ellipsoid\"\nradii = [1, 0.8, 0.7]",
    "kind = \"elliptic_cylinder\"\nradii = [0.6, 0.4]",
    "kind = \"cone\"\nradii = [0.5, 0.7, 0.5]",
    "kind = \"hyperboloid_one_sheet\"\nradii = [0.4, 0.6, 0.3]",
    "kind = \"elliptic_paraboloid\"\nradii = [0.5, 0.6, 0.5]",
];

/// Both through the shape, one beyond it, both beyond it, touching a sphere on both sides, past the middle, and past a
/// sphere.
const CUTS: [(f64, f64); 6] = [
    (0.5, -0.4),
    (0.3, -3.0),
    (2.5, -2.5),
    (1.0, -1.0),
    (0.75, 0.25),
    (1.75, 1.25),
];

fn variation(camera: &str, shape: &str, (up, down): (f64, f64), mode: &str, tilt: u32) -> String {
    format!(
        "format = 1\ntitle = \"{up} {down} {mode} {tilt}\"\n[camera]\n{camera}\n\
         [[materials]]\nname = \"clay\"\ncolour = [0.8, 0.4, 0.3]\n\
         [[objects]]\nname = \"thing\"\nmaterial = \"clay\"\n{shape}\nmode = \"{mode}\"\nprocessor = \"first_generation\"\n\
         place = [{{ rotate = {{ axis = \"x\", degrees = {tilt} }} }}]\n\
         cuts = [{{ point = [0, {up}, 0], normal = [0, 1, 0] }}, {{ point = [0, {down}, 0], normal = [0, -1, 0] }}]\n"
    )
}

/// Solids and patches of six shapes, planes through them, touching them and beyond them, slanted and square to the
/// view, in both projections.
#[test]
fn variations_differ_only_where_a_plane_is_at_a_face() {
    let mut all = Tally::default();
    let (mut compared, mut refused) = (0, 0);
    for mode in ["solid", "patch"] {
        let mut tally = Tally::default();
        for (camera_name, camera) in CAMERAS {
            for shape in SHAPES {
                for cuts in CUTS {
                    for tilt in [35, 90] {
                        let text = variation(camera, shape, cuts, mode, tilt);
                        let file = SceneFile::parse(&text, camera_name).expect("valid");
                        let scene = file.frame(96, 72).expect("a valid size");
                        for depth in FORMATS {
                            let format = Format::new(depth).expect("a format");
                            let done = compare(&scene, format, &mut tally);
                            *(if done { &mut compared } else { &mut refused }) += 1;
                        }
                    }
                }
            }
        }
        eprintln!("{mode}: {tally:?}");
        // A tie leaves a solid its depth and takes a face off a patch; the words move a face at one pixel in some
        // thousands.
        let (ties, none) = match mode {
            "solid" => (tally.tie_of_numbers, tally.tie_of_faces),
            _ => (tally.tie_of_faces, tally.tie_of_numbers),
        };
        assert!(ties > 0 && none == 0, "{tally:?}");
        assert!(
            tally.rounded_faces > 0 && tally.rounded_numbers == 0,
            "{tally:?}"
        );
        assert!(tally.differing() * 5000 < tally.pixels, "{tally:?}");
        all.pixels += tally.pixels;
    }
    eprintln!("{compared} scenes compared, {refused} refused");
    assert!(compared > 1000 && all.pixels > 500_000);
}
