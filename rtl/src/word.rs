//! The two value types of every port: [`Word`] (plain bits) and [`Int`] (two's complement).
//!
//! They take the place of rust-hdl's `Bits` and `Signed` in the kernels. rust-hdl keeps a value of more than 32 bits as
//! one `bool` per bit and compares signed values as big integers; a machine word gives the same results some fifty times
//! faster. It also closes a trap: sign extension is right for the most negative value too.
//!
//! Widths run from 1 to 64 bits. All arithmetic wraps modulo the width.

use rust_hdl::core::prelude::{Bits, Synth, TypeDescriptor, TypeKind, VCDValue, VerilogLiteral};
use std::ops::{Add, BitAnd, BitOr, BitXor, Mul, Neg, Not, Shl, Shr, Sub};

/// The ones of a word of `width` bits.
const fn ones(width: usize) -> u64 {
    assert!(width >= 1 && width <= 64, "a word has 1 to 64 bits");
    u64::MAX >> (64 - width)
}

/// `N` bits without a sign.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Word<const N: usize>(u64);

impl<const N: usize> Word<N> {
    const ONES: u64 = ones(N);

    /// The word of the low `N` bits of `value`.
    #[inline(always)]
    pub const fn new(value: u64) -> Self {
        Self(value & Self::ONES)
    }

    /// The value.
    #[inline(always)]
    pub const fn get(self) -> u64 {
        self.0
    }

    /// The value as the index of an array.
    #[inline(always)]
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Bits `offset + M - 1 .. offset`.
    #[inline(always)]
    pub const fn get_bits<const M: usize>(self, offset: usize) -> Word<M> {
        Word::new(self.0 >> offset)
    }

    /// One bit.
    #[inline(always)]
    pub const fn get_bit(self, index: usize) -> bool {
        (self.0 >> index) & 1 == 1
    }
}

impl<const N: usize> From<u64> for Word<N> {
    fn from(value: u64) -> Self {
        Self::new(value)
    }
}

impl<const N: usize> Synth for Word<N> {
    const BITS: usize = N;

    fn descriptor() -> TypeDescriptor {
        TypeDescriptor {
            name: format!("Bits::<{N}>"),
            kind: TypeKind::Bits(N),
        }
    }

    fn vcd(self) -> VCDValue {
        Bits::<N>::from(self.0).vcd()
    }

    fn verilog(self) -> VerilogLiteral {
        Bits::<N>::from(self.0).verilog()
    }
}

/// An `N` bit two's complement number.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Int<const N: usize>(i64);

impl<const N: usize> Int<N> {
    const UNUSED: u32 = {
        assert!(N >= 1 && N <= 64, "a word has 1 to 64 bits");
        64 - N as u32
    };

    /// The number congruent to `value` modulo `2^N`.
    #[inline(always)]
    pub const fn new(value: i64) -> Self {
        Self((value << Self::UNUSED) >> Self::UNUSED)
    }

    /// The value.
    #[inline(always)]
    pub const fn get(self) -> i64 {
        self.0
    }

    /// Bits `offset + M - 1 .. offset`, read as a number.
    #[inline(always)]
    pub const fn get_bits<const M: usize>(self, offset: usize) -> Int<M> {
        Int::new(self.0 >> offset)
    }

    /// One bit.
    #[inline(always)]
    pub const fn get_bit(self, index: usize) -> bool {
        (self.0 >> index) & 1 == 1
    }
}

impl<const N: usize> From<i64> for Int<N> {
    fn from(value: i64) -> Self {
        Self::new(value)
    }
}

impl<const N: usize> Synth for Int<N> {
    const BITS: usize = N;

    fn descriptor() -> TypeDescriptor {
        TypeDescriptor {
            name: format!("Signed::<{N}>"),
            kind: TypeKind::Signed(N),
        }
    }

    fn vcd(self) -> VCDValue {
        unsigned_cast(self).vcd()
    }

    fn verilog(self) -> VerilogLiteral {
        unsigned_cast(self).verilog()
    }
}

macro_rules! wrapping_operators {
    ($($word:ident),*) => {$(
        impl<const N: usize> Add for $word<N> {
            type Output = Self;
            #[inline(always)]
            fn add(self, other: Self) -> Self {
                Self::new(self.0.wrapping_add(other.0))
            }
        }

        impl<const N: usize> Sub for $word<N> {
            type Output = Self;
            #[inline(always)]
            fn sub(self, other: Self) -> Self {
                Self::new(self.0.wrapping_sub(other.0))
            }
        }

        impl<const N: usize> BitAnd for $word<N> {
            type Output = Self;
            #[inline(always)]
            fn bitand(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
        }

        impl<const N: usize> BitOr for $word<N> {
            type Output = Self;
            #[inline(always)]
            fn bitor(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
        }

        impl<const N: usize> BitXor for $word<N> {
            type Output = Self;
            #[inline(always)]
            fn bitxor(self, other: Self) -> Self {
                Self(self.0 ^ other.0)
            }
        }

        impl<const N: usize> Not for $word<N> {
            type Output = Self;
            #[inline(always)]
            fn not(self) -> Self {
                Self::new(!self.0)
            }
        }
    )*};
}

wrapping_operators!(Word, Int);

impl<const N: usize> Neg for Int<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(self.0.wrapping_neg())
    }
}

impl<const N: usize> Mul for Int<N> {
    type Output = Doubled<N>;
    #[inline(always)]
    fn mul(self, other: Self) -> Doubled<N> {
        Doubled(self.0 * other.0)
    }
}

/// A two's complement number of `2 N` bits, `N` at most 32: what the product of two [`Int`] is.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Doubled<const N: usize>(i64);

impl<const N: usize> Doubled<N> {
    const UNUSED: u32 = {
        assert!(N >= 1 && N <= 32, "a product has 2 to 64 bits");
        64 - 2 * N as u32
    };

    /// The number congruent to `value` modulo `2^(2 N)`.
    #[inline(always)]
    pub const fn new(value: i64) -> Self {
        Self((value << Self::UNUSED) >> Self::UNUSED)
    }

    /// The value.
    #[inline(always)]
    pub const fn get(self) -> i64 {
        self.0
    }

    /// Bits `offset + M - 1 .. offset`, read as a number.
    #[inline(always)]
    pub const fn get_bits<const M: usize>(self, offset: usize) -> Int<M> {
        Int::new(self.0 >> offset)
    }
}

impl<const N: usize> Neg for Doubled<N> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self::new(self.0.wrapping_neg())
    }
}

impl<const N: usize> BitAnd for Doubled<N> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }
}

impl<const N: usize> Synth for Doubled<N> {
    const BITS: usize = 2 * N;

    fn descriptor() -> TypeDescriptor {
        let width = Self::BITS;
        TypeDescriptor {
            name: format!("Signed::<{width}>"),
            kind: TypeKind::Signed(width),
        }
    }

    fn vcd(self) -> VCDValue {
        // The most significant bit comes first.
        match Bits::<64>::from(self.0 as u64).vcd() {
            VCDValue::Vector(bits) => VCDValue::Vector(bits[64 - Self::BITS..].to_vec()),
            other => other,
        }
    }

    fn verilog(self) -> VerilogLiteral {
        Bits::<64>::from(self.0 as u64 & ones(Self::BITS)).verilog()
    }
}

impl<const N: usize, const M: usize> Shl<Word<M>> for Word<N> {
    type Output = Self;
    #[inline(always)]
    fn shl(self, amount: Word<M>) -> Self {
        Self::new(self.0.checked_shl(amount.0 as u32).unwrap_or(0))
    }
}

impl<const N: usize, const M: usize> Shr<Word<M>> for Word<N> {
    type Output = Self;
    #[inline(always)]
    fn shr(self, amount: Word<M>) -> Self {
        Self(self.0.checked_shr(amount.0 as u32).unwrap_or(0))
    }
}

// rust-hdl's kernel macro recognises a function by the beginning of its name: `bit_cast` and `bits` are changes of width,
// `signed_cast` and `unsigned_cast` changes of reading.

/// A word lengthened with zeros, or cut, to `M` bits.
#[inline(always)]
pub const fn bit_cast<const M: usize, const N: usize>(word: Word<N>) -> Word<M> {
    Word::new(word.0)
}

/// A number lengthened with its sign, or cut, to `M` bits.
#[inline(always)]
pub const fn bits_signed<const M: usize, const N: usize>(number: Int<N>) -> Int<M> {
    Int::new(number.0)
}

/// A number lengthened with its sign to `M` bits. It has to be all that is assigned: rust-hdl prints `$signed` and leaves the width to the
/// target, while for [`bits_signed`] it prints a mask and loses the sign.
#[inline(always)]
pub const fn signed_bit_cast<const M: usize, const N: usize>(number: Int<N>) -> Int<M> {
    assert!(M >= N, "a number is lengthened");
    Int::new(number.0)
}

/// The same bits read as a number.
#[inline(always)]
pub const fn signed_cast<const N: usize>(word: Word<N>) -> Int<N> {
    Int::new(word.0 as i64)
}

/// The same bits read as a word.
#[inline(always)]
pub const fn unsigned_cast<const N: usize>(number: Int<N>) -> Word<N> {
    Word::new(number.0 as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn arithmetic_wraps_at_the_width() {
        assert_eq!(
            Int::<24>::new(8_388_607) + Int::new(1),
            Int::new(-8_388_608)
        );
        assert_eq!(-Int::<16>::new(-32_768), Int::new(-32_768));
        assert_eq!(Int::<64>::new(i64::MAX) + Int::new(1), Int::new(i64::MIN));
        assert_eq!(Word::<5>::new(3) - Word::new(4), Word::new(31));
        assert_eq!(!Word::<64>::new(0), Word::new(u64::MAX));
    }

    #[test]
    fn the_most_negative_number_keeps_its_sign() {
        assert_eq!(
            bits_signed::<40, 24>(Int::new(-8_388_608)).get(),
            -8_388_608
        );
        assert_eq!(signed_cast::<24>(Word::new(0x80_0000)).get(), -8_388_608);
        assert_eq!(unsigned_cast::<24>(Int::new(-1)).get(), 0xff_ffff);
        assert_eq!(
            Int::<16>::new(-32_768) * Int::new(-32_768),
            Doubled::new(1 << 30)
        );
    }

    #[test]
    fn shifts_beyond_the_width_leave_zero() {
        assert_eq!(
            Word::<24>::new(0xff_ffff) >> Word::<5>::new(24),
            Word::new(0)
        );
        assert_eq!(Word::<64>::new(1) << Word::<8>::new(64), Word::new(0));
    }
}
