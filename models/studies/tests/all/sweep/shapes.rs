use imogene_algebra::rational::{integer, power_of_two};
use imogene_golden::format::Format;
use imogene_prepare::Framing;
use imogene_scene::FramedObject;
use imogene_studies::sweep::find;
use num_rational::BigRational;

/// The plane, in camera pixels, is where the sweep says it is: at `R (1 - 2^-k)` from the centre, R = 2048 pixels.
#[test]
fn the_cap_is_as_thick_as_it_says() {
    let sweep = find("tangent-plane").expect("a sweep");
    let scenes = sweep.scenes(Format::BASE).into_iter();
    let removed = scenes.filter(|(series, ..)| *series == sweep.series[0]);
    let mut tried = 0;
    for (_, k, file) in removed {
        let scene = file.frame(96, 72).expect("valid");
        let FramedObject::Quadric(ball) = &scene.objects[0] else {
            panic!("a quadric");
        };
        let plane = &ball.planes[0];
        // The point of contact is the origin.
        let beyond = plane.value_at(&integer(0), &integer(0), &integer(0));
        let square = [&plane.a, &plane.b, &plane.c].map(|v| v * v);
        let length = square.iter().sum::<BigRational>();
        let thickness = integer(2048) / power_of_two(k.parse().expect("an exponent"));
        let square = &thickness * &thickness * length;
        assert_eq!(&beyond * &beyond, square, "k = {k}");
        assert!(beyond > integer(0));
        tried += 1;
    }
    assert_eq!(tried, 21);
}
