//! Scenes as people write them: at random, and on the way through a surface.

use crate::common::{PERSPECTIVE, read, scene};
use imogene_golden::format::Format;
use imogene_oracle::ordinary::scene_text;
use imogene_oracle::run::{Compared, Outcome, run};
use imogene_oracle::survey::survey;
use imogene_scene::{Camera, SceneFile};

fn is_long() -> bool {
    std::env::var_os("IMOGENE_FULL").is_some()
}

#[test]
fn every_scene_is_read_and_no_two_are_the_same() {
    let texts: Vec<String> = (0..200).map(|number| scene_text(1, number)).collect();
    for text in &texts {
        SceneFile::parse(text, "random").expect("an ordinary scene");
    }
    assert_eq!(texts[7], scene_text(1, 7));
    assert_ne!(texts[7], texts[8]);
    assert_ne!(texts[7], scene_text(2, 7));
    for kind in "hyperbolic_cylinder quadric polyhedron cone \"g2\"".split(' ') {
        assert!(texts.iter().any(|text| text.contains(kind)), "{kind}");
    }
}

/// Of ordinary scenes at most two in a hundred are refused, none fails its check, and no picture differs from the
/// traced one where nothing was announced.
#[test]
fn ordinary_scenes_draw() {
    let scenes = if is_long() { 1000 } else { 100 };
    for seed in [1, 2] {
        let found = survey(seed, scenes, Format::BASE, || ());
        assert!(found.pixels > 2000 * scenes as usize);
        assert!(found.differing.is_empty(), "{:?}", found.differing);
        assert!(found.transparent > 100 * scenes as usize);
        assert!(found.colours * 100 > 99 * found.pixels);
        // Nothing is really open in any of them.
        assert!(found.check_fails.is_empty(), "{:?}", found.check_fails);
        let refused = found.refused.len() as u64;
        assert!(refused * 50 <= scenes, "{:?}", found.refused);
    }
}

const SPHERE: &str = "kind = \"sphere\"\nradius = 1";
const CONE: &str = "kind = \"cone\"\nradii = [1, 1.5, 1]\n\
    cuts = [{ point = [0, 0, 0], normal = [0, 1, 0] }, { point = [0, -1.2, 0], normal = [0, -1, 0] }]";

/// The pictures of a scene that is not refused, which differ nowhere where they must not.
fn drawn(scene: &SceneFile, name: &str) -> Box<Compared> {
    match run(scene, 64, 48, Format::BASE, &|_| ()).expect("framed") {
        Outcome::Refused(reason) => panic!("{name}: {reason}"),
        Outcome::Compared(found) => {
            let c = &found.comparison;
            assert!(c.holds(), "{name}: {c:#?}");
            found
        }
    }
}

/// The eye at a step of a straight flight, looking ahead.
fn flown(scene: &SceneFile, from: [f64; 3], to: [f64; 3], part: f64) -> SceneFile {
    let mut scene = scene.clone();
    let Camera { eye, target, .. } = &mut scene.camera;
    let round = |value: f64| (value * 1e6).round() / 1e6;
    *eye = [0, 1, 2].map(|k| round(from[k] + part * (to[k] - from[k])));
    *target = [0, 1, 2].map(|k| round(eye[k] + to[k] - from[k]));
    scene
}

/// From outside through the surface to the inside: every frame is drawn, each shows something as long as anything is
/// ahead, and none differs from the traced picture where that was not announced.
#[test]
fn a_flight_through_a_surface_is_drawn_from_beginning_to_end() {
    let of = |object: &str| scene(PERSPECTIVE, &[object]);
    let wall = format!("{SPHERE}\nmode = \"patch\"");
    let eye = [2.63, 4.31, 11.17];
    let flights = [
        ("ball", of(SPHERE), [0.3, 0.2, 4.0], [0.1, 0.0, 0.2]),
        ("wall", of(&wall), [0.3, 0.2, 4.0], [0.1, 0.0, 0.2]),
        ("cone", of(CONE), [0.5, 1.0, 4.0], [0.1, -0.9, 0.1]),
        ("teapot", read("teapot"), eye, [0.1, 0.3, 0.1]),
    ];
    let steps = if is_long() { 200 } else { 20 };
    for (name, scene, from, to) in flights {
        for step in 0..=steps {
            let part = f64::from(step) / f64::from(steps);
            let frame = flown(&scene, from, to, part);
            let place = format!("{name}, step {step}");
            let found = drawn(&frame, &place);
            assert!(found.comparison.covered > 0, "{place}: nothing is seen");
            assert!(found.golden.covered() > 0, "{place}: nothing is drawn");
        }
    }
}

/// The distances of the eye from the middle of a ball of radius 1 at which it was once drawn, refused, and drawn again.
#[test]
fn the_eye_may_be_as_near_to_a_surface_as_it_likes() {
    for distance in [
        1.5, 1.3, 1.01, 1.0001, 1.0000001, 1.00000001, 1.0, 0.9999999, 0.999, 0.5,
    ] {
        for mode in ["solid", "patch"] {
            let camera = format!(
                "kind = \"perspective\"\neye = [0, 0, {distance:?}]\ntarget = [0, 0, 0]\nviewer_distance = {distance:?}\nview_height = 1\n"
            );
            let ball = format!("{SPHERE}\nmode = \"{mode}\"");
            let scene = scene(&camera, &[&ball]);
            let found = drawn(&scene, &format!("{mode} at {distance}"));
            assert_eq!(found.golden.covered(), 64 * 48, "{mode} at {distance}");
        }
    }
}

/// The picture does not depend on where the window stands: a smaller window nearer by shows the same.
#[test]
fn the_window_may_stand_anywhere() {
    let objects = ["kind = \"sphere\"\nradius = 1.5", CONE];
    let picture = |factor: f64| {
        let camera = format!(
            "kind = \"perspective\"\neye = [1, 2, 10]\ntarget = [0, 0, 0]\nviewer_distance = {:?}\nview_height = {:?}\n",
            8.0 * factor,
            4.0 * factor
        );
        let scene = scene(&camera, &objects);
        let found = drawn(&scene, &factor.to_string());
        (found.golden.id, found.golden.number)
    };
    let whole = picture(1.0);
    for factor in [0.001, 0.125, 0.5, 2.0, 1000.0] {
        assert_eq!(picture(factor), whole, "{factor}");
    }
}
