//! Interlaced pictures of whole scenes: fields of words for every other line, interleaved, are the progressive picture
//! bit for bit.

use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_golden::object::slot::{ProcessorWords, Slot};
use imogene_golden::object::words::Words;
use imogene_golden::unit::lattice::Lattice;
use imogene_prepare::Framing;
use imogene_prepare::{PreparedScene, prepare};
use imogene_scene::{FramedScene, SceneFile};
use imogene_testkit::scenes_in;
use std::path::Path;

/// The processors for the lines `first, first + step, ..` alone; `None` if one of them has no words for fields.
fn slots_of_field(prepared: &PreparedScene, step: i64, first: i64) -> Option<Vec<Slot>> {
    let field = |slot: Slot| {
        let words = match &slot.words {
            ProcessorWords::Quadric(words) => {
                ProcessorWords::Quadric(words.on(&Lattice::lines(step, first)))
            }
            ProcessorWords::Patch(words) => {
                ProcessorWords::Patch(words.on(&Lattice::lines(step, first)))
            }
            _ => return None,
        };
        Some(Slot { words, ..slot })
    };
    prepared.slots().into_iter().map(field).collect()
}

fn line<T: Clone>(values: &[T], width: usize, y: usize) -> Vec<T> {
    values[y * width..(y + 1) * width].to_vec()
}

/// Each line of each field against the line of the whole picture.
fn assert_interleaved(prepared: &PreparedScene, whole: &Frame, step: usize, name: &str) {
    let (width, height) = (whole.width, whole.height);
    for first in 0..step {
        let slots = slots_of_field(prepared, step as i64, first as i64).expect("quadrics");
        let lines = (height - first).div_ceil(step);
        let field = beam::render(&slots, &prepared.format, width, lines, || ());
        for y in 0..lines {
            let of = |frame: &Frame, y: usize| {
                let faces =
                    line(&frame.id, width, y)
                        .into_iter()
                        .zip(line(&frame.number, width, y));
                let normals = line(&frame.normal, width, y);
                (
                    line(&frame.depth, width, y),
                    faces.collect::<Vec<_>>(),
                    normals,
                )
            };
            assert!(
                of(&field, y) == of(whole, y * step + first),
                "{name}: line {y} of field {first} of {step}"
            );
        }
    }
}

fn framed(path: &Path, (width, height): (u32, u32)) -> FramedScene {
    let file = SceneFile::read(path).expect("a valid scene");
    file.frame(width, height).expect("a valid size")
}

/// The names of the scenes of a folder that were drawn in fields of 2 and of 3, and whose picture is not empty.
fn interlaced(folder: &str, size: (u32, u32), formats: &[Format]) -> Vec<String> {
    let mut drawn = vec![];
    for path in scenes_in(folder) {
        let scene = framed(&path, size);
        let name = path.file_stem().expect("a name").to_string_lossy();
        for format in formats {
            // Some scenes of the extremes are there to be refused.
            let Ok(prepared) = prepare(&scene, *format) else {
                continue;
            };
            if slots_of_field(&prepared, 1, 0).is_none() {
                continue;
            }
            let whole = prepared.frame(|| ());
            for step in [2, 3] {
                assert_interleaved(&prepared, &whole, step, &name);
            }
            if whole.covered() > 0 && !drawn.contains(&name.to_string()) {
                drawn.push(name.to_string());
            }
        }
    }
    drawn
}

/// Every scene of quadrics and patches, of an even and an odd number of lines, without and with guard bits.
#[test]
fn fields_of_every_scene_interleave() {
    let guarded = Format::BASE.with_guards(3, 4).expect("a format");
    let sixteen = Format::new(16).expect("a format");
    let widest = Format::new(32).expect("a format");
    let formats = [sixteen, Format::BASE, guarded, widest];
    let plain = interlaced("", (160, 120), &formats);
    assert!(
        plain.len() == scenes_in("").len() && plain.len() >= 15,
        "{plain:?}"
    );
    assert!(plain.contains(&"teapot".into()) && plain.contains(&"molecule".into()));
    let odd = interlaced("", (90, 67), &[Format::BASE]);
    assert_eq!(plain, odd);
    let processors = interlaced("processors", (160, 121), &formats);
    assert_eq!(processors, ["patch-processor", "tetrahedra"]);
    let extremes = interlaced("extremes", (80, 61), &[Format::BASE]);
    assert!(extremes.len() >= 25, "{extremes:?}");
}
