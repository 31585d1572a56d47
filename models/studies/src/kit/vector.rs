//! Vectors of three components in floating point.

/// A vector.
pub type Vector = [f64; 3];

/// The scalar product.
pub fn dot(u: Vector, v: Vector) -> f64 {
    u.iter().zip(v).map(|(a, b)| a * b).sum()
}

/// The vector product.
pub fn cross(u: Vector, v: Vector) -> Vector {
    let minor = |j: usize, k: usize| u[j] * v[k] - u[k] * v[j];
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

/// The length.
pub fn length(v: Vector) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}
