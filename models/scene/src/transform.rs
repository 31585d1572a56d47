//! Exact changes of frame: 4 x 4 matrices of rationals acting on column points.

use super::step::{Axis, Rotation, Scale, Step};
use imogene_algebra::matrix::{
    Matrix3, Matrix4, cofactors3, cofactors4, image, product, transposed,
};
use imogene_algebra::rational::{from_decimal, from_f64_exact};
use imogene_algebra::vector::{dot, normalised};
use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;

/// A change of frame `P' = M P` on points `(x, y, z, 1)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Transform {
    /// Row-major entries of M.
    pub rows: Matrix4<BigRational>,
}

impl Transform {
    /// The frame itself.
    pub fn identity() -> Self {
        Self::scaling([BigRational::one(), BigRational::one(), BigRational::one()])
    }

    /// Displacement by `offset`.
    pub fn translation(offset: [BigRational; 3]) -> Self {
        let mut transform = Self::identity();
        for (row, value) in transform.rows.iter_mut().zip(offset) {
            row[3] = value;
        }
        transform
    }

    /// Scaling from the origin, one factor for each axis.
    pub fn scaling(factors: [BigRational; 3]) -> Self {
        let mut rows: Matrix4<BigRational> = Default::default();
        for (index, factor) in factors.into_iter().enumerate() {
            rows[index][index] = factor;
        }
        rows[3][3] = BigRational::one();
        Self { rows }
    }

    /// A linear map whose entries are the exact values of `linear`.
    pub fn linear(linear: [[f64; 3]; 3]) -> Self {
        let mut transform = Self::identity();
        for (row, values) in transform.rows.iter_mut().zip(linear) {
            for (entry, value) in row.iter_mut().zip(values) {
                *entry = from_f64_exact(value);
            }
        }
        transform
    }

    /// The steps of a placement, the first applied first.
    pub fn placement(steps: &[Step]) -> Self {
        let after = |placed, step| Self::from_step(step).after(&placed);
        steps.iter().fold(Self::identity(), after)
    }

    fn from_step(step: &Step) -> Self {
        match step {
            Step::Translate(offset) => Self::translation(offset.map(from_decimal)),
            Step::Rotate(rotation) => Self::linear(rotation_matrix(rotation)),
            Step::Scale(Scale::Uniform(factor)) => Self::scaling([*factor; 3].map(from_decimal)),
            Step::Scale(Scale::PerAxis(factors)) => Self::scaling(factors.map(from_decimal)),
        }
    }

    /// The transform that applies `first`, then `self`.
    pub fn after(&self, first: &Self) -> Self {
        Self {
            rows: product(&self.rows, &first.rows),
        }
    }

    /// The image of a point.
    pub fn point(&self, point: &[BigRational; 3]) -> [BigRational; 3] {
        let moved = self.vector(point);
        let mut rows = self.rows.iter();
        moved.map(|value| value + &rows.next().expect("four rows")[3])
    }

    /// The image of a free vector: displacement leaves it alone.
    pub fn vector(&self, vector: &[BigRational; 3]) -> [BigRational; 3] {
        std::array::from_fn(|row| {
            let [x, y, z, _] = &self.rows[row];
            x * &vector[0] + y * &vector[1] + z * &vector[2]
        })
    }

    /// The images of the three unit vectors.
    pub(super) fn columns(&self) -> Matrix3<BigRational> {
        std::array::from_fn(|column| std::array::from_fn(|row| self.rows[row][column].clone()))
    }

    /// The determinant; negative when the transform mirrors.
    pub fn determinant(&self) -> BigRational {
        dot(&self.rows[0], &self.cofactors()[0])
    }

    /// The matrix of cofactors, `det(M) M^-T`.
    pub fn cofactors(&self) -> Matrix4<BigRational> {
        let WholeTransform { rows, unit } = WholeTransform::new(self);
        let unit = unit.pow(3);
        cofactors4(&rows).map(|row| row.map(|v| BigRational::new(v, unit.clone())))
    }
}

/// A transform in whole numbers over one positive denominator. What is transformed with it becomes a positive multiple
/// without common divisor in the end, so that nothing has to be reduced on the way, which would take most of the time.
#[derive(Clone, Debug)]
pub struct WholeTransform {
    rows: Matrix4<BigInt>,
    unit: BigInt,
}

impl WholeTransform {
    /// The same transform.
    pub fn new(transform: &Transform) -> Self {
        let all = || transform.rows.iter().flatten();
        let unit = all().fold(BigInt::one(), |lcm, v| {
            let divides = v.denom().is_one() || *v.denom() == lcm;
            if divides { lcm } else { lcm.lcm(v.denom()) }
        });
        let whole = |v: &BigRational| v.numer() * (&unit / v.denom());
        let rows = transform.rows.each_ref();
        let rows = rows.map(|row| row.each_ref().map(whole));
        Self { rows, unit }
    }

    /// The steps of a placement, the first applied first, and then `camera`.
    pub fn of_steps(camera: &Self, steps: &[Step]) -> Self {
        let after = |then: Self, step| then.after(&Self::new(&Transform::from_step(step)));
        steps.iter().rev().fold(camera.clone(), after)
    }

    fn after(&self, first: &Self) -> Self {
        Self {
            rows: product(&self.rows, &first.rows),
            unit: &self.unit * &first.unit,
        }
    }

    /// A multiple of the inverse: for `P' = (L P + t) / u` it is `u adj(L)` with the last column `-adj(L) t`, and
    /// `det(L)` in the corner.
    pub fn inverse(&self) -> WholeInverse {
        let part = |k: usize| -> [BigInt; 3] { std::array::from_fn(|c| self.rows[k][c].clone()) };
        let linear = [0, 1, 2].map(part);
        let adjugate = transposed(&cofactors3(&linear));
        let determinant = dot(&linear[0], &transposed(&adjugate)[0]);
        let sign = determinant.sign();
        let moved = image(&adjugate, &std::array::from_fn(|k| self.rows[k][3].clone()));
        let mut rows: Matrix4<BigInt> = Default::default();
        for ((row, minors), moved) in rows.iter_mut().zip(&adjugate).zip(moved) {
            let [x, y, z] = minors.each_ref().map(|c| c * &self.unit);
            *row = [x, y, z, -moved];
        }
        rows[3][3] = determinant;
        WholeInverse {
            rows,
            sign,
            cofactor_unit: self.unit.pow(3),
        }
    }
}

/// A multiple of the inverse of a transform M.
#[derive(Clone, Debug)]
pub struct WholeInverse {
    /// The matrix N that takes points of the new frame to a multiple of those of the old one.
    pub(super) rows: Matrix4<BigInt>,
    /// The sign of that multiple, which is that of the determinant of M.
    pub(super) sign: Sign,
    /// N over this number is the transpose of the cofactors of M.
    pub(super) cofactor_unit: BigInt,
}

/// Rodrigues' formula, written so that the axis of a coordinate rotation keeps its exact zeros and ones.
pub fn rotation_matrix(rotation: &Rotation) -> [[f64; 3]; 3] {
    let [x, y, z] = match rotation.axis {
        Axis::X => [1.0, 0.0, 0.0],
        Axis::Y => [0.0, 1.0, 0.0],
        Axis::Z => [0.0, 0.0, 1.0],
        Axis::Vector(vector) => normalised(vector),
    };
    let (sin, cos) = sine_and_cosine(rotation.degrees);
    let rest = 1.0 - cos;
    let diagonal = |u: f64| u * u + cos * (1.0 - u * u);
    [
        [diagonal(x), x * y * rest - z * sin, x * z * rest + y * sin],
        [x * y * rest + z * sin, diagonal(y), y * z * rest - x * sin],
        [x * z * rest - y * sin, y * z * rest + x * sin, diagonal(z)],
    ]
}

/// Sine and cosine of an angle in degrees, exact at the quarter turns where `f64` radians are not.
pub(super) fn sine_and_cosine(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        other => other.to_radians().sin_cos(),
    }
}
