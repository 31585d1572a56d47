//! A quadric and its planes on their way to the display: expressions, scales, whole numbers (source: 2.4.4, Table 5.6,
//! Fig B.4).
//!
//! Quadric and planes are given after the change of frame and the perspective, which is a factor of the matrix.

use super::transform::normalised;
use crate::evaluate::count::{Counted, number};

/// Depth of the quadric: `f1 -+ sqrt(f2)`.
#[derive(Clone, Copy, Debug)]
pub struct Depth {
    /// Factors of x, y and 1.
    pub f1: [Counted; 3],
    /// Factors of x^2, y^2, xy, x, y and 1.
    pub f2: [Counted; 6],
    /// The viewer is inside.
    pub is_front_view: bool,
}

/// f1 and f2 of the coefficients a to j; nothing for a quadric without z^2.
pub fn depth(q: [Counted; 10]) -> Option<Depth> {
    let [a, b, c, d, e, f, g, h, i, j] = q;
    if c.is_zero() {
        return None;
    }
    let is_front_view = c.is_negative();
    let over = c.reciprocal();
    let [x, y, one] = [e, f, i].map(|v| -(v * over));
    let entry = |p: Counted, r: Counted, v: Counted| p * r - v * over;
    let f2 = [
        entry(x, x, a),
        entry(y, y, b),
        entry(x, y, d).doubled(),
        entry(x, one, g).doubled(),
        entry(y, one, h).doubled(),
        entry(one, one, j),
    ];
    Some(Depth {
        f1: [x, y, one],
        f2,
        is_front_view,
    })
}

/// The normal before perspective: linear part on the polar plane and factor of the root, for each component.
#[derive(Clone, Copy, Debug)]
pub struct Normal {
    /// Factors of x, y and 1.
    pub g: [[Counted; 3]; 3],
    /// Factors of the root.
    pub k: [Counted; 3],
}

/// Half the gradient as `g(x, y) -+ K root`; `over_distance` is one over the viewer's distance.
pub fn normal(q: [Counted; 10], f1: &[Counted; 3], over_distance: Counted) -> Normal {
    let [a, b, c, d, e, f, g, h, i, j] = q;
    let before = |v: Counted, w: Counted| v + w * over_distance;
    let linear = [
        [a, d, g],
        [d, b, h],
        [before(e, g), before(f, h), before(i, j)],
    ];
    let k = [e, f, before(c, i)];
    let on_polar_plane = |component: usize| -> [Counted; 3] {
        std::array::from_fn(|term| linear[component][term] + k[component] * f1[term])
    };
    Normal {
        g: [0, 1, 2].map(on_polar_plane),
        k,
    }
}

/// The greatest f2 of a closed outline: its value where it is stationary.
pub fn greatest_f2([a, b, c, d, e, f]: &[Counted; 6]) -> Counted {
    let determinant = (*a * *b).doubled().doubled() - *c * *c;
    let over = determinant.reciprocal();
    let x = (*c * *e - (*b * *d).doubled()) * over;
    let y = (*c * *d - (*a * *e).doubled()) * over;
    *f + (*d * x + *e * y) * number(0.5)
}

/// The greatest size of a component of the normal over a box whose first pixel is (x, y).
pub fn greatest_normal(normal: &Normal, root: Counted, [x, y, w, h]: [Counted; 4]) -> Counted {
    let component = |k: usize| {
        let [a, b, c] = normal.g[k];
        let (across, down) = (a * w, b * h);
        let first = a * x + b * y + c;
        let (right, below) = (first + across, first + down);
        let corners = [first, right, below, below + across].map(Counted::size);
        let most = corners.into_iter().reduce(Counted::or_greater);
        most.expect("four") + (normal.k[k] * root).size()
    };
    let most = [0, 1, 2].map(component).into_iter();
    most.reduce(Counted::or_greater).expect("three")
}

/// Words of the depth with the scale Kp.
pub fn depth_words(depth: &Depth, scale: Counted, square: Counted) -> [Counted; 9] {
    std::array::from_fn(|word| match word {
        0..3 => depth.f1[word].scaled(scale),
        _ => depth.f2[word - 3].scaled(square),
    })
}

/// Words of the normal with a scale Kn of its own; the factors of the root, which is scaled by Kp, take Kn / Kp.
pub fn normal_words(normal: &Normal, greatest: Counted, over_depth_scale: Counted) -> Vec<Counted> {
    let full = number(32_767.0 * 256.0);
    let scale = full / greatest;
    let root_scale = scale * over_depth_scale;
    let linear = normal.g.into_iter().flatten().map(|v| v.scaled(scale));
    let of_root = normal.k.map(|v| v.scaled(root_scale));
    linear.chain(of_root).collect()
}

/// How a plane lies to the viewer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Towards the viewer.
    Front,
    /// Away.
    Back,
    /// Along the line of sight, or so steep that its depth does not fit its word.
    Perpendicular,
}

/// A plane as an expression: its depth, or what is not negative where it keeps.
pub fn plane(
    [a, b, c, d]: [Counted; 4],
    depth_scale: Counted,
    steepest: Counted,
) -> (Kind, [Counted; 3]) {
    if c.is_zero() {
        return (Kind::Perpendicular, [-a, -b, -d]);
    }
    let over = c.reciprocal();
    let depth = [a, b, d].map(|v| -(v * over));
    let slope = depth[0].size().or_greater(depth[1].size());
    if steepest.is_below(slope * depth_scale) {
        (Kind::Perpendicular, [-a, -b, -d])
    } else if c.is_negative() {
        (Kind::Front, depth)
    } else {
        (Kind::Back, depth)
    }
}

/// Words of a constant normal.
pub fn constant_normal(normal: [Counted; 3]) -> [Counted; 3] {
    normalised(normal).map(|v| v.scaled(number(32_767.0)))
}
