//! `check` and what `render` makes of it: verdicts, maps, warnings, and the frame of the normals.

use crate::common::Place;

/// Shape and values of an array of words of `bytes` bytes, as NumPy writes it.
fn array(file: &[u8], bytes: usize) -> (String, Vec<i64>) {
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
    let place = Place::new();
    let check = "check scenes/cut-sphere.toml --size 320x240 --format 16 --map";
    let report = place.json(&format!("{check} open.npy"));
    let counted = report["undecided_pixels"].as_u64().expect("a count");
    assert_eq!(report["files"][0], "open.npy");
    let (header, values) = array(&place.bytes("open.npy"), 1);
    let is_bytes = header.contains("(240, 320") && header.contains("u1");
    assert!(is_bytes, "{header}");
    assert_eq!(values.len(), 320 * 240);
    assert!(counted > 0);
    let marked = values.iter().filter(|&&m| m & 1 == 1).count();
    assert_eq!(marked as u64, counted);
    place.run(&format!("{check} open.png")).ended(0);
    let picture = imogene_studies::picture::read_mask(&place.path("open.png"));
    let (width, height, open) = picture.expect("a picture");
    assert_eq!((width, height), (320, 240));
    let mut pixels = open.iter().zip(&values);
    assert!(pixels.all(|(&open, &mark)| open == (mark != 0)));
}

#[test]
fn a_map_of_another_sort_is_refused() {
    let place = Place::new();
    let check = "check scenes/cone.toml --map open.gif";
    place.run(check).refused(&[".png or .npy"]);
    assert!(!place.has("open.gif"));
}

/// The words are too short for this one: the picture is written, with a warning, and both commands fail.
#[test]
fn a_picture_that_is_not_the_scene_is_drawn_with_a_warning() {
    let place = Place::new();
    let leaf = "scenes/extremes/flat-as-a-leaf.toml";
    let check = place.run(&format!("check {leaf}")).ended(1);
    check.says(&["'leaf'", "a pixel or more"]);
    let drawn = place.run(&format!("render {leaf} -o leaf.png")).ended(1);
    drawn.says(&["warning: object 'leaf'"]);
    assert!(place.has("leaf.png"));
    let exact = place.run(&format!("render {leaf} --model exact -o leaf.png"));
    assert_eq!(exact.ended(0).said, "");
}

const SPHERE: &str = r#"
format = 1
title = "sphere"
image = { width = 65, height = 65 }
[camera]
kind = "orthographic"
eye = [0, 0, 10]
target = [0, 0, 0]
view_height = 4
half_depth = 4
[[materials]]
name = "m"
colour = [1, 1, 1]
[[objects]]
name = "s"
kind = "sphere"
radius = 1.5
material = "m"
"#;

/// A sphere in the middle: x to the right, y down, z away, and out of the object.
#[test]
fn normals_are_those_of_the_camera_frame() {
    let place = Place::new();
    place.write("s.toml", SPHERE);
    place.run("render s.toml --normals n.npy").ended(0);
    let (header, values) = array(&place.bytes("n.npy"), 2);
    let is_words = header.contains("(65, 65, 3") && header.contains("i2");
    assert!(is_words, "{header}");
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
        let cosine = along / (24.375 * length);
        assert!(cosine > 0.999_99, "({x}, {y}): {normal:?}");
    }
    assert!(seen > 1500, "{seen}");
    assert_eq!(values[..3], [0, 0, 0]);
}
