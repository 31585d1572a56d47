use imogene_algebra::vector::{cross, dot, minus, normalised};

#[test]
fn products_of_vectors() {
    let (u, v) = ([1.0, 2.0, 3.0], [4.0, -5.0, 6.0]);
    assert_eq!(dot(u, v), 12.0);
    assert_eq!(cross(u, v), [27.0, 6.0, -13.0]);
    assert_eq!(minus([5i64, 1], [2, 3]), [3, -2]);
    assert_eq!(normalised([0.0, 3e200, 4e200]), [0.0, 0.6, 0.8]);
}
