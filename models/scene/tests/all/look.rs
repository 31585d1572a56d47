//! Another look at a scene, against places computed by hand.

use imogene_scene::{Camera, Lens, Look, SceneFile, Side};

fn scene(up: &str, objects: &str) -> SceneFile {
    // The eye is 13 from the target.
    let text = format!(
        "format = 1\ntitle = \"t\"\n[camera]\nkind = \"perspective\"\neye = [4, 6, 15]\ntarget = [1, 2, 3]\nup = {up}\n\
         viewer_distance = 13\nview_height = 4\nnear = 2\n[[lights]]\nkind = \"directional\"\nfrom = [3, 4, 12]\n\
         [[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n{objects}"
    );
    SceneFile::parse(&text, "t").expect("valid")
}

const BALL: &str = "[[objects]]\nname = \"b\"\nkind = \"sphere\"\nradius = 1\nmaterial = \"m\"\n";

/// The eye from the target and the direction upwards.
fn pose(look: &Look, up: &str) -> [[f64; 3]; 2] {
    let (scene, _) = look.applied(&scene(up, BALL), (4, 3)).expect("a camera");
    let Camera {
        eye,
        target,
        up,
        lens: Lens::Perspective { near, .. },
        ..
    } = scene.camera
    else {
        panic!("perspective")
    };
    assert_eq!((target, near), ([1.0, 2.0, 3.0], None));
    [std::array::from_fn(|k| eye[k] - target[k]), up]
}

fn side(side: Side) -> Look {
    Look {
        side: Some(side),
        ..Look::default()
    }
}

/// The scene with y up, looked at so, and what was left out.
fn applied(look: &Look, objects: &str) -> (SceneFile, Vec<String>) {
    look.applied(&scene(Y_UP, objects), (4, 3))
        .expect("a camera")
}

fn close(found: [[f64; 3]; 2], expected: [[f64; 3]; 2], what: &str) {
    for (a, b) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((a - b).abs() < 1e-12, "{what}: {found:?}, not {expected:?}");
    }
}

const Y_UP: &str = "[0.2, 1, 0.3]";
const Z_UP: &str = "[0, 0.1, 1]";

#[test]
fn sides_are_where_the_page_says() {
    let third = 13.0 / 3f64.sqrt();
    let sixth = 1.0 / 6f64.sqrt();
    let cases = [
        (Side::Front, Y_UP, [[0.0, 0.0, 13.0], [0.0, 1.0, 0.0]]),
        (Side::Back, Y_UP, [[0.0, 0.0, -13.0], [0.0, 1.0, 0.0]]),
        (Side::Left, Y_UP, [[-13.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        (Side::Right, Y_UP, [[13.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        (Side::Top, Y_UP, [[0.0, 13.0, 0.0], [0.0, 0.0, -1.0]]),
        (Side::Bottom, Y_UP, [[0.0, -13.0, 0.0], [0.0, 0.0, 1.0]]),
        (Side::Iso, Y_UP, [[third; 3], [-sixth, 2.0 * sixth, -sixth]]),
        (Side::Front, Z_UP, [[0.0, -13.0, 0.0], [0.0, 0.0, 1.0]]),
        (Side::Back, Z_UP, [[0.0, 13.0, 0.0], [0.0, 0.0, 1.0]]),
        (Side::Left, Z_UP, [[-13.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
        (Side::Right, Z_UP, [[13.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
        (Side::Top, Z_UP, [[0.0, 0.0, 13.0], [0.0, 1.0, 0.0]]),
        (Side::Bottom, Z_UP, [[0.0, 0.0, -13.0], [0.0, -1.0, 0.0]]),
        (
            Side::Iso,
            Z_UP,
            [[third, -third, third], [-sixth, sixth, 2.0 * sixth]],
        ),
    ];
    for (of, up, expected) in cases {
        close(pose(&side(of), up), expected, &format!("{of:?}, {up} up"));
    }
}

#[test]
fn what_is_seen_turns_about_the_picture() {
    let half = 13.0 * 0.5f64.sqrt();
    // From the front of a scene with y up: a turn about the direction upwards brings the left side to the viewer.
    let cases = [
        ([0.0, 90.0, 0.0], [[-13.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
        ([90.0, 0.0, 0.0], [[0.0, 13.0, 0.0], [0.0, 0.0, -1.0]]),
        ([0.0, 0.0, 90.0], [[0.0, 0.0, 13.0], [1.0, 0.0, 0.0]]),
        ([90.0, 90.0, 0.0], [[-13.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
        ([0.0, -45.0, 0.0], [[half, 0.0, half], [0.0, 1.0, 0.0]]),
        // The order: about the right first, then towards the viewer.
        ([90.0, 0.0, 90.0], [[0.0, 13.0, 0.0], [1.0, 0.0, 0.0]]),
    ];
    for (turn, expected) in cases {
        let look = Look {
            turn: Some(turn),
            ..side(Side::Front)
        };
        close(pose(&look, Y_UP), expected, &format!("{turn:?}"));
    }
}

#[test]
fn zoom_divides_the_height_and_leaves_the_rest() {
    let look = Look {
        zoom: Some(2.5),
        ..Look::default()
    };
    let after = applied(&look, BALL).0;
    let mut expected = scene(Y_UP, BALL);
    expected.camera.view_height = 1.6;
    assert_eq!(after, expected);
}

#[test]
fn lights_turn_only_when_they_are_asked_to() {
    for lights in [false, true] {
        let look = Look {
            turn: Some([0.0, 0.0, 90.0]),
            lights,
            ..Look::default()
        };
        // The first light is where the eye is, about which the turn goes.
        let after = applied(&look, BALL).0;
        let other = applied(
            &Look {
                lights,
                ..side(Side::Right)
            },
            BALL,
        )
        .0;
        let from = [&after, &other].map(|scene| match &scene.lights[0].beam {
            imogene_scene::Beam::Directional { from } => *from,
            other => panic!("{other:?}"),
        });
        let straight = [[3.0, 4.0, 12.0], [13.0, 0.0, 0.0]][usize::from(lights)];
        for (found, expected) in from.iter().zip([[3.0, 4.0, 12.0], straight]) {
            close([*found; 2], [expected; 2], &format!("lights {lights}"));
        }
    }
}

/// One ball of radius 1 in a picture of 4 by 3: the eye is where the tangents of its sides meet, 0.96 of 4/26 up.
#[test]
fn a_ball_touches_the_sides_of_a_fitted_picture() {
    let look = Look {
        fit: true,
        ..side(Side::Front)
    };
    let (fitted, left_out) = applied(&look, BALL);
    let tangent: f64 = 0.96 * 2.0 / 13.0;
    let expected = (1.0 + tangent * tangent).sqrt() / tangent;
    let Camera { eye, target, .. } = fitted.camera;
    assert!(left_out.is_empty());
    assert_eq!([eye[0], eye[1], target[0], target[1]], [0.0; 4]);
    assert!((eye[2] - expected).abs() < 1e-4, "{eye:?}, not {expected}");
    assert!((eye[2] - target[2] - 13.0).abs() < 1e-4);
}

#[test]
fn what_is_endless_is_named_and_left_out() {
    let endless = "[[objects]]\nname = \"pole\"\nkind = \"elliptic_cylinder\"\nradii = [1, 1]\nmaterial = \"m\"\n\
                   cuts = [{ point = [0, 5, 0], normal = [0, 1, 0] }]\n";
    let look = Look {
        fit: true,
        ..side(Side::Front)
    };
    let (fitted, left_out) = applied(&look, &format!("{endless}{BALL}"));
    assert_eq!(left_out, ["pole"]);
    let alone = applied(&look, BALL).0;
    assert_eq!(fitted.camera, alone.camera);
    let error = look.applied(&scene(Y_UP, endless), (4, 3));
    let error = error.expect_err("nothing to fit");
    assert!(error.to_string().contains("has an end"), "{error}");
}
