//! Solids: golden picture against exact picture, depths, faces and normals, on the scenes and on random ones.

use imogene_analysis::exact::render::{DEPTH_FRACTION, ExactPixel, directions, render};
use imogene_golden::format::Format;
use imogene_prepare::{Framing, prepare};
use imogene_scene::SceneFile;
use imogene_testkit::{angle_deg, scene_file};
use proptest::prelude::*;

const F: Format = Format::BASE;
const SIZE: (u32, u32) = (120, 90);

#[derive(Debug, Default)]
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
    let scene = file.frame(SIZE.0, SIZE.1).expect("valid size");
    let prepared = prepare(&scene, F).expect("prepared");
    let golden = prepared.frame(|| ());
    let exact = render(&scene, &F, || ());
    let normals = directions(&exact, &scene, &F);
    let mut found = Found::default();
    for (index, pixel) in exact.iter().enumerate() {
        let seen = pixel.as_ref().map_or((-1, 0), |p| (p.id as i32, p.number));
        let drawn = (golden.id[index], golden.number[index]);
        let Some(pixel) = pixel.as_ref().filter(|_| seen == drawn) else {
            found.different += usize::from(seen != drawn);
            continue;
        };
        found.add(
            pixel,
            golden.depth[index],
            golden.normal[index],
            normals[index],
        );
    }
    found
}

impl Found {
    fn add(&mut self, pixel: &ExactPixel, depth: i64, normal: [i16; 3], truth: [f64; 3]) {
        self.alike += 1;
        self.backs += usize::from(pixel.is_back);
        let exact = pixel.depth as f64 / f64::from(1 << DEPTH_FRACTION);
        self.depth = self.depth.max((depth as f64 - exact).abs());
        self.angle = self.angle.max(angle_deg(normal.map(f64::from), truth));
    }
}

#[test]
fn the_scenes_show_their_exact_picture() {
    for name in ["bracket", "printed-example"] {
        let found = compare(&scene_file(&format!("solids/{name}")));
        assert!(found.alike > 2000 && found.backs > 100, "{name}: {found:?}");
        assert!(found.different <= 3, "{name}: {found:?}");
        // The normal of a quadric turns fast beside its outline.
        assert!(
            found.angle < 2.0 && found.depth < 300.0,
            "{name}: {found:?}"
        );
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
        let objects: String = objects
            .into_iter()
            .enumerate()
            .map(|(index, (shape, place, degrees))| object(index, shape, place, degrees))
            .collect();
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
