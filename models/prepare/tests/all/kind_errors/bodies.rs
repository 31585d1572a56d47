//! Refusals of polyhedra, meshes and tetrahedral patches.

use super::{PARALLEL, PERSPECTIVE, check_each, refusal};

#[test]
fn polyhedra_that_cannot_be() {
    check_each(
        PERSPECTIVE,
        r#"
        kind = "polyhedron" | cuts | without cuts | 1 to 12
        kind = "polyhedron"\nradii = [1, 1, 1]\ncuts = [{UP}] | no `radii` | `cuts`
        kind = "polyhedron"\nmode = "patch"\ncuts = [{UP}] | is a volume | mode = "solid"
        kind = "polyhedron"\nprocessor = "quadric"\ncuts = [{UP}] | processor | "quadric" | of its own
        "#,
    );
}

#[test]
fn meshes_that_cannot_be() {
    check_each(
        PERSPECTIVE,
        r#"
        {MESH}vertices = [[0, 0, 0], [1, 0, 0]]\nfaces = [[0, 1, 1]] | vertices: 2 | at least three
        {MESH}vertices = [[0, 0, 0], [1, 0], [0, 1, 0]]\nfaces = [[0, 1, 2]] | vertices[1] | 2 numbers | [x, y, z]
        {MESH}vertices = [[0, 0, 0], [1, 0, nan], [0, 1, 0]]\nfaces = [[0, 1, 2]] | vertices[1][2] | finite
        {MESH}faces = [[0, 1, 2]] | needs | `vertices` and `faces`
        {MESH}{TRIANGLE} | needs | `vertices` and `faces`
        {MESH}{TRIANGLE}faces = [] | faces | no face
        {MESH}{TRIANGLE}faces = [[0, 1]] | faces[0] | 2 corners | three or four
        {MESH}{TRIANGLE}faces = [[0, 1, 2], [0, 1, 4]] | faces[1] | vertex 4 | 0 to 3
        {MESH}{TRIANGLE}faces = [[0, 1, 1]] | faces[0] | twice
        {MESH}{TRIANGLE}faces = [[0, 1, 2, 3]] | faces[0] | no area | sides cross
        {MESH}vertices = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]\nfaces = [[0, 1, 2]] | faces[0] | no area
        {FACE}normals = [[0, 0, 1]] | normals | 1 normals for 4 vertices
        {FACE}normals = [[0, 0, 1], [0, 0, 0], [0, 0, 1], [0, 0, 1]] | normals[1] | no direction
        {FACE}cuts = [{UP}] | cuts | cannot be cut
        {FACE}mode = "solid" | no `mode`
        {FACE}processor = "patch" | processor | "patch" | of its own
        {FACE}radius = 1 | no `radius` | `vertices`
        {FACE}place = [{ translate = [0, 0, 10] }] | faces[0] | vertex 0 | not in front of the viewer
        {FACE}place = [{ translate = [0, 0, 11] }] | faces[0] | not in front of the viewer
        {FACE}place = [{ scale = 1e12 }] | faces[0] | too far beside the screen
        "#,
    );
    check_each(
        &format!("{PERSPECTIVE}near = 5\n"),
        "{FACE}place = [{ translate = [0, 0, 5.1] }] | faces[0] | nearer | near end",
    );
    check_each(
        PARALLEL,
        "{FACE}place = [{ translate = [0, 0, 1e6] }] | faces[0] | too far",
    );
}

#[test]
fn wrong_indices_are_placed_on_their_line() {
    let message = refusal(PERSPECTIVE, "{MESH}{TRIANGLE}faces = [[0, -1, 2]]");
    assert!(
        message.contains("demo.toml:") && message.contains("-1"),
        "{message}"
    );
    assert!(message.contains("not negative"), "{message}");
}

#[test]
fn tetrahedra_that_cannot_be() {
    check_each(
        PERSPECTIVE,
        r#"
        kind = "tetrahedron_patch"\n{CORNERS}weights = [1, 2, 3] | `weights`, ten numbers | 3 numbers
        kind = "tetrahedron_patch"\n{WEIGHTS} | needs | `corners`, four points
        kind = "tetrahedron_patch"\ncorners = [[0, 0, 0]]\n{WEIGHTS} | four points | found 1 corners
        kind = "tetrahedron_patch"\ncorners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]\n{WEIGHTS} | corners | one plane
        kind = "tetrahedron_patch"\n{CORNERS}weights = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1] | weights | a plane
        kind = "tetrahedron_patch"\n{CORNERS}{WEIGHTS}cuts = [{UP}] | cuts | faces of the tetrahedron
        kind = "tetrahedron_patch"\n{CORNERS}{WEIGHTS}mode = "solid" | is a surface | mode = "patch"
        kind = "tetrahedron_patch"\n{CORNERS}{WEIGHTS}processor = "first_generation" | processor | does not draw a tetrahedral patch | "quadric"
        "#,
    );
}
