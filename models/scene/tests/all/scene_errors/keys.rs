//! Refusals of keys, types and kinds.

use super::check;

#[test]
fn unknown_key() {
    check(
        "radius = 1",
        "radios = 1",
        &["demo.toml:", "unknown field `radios`", "`radius`"],
    );
    check(
        "title =",
        "titel =",
        &["demo.toml:2:1:", "unknown field `titel`", "`title`"],
    );
    check(
        "eye =",
        "eyes =",
        &["demo.toml:", "unknown field `eyes`", "`eye`"],
    );
    check(
        "colour = [0.8",
        "color = [0.8",
        &["demo.toml:23:1:", "unknown field `color`", "`colour`"],
    );
    check(
        "{ scale = 2 }",
        "{ skale = 2 }",
        &["demo.toml:31:", "unknown field `skale`", "`scale`"],
    );
    check("from =", "form =", &["unknown field `form`", "`from`"]);
    check(
        ", height = 48",
        ", heigth = 48",
        &["demo.toml:5:", "unknown field `heigth`", "`height`"],
    );
}

#[test]
fn missing_key() {
    check("view_height = 4\n", "", &["missing field `view_height`"]);
    check(
        "radius = 1\n",
        "",
        &["object `ball`", "needs `radius`, one number"],
    );
    check(
        "viewer_distance = 10\n",
        "",
        &["missing field `viewer_distance`", "`field_of_view`"],
    );
    check(
        "from = [0, 1, 1]\n",
        "",
        &["a directional light needs `from`"],
    );
}

#[test]
fn key_of_another_kind() {
    check(
        "radius = 1",
        "radii = [1, 1, 1]",
        &["object `ball`", "no `radii`", "it takes `radius`"],
    );
    check(
        "kind = \"directional\"",
        "kind = \"point\"",
        &["a point light has no `from`", "`position`"],
    );
    check(
        "viewer_distance = 10",
        "half_depth = 10",
        &[
            "a perspective camera has no `half_depth`",
            "`viewer_distance`",
        ],
    );
}

#[test]
fn wrong_type() {
    check(
        "radius = 1",
        "radius = \"big\"",
        &["demo.toml:29:10:", "string \"big\"", "expected a number"],
    );
    check(
        "eye = [0, 0, 10]",
        "eye = [0, 10]",
        &["demo.toml:9:", "2 numbers found", "3 numbers"],
    );
    check(
        "eye = [0, 0, 10]",
        "eye = [0, 0, 10, 1]",
        &["demo.toml:9:", "4 numbers found", "3 numbers"],
    );
    check(
        "eye = [0, 0, 10]",
        "eye = 10",
        &["demo.toml:9:", "integer `10`", "array of numbers"],
    );
    check(
        "width = 64",
        "width = -64",
        &["demo.toml:5:", "-64", "a whole number"],
    );
    check(
        "exponent = 20",
        "exponent = 20.5",
        &["20.5", "a whole number"],
    );
    check(
        "{ scale = 2 }",
        "{ scale = [2, 2] }",
        &["2 numbers found", "one number or [x, y, z]"],
    );
    check(
        "axis = \"y\"",
        "axis = \"w\"",
        &["\"w\"", "\"x\", \"y\", \"z\" or a vector"],
    );
}

#[test]
fn steps_are_one_to_a_table() {
    check(
        "{ scale = 2 }",
        "{ scale = 2, translate = [1, 0, 0] }",
        &["demo.toml:31:", "several steps in one table", "its own { }"],
    );
    check(
        "{ scale = 2 }",
        "{}",
        &[
            "demo.toml:31:",
            "the step is empty",
            "`translate`, `rotate`, `scale`",
        ],
    );
}

#[test]
fn radii_of_the_wrong_length() {
    check(
        "kind = \"sphere\"\nradius = 1",
        "kind = \"elliptic_cylinder\"\nradii = [1, 2, 3]",
        &[
            "object `ball`",
            "the two numbers A and C",
            "found 3 numbers",
        ],
    );
}

#[test]
fn unknown_kind() {
    check(
        "kind = \"sphere\"",
        "kind = \"torus\"",
        &["unknown variant `torus`", "`sphere`", "`cone`"],
    );
    check(
        "kind = \"perspective\"",
        "kind = \"fisheye\"",
        &["unknown variant `fisheye`", "`orthographic`"],
    );
}
