//! Every scene of the collection: golden picture against exact picture, within the bounds that the check has proven.

use imogene_analysis::bounds::{depth_bound, normal_bound, undecided_pixels};
use imogene_analysis::exact::render::{DEPTH_FRACTION, ExactPixel, render};
use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::unit::depth_interval::{FACE_NEAR_END, FACE_PLANE};
use imogene_prepare::Framing;
use imogene_prepare::{PreparedQuadric, PreparedScene, prepare};
use imogene_scene::{FramedScene, Projection, SceneFile};
use imogene_testkit::{angle_deg, gradient, scenes_in};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

const SIZE: (u32, u32) = (320, 240);

/// Pixels at which golden and exact picture are known to differ: scene, column, line, reason. All lie on a sharp edge
/// where a cut plane meets the quadric, and the two depths differ by less than their rounding bounds together.
const KNOWN_DIFFERENCES: [(&str, usize, usize, &str); 5] = [
    (
        "ellipsoid",
        254,
        132,
        "far root 41 words before the front plane; rounding exchanges them",
    ),
    (
        "front-view",
        216,
        46,
        "far root 14 words before the back plane; rounding exchanges them",
    ),
    (
        "front-view",
        146,
        139,
        "far root 26 words before the back plane; rounding exchanges them",
    ),
    (
        "front-view",
        249,
        214,
        "near root 19 words behind the front plane; rounding exchanges them",
    ),
    (
        "hyperbolic-cylinder",
        261,
        74,
        "near root 50 words before the front plane; rounding exchanges them, only the face differs",
    ),
];

type Exact = Arc<Vec<Option<ExactPixel>>>;

/// The exact picture of a scene in depth words of this length, drawn once for all tests.
fn exact_picture(file: &Path, scene: &FramedScene, format: &Format) -> Exact {
    static DRAWN: Mutex<BTreeMap<(PathBuf, u32), Exact>> = Mutex::new(BTreeMap::new());
    let mut drawn = DRAWN.lock().expect("no test failed before");
    let place = drawn.entry((file.to_owned(), format.depth));
    let draw = || render(scene, format, || ()).into();
    place.or_insert_with(draw).clone()
}

struct Pictures {
    scene: FramedScene,
    prepared: PreparedScene,
    golden: Frame,
    exact: Exact,
    undecided: Vec<bool>,
}

fn pictures(file: &Path, format: Format) -> Pictures {
    let scene = SceneFile::read(file)
        .expect("valid")
        .frame(SIZE.0, SIZE.1)
        .expect("valid size");
    let prepared = prepare(&scene, format).expect("the scenes of the collection fit");
    Pictures {
        golden: prepared.frame(|| ()),
        exact: exact_picture(file, &scene, &format),
        undecided: undecided_pixels(&scene, &prepared),
        scene,
        prepared,
    }
}

/// Worst observed value beside the bound that held there, and the greatest ratio of the two.
#[derive(Default)]
struct Tightness {
    worst: f64,
    bound_at_worst: f64,
    ratio: f64,
}

impl Tightness {
    fn add(&mut self, observed: f64, bound: f64) {
        if observed > self.worst {
            (self.worst, self.bound_at_worst) = (observed, bound);
        }
        if bound > 0.0 {
            self.ratio = self.ratio.max(observed / bound);
        }
    }
}

impl Pictures {
    fn column_line(&self, index: usize) -> (usize, usize) {
        (index % self.golden.width, index / self.golden.width)
    }

    fn same_face(&self, index: usize, exact: &ExactPixel) -> bool {
        self.golden.id[index] == exact.id as i32 && self.golden.number[index] == exact.number
    }

    fn differs(&self, index: usize) -> bool {
        match &self.exact[index] {
            None => self.golden.id[index] >= 0,
            Some(exact) => !self.same_face(index, exact),
        }
    }

    fn quadric(&self, id: u32) -> &PreparedQuadric {
        self.prepared.objects[id as usize]
            .quadric()
            .expect("a quadric")
    }

    fn f2_at(&self, index: usize, id: u32) -> i64 {
        let (x, y) = self.column_line(index);
        let words = &self.quadric(id).words;
        words.f2_at(x as i64, y as i64, &self.prepared.format)
    }

    fn compare_depths(&self, name: &str) -> Tightness {
        let mut tightness = Tightness::default();
        for (index, exact) in self.seen() {
            let object = self.quadric(exact.id);
            let bound = depth_bound(object, exact.number, self.f2_at(index, exact.id));
            let unit = f64::from(1u32 << DEPTH_FRACTION);
            let off = (self.golden.depth[index] as f64 - exact.depth as f64 / unit).abs();
            // The exact depth itself is cut after its fraction bits.
            assert!(
                off <= bound + 2.0 / unit,
                "{name} {:?}: {off} beyond {bound}",
                self.column_line(index)
            );
            tightness.add(off, bound);
        }
        tightness
    }

    fn compare_normals(&self, name: &str) -> Tightness {
        let mut tightness = Tightness::default();
        for (index, exact) in self.seen() {
            let object = self.quadric(exact.id);
            let normal = self.golden.normal[index];
            let bound = normal_bound(object, exact.number, self.f2_at(index, exact.id), normal);
            let off = angle_deg(normal.map(f64::from), self.true_normal(index, exact));
            // Allowance for the evaluation of the gradient in floating point.
            assert!(
                off <= bound + 1e-4,
                "{name} {:?}: {off} beyond {bound} degrees",
                self.column_line(index)
            );
            tightness.add(off, bound);
        }
        tightness
    }

    /// Pixels at which both pictures show the same face.
    fn seen(&self) -> impl Iterator<Item = (usize, &ExactPixel)> {
        let exact = self.exact.iter().enumerate();
        exact
            .filter_map(|(i, e)| e.as_ref().map(|e| (i, e)))
            .filter(|(i, e)| self.same_face(*i, e))
    }

    fn true_normal(&self, index: usize, exact: &ExactPixel) -> [f64; 3] {
        let object = self.scene.objects[exact.id as usize]
            .quadric()
            .expect("a quadric");
        if exact.number == FACE_NEAR_END {
            return [0.0, 0.0, -1.0];
        }
        if exact.number >= FACE_PLANE {
            let plane = &object.planes[usize::from(exact.number - FACE_PLANE)];
            return [&plane.a, &plane.b, &plane.c].map(imogene_algebra::rational::to_f64);
        }
        let (x, y) = self.column_line(index);
        let full = imogene_algebra::rational::to_f64(match &self.scene.projection {
            Projection::Perspective { distance } => distance,
            Projection::Orthographic { half_depth } => half_depth,
        });
        let unit = f64::from(1u32 << DEPTH_FRACTION) * self.prepared.format.z_max() as f64;
        let depth = exact.depth as f64 / unit * full;
        let point = self
            .scene
            .projection
            .antecedent(self.scene.pixel_centre(x, y), depth);
        gradient(&object.quadric, point)
    }

    /// The pixels that differ; each must have been declared undecided.
    fn differences(&self, name: &str) -> Vec<(usize, usize)> {
        let differing = (0..self.exact.len()).filter(|&i| self.differs(i));
        differing
            .map(|index| {
                let at = self.column_line(index);
                assert!(self.undecided[index], "{name} {at:?} was declared decided");
                at
            })
            .collect()
    }

    fn undecided_count(&self) -> usize {
        self.undecided.iter().filter(|&&u| u).count()
    }
}

#[test]
fn every_scene_stays_within_its_bounds() {
    let mut differences = vec![];
    for file in scenes_in("") {
        let name = file
            .file_stem()
            .expect("a file")
            .to_string_lossy()
            .into_owned();
        let pictures = pictures(&file, Format::BASE);
        let depth = pictures.compare_depths(&name);
        let normal = pictures.compare_normals(&name);
        let undecided = pictures.undecided_count();
        println!(
            "{name}: depth {:.1} (bound there {:.1}, tightest {:.0} %), normal {:.4} deg (bound there {:.4}, tightest {:.0} %), \
             {undecided} undecided of {} pixels",
            depth.worst,
            depth.bound_at_worst,
            100.0 * depth.ratio,
            normal.worst,
            normal.bound_at_worst,
            100.0 * normal.ratio,
            pictures.golden.covered()
        );
        for (x, y) in pictures.differences(&name) {
            let index = y * pictures.golden.width + x;
            println!(
                "{name} differs at ({x}, {y}): golden object {} face {} depth {}, exact {:?}",
                pictures.golden.id[index],
                pictures.golden.number[index],
                pictures.golden.depth[index],
                pictures.exact[index]
            );
            differences.push((name.clone(), x, y));
        }
    }
    let known: Vec<_> = KNOWN_DIFFERENCES
        .iter()
        .map(|&(n, x, y, _)| (n.to_string(), x, y))
        .collect();
    assert_eq!(differences, known);
}

/// The bounds are stated for every format; the shorter the word, the more pixels they leave undecided.
#[test]
fn bounds_hold_in_every_format() {
    let chosen = ["cone", "front-view", "teapot"];
    let files = scenes_in("");
    for name in chosen {
        let file = files
            .iter()
            .find(|f| f.file_stem().is_some_and(|s| s == name));
        let mut last = usize::MAX;
        for depth in Format::CATALOGUE {
            let format = Format::new(depth).expect("in the catalogue");
            let pictures = pictures(file.expect("in the collection"), format);
            let depths = pictures.compare_depths(name);
            let normals = pictures.compare_normals(name);
            let differing = pictures.differences(name).len();
            let undecided = pictures.undecided_count();
            println!(
                "{name}, {depth} bits: depth {:.1} (tightest {:.0} %), normal {:.3} deg (tightest {:.0} %), {differing} pixels differ of \
                 {undecided} undecided",
                depths.worst,
                100.0 * depths.ratio,
                normals.worst,
                100.0 * normals.ratio
            );
            assert!(undecided <= last);
            last = undecided;
        }
    }
}

/// The scene of this name.
fn named<'a>(files: &'a [PathBuf], name: &str) -> &'a Path {
    let mut files = files.iter();
    let file = files.find(|file| file.file_stem().is_some_and(|stem| stem == name));
    file.expect("in the collection")
}

/// Guard bits make the depth error smaller, and the bounds that take them into account hold.
#[test]
fn bounds_hold_with_guard_bits() {
    let files = scenes_in("");
    for name in ["cone", "front-view", "teapot"] {
        let file = named(&files, name);
        for depth in [16, 24] {
            let base = Format::new(depth).expect("in the catalogue");
            let mut last = (f64::INFINITY, usize::MAX);
            for (linear, quadratic) in [(0, 0), (4, 8)] {
                let format = base.with_guards(linear, quadratic).expect("within limits");
                let pictures = pictures(file, format);
                let depths = pictures.compare_depths(name);
                pictures.compare_normals(name);
                let differing = pictures.differences(name).len();
                let undecided = pictures.undecided_count();
                println!(
                    "{name}, {depth} bits, guards {linear}:{quadratic}: depth {:.2} (bound there {:.2}, tightest {:.0} %), \
                     {differing} pixels differ of {undecided} undecided",
                    depths.worst,
                    depths.bound_at_worst,
                    100.0 * depths.ratio
                );
                assert!(depths.worst <= last.0 && undecided <= last.1);
                last = (depths.worst, undecided);
            }
        }
    }
}

/// With an approximate root every depth stays within its bound, and no pixel is another one that was declared decided.
#[test]
fn bounds_hold_with_every_form_of_the_root() {
    let files = scenes_in("");
    for name in ["cone", "front-view", "teapot"] {
        let file = named(&files, name);
        let worst = |form: &str, dropped_rows: u32| {
            let format = Format::fitted(&MachineWords {
                root_form: form.parse().expect("a form"),
                dropped_rows,
                ..MachineWords::of(24)
            });
            let pictures = pictures(file, format.expect("within limits"));
            let depths = pictures.compare_depths(name);
            pictures.compare_normals(name);
            println!(
                "{name}, {form} less {dropped_rows}: depth {:.0} (bound there {:.0}, tightest {:.0} %), {} pixels differ of {} undecided",
                depths.worst,
                depths.bound_at_worst,
                100.0 * depths.ratio,
                pictures.differences(name).len(),
                pictures.undecided_count()
            );
            depths.worst
        };
        let exact = worst("restoring", 0);
        assert_eq!(exact, worst("non-restoring", 0));
        let linear = [0, 1, 2].map(|count| worst(&format!("linear{count}"), 0));
        assert!(
            linear.is_sorted_by(|a, b| a > b) && linear[2] > exact,
            "{linear:?}"
        );
        for (form, dropped) in [
            ("quadratic0", 0),
            ("quadratic1", 4),
            ("leading4", 0),
            ("leading8", 2),
        ] {
            assert!(worst(form, dropped) > exact, "{form}");
        }
    }
}
