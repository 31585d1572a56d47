//! Zones of the screen: which an object touches, and its expressions moved to one (source: 1.3.2, 2.4.4, Table 5.8).

use super::facet::{Line, value};
use crate::evaluate::count::{Counted, number};

/// The box of points of the screen: least and greatest column, least and greatest line.
pub fn box_of(points: &[[Counted; 2]]) -> [Counted; 4] {
    let (first, others) = points.split_first().expect("points");
    let mut found = [first[0], first[0], first[1], first[1]];
    for point in others {
        for (axis, &place) in point.iter().enumerate() {
            let [least, most] = [2 * axis, 2 * axis + 1];
            found[least] = found[least].or_smaller(place);
            found[most] = found[most].or_greater(place);
        }
    }
    found
}

/// The zones of a box, first and last, across and down; `over_side` is one over the side of a zone.
pub fn zones(window: [Counted; 4], over_side: Counted) -> [Counted; 4] {
    window.map(|v| (v * over_side).floor())
}

/// The box of the outline `f2 >= 0` of a closed quadric, from its tangents along the axes.
pub fn box_of_outline([a, b, c, d, e, f]: &[Counted; 6]) -> [Counted; 4] {
    let half = number(0.5);
    let [c, d, e] = [*c, *d, *e].map(|v| v * half);
    // Cofactors of the conic's matrix (a c d / c b e / d e f).
    let corner = *a * *b - c * c;
    let x = c * e - *b * d;
    let y = c * d - *a * e;
    let xx = *b * *f - e * e;
    let yy = *a * *f - d * d;
    let over = corner.reciprocal();
    let [x, y] = [x * over, y * over];
    let reach = |middle: Counted, cofactor: Counted| {
        let reach = (middle * middle - cofactor * over).root();
        [middle - reach, middle + reach]
    };
    let ([x0, x1], [y0, y1]) = (reach(x, xx), reach(y, yy));
    [x0, x1, y0, y1]
}

/// The sides of the outline of a convex solid's corners on the screen: the lines through two of them with all others on
/// one side, not negative inside.
pub fn outline(corners: &[[Counted; 2]]) -> Vec<Line> {
    outline_of(corners, |_, _| true)
}

/// The same where it is known which pairs are edges of the solid.
pub fn outline_of(corners: &[[Counted; 2]], is_edge: impl Fn(usize, usize) -> bool) -> Vec<Line> {
    let pairs = (0..corners.len()).flat_map(|i| (i + 1..corners.len()).map(move |j| (i, j)));
    let edges = pairs.filter(|&(i, j)| is_edge(i, j));
    edges.filter_map(|(i, j)| side_of(corners, i, j)).collect()
}

fn side_of(corners: &[[Counted; 2]], i: usize, j: usize) -> Option<Line> {
    let (p, q) = (corners[i], corners[j]);
    let line = [p[1] - q[1], q[0] - p[0], p[0] * q[1] - q[0] * p[1]];
    let mut others = (0..corners.len()).filter(|&k| k != i && k != j);
    let is_negative = |k: usize| value(&line, corners[k][0], corners[k][1]).is_negative();
    let first = is_negative(others.next()?);
    let alike = others.all(|k| is_negative(k) == first);
    alike.then(|| if first { line.map(|v| -v) } else { line })
}

/// The expression seen from a zone's first pixel (k, l).
pub fn moved_line([a, b, c]: &Line, k: Counted, l: Counted) -> Line {
    [*a, *b, *c + *a * k + *b * l]
}

/// The same of a second-degree expression.
pub fn moved_conic([a, b, c, d, e, f]: &[Counted; 6], k: Counted, l: Counted) -> [Counted; 6] {
    let (ak, bl) = (*a * k, *b * l);
    let cl = *c * l;
    let along = *d + ak + cl;
    let down = *e + bl;
    let constant = *f + along * k + down * l;
    [*a, *b, *c, along + ak, down + bl + *c * k, constant]
}
