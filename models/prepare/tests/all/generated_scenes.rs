//! The scenes of many spheres: their committed files are what the generator writes today, and they can be drawn.

#[path = "../../../scene/examples/generate_scene/dna.rs"]
mod dna;
#[path = "../../../scene/examples/generate_scene/sphere.rs"]
mod sphere;
#[path = "../../../scene/examples/generate_scene/surface.rs"]
mod surface;

use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_scene::SceneFile;

fn committed(name: &str) -> String {
    let path = format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    std::fs::read_to_string(path).expect("a readable file")
}

#[test]
fn committed_scenes_are_those_of_the_generator() {
    for (path, text) in [
        ("shadows/dna", dna::scene()),
        ("shadows/sphere-surface", surface::scene()),
        ("zones/molecule-480", dna::without_shadows()),
    ] {
        let name = path.rsplit('/').next().expect("a name");
        assert!(
            committed(path) == text,
            "scenes/{path}.toml is stale: run the example generate_scene {name} and write its output there"
        );
    }
}

#[test]
fn they_have_as_many_spheres_and_shadows_as_they_say() {
    // One sphere casts one volume for each source with shadows, unless that meets nothing seen; the wall of the helix
    // casts none.
    for (name, objects, volumes) in [
        ("shadows/dna", 481, 960),
        ("shadows/sphere-surface", 4000, 3803),
        ("zones/molecule-480", 481, 0),
    ] {
        let scene = SceneFile::parse(&committed(name), name).expect("a valid scene");
        assert_eq!(scene.objects.len(), objects);
        let framed = scene.frame(720, 540).expect("a valid size");
        let prepared = prepare(&framed, Format::BASE).expect("fits the base format");
        assert_eq!(prepared.volumes.len(), volumes, "{name}");
    }
}
