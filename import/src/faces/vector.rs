//! Vectors of three numbers.

pub use imogene_algebra::vector::{Vector, cross, dot, minus};

use std::f64::consts::TAU;

/// `u + v`.
pub fn plus(u: Vector, v: Vector) -> Vector {
    std::array::from_fn(|k| u[k] + v[k])
}

/// `factor * v`.
pub fn times(factor: f64, v: Vector) -> Vector {
    v.map(|value| factor * value)
}

/// The point `origin + factor * direction`.
pub fn along(origin: Vector, factor: f64, direction: Vector) -> Vector {
    plus(origin, times(factor, direction))
}

/// Length.
pub fn length(v: Vector) -> f64 {
    let greatest = v.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    if greatest == 0.0 {
        return 0.0;
    }
    greatest * dot(times(1.0 / greatest, v), times(1.0 / greatest, v)).sqrt()
}

/// Distance of two points.
pub fn distance(p: Vector, q: Vector) -> f64 {
    length(minus(p, q))
}

/// The vector of length 1, exactly the given one if that is an axis of the frame; a zero vector stays as it is.
pub fn unit(v: Vector) -> Vector {
    let size = length(v);
    if size == 0.0 || size == 1.0 {
        return v;
    }
    v.map(|value| value / size)
}

/// Part of `v` across the unit vector `axis`.
pub fn across(v: Vector, axis: Vector) -> Vector {
    along(v, -dot(v, axis), axis)
}

/// Two unit vectors of a right-handed frame (e1, e2, axis), turned by `turn` radians about the unit vector `axis`.
pub fn frame(axis: Vector, turn: f64) -> [Vector; 2] {
    let smallest = (0..3).min_by(|i, j| axis[*i].abs().total_cmp(&axis[*j].abs()));
    let mut other = [0.0; 3];
    other[smallest.expect("three axes")] = 1.0;
    let e1 = unit(across(other, axis));
    let e2 = cross(axis, e1);
    let (sine, cosine) = turn.sin_cos();
    let turned = |a: f64, b: f64| plus(times(a, e1), times(b, e2));
    [turned(cosine, sine), turned(-sine, cosine)]
}

/// The point of the plane through `origin` with the unit vector `normal` nearest to `p`.
pub fn onto_plane(p: Vector, origin: Vector, normal: Vector) -> Vector {
    along(p, -dot(minus(p, origin), normal), normal)
}

/// An angle brought into 0 to 2 pi.
pub fn positive_angle(angle: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    if turned >= TAU { 0.0 } else { turned }
}

/// The opposite vector, without the sign of a zero.
pub fn opposite(v: Vector) -> Vector {
    v.map(|value| 0.0 - value)
}

/// The middle of points.
pub fn mean(points: &[Vector]) -> Vector {
    let share = 1.0 / points.len().max(1) as f64;
    points.iter().fold([0.0; 3], |sum, p| along(sum, share, *p))
}

/// The greatest distance of points from a place; 0 without points.
pub fn reach(points: impl IntoIterator<Item = Vector>, from: Vector) -> f64 {
    let distances = points.into_iter().map(|p| distance(p, from));
    distances.fold(0.0, f64::max)
}

/// The greatest distance of points from the line through a place along a unit vector.
pub fn off_line(points: &[Vector], from: Vector, course: Vector) -> f64 {
    let off = points.iter().map(|p| across(minus(*p, from), course));
    reach(off, [0.0; 3])
}

/// The point of which a measure is greatest.
pub fn farthest(points: &[Vector], measure: impl Fn(Vector) -> f64) -> Option<Vector> {
    let all = points.iter().copied();
    all.max_by(|p, q| measure(*p).total_cmp(&measure(*q)))
}

/// The middle of two numbers; of one, if the other is endless, a step away, and 0 of none.
pub fn between(low: f64, high: f64, step: f64) -> f64 {
    match (low.is_finite(), high.is_finite()) {
        (true, true) => 0.5 * (low + high),
        (true, false) => low + step,
        (false, true) => high - step,
        (false, false) => 0.0,
    }
}

/// Least and greatest of some numbers.
pub fn range(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    values.fold(none, |[low, high], v| [low.min(v), high.max(v)])
}

/// Least and greatest coordinates of points; nothing without points.
pub fn hull(points: &[Vector]) -> Option<[Vector; 2]> {
    let ranges: [_; 3] = std::array::from_fn(|k| range(points.iter().map(|p| p[k])));
    (!points.is_empty()).then(|| [0, 1].map(|end| ranges.map(|range| range[end])))
}
