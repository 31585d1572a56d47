//! A scene that is located once has the words of one that is prepared from scratch, whatever was asked for before.

use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_prepare::rounding::Anchor;
use imogene_prepare::{
    Framing, LocatedScene, Options, PreparedScene, error::PrepareError, prepare_with,
};
use imogene_testkit::scene_file;

/// Depth, root, plane, normal, guard bits and digits left out: each but the first differs in one of them from another,
/// and some are too short for a scene.
const WIDTHS: [[u32; 7]; 10] = [
    [20, 20, 32, 14, 1, 2, 0],
    [20, 18, 32, 14, 1, 2, 0],
    [20, 20, 24, 14, 1, 2, 0],
    [20, 20, 32, 10, 1, 2, 0],
    [20, 20, 32, 14, 3, 2, 0],
    [20, 20, 32, 14, 1, 0, 0],
    [20, 20, 32, 14, 1, 2, 4],
    [13, 13, 25, 14, 1, 2, 0],
    [13, 12, 19, 10, 3, 0, 2],
    [24, 24, 36, 16, 0, 0, 0],
];

fn format(
    [
        depth,
        root,
        plane,
        normal,
        guard_linear,
        guard_quadratic,
        dropped_rows,
    ]: [u32; 7],
) -> Format {
    let words = MachineWords {
        root,
        plane,
        normal,
        guard_linear,
        guard_quadratic,
        dropped_rows,
        ..MachineWords::of(depth)
    };
    Format::fitted(&words).expect("a format")
}

/// All that is known of it.
fn told(prepared: Result<PreparedScene, PrepareError>) -> String {
    match prepared {
        Ok(scene) => format!("{:?} {:?}", scene.objects, scene.volumes),
        Err(refusal) => refusal.to_string(),
    }
}

#[test]
fn words_do_not_depend_on_what_was_asked_for_before() {
    let about_origin = Options {
        anchor: Some(Anchor::ORIGIN),
        ..Options::HARDWARE
    };
    // Volumes of every kind, prisms, steep planes and planes through the eye.
    let scenes = [
        "shadows/robot",
        "shadows/ball-before-ball",
        "orthographic",
        "extremes/plane-along-the-ray",
        "extremes/plane-through-the-eye",
        "extremes/axis-along-the-ray",
        "front-view",
    ];
    for name in scenes {
        let scene = scene_file(name).frame(64, 48).expect("a scene");
        let located = LocatedScene::new(&scene);
        for (index, widths) in WIDTHS.iter().chain(WIDTHS.iter().rev()).enumerate() {
            for options in [Options::HARDWARE, about_origin] {
                let again = told(located.prepare(&scene, format(*widths), options));
                let fresh = told(prepare_with(&scene, format(*widths), options));
                assert!(
                    again == fresh,
                    "{name}, {widths:?}, number {index}:\n{again}\n{fresh}"
                );
            }
        }
    }
}
