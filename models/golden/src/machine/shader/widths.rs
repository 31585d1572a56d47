//! Internal widths of the shading processor, and what its multipliers cost.

use serde::Serialize;

/// Widths inside the shading processor that its error depends on. The hardware has the default; others are for
/// measuring what a bit is worth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct ShaderWidths {
    /// Bits kept of a component of the vector to a light, its sign included.
    pub mantissa: u32,
    /// Bits kept of a scalar product before it is multiplied again.
    pub scalar: u32,
    /// Bits kept of the square of the normal before it is multiplied again.
    pub square: u32,
    /// Bits kept of the difference that is the cosine of the highlight.
    pub difference: u32,
    /// Bits of the place inside a segment of a curve.
    pub place: u32,
    /// Bits after the point of a logarithm.
    pub logarithm: u32,
    /// Bits after the point of a power of two.
    pub power: u32,
    /// Bits of a diffuse or specular factor, 0 to 1.
    pub factor: u32,
    /// Bits of the light that a material sends back, 0 to 2.
    pub reflected: u32,
}

/// Bits of a component of the normal.
const NORMAL: u32 = 16;
/// Bits of a component of the line of sight.
const RAY: u32 = 18;
/// Bits of a coefficient of a curve of second degree.
const CURVATURE: u32 = 12;

impl Default for ShaderWidths {
    fn default() -> Self {
        Self {
            mantissa: 18,
            scalar: 25,
            square: 23,
            difference: 31,
            place: 14,
            logarithm: 20,
            power: 17,
            factor: 17,
            reflected: 17,
        }
    }
}

impl ShaderWidths {
    fn each(&mut self) -> [(&'static str, &mut u32); 9] {
        [
            ("mantissa", &mut self.mantissa),
            ("scalar", &mut self.scalar),
            ("square", &mut self.square),
            ("difference", &mut self.difference),
            ("place", &mut self.place),
            ("logarithm", &mut self.logarithm),
            ("power", &mut self.power),
            ("factor", &mut self.factor),
            ("reflected", &mut self.reflected),
        ]
    }

    /// The widths by name.
    pub fn named(mut self) -> [(&'static str, u32); 9] {
        self.each().map(|(name, width)| (name, *width))
    }

    /// The same widths with one of [`ShaderWidths::named`] shorter by some bits.
    /// Panics when there is no such name.
    #[must_use]
    pub fn shorter(mut self, name: &str, bits: u32) -> Self {
        let own = self.each().into_iter().find(|(own, _)| *own == name);
        let Some((_, width)) = own else {
            panic!("'{name}' is no width of the shading processor");
        };
        *width -= bits;
        self
    }

    /// Bits dropped of the scalar product of a normal and the vector to a light or a line of sight of 18 bits.
    pub fn dropped(&self) -> u32 {
        NORMAL + RAY + 1 - self.scalar
    }

    /// Partial products of all multipliers for so many lights: the sum of the products of the widths of their operands.
    pub fn multiplier_bits(&self, lights: u32) -> u32 {
        let Self {
            mantissa,
            scalar,
            square,
            place,
            logarithm,
            power,
            factor,
            reflected,
            ..
        } = *self;
        let curve = |fraction: u32| CURVATURE * place + (fraction - 3) * place;
        let shared = 3 * NORMAL * NORMAL + 3 * RAY * RAY + 3 * NORMAL * RAY + 2 * curve(logarithm);
        let to_light = 3 * 28 * 32;
        let scalars = 3 * NORMAL * 30 + 3 * mantissa * mantissa + 3 * mantissa * RAY;
        let difference = scalar * scalar + square * scalar;
        let curves = 3 * curve(logarithm) + 2 * curve(power) + 8 * (logarithm + 6);
        let colours = 4 * 16 * factor + 3 * reflected * 17;
        shared + lights * (to_light + scalars + difference + curves + colours)
    }
}
