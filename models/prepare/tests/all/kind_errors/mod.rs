//! Every refusal of a kind, a processor or a mesh says what is wrong, where, and what would be accepted.

mod bodies;
mod quadrics;

use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_prepare::prepare;
use imogene_scene::SceneFile;
use imogene_testkit::rows;

const PERSPECTIVE: &str = "kind = \"perspective\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nviewer_distance = 10\nview_height = 4\n";
const PARALLEL: &str = "kind = \"orthographic\"\neye = [3, 4, 10]\ntarget = [0, 0, 0]\nview_height = 4\nhalf_depth = 4\n";
const STRAIGHT: &str = "kind = \"orthographic\"\neye = [0, 0, 10]\ntarget = [0, 0, 0]\nview_height = 4\nhalf_depth = 4\n";

/// What stands for longer keys in the tables.
const SHORT: [(&str, &str); 16] = [
    ("{UP}", "{ point = [0, 0.5, 0], normal = [0, 1, 0] }"),
    ("{DOWN}", "{ point = [0, -0.5, 0], normal = [0, -1, 0] }"),
    (
        "{SLANTED}",
        "{ point = [0, -0.5, 0], normal = [0.1, -1, 0] }",
    ),
    ("{SIDE}", "{ point = [1, 0, 0], normal = [1, 0, 0] }"),
    (
        "{TURNED}",
        "place = [{ rotate = { axis = \"x\", degrees = 90 } }]\n",
    ),
    ("{FIRST}", "processor = \"first_generation\"\n"),
    ("{PARABOLOID}", "processor = \"paraboloid\"\n"),
    ("{SPHERE}", "kind = \"sphere\"\nradius = 1\n"),
    (
        "{CYLINDER}",
        "kind = \"elliptic_cylinder\"\nradii = [1, 1]\n",
    ),
    (
        "{WAIST}",
        "kind = \"hyperboloid_one_sheet\"\nradii = [1, 1, 1]\nplace = [{ scale = 30 }, { translate = [0, 0, 10] }]\n\
         cuts = [{ point = [0, -0.1, 0], normal = [0, 1, 0] }, { point = [0, -0.2, 0], normal = [0, -1, 0] }]\n",
    ),
    (
        "{BOWL}",
        "kind = \"elliptic_paraboloid\"\nradii = [1, 1, 1]\nprocessor = \"curved_facet\"\n",
    ),
    ("{FACE}", "{MESH}{TRIANGLE}faces = [[0, 1, 2]]\n"),
    ("{MESH}", "kind = \"mesh\"\n"),
    (
        "{TRIANGLE}",
        "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]\n",
    ),
    (
        "{CORNERS}",
        "corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n",
    ),
    (
        "{WEIGHTS}",
        "weights = [-1, 1, 1, 1, -1, -1, -1, -1, -1, -1]\n",
    ),
];

/// The keys of an object with all that is short in them.
fn full(keys: &str) -> String {
    let replaced = |text: String, (short, long): &(&str, &str)| text.replace(short, long);
    SHORT.iter().fold(keys.replace("\\n", "\n"), replaced)
}

fn scene(camera: &str, keys: &str) -> String {
    format!(
        "format = 1\ntitle = \"test\"\nimage = {{ width = 64, height = 48 }}\n[camera]\n{camera}\
         [[materials]]\nname = \"clay\"\ncolour = [0.8, 0.4, 0.3]\n\
         [[objects]]\nname = \"thing\"\nmaterial = \"clay\"\n{}\n",
        full(keys)
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

/// A row has the keys of an object and the parts of the message.
fn check_each(camera: &str, table: &str) {
    for row in rows(table) {
        let message = refusal(camera, row[0]);
        for part in row[1..].iter().chain(&["thing"]) {
            assert!(message.contains(part), "`{part}` is missing in: {message}");
        }
    }
}

fn accept_each(camera: &str, table: &str) {
    for row in rows(table) {
        let file = SceneFile::parse(&scene(camera, row[0]), "demo.toml").expect("valid");
        let framed = file.frame(64, 48).expect("framed");
        prepare(&framed, Format::BASE).expect("fits");
        let written = file.to_toml().expect("can be written");
        assert_eq!(SceneFile::parse(&written, "written").expect("valid"), file);
    }
}

#[test]
fn good_ones_are_accepted_and_written() {
    accept_each(
        PERSPECTIVE,
        r#"
        {SPHERE}mode = "patch"\nprocessor = "patch"
        kind = "polyhedron"\ncuts = [{UP}, { point = [0, 0, 1], normal = [0, 0, 1] }]
        {MESH}{TRIANGLE}faces = [[0, 1, 2], [0, 1, 3, 2]]
        {FACE}normals = [[0, 0, 1], [0, 1, 1], [1, 0, 1], [0, 0, 2]]
        kind = "tetrahedron_patch"\n{CORNERS}{WEIGHTS}
        kind = "tetrahedron_patch"\nmode = "patch"\nprocessor = "quadric"\n{CORNERS}{WEIGHTS}
        {SPHERE}{FIRST}cuts = [{UP}, {DOWN}]\nplace = [{ rotate = { axis = "x", degrees = 60 } }]
        "#,
    );
    accept_each(
        PARALLEL,
        r#"
        {SPHERE}{PARABOLOID}place = [{ scale = [2, -2, 2] }, { rotate = { axis = [1, 2, 3], degrees = 33 } }]
        {CYLINDER}{PARABOLOID}cuts = [{DOWN}, {UP}]
        {SPHERE}mode = "patch"\nprocessor = "curved_facet"
        "#,
    );
}

/// Objects beyond the words are refused with the word and its bits; nothing panics at the ends of what a file can hold.
#[test]
fn what_does_not_fit_is_refused_by_word() {
    check_each(
        PARALLEL,
        r#"kind = "sphere"\nradius = 3000\n{PARABOLOID} | too large for the format | bits"#,
    );
    check_each(
        STRAIGHT,
        "{FACE}place = [{ translate = [0, 0, -3000] }, { scale = 1000 }] | too far outside the depth range",
    );
    for scale in ["1e-12", "1e-6", "1e6", "1e12"] {
        let steps = vec![format!("{{ scale = {scale} }}"); 30].join(", ");
        let place = format!("place = [{steps}]\n");
        let parallel = r#"
            {SPHERE}{PARABOLOID}
            {CYLINDER}{PARABOLOID}cuts = [{UP}, {DOWN}]\n
            {SPHERE}mode = "patch"\nprocessor = "curved_facet"\n
            {FACE}
            "#;
        let perspective = r#"
            {FACE}
            kind = "tetrahedron_patch"\n{CORNERS}{WEIGHTS}
            kind = "polyhedron"\ncuts = [{UP}, { point = [0, 0, 1], normal = [0, 0, 1] }]\n
            "#;
        let parallel = rows(parallel).map(|row| (row[0], PARALLEL));
        let perspective = rows(perspective).map(|row| (row[0], PERSPECTIVE));
        for (keys, camera) in parallel.chain(perspective) {
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
