//! What words and numbers can do besides what they have in common.

use super::{Bits, Int, Value, as_bits, in_scope, join, make, mask, same_width};
use crate::build::{node_of, refuse};
use crate::bundle::{Bundle, members, replaced};
use crate::tree::{Binary, Op};
use std::ops::{Add, BitAnd, BitOr, BitXor, Mul, Not, Sub};

impl Bits {
    /// A constant.
    #[track_caller]
    pub fn new(value: u64, width: u32) -> Bits {
        Bits::literal(value, width)
    }

    /// `one` where this bit is 1, else `other`, member by member.
    #[track_caller]
    pub fn select<B: Bundle>(self, one: B, other: B) -> B {
        in_scope(self.0);
        if self.width() != 1 {
            refuse(format!("{} selects, but is no single bit", node_of(self.0)));
        }
        let mut chosen = vec![];
        for ((_, a), (_, b)) in members(&one).into_iter().zip(members(&other)) {
            same_width("is selected beside", a.handle, b.handle);
            let op = Op::Select(self.0.net, a.handle.net, b.handle.net);
            chosen.push(match a.signed {
                _ if a.handle.net == b.handle.net => a.handle,
                true => make::<Int>(op, a.handle.width).0,
                false => make::<Bits>(op, a.handle.width).0,
            });
        }
        replaced(&one, chosen)
    }

    /// The same bits as a number.
    #[track_caller]
    pub fn int(self) -> Int {
        in_scope(self.0);
        make(Op::Same(self.0.net), self.width())
    }

    /// Shifted to the left by a constant, zeros behind; the width stays.
    #[track_caller]
    pub fn left(self, count: u32) -> Bits {
        if count == 0 {
            return self;
        }
        join([self.slice(self.width() - 1 - count, 0), Bits::new(0, count)])
    }

    /// Shifted to the left by another word; the width stays.
    #[track_caller]
    pub fn left_by(self, count: Bits) -> Bits {
        in_scope(self.0);
        make(
            Op::Binary(Binary::Left, self.0.net, count.0.net),
            self.width(),
        )
    }

    /// Shifted to the right by another word, zeros in front.
    #[track_caller]
    pub fn right_by(self, count: Bits) -> Bits {
        in_scope(self.0);
        make(
            Op::Binary(Binary::Right, self.0.net, count.0.net),
            self.width(),
        )
    }
}

impl Int {
    /// A constant.
    #[track_caller]
    pub fn new(value: i64, width: u32) -> Int {
        let least = -(1i128 << (width - 1));
        if i128::from(value) < least || i128::from(value) >= -least {
            refuse(format!("{value} has no {width} bits"));
        }
        Int::literal(value as u64 & mask(width), width)
    }

    /// The same bits as a word.
    #[track_caller]
    pub fn bits(self) -> Bits {
        as_bits(self)
    }

    /// 1 where it is less than 0.
    #[track_caller]
    pub fn is_negative(self) -> Bits {
        self.top()
    }

    /// Shifted to the right by a word; the sign goes on.
    #[track_caller]
    pub fn right_by(self, count: Bits) -> Int {
        in_scope(self.0);
        make(
            Op::Binary(Binary::Right, self.0.net, count.0.net),
            self.width(),
        )
    }
}

macro_rules! operators {
    ($($value:ident: $($operator:ident $function:ident $word:literal),*;)*) => {$($(
        impl $operator for $value {
            type Output = $value;

            #[track_caller]
            fn $function(self, other: $value) -> $value {
                same_width($word, self.0, other.0);
                make(Op::Binary(Binary::$operator, self.0.net, other.0.net), self.0.width)
            }
        }
    )*)*};
}

operators! {
    Bits: Add add "is added to", Sub sub "is less by";
    Int: Add add "is added to", Sub sub "is less by";
}

macro_rules! products {
    ($($value:ident)*) => {$(
        /// The whole product, with the bits of both together.
        impl Mul for $value {
            type Output = $value;

            #[track_caller]
            fn mul(self, other: $value) -> $value {
                in_scope(self.0);
                in_scope(other.0);
                let width = [self.0.width, other.0.width].iter().sum();
                make(Op::Binary(Binary::Mul, self.0.net, other.0.net), width)
            }
        }
    )*};
}

products! { Bits Int }

macro_rules! bitwise {
    ($($operator:ident $function:ident $binary:ident;)*) => {$(
        impl $operator for Bits {
            type Output = Bits;

            #[track_caller]
            fn $function(self, other: Bits) -> Bits {
                same_width("is joined bit by bit with", self.0, other.0);
                make(Op::Binary(Binary::$binary, self.0.net, other.0.net), self.0.width)
            }
        }
    )*};
}

bitwise! {
    BitAnd bitand And;
    BitOr bitor Or;
    BitXor bitxor Xor;
}

impl Not for Bits {
    type Output = Bits;

    #[track_caller]
    fn not(self) -> Bits {
        in_scope(self.0);
        make(Op::Not(self.0.net), self.0.width)
    }
}
