use imogene_algebra::matrix::{SYMMETRIC, cofactors4, image, product, transposed};
use imogene_studies::evaluate::count::numbers;
use imogene_studies::evaluate::work::transform::{
    Matrix, affine_product, cofactors_of_shared_minors, determinant, determinant_alone, inverse,
    point, quadric, quadric_in_full,
};

/// Whole numbers, so that every result is exact.
const M: [[f64; 4]; 4] = [
    [2.0, -1.0, 3.0, 5.0],
    [0.0, 4.0, 1.0, -2.0],
    [7.0, 1.0, -3.0, 6.0],
    [1.0, 0.0, 2.0, 3.0],
];
const Q: [f64; 10] = [1.0, 2.0, -3.0, 4.0, 0.0, 5.0, -1.0, 2.0, 6.0, -7.0];

fn matrix() -> Matrix {
    M.map(numbers)
}

fn values(m: &Matrix) -> [[f64; 4]; 4] {
    m.map(|row| row.map(|v| v.value))
}

#[test]
fn both_ways_to_the_cofactors_agree_and_invert() {
    let m = matrix();
    let one_by_one = cofactors4(&m);
    assert_eq!(values(&one_by_one), values(&cofactors_of_shared_minors(&m)));
    let det = determinant(&m, &one_by_one);
    assert_eq!(det.value, determinant_alone(&m).value);
    // M times the transposed cofactors is the determinant times the identity.
    let identity = values(&product(&m, &transposed(&one_by_one)));
    for (i, row) in identity.into_iter().enumerate() {
        for (j, value) in row.into_iter().enumerate() {
            assert_eq!(value, if i == j { det.value } else { 0.0 }, "{i} {j}");
        }
    }
    let back = values(&product(&m, &inverse(&one_by_one, det)));
    for (i, row) in back.into_iter().enumerate() {
        for (j, value) in row.into_iter().enumerate() {
            // Four products of numbers below 10, each rounded at 2^-53.
            assert!((value - f64::from(u8::from(i == j))).abs() < 1e-13);
        }
    }
}

/// A quadric and a plane have, at the image of a point, det^2 and det times the value that they have at the point.
#[test]
fn transformed_surfaces_go_through_the_images_of_their_points() {
    let m = matrix();
    let c = cofactors4(&m);
    let det = determinant(&m, &c).value;
    let at = |q: [f64; 10], p: [f64; 4]| -> f64 {
        let pairs = SYMMETRIC.iter().zip(q);
        pairs
            .map(|(&[i, j], v)| if i == j { v } else { 2.0 * v } * p[i] * p[j])
            .sum()
    };
    let q = numbers(Q);
    let moved = quadric(&c, q).map(|v| v.value);
    let full = values(&quadric_in_full(&c, q));
    assert_eq!(moved, SYMMETRIC.map(|[row, col]| full[row][col]));
    let flat = [3.0, -2.0, 1.0, 4.0];
    let moved_plane = image(&c, &numbers(flat)).map(|v| v.value);
    for p in [[1.0, 2.0, 3.0], [-4.0, 0.0, 5.0], [2.0, -7.0, 1.0]] {
        let image = point(&m, numbers(p)).map(|v| v.value);
        let [x, y, z] = p;
        assert_eq!(at(moved, image), det * det * at(Q, [x, y, z, 1.0]));
        let before: f64 = flat.iter().zip([x, y, z, 1.0]).map(|(a, b)| a * b).sum();
        let after: f64 = moved_plane.iter().zip(image).map(|(a, b)| a * b).sum();
        assert_eq!(after, det * before);
    }
}

#[test]
fn an_affine_product_is_the_product() {
    let mut m = M;
    m[3] = [0.0, 0.0, 0.0, 1.0];
    let m = m.map(numbers);
    assert_eq!(values(&product(&m, &m)), values(&affine_product(&m, &m)));
}
