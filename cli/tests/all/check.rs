//! `check` and what `render` makes of it: verdicts, maps, warnings, and the frame of the normals.

use crate::common::{imogene, scene};
use serde_json::Value;
use std::path::Path;

/// Runs the program: exit code, standard output, standard error.
fn run(arguments: &[&str]) -> (Option<i32>, Vec<u8>, String) {
    let output = imogene().args(arguments).output().expect("runs");
    let said = String::from_utf8(output.stderr).expect("text");
    (output.status.code(), output.stdout, said)
}

fn text(path: &Path) -> &str {
    path.to_str().expect("a plain path")
}

/// Shape and values of an array of words of `bytes` bytes, as NumPy writes it.
fn array(path: &Path, bytes: usize) -> (String, Vec<i64>) {
    let file = std::fs::read(path).expect("written");
    assert_eq!(&file[..6], b"\x93NUMPY");
    let start = 10 + usize::from(u16::from_le_bytes([file[8], file[9]]));
    let header = String::from_utf8_lossy(&file[10..start]).into_owned();
    let word = |word: &[u8]| match word {
        [one] => i64::from(*one),
        [low, high] => i64::from(i16::from_le_bytes([*low, *high])),
        _ => unreachable!("words of one or two bytes"),
    };
    (header, file[start..].chunks(bytes).map(word).collect())
}

#[test]
fn a_map_marks_the_pixels_that_are_counted() {
    let folder = tempfile::tempdir().expect("a folder");
    let [picture, marks] = ["open.png", "open.npy"].map(|name| folder.path().join(name));
    let ball = scene("cut-sphere.toml");
    let options = [
        "check",
        text(&ball),
        "--size",
        "320x240",
        "--format",
        "16",
        "--json",
    ];
    let (code, out, _) = run(&[&options[..], &["--map", text(&marks)]].concat());
    assert_eq!(code, Some(0));
    let report: Value = serde_json::from_slice(&out).expect("one document");
    let counted = report["undecided_pixels"].as_u64().expect("a count");
    assert_eq!(report["files"][0], text(&marks));
    let (header, values) = array(&marks, 1);
    assert!(
        header.contains("(240, 320") && header.contains("u1"),
        "{header}"
    );
    assert_eq!(values.len(), 320 * 240);
    assert!(counted > 0);
    assert_eq!(
        values.iter().filter(|&&m| m & 1 == 1).count() as u64,
        counted
    );
    assert_eq!(
        run(&[&options[..], &["--map", text(&picture)]].concat()).0,
        Some(0)
    );
    let (width, height, open) = imogene_studies::picture::read_mask(&picture).expect("a picture");
    assert_eq!((width, height), (320, 240));
    assert!(
        open.iter()
            .zip(&values)
            .all(|(&open, &mark)| open == (mark != 0))
    );
}

#[test]
fn a_map_of_another_sort_is_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let map = folder.path().join("open.gif");
    let (code, _, said) = run(&["check", text(&scene("cone.toml")), "--map", text(&map)]);
    assert_eq!(code, Some(2));
    assert!(said.contains(".png or .npy"), "{said}");
    assert!(!map.exists());
}

/// The words are too short for this one: the picture is written, with a warning, and both commands fail.
#[test]
fn a_picture_that_is_not_the_scene_is_drawn_with_a_warning() {
    let folder = tempfile::tempdir().expect("a folder");
    let picture = folder.path().join("leaf.png");
    let leaf = scene("extremes/flat-as-a-leaf.toml");
    let (code, _, said) = run(&["check", text(&leaf)]);
    assert_eq!(code, Some(1));
    assert!(
        said.contains("'leaf'") && said.contains("a pixel or more"),
        "{said}"
    );
    let (code, _, said) = run(&["render", text(&leaf), "-o", text(&picture)]);
    assert_eq!(code, Some(1));
    assert!(said.contains("warning: object 'leaf'"), "{said}");
    assert!(picture.exists());
    let (code, _, said) = run(&[
        "render",
        text(&leaf),
        "--model",
        "exact",
        "-o",
        text(&picture),
    ]);
    assert_eq!((code, said.as_str()), (Some(0), ""));
}

/// A sphere in the middle: x to the right, y down, z away, and out of the object.
#[test]
fn normals_are_those_of_the_camera_frame() {
    let folder = tempfile::tempdir().expect("a folder");
    let [file, picture, normals] =
        ["s.toml", "s.png", "n.npy"].map(|name| folder.path().join(name));
    let sphere = "format = 1\ntitle = \"sphere\"\nimage = { width = 65, height = 65 }\n[camera]\nkind = \"orthographic\"\n\
        eye = [0, 0, 10]\ntarget = [0, 0, 0]\nview_height = 4\nhalf_depth = 4\n[[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n\
        [[objects]]\nname = \"s\"\nkind = \"sphere\"\nradius = 1.5\nmaterial = \"m\"\n";
    std::fs::write(&file, sphere).expect("written");
    let options = [
        "render",
        text(&file),
        "-o",
        text(&picture),
        "--normals",
        text(&normals),
    ];
    assert_eq!(run(&options).0, Some(0));
    let (header, values) = array(&normals, 2);
    assert!(
        header.contains("(65, 65, 3") && header.contains("i2"),
        "{header}"
    );
    let mut seen = 0;
    for (index, normal) in values.chunks(3).enumerate() {
        // Pixel (i, j) samples i - 32.5, j - 32.5; sixteen and a quarter pixels are a unit, the radius 24.375.
        let [x, y] = [index % 65, index / 65].map(|v| v as f64 - 32.5);
        let square = 24.375f64.powi(2) - x * x - y * y;
        if square <= 1.0 {
            continue;
        }
        seen += 1;
        let outward = [x, y, -square.sqrt()];
        let normal: Vec<f64> = normal.iter().map(|&v| v as f64).collect();
        let length = normal.iter().map(|v| v * v).sum::<f64>().sqrt();
        let along: f64 = outward.iter().zip(&normal).map(|(a, b)| a * b).sum();
        assert!(
            along / (24.375 * length) > 0.999_99,
            "({x}, {y}): {normal:?}"
        );
    }
    assert!(seen > 1500, "{seen}");
    assert_eq!(values[..3], [0, 0, 0]);
}
