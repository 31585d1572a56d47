//! Refusals of polyhedra, meshes and tetrahedral patches.

use super::{CORNERS, PARALLEL, PERSPECTIVE, TRIANGLE, UP, WEIGHTS, check, refusal};

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
}

#[test]
fn meshes_that_cannot_be() {
    let mesh = |rest: &str| format!("kind = \"mesh\"\n{rest}");
    let faces = |list: &str| format!("kind = \"mesh\"\n{TRIANGLE}faces = {list}");
    check(
        PERSPECTIVE,
        &mesh("vertices = [[0, 0, 0], [1, 0, 0]]\nfaces = [[0, 1, 1]]"),
        &["vertices: 2", "at least three"],
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
        &format!("{PERSPECTIVE}near = 5\n"),
        &moved("5.1"),
        &["faces[0]", "nearer", "near end"],
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
