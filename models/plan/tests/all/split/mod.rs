//! A picture that workers draw piece by piece is the picture of the whole screen: every scene of the collection, every
//! processor.

mod division;
mod duplication;

use imogene_golden::format::Format;
use imogene_golden::machine::frame::Frame;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::object::slot::ProcessorWords;
use imogene_plan::split::{Divided, Division};
use imogene_prepare::{Framing, PreparedScene, prepare};
use imogene_testkit::{collection, file_prepared, scene_file};
use std::collections::BTreeMap;
use std::path::Path;

/// A screen that none of the divisions divides.
const SIZE: (u32, u32) = (83, 61);

/// The scene in the base format; none if the preparation refuses it.
fn prepared(path: &Path) -> Option<PreparedScene> {
    file_prepared(path, SIZE, Format::BASE).map(|(_, prepared)| prepared)
}

fn whole(scene: &PreparedScene) -> (Frame, Lighting) {
    let frame = scene.frame(|| ());
    let lighting = scene.light(&frame, || ());
    (frame, lighting)
}

const fn zones(width: u32, height: u32) -> Division {
    Division::Zones { width, height }
}

const DIVISIONS: [(Division, usize); 5] = [
    (zones(16, 16), 3),
    (zones(64, 7), 2),
    (Division::Lines(3), 3),
    (Division::Lines(2), 5),
    (Division::Lines(61), 4),
];

fn assert_is_whole(divided: &Divided, whole: &(Frame, Lighting), what: &str) {
    let (frame, lighting) = whole;
    assert!(divided.frame.depth == frame.depth, "depths of {what}");
    assert!(divided.frame.id == frame.id, "objects of {what}");
    assert!(divided.frame.number == frame.number, "faces of {what}");
    assert!(divided.frame.normal == frame.normal, "normals of {what}");
    assert!(divided.lighting == *lighting, "flags of {what}");
}

#[test]
fn every_scene_of_the_collection_is_the_same_however_it_is_divided() {
    let mut kinds = BTreeMap::new();
    let (mut drawn, mut lit) = (0, 0);
    for path in collection() {
        let Some(scene) = prepared(&path) else {
            continue;
        };
        let name = path.display();
        if scene.refuse_transparent().is_err() {
            continue;
        }
        let whole = whole(&scene);
        for slot in scene.slots() {
            let kind = match slot.words {
                ProcessorWords::Quadric(_) => "quadric",
                ProcessorWords::Patch(_) => "patch",
                ProcessorWords::FirstGeneration(_) => "first generation",
                ProcessorWords::Polyhedron(_) => "polyhedron",
                ProcessorWords::Facet(_) => "facet",
                ProcessorWords::Sphere(_) => "sphere",
                ProcessorWords::Cylinder(_) => "cylinder",
                ProcessorWords::CurvedFacet(_) => "curved facet",
                ProcessorWords::Quotient(_) => "quotient",
                ProcessorWords::Member(_) => "object of a solid",
            };
            *kinds.entry(kind).or_insert(0) += 1;
        }
        for (division, workers) in DIVISIONS {
            let divided = Divided::draw(&scene, division, workers, || ());
            assert_is_whole(&divided, &whole, &format!("{name}, {division}"));
            assert_eq!(divided.workers.len(), workers);
            let (work, loads) = (divided.work(), divided.duplication.loads);
            assert_eq!(work.loads, loads, "{name}, {division}");
            // No piece visits a pixel of a box that another one visits.
            let slots = scene.slots();
            let boxes = slots.iter().map(|s| s.words.screen_box().pixels());
            assert_eq!(work.object_pixels, boxes.sum::<u64>(), "{name}, {division}");
        }
        drawn += usize::from(whole.0.covered() > 100);
        lit += usize::from(!scene.volumes.is_empty());
    }
    assert!(drawn > 30, "{drawn} scenes show something");
    assert!(lit >= 2, "{lit} scenes have volumes");
    assert_eq!(kinds.len(), 10, "processors: {kinds:?}");
}

/// A spot whose box is small, in pieces that the box does not touch; and guard bits.
#[test]
fn lights_and_guard_bits_are_the_same_however_the_picture_is_divided() {
    let file = scene_file("../models/testkit/scenes/shadows");
    let framed = file.frame(83, 61).expect("a valid size");
    for (depth, linear, quadratic) in [(24, 0, 0), (16, 3, 5), (20, 10, 7)] {
        let format = Format::new(depth).expect("in the catalogue");
        let format = format.with_guards(linear, quadratic).expect("guard bits");
        let scene = prepare(&framed, format).expect("fits the format");
        let whole = whole(&scene);
        for (division, workers) in DIVISIONS {
            let divided = Divided::draw(&scene, division, workers, || ());
            assert_is_whole(&divided, &whole, &format!("{division}"));
        }
    }
}

/// The balance of loads that are known: lines share a box evenly, zones do not.
#[test]
fn balance_is_the_mean_over_the_most() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/cut-sphere.toml");
    let scene = prepared(&path).expect("fits");
    let alone = Divided::draw(&scene, zones(83, 61), 4, || ());
    assert_eq!(alone.balance(), 0.25);
    assert_eq!(alone.balance_of_queue(), 0.25);
    let lines = Divided::draw(&scene, Division::Lines(2), 2, || ());
    let loads: Vec<u64> = lines.workers.iter().map(|w| w.work.pixels()).collect();
    let mean = loads.iter().sum::<u64>() as f64 / 2.0;
    assert_eq!(
        lines.balance(),
        mean / *loads.iter().max().expect("two") as f64
    );
    assert!(lines.balance() > 0.9);
}
