//! Transparent objects: the golden picture against blends in real numbers by exact depths, and what is refused.

use imogene_analysis::bounds::check;
use imogene_analysis::exact::render::{render, to_frame};
use imogene_analysis::phong;
use imogene_golden::format::Format;
use imogene_golden::machine::lighting::Lighting;
use imogene_golden::machine::shader::shade_picture;
use imogene_prepare::shader::{material_numbers, shader_words};
use imogene_prepare::{Framing, prepare};
use imogene_scene::{SceneFile, Step};
use imogene_testkit::scene_file;

const F: Format = Format::BASE;
const SIZE: (u32, u32) = (160, 120);

fn still_life() -> SceneFile {
    scene_file("glass/still-life")
}

/// Red, green and blue by the golden models of processors, shading and blends, and by the exact reference.
fn pictures(file: &SceneFile) -> [Vec<u8>; 2] {
    let scene = file.frame(SIZE.0, SIZE.1).expect("valid size");
    let prepared = prepare(&scene, F).expect("prepared");
    let frame = prepared.frame(|| ());
    let words = shader_words(&scene, &F).expect("words");
    let (lighting, materials) = (Lighting::full(&frame), material_numbers(&scene));
    let golden = shade_picture(&frame, &lighting, &materials, &words);
    let exact = to_frame(&render(&scene, &F, || ()), &scene, &F);
    let truth = phong::shade(&exact, &Lighting::full(&exact), &scene, &F);
    [golden, truth]
}

/// Pixels of which a component differs by more than some levels.
fn differing(one: &[u8], other: &[u8], levels: u8) -> usize {
    let pixels = one.chunks_exact(3).zip(other.chunks_exact(3));
    let differs = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > levels);
    pixels.filter(differs).count()
}

#[test]
fn the_blends_are_those_of_real_numbers() {
    let mut file = still_life();
    let [golden, truth] = pictures(&file);
    // Words of shading and of three blends; beyond that, outlines.
    let off = differing(&golden, &truth, 6);
    assert!(off <= 12, "{off}");
    // Opaque, the same objects make another picture.
    for material in &mut file.materials {
        material.opacity = 1.0;
    }
    let [opaque, _] = pictures(&file);
    assert!(differing(&golden, &opaque, 20) > 1000);
}

#[test]
fn layers_are_blended_farthest_first() {
    let mut file = still_life();
    for _ in 0..2 {
        let scene = file.frame(SIZE.0, SIZE.1).expect("valid size");
        let prepared = prepare(&scene, F).expect("prepared");
        let frame = prepared.frame(|| ());
        assert_eq!(frame.layers.len(), 3);
        let mut overlaps = 0;
        for (place, near) in frame.layers.iter().enumerate() {
            for far in &frame.layers[..place] {
                let depths = far.depth.iter().zip(&near.depth);
                let both = depths.filter(|(a, b)| **a < F.z_max() && **b < F.z_max());
                both.for_each(|(a, b)| {
                    assert!(a >= b);
                    overlaps += 1;
                });
            }
        }
        assert!(overlaps > 100);
        // In whatever order the file has them.
        file.objects.reverse();
    }
}

/// Glass hides nothing from the check, is shown itself, and where its outline is open the picture is.
#[test]
fn the_check_sees_through_glass() {
    let open = |change: &dyn Fn(&mut SceneFile)| {
        let mut file = still_life();
        change(&mut file);
        let scene = file.frame(SIZE.0, SIZE.1).expect("valid size");
        let prepared = prepare(&scene, Format::new(10).expect("a format")).expect("prepared");
        let report = check(&scene, &prepared);
        let summary = report.summary;
        assert!(summary.never_shown.is_empty(), "{summary:?}");
        report.open
    };
    let all = open(&|_| ());
    let behind = open(&|file| file.objects.truncate(3));
    let glass = open(&|file| drop(file.objects.drain(..3)));
    let count = |open: &[bool]| open.iter().filter(|open| **open).count();
    let own = [&behind, &glass].map(|open| count(open));
    assert!(own.iter().all(|&open| open > 100), "{own:?}");
    // What is open behind the glass is open, whether the glass is there or not.
    assert!(behind.iter().zip(&all).all(|(behind, all)| !behind || *all));
    // Of the glass some pixels may be hidden, of which nothing depends.
    assert!(count(&all) > count(&behind) + count(&glass) / 2);
}

#[test]
fn what_cannot_be_blended_is_refused_by_name() {
    let refusal = |change: &dyn Fn(&mut SceneFile)| {
        let mut file = still_life();
        change(&mut file);
        let scene = file.frame(SIZE.0, SIZE.1).expect("valid size");
        prepare(&scene, F).expect_err("refused").to_string()
    };
    let crossing = refusal(&|file| {
        let mut other = file.objects[4].clone();
        other.name = "crossing".into();
        other.place.push(Step::Translate([0.3, 0.0, 0.0]));
        file.objects.push(other);
    });
    assert!(
        crossing.contains("'sphere'") && crossing.contains("'crossing'"),
        "{crossing}"
    );
    let many = refusal(&|file| {
        for number in 0..6 {
            let mut other = file.objects[4].clone();
            other.name = format!("sphere {number}");
            file.objects.push(other);
        }
    });
    assert!(many.contains("9 transparent objects; at most 8"), "{many}");
    let shadows = refusal(&|file| file.lights[0].shadows = true);
    assert!(
        shadows.contains("lights[0]") && shadows.contains("`shadows = false`"),
        "{shadows}"
    );
}
