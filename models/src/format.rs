//! Number formats: every width of a machine as data.

use serde::Serialize;
use thiserror::Error;

/// The widths of one machine, all derived from its depth word `W` (`docs/architecture.md`, section 1).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Format {
    /// Depth word `W`, two's complement.
    pub depth: u32,
    /// Depth sum `S = W + 2`: f1, and f1 -+ r before saturation.
    pub sum: u32,
    /// Quadratic word `F = 2W`: f2, and the radicand.
    pub quadratic: u32,
    /// Root bits `K = W`.
    pub root: u32,
    /// Plane word `P = W + 12`: depth of a cut plane before saturation.
    pub plane: u32,
    /// First-degree part of a normal component.
    pub normal_linear: u32,
    /// Factor K_k and resulting normal component.
    pub normal: u32,
}

/// A depth word that is not in the catalogue.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("depth word of {0} bits is not in the catalogue; accepted: 16, 20, 24, 28, 32")]
pub struct FormatError(pub u32);

impl Format {
    /// Depth words for which the hardware is instantiated.
    pub const CATALOGUE: [u32; 5] = [16, 20, 24, 28, 32];

    /// The format of the source machine: 24-bit depth, 48-bit quadratic accumulator.
    pub const BASE: Format = Format::of_depth(24);

    /// The format of a depth word, or an error that lists the catalogue.
    pub fn new(depth: u32) -> Result<Format, FormatError> {
        if Self::CATALOGUE.contains(&depth) {
            Ok(Self::of_depth(depth))
        } else {
            Err(FormatError(depth))
        }
    }

    const fn of_depth(depth: u32) -> Format {
        Format {
            depth,
            sum: depth + 2,
            quadratic: 2 * depth,
            root: depth,
            plane: depth + 12,
            normal_linear: 24,
            normal: 16,
        }
    }

    /// Far end: infinity in perspective, the background, the mark of an absent object.
    pub const fn z_max(&self) -> i64 {
        (1 << (self.depth - 1)) - 1
    }

    /// Near end: half the viewer distance in perspective.
    pub const fn z_low(&self) -> i64 {
        -self.z_max()
    }

    /// Lower bound of a saturated plane depth, one below the near end.
    pub const fn plane_low(&self) -> i64 {
        self.z_low() - 1
    }
}

/// The largest value of a two's complement word of `width` bits (at most 127).
pub const fn word_max(width: u32) -> i128 {
    (1 << (width - 1)) - 1
}

/// `value` modulo 2^width, sign-extended: what a two's complement register of `width` bits (1 to 127) holds.
#[inline]
pub const fn wrap(value: i128, width: u32) -> i128 {
    (value << (128 - width)) >> (128 - width)
}

/// As [`wrap`], for words of at most 64 bits.
#[inline]
pub const fn wrap64(value: i64, width: u32) -> i64 {
    (value << (64 - width)) >> (64 - width)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_format_is_24_48() {
        let f = Format::BASE;
        assert_eq!(
            (f.depth, f.sum, f.quadratic, f.root, f.plane),
            (24, 26, 48, 24, 36)
        );
        assert_eq!((f.z_max(), f.z_low()), (8_388_607, -8_388_607));
        assert_eq!(Format::new(25), Err(FormatError(25)));
    }

    #[test]
    fn wrap_sign_extends() {
        assert_eq!(wrap(1 << 23, 24), -(1 << 23));
        assert_eq!(wrap(-(1 << 23) - 1, 24), (1 << 23) - 1);
        assert_eq!(wrap64((1 << 35) + 5, 36), -(1 << 35) + 5);
    }
}
