//! Refusals of keys, types and kinds.

use super::check_each;

#[test]
fn unknown_key() {
    check_each(
        r#"
        radius = 1 | radios = 1 | demo.toml: | unknown field `radios` | `radius`
        title = | titel = | demo.toml:2:1: | unknown field `titel` | `title`
        eye = | eyes = | demo.toml: | unknown field `eyes` | `eye`
        colour = [0.8 | color = [0.8 | demo.toml:23:1: | unknown field `color` | `colour`
        { scale = 2 } | { skale = 2 } | demo.toml:31: | unknown field `skale` | `scale`
        from = | form = | unknown field `form` | `from`
        , height = 48 | , heigth = 48 | demo.toml:5: | unknown field `heigth` | `height`
        "#,
    );
}

#[test]
fn missing_key() {
    check_each(
        r#"
        view_height = 4\n | | missing field `view_height`
        radius = 1\n | | object `ball` | needs `radius`, one number
        viewer_distance = 10\n | | missing field `viewer_distance` | `field_of_view`
        from = [0, 1, 1]\n | | a directional light needs `from`
        "#,
    );
}

#[test]
fn key_of_another_kind() {
    check_each(
        r#"
        radius = 1 | radii = [1, 1, 1] | object `ball` | no `radii` | it takes `radius`
        kind = "directional" | kind = "point" | a point light has no `from` | `position`
        viewer_distance = 10 | half_depth = 10 | a perspective camera has no `half_depth` | `viewer_distance`
        "#,
    );
}

#[test]
fn wrong_type() {
    check_each(
        r#"
        radius = 1 | radius = "big" | demo.toml:29:10: | string "big" | expected a number
        eye = [0, 0, 10] | eye = [0, 10] | demo.toml:9: | 2 numbers found | 3 numbers
        eye = [0, 0, 10] | eye = [0, 0, 10, 1] | demo.toml:9: | 4 numbers found | 3 numbers
        eye = [0, 0, 10] | eye = 10 | demo.toml:9: | integer `10` | array of numbers
        width = 64 | width = -64 | demo.toml:5: | -64 | a whole number
        exponent = 20 | exponent = 20.5 | 20.5 | a whole number
        { scale = 2 } | { scale = [2, 2] } | 2 numbers found | one number or [x, y, z]
        axis = "y" | axis = "w" | "w" | "x", "y", "z" or a vector
        kind = "sphere"\nradius = 1 | kind = "elliptic_cylinder"\nradii = [1, 2, 3] | `ball` | the two numbers A and C | found 3 numbers
        "#,
    );
}

#[test]
fn steps_are_one_to_a_table() {
    check_each(
        r#"
        { scale = 2 } | { scale = 2, translate = [1, 0, 0] } | demo.toml:31: | several steps in one table | its own { }
        { scale = 2 } | {} | demo.toml:31: | the step is empty | `translate`, `rotate`, `scale`
        "#,
    );
}

#[test]
fn unknown_kind() {
    check_each(
        r#"
        kind = "sphere" | kind = "torus" | unknown variant `torus` | `sphere` | `cone`
        kind = "perspective" | kind = "fisheye" | unknown variant `fisheye` | `orthographic`
        "#,
    );
}
