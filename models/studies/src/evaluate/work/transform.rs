//! Changes of frame: points, normals, planes and quadrics under a matrix of 4 x 4 (source: 2.1.1, 5.1.2). Products and
//! cofactors are those with which the preparation of this project computes.

use crate::evaluate::count::{Counted, number};
use imogene_algebra::matrix::{Matrix4, SYMMETRIC, cofactor, product, symmetric, transposed};
use imogene_algebra::vector::dot;

/// A matrix by rows; points are columns.
pub type Matrix = Matrix4<Counted>;

/// The product of matrices whose last row is 0 0 0 1, which is neither read nor computed.
pub fn affine_product(left: &Matrix, right: &Matrix) -> Matrix {
    let columns = transposed(right);
    let entry = |row: usize, col: usize| {
        let ([a, b, c, d], [x, y, z, _]) = (left[row], columns[col]);
        let sum = dot([a, b, c], [x, y, z]);
        if col == 3 { sum + d } else { sum }
    };
    let last = right[3];
    std::array::from_fn(|row| match row {
        3 => last,
        _ => std::array::from_fn(|col| entry(row, col)),
    })
}

/// The homogeneous image of a point.
pub fn point(m: &Matrix, p: [Counted; 3]) -> [Counted; 4] {
    m.map(|[a, b, c, d]| dot([a, b, c], p) + d)
}

/// A point from its homogeneous one.
pub fn divided([x, y, z, w]: [Counted; 4]) -> [Counted; 3] {
    let one = w.reciprocal();
    [x * one, y * one, z * one]
}

/// The image of a direction under the linear part.
pub fn direction(m: &Matrix, v: [Counted; 3]) -> [Counted; 3] {
    let [x, y, z, _] = m.map(|[a, b, c, _]| [a, b, c]);
    [x, y, z].map(|row| dot(row, v))
}

/// `C Q C'` of a symmetric Q; the product is symmetric, so ten of its entries are computed.
pub fn quadric(cofactors: &Matrix, q: [Counted; 10]) -> [Counted; 10] {
    let half = product(cofactors, &symmetric(q.each_ref()));
    SYMMETRIC.map(|[row, col]| dot(half[row], cofactors[col]))
}

/// The same, all sixteen entries of both products.
pub fn quadric_in_full(cofactors: &Matrix, q: [Counted; 10]) -> Matrix {
    let half = product(cofactors, &symmetric(q.each_ref()));
    product(&half, &transposed(cofactors))
}

/// All cofactors from the twelve minors of 2 x 2 that they share.
pub fn cofactors_of_shared_minors(m: &Matrix) -> Matrix {
    let minors = |upper: &[Counted; 4], lower: &[Counted; 4]| {
        let zero = number(0.0);
        let mut table = [[zero; 4]; 4];
        for i in 0..4 {
            for j in i + 1..4 {
                table[i][j] = upper[i] * lower[j] - upper[j] * lower[i];
            }
        }
        table
    };
    let (first, last) = (minors(&m[0], &m[1]), minors(&m[2], &m[3]));
    std::array::from_fn(|row| {
        // The row that stands beside, and the minors of the two others.
        let (beside, table) = match row {
            0 => (&m[1], &last),
            1 => (&m[0], &last),
            2 => (&m[3], &first),
            _ => (&m[2], &first),
        };
        std::array::from_fn(|col| {
            let [c0, c1, c2] =
                std::array::from_fn(|index: usize| index + usize::from(index >= col));
            let sum = beside[c0] * table[c1][c2] - beside[c1] * table[c0][c2]
                + beside[c2] * table[c0][c1];
            match (row + col).is_multiple_of(2) {
                true => sum,
                false => -sum,
            }
        })
    })
}

/// The determinant from a row and its cofactors.
pub fn determinant(m: &Matrix, cofactors: &Matrix) -> Counted {
    dot(m[0], cofactors[0])
}

/// The determinant alone, by the first row.
pub fn determinant_alone(m: &Matrix) -> Counted {
    let row: [Counted; 4] = std::array::from_fn(|col| cofactor(m, 0, col));
    dot(m[0], row)
}

/// The inverse: the transposed cofactors over the determinant.
pub fn inverse(cofactors: &Matrix, determinant: Counted) -> Matrix {
    let one = determinant.reciprocal();
    transposed(cofactors).map(|row| row.map(|value| value * one))
}

/// A vector of length 1.
pub fn normalised(v: [Counted; 3]) -> [Counted; 3] {
    let one = dot(v, v).root().reciprocal();
    v.map(|value| value * one)
}
