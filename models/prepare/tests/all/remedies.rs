//! Every remedy that a refusal of the preparation names is applied, and the scene is then drawn.

use imogene_contract::MachineWords;
use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::error::PrepareError;
use imogene_prepare::{Options, PreparedScene, prepare_with};
use imogene_scene::SceneFile;

const PERSPECTIVE: &str = "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nviewer_distance = 10\nview_height = 4\nnear = 5\n";
const PARALLEL: &str = "kind = \"orthographic\"\neye = [4, -2, 5]\ntarget = [0, 0, 0]\nview_height = 3\nnear = -1\nfar = 1\n";
const SPHERE: &str = "kind = \"sphere\"\nradius = 1\n";
const BOX: &str = "cuts = [{ point = [1, 0, 0], normal = [1, 0, 0] }, { point = [-1, 0, 0], normal = [-1, 0, 0] }, \
    { point = [0, 1, 0], normal = [0, 1, 0] }, { point = [0, -1, 0], normal = [0, -1, 0] }, \
    { point = [0, 0, 1], normal = [0, 0, 1] }, { point = [0, 0, -1], normal = [0, 0, -1] }]\n";

/// A scene of one object, with lights before it.
fn text(camera: &str, lights: &str, object: &str) -> String {
    format!(
        "format = 1\ntitle = \"t\"\nimage = {{ width = 64, height = 48 }}\n[camera]\n{camera}{lights}\n\
         [[materials]]\nname = \"m\"\ncolour = [1, 1, 1]\n[[objects]]\nname = \"a\"\nmaterial = \"m\"\n{object}"
    )
}

fn prepared(text: &str, format: Format, options: Options) -> Result<PreparedScene, PrepareError> {
    let scene = SceneFile::parse(text, "t.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let framed = scene.frame(64, 48).expect("framed");
    prepare_with(&framed, format, options)
}

/// The refusal of a scene. Of each remedy it has what the message advises, and the change of the text that follows it,
/// with which the scene is prepared.
fn refused(scene: &str, remedies: &[[&str; 3]]) -> String {
    refused_in(scene, Format::BASE, Options::default(), remedies)
}

fn refused_in(scene: &str, format: Format, options: Options, remedies: &[[&str; 3]]) -> String {
    let refusal = prepared(scene, format, options).expect_err("must be refused");
    let message = refusal.to_string();
    for [advice, before, after] in remedies {
        assert!(message.contains(advice), "no `{advice}` in: {message}");
        assert!(scene.contains(before), "no `{before}` to change");
        let drawn = prepared(&scene.replace(before, after), format, options);
        assert!(drawn.is_ok(), "{advice}: {}", drawn.unwrap_err());
    }
    message
}

/// The text between two others.
fn between<'a>(message: &'a str, before: &str, after: &str) -> &'a str {
    let (_, rest) = message
        .split_once(before)
        .unwrap_or_else(|| panic!("{message}"));
    rest.split_once(after).expect("an end").0
}

#[test]
fn the_range_that_would_do_does() {
    for distance in ["1.3", "1.01", "1.00001"] {
        let camera = PERSPECTIVE
            .replace("[0, 0, 10]", &format!("[0, 0, {distance}]"))
            .replace("near = 5", "near = 1");
        let scene = text(&camera, "", &format!("{SPHERE}mode = \"patch\"\n"));
        let message = refused_in(&scene, Format::BASE, Options::ROOTS, &[]);
        let near = between(&message, "`near = ", "`");
        let changed = scene.replace("near = 1", &format!("near = {near}"));
        prepared(&changed, Format::BASE, Options::ROOTS).expect("the range that would do");
    }
    let saddle = format!("kind = \"hyperbolic_paraboloid\"\nradii = [1, 1, 1]\n{BOX}");
    let scene = text(
        &PARALLEL.replace("-1\nfar = 1", "-0.01\nfar = 0.01"),
        "",
        &saddle,
    );
    let message = refused_in(&scene, Format::BASE, Options::ROOTS, &[]);
    let [near, far] = ["`near = ", "`far = "].map(|key| between(&message, key, "`"));
    let changed = scene.replace(
        "near = -0.01\nfar = 0.01",
        &format!("near = {near}\nfar = {far}"),
    );
    prepared(&changed, Format::BASE, Options::ROOTS).expect("the range that would do");
}

#[test]
fn volumes_that_are_left_out() {
    let light = |lamp: &str| format!("[[lights]]\n{lamp}\nshadows = true\n");
    let beside = |x: &str| {
        let camera = PERSPECTIVE.replace("eye = [0", &format!("eye = [{x}"));
        let sun = light("kind = \"directional\"\nfrom = [0, 0, 1]");
        text(&camera, &sun, SPHERE)
    };
    // The shadow is a cylinder along the view, and the eye on it or very nearly; and a box whose edge, light and eye
    // have nearly a plane in common, which passes
    // the pixels of the middle column.
    let lamp = light("kind = \"point\"\nposition = [0.000001, 0.3, 9]");
    let from_the_middle = BOX.replace("point = [-1, 0, 0]", "point = [0, 0, 0]");
    let block = text(
        PERSPECTIVE,
        &lamp,
        &format!("kind = \"polyhedron\"\n{from_the_middle}"),
    );
    for (scene, problem) in [
        (beside("1"), "exactly on its surface"),
        (beside("1.0000000001"), "too large for the format"),
        (block, "passes so nearly through the viewer"),
    ] {
        let casting = scene.replace("material = \"m\"", "material = \"m\"\ncasts_shadow = true");
        let remedies = [
            ["`shadows = false`", "\nshadows = true", "\nshadows = false"],
            [
                "`casts_shadow = false`",
                "casts_shadow = true",
                "casts_shadow = false",
            ],
        ];
        let message = refused(&casting, &remedies);
        assert!(message.contains(problem), "{message}");
    }
}

#[test]
fn a_light_within_a_solid() {
    let lamp = "[[lights]]\nkind = \"point\"\nposition = [0, 0.5, 0]\nshadows = true\n";
    let unlit = "radius = 1\ncasts_shadow = false";
    let remedies = [
        ["move the light out of it", "[0, 0.5, 0]", "[0, 5, 0]"],
        ["`casts_shadow = false`", "radius = 1", unlit],
    ];
    refused(&text(PERSPECTIVE, lamp, SPHERE), &remedies);
}

#[test]
fn a_plane_that_passes_through_the_eye() {
    let object = "kind = \"sphere\"\nradius = 1\ncuts = [{ point = [0, 0, 0], normal = [100000, 0, -1] }]\nplace = [{ translate = [0, 0, -3] }]\n";
    let scene = text(&PERSPECTIVE.replace("near = 5\n", ""), "", object);
    let turned = "[100000, 0, -1745]";
    let remedy = ["turn the plane by a degree", "[100000, 0, -1]", turned];
    refused(&scene, &[remedy]);
}

#[test]
fn the_first_generation_and_fitted_machines() {
    let cylinder = "kind = \"elliptic_cylinder\"\nradii = [1, 1]\nprocessor = \"first_generation\"\n\
        cuts = [{ point = [0, 1, 0], normal = [0, 1, 0] }, { point = [0, -1, 0], normal = [0, -1, 0] }]\n";
    // Both planes are seen edge-on, or the viewer is between them.
    let advice = "the processor \"quadric\" draws it";
    let remedy = [advice, "\"first_generation\"", "\"quadric\""];
    refused(&text(PERSPECTIVE, "", cylinder), &[remedy]);
    let widths = MachineWords {
        plane: 30,
        ..Format::BASE.widths()
    };
    let mesh =
        "kind = \"mesh\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\n";
    let scene = text(PERSPECTIVE, "", mesh);
    let fitted = Format::fitted(&widths).expect("a machine");
    let message = refused_in(&scene, fitted, Options::default(), &[]);
    let advice = "follow from the depth word; give --format";
    assert!(message.contains(advice), "{message}");
    prepared(&scene, Format::BASE, Options::default()).expect("of the catalogue");
}

#[test]
fn a_face_of_a_mesh_behind_the_viewer() {
    let mesh = "kind = \"mesh\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 20]]\nfaces = [[0, 1, 2], [1, 2, 3]]\n";
    let moved = "place = [{ translate = [0, 0, -15] }]\nvertices";
    let remedies = [
        ["leave the face out", ", [1, 2, 3]]", "]"],
        ["move the mesh", "vertices", moved],
    ];
    let scene = text(&PERSPECTIVE.replace("near = 5\n", ""), "", mesh);
    refused(&scene, &remedies);
}
