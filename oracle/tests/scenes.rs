//! Every scene of the repository: golden picture against traced picture.

mod common;

use imogene_models::check::check;
use imogene_models::format::Format;
use imogene_models::prepare::prepare;
use imogene_models::scene::SceneFile;
use imogene_oracle::compare::Mark;
use imogene_oracle::run::{Outcome, run};

/// The scenes that their own check fails, since their words are too short for them: pixels of their outlines are announced far from the edge.
const WITHOUT_BOUNDS: [&str; 1] = ["flat-as-a-leaf"];

/// The picture of the check is the scene's own size where that is small: the extremes are made for it.
fn size(scene: &SceneFile) -> (u32, u32) {
    let (w, h) = (scene.image.width, scene.image.height);
    if w * h <= 64 * 128 { (w, h) } else { (80, 60) }
}

#[test]
fn every_golden_picture_is_the_traced_one_outside_the_band() {
    let (mut refused, mut compared) = (vec![], 0);
    for file in common::files() {
        let name = file
            .file_stem()
            .expect("a file")
            .to_string_lossy()
            .into_owned();
        let scene = SceneFile::read(&file).expect("valid");
        let (w, h) = size(&scene);
        let outcome = run(&scene, w, h, Format::BASE, &|_| ()).expect("framed");
        let found = match outcome {
            Outcome::Refused(_) => {
                refused.push(name);
                continue;
            }
            Outcome::Compared(found) => found,
        };
        compared += 1;
        let c = &found.comparison;
        assert!(c.holds(), "{name}: {c:#?}");
        let is_without = WITHOUT_BOUNDS.contains(&name.as_str());
        assert_eq!(c.announced > 0, is_without, "{name}: {c:#?}");
        let marked = |mark| found.marks.iter().filter(|m| **m == mark).count();
        assert_eq!(marked(Mark::Inside), c.differences_inside);
        assert_eq!(marked(Mark::Outside), c.differences_outside);
        assert_eq!(marked(Mark::Tied), c.tied);
        assert_eq!(marked(Mark::Announced), c.announced);
        assert!(
            c.covered < 20 || c.depths > 0,
            "{name}: no depth was compared"
        );
        assert!(
            c.differences_inside * 20 <= c.band || is_without || c.band < 20 || c.tied > 0,
            "{name}: {c:#?}"
        );
    }
    assert!(compared >= 60, "{compared}");
    refused.sort();
    let expected = [
        "axis-too-nearly-along-the-ray",
        "behind-the-eye",
        "eye-barely-inside",
        "eye-barely-outside",
        "eye-inside-solid",
    ];
    assert_eq!(refused, expected);
}

#[test]
fn a_scene_that_differs_is_one_whose_check_fails() {
    for file in common::files() {
        let name = file
            .file_stem()
            .expect("a file")
            .to_string_lossy()
            .into_owned();
        if !WITHOUT_BOUNDS.contains(&name.as_str()) {
            continue;
        }
        let scene = SceneFile::read(&file).expect("valid");
        let framed = scene
            .frame(scene.image.width, scene.image.height)
            .expect("framed");
        let prepared = prepare(&framed, Format::BASE).expect("prepared");
        assert!(!check(&framed, &prepared).ok);
    }
}

/// A wrong picture is noticed: one object moved by two pixels, or one word of depth too many.
#[test]
fn wrong_pictures_are_noticed() {
    let file = common::files()
        .into_iter()
        .find(|f| f.ends_with("teapot.toml"))
        .expect("the teapot");
    let scene = SceneFile::read(&file).expect("valid");
    let (w, h) = (80, 60);
    let framed = scene.frame(w, h).expect("framed");
    let prepared = prepare(&framed, Format::BASE).expect("prepared");
    let golden = imogene_models::machine::beam::render(
        &prepared.slots(),
        &Format::BASE,
        w as usize,
        h as usize,
        || (),
    );
    let tracer = imogene_oracle::trace::Tracer::new(&scene, &framed.range, w, h);
    let bounds =
        imogene_oracle::bounds::Bounds::new(&framed, &prepared, tracer.bodies()).expect("bounds");
    let traced = tracer.draw(|| ());
    let against =
        |frame| imogene_oracle::compare::compare(&tracer, &traced, frame, &bounds, &prepared).0;
    assert!(against(&golden).holds());
    let mut moved = golden.clone();
    moved.id.rotate_right(2);
    moved.number.rotate_right(2);
    assert!(against(&moved).differences_outside > 0);
    let mut deeper = golden.clone();
    let most = against(&golden).depth_bound as i64 + 1;
    deeper.depth.iter_mut().for_each(|d| *d += 2 * most);
    let found = against(&deeper);
    assert!(found.depths_beyond_bound > 0 && found.differences_outside == 0);
}
