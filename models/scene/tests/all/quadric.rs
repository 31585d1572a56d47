use imogene_algebra::rational::integer;
use imogene_scene::{Axis, Plane, Quadric, Rotation, Scale, Step, Transform, WholeTransform};
use num_traits::Signed;
use proptest::prelude::*;

fn step() -> impl Strategy<Value = Step> {
    let decimal = || (-9999i32..9999).prop_map(|n| f64::from(n) / 1000.0);
    let factor = || prop_oneof![1i32..4000, -4000i32..-1].prop_map(|n| f64::from(n) / 1000.0);
    let vector = [decimal(), decimal(), decimal()];
    prop_oneof![
        vector.clone().prop_map(Step::Translate),
        [factor(), factor(), factor()].prop_map(|f| Step::Scale(Scale::PerAxis(f))),
        (vector, 0i32..360).prop_map(|([x, y, z], degrees)| {
            let axis = Axis::Vector([x, y, z + 20.0]);
            let degrees = f64::from(degrees);
            Step::Rotate(Rotation { axis, degrees })
        }),
    ]
}

proptest! {
    /// The image has at the image of a point the value of the original at the point, times det(M)^2 for a quadric
    /// and |det(M)| for a plane; the whole multiples become the same primitive ones.
    #[test]
    fn images_have_the_values_of_their_originals(
        steps in proptest::collection::vec(step(), 0..4), camera in proptest::collection::vec(step(), 0..3),
        q in proptest::collection::vec(-50i64..50, 10), p in proptest::array::uniform4(-50i64..50),
        at in proptest::array::uniform3(-20i64..20)
    ) {
        let camera = Transform::placement(&camera);
        let transform = camera.after(&Transform::placement(&steps));
        let determinant = transform.determinant();
        let at = at.map(integer);
        let [x, y, z] = transform.point(&at);
        let quadric = Quadric::from_array(std::array::from_fn(|k| integer(q[k]) / integer(7)));
        let image = quadric.transformed(&transform);
        let expected = quadric.value_at(&at[0], &at[1], &at[2]) * &determinant * &determinant;
        prop_assert_eq!(image.value_at(&x, &y, &z), expected);
        let [a, b, c, d] = p.map(integer);
        let plane = Plane { a, b, c, d };
        let cut = plane.transformed(&transform);
        prop_assert_eq!(cut.value_at(&x, &y, &z), plane.value_at(&at[0], &at[1], &at[2]) * determinant.abs());
        let inverse = WholeTransform::of_steps(&WholeTransform::new(&camera), &steps).inverse();
        prop_assert_eq!(quadric.transformed_whole(&inverse).primitive(), image.primitive());
        prop_assert_eq!(plane.transformed_whole(&inverse).primitive(), cut.primitive());
    }
}
