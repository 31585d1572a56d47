//! Refusals of processors that draw a quadric of a family.

use super::{PARALLEL, PERSPECTIVE, STRAIGHT, check_each, refusal};

#[test]
fn unknown_processor() {
    let message = refusal(PERSPECTIVE, "{SPHERE}processor = \"facet\"");
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
    check_each(
        PERSPECTIVE,
        r#"{SPHERE}processor = "patch" | processor | "patch" | solid | mode = "patch""#,
    );
}

#[test]
fn first_generation_with_other_cuts() {
    // In the fifth the viewer looks along the planes and stands between them. In the last he is inside the waist of
    // one sheet; between two sheets he would be outside of the solid.
    check_each(
        PERSPECTIVE,
        r#"
        {SPHERE}{FIRST}cuts = [{UP}] | cuts | 1 cuts | exactly two parallel cuts
        {SPHERE}{FIRST}cuts = [{UP}, {DOWN}, {DOWN}] | 3 cuts | exactly two parallel cuts
        {SPHERE}{FIRST}cuts = [{UP}, {UP}] | not parallel with opposite normals | exactly two parallel cuts
        {SPHERE}{FIRST}cuts = [{UP}, {SLANTED}] | not parallel | exactly two parallel cuts
        {SPHERE}{FIRST}cuts = [{UP}, {DOWN}] | first_generation | between its two planes | "quadric"
        {WAIST}{FIRST} | first_generation | inside the unbounded quadric
        "#,
    );
}

#[test]
fn paraboloids_that_cannot_be() {
    check_each(
        PERSPECTIVE,
        r#"{SPHERE}{PARABOLOID} | processor | "paraboloid" | perspective | orthographic"#,
    );
    check_each(
        PARALLEL,
        r#"
        {SPHERE}{PARABOLOID}mode = "patch" | "paraboloid" | patch | mode = "solid"
        {SPHERE}{PARABOLOID}cuts = [{UP}] | cuts | does not cut a sphere
        {SPHERE}{PARABOLOID}place = [{ scale = [1, 2, 1] }] | place | no longer a sphere | keep it round
        kind = "ellipsoid"\nradii = [1, 1, 1]\n{PARABOLOID} | spheres and circular cylinders only | kind = "sphere"
        kind = "elliptic_cylinder"\nradii = [1, 2]\n{PARABOLOID}cuts = [{UP}, {DOWN}] | place | not a right circular cylinder
        {CYLINDER}{PARABOLOID}cuts = [{UP}] | cuts | two ends | [0, 1, 0]
        {CYLINDER}{PARABOLOID}cuts = [{UP}, {SLANTED}] | across the axis
        {CYLINDER}{PARABOLOID}cuts = [{UP}, { point = [0, 0.5, 0], normal = [0, -1, 0] }] | leave nothing
        "#,
    );
    check_each(
        STRAIGHT,
        r#"
        {CYLINDER}{PARABOLOID}cuts = [{UP}, {DOWN}] | side-on | turn it
        {CYLINDER}{PARABOLOID}cuts = [{UP}, {DOWN}]\n{TURNED} | end-on | turn it
        "#,
    );
}

#[test]
fn curved_facets_that_cannot_be() {
    check_each(
        PERSPECTIVE,
        r#"{BOWL}mode = "patch" | "curved_facet" | perspective"#,
    );
    check_each(
        STRAIGHT,
        r#"
        {BOWL} | "curved_facet" | solid | mode = "patch"
        {BOWL}mode = "patch" | second degree | along its axis
        {BOWL}mode = "patch"\n{TURNED}cuts = [{UP}] | cuts[0] | perpendicular to the screen
        {BOWL}mode = "patch"\n{TURNED}cuts = [{SIDE}, {SIDE}, {SIDE}, {SIDE}, {SIDE}] | 5 cuts | at most 4 sides
        {SPHERE}mode = "patch"\nprocessor = "curved_facet"\ncuts = [{UP}] | cuts | outline
        {SPHERE}mode = "patch"\nprocessor = "curved_facet"\nplace = [{ scale = [1, 1, 2] }] | place | no longer a sphere
        "#,
    );
}
