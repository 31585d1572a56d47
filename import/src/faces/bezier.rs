//! Rational Bezier patches, and polynomials over them: the greatest Bernstein coefficient bounds a polynomial.

use super::vector::Vector;

/// A point times its weight, and the weight.
pub type Pole = [f64; 4];

/// A control point without its weight.
pub fn plain(p: &Pole) -> Vector {
    [p[0] / p[3], p[1] / p[3], p[2] / p[3]]
}

/// A control point with a weight.
pub fn weighted([x, y, z]: Vector, weight: f64) -> Pole {
    [x * weight, y * weight, z * weight, weight]
}

/// A rational patch over the unit square.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Degrees in u and v.
    pub degrees: [usize; 2],
    /// Control points, those of one u after another.
    pub poles: Vec<Pole>,
}

impl Patch {
    /// One coordinate or a combination of the four, as a polynomial.
    pub fn polynomial(&self, weights: Pole) -> Bernstein {
        let degrees = self.degrees;
        let [rows, columns] = degrees.map(binomials);
        let width = columns.len();
        let scaled = |(k, pole): (usize, &Pole)| {
            let value: f64 = pole.iter().zip(weights).map(|(p, w)| p * w).sum();
            value * rows[k / width] * columns[k % width]
        };
        let scaled = self.poles.iter().enumerate().map(scaled).collect();
        Bernstein { degrees, scaled }
    }

    /// The place of two parameters from 0 to 1, and the directions of growing u and v there.
    pub fn at(&self, u: f64, v: f64) -> (Vector, [Vector; 2]) {
        let [_, q] = self.degrees;
        let rows = self.poles.chunks(q + 1).map(|row| casteljau(row, v));
        let (places, slopes): (Vec<Pole>, Vec<Pole>) = rows.unzip();
        let (place, du) = casteljau(&places, u);
        let (dv, _) = casteljau(&slopes, u);
        let point = plain(&place);
        let slope = |d: Pole| std::array::from_fn(|k| (d[k] - point[k] * d[3]) / place[3]);
        (point, [slope(du), slope(dv)])
    }
}

/// The value and the derivative of a curve by its control points.
fn casteljau(poles: &[Pole], t: f64) -> (Pole, Pole) {
    let mut points = poles.to_vec();
    let degree = points.len() - 1;
    let mut slope = [0.0; 4];
    for round in 1..=degree {
        if round == degree {
            slope = std::array::from_fn(|k| degree as f64 * (points[1][k] - points[0][k]));
        }
        for i in 0..=degree - round {
            points[i] = std::array::from_fn(|k| (1.0 - t) * points[i][k] + t * points[i + 1][k]);
        }
    }
    (points[0], slope)
}

/// A polynomial in two variables: Bernstein coefficients times their binomials, so that products are convolutions.
#[derive(Clone, Debug)]
pub struct Bernstein {
    degrees: [usize; 2],
    scaled: Vec<f64>,
}

fn binomials(degree: usize) -> Vec<f64> {
    let mut row = vec![1.0];
    for k in 0..degree {
        row.push(row[k] * (degree - k) as f64 / (k + 1) as f64);
    }
    row
}

impl Bernstein {
    /// The product.
    pub fn times(&self, other: &Bernstein) -> Bernstein {
        let [p, q] = self.degrees;
        let [r, s] = other.degrees;
        let width = q + s + 1;
        let mut scaled = vec![0.0; (p + r + 1) * width];
        for (i, a) in self.scaled.iter().enumerate().filter(|(_, a)| **a != 0.0) {
            let start = i / (q + 1) * width + i % (q + 1);
            for (j, b) in other.scaled.iter().enumerate() {
                scaled[start + j / (s + 1) * width + j % (s + 1)] += a * b;
            }
        }
        let degrees = [p + r, q + s];
        Bernstein { degrees, scaled }
    }

    /// `self + factor * other`, of the same degrees.
    pub fn plus(mut self, factor: f64, other: &Bernstein) -> Bernstein {
        for (value, other) in self.scaled.iter_mut().zip(&other.scaled) {
            *value += factor * other;
        }
        self
    }

    /// No place of the patch has a greater absolute value.
    pub fn bound(&self) -> f64 {
        let [rows, columns] = self.degrees.map(binomials);
        let width = columns.len();
        let each = self.scaled.iter().enumerate();
        let plain = each.map(|(k, value)| value / (rows[k / width] * columns[k % width]));
        plain.map(f64::abs).fold(0.0, f64::max)
    }
}

/// The Bezier pieces of a B-spline curve: the polar form at the ends of each of its intervals.
pub fn pieces(degree: usize, knots: &[f64], poles: &[Pole]) -> Vec<Vec<Pole>> {
    let spans = (degree..poles.len()).filter(|span| knots[*span] < knots[span + 1]);
    let piece = |span: usize| {
        let own = &poles[span - degree..=span];
        let end = |k: usize, n: usize| knots[span + usize::from(n >= degree - k)];
        let pole = |k| de_boor(degree, knots, own, span, |n| end(k, n));
        (0..=degree).map(pole).collect()
    };
    spans.map(piece).collect()
}

/// The polar form of the piece of a span (de Boor with an argument for each round).
pub fn de_boor(
    degree: usize,
    knots: &[f64],
    poles: &[Pole],
    span: usize,
    argument: impl Fn(usize) -> f64,
) -> Pole {
    let mut points = poles.to_vec();
    for round in 1..=degree {
        let u = argument(round - 1);
        for k in (round..=degree).rev() {
            let (left, right) = (knots[span - degree + k], knots[span + 1 + k - round]);
            let width = right - left;
            let share = if width > 0.0 { (u - left) / width } else { 0.0 };
            let before = points[k - 1];
            points[k] = std::array::from_fn(|n| (1.0 - share) * before[n] + share * points[k][n]);
        }
    }
    points[degree]
}

/// The patches of a B-spline surface; `poles[i][j]` is that of the i-th in u and the j-th in v.
pub fn patches(degrees: [usize; 2], knots: [&[f64]; 2], poles: &[Vec<Pole>]) -> Vec<Patch> {
    let rows = poles.iter().map(|row| pieces(degrees[1], knots[1], row));
    let along_v: Vec<Vec<Vec<Pole>>> = rows.collect();
    let counts = degrees.map(|degree| degree + 1);
    let mut all = vec![];
    for piece in 0..along_v[0].len() {
        // For each control point of the piece in v the column in u.
        let column = |j: usize| {
            let column: Vec<Pole> = along_v.iter().map(|row| row[piece][j]).collect();
            pieces(degrees[0], knots[0], &column)
        };
        let columns: Vec<Vec<Vec<Pole>>> = (0..counts[1]).map(column).collect();
        all.extend((0..columns[0].len()).map(|own| {
            let pole = |k: usize| columns[k % counts[1]][own][k / counts[1]];
            let poles = (0..counts[0] * counts[1]).map(pole).collect();
            Patch { degrees, poles }
        }));
    }
    all
}
