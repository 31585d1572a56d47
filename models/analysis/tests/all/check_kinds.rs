//! The check of every kind of object, with the exact reference as the witness: what differs is announced, and every
//! depth is within its bound.

use crate::pictures::{Pictures, UNIT};
use imogene_algebra::rational::from_f64_exact;
use imogene_analysis::bounds::{CheckReport, check, failing};
use imogene_analysis::exact::shadow;
use imogene_golden::format::Format;
use imogene_golden::object::quadric::ScreenBox;
use imogene_prepare::Framing;
use imogene_prepare::forms::QuadraticForm;
use imogene_scene::SceneFile;
use imogene_testkit::{Random, is_full};
use num_traits::Signed;

const SIZE: (u32, u32) = (44, 33);

const CAMERAS: [&str; 2] = [
    "kind = \"perspective\"\neye = [1, 2, 9]\ntarget = [0, 0, 0]\nviewer_distance = 9.3\nview_height = 4\n",
    "kind = \"orthographic\"\neye = [3, 4, 10]\ntarget = [0, 0, 0]\nview_height = 4\nhalf_depth = 5\n",
];
const UP: &str = "{ point = [0, 0.6, 0], normal = [0, 1, 0] }";
const DOWN: &str = "{ point = [0, -0.7, 0], normal = [0, -1, 0] }";

/// The keys of a kind, and the cameras that can see it.
#[rustfmt::skip]
const KINDS: [(&str, &str, &[usize]); 12] = [
    ("ball", "kind = \"sphere\"\nradius = 0.9", &[0, 1]),
    ("double cone", "kind = \"cone\"\nradii = [0.5, 0.6, 0.5]\ncuts = [UP, DOWN]", &[0, 1]),
    ("hat", "kind = \"cone\"\nradii = [0.7, 0.6, 0.5]\ncuts = [{ point = [0, 0, 0], normal = [0, 1, 0] }, DOWN]", &[0, 1]),
    ("patch", "kind = \"hyperboloid_one_sheet\"\nradii = [0.5, 0.7, 0.5]\nmode = \"patch\"\ncuts = [UP, DOWN]", &[0, 1]),
    ("first generation", "kind = \"sphere\"\nradius = 1\nprocessor = \"first_generation\"\ncuts = [UP, DOWN]", &[0, 1]),
    ("polyhedron", "kind = \"polyhedron\"\ncuts = [UP, DOWN, { point = [1, 0, 0], normal = [1, 0, 0.2] }, { point = [-1, 0, 0], normal = [-1, 0, 0] }, { point = [0, 0, 0.4], normal = [0, 0.3, 1] }, { point = [0, 0, -1], normal = [0, 0, -1] }]", &[0, 1]),
    ("mesh", "kind = \"mesh\"\nvertices = [[0, 0, 0], [1, 0.1, 0.3], [0.2, 1, -0.4], [-0.8, 0.4, 0.5], [-0.3, -0.9, 0.1]]\nfaces = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [1, 2, 3]]", &[0, 1]),
    ("sliver", "kind = \"mesh\"\nvertices = [[-1, 0, 0], [1, 0.02, 0.3], [1, 0.0, -0.4], [-1, 0.5, 0], [1, 0.52, 0.2], [1, 0.51, 0.1]]\nfaces = [[0, 1, 2], [3, 4, 5]]", &[0, 1]),
    ("paraboloid sphere", "kind = \"sphere\"\nradius = 0.9\nprocessor = \"paraboloid\"", &[1]),
    ("paraboloid cylinder", "kind = \"elliptic_cylinder\"\nradii = [0.6, 0.6]\nprocessor = \"paraboloid\"\ncuts = [DOWN, UP]", &[1]),
    ("curved facet", "kind = \"sphere\"\nradius = 0.8\nmode = \"patch\"\nprocessor = \"curved_facet\"", &[1]),
    // The plane x = 0 twice over: a quotient.
    ("quotient", "kind = \"quadric\"\ncoefficients = [0, 0, 0, 1, 0, 0, 0, 0, 0, 0]\ncuts = [{ point = [1, 0, 0], normal = [1, 0, 0] }, { point = [-1, 0, 0], normal = [-1, 0, 0] }, { point = [0, 1, 0], normal = [0, 1, 0] }, { point = [0, -1, 0], normal = [0, -1, 0] }, { point = [0, 0, 1], normal = [0, 0, 1] }, { point = [0, 0, -1], normal = [0, 0, -1] }]", &[0, 1]),
];

fn text(camera: &str, objects: &[String], light: &str) -> String {
    let object = |(k, keys)| format!("[[objects]]\nname = \"o{k}\"\nmaterial = \"m\"\n{keys}\n");
    let objects: String = objects.iter().enumerate().map(object).collect();
    format!(
        "format = 1\ntitle = \"kinds\"\nimage = {{ width = 44, height = 33 }}\n[camera]\n{camera}{light}\
         [[materials]]\nname = \"m\"\ncolour = [0.8, 0.5, 0.3]\n{objects}"
         )
         .replace("UP", UP)
    .replace("DOWN", DOWN)
}

fn placed(keys: &str, random: &mut Random) -> String {
    let [x, y, z, angle] = [0.5, 0.4, 0.6, 180.0].map(|reach| random.signed() * reach);
    format!(
        "{keys}\nplace = [{{ rotate = {{ axis = [1, 2, 0.5], degrees = {angle:.3} }} }}, {{ translate = [{x:.4}, {y:.4}, {z:.4}] }}]"
    )
}

/// A scene by both models, and the report.
struct Case {
    pictures: Pictures,
    report: CheckReport,
}

/// `None` if the format refuses it.
fn case(text: &str, depth: u32) -> Option<Case> {
    let file = SceneFile::parse(text, "kinds.toml").expect("a valid scene");
    let scene = file.frame(SIZE.0, SIZE.1).ok()?;
    let format = Format::new(depth).expect("in the catalogue");
    let pictures = Pictures::of(scene, format).ok()?;
    let report = check(&pictures.scene, &pictures.prepared);
    Some(Case { pictures, report })
}

/// What the pixels of some cases say.
#[derive(Default, Debug)]
struct Tally {
    compared: usize,
    differing: usize,
    open: usize,
}

impl Case {
    /// The first generation counts its planes as front and back, the exact reference as the scene does.
    fn same_face(&self, (id, one): (i32, u8), (other_id, other): (i32, u8)) -> bool {
        let is_first_generation =
            || self.pictures.scene.objects[id as usize].processor() == "first_generation";
        id == other_id && (one == other || (one >= 2 && other >= 2 && is_first_generation()))
    }

    fn tally(&self, tally: &mut Tally, what: &str) {
        let Case { pictures, report } = self;
        let open = report.open.iter().filter(|&&o| o).count();
        assert_eq!(open, report.undecided_pixels);
        tally.open += open;
        for (index, exact) in pictures.exact.iter().enumerate() {
            let (place, open) = (pictures.place(index), report.open[index]);
            let face = pictures.golden_face(index);
            if !self.same_face(face, pictures.exact_face(index)) {
                tally.differing += 1;
                assert!(open, "{what} {place:?}: face {face:?}, exact {exact:?}");
            } else if let (Some(exact), false) = (exact, open) {
                tally.compared += 1;
                let off = pictures.depth_error(index, exact).abs();
                let bound = report.objects[exact.id as usize].depth_lsb();
                let most = bound + 2.0 / UNIT;
                assert!(off <= most, "{what} {place:?}: {off} beyond {bound}");
                assert!(bound <= report.bounds.depth_lsb);
            }
        }
    }
}

/// Two objects of a kind, one before the other, in random places.
#[test]
fn what_differs_is_announced_and_depths_are_within_their_bounds() {
    let mut random = Random(0x0ddb_a110);
    for (name, keys, cameras) in KINDS {
        let (mut tally, mut cases) = (Tally::default(), 0);
        for round in 0..12 {
            let camera = CAMERAS[cameras[round % cameras.len()]];
            let objects = [placed(keys, &mut random), placed(keys, &mut random)];
            for depth in [16, 24] {
                if let Some(case) = case(&text(camera, &objects, ""), depth) {
                    case.tally(&mut tally, name);
                    cases += 1;
                }
            }
        }
        println!("{name}: {cases} cases, {tally:?}");
        let some = cases >= 6 && tally.compared > 200;
        assert!(some, "{name}: {cases} cases, {tally:?}");
    }
}

/// Different kinds in one scene: what is compared is the picture, not each object by itself.
#[test]
fn kinds_cross_each_other() {
    let mut random = Random(0x00c0_ffee);
    let mut tally = Tally::default();
    for round in 0..16 {
        let objects: Vec<String> = (0..3)
            .map(|k| placed(KINDS[(3 * round + 4 * k) % KINDS.len()].1, &mut random))
            .collect();
        for depth in [16, 24] {
            if let Some(case) = case(&text(CAMERAS[1], &objects, ""), depth) {
                case.tally(&mut tally, "mixture");
            }
        }
    }
    println!("{tally:?}");
    assert!(tally.differing > 0 && tally.compared > 2000, "{tally:?}");
}

/// Two faces in one place: the earlier object wins by the contract, rounding may say otherwise.
#[test]
fn a_tie_of_any_kinds_is_announced() {
    let plate = |kind: &str, sides: &str| {
        format!(
            "{kind}\ncuts = [UP, DOWN, {{ point = [1, 0, 0], normal = [1, 0, 0] }}, {{ point = [-1, 0, 0], normal = [-1, 0, 0] }}, {{ point = [0, 0, 0.5], normal = [0, 0, 1] }}, {{ point = [0, 0, -1], normal = [0, 0, -1] }}{sides}]"
        )
    };
    let block = plate("kind = \"polyhedron\"", "");
    let taller = block.replace("UP", "{ point = [0, 0.9, 0], normal = [0, 1, 0] }");
    for camera in CAMERAS {
        let case = case(&text(camera, &[block.clone(), taller.clone()], ""), 24).expect("fits");
        let shown = case
            .pictures
            .golden
            .id
            .iter()
            .filter(|&&id| id == 0)
            .count();
        let undecided = case.report.undecided_pixels;
        assert!(shown > 100 && undecided >= shown, "{shown}");
    }
}

/// Looked at from above, a cone shows its apex: f2 has a pit there, and nothing around it moves.
#[test]
fn the_apex_of_a_cone_that_is_looked_into_does_not_fail_the_check() {
    let mut random = Random(0xa9e0);
    let mut apexes = 0;
    for round in 0..40 {
        let (x, z) = (random.signed() * 2.0, 3.0 + random.signed());
        let camera = format!(
            "kind = \"perspective\"\neye = [{x:.3}, 7, {z:.3}]\ntarget = [0, 0, 0]\nviewer_distance = 7\nview_height = 3\n"
        );
        let cone = "kind = \"cone\"\nradii = [0.9, 0.7, 0.8]\ncuts = [DOWN, TOP]";
        let top = if round % 2 == 0 {
            "{ point = [0, 0, 0], normal = [0, 1, 0] }"
        } else {
            "{ point = [0, 1, 0], normal = [0, 1, 0] }"
        };
        let case = case(&text(&camera, &[cone.replace("TOP", top)], ""), 24).expect("fits");
        case.tally(&mut Tally::default(), "cone");
        let bounds = &case.report.objects[0].quadric().expect("a quadric").bounds;
        apexes += usize::from(bounds.silhouette_singular);
        let off = bounds.silhouette_px;
        assert!(case.report.ok && off < 0.1, "{camera}: {off}");
    }
    assert!(apexes > 20, "{apexes} apexes");
}

/// Around an apex, on a grid much finer than pixels and in exact rationals: from any point at which the computed sign
/// of f2 is not the true one, a point at which it is lies within the stated displacement.
#[test]
fn a_spot_at_an_apex_is_as_wide_as_stated() {
    let mut random = Random(0x5907);
    let (mut differing, mut spots) = (0, 0);
    for _ in 0..if is_full() { 30 } else { 15 } {
        let (x, z) = (random.signed() * 2.0, 3.0 + random.signed());
        let camera = format!(
            "kind = \"perspective\"\neye = [{x:.3}, 7, {z:.3}]\ntarget = [0, 0, 0]\nviewer_distance = 7\nview_height = 3\n"
        );
        let cone = "kind = \"cone\"\nradii = [0.9, 0.7, 0.8]\ncuts = [DOWN, { point = [0, 1, 0], normal = [0, 1, 0] }]".to_owned();
        for depth in [16, 20] {
            let case = case(&text(&camera, std::slice::from_ref(&cone), ""), depth).expect("fits");
            let object = case.pictures.prepared.objects[0].quadric();
            let object = object.expect("a quadric");
            let bound = case.report.bounds.silhouette_px;
            let q = &object.words.f2;
            let [a, b, c, d, e] = [q.a, q.b, q.c, q.d, q.e].map(|v| v as f64);
            let unit = 4.0 * a * b - c * c;
            if unit <= 0.0 {
                continue;
            }
            spots += 1;
            let apex = [(c * e - 2.0 * b * d) / unit, (c * d - 2.0 * a * e) / unit];
            let words = QuadraticForm::of_words(q);
            let step = bound / 6.0;
            let place = |k: i64, axis: usize| from_f64_exact(apex[axis] + k as f64 * step);
            let agrees = |(u, v): (i64, i64)| {
                let (x, y) = (place(u, 0), place(v, 1));
                words.at(&x, &y).is_negative() == object.exact.f2.at(&x, &y).is_negative()
            };
            const REACH: i64 = 14;
            let grid = ScreenBox::of([-REACH, REACH], [-REACH, REACH]).each();
            let grid: Vec<(i64, i64)> = grid.collect();
            let right: Vec<(i64, i64)> = grid.iter().copied().filter(|&at| agrees(at)).collect();
            for &(u, v) in grid.iter().filter(|at| !right.contains(at)) {
                differing += 1;
                let near = |&(i, j): &(i64, i64)| ((i - u).pow(2) + (j - v).pow(2)) as f64;
                let least = right.iter().map(near).fold(f64::INFINITY, f64::min).sqrt();
                // Of points of a grid the nearest one may be a step farther.
                let far = (least - 1.5) * step;
                assert!(far <= bound, "{camera}: {far} beyond {bound}");
            }
        }
    }
    println!("{spots} spots, {differing} points differ");
    assert!(spots > 10 && differing > 10);
}

/// Words that are too short for a leaf: a check fails exactly if the quick one does, and never if the picture is right.
#[test]
fn the_quick_decision_is_that_of_the_check() {
    let mut random = Random(0x1eaf);
    let (mut failed, mut held) = (0, 0);
    for round in 0..60 {
        let thin = 10f64.powf(-1.0 - 2.5 * (round % 12) as f64 / 5.0);
        let keys = KINDS[[0, 1, 3][round % 3]].1;
        let angle = random.signed() * 90.0;
        let leaf = format!(
            "{keys}\nplace = [{{ scale = [1, 1, {thin}] }}, {{ rotate = {{ axis = [1, 0.3, 0.2], degrees = {angle:.2} }} }}]"
        );
        for depth in [16, 20] {
            let text = text(CAMERAS[round % 2], std::slice::from_ref(&leaf), "");
            let Some(case) = case(&text, depth) else {
                continue;
            };
            case.tally(&mut Tally::default(), "leaf");
            let found = failing(&case.pictures.scene, &case.pictures.prepared);
            assert_eq!(found.is_empty(), case.report.ok, "{leaf}: {found:?}");
            if case.report.ok {
                held += 1;
            } else {
                failed += 1;
                assert!(case.report.objects[0].problems.contains(&found[0].reason));
            }
        }
    }
    println!("{failed} fail, {held} hold");
    assert!(failed > 5 && held > 20, "{failed} fail, {held} hold");
}

/// Flags of the sources against exact segments: where they differ, light or object is announced.
#[test]
fn light_that_differs_is_announced() {
    let mut random = Random(0x0001_1947);
    let light = "[[lights]]\nkind = \"directional\"\nfrom = [-3, 5, 4]\nshadows = true\n[[lights]]\nkind = \"spot\"\nposition = [2, 5, 3]\ntarget = [0, 0, 0]\nhalf_angle = 11\nshadows = true\n";
    let floor = "kind = \"polyhedron\"\ncuts = [{ point = [0, -0.8, 0], normal = [0, 1, 0] }, { point = [0, -1.2, 0], normal = [0, -1, 0] }, { point = [2, 0, 0], normal = [1, 0, 0] }, { point = [-2, 0, 0], normal = [-1, 0, 0] }, { point = [0, 0, 2], normal = [0, 0, 1] }, { point = [0, 0, -2], normal = [0, 0, -1] }]";
    let (mut differing, mut open, mut dark, mut cases) = (0, 0, 0, 0);
    for round in 0..10 {
        let keys = KINDS[[0, 1, 5][round % 3]].1;
        let objects = [floor.to_owned(), placed(keys, &mut random)];
        for depth in [16, 24] {
            let Some(case) = case(&text(CAMERAS[round % 2], &objects, light), depth) else {
                continue;
            };
            cases += 1;
            let golden = case.pictures.prepared.light(&case.pictures.golden, || ());
            let exact = shadow::lighting(&case.pictures.scene, || ());
            open += case.report.undecided_light_pixels;
            for (index, (one, other)) in golden.flags.iter().zip(&exact.flags).enumerate() {
                if case.pictures.golden.id[index] < 0 || case.pictures.exact[index].is_none() {
                    // The light on the background is no light.
                    continue;
                }
                dark += usize::from(*one != u16::MAX);
                if one != other {
                    differing += 1;
                    let announced = case.report.open[index] || case.report.open_light[index];
                    assert!(
                        announced,
                        "round {round}, {depth} bits, pixel {index}: {one:b} {other:b}"
                    );
                }
            }
        }
    }
    println!("{cases} cases, {dark} dark pixels, {differing} differ, {open} open");
    assert!(cases >= 10 && dark > 1000 && open < dark / 2);
}
