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
    /// Guard bits g1 of f1 below the last bit of the depth word: its pe1 is `S + g1` bits wide.
    pub guard_linear: u32,
    /// Guard bits g2 of f2 below the last bit of the quadratic word: its pe2 is `F + g2` bits wide.
    pub guard_quadratic: u32,
}

/// A depth word that is not in the catalogue.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("depth word of {0} bits is not in the catalogue; accepted: 16, 20, 24, 28, 32")]
pub struct FormatError(pub u32);

/// Guard bits that a format cannot have.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum GuardError {
    /// More than 16.
    #[error("guard bits {linear}:{quadratic}: at most {max} each are accepted", max = Format::MAX_GUARD)]
    TooMany {
        /// Of f1.
        linear: u32,
        /// Of f2.
        quadratic: u32,
    },
    /// The second-degree processor would be wider than 64 bits.
    #[error(
        "{quadratic} guard bits of f2 make its processor {width} bits wide, more than 64; \
         a depth word of {depth} bits accepts at most {most}"
    )]
    TooWide {
        /// Depth word of the format.
        depth: u32,
        /// Of f2.
        quadratic: u32,
        /// Width that the processor would have.
        width: u32,
        /// The most that is accepted.
        most: u32,
    },
    /// A word of f1 would not fit the load bus, which is as wide as a word of f2.
    #[error(
        "{linear} guard bits of f1 make its words {width} bits wide, more than the load bus of {bus} bits; \
         with {quadratic} guard bits of f2 at most {most} are accepted"
    )]
    BeyondBus {
        /// Of f1.
        linear: u32,
        /// Of f2.
        quadratic: u32,
        /// Width of a word of f1.
        width: u32,
        /// Width of the load bus.
        bus: u32,
        /// The most that is accepted.
        most: u32,
    },
}

impl Format {
    /// Most guard bits of either part of the depth.
    pub const MAX_GUARD: u32 = 16;

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
            guard_linear: 0,
            guard_quadratic: 0,
        }
    }

    /// The same format with guard bits below the last bits of f1 and f2; 0 to 16 each, `F + g2` at most 64, and `S + g1` at most
    /// `F + g2`, the width of the load bus.
    pub const fn with_guards(self, linear: u32, quadratic: u32) -> Result<Format, GuardError> {
        if linear > Self::MAX_GUARD || quadratic > Self::MAX_GUARD {
            return Err(GuardError::TooMany { linear, quadratic });
        }
        let format = Format {
            guard_linear: linear,
            guard_quadratic: quadratic,
            ..self
        };
        if format.pe2_width() > 64 {
            return Err(GuardError::TooWide {
                depth: self.depth,
                quadratic,
                width: format.pe2_width(),
                most: 64 - self.quadratic,
            });
        }
        if format.pe1_width() > format.bus() {
            return Err(GuardError::BeyondBus {
                linear,
                quadratic,
                width: format.pe1_width(),
                bus: format.bus(),
                most: format.bus() - self.sum,
            });
        }
        Ok(format)
    }

    /// True if either part of the depth has guard bits.
    pub const fn has_guards(&self) -> bool {
        self.guard_linear > 0 || self.guard_quadratic > 0
    }

    /// Width `S + g1` of the elementary processor of f1, which works in units of 2^-g1 depth words.
    pub const fn pe1_width(&self) -> u32 {
        self.sum + self.guard_linear
    }

    /// Width `F + g2` of the elementary processor of f2, which works in units of 2^-g2 of the last bit of f2.
    pub const fn pe2_width(&self) -> u32 {
        self.quadratic + self.guard_quadratic
    }

    /// Data bits of the load bus: the width of the widest word, that of f2.
    pub const fn bus(&self) -> u32 {
        self.pe2_width()
    }

    /// f1 as the rest of the machine sees it: the guard bits of its processor's value dropped, downwards.
    #[inline]
    pub const fn drop_linear(&self, value: i64) -> i64 {
        value >> self.guard_linear
    }

    /// f2 as the rest of the machine sees it: the guard bits of its processor's value dropped, downwards, which keeps the sign.
    #[inline]
    pub const fn drop_quadratic(&self, value: i64) -> i64 {
        value >> self.guard_quadratic
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
    fn guard_bits_widen_the_processors_only() {
        let base = Format::BASE;
        let f = base.with_guards(2, 4).unwrap();
        assert_eq!((f.pe1_width(), f.pe2_width(), f.bus()), (28, 52, 52));
        assert_eq!((f.sum, f.quadratic, f.z_max()), (26, 48, base.z_max()));
        assert_eq!((f.drop_linear(-1), f.drop_linear(7)), (-1, 1));
        assert_eq!((f.drop_quadratic(-1), f.drop_quadratic(15)), (-1, 0));
        assert!(f.has_guards() && !base.has_guards());
    }

    #[test]
    fn guard_bits_beyond_the_words_are_refused() {
        let refused = |depth, linear, quadratic| {
            let format = Format::new(depth).unwrap();
            format
                .with_guards(linear, quadratic)
                .unwrap_err()
                .to_string()
        };
        assert!(refused(24, 17, 0).contains("at most 16 each"));
        assert!(refused(28, 0, 9).contains("at most 8"));
        assert!(refused(32, 0, 1).contains("at most 0"));
        assert!(refused(16, 16, 0).contains("at most 14"));
        assert!(Format::new(16).unwrap().with_guards(16, 2).is_ok());
        assert!(Format::BASE.with_guards(16, 16).is_ok());
    }

    #[test]
    fn wrap_sign_extends() {
        assert_eq!(wrap(1 << 23, 24), -(1 << 23));
        assert_eq!(wrap(-(1 << 23) - 1, 24), (1 << 23) - 1);
        assert_eq!(wrap64((1 << 35) + 5, 36), -(1 << 35) + 5);
    }
}
