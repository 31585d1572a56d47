//! Scenes of the other object processors: golden picture against exact picture.

mod meshes;
mod tetrahedra;

use imogene_algebra::rational::{integer, to_f64};
use imogene_analysis::bounds::{check, depth_bound, undecided_pixels};
use imogene_analysis::exact::render::{DEPTH_FRACTION, ExactPixel, render, to_frame};
use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_prepare::Framing;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{PreparedScene, prepare};
use imogene_scene::{FramedObject, FramedScene, Quadric, SceneFile, Shape};
use imogene_testkit::scene_file;
use num_rational::BigRational;
use num_traits::Zero;

const SIZE: (u32, u32) = (320, 240);

const FILES: [&str; 7] = [
    "curved-facet",
    "first-generation",
    "mesh",
    "paraboloids",
    "patch-processor",
    "polyhedron",
    "tetrahedra",
];

struct Pictures {
    scene: FramedScene,
    prepared: PreparedScene,
    golden: Frame,
    exact: Vec<Option<ExactPixel>>,
}

fn file(name: &str) -> SceneFile {
    scene_file(&format!("processors/{name}"))
}

impl Pictures {
    fn of(name: &str, format: Format) -> Pictures {
        Pictures::of_file(&file(name), SIZE, format)
    }

    fn of_file(file: &SceneFile, (width, height): (u32, u32), format: Format) -> Pictures {
        let scene = file.frame(width, height).expect("valid");
        let prepared = prepare(&scene, format).expect("fits");
        Pictures {
            golden: prepared.frame(|| ()),
            exact: render(&scene, &format, || ()),
            scene,
            prepared,
        }
    }

    fn exact_face(&self, index: usize) -> (i32, u8) {
        self.exact[index].map_or((-1, 0), |e| (e.id as i32, e.number))
    }

    fn golden_face(&self, index: usize) -> (i32, u8) {
        (self.golden.id[index], self.golden.number[index])
    }

    /// The pixels at which the pictures show different faces; each has its golden face among its neighbours in the
    /// exact picture: an edge is less than a pixel away.
    fn differences(&self) -> usize {
        let (w, h) = (self.golden.width as i64, self.golden.height as i64);
        let mut count = 0;
        for index in 0..self.exact.len() {
            if self.exact_face(index) == self.golden_face(index) {
                continue;
            }
            count += 1;
            let (x, y) = (index as i64 % w, index as i64 / w);
            let near = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (x + dx, y + dy)));
            let mut near = near.filter(|&(x, y)| (0..w).contains(&x) && (0..h).contains(&y));
            assert!(
                near.any(|(x, y)| self.exact_face((y * w + x) as usize) == self.golden_face(index)),
                "pixel ({x}, {y}): drawn {:?}, exact {:?}",
                self.golden_face(index),
                self.exact[index]
            );
        }
        count
    }

    /// Pixels of the exact picture within two pixels of both objects 0 and 1, and not at the outline, where a joint
    /// ends.
    fn joint(&self) -> Vec<usize> {
        let (w, h) = (self.golden.width as i64, self.golden.height as i64);
        let id = |u: i64, v: i64| self.exact_face((v * w + u) as usize).0;
        let around = |x: i64, y: i64, reach: i64| {
            let lines = (y - reach).max(0)..=(y + reach).min(h - 1);
            lines.flat_map(move |v| {
                ((x - reach).max(0)..=(x + reach).min(w - 1)).map(move |u| (u, v))
            })
        };
        let near = |x, y, object| around(x, y, 2).any(|(u, v)| id(u, v) == object);
        (0..w * h)
            .filter(|i| {
                let (x, y) = (i % w, i / w);
                near(x, y, 0) && near(x, y, 1) && around(x, y, 1).all(|(u, v)| id(u, v) >= 0)
            })
            .map(|i| i as usize)
            .collect()
    }

    /// Index, and golden less exact depth in depth words, of each pixel at which both show the same face.
    fn depth_errors(&self) -> impl Iterator<Item = (usize, f64)> {
        let unit = f64::from(1u32 << DEPTH_FRACTION);
        let same =
            |i: &usize| self.exact[*i].is_some() && self.exact_face(*i) == self.golden_face(*i);
        (0..self.exact.len()).filter(same).map(move |i| {
            let exact = self.exact[i].expect("filtered").depth as f64 / unit;
            (i, self.golden.depth[i] as f64 - exact)
        })
    }

    /// Angles between golden and exact normal in degrees, with the object.
    fn normal_errors(&self) -> Vec<(i32, f64)> {
        let exact = to_frame(&self.exact, &self.scene, &self.prepared.format);
        let angle = |(i, _): (usize, f64)| {
            let [one, other] = [&self.golden, &exact].map(|f| f.normal[i].map(f64::from));
            (self.golden.id[i], imogene_testkit::angle_deg(one, other))
        };
        self.depth_errors().map(angle).collect()
    }
}

/// Polyhedra differ by the rounding of their planes alone.
#[test]
fn polyhedra_are_within_the_rounding_of_their_planes() {
    for depth in [16, 24, 32] {
        let pictures = Pictures::of("polyhedron", Format::new(depth).unwrap());
        let differences = pictures.differences();
        println!("depth word {depth}: {differences} pixels differ");
        assert!(differences <= 2 + (200 >> (depth - 16)), "{differences}");
        for (i, off) in pictures.depth_errors() {
            let object = &pictures.prepared.objects[pictures.golden.id[i] as usize];
            let window = object.screen_box();
            let bound = Anchor::middle_of(window).linear_bound(window);
            assert!(off.abs() <= bound, "{off} beyond {bound}");
        }
        assert!(pictures.normal_errors().iter().all(|&(_, off)| off < 0.01));
        assert!(pictures.golden.covered() > 10_000);
    }
}

/// The patch processor has the words and the bounds of the quadric processor.
#[test]
fn patches_are_within_their_proven_bounds() {
    for name in ["patch-processor", "tetrahedra"] {
        let pictures = Pictures::of(name, Format::BASE);
        let undecided = undecided_pixels(&pictures.scene, &pictures.prepared);
        for (i, &open) in undecided.iter().enumerate() {
            assert!(
                open || pictures.exact_face(i) == pictures.golden_face(i),
                "{name} {i}"
            );
        }
        let width = pictures.golden.width;
        for (i, off) in pictures.depth_errors() {
            let object = pictures.prepared.objects[pictures.golden.id[i] as usize].quadric();
            let object = object.expect("a patch");
            let (x, y) = ((i % width) as i64, (i / width) as i64);
            let f2 = object.words.f2_at(x, y, &pictures.prepared.format);
            let bound = depth_bound(object, pictures.golden.number[i], f2);
            assert!(off.abs() <= bound + 1e-5, "{off} beyond {bound}");
        }
    }
}

/// The same objects by the quadric processor give the bounds; the first generation decides by contours instead of
/// depths.
#[test]
fn first_generation_is_within_the_bounds_of_its_quadrics() {
    for depth in [20, 24] {
        let format = Format::new(depth).unwrap();
        let pictures = Pictures::of("first-generation", format);
        let mut scene = pictures.scene.clone();
        for object in &mut scene.objects {
            let FramedObject::FirstGeneration(quadric) = object else {
                panic!("of the first generation");
            };
            *object = FramedObject::Quadric(quadric.clone());
        }
        let second = prepare(&scene, format).expect("fits");
        let undecided = undecided_pixels(&scene, &second);
        let differing = (0..undecided.len())
            .filter(|&i| pictures.exact_face(i) != pictures.golden_face(i))
            .collect::<Vec<_>>();
        println!("depth word {depth}: {} pixels differ", differing.len());
        for i in differing {
            assert!(undecided[i], "pixel {i} is decided");
        }
        let width = pictures.golden.width;
        for (i, off) in pictures.depth_errors() {
            let object = second.objects[pictures.golden.id[i] as usize].quadric();
            let object = object.expect("a quadric");
            let (x, y) = ((i % width) as i64, (i / width) as i64);
            let f2 = object.words.f2_at(x, y, &format);
            let bound = depth_bound(object, pictures.golden.number[i], f2);
            assert!(off.abs() <= bound + 1e-5, "{off} beyond {bound}");
        }
        assert!(pictures.golden.covered() > 15_000);
    }
}

/// Outlines are exact; the depth is off by the paraboloid: 0.2945 of the radius, over the level part of the axis for a
/// cylinder, and a count of rounding.
#[test]
fn paraboloids_have_the_exact_outline_at_any_size() {
    for size in [(160, 120), (320, 240), (480, 360)] {
        let pictures = Pictures::of_file(&file("paraboloids"), size, Format::BASE);
        for i in 0..pictures.exact.len() {
            assert_eq!(pictures.exact_face(i), pictures.golden_face(i), "pixel {i}");
        }
        let scale = to_f64(&pictures.prepared.depth_scale);
        for (i, off) in pictures.depth_errors() {
            let bound = match (
                &pictures.scene.objects[pictures.golden.id[i] as usize],
                pictures.golden.number[i],
            ) {
                (FramedObject::Sphere(s), _) => 0.2946 * to_f64(&s.radius) * scale,
                (FramedObject::Cylinder(c), 0) => {
                    0.2946 * to_f64(&c.radius) * scale / to_f64(&c.level)
                }
                (FramedObject::Cylinder(_), _) => 0.0,
                _ => 2.0,
            };
            assert!(off.abs() <= bound + 1.0, "{off} beyond {bound}");
        }
        assert!(
            pictures
                .prepared
                .objects
                .iter()
                .all(|o| o.notes().is_empty())
        );
    }
}

/// A depth of second degree is drawn to the count; the sphere is a paraboloid.
#[test]
fn curved_facets_have_the_exact_outline_and_depth() {
    let pictures = Pictures::of("curved-facet", Format::BASE);
    let mut compared = [0; 3];
    for i in 0..pictures.exact.len() {
        assert_eq!(pictures.exact_face(i), pictures.golden_face(i), "pixel {i}");
    }
    let scale = to_f64(&pictures.prepared.depth_scale);
    for (i, off) in pictures.depth_errors() {
        let id = pictures.golden.id[i] as usize;
        let bound = match &pictures.scene.objects[id] {
            FramedObject::CurvedSphere(s) => 0.2946 * to_f64(&s.radius) * scale,
            _ => 0.51,
        };
        assert!(off.abs() <= bound, "object {id}: {off} beyond {bound}");
        compared[id] += 1;
    }
    assert!(compared.iter().all(|&n| n > 3000), "{compared:?}");
}

/// The words are proven to fit for every format, and the check reports every object.
#[test]
fn every_format_draws_every_scene() {
    for name in FILES {
        let file = file(name);
        let scene = file.frame(160, 120).expect("valid");
        let mut covered = vec![];
        for depth in Format::CATALOGUE {
            let format = Format::new(depth).unwrap();
            let prepared = prepare(&scene, format).expect("fits");
            covered.push(prepared.frame(|| ()).covered());
            let report = check(&scene, &prepared);
            assert_eq!(report.objects.len(), scene.objects.len());
            for object in &prepared.objects {
                if let imogene_prepare::PreparedObject::Parts(parts) = object {
                    assert!(!parts.needed.is_empty() && !parts.words.is_empty());
                    assert!(parts.needed.iter().all(|n| n.needed <= n.available));
                }
            }
        }
        let (least, most) = (covered.iter().min().unwrap(), covered.iter().max().unwrap());
        assert!(most - least < 20, "{name}: {covered:?}");
    }
}

/// Guard bits widen the core of the first generation only.
#[test]
fn first_generation_takes_guard_bits() {
    let format = Format::BASE.with_guards(4, 8).unwrap();
    let scene = file("first-generation").frame(160, 120).expect("valid");
    let [plain, guarded] =
        [Format::BASE, format].map(|format| prepare(&scene, format).expect("fits").frame(|| ()));
    let other = plain.id.iter().zip(&guarded.id).filter(|(a, b)| a != b);
    assert!(other.count() < 5);
    assert!(plain.depth != guarded.depth);
}

fn parallel_view(eye: [f64; 3]) -> imogene_scene::Camera {
    let pose = [eye, [0.0, 0.1, 0.0], [0.0, 1.0, 0.0]];
    imogene_scene::Camera {
        lens: imogene_scene::Lens::Orthographic {
            half_depth: Some(4.0),
            ends: None,
        },
        ..imogene_scene::Camera::perspective(pose, 1.0, 4.0)
    }
}
