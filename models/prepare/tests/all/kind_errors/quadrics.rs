//! Refusals of processors that draw a quadric of a family.

use super::{DOWN, PARALLEL, PERSPECTIVE, STRAIGHT, UP, check, refusal};

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
