//! Lit-sphere shading against the shading processor, which has another formula and other words.

use imogene_golden::format::Format;
use imogene_prepare::{Framing, prepare};
use imogene_scene::SceneFile;
use imogene_studies::shading_trial::{SphereErrors, sphere_errors};
use imogene_testkit::scene_path;

/// The errors on a scene whose lights at a point are directional ones.
fn errors(scene: &str, nearest: bool) -> Vec<SphereErrors> {
    let text = std::fs::read_to_string(scene_path(scene)).expect("a scene");
    let text = text.replace("kind = \"point\"\nposition", "kind = \"directional\"\nfrom");
    let file = SceneFile::parse(&text, scene).expect("a valid scene");
    let framed = file.frame(320, 240).expect("a valid size");
    let prepared = prepare(&framed, Format::BASE).expect("fits the format");
    sphere_errors(&framed, &prepared, nearest).expect("words")
}

/// Where viewer and lights are infinitely far, nothing but the table and its rounding is between the two.
#[test]
fn along_parallel_lines_of_sight_large_tables_are_near_the_processor() {
    let [smallest, .., largest] = &errors("orthographic", false)[..] else {
        panic!("tables of several sizes");
    };
    assert_eq!((smallest.side, largest.side), (16, 128));
    let all = &largest.all;
    assert!(all.mean < 0.5 && all.most_of_1000 <= 3, "{largest:?}");
    assert!(smallest.all.mean > 2.0 * largest.all.mean, "{smallest:?}");
}

/// One colour for each square is rougher than what stands between entries, and gets better as they get smaller.
#[test]
fn the_nearest_entry_is_rougher() {
    let (between, nearest) = (errors("orthographic", false), errors("orthographic", true));
    for (between, nearest) in between.iter().zip(&nearest) {
        assert!(nearest.nearest && between.side == nearest.side);
        assert!(nearest.table.mean > between.table.mean, "{nearest:?}");
    }
    for pair in nearest.windows(2) {
        let ratio = pair[0].table.mean / pair[1].table.mean;
        assert!((1.4..3.0).contains(&ratio), "{pair:?}");
    }
}

/// The table is as near to its own formula where the eye is near, though that is far from the processor's. In a shadow
/// it is the table of the lights that are left.
#[test]
fn a_near_viewer_costs_more_than_the_table() {
    for scene in ["teapot", "shadows/robot"] {
        let errors = errors(scene, false);
        let of_64 = &errors[2];
        assert_eq!(of_64.side, 64);
        let (all, table) = (&of_64.all, &of_64.table);
        assert!(
            table.mean < 0.5 && table.most_of_1000 <= 10,
            "{scene}: {table:?}"
        );
        assert!(all.mean > table.mean, "{scene}: {of_64:?}");
    }
}
