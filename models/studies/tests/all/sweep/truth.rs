use imogene_analysis::exact::render::{DEPTH_FRACTION, render, to_frame};
use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_studies::sweep::find;
use imogene_studies::sweep::truth::{DEPTH_BITS, Truth};

/// Another way to depths and normals from the same rays: equal to the exact picture in the digits that it has.
#[test]
fn the_truth_is_the_exact_picture_with_more_digits() {
    let format = Format::BASE;
    let chosen = [("word-length", "24"), ("side-offset", "120"), ("thin", "1")];
    for (name, parameter) in chosen {
        let scenes = find(name).expect("a sweep").scenes(format);
        for (series, _, file) in scenes.into_iter().filter(|s| s.1 == parameter) {
            let scene = file.frame(file.image.width, file.image.height);
            let scene = scene.expect("valid");
            let truth = Truth::new(&scene, format.z_max());
            let exact = render(&scene, &format, || ());
            let frame = to_frame(&exact, &scene, &format);
            for (index, pixel) in exact.iter().enumerate() {
                let (x, y) = (index % frame.width, index / frame.width);
                let found = truth.at(x as i64, y as i64);
                assert_eq!(found.is_some(), pixel.is_some(), "{name}, {series}");
                let (Some(found), Some(pixel)) = (found, pixel) else {
                    continue;
                };
                assert_eq!((found.id, found.number), (pixel.id as usize, pixel.number));
                let apart =
                    (found.depth >> (DEPTH_BITS - DEPTH_FRACTION)) - i128::from(pixel.depth);
                assert!(apart.abs() <= 1, "{name}, {series}, ({x}, {y}): {apart}");
                let length = found.normal.iter().map(|v| v * v).sum::<f64>().sqrt();
                for (component, kept) in found.normal.iter().zip(frame.normal[index]) {
                    let off = component / length * 32767.0 - f64::from(kept);
                    assert!(off.abs() < 0.51, "{name}, {series}, ({x}, {y}): {off}");
                }
            }
        }
    }
}
