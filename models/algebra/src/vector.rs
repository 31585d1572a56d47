//! Vectors of numbers of any kind: `f64`, whole numbers, exact rationals.

use std::borrow::Borrow;
use std::ops::{Add, Mul, Sub};

/// Numbers that are added, subtracted and multiplied without being used up.
pub trait Ring: Add<Output = Self> + Sub<Output = Self> + Sized {
    /// The product.
    fn times(&self, other: &Self) -> Self;
    /// The difference.
    fn less(&self, other: &Self) -> Self;
}

impl<T> Ring for T
where
    T: Add<Output = T> + Sub<Output = T>,
    for<'a> &'a T: Mul<&'a T, Output = T> + Sub<&'a T, Output = T>,
{
    fn times(&self, other: &T) -> T {
        self * other
    }

    fn less(&self, other: &T) -> T {
        self - other
    }
}

/// The scalar product, summed in the order of the components.
/// Panics if the vectors have no component.
pub fn dot<T: Ring, const N: usize>(u: impl Borrow<[T; N]>, v: impl Borrow<[T; N]>) -> T {
    let products = u.borrow().iter().zip(v.borrow()).map(|(u, v)| u.times(v));
    products.reduce(T::add).expect("a component")
}

/// The square of the length.
pub fn square<T: Ring, const N: usize>(v: impl Borrow<[T; N]>) -> T {
    dot(v.borrow(), v.borrow())
}

/// The vector product.
pub fn cross<T: Ring>(u: impl Borrow<[T; 3]>, v: impl Borrow<[T; 3]>) -> [T; 3] {
    let ([a, b, c], [x, y, z]) = (u.borrow(), v.borrow());
    [
        b.times(z) - c.times(y),
        c.times(x) - a.times(z),
        a.times(y) - b.times(x),
    ]
}

/// A vector in floating point.
pub type Vector = [f64; 3];

/// The length.
pub fn length(v: Vector) -> f64 {
    square(v).sqrt()
}

/// The vector at length one; one without length has no direction, and stays.
pub fn unit(v: Vector) -> Vector {
    match length(v) {
        0.0 => v,
        length => v.map(|part| part / length),
    }
}

/// The difference of two vectors.
pub fn minus<T: Ring, const N: usize>(u: impl Borrow<[T; N]>, v: impl Borrow<[T; N]>) -> [T; N] {
    let (u, v) = (u.borrow(), v.borrow());
    std::array::from_fn(|k| u[k].less(&v[k]))
}

/// The direction of a vector, of length 1; scaled first so that no square overflows or vanishes.
pub fn normalised(vector: [f64; 3]) -> [f64; 3] {
    let largest = vector.iter().fold(0f64, |most, v| most.max(v.abs()));
    let scaled = vector.map(|v| v / largest);
    let length = square(scaled).sqrt();
    scaled.map(|v| v / length)
}
