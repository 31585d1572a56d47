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

struct Case<'a> {
    scene: String,
    format: Format,
    options: Options,
    /// What the message advises, and the change of the text that follows it.
    remedies: Vec<(&'a str, &'a str, &'a str)>,
}

fn prepared(text: &str, format: Format, options: Options) -> Result<PreparedScene, PrepareError> {
    let scene = SceneFile::parse(text, "t.toml").unwrap_or_else(|error| panic!("{error}\n{text}"));
    let framed = scene.frame(64, 48).expect("framed");
    prepare_with(&framed, format, options)
}

impl Case<'_> {
    fn of(scene: String) -> Case<'static> {
        Case {
            scene,
            format: Format::BASE,
            options: Options::default(),
            remedies: vec![],
        }
    }

    /// The refusal; each remedy that it names is applied.
    fn check(&self) -> String {
        let refusal =
            prepared(&self.scene, self.format, self.options).expect_err("must be refused");
        let message = refusal.to_string();
        for (advice, before, after) in &self.remedies {
            assert!(message.contains(advice), "no `{advice}` in: {message}");
            assert!(self.scene.contains(before), "no `{before}` to change");
            let changed = self.scene.replace(before, after);
            let drawn = prepared(&changed, self.format, self.options);
            assert!(drawn.is_ok(), "{advice}: {}", drawn.unwrap_err());
        }
        message
    }
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
        let case = Case {
            options: Options::ROOTS,
            ..Case::of(scene.clone())
        };
        let message = case.check();
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
    let message = Case {
        options: Options::ROOTS,
        ..Case::of(scene.clone())
    }
    .check();
    let (near, far) = (
        between(&message, "`near = ", "`"),
        between(&message, "`far = ", "`"),
    );
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
        let remedies = vec![
            ("`shadows = false`", "\nshadows = true", "\nshadows = false"),
            (
                "`casts_shadow = false`",
                "casts_shadow = true",
                "casts_shadow = false",
            ),
        ];
        let case = Case {
            remedies,
            ..Case::of(casting)
        };
        let message = case.check();
        assert!(message.contains(problem), "{message}");
    }
}

#[test]
fn a_light_within_a_solid() {
    let lamp = "[[lights]]\nkind = \"point\"\nposition = [0, 0.5, 0]\nshadows = true\n";
    let remedies = vec![
        ("move the light out of it", "[0, 0.5, 0]", "[0, 5, 0]"),
        (
            "`casts_shadow = false`",
            "radius = 1",
            "radius = 1\ncasts_shadow = false",
        ),
    ];
    Case {
        remedies,
        ..Case::of(text(PERSPECTIVE, lamp, SPHERE))
    }
    .check();
}

#[test]
fn a_plane_that_passes_through_the_eye() {
    let object = "kind = \"sphere\"\nradius = 1\ncuts = [{ point = [0, 0, 0], normal = [100000, 0, -1] }]\nplace = [{ translate = [0, 0, -3] }]\n";
    let remedies = vec![(
        "turn the plane by a degree",
        "[100000, 0, -1]",
        "[100000, 0, -1745]",
    )];
    Case {
        remedies,
        ..Case::of(text(&PERSPECTIVE.replace("near = 5\n", ""), "", object))
    }
    .check();
}

#[test]
fn the_first_generation_and_fitted_machines() {
    let cylinder = "kind = \"elliptic_cylinder\"\nradii = [1, 1]\nprocessor = \"first_generation\"\n\
        cuts = [{ point = [0, 1, 0], normal = [0, 1, 0] }, { point = [0, -1, 0], normal = [0, -1, 0] }]\n";
    // Both planes are seen edge-on, or the viewer is between them.
    let remedies = vec![(
        "the processor \"quadric\" draws it",
        "\"first_generation\"",
        "\"quadric\"",
    )];
    Case {
        remedies,
        ..Case::of(text(PERSPECTIVE, "", cylinder))
    }
    .check();
    let widths = MachineWords {
        plane: 30,
        ..Format::BASE.widths()
    };
    let mesh =
        "kind = \"mesh\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]]\n";
    let scene = text(PERSPECTIVE, "", mesh);
    let fitted = Format::fitted(&widths).expect("a machine");
    let message = Case {
        format: fitted,
        ..Case::of(scene.clone())
    }
    .check();
    assert!(
        message.contains("follow from the depth word; give --format"),
        "{message}"
    );
    prepared(&scene, Format::BASE, Options::default()).expect("of the catalogue");
}

#[test]
fn a_face_of_a_mesh_behind_the_viewer() {
    let mesh = "kind = \"mesh\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 20]]\nfaces = [[0, 1, 2], [1, 2, 3]]\n";
    let remedies = vec![
        ("leave the face out", ", [1, 2, 3]]", "]"),
        (
            "move the mesh",
            "vertices",
            "place = [{ translate = [0, 0, -15] }]\nvertices",
        ),
    ];
    Case {
        remedies,
        ..Case::of(text(&PERSPECTIVE.replace("near = 5\n", ""), "", mesh))
    }
    .check();
}
