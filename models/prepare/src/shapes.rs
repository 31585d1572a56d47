//! Spheres and cylinders of orthographic views by paraboloids, exactly (source: Chaillou, IV.2.4 and IV.2.5).
//!
//! `sqrt(1 - r^2)` is replaced by `a - b r^2` with a = 21 pi / 64 and b = 15 pi / 64, the least squares fit of the
//! profile on 0 <= r <= 1.

use super::forms::{LinearForm, QuadraticForm};
use imogene_algebra::rational::{integer, round_half_up};
use imogene_contract::words::NORMAL_LENGTH;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;

/// A sphere: centre in pixels and depth words, radius in pixels.
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

/// A cylinder that is seen neither end-on nor side-on.
///
/// Its unit axis, from the front disc to the back, is `(level cos, level sin, deep)` with cos^2 + sin^2 = 1 and
/// level^2 + deep^2 = 1, all rational, level and deep positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CylinderShape {
    /// Centre of the front disc: column, line, depth in pixels.
    pub centre: [BigRational; 3],
    /// Direction of the axis on the screen: cosine and sine.
    pub direction: [BigRational; 2],
    /// Part of the unit axis in the screen plane.
    pub level: BigRational,
    /// Part of the unit axis away from the viewer.
    pub deep: BigRational,
    /// Radius in pixels, positive.
    pub radius: BigRational,
    /// Length in pixels, positive.
    pub length: BigRational,
    /// Depth words per pixel, positive.
    pub scale: BigRational,
}

/// The two factors a and b, pi to 30 digits.
fn bulge() -> [BigRational; 2] {
    let digits = BigInt::from(314_159_265_358_979_323_846_264_338_328_i128);
    let pi = BigRational::new(digits, BigInt::from(10).pow(29));
    [21, 15].map(|n| &pi * integer(n) / integer(64))
}

impl SphereShape {
    /// `factor ((x - x1)^2 + (y - y1)^2) + top`.
    fn round(&self, factor: BigRational, top: BigRational) -> QuadraticForm {
        let minus_two = integer(-2) * &factor;
        let far = &factor * (&self.x * &self.x + &self.y * &self.y);
        QuadraticForm::of_array([
            factor.clone(),
            factor,
            integer(0),
            &minus_two * &self.x,
            &minus_two * &self.y,
            top + far,
        ])
    }

    /// The paraboloid's front depth: `z - s (a R - b r^2 / R)`.
    pub fn paraboloid(&self) -> QuadraticForm {
        let [a, b] = bulge();
        let top = &self.z - a * &self.radius * &self.scale;
        self.round(b * &self.scale / &self.radius, top)
    }

    /// Not negative inside the outline: `R^2 - r^2`.
    pub fn outline(&self) -> QuadraticForm {
        self.round(integer(-1), &self.radius * &self.radius)
    }

    /// The normal's parts along columns and along lines, of length [`NORMAL_LENGTH`].
    pub fn normal_across(&self) -> [LinearForm; 2] {
        let slope = integer(NORMAL_LENGTH) / &self.radius;
        let x = [slope.clone(), integer(0), -&slope * &self.x];
        let y = [integer(0), slope.clone(), -&slope * &self.y];
        [x, y].map(LinearForm::of_array)
    }

    /// The normal's part along the depth, by the same paraboloid as the depth.
    pub fn normal_deep(&self) -> QuadraticForm {
        let [high, low] = bulge().map(|factor| factor * integer(NORMAL_LENGTH));
        self.round(low / (&self.radius * &self.radius), -high)
    }
}

impl CylinderShape {
    /// Pixels along the axis on the screen from the centre of the front disc.
    fn along(&self) -> LinearForm {
        let ([cos, sin], [x, y, _]) = (&self.direction, &self.centre);
        LinearForm::of_array([cos.clone(), sin.clone(), -(cos * x + sin * y)])
    }

    /// Pixels across the axis.
    fn across(&self) -> LinearForm {
        let ([cos, sin], [x, y, _]) = (&self.direction, &self.centre);
        LinearForm::of_array([-sin, cos.clone(), sin * x - cos * y])
    }

    /// The half height of the parabolic body, `a R - b t^2 / R`, times a factor.
    fn bulge(&self, factor: &BigRational) -> QuadraticForm {
        let [a, b] = bulge().map(|part| part * factor);
        let square = QuadraticForm::square_of(&self.across());
        square
            .scaled(&(-b / &self.radius))
            .raised(&(a * &self.radius))
    }

    /// The parabolic body's front depth in depth words.
    pub fn body(&self) -> QuadraticForm {
        let slope = &self.scale * &self.deep / &self.level;
        let axis = self.along().scaled(&slope);
        let axis = axis.raised(&(&self.scale * &self.centre[2]));
        let half = self.bulge(&(-&self.scale / &self.level));
        half.plus(&QuadraticForm::of_linear(&axis))
    }

    /// Sides of the rectangle between the discs' centres, not negative inside.
    pub fn sides(&self) -> [LinearForm; 4] {
        let (a, t, minus) = (self.along(), self.across(), integer(-1));
        let end = &self.length * &self.level;
        [
            a.clone(),
            a.scaled(&minus).raised(&end),
            t.raised(&self.radius),
            t.scaled(&minus).raised(&self.radius),
        ]
    }

    /// Outlines of the front and the back disc, not negative inside: `R^2 deep^2 - deep^2 t^2 - (a - shift)^2`.
    pub fn discs(&self) -> [QuadraticForm; 2] {
        let square = &self.deep * &self.deep;
        let across = QuadraticForm::square_of(&self.across()).scaled(&-&square);
        let within = across.raised(&(square * &self.radius * &self.radius));
        [integer(0), -&self.length * &self.level].map(|shift| {
            let along = self.along().raised(&shift);
            within.minus(&QuadraticForm::square_of(&along))
        })
    }

    /// Normal of the body, outward, of length [`NORMAL_LENGTH`] where it is exact: t across the axis, and the bulge
    /// times (deep cos, deep sin, -level).
    pub fn body_normal(&self) -> [QuadraticForm; 3] {
        let [cos, sin] = &self.direction;
        let per_radius = integer(NORMAL_LENGTH) / &self.radius;
        [
            (-sin, &self.deep * cos),
            (cos.clone(), &self.deep * sin),
            (integer(0), -&self.level),
        ]
        .map(|(across, bulge)| {
            let across = self.across().scaled(&(across * &per_radius));
            self.bulge(&(bulge * &per_radius))
                .plus(&QuadraticForm::of_linear(&across))
        })
    }

    /// Depth of the front disc in depth words.
    pub fn disc(&self) -> LinearForm {
        let slope = -&self.scale * &self.level / &self.deep;
        let middle = &self.scale * &self.centre[2];
        self.along().scaled(&slope).raised(&middle)
    }

    /// Normal of the front disc.
    pub fn disc_normal(&self) -> [i16; 3] {
        let [cos, sin] = &self.direction;
        [&self.level * cos, &self.level * sin, self.deep.clone()].map(|part| {
            let rounded = round_half_up(&(-part * integer(NORMAL_LENGTH))).to_i16();
            rounded.expect("a unit vector's component")
        })
    }
}
