//! Tetrahedral patches: ten Bernstein weights to the implicit quadric, and the four faces as planes.

use super::plane::Plane;
use super::quadric::Quadric;
use super::transform::{Transform, product};
use imogene_algebra::rational::from_decimal;
use num_rational::BigRational;
use num_traits::{One, Zero};

/// Corners of a pair whose weight stands at 4, 5, .. in the list of weights; the first four are those of each corner with itself.
const PAIRS: [(usize, usize); 6] = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];

/// The quadric and the four planes of a tetrahedron, in the coordinates of its corners; nothing if the corners lie in one plane.
///
/// With the barycentric coordinates b as affine functions of the point, F = b' W b for the symmetric W of the weights: a pair stands in it twice, which is
/// the factor 2 of its Bernstein polynomial. Plane i keeps b_i >= 0, so it is the face opposite corner i.
pub(super) fn implicit(
    corners: &[[f64; 3]; 4],
    weights: &[f64; 10],
) -> Option<(Quadric, [Plane; 4])> {
    let mut points = Transform::identity();
    for (column, corner) in corners.iter().enumerate() {
        for (row, value) in corner.iter().enumerate() {
            points.rows[row][column] = from_decimal(*value);
        }
        points.rows[3][column] = BigRational::one();
    }
    let determinant = points.determinant();
    if determinant.is_zero() {
        return None;
    }
    // Row i of the inverse is b_i: column i of the cofactors over the determinant.
    let cofactors = points.cofactors();
    let coordinates: [[BigRational; 4]; 4] =
        std::array::from_fn(|i| std::array::from_fn(|k| &cofactors[k][i] / &determinant));
    let mut symmetric: [[BigRational; 4]; 4] = Default::default();
    for (i, weight) in weights[..4].iter().enumerate() {
        symmetric[i][i] = from_decimal(*weight);
    }
    for ((i, j), weight) in PAIRS.into_iter().zip(&weights[4..]) {
        symmetric[i][j] = from_decimal(*weight);
        symmetric[j][i] = from_decimal(*weight);
    }
    let transposed = std::array::from_fn(|i| std::array::from_fn(|k| coordinates[k][i].clone()));
    let matrix = product(&product(&transposed, &symmetric), &coordinates);
    let planes = coordinates.map(|[a, b, c, d]| Plane {
        a: -a,
        b: -b,
        c: -c,
        d: -d,
    });
    Some((Quadric::from_matrix(matrix), planes))
}
