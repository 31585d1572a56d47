//! Pictures of closed parts have no cracks: the screen-space detector of the source (thesis section IV.2.2), with one crack injected to see that it works.

use imogene_import::faces::{FaceOptions, read};
use imogene_models::format::Format;
use imogene_models::machine::beam;
use imogene_models::machine::frame::Frame;
use imogene_models::prepare::prepare;

/// The frame of a part at 360 x 270, and for every object the face it is of.
fn drawn(name: &str, format: &Format) -> (Frame, Vec<usize>) {
    let path = format!(
        "{}/../scenes/cad/{name}.faces.toml",
        env!("CARGO_MANIFEST_DIR")
    );
    let bytes = std::fs::read(path).unwrap();
    let options = FaceOptions {
        max_deviation: None,
        no_volumes: true,
    };
    let scene = read(&bytes, name, &options).unwrap().scene;
    let faces: Vec<&str> = scene
        .objects
        .iter()
        .map(|object| object.name.split('#').next().unwrap())
        .collect();
    let of = faces
        .iter()
        .map(|face| faces.iter().position(|other| other == face).unwrap())
        .collect();
    let (width, height) = (360, 270);
    let prepared = prepare(&scene.frame(width, height).unwrap(), *format).unwrap();
    let frame = beam::render(
        &prepared.slots(),
        format,
        width as usize,
        height as usize,
        || (),
    );
    (frame, of)
}

/// Pixels between two opposite neighbours that are both nearer by more than `d_min` words and neither of the pixel's own face.
fn cracks(frame: &Frame, face: &[usize], d_min: i64) -> Vec<(usize, usize)> {
    let mut found = vec![];
    let owner = |k: usize| usize::try_from(frame.id[k]).ok().map(|id| face[id]);
    for y in 1..frame.height - 1 {
        for x in 1..frame.width - 1 {
            let at = y * frame.width + x;
            let steps = [1, frame.width - 1, frame.width, frame.width + 1];
            let crack = steps.into_iter().any(|step| {
                [at - step, at + step].into_iter().all(|k| {
                    owner(k).is_some()
                        && owner(k) != owner(at)
                        && frame.depth[k] + d_min < frame.depth[at]
                })
            });
            if crack {
                found.push((x, y));
            }
        }
    }
    found
}

#[test]
fn closed_parts_are_seen_without_cracks() {
    let format = Format::default();
    for name in [
        "flange",
        "bracket",
        "curved-plate",
        "volumes",
        "cross-drilled",
    ] {
        let (mut frame, face) = drawn(name, &format);
        let seen = || {
            frame
                .depth
                .iter()
                .zip(&frame.id)
                .filter(|(_, id)| **id >= 0)
                .map(|(d, _)| *d)
        };
        // A hundredth of the depth of what is seen: every wall of the parts is thicker.
        let d_min = (seen().max().unwrap() - seen().min().unwrap()) / 100;
        assert_eq!(cracks(&frame, &face, d_min), [], "{name}");
        // One pixel out of the middle of a face.
        let whole = |k: usize| {
            [0, 1, 2].iter().all(|c| {
                (0..3).all(|r| {
                    let other = k + c + r * frame.width;
                    frame.id.get(other).is_some_and(|id| *id >= 0)
                })
            })
        };
        let corner = (0..frame.id.len()).find(|k| whole(*k)).unwrap();
        let middle = corner + 1 + frame.width;
        frame.id[middle] = -1;
        frame.depth[middle] = format.z_max();
        assert_eq!(
            cracks(&frame, &face, d_min),
            [(middle % frame.width, middle / frame.width)]
        );
    }
}
