//! Square matrices in rows, of numbers of any kind.

use super::vector::{Ring, dot};
use std::array::from_fn;
use std::ops::Neg;

/// A matrix of three rows.
pub type Matrix3<T> = [[T; 3]; 3];
/// A matrix of four rows.
pub type Matrix4<T> = [[T; 4]; 4];

/// Rows as columns.
pub fn transposed<T: Clone, const N: usize>(m: &[[T; N]; N]) -> [[T; N]; N] {
    from_fn(|i| from_fn(|j| m[j][i].clone()))
}

/// The matrix times a column.
pub fn image<T: Ring, const N: usize, const M: usize>(m: &[[T; N]; M], v: &[T; N]) -> [T; M] {
    from_fn(|i| dot(&m[i], v))
}

/// The matrix product `left right`.
pub fn product<T: Ring, const N: usize>(left: &[[T; N]; N], right: &[[T; N]; N]) -> [[T; N]; N] {
    let entry = |i: usize, j: usize| {
        let terms = (0..N).map(|k| left[i][k].times(&right[k][j]));
        terms.reduce(T::add).expect("a row")
    };
    from_fn(|i| from_fn(|j| entry(i, j)))
}

/// Row and column of the ten numbers of a symmetric matrix, in the order of the coefficients of a quadric.
pub const SYMMETRIC: [[usize; 2]; 10] = [
    [0, 0],
    [1, 1],
    [2, 2],
    [0, 1],
    [0, 2],
    [1, 2],
    [0, 3],
    [1, 3],
    [2, 3],
    [3, 3],
];

/// The symmetric matrix of ten numbers in the order of [`SYMMETRIC`].
pub fn symmetric<T: Clone>([a, b, c, d, e, f, g, h, i, j]: [&T; 10]) -> Matrix4<T> {
    [[a, d, e, g], [d, b, f, h], [e, f, c, i], [g, h, i, j]].map(|row| row.map(T::clone))
}

/// The cofactors of a matrix of three rows, whose signs the cyclic order of rows and columns gives.
pub fn cofactors3<T: Ring>(m: &Matrix3<T>) -> Matrix3<T> {
    let minor = |i: usize, j: usize| {
        let ((r, s), (c, d)) = (((i + 1) % 3, (i + 2) % 3), ((j + 1) % 3, (j + 2) % 3));
        m[r][c].times(&m[s][d]) - m[r][d].times(&m[s][c])
    };
    from_fn(|i| from_fn(|j| minor(i, j)))
}

/// The signed minor without a row and a column.
pub fn cofactor<T: Ring + Neg<Output = T>>(m: &Matrix4<T>, row: usize, column: usize) -> T {
    let others = |skipped: usize| -> [usize; 3] { from_fn(|k| k + usize::from(k >= skipped)) };
    let [r, s, t] = others(row).map(|k| &m[k]);
    let [c, d, e] = others(column);
    let two = |d: usize, e: usize| s[d].times(&t[e]) - s[e].times(&t[d]);
    let minor = r[c].times(&two(d, e)) - r[d].times(&two(c, e)) + r[e].times(&two(c, d));
    if (row + column).is_multiple_of(2) {
        minor
    } else {
        -minor
    }
}

/// All cofactors, `det(M) M^-T`.
pub fn cofactors4<T: Ring + Neg<Output = T>>(m: &Matrix4<T>) -> Matrix4<T> {
    from_fn(|i| from_fn(|j| cofactor(m, i, j)))
}
