use imogene_algebra::matrix::{cofactors3, cofactors4, image, product, transposed};
use imogene_algebra::vector::dot;
use std::array::from_fn;

#[test]
fn cofactors_times_the_transpose_are_the_determinant() {
    let m = [[2, 1, 0, 3], [1, -4, 2, 0], [0, 5, 1, 1], [7, 0, 2, -1]];
    let whole = product(&m, &transposed(&cofactors4(&m)));
    // By Leibniz' formula.
    let determinant = 297;
    assert_eq!(
        whole,
        from_fn(|i| from_fn(|j| if i == j { determinant } else { 0 }))
    );
    let n = [[2, 1, 0], [1, -4, 2], [0, 5, 1]];
    let cofactors = cofactors3(&n);
    assert_eq!(cofactors[0], [-14, -1, 5]);
    assert_eq!(dot(n[0], cofactors[0]), -29);
    assert_eq!(image(&n, &[1, 2, 3]), [4, -1, 13]);
}
