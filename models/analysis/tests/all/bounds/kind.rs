use imogene_analysis::bounds::quadric_kind;
use imogene_scene::{Quadric, Shape, Transform};

#[test]
fn every_shape_of_scene_files_is_recognised_in_any_frame() {
    let r3 = [1.5, 2.0, 0.75];
    let r2 = [1.5, 2.0];
    let shapes = [
        (Shape::Ellipsoid { radii: r3 }, "ellipsoid"),
        (Shape::Sphere { radius: 2.0 }, "ellipsoid"),
        (Shape::EllipticCylinder { radii: r2 }, "elliptic_cylinder"),
        (
            Shape::HyperbolicCylinder { radii: r2 },
            "hyperbolic_cylinder",
        ),
        (Shape::ParabolicCylinder { radii: r2 }, "parabolic_cylinder"),
        (Shape::Cone { radii: r3 }, "cone"),
        (
            Shape::HyperboloidOneSheet { radii: r3 },
            "hyperboloid_one_sheet",
        ),
        (
            Shape::HyperboloidTwoSheets { radii: r3 },
            "hyperboloid_two_sheets",
        ),
        (
            Shape::EllipticParaboloid { radii: r3 },
            "elliptic_paraboloid",
        ),
        (
            Shape::HyperbolicParaboloid { radii: r3 },
            "hyperbolic_paraboloid",
        ),
    ];
    let turn = [[0.6, 0.8, 0.0], [-0.48, 0.36, 0.8], [0.64, -0.48, 0.6]];
    for (shape, name) in shapes {
        let quadric = Quadric::from_shape(&shape).expect("a quadric");
        assert_eq!(quadric_kind(&quadric), name);
        let moved = Transform::translation([3, -5, 7].map(imogene_algebra::rational::integer));
        let frame = Transform::linear(turn).after(&moved);
        assert_eq!(quadric_kind(&quadric.transformed(&frame)), name);
    }
}
