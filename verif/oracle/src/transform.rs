//! Changes of frame in exact rationals: where an object stands, and the way back into its own coordinates.
//!
//! Rotations follow the rule of scene files: the entries of the matrix are computed once in double precision, and the
//! scene is the exact scene with these entries. They are computed here by `1 + sin K + (1 - cos) K^2`.

use imogene_algebra::rational::{from_decimal, from_f64_exact};
use imogene_scene::{Axis, Rotation, Scale, Step};
use num_rational::BigRational;
use num_traits::{One, Zero};

/// A homogeneous point or direction.
pub type Vector = [BigRational; 4];
/// A matrix by rows.
pub type Matrix = [[BigRational; 4]; 4];

/// The frame itself.
pub fn identity() -> Matrix {
    diagonal(std::array::from_fn(|_| BigRational::one()))
}

/// Scaling along the axes.
pub fn diagonal(factors: [BigRational; 3]) -> Matrix {
    let mut rows: Matrix = Default::default();
    for (k, factor) in factors.into_iter().enumerate() {
        rows[k][k] = factor;
    }
    rows[3][3] = BigRational::one();
    rows
}

/// The steps of a placement, the first applied first.
pub fn placement(steps: &[Step]) -> Matrix {
    let after = |placed: Matrix, step| times(&of_step(step), &placed);
    steps.iter().fold(identity(), after)
}

fn of_step(step: &Step) -> Matrix {
    match step {
        Step::Translate(offset) => {
            let mut rows = identity();
            for (row, value) in rows.iter_mut().zip(offset) {
                row[3] = from_decimal(*value);
            }
            rows
        }
        Step::Rotate(rotation) => {
            let mut rows = identity();
            for (row, values) in rows.iter_mut().zip(turn(rotation)) {
                for (entry, value) in row.iter_mut().zip(values) {
                    *entry = from_f64_exact(value);
                }
            }
            rows
        }
        Step::Scale(Scale::Uniform(factor)) => diagonal([*factor; 3].map(from_decimal)),
        Step::Scale(Scale::PerAxis(factors)) => diagonal(factors.map(from_decimal)),
    }
}

/// `1 + sin K + (1 - cos) K^2` with K the cross product with the unit axis.
fn turn(rotation: &Rotation) -> [[f64; 3]; 3] {
    let axis = match rotation.axis {
        Axis::X => [1.0, 0.0, 0.0],
        Axis::Y => [0.0, 1.0, 0.0],
        Axis::Z => [0.0, 0.0, 1.0],
        Axis::Vector(vector) => unit(vector),
    };
    let (sin, cos) = sine_and_cosine(rotation.degrees);
    let [x, y, z] = axis;
    let k = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    let entry = |row: usize, column: usize| {
        let square: f64 = (0..3).map(|m| k[row][m] * k[m][column]).sum();
        let one = f64::from(u8::from(row == column));
        if row == column && square == -1.0 {
            // 1 - (1 - cos) would round.
            return cos;
        }
        one + sin * k[row][column] + (1.0 - cos) * square
    };
    std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column)))
}

/// Quarter turns are exact.
fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    let turned = degrees.rem_euclid(360.0);
    if turned % 90.0 == 0.0 {
        return [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][(turned / 90.0) as usize % 4];
    }
    (turned.to_radians().sin(), turned.to_radians().cos())
}

/// A direction of length 1, scaled first so that no square overflows or vanishes.
pub fn unit(vector: [f64; 3]) -> [f64; 3] {
    let greatest = vector.iter().fold(0.0f64, |most, v| most.max(v.abs()));
    let scaled = vector.map(|v| v / greatest);
    let length = scaled[0].hypot(scaled[1]).hypot(scaled[2]);
    scaled.map(|v| v / length)
}

/// The product of two matrices.
pub fn times(left: &Matrix, right: &Matrix) -> Matrix {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| {
            let terms = (0..4).filter(|&k| !left[row][k].is_zero() && !right[k][column].is_zero());
            terms.map(|k| &left[row][k] * &right[k][column]).sum()
        })
    })
}

/// The image of a homogeneous vector.
pub fn apply(matrix: &Matrix, vector: &Vector) -> Vector {
    matrix.each_ref().map(|row| {
        let terms = row.iter().zip(vector);
        let terms = terms.filter(|(m, v)| !m.is_zero() && !v.is_zero());
        terms.map(|(m, v)| m * v).sum()
    })
}

/// The inverse by elimination; `None` if there is none.
pub fn inverse(matrix: &Matrix) -> Option<Matrix> {
    let (mut left, mut right) = (matrix.clone(), identity());
    for column in 0..4 {
        let pivot = (column..4).find(|&row| !left[row][column].is_zero())?;
        left.swap(column, pivot);
        right.swap(column, pivot);
        let factor = left[column][column].recip();
        for entry in left[column].iter_mut().chain(&mut right[column]) {
            *entry *= &factor;
        }
        let (left_row, right_row) = (left[column].clone(), right[column].clone());
        for row in (0..4).filter(|&row| row != column) {
            let factor = left[row][column].clone();
            if factor.is_zero() {
                continue;
            }
            for k in 0..4 {
                left[row][k] -= &factor * &left_row[k];
                right[row][k] -= &factor * &right_row[k];
            }
        }
    }
    Some(right)
}
