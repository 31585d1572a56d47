//! Solids: golden picture against exact picture, depths, faces and normals, on the scenes and on random ones.

use crate::pictures::Pictures;
use imogene_golden::format::Format;
use imogene_scene::SceneFile;
use imogene_testkit::scene_file;
use proptest::prelude::*;

const SIZE: (u32, u32) = (120, 90);

#[derive(Debug)]
struct Found {
    /// Pixels where both see the same face.
    alike: usize,
    /// Pixels where they see different faces, or one of them none.
    different: usize,
    /// Pixels that show the back of an object taken away.
    backs: usize,
    /// Greatest difference of depths, in depth words.
    depth: f64,
    /// Greatest angle between normals, in degrees.
    angle: f64,
}

fn compare(file: &SceneFile) -> Found {
    let pictures = Pictures::of_file(file, SIZE, Format::BASE);
    let (depths, angles) = (pictures.depth_errors(), pictures.normal_errors());
    let backs = pictures.seen().filter(|(_, pixel)| pixel.is_back);
    Found {
        alike: pictures.seen().count(),
        different: pictures.differing().count(),
        backs: backs.count(),
        depth: depths.map(|(_, off)| off.abs()).fold(0.0, f64::max),
        angle: angles.iter().map(|e| e.1).fold(0.0, f64::max),
    }
}

#[test]
fn the_scenes_show_their_exact_picture() {
    for name in ["bracket", "printed-example"] {
        let found = compare(&scene_file(&format!("solids/{name}")));
        assert!(found.alike > 2000 && found.backs > 100, "{name}: {found:?}");
        assert!(found.different <= 3, "{name}: {found:?}");
        // The normal of a quadric turns fast beside its outline.
        let near = found.angle < 2.0 && found.depth < 300.0;
        assert!(near, "{name}: {found:?}");
    }
}

/// Objects of a random solid: balls, cylinders with lids, and boxes.
const SHAPES: [&str; 3] = [
    "kind = \"sphere\"\nradius = 1",
    "kind = \"elliptic_cylinder\"\nradii = [0.7, 0.7]\ncuts = [{ point = [0, 1, 0], normal = [0, 1, 0] }, { point = [0, -1, 0], normal = [0, -1, 0] }]",
    "kind = \"polyhedron\"\ncuts = [{ point = [0.8, 0, 0], normal = [1, 0, 0] }, { point = [-0.8, 0, 0], normal = [-1, 0, 0] }, \
     { point = [0, 0.7, 0], normal = [0, 1, 0] }, { point = [0, -0.7, 0], normal = [0, -1, 0] }, \
     { point = [0, 0, 0.6], normal = [0, 0, 1] }, { point = [0, 0, -0.6], normal = [0, 0, -1] }]",
];

fn object(index: usize, shape: usize, [x, y, z]: [i32; 3], degrees: i32) -> String {
    let [x, y, z] = [x, y, z].map(|v| f64::from(v) / 100.0);
    format!(
        "[[objects]]\nname = \"o{index}\"\nmaterial = \"m\"\nplace = [{{ rotate = {{ axis = \"x\", degrees = {degrees} }} }}, \
         {{ rotate = {{ axis = \"z\", degrees = {} }} }}, {{ translate = [{x}, {y}, {z}] }}]\n{}\n",
        degrees / 2,
        SHAPES[shape]
    )
}

/// A tree of operations over some of six objects, as a scene file has it.
fn any_tree() -> impl Strategy<Value = String> {
    let leaf = (0usize..6).prop_map(|index| format!("\"o{index}\""));
    let operation = |part: BoxedStrategy<String>| {
        let words = prop_oneof![Just("union"), Just("intersection"), Just("difference")];
        (words, proptest::collection::vec(part, 2..4))
            .prop_map(|(word, parts)| format!("{{ {word} = [{}] }}", parts.join(", ")))
    };
    let tree = leaf.prop_recursive(2, 6, 3, move |part| operation(part.boxed()));
    operation(tree.boxed())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn random_solids_show_their_exact_picture(
        tree in any_tree(),
        objects in proptest::collection::vec(
            (0usize..3, proptest::array::uniform3(-80i32..80), 0i32..180), 6
        ),
        is_perspective in any::<bool>(),
    ) {
        let camera = match is_perspective {
            true => "kind = \"perspective\"\nviewer_distance = 8",
            false => "kind = \"orthographic\"",
        };
        let objects = objects.into_iter().enumerate();
        let objects: String = objects.map(|(k, (shape, place, angle))| object(k, shape, place, angle)).collect();
        let text = format!(
            "format = 1\ntitle = \"t\"\n[camera]\n{camera}\neye = [3, 4, 7]\ntarget = [0, 0, 0]\nview_height = 5\n\
             [[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n{objects}[[solids]]\nname = \"s\"\nof = {tree}\n"
        );
        let scene = SceneFile::parse(&text, "random").expect("a scene");
        let found = compare(&scene);
        // What differs lies on edges, of which a solid of six objects has a few hundred pixels.
        prop_assert!(found.different <= 12, "{:?} of {}", found, text);
        prop_assert!(found.depth < 3000.0, "{:?} of {}", found, text);
    }
}
