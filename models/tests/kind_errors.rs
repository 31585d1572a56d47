//! Every refusal of a kind, a processor or a mesh says what is wrong, where, and what would be accepted.

use imogene_models::format::Format;
use imogene_models::prepare::prepare;
use imogene_models::scene::SceneFile;

const PERSPECTIVE: &str = "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nviewer_distance = 10\nview_height = 4\n";
const PARALLEL: &str = "kind = \"orthographic\"\neye = [3, 4, 10]\ntarget = [0, 0, 0]\nview_height = 4\nhalf_depth = 4\n";
const STRAIGHT: &str = "kind = \"orthographic\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nview_height = 4\nhalf_depth = 4\n";

const UP: &str = "{ point = [0, 0.5, 0], normal = [0, 1, 0] }";
const DOWN: &str = "{ point = [0, -0.5, 0], normal = [0, -1, 0] }";
const TRIANGLE: &str = "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]\n";
const CORNERS: &str = "corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
const WEIGHTS: &str = "weights = [-1, 1, 1, 1, -1, -1, -1, -1, -1, -1]\n";

fn scene(camera: &str, keys: &str) -> String {
    format!(
        "format = 1\ntitle = \"test\"\nimage = {{ width = 64, height = 48 }}\n[camera]\n{camera}\
         [[materials]]\nname = \"clay\"\ncolour = [0.8, 0.4, 0.3]\n\
         [[objects]]\nname = \"thing\"\nmaterial = \"clay\"\n{keys}\n"
    )
}

/// The message of whatever refuses the scene: reading, framing or preparation.
fn refusal(camera: &str, keys: &str) -> String {
    let file = match SceneFile::parse(&scene(camera, keys), "demo.toml") {
        Ok(file) => file,
        Err(error) => return error.to_string(),
    };
    let framed = match file.frame(64, 48) {
        Ok(framed) => framed,
        Err(error) => return error.to_string(),
    };
    match prepare(&framed, Format::BASE) {
        Ok(_) => panic!("accepted:\n{keys}"),
        Err(error) => error.to_string(),
    }
}

#[track_caller]
fn check(camera: &str, keys: &str, parts: &[&str]) {
    let message = refusal(camera, keys);
    for part in parts.iter().chain(&["thing"]) {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

#[track_caller]
fn accept(camera: &str, keys: &str) {
    let file = SceneFile::parse(&scene(camera, keys), "demo.toml").expect("valid");
    let framed = file.frame(64, 48).expect("framed");
    prepare(&framed, Format::BASE).expect("fits");
    let written = file.to_toml().expect("can be written");
    assert_eq!(SceneFile::parse(&written, "written").expect("valid"), file);
}

#[test]
fn good_ones_are_accepted_and_written() {
    accept(
        PERSPECTIVE,
        "kind = \"sphere\"\nradius = 1\nmode = \"patch\"\nprocessor = \"patch\"",
    );
    accept(
        PERSPECTIVE,
        &format!(
            "kind = \"polyhedron\"\ncuts = [{UP}, {{ point = [0, 0, 1], normal = [0, 0, 1] }}]"
        ),
    );
    accept(
        PERSPECTIVE,
        &format!("kind = \"mesh\"\n{TRIANGLE}faces = [[0, 1, 2], [0, 1, 3, 2]]"),
    );
    accept(
        PERSPECTIVE,
        &format!(
            "kind = \"mesh\"\n{TRIANGLE}faces = [[0, 1, 2]]\nnormals = [[0, 0, 1], [0, 1, 1], [1, 0, 1], [0, 0, 2]]"
        ),
    );
    accept(
        PERSPECTIVE,
        &format!("kind = \"tetrahedron_patch\"\n{CORNERS}{WEIGHTS}"),
    );
    accept(
        PERSPECTIVE,
        &format!(
            "kind = \"tetrahedron_patch\"\nmode = \"patch\"\nprocessor = \"quadric\"\n{CORNERS}{WEIGHTS}"
        ),
    );
    accept(
        PARALLEL,
        "kind = \"sphere\"\nradius = 1\nprocessor = \"paraboloid\"\nplace = [{ scale = [2, -2, 2] }, { rotate = { axis = [1, 2, 3], degrees = 33 } }]",
    );
    accept(
        PARALLEL,
        &format!(
            "kind = \"elliptic_cylinder\"\nradii = [1, 1]\nprocessor = \"paraboloid\"\ncuts = [{DOWN}, {UP}]"
        ),
    );
    accept(
        PARALLEL,
        "kind = \"sphere\"\nradius = 1\nmode = \"patch\"\nprocessor = \"curved_facet\"",
    );
    accept(
        PERSPECTIVE,
        &format!(
            "kind = \"sphere\"\nradius = 1\nprocessor = \"first_generation\"\ncuts = [{UP}, {DOWN}]\nplace = [{{ rotate = {{ axis = \"x\", degrees = 60 }} }}]"
        ),
    );
}

#[test]
fn unknown_processor() {
    let message = refusal(
        PERSPECTIVE,
        "kind = \"sphere\"\nradius = 1\nprocessor = \"facet\"",
    );
    for part in [
        "demo.toml:18:13",
        "`facet`",
        "`quadric`",
        "`first_generation`",
    ] {
        assert!(message.contains(part), "`{part}` is missing in: {message}");
    }
}

#[test]
fn patch_processor_on_a_solid() {
    check(
        PERSPECTIVE,
        "kind = \"sphere\"\nradius = 1\nprocessor = \"patch\"",
        &["processor", "\"patch\"", "solid", "mode = \"patch\""],
    );
}

#[test]
fn first_generation_with_other_cuts() {
    let with = |cuts: &str| {
        format!("kind = \"sphere\"\nradius = 1\nprocessor = \"first_generation\"\ncuts = [{cuts}]")
    };
    let needed = "exactly two parallel cuts";
    check(PERSPECTIVE, &with(UP), &["cuts", "1 cuts", needed]);
    check(
        PERSPECTIVE,
        &with(&format!("{UP}, {DOWN}, {DOWN}")),
        &["3 cuts", needed],
    );
    check(
        PERSPECTIVE,
        &with(&format!("{UP}, {UP}")),
        &["not parallel with opposite normals", needed],
    );
    let slanted = "{ point = [0, -0.5, 0], normal = [0.1, -1, 0] }";
    check(
        PERSPECTIVE,
        &with(&format!("{UP}, {slanted}")),
        &["not parallel", needed],
    );
    // The viewer looks along the planes and stands between them.
    check(
        PERSPECTIVE,
        &with(&format!("{UP}, {DOWN}")),
        &["first_generation", "between its two planes", "\"quadric\""],
    );
    let around = "place = [{ scale = 3 }, { translate = [0, 0, 10] }]\n";
    let inside = format!(
        "kind = \"hyperboloid_two_sheets\"\nradii = [1, 1, 1]\nprocessor = \"first_generation\"\n{around}cuts = [{{ point = [0, -2, 0], normal = [0, 1, 0] }}, {{ point = [0, -3, 0], normal = [0, -1, 0] }}]"
    );
    // Outside a hyperboloid of two sheets, between them, is outside of the solid; one sheet's waist is inside.
    let waist = inside
        .replace("two_sheets", "one_sheet")
        .replace("scale = 3", "scale = 30")
        .replace("-2, 0]", "-0.1, 0]")
        .replace("-3, 0]", "-0.2, 0]");
    check(
        PERSPECTIVE,
        &waist,
        &["first_generation", "inside the unbounded quadric"],
    );
}

#[test]
fn paraboloids_that_cannot_be() {
    let sphere = "kind = \"sphere\"\nradius = 1\nprocessor = \"paraboloid\"\n";
    check(
        PERSPECTIVE,
        sphere,
        &["processor", "\"paraboloid\"", "perspective", "orthographic"],
    );
    check(
        PARALLEL,
        &format!("{sphere}mode = \"patch\""),
        &["\"paraboloid\"", "patch", "mode = \"solid\""],
    );
    check(
        PARALLEL,
        &format!("{sphere}cuts = [{UP}]"),
        &["cuts", "does not cut a sphere"],
    );
    check(
        PARALLEL,
        &format!("{sphere}place = [{{ scale = [1, 2, 1] }}]"),
        &["place", "no longer a sphere", "keep it round"],
    );
    check(
        PARALLEL,
        "kind = \"ellipsoid\"\nradii = [1, 1, 1]\nprocessor = \"paraboloid\"",
        &["spheres and circular cylinders only", "kind = \"sphere\""],
    );
    let cylinder = |radii: &str, cuts: &str, place: &str| {
        format!(
            "kind = \"elliptic_cylinder\"\nradii = {radii}\nprocessor = \"paraboloid\"\nplace = [{place}]\ncuts = [{cuts}]"
        )
    };
    let both = format!("{UP}, {DOWN}");
    check(
        PARALLEL,
        &cylinder("[1, 2]", &both, ""),
        &["place", "not a right circular cylinder"],
    );
    check(
        PARALLEL,
        &cylinder("[1, 1]", UP, ""),
        &["cuts", "two ends", "[0, 1, 0]"],
    );
    let slanted = "{ point = [0, -0.5, 0], normal = [0.1, -1, 0] }";
    check(
        PARALLEL,
        &cylinder("[1, 1]", &format!("{UP}, {slanted}"), ""),
        &["across the axis"],
    );
    check(
        PARALLEL,
        &cylinder(
            "[1, 1]",
            &format!("{UP}, {}", DOWN.replace("-0.5", "0.5")),
            "",
        ),
        &["leave nothing"],
    );
    check(
        STRAIGHT,
        &cylinder("[1, 1]", &both, ""),
        &["side-on", "turn it"],
    );
    let turned = "{ rotate = { axis = \"x\", degrees = 90 } }";
    check(
        STRAIGHT,
        &cylinder("[1, 1]", &both, turned),
        &["end-on", "turn it"],
    );
}

#[test]
fn curved_facets_that_cannot_be() {
    let bowl = "kind = \"elliptic_paraboloid\"\nradii = [1, 1, 1]\nprocessor = \"curved_facet\"\n";
    check(
        PERSPECTIVE,
        &format!("{bowl}mode = \"patch\""),
        &["\"curved_facet\"", "perspective"],
    );
    check(
        STRAIGHT,
        bowl,
        &["\"curved_facet\"", "solid", "mode = \"patch\""],
    );
    let bowl = format!("{bowl}mode = \"patch\"\n");
    check(STRAIGHT, &bowl, &["second degree", "along its axis"]);
    let turned = "place = [{ rotate = { axis = \"x\", degrees = 90 } }]\n";
    check(
        STRAIGHT,
        &format!("{bowl}{turned}cuts = [{UP}]"),
        &["cuts[0]", "perpendicular to the screen"],
    );
    let side = "{ point = [1, 0, 0], normal = [1, 0, 0] }, ".repeat(5);
    check(
        STRAIGHT,
        &format!("{bowl}{turned}cuts = [{side}]"),
        &["5 cuts", "at most 4 sides"],
    );
    let sphere = "kind = \"sphere\"\nradius = 1\nmode = \"patch\"\nprocessor = \"curved_facet\"\n";
    check(
        STRAIGHT,
        &format!("{sphere}cuts = [{UP}]"),
        &["cuts", "outline"],
    );
    check(
        STRAIGHT,
        &format!("{sphere}place = [{{ scale = [1, 1, 2] }}]"),
        &["place", "no longer a sphere"],
    );
}

#[test]
fn polyhedra_that_cannot_be() {
    check(
        PERSPECTIVE,
        "kind = \"polyhedron\"",
        &["cuts", "without cuts", "1 to 12"],
    );
    check(
        PERSPECTIVE,
        &format!("kind = \"polyhedron\"\nradii = [1, 1, 1]\ncuts = [{UP}]"),
        &["no `radii`", "`cuts`"],
    );
    check(
        PERSPECTIVE,
        &format!("kind = \"polyhedron\"\nmode = \"patch\"\ncuts = [{UP}]"),
        &["is a volume", "mode = \"solid\""],
    );
    check(
        PERSPECTIVE,
        &format!("kind = \"polyhedron\"\nprocessor = \"quadric\"\ncuts = [{UP}]"),
        &["processor", "\"quadric\"", "of its own"],
    );
    // The slab between two planes reaches to the viewer.
    check(
        PERSPECTIVE,
        &format!("kind = \"polyhedron\"\ncuts = [{UP}, {DOWN}]"),
        &["inside this polyhedron"],
    );
    let behind = "{ point = [0, 0, 12], normal = [0, 0, -1] }";
    let side = |x: i32| format!("{{ point = [{x}, 0, 0], normal = [{x}, 0, 0] }}");
    let sides = format!(
        "{behind}, {}, {}, {UP}, {DOWN}, {{ point = [0, 0, 14], normal = [0, 0, 1] }}",
        side(1),
        side(-1)
    );
    check(
        PERSPECTIVE,
        &format!("kind = \"polyhedron\"\ncuts = [{sides}]"),
        &["behind the viewer"],
    );
}

#[test]
fn meshes_that_cannot_be() {
    let mesh = |rest: &str| format!("kind = \"mesh\"\n{rest}");
    let faces = |list: &str| format!("kind = \"mesh\"\n{TRIANGLE}faces = {list}");
    check(
        PERSPECTIVE,
        &mesh("vertices = [[0, 0, 0], [1, 0, 0]]\nfaces = [[0, 1, 1]]"),
        &["vertices", "2 vertices", "at least three"],
    );
    check(
        PERSPECTIVE,
        &mesh("vertices = [[0, 0, 0], [1, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]"),
        &["vertices[1]", "2 numbers", "[x, y, z]"],
    );
    check(
        PERSPECTIVE,
        &mesh("vertices = [[0, 0, 0], [1, 0, nan], [0, 1, 0]]\nfaces = [[0, 1, 2]]"),
        &["vertices[1][2]", "finite"],
    );
    check(
        PERSPECTIVE,
        &mesh("faces = [[0, 1, 2]]"),
        &["needs", "`vertices` and `faces`"],
    );
    check(
        PERSPECTIVE,
        &mesh(TRIANGLE),
        &["needs", "`vertices` and `faces`"],
    );
    check(PERSPECTIVE, &faces("[]"), &["faces", "no face"]);
    check(
        PERSPECTIVE,
        &faces("[[0, 1]]"),
        &["faces[0]", "2 corners", "three or four"],
    );
    check(
        PERSPECTIVE,
        &faces("[[0, 1, 2], [0, 1, 4]]"),
        &["faces[1]", "vertex 4", "0 to 3"],
    );
    check(PERSPECTIVE, &faces("[[0, 1, 1]]"), &["faces[0]", "twice"]);
    check(
        PERSPECTIVE,
        &faces("[[0, 1, 2, 3]]"),
        &["faces[0]", "no area", "sides cross"],
    );
    check(
        PERSPECTIVE,
        &mesh("vertices = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]\nfaces = [[0, 1, 2]]"),
        &["faces[0]", "no area"],
    );
    check(
        PERSPECTIVE,
        &format!("{}\nnormals = [[0, 0, 1]]", faces("[[0, 1, 2]]")),
        &["normals", "1 normals for 4 vertices"],
    );
    check(
        PERSPECTIVE,
        &format!(
            "{}\nnormals = [[0, 0, 1], [0, 0, 0], [0, 0, 1], [0, 0, 1]]",
            faces("[[0, 1, 2]]")
        ),
        &["normals[1]", "no direction"],
    );
    check(
        PERSPECTIVE,
        &format!("{}\ncuts = [{UP}]", faces("[[0, 1, 2]]")),
        &["cuts", "cannot be cut"],
    );
    check(
        PERSPECTIVE,
        &format!("{}\nmode = \"solid\"", faces("[[0, 1, 2]]")),
        &["no `mode`"],
    );
    check(
        PERSPECTIVE,
        &format!("{}\nprocessor = \"patch\"", faces("[[0, 1, 2]]")),
        &["processor", "\"patch\"", "of its own"],
    );
    check(
        PERSPECTIVE,
        &format!("{}\nradius = 1", faces("[[0, 1, 2]]")),
        &["no `radius`", "`vertices`"],
    );
    let moved = |z: &str| {
        format!(
            "{}\nplace = [{{ translate = [0, 0, {z}] }}]",
            faces("[[0, 1, 2]]")
        )
    };
    check(
        PERSPECTIVE,
        &moved("10"),
        &["faces[0]", "vertex 0", "not in front of the viewer"],
    );
    check(
        PERSPECTIVE,
        &moved("11"),
        &["faces[0]", "not in front of the viewer"],
    );
    check(
        PERSPECTIVE,
        &moved("5.1"),
        &["faces[0]", "nearer", "viewer_distance"],
    );
    check(
        PERSPECTIVE,
        &format!("{}\nplace = [{{ scale = 1e12 }}]", faces("[[0, 1, 2]]")),
        &["faces[0]", "too far beside the screen"],
    );
    check(PARALLEL, &moved("1e6"), &["faces[0]", "too far"]);
}

#[test]
fn wrong_indices_are_placed_on_their_line() {
    let message = refusal(
        PERSPECTIVE,
        &format!("kind = \"mesh\"\n{TRIANGLE}faces = [[0, -1, 2]]"),
    );
    assert!(
        message.contains("demo.toml:") && message.contains("-1"),
        "{message}"
    );
    assert!(message.contains("not negative"), "{message}");
}

#[test]
fn tetrahedra_that_cannot_be() {
    let patch = |rest: &str| format!("kind = \"tetrahedron_patch\"\n{rest}");
    check(
        PERSPECTIVE,
        &patch(&format!("{CORNERS}weights = [1, 2, 3]")),
        &["`weights`, ten numbers", "3 numbers"],
    );
    check(
        PERSPECTIVE,
        &patch(WEIGHTS),
        &["needs", "`corners`, four points"],
    );
    check(
        PERSPECTIVE,
        &patch(&format!("corners = [[0, 0, 0]]\n{WEIGHTS}")),
        &["four points", "found 1 corners"],
    );
    check(
        PERSPECTIVE,
        &patch(&format!(
            "corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]\n{WEIGHTS}"
        )),
        &["corners", "one plane"],
    );
    check(
        PERSPECTIVE,
        &patch(&format!(
            "{CORNERS}weights = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"
        )),
        &["weights", "a plane"],
    );
    check(
        PERSPECTIVE,
        &patch(&format!("{CORNERS}{WEIGHTS}cuts = [{UP}]")),
        &["cuts", "faces of the tetrahedron"],
    );
    check(
        PERSPECTIVE,
        &patch(&format!("{CORNERS}{WEIGHTS}mode = \"solid\"")),
        &["is a surface", "mode = \"patch\""],
    );
    check(
        PERSPECTIVE,
        &patch(&format!(
            "{CORNERS}{WEIGHTS}processor = \"first_generation\""
        )),
        &[
            "processor",
            "does not draw a tetrahedral patch",
            "\"quadric\"",
        ],
    );
}

/// Objects beyond the words are refused with the word and its bits; nothing panics at the ends of what a file can hold.
#[test]
fn what_does_not_fit_is_refused_by_word() {
    let far = |kind: &str| {
        format!("{kind}\nplace = [{{ translate = [0, 0, -3000] }}, {{ scale = 1000 }}]")
    };
    let sphere = "kind = \"sphere\"\nradius = 3000\nprocessor = \"paraboloid\"";
    check(PARALLEL, sphere, &["too large for the format", "bits"]);
    check(
        STRAIGHT,
        &far("kind = \"mesh\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]"),
        &["too far outside the depth range"],
    );
    for scale in ["1e-12", "1e-6", "1e6", "1e12"] {
        let steps = vec![format!("{{ scale = {scale} }}"); 30].join(", ");
        let place = format!("place = [{steps}]\n");
        let objects = [
            (
                "kind = \"sphere\"\nradius = 1\nprocessor = \"paraboloid\"\n".to_owned(),
                PARALLEL,
            ),
            (
                format!(
                    "kind = \"elliptic_cylinder\"\nradii = [1, 1]\nprocessor = \"paraboloid\"\ncuts = [{UP}, {DOWN}]\n"
                ),
                PARALLEL,
            ),
            (
                "kind = \"sphere\"\nradius = 1\nmode = \"patch\"\nprocessor = \"curved_facet\"\n"
                    .to_owned(),
                PARALLEL,
            ),
            (
                format!("kind = \"mesh\"\n{TRIANGLE}faces = [[0, 1, 2]]\n"),
                PARALLEL,
            ),
            (
                format!("kind = \"mesh\"\n{TRIANGLE}faces = [[0, 1, 2]]\n"),
                PERSPECTIVE,
            ),
            (
                format!("kind = \"tetrahedron_patch\"\n{CORNERS}{WEIGHTS}"),
                PERSPECTIVE,
            ),
            (
                format!(
                    "kind = \"polyhedron\"\ncuts = [{UP}, {{ point = [0, 0, 1], normal = [0, 0, 1] }}]\n"
                ),
                PERSPECTIVE,
            ),
        ];
        for (keys, camera) in objects {
            let text = scene(camera, &format!("{keys}{place}"));
            let file = SceneFile::parse(&text, "demo.toml").expect("valid");
            for format in Format::CATALOGUE {
                if let Ok(framed) = file.frame(64, 48) {
                    // Drawn, left out with a note, or refused; never a panic.
                    if let Err(error) = prepare(&framed, Format::new(format).unwrap()) {
                        assert!(error.to_string().contains("thing"), "{error}");
                    }
                }
            }
        }
    }
}
