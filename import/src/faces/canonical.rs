//! Free-form surfaces that are planes, cylinders, cones, spheres or tori but for the digits of their file.
//!
//! A candidate is fitted to places and normals; what it is off is then bounded over the whole surface, not at places:
//! the equation of the candidate is a polynomial over every patch, whose coefficients in the Bernstein basis bound it.

use super::bezier::{Bernstein, Patch, Pole, plain};
use super::vector::*;
use super::{Form, Surface};
use nalgebra::{DMatrix, DVector, Matrix3, Matrix6, Vector3, Vector6};
use std::f64::consts::PI;

/// Places of a patch in each direction.
const PLACES: usize = 5;
/// Most patches from which places are taken.
const MOST_SAMPLED: usize = 40;
const STEPS: usize = 6;
/// Smallest and greatest angle of a cone, degrees.
const ANGLES: [f64; 2] = [0.1, 89.9];

/// A place of a surface and its unit normal.
type Place = (Vector, Vector);

/// What a surface is taken for.
#[derive(Clone, Debug, Default)]
pub struct Found {
    pub surface: Surface,
    /// Why it is not drawn although it is a quadric.
    pub refused: Option<String>,
    /// No place of the surface of the file is farther off it, scene units.
    pub off: f64,
    /// Its own normal is opposite to that of the surface of the file.
    pub opposite: bool,
}

/// The quadric, plane or torus that a surface of patches is within a length of.
pub fn canonical(patches: &[Patch], tolerance: f64) -> Option<Found> {
    let places = places(patches);
    let middle = mean(places.iter().map(|(p, _)| *p));
    let candidates = [plane, cylinder, sphere, cone, torus];
    let found = candidates.iter().filter_map(|fit| {
        let surface = improved(fit(&places, middle)?, &places);
        let nearest = |(p, _): &Place| Some(distance(*p, surface.nearest(*p)?));
        let near = |place| nearest(place).is_some_and(|off| off <= tolerance);
        if !places.iter().all(near) {
            return None;
        }
        let bounds = patches.iter().map(|patch| bound(patch, &surface));
        let off = bounds.fold(0.0, f64::max);
        (off <= tolerance).then_some((surface, off))
    });
    // The simpler kind of two that are as good.
    let (mut surface, off) = found.min_by(|a, b| (a.1 - 1e-12).total_cmp(&b.1))?;
    let agree = |(p, n): &Place| Some(dot(surface.normal_at(*p)?, *n));
    let opposite_normal = places.iter().filter_map(agree).sum::<f64>() < 0.0;
    let turned = surface.is_plane() && opposite_normal;
    if turned {
        surface.axis = opposite(surface.axis);
    }
    Some(Found {
        surface,
        off,
        opposite: opposite_normal && !turned,
        ..Found::default()
    })
}

fn places(patches: &[Patch]) -> Vec<Place> {
    let step = patches.len().div_ceil(MOST_SAMPLED);
    let mut all = vec![];
    for patch in patches.iter().step_by(step.max(1)) {
        for k in 0..PLACES * PLACES {
            let share = |k: usize| (k as f64 + 0.5) / PLACES as f64;
            let (u, v) = (share(k % PLACES), share(k / PLACES));
            let (place, [du, dv]) = patch.at(u, v);
            let normal = cross(du, dv);
            if length(normal) > 0.0 {
                all.push((place, unit(normal)));
            }
        }
    }
    all
}

fn mean(points: impl Iterator<Item = Vector>) -> Vector {
    let (sum, count) = points.fold(([0.0; 3], 0), |(sum, n), p| (plus(sum, p), n + 1));
    times(1.0 / f64::from(count.max(1)), sum)
}

fn plane(places: &[Place], middle: Vector) -> Option<Surface> {
    let normal = unit(mean(places.iter().map(|(_, n)| *n)));
    (length(normal) > 0.0).then(|| Surface::new(middle, normal, Form::Plane))
}

/// The direction in which vectors are least, as eigenvector of the sum of their squares.
fn least(vectors: impl Iterator<Item = Vector>) -> Vector {
    let mut sum = Matrix3::zeros();
    for v in vectors {
        let v = Vector3::from(v);
        sum += v * v.transpose();
    }
    let eigen = sum.symmetric_eigen();
    let axis = eigen.eigenvectors.column(eigen.eigenvalues.imin());
    unit([axis[0], axis[1], axis[2]])
}

/// The solution of equations in three unknowns by least squares.
fn solved(rows: impl Iterator<Item = (Vector, f64)>) -> Option<Vector> {
    let (mut matrix, mut right) = (Matrix3::zeros(), Vector3::zeros());
    for (row, value) in rows {
        let row = Vector3::from(row);
        matrix += row * row.transpose();
        right += row * value;
    }
    let found: Vector = matrix.lu().solve(&right)?.into();
    found.iter().all(|v| v.is_finite()).then_some(found)
}

/// The circle through points of a plane: its centre and its radius.
fn circle(points: &[[f64; 2]]) -> Option<([f64; 2], f64)> {
    let row = |[x, y]: &[f64; 2]| ([2.0 * x, 2.0 * y, 1.0], x * x + y * y);
    let [x, y, rest] = solved(points.iter().map(row))?;
    let square = rest + x * x + y * y;
    (square > 0.0).then(|| ([x, y], square.sqrt()))
}

fn cylinder(places: &[Place], middle: Vector) -> Option<Surface> {
    let axis = least(places.iter().map(|(_, n)| *n));
    let e = frame(axis, 0.0);
    let flat = |(p, _): &Place| e.map(|e| dot(minus(*p, middle), e));
    let ([x, y], radius) = circle(&places.iter().map(flat).collect::<Vec<_>>())?;
    let origin = along(along(middle, x, e[0]), y, e[1]);
    Some(Surface::new(origin, axis, Form::Cylinder(radius)))
}

fn sphere(places: &[Place], middle: Vector) -> Option<Surface> {
    // The normals of a sphere meet in its centre.
    let rows = places.iter().flat_map(|(p, n)| {
        let from = minus(*p, middle);
        frame(*n, 0.0).map(|e| (e, dot(e, from)))
    });
    let centre = plus(middle, solved(rows)?);
    let distances = places.iter().map(|(p, _)| distance(*p, centre));
    let radius = distances.sum::<f64>() / places.len() as f64;
    (radius > 0.0).then(|| Surface::new(centre, [0.0, 0.0, 1.0], Form::Sphere(radius)))
}

fn cone(places: &[Place], middle: Vector) -> Option<Surface> {
    let normal = mean(places.iter().map(|(_, n)| *n));
    let mut axis = least(places.iter().map(|(_, n)| minus(*n, normal)));
    let rows = places.iter().map(|(p, n)| (*n, dot(*n, minus(*p, middle))));
    let apex = plus(middle, solved(rows)?);
    if dot(axis, minus(middle, apex)) < 0.0 {
        axis = opposite(axis);
    }
    let half_angle = dot(normal, axis).abs().min(1.0).asin();
    let [least, most] = ANGLES.map(|angle| angle * PI / 180.0);
    let possible = (least..most).contains(&half_angle);
    possible.then(|| Surface::new(apex, axis, Form::Cone(half_angle)))
}

/// All normals of a surface that is turned about an axis meet it: six equations without a right side for the line.
fn torus(places: &[Place], middle: Vector) -> Option<Surface> {
    let size = reach(places.iter().map(|(p, _)| *p), middle);
    let mut sum = Matrix6::zeros();
    for (p, n) in places {
        let moment = cross(times(1.0 / size, minus(*p, middle)), *n);
        let row = Vector6::new(n[0], n[1], n[2], moment[0], moment[1], moment[2]);
        sum += row * row.transpose();
    }
    let eigen = sum.symmetric_eigen();
    let line = eigen.eigenvectors.column(eigen.eigenvalues.imin());
    let (moment, direction) = ([line[0], line[1], line[2]], [line[3], line[4], line[5]]);
    let square = dot(direction, direction);
    if square < 1e-6 {
        return None;
    }
    let foot = plus(middle, times(size / square, cross(direction, moment)));
    let axis = unit(direction);
    let profile = |(p, _): &Place| {
        let from = minus(*p, foot);
        [length(across(from, axis)), dot(from, axis)]
    };
    let ([major, height], minor) = circle(&places.iter().map(profile).collect::<Vec<_>>())?;
    let centre = along(foot, height, axis);
    (major > 1e-6 * size).then(|| Surface::new(centre, axis, Form::Torus(major, minor)))
}

fn numbers(surface: &Surface) -> Vec<f64> {
    let Surface { origin, axis, form } = surface;
    let sizes: &[f64] = match form {
        Form::Plane => &[],
        Form::Cylinder(size) | Form::Cone(size) => &[*size],
        Form::Sphere(radius) => return [&origin[..], &[*radius]].concat(),
        Form::Torus(major, minor) => &[*major, *minor],
        Form::Other(_) => return vec![],
    };
    [&origin[..], axis, sizes].concat()
}

fn with_numbers(surface: &Surface, n: &[f64]) -> Surface {
    let origin = [n[0], n[1], n[2]];
    if surface.is_sphere() {
        return Surface::new(origin, surface.axis, Form::Sphere(n[3]));
    }
    let form = match &surface.form {
        Form::Cylinder(_) => Form::Cylinder(n[6]),
        Form::Cone(_) => Form::Cone(n[6]),
        Form::Torus(..) => Form::Torus(n[6], n[7]),
        other => other.clone(),
    };
    Surface::new(origin, unit([n[3], n[4], n[5]]), form)
}

/// The best of its kind near a surface, by least squares of the distances (Gauss and Newton).
fn improved(surface: Surface, places: &[Place]) -> Surface {
    let off = |surface: &Surface| -> Option<DVector<f64>> {
        let each = places.iter().map(|(p, _)| {
            let q = surface.nearest(*p)?;
            Some(dot(minus(*p, q), surface.normal_at(q)?))
        });
        Some(DVector::from_vec(each.collect::<Option<Vec<f64>>>()?))
    };
    let mut best = surface;
    let Some(mut now) = off(&best) else {
        return best;
    };
    let size = reach(places.iter().map(|(p, _)| *p), places[0].0);
    for _ in 0..STEPS {
        let plain = numbers(&best);
        let step = 1e-6;
        let mut columns = vec![];
        for k in 0..plain.len() {
            // Places move with the size, directions and angles do not.
            let own = if k < 3 { step * size } else { step };
            let moved = |sign: f64| {
                let mut numbers = plain.clone();
                numbers[k] += sign * own;
                off(&with_numbers(&best, &numbers))
            };
            let (Some(plus), Some(minus)) = (moved(1.0), moved(-1.0)) else {
                return best;
            };
            columns.push((plus - minus) / (2.0 * own));
        }
        let jacobian = DMatrix::from_columns(&columns);
        let Ok(change) = jacobian.svd(true, true).solve(&now, 1e-9 * size.min(1.0)) else {
            return best;
        };
        let moved = plain.iter().zip(change.iter()).map(|(a, b)| a - b);
        let numbers: Vec<f64> = moved.collect();
        let next = with_numbers(&best, &numbers);
        match off(&next) {
            Some(less) if less.norm() < now.norm() => (best, now) = (next, less),
            _ => return best,
        }
    }
    best
}

/// No place of a patch is farther off a surface.
pub fn bound(patch: &Patch, surface: &Surface) -> f64 {
    // No place is below the least weight of a control point.
    let weights = patch.poles.iter().map(|pole| pole[3]);
    let weight = weights.fold(f64::INFINITY, f64::min);
    if weight <= 0.0 {
        return f64::INFINITY;
    }
    // A length along a direction from a point, times the weight.
    let Surface { origin, axis, .. } = *surface;
    let along = |d: Vector| patch.polynomial([d[0], d[1], d[2], -dot(origin, d)]);
    let square = |d: &Vector| along(*d).times(&along(*d));
    let squares = |axes: &[Vector]| -> Bernstein {
        let rest = axes[1..].iter();
        rest.fold(square(&axes[0]), |sum, d| sum.plus(1.0, &square(d)))
    };
    let one = patch.polynomial([0.0, 0.0, 0.0, 1.0]);
    let unit = one.times(&one);
    // The patch is in the convex hull of its control points.
    let height = |pole: &Pole| dot(minus(plain(pole), origin), axis);
    let heights = || patch.poles.iter().map(height);
    let [e, f] = frame(axis, 0.0);
    // The difference of squares over the sum.
    let round = |axes: &[Vector], radius: f64| {
        squares(axes).plus(-radius * radius, &unit).bound() / (weight * weight * radius)
    };
    match surface.form {
        Form::Plane => heights().map(f64::abs).fold(0.0, f64::max),
        Form::Cylinder(radius) => round(&[e, f], radius),
        Form::Sphere(radius) => round(&[[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], radius),
        Form::Cone(half_angle) => {
            let (sine, cosine) = half_angle.sin_cos();
            let scaled = squares(&[e, f]).plus(-(sine / cosine).powi(2), &square(&axis));
            let product = cosine * cosine * scaled.bound() / (weight * weight);
            // The distance from the cone times that from its mirror image, at least the height times twice the sine.
            let height = heights().fold(f64::INFINITY, f64::min);
            if height < -product.sqrt() {
                return f64::INFINITY;
            }
            product.sqrt().min(product / (height.max(0.0) * sine))
        }
        Form::Torus(major, minor) => {
            let inner = major * major - minor * minor;
            if inner <= 0.0 {
                return f64::INFINITY;
            }
            let sum = squares(&[e, f, axis]).plus(inner, &unit);
            let out = squares(&[e, f]).times(&unit);
            let quartic = sum.times(&sum).plus(-4.0 * major * major, &out);
            quartic.bound() / (weight.powi(4) * inner * minor)
        }
        Form::Other(_) => f64::INFINITY,
    }
}
