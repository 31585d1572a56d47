//! What switches a plane, a side or a processor off changes no pixel, in any kind of processor.

use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::quadric::{QuadricWords, ScreenBox};
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::unused::{Unused, UnusedPlane, every_kind};
use imogene_golden::object::volume::VolumeKind;
use imogene_golden::object::words::Words;
use imogene_golden::unit::depth_interval::Class;
use imogene_prepare::Framing;
use imogene_prepare::{PreparedScene, prepare};
use imogene_testkit::scene_file;
use std::collections::BTreeSet;

const SIZE: (u32, u32) = (64, 48);

fn prepared(name: &str) -> PreparedScene {
    let framed = scene_file(name).frame(SIZE.0, SIZE.1).expect("a size");
    prepare(&framed, Format::BASE).expect("fits the format")
}

fn frame(slots: &[Slot]) -> Frame {
    let size = (SIZE.0 as usize, SIZE.1 as usize);
    beam::render(slots, &Format::BASE, size.0, size.1, || ())
}

fn unused(kind: &str) -> Unused {
    let found = every_kind().into_iter().find(|u| u.processor == kind);
    found.expect("every kind of processor")
}

/// Gives the words one plane or side more, of no use; the name of their processor.
fn add_one(words: &mut ProcessorWords) -> &'static str {
    let name = match words {
        ProcessorWords::Quadric(_) => "quadric",
        ProcessorWords::Patch(_) => "patch",
        ProcessorWords::Polyhedron(_) => "polyhedron",
        ProcessorWords::FirstGeneration(_) => "first_generation",
        ProcessorWords::Facet(_) => "facet",
        ProcessorWords::CurvedFacet(_) => "curved_facet",
        ProcessorWords::Sphere(_) => "sphere",
        ProcessorWords::Cylinder(_) => "cylinder",
        ProcessorWords::Quotient(_) => "quotient",
        ProcessorWords::Member(_) => panic!("no scene of this test has solids"),
    };
    match (words, unused(name).plane) {
        (ProcessorWords::Quadric(w) | ProcessorWords::Patch(w), Some(UnusedPlane::Plane(p))) => {
            w.planes.push(p);
        }
        (ProcessorWords::Polyhedron(w), Some(UnusedPlane::Plane(p))) => w.planes.push(p),
        (ProcessorWords::Quotient(w), Some(UnusedPlane::Plane(p))) => w.planes.push(p),
        (ProcessorWords::Facet(w), Some(UnusedPlane::Side(side))) => w.edges.push(side),
        (ProcessorWords::CurvedFacet(w), Some(UnusedPlane::CurvedSide(q))) => w.sides.push(q),
        (ProcessorWords::FirstGeneration(w), Some(UnusedPlane::Contour(c))) => {
            (w.front, w.back) = (c, c);
        }
        (ProcessorWords::Sphere(_) | ProcessorWords::Cylinder(_), None) => {}
        (words, plane) => panic!("{words:?} with {plane:?}"),
    }
    name
}

/// The same object in an empty box.
fn switched_off(slot: &Slot, nowhere: ScreenBox) -> Slot {
    let mut slot = slot.clone();
    *slot.words.screen_box_mut() = nowhere;
    slot
}

#[test]
fn a_plane_that_cuts_nothing_and_an_absent_object_change_no_pixel() {
    let mut kinds = BTreeSet::new();
    for scene in [
        "teapot.toml",
        "extremes/eye-on-quadric.toml",
        "processors/curved-facet.toml",
        "processors/mesh.toml",
        "processors/paraboloids.toml",
        "processors/patch-processor.toml",
        "processors/polyhedron.toml",
    ] {
        let slots = prepared(scene).slots();
        let wanted = frame(&slots);
        assert!(wanted.covered() > 100, "{scene}");
        let mut others = slots.clone();
        for slot in &slots {
            let mut more = slot.clone();
            let kind = add_one(&mut more.words);
            kinds.insert(kind);
            others.push(switched_off(slot, unused(kind).screen_box));
            others[slots.iter().position(|s| s == slot).expect("it is there")] = more;
        }
        let found = frame(&others);
        assert!(
            found.depth == wanted.depth && found.id == wanted.id,
            "{scene}"
        );
        assert!(found.normal == wanted.normal, "{scene}");
    }
    let all = every_kind().into_iter().map(|unused| unused.processor);
    let apart = ["first_generation", "volume"];
    let all = all.filter(|kind| !apart.contains(kind));
    assert_eq!(kinds, all.collect());
}

#[test]
fn contours_that_cut_nothing_leave_the_whole_quadric() {
    let mut slots = prepared("processors/first-generation.toml").slots();
    slots.retain(|slot| matches!(slot.words, ProcessorWords::FirstGeneration(_)));
    let cut = frame(&slots);
    let mut whole = slots.clone();
    for (slot, quadric) in slots.iter_mut().zip(&mut whole) {
        let ProcessorWords::FirstGeneration(words) = &slot.words else {
            unreachable!("the others are left out")
        };
        let quadric_words = QuadricWords {
            class: match words.patch {
                true => Class::Patch,
                false => Class::Side,
            },
            screen_box: words.screen_box,
            f1: words.f1,
            f2: words.f2,
            normal: words.normal,
            planes: vec![],
        };
        quadric.words = ProcessorWords::Quadric(quadric_words);
        add_one(&mut slot.words);
    }
    let (found, wanted) = (frame(&slots), frame(&whole));
    assert_ne!(cut.depth, wanted.depth, "the planes cut something");
    assert!(found.depth == wanted.depth && found.normal == wanted.normal);
}

#[test]
fn a_volume_without_a_use_takes_no_light_away() {
    let mut scene = prepared("shadows/robot.toml");
    let seen = frame(&scene.slots());
    let wanted = scene.light(&seen, || ());
    assert!(wanted.flags.iter().any(|&flags| flags != u16::MAX));
    let Unused {
        plane: Some(UnusedPlane::Volume(plane)),
        screen_box,
        ..
    } = unused("volume")
    else {
        panic!("volumes have planes")
    };
    let off = scene.volumes.iter().map(|volume| {
        let mut off = volume.clone();
        off.words.kind = VolumeKind::Shadow;
        off.words.screen_box = screen_box;
        off
    });
    let off: Vec<_> = off.collect();
    for volume in &mut scene.volumes {
        volume.words.planes.push(plane);
    }
    scene.volumes.extend(off);
    assert!(scene.light(&seen, || ()).flags == wanted.flags);
}
