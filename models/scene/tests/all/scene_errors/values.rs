//! Refusals of numbers and vectors.

use super::{GOOD, check_each, refused};
use imogene_prepare::Framing;
use imogene_scene::SceneFile;

#[test]
fn not_a_number_or_an_absurdly_large_one() {
    check_each(
        r#"
        radius = 1 | radius = nan | object `ball`, radius | NaN | finite number
        radius = 1 | radius = 1e300 | object `ball`, radius | 1e300 | 1e12
        eye = [0, 0, 10] | eye = [0, inf, 10] | camera.eye[1] | inf | finite number
        intensity = 1 | intensity = -inf | lights[0].intensity | -inf | finite number
        degrees = 30 | degrees = nan | object `ball`, place[1].rotate.degrees | NaN
        point = [0, 0.5, 0] | point = [0, nan, 0] | object `ball`, cuts[0].point[1] | NaN
        "#,
    );
}

#[test]
fn radius_not_positive() {
    check_each(
        r#"
        radius = 1 | radius = 0 | object `ball`, radius | 0 is not positive | above 0
        background = [0, 0, 0] | attenuation = -2 | attenuation | -2 is not positive | above 0
        kind = "sphere"\nradius = 1 | kind = "ellipsoid"\nradii = [1, -2, 3] | object `ball`, radii[1] | -2 is not positive | above 0
        "#,
    );
}

#[test]
fn zero_direction() {
    check_each(
        r#"
        normal = [0, 1, 0] | normal = [0, 0, 0] | object `ball`, cuts[0].normal | no direction
        from = [0, 1, 1] | from = [0, 0, 0] | lights[0].from | no direction
        axis = "y" | axis = [0, 0, 0] | object `ball`, place[1].rotate.axis | no direction
        up = [0, 1, 0] | up = [0, 0, 0] | camera.up | no direction
        "#,
    );
}

#[test]
fn singular_transform() {
    check_each(
        r#"
        scale = 2 | scale = 0 | object `ball`, place[0].scale | singular | other than 0
        scale = 2 | scale = [1, 0, 1] | object `ball`, place[0].scale | singular | other than 0
        "#,
    );
}

#[test]
fn out_of_range() {
    check_each(
        r#"
        colour = [0.8, 0.4, 0.3] | colour = [204, 102, 77] | material `clay`, colour[0] | 204 | 0 to 1 | 255
        background = [0, 0, 0] | background = [0, 0, -0.1] | background[2] | -0.1 | 0 to 1
        exponent = 20 | exponent = 0 | material `clay`, exponent | 0 is out of range | 1 to 200
        exponent = 20 | exponent = 201 | material `clay`, exponent | 201 | 1 to 200
        exponent = 20 | diffuse = 1.5 | material `clay`, diffuse | 1.5 | 0 to 1
        intensity = 1 | intensity = 11 | lights[0].intensity | 11 | 0 to 10
        "#,
    );
}

#[test]
fn quadric_without_second_degree() {
    check_each(
        r#"
        kind = "sphere"\nradius = 1 | kind = "quadric"\ncoefficients = [0, 0, 0, 0, 0, 0, 0, 0, 0, 0] | object `ball`, coefficients | all ten are zero | a to f
        kind = "sphere"\nradius = 1 | kind = "quadric"\ncoefficients = [0, 0, 0, 0, 0, 0, 1, 2, 3, 4] | object `ball`, coefficients | leaves a plane | a to f
        kind = "sphere"\nradius = 1 | kind = "quadric"\ncoefficients = [1, 1, 1] | object `ball` | the ten numbers a to j | found 3 numbers
        "#,
    );
    // As a surface with cuts, of which the good scene has one, it is a part of a plane; without cuts it is endless.
    let sphere = "kind = \"sphere\"\nradius = 1";
    let surface = |coefficients: &str| {
        let new = format!("kind = \"quadric\"\ncoefficients = {coefficients}\nmode = \"patch\"");
        GOOD.replacen(sphere, &new, 1)
    };
    let plane = surface("[0, 0, 0, 0, 0, 0, 1, 2, 3, 4]");
    assert!(SceneFile::parse(&plane, "demo.toml").is_ok());
    let uncut: Vec<&str> = plane.lines().filter(|l| !l.starts_with("cuts")).collect();
    refused(
        &uncut.join("\n"),
        "object `ball`, coefficients | leaves a plane",
    );
    refused(
        &surface("[0, 0, 0, 0, 0, 0, 0, 0, 0, 4]"),
        "object `ball`, coefficients | all but j are zero",
    );
}

#[test]
fn image_size() {
    check_each(
        r#"
        width = 64 | width = 0 | image.width | 0 pixels | 1 to 4096
        height = 48 | height = 4097 | image.height | 4097 pixels | 1 to 4096
        "#,
    );
    let scene = SceneFile::parse(GOOD, "demo.toml").expect("a good scene");
    let message = scene.frame(5000, 10).expect_err("too wide").to_string();
    assert!(message.contains("image.width: 5000 pixels"), "{message}");
}
