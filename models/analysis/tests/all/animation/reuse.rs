//! Frames prepared from the one before are those prepared from scratch: words, bounds, notes and pictures.

use super::{CAMERA, ball, parsed};
use imogene_analysis::phong;
use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::animator::{Animator, PreparedFrame};
use imogene_prepare::{Options, PreparedScene, Reuse, prepare};
use imogene_scene::animation::Playback;
use imogene_scene::{FramedScene, SceneFile};
use proptest::prelude::*;

const SIZE: (u32, u32) = (48, 36);

fn picture(framed: &FramedScene, prepared: &PreparedScene) -> Vec<u8> {
    let frame = prepared.frame(|| ());
    let lighting = prepared.light(&frame, || ());
    phong::shade(&frame, &lighting, framed, &prepared.format)
}

/// Prepares these frames one after the other, compares each with a preparation of its scene alone, and says how much
/// was taken over.
fn compare(file: &SceneFile, order: &[usize]) -> Vec<Result<Reuse, String>> {
    let mut animator = Animator::new(file, SIZE, Format::BASE, Options::default()).expect("frames");
    let one = |&index: &usize| {
        let scene = animator.playback.scene(index).expect("few steps");
        let alone = scene.frame(SIZE.0, SIZE.1).map_err(|e| e.to_string());
        let alone = alone.and_then(|framed| {
            let prepared = prepare(&framed, Format::BASE).map_err(|e| e.to_string())?;
            Ok((framed, prepared))
        });
        let again = animator.prepare(index, &|| ());
        match (alone, again) {
            (Ok((framed, prepared)), Ok(again)) => {
                assert_same(&framed, &prepared, &again);
                Ok(again.reuse)
            }
            (Err(alone), Err(again)) => {
                assert_eq!(alone, again.source.to_string());
                Err(alone)
            }
            (alone, again) => panic!(
                "alone {:?}, again {:?}",
                alone.map(|_| ()),
                again.map(|_| ()).map_err(|e| e.to_string())
            ),
        }
    };
    order.iter().map(one).collect()
}

/// The same of frames that can all be drawn.
fn drawn(file: &SceneFile, order: &[usize]) -> Vec<Reuse> {
    let reuse = compare(file, order).into_iter();
    reuse.map(|r| r.expect("can be drawn")).collect()
}

fn assert_same(framed: &FramedScene, prepared: &PreparedScene, again: &PreparedFrame) {
    assert_eq!(*framed, again.framed);
    // Everything there is to know: words, exact expressions, bounds, needs, notes, names.
    assert_eq!(format!("{prepared:?}"), format!("{:?}", again.prepared));
    let own = picture(&again.framed, &again.prepared);
    assert_eq!(picture(framed, prepared), own);
}

const LAMPS: &str = r#"
[[lights]]
name = "sun"
kind = "directional"
from = [-2, 6, 5]
shadows = true
[[lights]]
name = "lamp"
kind = "spot"
position = [4, 9, 6]
towards = [-4, -9, -6]
half_angle = 25
shadows = true
"#;

const SIDE: &str = "[[cameras]]\nname = \"side\"\nkind = \"orthographic\"\neye = [9, 3, 4]\ntarget = [0, 0, 0]\n\
                    view_height = 6\nhalf_depth = 9\n";

const BODIES: &str = r#"
[[groups]]
name = "pair"
[[groups]]
name = "inner"
group = "pair"
[[objects]]
name = "floor"
kind = "elliptic_cylinder"
radii = [6, 6]
material = "plain"
casts_shadow = false
place = [{ translate = [0, -1.5, 0] }]
cuts = [{ point = [0, 0, 0], normal = [0, 1, 0] }, { point = [0, -0.3, 0], normal = [0, -1, 0] }]
[[objects]]
name = "cup"
group = "pair"
kind = "elliptic_paraboloid"
radii = [0.5, 0.6, 0.5]
mode = "patch"
material = "plain"
place = [{ translate = [-1.5, 0, 0] }]
cuts = [{ point = [0, 1, 0], normal = [0, 1, 0] }]
[[objects]]
name = "egg"
group = "inner"
kind = "ellipsoid"
radii = [0.5, 0.8, 0.6]
material = "plain"
place = [{ translate = [1.5, 0, 1] }]
cuts = [{ point = [0, 0.5, 0], normal = [0, 1, 0] }]
[[objects]]
name = "die"
kind = "polyhedron"
material = "plain"
place = [{ scale = 0.4 }, { translate = [0, 1.2, -1] }]
cuts = [
  { point = [1, 0, 0], normal = [1, 0, 0] }, { point = [-1, 0, 0], normal = [-1, 0, 0] }, { point = [0, 1, 0], normal = [0, 1, 0] },
  { point = [0, -1, 0], normal = [0, -1, 0] }, { point = [0, 0, 1], normal = [0, 0, 1] }, { point = [0, 0, -1], normal = [0, 0, -1] },
]
"#;

fn bodies(images: &str) -> SceneFile {
    let top = CAMERA.to_owned() + SIDE + LAMPS;
    let ball = ball("place = [{ scale = 0.4 }]");
    parsed(&top, &(BODIES.to_owned() + &ball + images))
}

#[test]
fn only_what_moves_is_prepared() {
    // The ball is within the room that the floor takes, so that the other shadows stay.
    let images = "[[images]]\nname = \"slide\"\nsteps = 3\nactions = [{ target = \"ball\", translate = [0.3, -0.3, 0.3] }]\n";
    let file = bodies(images);
    let reuse = drawn(&file, &[0, 1, 2]);
    assert_eq!((reuse[0].objects_prepared, reuse[0].objects_reused), (5, 0));
    for later in &reuse[1..] {
        assert_eq!((later.objects_prepared, later.objects_reused), (1, 4));
        // The cone of the spot, and the shadow of the ball from both sources.
        assert_eq!(later.volumes_prepared, 3);
        let all = reuse[0].volumes_prepared;
        assert_eq!(later.volumes_reused, all - 3);
        assert!(later.volumes_reused >= 6);
    }
}

/// Two halves meet in a plane; as one of them slides along it, the box in which the plane counts changes, and with it
/// the words of the half that stays.
#[test]
fn what_shares_a_plane_with_what_moves_is_prepared() {
    let half = |name: &str, x: f64| {
        format!(
            "[[objects]]\nname = \"{name}\"\nkind = \"ellipsoid\"\nradii = [1.5, 1, 1]\nmaterial = \"plain\"\n\
             cuts = [{{ point = [0, 0, 0], normal = [{x}, 0, {:?}] }}]\n",
            0.3 * x
        )
    };
    let objects = half("west", 1.0) + &half("east", -1.0);
    let images = "[[images]]\nname = \"slide\"\nsteps = 2\nactions = [{ target = \"east\", translate = [0, 0.8, 0] }]\n";
    let file = parsed(CAMERA, &(objects + images));
    let reuse = compare(&file, &[0, 1]);
    let second = reuse[1].as_ref().expect("a frame");
    assert_eq!((second.objects_prepared, second.objects_reused), (2, 0));
}

#[test]
fn a_dimmed_light_or_a_still_frame_prepares_no_object() {
    let file = bodies(
        "[[images]]\nname = \"still\"\nsteps = 2\n\
         [[images]]\nname = \"dim\"\nactions = [{ light = \"sun\", intensity = 0.2 }]\n\
         [[images]]\nname = \"aside\"\nactions = [{ target = \"sun\", rotate = { axis = \"y\", degrees = 10 } }]\n\
         [[images]]\nname = \"look\"\nactions = [{ active_camera = \"side\" }]\n",
    );
    let reuse = drawn(&file, &[0, 1, 2, 3, 4, 0]);
    let of = |r: &Reuse| (r.objects_prepared, r.volumes_prepared);
    // The cone of the spot is computed in every frame.
    assert_eq!([of(&reuse[1]), of(&reuse[2])], [(0, 1); 2]);
    assert_eq!(reuse[3].objects_prepared, 0);
    assert!(reuse[3].volumes_prepared > 1 && reuse[3].volumes_reused > 1);
    // Another camera changes everything.
    assert_eq!((reuse[4].objects_reused, reuse[4].volumes_reused), (0, 0));
    assert_eq!((reuse[5].objects_reused, reuse[5].volumes_reused), (0, 0));
}

fn number(range: std::ops::Range<i32>) -> impl Strategy<Value = String> {
    range.prop_map(|tenths| format!("{:.1}", f64::from(tenths) / 10.0))
}

fn action() -> impl Strategy<Value = String> {
    let target = prop::sample::select(vec![
        "ball", "cup", "egg", "die", "pair", "inner", "floor", "sun", "lamp", "eye",
    ]);
    let seen = prop::sample::select(vec![
        "ball", "cup", "egg", "die", "pair", "inner", "sun", "lamp",
    ]);
    let offset = [number(-8..9), number(-8..9), number(-8..9)];
    let axis = prop::sample::select(vec!["\"x\"", "\"y\"", "\"z\"", "[1, 2, 0]"]);
    let frame = prop::sample::select(vec!["own", "parent"]);
    prop_oneof![
        6 => (target.clone(), offset, frame.clone()).prop_map(|(t, [x, y, z], f)| {
            format!("{{ target = \"{t}\", translate = [{x}, {y}, {z}], frame = \"{f}\" }}")
        }),
        4 => (target.clone(), axis, -60..60, frame.clone()).prop_map(|(t, axis, degrees, f)| {
            format!("{{ target = \"{t}\", rotate = {{ axis = {axis}, degrees = {degrees} }}, frame = \"{f}\" }}")
        }),
        2 => (target, number(7..14), frame).prop_map(|(t, factor, f)| {
            format!("{{ target = \"{t}\", scale = {factor}, frame = \"{f}\" }}")
        }),
        3 => (seen, any::<bool>()).prop_map(|(t, show)| format!("{{ target = \"{t}\", show = {show} }}")),
        1 => number(0..20).prop_map(|i| format!("{{ light = \"lamp\", intensity = {i} }}")),
        1 => (20..90).prop_map(|focal| format!("{{ camera = \"eye\", focal = {focal} }}")),
        1 => prop::sample::select(vec!["eye", "side"])
            .prop_map(|name| format!("{{ active_camera = \"{name}\" }}")),
    ]
}

/// Three images of one or two frames, each from the scene as written or from an image before it.
fn images() -> impl Strategy<Value = String> {
    let image = (prop::collection::vec(action(), 0..3), 1..3, 0..4usize);
    prop::collection::vec(image, 3).prop_map(|images| {
        let one = |(index, (actions, steps, parent)): (usize, (Vec<String>, i32, usize))| {
            let parent = match parent {
                0 => String::new(),
                _ if index == 0 => String::new(),
                p => format!("parent = \"image {}\"\n", (index - 1).min(p - 1)),
            };
            format!(
                "[[images]]\nname = \"image {index}\"\nsteps = {steps}\n{parent}actions = [{}]\n",
                actions.join(", ")
            )
        };
        images.into_iter().enumerate().map(one).collect()
    })
}

#[test]
fn random_animations_are_those_prepared_from_scratch() {
    let mut runner = proptest::test_runner::TestRunner::new(ProptestConfig {
        cases: 32,
        failure_persistence: None,
        ..ProptestConfig::default()
    });
    let totals = std::cell::RefCell::new((Reuse::default(), 0));
    let outcome = runner.run(&images(), |images| {
        let file = bodies(&images);
        let count = Playback::new(&file).unwrap().count();
        // There and back: any order is possible.
        let order: Vec<usize> = (0..count).chain((0..count).rev()).collect();
        for reuse in compare(&file, &order).into_iter().flatten() {
            let (sum, frames) = &mut *totals.borrow_mut();
            sum.objects_prepared += reuse.objects_prepared;
            sum.objects_reused += reuse.objects_reused;
            sum.volumes_prepared += reuse.volumes_prepared;
            sum.volumes_reused += reuse.volumes_reused;
            *frames += 1;
        }
        Ok(())
    });
    outcome.expect("the same from scratch");
    let (sum, frames) = totals.into_inner();
    // The cases are not empty: most frames can be drawn, and much of them is taken over.
    assert!(frames > 32, "{frames} frames");
    assert!(sum.objects_reused > sum.objects_prepared / 4, "{sum:?}");
    assert!(sum.volumes_reused > 32, "{sum:?}");
}
