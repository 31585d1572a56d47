//! What the preparation refuses, and that its message says what, where and what would be accepted.

use imogene_golden::format::Format;
use imogene_prepare::error::PrepareError;
use imogene_prepare::{prepare as prepare_scene, prepare_for_roots};
use imogene_scene::{FramedQuadric, Projection, Surface};
use imogene_testkit::*;

/// The refusal of a machine that has processors of roots alone.
fn refusal(projection: Projection, object: FramedQuadric) -> PrepareError {
    let scene = scene_of(WIDTH, HEIGHT, projection, vec![object]);
    prepare_for_roots(&scene, Format::BASE).expect_err("no processor")
}

#[track_caller]
fn assert_says(error: &PrepareError, essentials: &[&str]) {
    let message = error.to_string();
    for essential in essentials {
        assert!(message.contains(essential), "'{essential}': {message}");
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
    let cuts = [[0, 0, -1, 100]];
    let cut = object("room", Surface::Solid, sphere([0, 0, -1000], 1200), &cuts);
    let prepared = prepare(&scene(vec![cut]));
    assert!(golden_pixels(&first(&prepared).words) > 0);
}

#[test]
fn viewer_exactly_on_the_quadric() {
    let cuts = [[0, 0, -1, -600]];
    let cut = object("ball", Surface::Patch, sphere([0, 0, -700], 300), &cuts);
    let error = refusal(perspective(1000), cut);
    assert!(matches!(error, PrepareError::ViewerOnSurface { .. }));
    assert_says(
        &error,
        &["'ball'", "exactly on this quadric", "square roots alone"],
    );
}

#[test]
fn object_behind_the_viewer() {
    let ball = ball([0, 0, -1500], 100, &[]);
    let prepared = prepare(&scene(vec![ball]));
    let notes = prepared.objects[0].notes();
    assert!(notes[0].contains("behind the viewer") && notes[0].contains("target"));
    assert_eq!(golden_pixels(&first(&prepared).words), 0);
}

/// A parabolic cylinder with its axis plane along the line of sight: z appears only to the first degree.
#[test]
fn orthographic_view_along_an_asymptotic_direction() {
    let trough = whole_quadric([1, 0, 0, 0, 0, 0, 0, 0, -50, 0]);
    let trough = object("trough", Surface::Solid, trough, &[]);
    let error = refusal(parallel(500), trough);
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
    let PrepareError::TooLarge(_, ref excess) = error else {
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
    let scene = scene(vec![ball([0, 0, 300], 100, &[steep])]);
    let error = prepare_scene(&scene, Format::BASE).expect_err("must be refused");
    let PrepareError::SteepPlane(.., ref steep) = error else {
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
