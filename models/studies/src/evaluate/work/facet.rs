//! A facet of three corners on its way to the display: set-up of both conversions, quantities over it, whole numbers
//! (source: Tables 5.1, 5.4, 5.5).

use crate::evaluate::count::{Counted, number};
use imogene_algebra::vector::dot;

/// Corners: column, line, depth.
pub type Corners = [[Counted; 3]; 3];

/// `a x + b y + c`.
pub type Line = [Counted; 3];

/// What stays of the set-up for the quantities.
#[derive(Clone, Copy, Debug)]
pub struct Shape {
    /// Second and third corner less the first, column and line.
    pub sides: [[Counted; 2]; 2],
    /// One over the doubled area.
    pub over_area: Counted,
}

/// A facet ready to be drawn by following its contour.
#[derive(Clone, Debug)]
pub struct Contour {
    /// Corners by ascending line.
    pub corners: Corners,
    /// Columns per line of the sides 0-1, 0-2 and 1-2; none along a line.
    pub slopes: [Option<Counted>; 3],
    /// The middle corner is right of the long side.
    pub middle_is_right: bool,
    /// Depth per column and per line.
    pub depth: [Counted; 2],
    /// Depth per line along each side that can be the left one.
    pub depth_steps: Vec<Counted>,
    /// For the quantities.
    pub shape: Shape,
}

/// The set-up of contour following; nothing for a facet without area.
pub fn contour(mut corners: Corners) -> Option<Contour> {
    for (i, j) in [(0, 1), (1, 2), (0, 1)] {
        if corners[j][1].is_below(corners[i][1]) {
            corners.swap(i, j);
        }
    }
    let difference =
        |(i, j): (usize, usize)| [0, 1].map(|axis| corners[j][axis] - corners[i][axis]);
    let [one, two, third] = [(0, 1), (0, 2), (1, 2)].map(difference);
    let sides = [one, two];
    let slopes = [one, two, third].map(|[dx, dy]| (!dy.is_zero()).then(|| dx / dy));
    let area = sides[0][0] * sides[1][1] - sides[1][0] * sides[0][1];
    if area.is_zero() {
        return None;
    }
    let middle_is_right = !area.is_negative();
    let shape = Shape {
        sides,
        over_area: area.reciprocal(),
    };
    let depth = gradient(&shape, corners.map(|corner| corner[2]));
    let depth_steps = steps(depth, middle_is_right, &slopes);
    Some(Contour {
        corners,
        slopes,
        middle_is_right,
        depth,
        depth_steps,
        shape,
    })
}

/// Change per column and per line of a quantity given at the corners.
fn gradient(shape: &Shape, w: [Counted; 3]) -> [Counted; 2] {
    let (dw1, dw2) = (w[1] - w[0], w[2] - w[0]);
    let [[x1, y1], [x2, y2]] = shape.sides;
    let twice = [dw1 * y2 - dw2 * y1, x1 * dw2 - x2 * dw1];
    twice.map(|v| v * shape.over_area)
}

/// Change per line along the sides on the left.
fn steps(
    [across, down]: [Counted; 2],
    middle_is_right: bool,
    slopes: &[Option<Counted>; 3],
) -> Vec<Counted> {
    let left: &[usize] = if middle_is_right { &[1] } else { &[0, 2] };
    let slopes = left.iter().filter_map(|&side| slopes[side]);
    slopes.map(|slope| down + slope * across).collect()
}

/// A quantity for contour following: change per column, and per line along the left.
pub fn followed(contour: &Contour, w: [Counted; 3]) -> Vec<Counted> {
    let slope = gradient(&contour.shape, w);
    let steps = steps(slope, contour.middle_is_right, &contour.slopes);
    [vec![slope[0]], steps].concat()
}

/// A facet as expressions.
#[derive(Clone, Debug)]
pub struct Expressions {
    /// Sides, not negative inside.
    pub sides: [Line; 3],
    /// Depth.
    pub depth: Line,
    /// For the quantities.
    pub shape: Shape,
}

/// The set-up of the expressions. A facet of no area gives a division by zero: its sides leave no pixel.
pub fn expressions(corners: Corners) -> Expressions {
    let mut sides = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| {
        let [p, q] = [corners[i], corners[j]];
        [p[1] - q[1], q[0] - p[0], p[0] * q[1] - q[0] * p[1]]
    });
    // The three constants are twice the areas of the triangles with the origin.
    let mut area = sides[0][2] + sides[1][2] + sides[2][2];
    if area.is_negative() {
        sides = sides.map(|side| side.map(|v| -v));
        area = -area;
    }
    let shape = Shape {
        sides: [[sides[0][1], -sides[0][0]], [-sides[2][1], sides[2][0]]],
        over_area: area.reciprocal(),
    };
    let depth = expressed(&shape, corners, corners.map(|corner| corner[2]));
    Expressions {
        sides,
        depth,
        shape,
    }
}

/// A quantity as an expression.
pub fn expressed(shape: &Shape, corners: Corners, w: [Counted; 3]) -> Line {
    let [a, b] = gradient(shape, w);
    [a, b, w[0] - a * corners[0][0] - b * corners[0][1]]
}

/// The value of an expression.
pub fn value(line: &Line, x: Counted, y: Counted) -> Counted {
    dot([line[0], line[1]], [x, y]) + line[2]
}

/// Is a point inside the facet? All sides are asked.
pub fn is_inside(sides: &[Line], x: Counted, y: Counted) -> bool {
    let outside = sides.iter().filter(|side| value(side, x, y).is_negative());
    outside.count() == 0
}

/// Words of the expressions: corners on a grid of 1/16 pixel, so that the sides are whole without a further conversion;
/// depth and quantities scaled and rounded.
pub fn expression_words(
    corners: Corners,
    quantities: [[Counted; 3]; 3],
    depth_scale: Counted,
    quantity_scale: Counted,
) -> (Expressions, Vec<Counted>) {
    let subpixels = number(16.0);
    let on_grid = corners.map(|[x, y, z]| [x.scaled(subpixels), y.scaled(subpixels), z]);
    let facet = expressions(on_grid);
    let mut words = facet.depth.map(|v| v.scaled(depth_scale)).to_vec();
    for w in quantities {
        let line = expressed(&facet.shape, on_grid, w);
        words.extend(line.map(|v| v.scaled(quantity_scale)));
    }
    (facet, words)
}

/// Words of contour following: the slopes, the column and the line of the first corner, depth and quantities with their
/// first value and their changes.
pub fn contour_words(
    contour: &Contour,
    quantities: [[Counted; 3]; 3],
    depth_scale: Counted,
    quantity_scale: Counted,
) -> Vec<Counted> {
    let subpixels = number(16.0);
    let first = contour.corners[0];
    let ends = contour.slopes.iter().flatten().chain(&first[..2]);
    let mut words: Vec<Counted> = ends.map(|v| v.scaled(subpixels)).collect();
    let depth = [first[2], contour.depth[0]];
    let depth = depth.iter().chain(&contour.depth_steps);
    words.extend(depth.map(|v| v.scaled(depth_scale)));
    for w in quantities {
        let values = [w[0]].into_iter().chain(followed(contour, w));
        words.extend(values.map(|v| v.scaled(quantity_scale)));
    }
    words
}
