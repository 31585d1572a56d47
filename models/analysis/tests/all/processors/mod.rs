//! Scenes of the other object processors: golden picture against exact picture.

mod meshes;
mod tetrahedra;

use crate::pictures::Pictures;
use imogene_algebra::rational::{integer, to_f64};
use imogene_analysis::bounds::{check, undecided_pixels};
use imogene_golden::format::Format;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::cut_plane::PlaneKind;
use imogene_prepare::prepare;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{Framing, PreparedScene};
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

fn file(name: &str) -> SceneFile {
    scene_file(&format!("processors/{name}"))
}

fn pictures(name: &str, format: Format) -> Pictures {
    Pictures::of_file(&file(name), SIZE, format)
}

/// The pixels at which the pictures show different faces; each has its golden face among its neighbours in the exact
/// picture: an edge is less than a pixel away.
fn differences(pictures: &Pictures) -> usize {
    let at_an_edge = |index: &usize| {
        let face = pictures.golden_face(*index);
        let mut around = pictures.around(*index, 1);
        let near = around.any(|i| pictures.exact_face(i) == face);
        assert!(near, "pixel {:?}: drawn {face:?}", pictures.place(*index));
    };
    pictures.differing().inspect(at_an_edge).count()
}

fn assert_same_faces(pictures: &Pictures) {
    assert_eq!(pictures.differing().next(), None);
}

/// Faces differ and depths are off as the words of a scene of quadrics, prepared by the quadric processor, allow.
fn assert_within_bounds(pictures: &Pictures, scene: &FramedScene, prepared: &PreparedScene) {
    let undecided = undecided_pixels(scene, prepared);
    for index in pictures.differing() {
        assert!(undecided[index], "pixel {index} is decided");
    }
    for (i, off) in pictures.depth_errors() {
        let bound = pictures.depth_bound(prepared, i);
        assert!(off.abs() <= bound + 1e-5, "{off} beyond {bound}");
    }
}

/// Polyhedra differ by the rounding of their planes alone.
#[test]
fn polyhedra_are_within_the_rounding_of_their_planes() {
    for depth in [16, 24, 32] {
        let pictures = pictures("polyhedron", Format::new(depth).unwrap());
        let differences = differences(&pictures);
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
        let pictures = pictures(name, Format::BASE);
        assert_within_bounds(&pictures, &pictures.scene, &pictures.prepared);
    }
}

/// The same objects by the quadric processor give the bounds; the first generation decides by contours instead of
/// depths.
#[test]
fn first_generation_is_within_the_bounds_of_its_quadrics() {
    for depth in [20, 24] {
        let format = Format::new(depth).unwrap();
        let pictures = pictures("first-generation", format);
        let mut scene = pictures.scene.clone();
        for object in &mut scene.objects {
            let FramedObject::FirstGeneration(quadric) = object else {
                panic!("of the first generation");
            };
            *object = FramedObject::Quadric(quadric.clone());
        }
        let second = prepare(&scene, format).expect("fits");
        assert_within_bounds(&pictures, &scene, &second);
        assert!(pictures.golden.covered() > 15_000);
    }
}

/// Outlines are exact; the depth is off by the paraboloid: 0.2945 of the radius, over the level part of the axis for a
/// cylinder, and a count of rounding.
#[test]
fn paraboloids_have_the_exact_outline_at_any_size() {
    for size in [(160, 120), (320, 240), (480, 360)] {
        let pictures = Pictures::of_file(&file("paraboloids"), size, Format::BASE);
        assert_same_faces(&pictures);
        let scale = to_f64(&pictures.prepared.depth_scale);
        for (i, off) in pictures.depth_errors() {
            let flat = pictures.golden.number[i] > 0;
            let bound = match &pictures.scene.objects[pictures.golden.id[i] as usize] {
                FramedObject::Sphere(s) => 0.2946 * to_f64(&s.radius) * scale,
                FramedObject::Cylinder(_) if flat => 0.0,
                FramedObject::Cylinder(c) => 0.2946 * to_f64(&c.radius) * scale / to_f64(&c.level),
                _ => 2.0,
            };
            assert!(off.abs() <= bound + 1.0, "{off} beyond {bound}");
        }
        let mut objects = pictures.prepared.objects.iter();
        assert!(objects.all(|o| o.notes().is_empty()));
    }
}

/// A depth of second degree is drawn to the count; the sphere is a paraboloid.
#[test]
fn curved_facets_have_the_exact_outline_and_depth() {
    let pictures = pictures("curved-facet", Format::BASE);
    let mut compared = [0; 3];
    assert_same_faces(&pictures);
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
