//! Shadows and spots of the golden machine against exact rays to the light.
//!
//! Where the rounding of the words and the margin cannot change an answer, golden and exact flags are equal; that is
//! decided in whole numbers, from the proven bounds of the words and the distance of the two visible depths. Everywhere
//! else they may differ; it is counted how often they do, and each place is held against the edges of light in the
//! exact flags.

mod compare;
mod decide;
mod meshes;
mod polyhedra;
mod quadrics;

use crate::pictures::Pictures;
use compare::{Tally, compare};
use imogene_algebra::rational::integer;
use imogene_golden::format::Format;
use imogene_scene::{FramedObject, FramedQuadric, FramedScene, FramedSource, Surface};
use imogene_testkit::*;

const F: Format = Format::BASE;

/// Compares a scene of a file; the number of its volumes.
fn compare_file(path: &str, size: (u32, u32), tally: &mut Tally) -> usize {
    let pictures = Pictures::of_file(&scene_file(path), size, F);
    compare(&pictures, tally);
    let volumes = pictures.prepared.volumes.len();
    eprintln!("{volumes} volumes, {tally:?}");
    volumes
}

/// A floor, a ball, a bowl of a half sphere and an oblique can under a directional light and a spot.
#[test]
fn a_scene_with_a_spot_has_the_shadows_of_the_exact_rays() {
    // Ball 1, half sphere 2, can and floor 3 for each source, less those that meet nothing; one cone.
    let mut tally = Tally::default();
    compare_file("../models/testkit/scenes/shadows", (180, 135), &mut tally);
    assert!(tally.lit > 10_000 && tally.dark > 5_000, "{tally:?}");
    assert!(tally.open <= 38 && tally.differing <= 32, "{tally:?}");
    assert_eq!(tally.differing, tally.at_an_edge, "{tally:?}");
}

/// The robot of the collection: 38 solids cast shadows of a spot and a directional light.
#[test]
fn the_robot_has_the_shadows_of_the_exact_rays() {
    let mut tally = Tally::default();
    let volumes = compare_file("shadows/robot", (120, 90), &mut tally);
    assert!(volumes > 100);
    assert!(tally.lit > 3_000 && tally.dark > 2_000, "{tally:?}");
    assert!(tally.open <= 22 && tally.differing <= 15, "{tally:?}");
    assert_eq!(tally.differing, tally.at_an_edge, "{tally:?}");
}

/// Two objects before a wall that casts no shadow, by turns in perspective and in a parallel view.
fn before_a_wall(round: usize, casters: [FramedObject; 2]) -> FramedScene {
    let wall = FramedQuadric {
        casts_shadow: false,
        ..object("wall", Surface::Solid, sphere([0, 0, 250], 200), &[])
    };
    let projection = if round.is_multiple_of(2) {
        perspective(150)
    } else {
        parallel(150)
    };
    let mut framed = scene_of(96, 72, projection, vec![wall]);
    framed.objects.extend(casters);
    framed.title = format!("round {round}");
    framed
}

/// A point source and a directional one, both on the viewer's side.
fn sources(random: &mut Random) -> Vec<FramedSource> {
    let mut at = |most: f64| (random.signed() * most).round() as i64;
    vec![
        source([at(90.0), at(90.0), -50 - at(40.0).abs(), 1]),
        source([at(10.0), at(10.0), -3 - at(10.0).abs(), 0]),
    ]
}

fn source(point: [i64; 4]) -> FramedSource {
    FramedSource {
        point: point.map(integer),
        shadows: true,
        cone: None,
    }
}
