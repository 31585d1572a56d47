use imogene_analysis::bounds::quadric_kind;
use imogene_scene::{Quadric, Shape, Transform};

#[test]
fn every_shape_of_scene_files_is_recognised_in_any_frame() {
    let r3 = [1.5, 2.0, 0.75];
    let r2 = [1.5, 2.0];
    let shapes = [
        (Shape::Ellipsoid(r3), "ellipsoid"),
        (Shape::Sphere { radius: 2.0 }, "ellipsoid"),
        (Shape::EllipticCylinder(r2), "elliptic_cylinder"),
        (Shape::HyperbolicCylinder(r2), "hyperbolic_cylinder"),
        (Shape::ParabolicCylinder(r2), "parabolic_cylinder"),
        (Shape::Cone(r3), "cone"),
        (Shape::HyperboloidOneSheet(r3), "hyperboloid_one_sheet"),
        (Shape::HyperboloidTwoSheets(r3), "hyperboloid_two_sheets"),
        (Shape::EllipticParaboloid(r3), "elliptic_paraboloid"),
        (Shape::HyperbolicParaboloid(r3), "hyperbolic_paraboloid"),
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
