//! What the preparation refuses, and that its message says what, where and what would be accepted.

use imogene_algebra::rational::integer;
use imogene_golden::format::Format;
use imogene_prepare::error::PrepareError;
use imogene_prepare::{prepare as prepare_scene, prepare_for_roots};
use imogene_scene::{FramedQuadric, Projection, Surface};
use imogene_testkit::*;

fn refusal(object: FramedQuadric) -> PrepareError {
    refusal_in(
        Projection::Perspective {
            distance: integer(1000),
        },
        Format::BASE,
        object,
    )
}

fn refusal_in(projection: Projection, format: Format, object: FramedQuadric) -> PrepareError {
    let scene = scene_of(WIDTH, HEIGHT, projection, vec![object]);
    prepare_scene(&scene, format).expect_err("must be refused")
}

#[track_caller]
fn assert_says(error: &PrepareError, essentials: &[&str]) {
    let message = error.to_string();
    for essential in essentials {
        assert!(
            message.contains(essential),
            "'{essential}' missing in: {message}"
        );
    }
}

#[test]
fn a_solid_about_the_viewer_is_open_at_the_near_end() {
    let room = object("room", Surface::Solid, sphere([0, 0, -1000], 900), &[]);
    let prepared = prepare(&scene(vec![room]));
    // The near end is 500 from the eye, so all of it lies in the ball.
    let pixels = WIDTH as usize * HEIGHT as usize;
    assert_eq!(golden_pixels(&first(&prepared).words), pixels);
}

/// The same room with the viewer's part cut away is a solid before him, and is drawn.
#[test]
fn viewer_in_the_part_that_is_cut_away_is_accepted() {
    let cut = object(
        "room",
        Surface::Solid,
        sphere([0, 0, -1000], 1200),
        &[[0, 0, -1, 100]],
    );
    let prepared = prepare(&scene(vec![cut]));
    assert!(golden_pixels(&first(&prepared).words) > 0);
}

#[test]
fn viewer_exactly_on_the_quadric() {
    let cut = object(
        "ball",
        Surface::Patch,
        sphere([0, 0, -700], 300),
        &[[0, 0, -1, -600]],
    );
    let projection = Projection::Perspective {
        distance: integer(1000),
    };
    let scene = scene_of(WIDTH, HEIGHT, projection, vec![cut]);
    let error = prepare_for_roots(&scene, Format::BASE).expect_err("no processor");
    assert!(matches!(error, PrepareError::ViewerOnSurface { .. }));
    assert_says(
        &error,
        &["'ball'", "exactly on this quadric", "square roots alone"],
    );
}

#[test]
fn object_behind_the_viewer() {
    let ball = object("ball", Surface::Solid, sphere([0, 0, -1500], 100), &[]);
    let prepared = prepare(&scene(vec![ball]));
    let notes = prepared.objects[0].notes();
    assert!(notes[0].contains("behind the viewer") && notes[0].contains("target"));
    assert_eq!(golden_pixels(&first(&prepared).words), 0);
}

/// A parabolic cylinder with its axis plane along the line of sight: z appears only to the first degree.
#[test]
fn orthographic_view_along_an_asymptotic_direction() {
    let trough = whole_quadric([1, 0, 0, 0, 0, 0, 0, 0, -50, 0]);
    let projection = Projection::Orthographic {
        half_depth: integer(500),
    };
    let trough = object("trough", Surface::Solid, trough, &[]);
    let scene = scene_of(WIDTH, HEIGHT, projection, vec![trough]);
    let error = prepare_for_roots(&scene, Format::BASE).expect_err("no processor");
    assert!(matches!(error, PrepareError::AsymptoticView { .. }));
    assert_says(
        &error,
        &["'trough'", "asymptotic direction", "square roots alone"],
    );
}

/// The eye 1 pixel before a wide ball: f1 and the root are many times the viewer distance.
#[test]
fn too_large_for_the_format() {
    let globe = object("globe", Surface::Patch, sphere([0, 0, 5001], 6000), &[]);
    let scene = scene(vec![globe]);
    // A quotient draws it; a machine without one refuses it.
    assert!(prepare_scene(&scene, Format::BASE).is_ok());
    let error = prepare_for_roots(&scene, Format::BASE).expect_err("no processor");
    let PrepareError::TooLarge { ref excess, .. } = error else {
        panic!("{error}");
    };
    assert!(excess.needed > excess.available);
    let (needed, available) = (excess.needed.to_string(), excess.available.to_string());
    let word = excess.word.clone();
    assert_says(
        &error,
        &[
            "'globe'",
            "too large for the format",
            &word,
            &needed,
            &available,
        ],
    );
    assert_says(&error, &["columns 0..719", "lines 0..539", "`near = "]);
}

/// A plane that passes so nearly through the viewer that its depth leaves the plane word, and that turns inside the
/// object at column 360.
#[test]
fn steep_plane_that_is_no_half_plane() {
    let steep = [100_000, 0, 1, -300];
    let error = refusal(object(
        "ball",
        Surface::Solid,
        sphere([0, 0, 300], 100),
        &[steep],
    ));
    let PrepareError::SteepPlane { ref steep, .. } = error else {
        panic!("{error}");
    };
    let needed = steep.needed;
    assert_eq!((steep.x, steep.available), (360, Format::BASE.plane));
    assert!(needed > steep.available);
    assert_says(
        &error,
        &[
            "'ball'",
            "cut 0",
            "through the viewer",
            "(360, ",
            "turn the plane",
            &needed.to_string(),
        ],
    );
}
