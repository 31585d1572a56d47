//! The crack detector on convex solids from many sides, and on pictures broken on purpose.

use crate::common::scene;
use imogene_golden::format::Format;
use imogene_golden::machine::beam;
use imogene_golden::machine::frame::Frame;
use imogene_oracle::crack::{Buffers, Rule, cracks, mark_openings, two_pixels};
use imogene_oracle::inject::{Breakable, Sort};
use imogene_oracle::trace::Tracer;
use imogene_prepare::Framing;
use imogene_prepare::{PreparedScene, prepare};
use imogene_scene::{DepthRange, SceneFile};

const CONVEX: [&str; 6] = [
    "kind = \"sphere\"\nradius = 1.5",
    "kind = \"ellipsoid\"\nradii = [2, 0.4, 1]",
    "kind = \"sphere\"\nradius = 1.5\ncuts = [{ point = [0, 0.3, 0], normal = [1, 2, 1] }, { point = [0, -0.5, 0], normal = [0, -1, 0.2] }]",
    "kind = \"elliptic_cylinder\"\nradii = [0.8, 0.3]\ncuts = [{ point = [0, 1, 0], normal = [0, 1, 0] }, { point = [0, -1, 0], normal = [0, -1, 0] }]",
    "kind = \"cone\"\nradii = [1, 1, 1]\ncuts = [{ point = [0, 0, 0], normal = [0, 1, 0] }, { point = [0, -1.5, 0], normal = [0, -1, 0] }]",
    "kind = \"polyhedron\"\ncuts = [{ point = [1, 0, 0], normal = [1, 0, 0] }, { point = [-1, 0, 0], normal = [-1, 0, 0] }, { point = [0, 1, 0], normal = [0, 1, 0] }, \
     { point = [0, -1, 0], normal = [0, -1, 0] }, { point = [0, 0, 1], normal = [0, 0, 1] }, { point = [0, 0, -1], normal = [0, 0, -1] }]",
];

fn rule(min_distance: f64, width: usize) -> Rule {
    Rule {
        min_distance,
        width,
    }
}

fn prepared(scene: &SceneFile, width: u32, height: u32) -> PreparedScene {
    prepare(&scene.frame(width, height).expect("framed"), Format::BASE).expect("prepared")
}

/// The golden picture, and what is searched of it.
fn drawn(scene: &SceneFile, prepared: &PreparedScene) -> (Frame, Buffers) {
    let [columns, lines] = [prepared.width, prepared.height].map(|pixels| pixels as usize);
    let frame = beam::render(&prepared.slots(), &Format::BASE, columns, lines, || ());
    let range = DepthRange::of_camera(&scene.camera);
    let buffers = Buffers::new(&frame, &range, Format::BASE.z_max());
    (frame, buffers)
}

#[test]
fn convex_solids_have_no_cracks_from_any_side() {
    let views = "0, 0, 10; 10, 1, 0.5; 5, 4, 5; -6, -3, 7; 0.1, 9.5, 3";
    let projections = [
        "kind = \"perspective\"\nviewer_distance = 10",
        "kind = \"orthographic\"\nhalf_depth = 4",
    ];
    for object in CONVEX {
        for eye in views.split("; ") {
            for projection in projections {
                let camera =
                    format!("{projection}\neye = [{eye}]\ntarget = [0, 0, 0]\nview_height = 4.8\n");
                let scene = scene(&camera, &[object]);
                let prepared = prepared(&scene, 160, 120);
                let (frame, buffers) = drawn(&scene, &prepared);
                assert!(frame.covered() > 100, "{object} from {eye}");
                // A thousandth of a pixel is far above the depth error.
                let least = two_pixels(&scene.camera, 120) / 2000.0;
                for (min_distance, width) in [(1000.0 * least, 1), (least, 1), (least, 3)] {
                    let found = cracks(&buffers, &rule(min_distance, width));
                    assert_eq!(found, [], "{object} from {eye}");
                }
            }
        }
    }
}

/// In solids before the background every crack is found, whatever the distance; and no other pixel is flagged.
#[test]
fn every_crack_of_a_convex_solid_is_found() {
    for object in CONVEX {
        let scene = scene(crate::common::PERSPECTIVE, &[object]);
        let breakable = Breakable::new(&prepared(&scene, 160, 120));
        let range = DepthRange::of_camera(&scene.camera);
        for sort in [Sort::Points, Sort::Lines] {
            for min_distance in [0.01, 1.0, 100.0] {
                let score = breakable.score(&range, sort, 100, 7, &rule(min_distance, 1));
                assert!(score.made > 5, "{object} {score:?}");
                let wanted = (score.made, 0);
                assert_eq!((score.found, score.others), wanted, "{object} {score:?}");
            }
        }
    }
}

/// Behind the pixels of a joint lies another object; what is deep enough behind all that is about it is found.
#[test]
fn every_deep_crack_of_the_teapot_is_found() {
    let scene = crate::common::read("teapot");
    let breakable = Breakable::new(&prepared(&scene, 200, 150));
    let range = DepthRange::of_camera(&scene.camera);
    for sort in [Sort::Points, Sort::Lines, Sort::Joints] {
        let rule = rule(two_pixels(&scene.camera, 150), 1);
        let score = breakable.score(&range, sort, 60, 3, &rule);
        assert!(score.deep > 10, "{score:?}");
        assert_eq!(score.deep, score.deep_found, "{score:?}");
    }
}

/// Faces that meet have planes in common. Rounded for each object by itself, as if it were alone in its scene, the two
/// sides of such a plane lie apart, and the detector finds a pixel that falls between them; prepared together, none
/// does.
#[test]
fn edges_that_are_rounded_on_each_side_by_itself_are_found() {
    let mut found_apart = 0;
    for part in ["ball-joint", "bracket", "fillet"] {
        let scene = crate::common::read(&format!("cad/{part}"));
        let (width, height) = (scene.image.width, scene.image.height);
        let framed = scene.frame(width, height).expect("framed");
        let together = prepare(&framed, Format::BASE).expect("prepared");
        let mut apart = together.clone();
        for (index, object) in framed.objects.iter().enumerate() {
            let mut alone = framed.clone();
            alone.objects = vec![object.clone()];
            let prepared = prepare(&alone, Format::BASE).expect("prepared");
            apart.objects[index] = prepared.objects[0].clone();
        }
        let tracer = Tracer::new(&scene, &framed.range, width, height);
        let rule = rule(two_pixels(&scene.camera, height as usize), 1);
        let count = |prepared: &PreparedScene| {
            let (_, buffers) = drawn(&scene, prepared);
            let mut found = cracks(&buffers, &rule);
            mark_openings(&mut found, &tracer);
            found.iter().filter(|c| c.is_of_the_drawing()).count()
        };
        assert_eq!(count(&together), 0, "{part}");
        found_apart += count(&apart);
    }
    assert!(found_apart > 0);
}
