//! The scenes of the collection and of the page of the format.

use super::*;
use imogene_testkit::{scene_file, scenes_in};

#[test]
fn shipped_scenes_load_frame_and_survive_writing() {
    let paths = scenes_in("");
    assert!(paths.len() >= 15, "only {} scenes found", paths.len());
    for path in paths {
        let scene = SceneFile::read(&path).unwrap_or_else(|error| panic!("{error}"));
        let framed = scene.frame(scene.image.width, scene.image.height);
        let framed = framed.expect("a checked scene");
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
        let patches = scene.objects.iter().filter(|o| o.mode == Surface::Patch);
        patches.filter(|o| test(&o.shape)).count()
    };
    assert_eq!(scene.objects.len(), 10);
    assert_eq!(count(|s| matches!(s, Shape::Ellipsoid(_))), 4);
    assert_eq!(count(|s| matches!(s, Shape::Cone(_))), 2);
    assert_eq!(count(|s| matches!(s, Shape::HyperboloidOneSheet(_))), 3);
    assert!(scene.objects.iter().all(|object| object.cuts.len() <= 3));
}

/// The page of the format must not promise what the reader refuses.
#[test]
fn documented_example_is_a_scene() {
    let page = include_str!("../../../../../docs/scene-format.md");
    let mut blocks = page.split("```");
    let example = blocks.find_map(|block| block.strip_prefix("toml\n"));
    let example = example.expect("an example");
    let scene =
        SceneFile::parse(example, "scene-format.md").unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(scene.objects.len(), 2);
    assert_eq!((scene.image.width, scene.image.height), (720, 540));
}
