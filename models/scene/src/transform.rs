//! Exact changes of frame: 4 x 4 matrices of rationals acting on column points.

use num_bigint::{BigInt, Sign};
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::One;

use super::file::{Axis, Rotation, Scale, Step};
use imogene_algebra::rational::{from_decimal, from_f64_exact};

/// A change of frame `P' = M P` on points `(x, y, z, 1)`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Transform {
    /// Row-major entries of M.
    pub rows: [[BigRational; 4]; 4],
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
        let mut rows: [[BigRational; 4]; 4] = Default::default();
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
        steps.iter().fold(Self::identity(), |placed, step| {
            Self::from_step(step).after(&placed)
        })
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
        std::array::from_fn(|row| {
            let [x, y, z, w] = &self.rows[row];
            x * &point[0] + y * &point[1] + z * &point[2] + w
        })
    }

    /// The image of a free vector: displacement leaves it alone.
    pub fn vector(&self, vector: &[BigRational; 3]) -> [BigRational; 3] {
        std::array::from_fn(|row| {
            let [x, y, z, _] = &self.rows[row];
            x * &vector[0] + y * &vector[1] + z * &vector[2]
        })
    }

    /// The determinant; negative when the transform mirrors.
    pub fn determinant(&self) -> BigRational {
        let cofactors = self.cofactors();
        let terms = self.rows[0].iter().zip(&cofactors[0]);
        terms.map(|(value, cofactor)| value * cofactor).sum()
    }

    /// The matrix of cofactors in whole numbers over one positive denominator.
    fn whole_cofactors(&self) -> ([[BigInt; 4]; 4], BigInt) {
        let WholeTransform { rows, unit } = WholeTransform::new(self);
        let cofactors =
            std::array::from_fn(|row| std::array::from_fn(|column| cofactor(&rows, row, column)));
        (cofactors, unit.pow(3))
    }

    /// The matrix of cofactors, `det(M) M^-T`.
    pub fn cofactors(&self) -> [[BigRational; 4]; 4] {
        let (cofactors, unit) = self.whole_cofactors();
        cofactors.map(|row| row.map(|v| BigRational::new(v, unit.clone())))
    }
}

/// A transform in whole numbers over one positive denominator. What is transformed with it becomes a positive multiple
/// without common divisor in the end, so that nothing has to be reduced on the way, which would take most of the time.
#[derive(Clone, Debug)]
pub(super) struct WholeTransform {
    rows: [[BigInt; 4]; 4],
    unit: BigInt,
}

impl WholeTransform {
    /// The same transform.
    pub(super) fn new(transform: &Transform) -> Self {
        let all = || transform.rows.iter().flatten();
        let unit = all().fold(BigInt::one(), |lcm, v| {
            if v.denom().is_one() || *v.denom() == lcm {
                lcm
            } else {
                lcm.lcm(v.denom())
            }
        });
        let whole = |v: &BigRational| v.numer() * (&unit / v.denom());
        let rows = transform
            .rows
            .each_ref()
            .map(|row| row.each_ref().map(whole));
        Self { rows, unit }
    }

    /// The steps of a placement, the first applied first, and then `camera`.
    pub(super) fn of_steps(camera: &Self, steps: &[Step]) -> Self {
        let steps = steps.iter().rev();
        steps.fold(camera.clone(), |then, step| {
            then.after(&Self::new(&Transform::from_step(step)))
        })
    }

    fn after(&self, first: &Self) -> Self {
        let entry = |row: usize, column: usize| {
            let terms = (0..4).map(|k| &self.rows[row][k] * &first.rows[k][column]);
            terms.sum::<BigInt>()
        };
        Self {
            rows: std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column))),
            unit: &self.unit * &first.unit,
        }
    }

    /// A multiple of the inverse: for `P' = (L P + t) / u` it is `u adj(L)` with the last column `-adj(L) t`, and
    /// `det(L)` in the corner.
    pub(super) fn inverse(&self) -> WholeInverse {
        let m = &self.rows;
        let minor = |row: usize, column: usize| {
            let (r, s) = ((row + 1) % 3, (row + 2) % 3);
            let (c, d) = ((column + 1) % 3, (column + 2) % 3);
            &m[r][c] * &m[s][d] - &m[r][d] * &m[s][c]
        };
        // The adjugate is the transpose of the cofactors, whose signs the cyclic order of rows and columns gives.
        let adjugate: [[BigInt; 3]; 3] =
            std::array::from_fn(|row| std::array::from_fn(|column| minor(column, row)));
        let determinant: BigInt = (0..3).map(|k| &m[0][k] * &adjugate[k][0]).sum();
        let sign = determinant.sign();
        let mut rows: [[BigInt; 4]; 4] = Default::default();
        for (row, minors) in rows.iter_mut().zip(&adjugate) {
            let moved: BigInt = minors.iter().zip(m).map(|(c, row)| c * &row[3]).sum();
            row[3] = -moved;
            for (entry, c) in row.iter_mut().zip(minors) {
                *entry = c * &self.unit;
            }
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
pub(super) struct WholeInverse {
    /// The matrix N that takes points of the new frame to a multiple of those of the old one.
    pub(super) rows: [[BigInt; 4]; 4],
    /// The sign of that multiple, which is that of the determinant of M.
    pub(super) sign: Sign,
    /// N over this number is the transpose of the cofactors of M.
    pub(super) cofactor_unit: BigInt,
}

/// The signed minor without a row and a column.
pub fn cofactor(m: &[[BigInt; 4]; 4], row: usize, column: usize) -> BigInt {
    let others = |skipped: usize| -> [usize; 3] {
        std::array::from_fn(|index| index + usize::from(index >= skipped))
    };
    let [r0, r1, r2] = others(row).map(|index| &m[index]);
    let [c0, c1, c2] = others(column);
    let minor = &r0[c0] * (&r1[c1] * &r2[c2] - &r1[c2] * &r2[c1])
        - &r0[c1] * (&r1[c0] * &r2[c2] - &r1[c2] * &r2[c0])
        + &r0[c2] * (&r1[c0] * &r2[c1] - &r1[c1] * &r2[c0]);
    if (row + column).is_multiple_of(2) {
        minor
    } else {
        -minor
    }
}

/// The matrix product `left right`.
pub(super) fn product(
    left: &[[BigRational; 4]; 4],
    right: &[[BigRational; 4]; 4],
) -> [[BigRational; 4]; 4] {
    std::array::from_fn(|row| {
        std::array::from_fn(|column| (0..4).map(|k| &left[row][k] * &right[k][column]).sum())
    })
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
    let turned = degrees.rem_euclid(360.0);
    match turned {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        other => other.to_radians().sin_cos(),
    }
}

/// The direction of `vector`, of length 1; scaled first so that no square overflows or vanishes.
pub(super) fn normalised(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector
        .iter()
        .fold(0.0_f64, |max, value| max.max(value.abs()));
    let scaled = vector.map(|value| value / largest);
    let length = dot(scaled, scaled).sqrt();
    scaled.map(|value| value / length)
}

pub(super) fn dot(left: [f64; 3], right: [f64; 3]) -> f64 {
    left[0] * right[0] + left[1] * right[1] + left[2] * right[2]
}

pub(super) fn cross(left: [f64; 3], right: [f64; 3]) -> [f64; 3] {
    [
        left[1] * right[2] - left[2] * right[1],
        left[2] * right[0] - left[0] * right[2],
        left[0] * right[1] - left[1] * right[0],
    ]
}
