//! The sphere processor of the first machine: an exact outline, and a paraboloid for the depth (source: Chaillou,
//! IV.2.4).

use super::facet::linear_component;
use super::paraboloid::*;
use super::screen_box::ScreenBox;
use super::words::{Expression, Object, ObjectPixel, Parts, Words};
use crate::format::{Format, wrap64};
use crate::unit::depth_interval::{Class, FACE_NEAR_END, halves};
use crate::unit::normal::{LINEAR_WIDTH, NEAR_END_NORMAL};
use crate::unit::pe1::Linear;
use crate::unit::pe2::Quadratic;
use imogene_algebra::rational::{integer, round_half_up};
use num_rational::BigRational;
use num_traits::ToPrimitive;
use serde::{Deserialize, Serialize};

/// A sphere of an orthographic view: centre in pixels and depth words, radius in pixels.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SphereShape {
    /// Column of the centre.
    pub x: BigRational,
    /// Line of the centre.
    pub y: BigRational,
    /// Depth of the centre in depth words.
    pub z: BigRational,
    /// Radius in pixels, positive.
    pub radius: BigRational,
    /// Depth words per pixel, positive.
    pub scale: BigRational,
}

/// All coefficient words of one sphere for one zone.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct SphereWords {
    /// Where the sphere can be on the screen.
    pub screen_box: ScreenBox,
    /// Not negative inside the outline.
    pub contour: Quadratic,
    /// Front depth, in units of `2^-(W-2)` depth words.
    pub front: Quadratic,
    /// Front and back depth together, the same at every pixel: what the source spends a fourth PE2 on.
    pub sum: i64,
    /// Normal in x and y, 24 bits.
    pub normal: [Linear; 2],
    /// Normal in z, F bits.
    pub normal_z: Quadratic,
}

impl SphereShape {
    /// The paraboloid's front depth as an expression in pixels: `z - s (a R - b r^2 / R)`.
    pub fn paraboloid(&self) -> Exact {
        let (a, b) = bulge();
        let factor = b * &self.scale / &self.radius;
        let top = &self.z - a * &self.radius * &self.scale;
        self.round(&factor, top)
    }

    /// `factor ((x - x1)^2 + (y - y1)^2) + top`.
    fn round(&self, factor: &BigRational, top: BigRational) -> Exact {
        let minus_two = integer(-2) * factor;
        let far = factor * (&self.x * &self.x + &self.y * &self.y);
        [
            factor.clone(),
            factor.clone(),
            integer(0),
            &minus_two * &self.x,
            &minus_two * &self.y,
            top + far,
        ]
    }

    /// Not negative inside the outline: `R^2 - r^2`.
    pub fn outline(&self) -> Exact {
        self.round(&integer(-1), &self.radius * &self.radius)
    }

    /// The normal's parts along columns and along lines, of length [`NORMAL_LENGTH`].
    pub fn normal_across(&self) -> [[BigRational; 3]; 2] {
        let slope = integer(NORMAL_LENGTH) / &self.radius;
        [
            [slope.clone(), integer(0), -&slope * &self.x],
            [integer(0), slope.clone(), -&slope * &self.y],
        ]
    }

    /// The normal's part along the depth, by the same paraboloid as the depth.
    pub fn normal_deep(&self) -> Exact {
        let (high, low) = bulge();
        let length = integer(NORMAL_LENGTH);
        let deep = low * &length / (&self.radius * &self.radius);
        self.round(&deep, -high * length)
    }

    /// The coefficient words.
    pub fn words(&self, screen_box: ScreenBox, format: &Format) -> SphereWords {
        let across = |exact: &[BigRational; 3]| first_degree(exact, LINEAR_WIDTH - format.normal);
        let sum = round_half_up(&(integer(2) * &self.z)).to_i64();
        SphereWords {
            screen_box,
            contour: Quadratic::new(contour(&self.outline())),
            front: second_degree(&self.paraboloid(), depth_guard(format)),
            sum: sum.expect("twice a depth word has fewer than 64 bits"),
            normal: self.normal_across().each_ref().map(across),
            normal_z: second_degree(&self.normal_deep(), normal_guard(format)),
        }
    }
}

impl Words for SphereWords {
    fn screen_box(&self) -> &ScreenBox {
        &self.screen_box
    }

    fn parts_mut(&mut self) -> Parts<'_> {
        let second = [&mut self.contour, &mut self.front, &mut self.normal_z];
        let first = self.normal.iter_mut().map(Expression::First);
        let all = first.chain(second.map(Expression::Second));
        (vec![&mut self.screen_box], all.collect())
    }
}

/// Latency in clocks from the raster flags to the outputs: processors, back depth, depth interval, output.
pub const LATENCY: u32 = 4;

impl Object for SphereWords {
    fn at(&self, x: i64, y: i64, format: &Format) -> ObjectPixel {
        let value = |q: &Quadratic| q.wrapped_at(x, y, format.quadratic);
        let there = self.screen_box.contains(x, y) && value(&self.contour) >= 0;
        let near = (value(&self.front) >> depth_guard(format)) as i64;
        let far = wrap64(self.sum - near, format.sum);
        let (interval, _) = halves(Class::Side, near, far, !there, format);
        let normal = || match interval.nf {
            FACE_NEAR_END => NEAR_END_NORMAL,
            _ => {
                let [nx, ny] = self.normal.each_ref().map(|n| linear_component(n, x, y));
                let nz = value(&self.normal_z) >> normal_guard(format);
                [nx, ny, nz as i16]
            }
        };
        ObjectPixel::of(interval, normal, format)
    }
}
