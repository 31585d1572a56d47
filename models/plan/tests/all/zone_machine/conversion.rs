//! Objects and volumes of the collection by their own processors and by those of a zone machine.

use super::{MACHINE, polyhedra_with_shadows, scene, with_facets};
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::object::as_quadric::AsQuadricError;
use imogene_golden::object::quadric::ObjectPixel;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::object::volume_line::for_each_inside;
use imogene_prepare::PreparedScene;
use std::collections::BTreeMap;

const SIZE: (u32, u32) = (160, 120);

fn line(words: &ProcessorWords, prepared: &PreparedScene, y: i64) -> Vec<(i64, ObjectPixel)> {
    let mut pixels = vec![];
    words.for_each_present(&prepared.format, y, |x, pixel| pixels.push((x, pixel)));
    pixels
}

/// The pixels of each kind of words that are compared.
fn compare_objects(prepared: &PreparedScene, compared: &mut BTreeMap<&'static str, usize>) {
    for slot in prepared.slots() {
        let ours = slot.words.on_quadric_processor(&prepared.format, 12);
        let kind = match &slot.words {
            ProcessorWords::Quadric(_) => "quadric",
            ProcessorWords::Patch(_) => "patch",
            ProcessorWords::Polyhedron(_) => "polyhedron",
            ProcessorWords::Facet(_) => "facet",
            _ => {
                assert!(matches!(ours, Err(AsQuadricError::Processor(_))));
                continue;
            }
        };
        let ours = ProcessorWords::Quadric(ours.expect("fits the processor"));
        for y in 0..i64::from(prepared.height) {
            let (mut got, mut wanted) = (line(&ours, prepared, y), line(&slot.words, prepared, y));
            *compared.entry(kind).or_default() += wanted.len();
            if kind == "facet" {
                // Its one face is face 2 on its own processor and face 0 of a patch.
                assert!(got.iter().all(|(_, p)| p.number == 0));
                assert!(wanted.iter().all(|(_, p)| p.number == 2));
                for (_, pixel) in got.iter_mut().chain(&mut wanted) {
                    pixel.number = 0;
                }
            }
            assert_eq!(got, wanted, "{kind} of object {}, line {y}", slot.object);
        }
    }
}

#[test]
fn objects_of_the_collection_are_the_same_pixel_for_pixel() {
    let mut compared = BTreeMap::new();
    for name in [
        "curved-facet",
        "first-generation",
        "mesh",
        "paraboloids",
        "patch-processor",
        "polyhedron",
        "tetrahedra",
    ] {
        let path = format!("scenes/processors/{name}.toml");
        compare_objects(&scene(&path, SIZE, with_facets()), &mut compared);
    }
    for name in ["robot", "dna"] {
        let path = format!("scenes/shadows/{name}.toml");
        compare_objects(&scene(&path, SIZE, Format::BASE), &mut compared);
    }
    eprintln!("{compared:?}");
    for kind in ["quadric", "patch", "polyhedron", "facet"] {
        assert!(compared[kind] > 2_000, "{compared:?}");
    }
}

#[test]
fn volumes_of_the_collection_are_the_same_pixel_for_pixel() {
    let (mut of_planes, mut inside) = (0, 0);
    for prepared in [
        polyhedra_with_shadows(SIZE),
        scene("scenes/shadows/robot.toml", SIZE, Format::BASE),
        scene("models/testkit/scenes/shadows.toml", SIZE, Format::BASE),
    ] {
        let (width, height) = (prepared.width as usize, prepared.height as usize);
        let slots = prepared.slots();
        let frame = beam::render(&slots, &prepared.format, width, height, || ());
        for volume in &prepared.volumes {
            let theirs = &volume.words;
            let ours = theirs.on_quadric_processor(MACHINE.volume_planes);
            let ours = ours.expect("fits the processor");
            of_planes += usize::from(theirs.quadric.is_none());
            for (y, depths) in frame.depth.chunks(width).enumerate() {
                let [got, wanted] = [&ours, theirs].map(|words| {
                    let mut columns = vec![];
                    for_each_inside(words, &prepared.format, y as i64, depths, |x| {
                        columns.push(x);
                    });
                    columns
                });
                assert_eq!(got, wanted, "{}, line {y}", volume.name);
                inside += wanted.len();
            }
        }
    }
    assert!(of_planes > 5 && inside > 5_000, "{of_planes} {inside}");
}
