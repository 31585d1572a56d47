//! The facet processor: a flat facet of three or four sides with Phong's interpolated normals (source: Chaillou,
//! IV.2.2; Nyiri, 4.1.2).

use super::paraboloid::{one_face, plane_guard};
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::Format;
use crate::unit::depth_interval::FACE_PLANE;
use crate::unit::normal::LINEAR_WIDTH;
use crate::unit::pe1::Linear;
use imogene_algebra::rational::{fraction, integer, power_of_two, round_half_up};
use num_rational::BigRational;
use num_traits::{ToPrimitive, Zero};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Bits of a corner's place below a pixel.
pub const SUBPIXEL: u32 = 4;
/// Largest component of a corner's normal; the rest of the word is for rounding.
pub const MAX_COMPONENT: i16 = 32_000;
/// Number of the facet among the faces.
pub const FACE_FACET: u8 = FACE_PLANE;

/// A corner of a facet.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Corner {
    /// Column in units of `2^-SUBPIXEL` pixels.
    pub x: i64,
    /// Line, likewise.
    pub y: i64,
    /// Depth in depth words.
    pub z: BigRational,
    /// Normal.
    pub normal: [i16; 3],
}

/// Corners that are no facet.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum FacetError {
    /// Neither three nor four.
    #[error("a facet of {0} corners; accepted: 3 or 4")]
    Corners(usize),
    /// No area on the screen, or corners that do not go round once.
    #[error("the corners of the facet do not go round a convex area of the screen")]
    NotConvex,
    /// The fourth corner is elsewhere.
    #[error(
        "the four corners of the facet have no common {0}; draw it as two facets of three corners"
    )]
    NotLinear(&'static str),
    /// A normal that is too long for its word.
    #[error("component {0} of a corner's normal; accepted: -{MAX_COMPONENT} to {MAX_COMPONENT}")]
    Component(i16),
}

/// All coefficient words of one facet for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct FacetWords {
    /// Where the facet can be on the screen.
    pub screen_box: ScreenBox,
    /// Its three or four sides, P bits, not negative inside.
    pub edges: Vec<Linear>,
    /// Its depth, P bits, in units of `2^-10` depth words.
    pub depth: Linear,
    /// Its normal, 24 bits.
    pub normal: [Linear; 3],
}

/// The side from one corner to the next, not negative on its left (clockwise as lines grow downwards), in whole pixels.
///
/// A pixel exactly on a side belongs to the facet that has the side's left at a slightly greater column, or, if the
/// side runs along a line, at a slightly greater line. The neighbour has the same side the other way round, so exactly
/// one of them has the pixel; and all sides of a corner agree, because the rule is to look at the pixel moved by an
/// infinitely small step.
fn edge(from: &Corner, to: &Corner) -> Linear {
    let (a, b) = (i128::from(from.y - to.y), i128::from(to.x - from.x));
    let c = i128::from(from.x) * i128::from(to.y) - i128::from(to.x) * i128::from(from.y);
    let owned = a > 0 || (a == 0 && b > 0);
    // (a, b) multiply whole pixels, c is finer: its floor keeps every sign.
    let constant = (c - i128::from(!owned)) >> SUBPIXEL;
    Linear::new(a, b, constant)
}

fn doubled_area(p: &Corner, q: &Corner, r: &Corner) -> i128 {
    let [ux, uy] = [q.x - p.x, q.y - p.y].map(i128::from);
    let [vx, vy] = [r.x - p.x, r.y - p.y].map(i128::from);
    ux * vy - vx * uy
}

/// The first-degree expression in pixels with the values `w` at three corners.
fn through(corners: [&Corner; 3], w: [&BigRational; 3]) -> [BigRational; 3] {
    let [p, q, r] = corners;
    let unit = |v: i64| fraction(v, 1 << SUBPIXEL);
    let [ux, uy, vx, vy] = [q.x - p.x, q.y - p.y, r.x - p.x, r.y - p.y].map(unit);
    let (dq, dr) = (w[1] - w[0], w[2] - w[0]);
    let area = &ux * &vy - &vx * &uy;
    let a = (&dq * &vy - &dr * &uy) / &area;
    let b = (&ux * &dr - &vx * &dq) / &area;
    let c = w[0] - &a * unit(p.x) - &b * unit(p.y);
    [a, b, c]
}

fn linear_value(
    corners: &[Corner],
    of: impl Fn(&Corner) -> BigRational,
    name: &'static str,
) -> Result<[BigRational; 3], FacetError> {
    let w: Vec<BigRational> = corners.iter().map(&of).collect();
    let first = [&corners[0], &corners[1], &corners[2]];
    let exact = through(first, [&w[0], &w[1], &w[2]]);
    if let [_, _, _, fourth] = corners {
        let [a, b, c] = &exact;
        let [x, y] = [fourth.x, fourth.y].map(|v| fraction(v, 1 << SUBPIXEL));
        if !(a * x + b * y + c - &w[3]).is_zero() {
            return Err(FacetError::NotLinear(name));
        }
    }
    Ok(exact)
}

/// An expression in units of `2^-guard`, rounded, half a unit of the result added: the shift at the end then rounds to
/// nearest.
fn first_degree(exact: &[BigRational; 3], guard: u32) -> Linear {
    let unit = power_of_two(guard);
    let [a, b, c] = exact.each_ref().map(|value| {
        let word = round_half_up(&(value * &unit)).to_i128();
        word.expect("a coefficient word has fewer than 128 bits")
    });
    Linear::new(a, b, c + (1 << guard >> 1))
}

impl FacetWords {
    /// The words of the facet with these corners, in either sense of rotation.
    pub fn new(
        corners: &[Corner],
        screen_box: ScreenBox,
        format: &Format,
    ) -> Result<FacetWords, FacetError> {
        let n = corners.len();
        if !(3..=4).contains(&n) {
            return Err(FacetError::Corners(n));
        }
        let mut components = corners.iter().flat_map(|c| c.normal);
        let is_long = |v: &i16| v.unsigned_abs() > MAX_COMPONENT as u16;
        if let Some(bad) = components.find(is_long) {
            return Err(FacetError::Component(bad));
        }
        let corner = |i: usize| &corners[i % n];
        let turn = |i| doubled_area(corner(i), corner(i + 1), corner(i + 2));
        let turns: Vec<i128> = (0..n).map(turn).collect();
        let left = turns.iter().all(|&t| t > 0);
        if !left && !turns.iter().all(|&t| t < 0) {
            return Err(FacetError::NotConvex);
        }
        let side = |i: usize| {
            let (from, to) = (corner(i), corner(i + 1));
            if left { edge(from, to) } else { edge(to, from) }
        };
        let depth = linear_value(corners, |c| c.z.clone(), "plane")?;
        let mut normal = [Linear::default(); 3];
        for (k, words) in normal.iter_mut().enumerate() {
            let component = |c: &Corner| integer(c.normal[k].into());
            let exact = linear_value(corners, component, "interpolation of normals")?;
            *words = first_degree(&exact, LINEAR_WIDTH - format.normal);
        }
        Ok(FacetWords {
            screen_box,
            edges: (0..n).map(side).collect(),
            depth: first_degree(&depth, plane_guard(format)),
            normal,
        })
    }
}

impl Words for FacetWords {
    fn parts_mut(&mut self) -> Parts<'_> {
        let all = self.edges.iter_mut().chain([&mut self.depth]);
        let all = all.chain(&mut self.normal).map(Expression::First);
        (vec![&mut self.screen_box], all.collect())
    }
}

/// Latency in clocks from the raster flags to the outputs: processors; signs and ends of the depth word; selection.
pub const LATENCY: u32 = 3;

impl Object for FacetWords {
    /// Front and back depth are the same.
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let not_negative = |edge: &Linear| edge.wrapped_at(x, y, format.plane) >= 0;
        let inside = self.screen_box.contains(x, y) && self.edges.iter().all(not_negative);
        let z = self.depth.wrapped_at(x, y, format.plane) >> plane_guard(format);
        let face = one_face(z as i64, FACE_FACET, inside, format);
        let component = |n: &Linear| linear_component(n, x, y);
        ObjectPixel::of(face, || self.normal.each_ref().map(component), format)
    }
}

/// A component of a normal that has a first-degree expression of its own.
pub(super) fn linear_component(n: &Linear, x: i64, y: i64) -> i16 {
    (n.wrapped_at(x, y, LINEAR_WIDTH) >> (LINEAR_WIDTH - 16)) as i16
}
