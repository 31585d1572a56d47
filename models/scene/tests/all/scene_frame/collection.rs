//! The scenes of the collection and of the page of the format.

use super::*;
use imogene_prepare::Framing;
use imogene_testkit::{scene_file, scenes_in};

#[test]
fn shipped_scenes_load_frame_and_survive_writing() {
    let paths = scenes_in("");
    assert!(paths.len() >= 15, "only {} scenes found", paths.len());
    for path in paths {
        let scene = SceneFile::read(&path).unwrap_or_else(|error| panic!("{error}"));
        let framed = scene
            .frame(scene.image.width, scene.image.height)
            .expect("a checked scene");
        assert_eq!(framed.objects.len(), scene.objects.len());
        let written = scene.to_toml().expect("a checked scene");
        let again = SceneFile::parse(&written, "written")
            .unwrap_or_else(|error| panic!("{error}\n{written}"));
        assert_eq!(again, scene, "{}", path.display());
    }
}

#[test]
fn teapot_is_made_of_the_source_s_quadrics() {
    let scene = scene_file("teapot");
    let count = |test: fn(&Shape) -> bool| {
        scene
            .objects
            .iter()
            .filter(|object| object.mode == imogene_scene::Surface::Patch && test(&object.shape))
            .count()
    };
    assert_eq!(scene.objects.len(), 10);
    assert_eq!(count(|shape| matches!(shape, Shape::Ellipsoid { .. })), 4);
    assert_eq!(count(|shape| matches!(shape, Shape::Cone { .. })), 2);
    assert_eq!(
        count(|shape| matches!(shape, Shape::HyperboloidOneSheet { .. })),
        3
    );
    assert!(scene.objects.iter().all(|object| object.cuts.len() <= 3));
}

/// The page of the format must not promise what the reader refuses.
#[test]
fn documented_example_is_a_scene() {
    let page = include_str!("../../../../../docs/scene-format.md");
    let example = page
        .split("```")
        .find_map(|block| block.strip_prefix("toml\n"))
        .expect("the page opens with an example");
    let scene =
        SceneFile::parse(example, "scene-format.md").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.objects.len(), 2);
    assert_eq!((scene.image.width, scene.image.height), (720, 540));
}
