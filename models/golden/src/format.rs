//! Number formats: every width of a machine as data.

use crate::unit::root::Method;
use imogene_contract::words::{LEAST_DEPTH, MOST_DEPTH, MOST_GUARD, WordRange};
use imogene_contract::{MachineWords, RootForm, words};
use serde::Serialize;
use std::ops::RangeInclusive;
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
    /// Rows that the root network lacks: the last digits of the root, which are zero.
    pub dropped_rows: u32,
    /// How the root is taken.
    #[serde(skip_serializing_if = "RootForm::is_usual")]
    pub root_form: RootForm,
}

impl Format {
    /// Depth words: below, nothing of a picture is left; above, f2 is longer than 64 bits.
    pub const DEPTHS: RangeInclusive<u32> = LEAST_DEPTH..=MOST_DEPTH;

    /// Depth words of the tables of errors, proofs and costs.
    pub const CATALOGUE: [u32; 5] = words::DEPTH_WORDS;

    /// The format of the source machine: 24-bit depth, 48-bit quadratic accumulator.
    pub const BASE: Format = Format::of(&MachineWords::of(24));

    /// The format of a depth word from which all others follow.
    pub fn new(depth: u32) -> Result<Format, FormatError> {
        match Self::DEPTHS.contains(&depth) {
            true => Ok(Self::of(&MachineWords::of(depth))),
            false => Err(FormatError(depth)),
        }
    }

    const fn of(words: &MachineWords) -> Format {
        Format {
            depth: words.depth,
            sum: words::depth_sum(words.depth),
            quadratic: words::quadratic(words.root),
            root: words.root,
            plane: words.plane,
            normal_linear: words.normal + Self::NORMAL_FRACTION,
            normal: words.normal,
            guard_linear: words.guard_linear,
            guard_quadratic: words.guard_quadratic,
            dropped_rows: words.dropped_rows,
            root_form: words.root_form,
        }
    }

    /// The format of a machine that is fitted to a scene, or the word that is out of its range.
    pub fn fitted(words: &MachineWords) -> Result<Format, FittedError> {
        let unguarded = MachineWords {
            guard_linear: 0,
            guard_quadratic: 0,
            ..*words
        };
        if let Some(range) = unguarded.refused() {
            return Err(FittedError::Range(range));
        }
        let (linear, quadratic) = (words.guard_linear, words.guard_quadratic);
        Ok(Format::of(&unguarded).with_guards(linear, quadratic)?)
    }

    /// The widths from which all others follow.
    pub const fn widths(&self) -> MachineWords {
        MachineWords {
            depth: self.depth,
            root: self.root,
            plane: self.plane,
            normal: self.normal,
            guard_linear: self.guard_linear,
            guard_quadratic: self.guard_quadratic,
            dropped_rows: self.dropped_rows,
            root_form: self.root_form,
        }
    }

    /// Most digits of the root that are not computed.
    pub const MAX_DROPPED_ROWS: u32 = words::MOST_DROPPED;

    /// Rows of the root network: the digits of the root that are computed.
    #[inline]
    pub const fn root_rows(&self) -> u32 {
        self.root - self.dropped_rows
    }

    /// A root without the digits that are not computed.
    #[inline]
    pub const fn keep_rows(&self, root: i64) -> i64 {
        root >> self.dropped_rows << self.dropped_rows
    }

    /// Clocks from f2 to its root.
    pub const fn root_latency(&self, rows_per_stage: u32) -> u32 {
        Method::of(self.root_form).latency(self.root_rows(), rows_per_stage)
    }

    /// Bits of a normal's linear part below the last bit of the component.
    pub const NORMAL_FRACTION: u32 = words::NORMAL_PART - words::NORMAL;

    /// Greatest normal component, `2^(n - 1) - 1` for n bits.
    #[inline]
    pub const fn greatest_normal(&self) -> i16 {
        i16::MAX >> (16 - self.normal)
    }

    /// Binary places of the product `K r` of a normal below the last bit of its linear part: 6 for components of 16
    /// bits.
    #[inline]
    pub const fn product_fraction(&self) -> u32 {
        self.normal - 10
    }

    /// The same format with guard bits below the last bits of f1 and f2; 0 to 16 each, and `F + g2` at most 64.
    pub const fn with_guards(self, linear: u32, quadratic: u32) -> Result<Format, GuardError> {
        if linear > MOST_GUARD || quadratic > MOST_GUARD {
            return Err(GuardError::TooMany(linear, quadratic));
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
        Ok(format)
    }

    /// True if either part of the depth has guard bits.
    pub const fn has_guards(&self) -> bool {
        self.guard_linear > 0 || self.guard_quadratic > 0
    }

    /// Width `S + g1` of the elementary processor of f1, which works in units of 2^-g1 depth words.
    #[inline]
    pub const fn pe1_width(&self) -> u32 {
        self.sum + self.guard_linear
    }

    /// Width `F + g2` of the elementary processor of f2, which works in units of 2^-g2 of the last bit of f2.
    #[inline]
    pub const fn pe2_width(&self) -> u32 {
        self.quadratic + self.guard_quadratic
    }

    /// True if all words but the guard bits follow from the depth word, whatever the form of the root.
    pub fn follows_depth_word(&self) -> bool {
        let own = MachineWords {
            guard_linear: self.guard_linear,
            guard_quadratic: self.guard_quadratic,
            root_form: self.root_form,
            ..MachineWords::of(self.depth)
        };
        own == self.widths()
    }

    /// Data bits of the load bus: the width of the widest word.
    pub fn bus(&self) -> u32 {
        let words = [
            self.pe1_width(),
            self.pe2_width(),
            self.plane,
            self.normal_linear,
        ];
        words.into_iter().fold(Self::BOX_WORD, u32::max)
    }

    /// Bits of a word of the screen box: two coordinates.
    pub const BOX_WORD: u32 = 24;

    /// f1 as the rest of the machine sees it: the guard bits of its processor's value dropped, downwards.
    #[inline]
    pub const fn drop_linear(&self, value: i64) -> i64 {
        value >> self.guard_linear
    }

    /// f2 as the rest of the machine sees it: the guard bits of its processor's value dropped, downwards, which keeps
    /// the sign.
    #[inline]
    pub const fn drop_quadratic(&self, value: i64) -> i64 {
        value >> self.guard_quadratic
    }

    /// Far end: infinity in perspective, the background, the mark of an absent object.
    #[inline]
    pub const fn z_max(&self) -> i64 {
        // As all ends a 32-bit word made longer: beside others of that kind the compiler compares 32 bits.
        (i32::MAX >> (32 - self.depth)) as i64
    }

    /// Near end, wherever the range of the depth word begins.
    #[inline]
    pub const fn z_low(&self) -> i64 {
        -(i32::MAX >> (32 - self.depth)) as i64
    }

    /// Lower bound of a saturated plane depth, one below the near end.
    #[inline]
    pub const fn plane_low(&self) -> i64 {
        (i32::MIN >> (32 - self.depth)) as i64
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

/// Widths that no machine can have.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum FittedError {
    /// One of them is out of its range.
    #[error("{} of {} bits: accepted are {} to {}", .0.0, .0.1, .0.2, .0.3)]
    Range(WordRange),
    /// The guard bits.
    #[error(transparent)]
    Guards(#[from] GuardError),
}

/// A depth word that no machine has.
#[derive(Debug, Error, PartialEq, Eq)]
#[error("depth word of {0} bits: accepted are {LEAST_DEPTH} to {MOST_DEPTH}")]
pub struct FormatError(pub u32);

/// Guard bits that a format cannot have.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum GuardError {
    /// More than 16 of f1 or of f2.
    #[error("guard bits {0}:{1}: at most {MOST_GUARD} each are accepted")]
    TooMany(u32, u32),
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
}
