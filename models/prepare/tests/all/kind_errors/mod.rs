//! Every refusal of a kind, a processor or a mesh says what is wrong, where, and what would be accepted.

mod bodies;
mod quadrics;

use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_scene::SceneFile;

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
