//! `--view`, `--rotate`, `--fit`, `--samples` of `render` and `import`, and pictures sampled elsewhere in their pixels.

use crate::common::{Place, repository, run};
use imogene_studies::picture::read_png;
use std::path::{Path, PathBuf};

fn scene(name: &str) -> PathBuf {
    repository("scenes").join(name)
}

/// The indices of a picture's objects.
fn ids(scene: &Path, (width, height): (usize, usize), options: &str) -> Vec<i32> {
    let place = Place::new();
    let scene = scene.display();
    let line = format!("render {scene} --ids i.npy --size {width}x{height} -o p.png {options}");
    place.run(&line).ended(0);
    let bytes = place.bytes("i.npy");
    let words = bytes[bytes.len() - 4 * width * height..].chunks_exact(4);
    let word = |w: &[u8]| i32::from_le_bytes(w.try_into().unwrap());
    words.map(word).collect()
}

/// The colours of a picture, red, green and blue.
fn colours(scene: &Path, size: &str, options: &str) -> Vec<u8> {
    let place = Place::new();
    let scene = scene.display();
    let line = format!("render {scene} --size {size} -o p.png {options}");
    place.run(&line).ended(0);
    read_png(&place.path("p.png")).unwrap().1
}

/// A scene with a line more in its camera.
fn with_key(file: &Path, line: &str, folder: &Path) -> PathBuf {
    let text = std::fs::read_to_string(file).unwrap();
    let changed = text.replacen("[camera]\n", &format!("[camera]\n{line}\n"), 1);
    assert_ne!(text, changed);
    let path = folder.join("changed.toml");
    std::fs::write(&path, changed).unwrap();
    path
}

const SIZE: (usize, usize) = (240, 180);

/// Most of the picture's width and height that is covered; nothing may touch its border.
fn filled(ids: &[i32], what: &str) -> f64 {
    let (width, height) = SIZE;
    let seen = (0..ids.len()).filter(|k| ids[*k] >= 0);
    let seen: Vec<[usize; 2]> = seen.map(|k| [k % width, k / width]).collect();
    let [columns, lines] = [0, 1].map(|axis| {
        let places = seen.iter().map(|place| place[axis]);
        (places.clone().min().unwrap(), places.max().unwrap())
    });
    let is_whole = |(low, high): (usize, usize), size: usize| low > 0 && high + 1 < size;
    assert!(is_whole(columns, width), "{what}: {columns:?}");
    assert!(is_whole(lines, height), "{what}: {lines:?}");
    let share = |(low, high): (usize, usize), size: usize| (high - low + 1) as f64 / size as f64;
    share(columns, width).max(share(lines, height))
}

#[test]
fn a_fitted_scene_fills_the_picture_and_is_whole() {
    let folder = tempfile::tempdir().unwrap();
    let names = "teapot orthographic molecule processors/mesh processors/polyhedron processors/tetrahedra animation/arm";
    let names = names.split(' ').map(|name| format!("{name}.toml"));
    let mut scenes: Vec<PathBuf> = names.map(|name| scene(&name)).collect();
    let parts = "parts/flange.step parts/cross-drilled.step scenes/molecules/helix.pdb";
    for part in parts.split(' ') {
        let name = Path::new(part).with_extension("toml");
        let written = folder.path().join(name.file_name().unwrap());
        run(&format!("import {part} -o {}", written.display())).ended(0);
        // Importers fit their pictures to what they write.
        let filled = filled(&ids(&written, SIZE, ""), part);
        assert!((0.9..=1.0).contains(&filled), "{part}: {filled}");
        scenes.push(written);
    }
    for file in &scenes {
        for view in ["", "--view iso", "--view back --rotate 20,-35,10"] {
            let options = format!("--fit {view}");
            let what = format!("{} {options}", file.display());
            let filled = filled(&ids(file, SIZE, &options), &what);
            assert!((0.9..=1.0).contains(&filled), "{what}: {filled}");
        }
    }
}

#[test]
fn import_writes_the_camera_it_is_asked_for() {
    let place = Place::new();
    let part = repository("parts/flange.step");
    let import = |options: &str| {
        let line = format!("import {} -o a.toml {options}", part.display());
        place.run(&line).ended(0);
        let scene: toml::Table = toml::from_str(&place.text("a.toml")).unwrap();
        ["eye", "target", "up"].map(|key| -> Vec<f64> {
            let number = |v: &toml::Value| v.clone().try_into::<f64>();
            let numbers = scene["camera"][key].as_array().unwrap().iter();
            numbers.map(|v| number(v).unwrap()).collect()
        })
    };
    let [eye, target, _] = import("");
    let squares = eye.iter().zip(&target).map(|(e, t)| (e - t).powi(2));
    let distance = squares.sum::<f64>().sqrt();
    let [eye, same, up] = import("--view front");
    // A part has z up: its front is seen from -y.
    assert_eq!((&same, up), (&target, vec![0.0, 0.0, 1.0]));
    assert_eq!([eye[0], eye[2]], [target[0], target[2]]);
    assert!((eye[1] - (target[1] - distance)).abs() < 1e-9 * distance);
}

#[test]
fn samples_are_the_mean_of_shifted_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let quarters = vec![-0.375, -0.125, 0.125, 0.375];
    for (name, count, places) in [
        ("teapot.toml", "4", vec![-0.25, 0.25]),
        ("orthographic.toml", "16", quarters),
    ] {
        let file = scene(name);
        let mut sums = vec![0u32; 3 * 64 * 48];
        for y in &places {
            for x in &places {
                let shifted = with_key(&file, &format!("sample_at = [{x}, {y}]"), folder.path());
                for (sum, value) in sums.iter_mut().zip(colours(&shifted, "64x48", "")) {
                    *sum += u32::from(value);
                }
            }
        }
        let passes = (places.len() * places.len()) as u32;
        let mean = sums.iter().map(|s| ((s + passes / 2) / passes) as u8);
        let mean: Vec<u8> = mean.collect();
        let plain = colours(&file, "64x48", "");
        let drawn = colours(&file, "64x48", &format!("--samples {count}"));
        assert!(drawn == mean, "{name}");
        assert_ne!(drawn, plain);
        let sampled = ids(&file, (64, 48), &format!("--samples {count}"));
        assert_eq!(sampled, ids(&file, (64, 48), ""));
    }
}

/// What a picture that is sampled at half pixels shows is at the odd pixels of one twice as large.
#[test]
fn half_pixels_are_the_odd_pixels_of_the_double_size() {
    let folder = tempfile::tempdir().unwrap();
    let (width, height, small, large) = (40, 30, "40x30", "80x60");
    // A wide angle, under which half a pixel turns the line of sight by degrees.
    let wide = folder.path().join("wide.toml");
    let text = std::fs::read_to_string(scene("cut-sphere.toml")).unwrap();
    let lines = text.lines().map(|line| match line.split(' ').next() {
        Some("viewer_distance") => "field_of_view = 140",
        Some("view_height") => "",
        _ => line,
    });
    let text = lines.collect::<Vec<_>>().join("\n");
    assert!(text.contains("field_of_view"));
    std::fs::write(&wide, text).unwrap();
    for file in [scene("teapot.toml"), scene("orthographic.toml"), wide] {
        let half = with_key(&file, "sample_at = [0.5, 0.5]", folder.path());
        let exact = "--model exact";
        let odd = |k: usize| (2 * (k / width) + 1) * 2 * width + 2 * (k % width) + 1;
        let found = ids(&half, (width, height), exact);
        let double = ids(&file, (2 * width, 2 * height), exact);
        let expected: Vec<i32> = (0..found.len()).map(|k| double[odd(k)]).collect();
        assert!(found == expected, "{}", file.display());
        assert_ne!(found, ids(&file, (width, height), exact));
        // The words of depth and normal are rounded for another size of pixel; light is the same.
        let (found, double) = (colours(&half, small, exact), colours(&file, large, exact));
        for (k, found) in found.chunks_exact(3).enumerate() {
            for (a, b) in found.iter().zip(&double[3 * odd(k)..]) {
                let name = file.display();
                assert!(a.abs_diff(*b) <= 1, "{name}, pixel {k}: {a} {b}");
            }
        }
        run(&format!("raytrace {} --size {small}", half.display())).ended(0);
    }
}
