//! Tetrahedral patches: ten Bernstein weights to the implicit quadric, and the four faces as planes.

use super::transform::Transform;
use imogene_algebra::matrix::{Matrix4, product, symmetric, transposed};
use imogene_algebra::rational::from_decimal;
use num_rational::BigRational;
use num_traits::Zero;

/// The matrix of the quadric and the four planes of a tetrahedron, in the coordinates of its corners; `None` if the
/// corners lie in one plane.
///
/// With the barycentric coordinates b as affine functions of the point, F = b' W b for the symmetric W of the weights:
/// a pair stands in it twice, which is the factor 2 of its Bernstein polynomial. Plane i keeps b_i >= 0, so it is the
/// face opposite corner i.
pub(super) fn implicit(
    corners: &[[f64; 3]; 4],
    weights: &[f64; 10],
) -> Option<(Matrix4<BigRational>, Matrix4<BigRational>)> {
    let corners = corners.map(|[x, y, z]| [x, y, z, 1.0].map(from_decimal));
    let points = Transform {
        rows: transposed(&corners),
    };
    let determinant = points.determinant();
    if determinant.is_zero() {
        return None;
    }
    // Row i of the inverse is b_i: column i of the cofactors over the determinant.
    let coordinates = transposed(&points.cofactors()).map(|row| row.map(|v| v / &determinant));
    let [w00, w11, w22, w33, w01, w02, w03, w12, w13, w23] = &weights.map(from_decimal);
    let weights = symmetric([w00, w11, w22, w01, w02, w12, w03, w13, w23, w33]);
    let matrix = product(&product(&transposed(&coordinates), &weights), &coordinates);
    Some((matrix, coordinates.map(|plane| plane.map(|v| -v))))
}
