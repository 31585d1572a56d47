//! The type of a quadric, from the signs of its exact coefficients (source: Table 2.1).
//!
//! By Sylvester's law the numbers of positive and negative squares of the quadratic part, and of the whole 4 x 4
//! matrix, do not depend on the frame; together they name the type.

use imogene_algebra::matrix::symmetric;
use imogene_algebra::whole::common_denominator;
use imogene_scene::Quadric;
use num_bigint::BigInt;
use num_traits::{Signed, Zero};

/// The type of the surface Q = 0, named as in scene files where they have a name for it.
pub fn quadric_kind(quadric: &Quadric) -> &'static str {
    let (whole, _) = common_denominator(quadric.coefficients());
    let matrix = symmetric(whole.each_ref()).map(Vec::from).to_vec();
    let part = matrix[..3].iter().map(|r| r[..3].to_vec()).collect();
    match (inertia(part), inertia(matrix)) {
        ((3, 0), (3, 1)) => "ellipsoid",
        ((2, 1), (2, 2)) => "hyperboloid_one_sheet",
        ((2, 1), (3, 1)) => "hyperboloid_two_sheets",
        ((2, 1), (2, 1)) => "cone",
        ((2, 0), (3, 1)) => "elliptic_paraboloid",
        ((1, 1), (2, 2)) => "hyperbolic_paraboloid",
        ((2, 0), (2, 1)) => "elliptic_cylinder",
        ((1, 1), (2, 1)) => "hyperbolic_cylinder",
        ((1, 0), (2, 1)) => "parabolic_cylinder",
        ((1, 1), (1, 1)) | ((1, 0), (1, 1)) => "plane_pair",
        ((1, 0), (1, 0)) => "double_plane",
        ((3, 0), (3, 0)) => "point",
        ((2, 0), (2, 0)) => "line",
        ((0, 0), _) => "plane",
        _ => "empty",
    }
}

/// Numbers of squares of either sign in a symmetric matrix, by symmetric elimination; the greater one first, since the
/// surface is the same for -Q.
fn inertia(mut m: Vec<Vec<BigInt>>) -> (usize, usize) {
    let [mut positive, mut negative] = [0, 0];
    while !m.is_empty() {
        let n = m.len();
        let Some(pivot) = (0..n).find(|&k| !m[k][k].is_zero()) else {
            // Without a square, a product x_i x_j becomes two by x_i := x_i + x_j.
            let mut pairs = (0..n).flat_map(|i| (0..i).map(move |j| (i, j)));
            let Some((i, j)) = pairs.find(|&(i, j)| !m[i][j].is_zero()) else {
                break;
            };
            for (k, added) in m[j].clone().into_iter().enumerate() {
                m[i][k] += added;
            }
            for row in &mut m {
                let added = row[j].clone();
                row[i] += added;
            }
            continue;
        };
        match m[pivot][pivot].is_positive() {
            true => positive += 1,
            false => negative += 1,
        }
        m = schur_complement(&m, pivot);
    }
    (positive.max(negative), positive.min(negative))
}

/// Times the magnitude of the pivot, so that nothing is divided.
fn schur_complement(m: &[Vec<BigInt>], pivot: usize) -> Vec<Vec<BigInt>> {
    let rest: Vec<usize> = (0..m.len()).filter(|&k| k != pivot).collect();
    let square = &m[pivot][pivot];
    let (size, sign) = (square.abs(), square.signum());
    let entry = |i: usize, j: usize| &m[i][j] * &size - &m[i][pivot] * &m[pivot][j] * &sign;
    rest.iter()
        .map(|&i| rest.iter().map(|&j| entry(i, j)).collect())
        .collect()
}
