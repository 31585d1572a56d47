//! What words and numbers can do besides what they have in common.

use super::{Bits, Int, Value, as_bits, binary, join, made, make, mask, same_width, single_bit};
use crate::bundle::{Bundle, members, replaced};
use crate::scope::refuse;
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
        single_bit(self, "selects");
        let mut chosen = vec![];
        for ((_, a), (_, b)) in members(&one).into_iter().zip(members(&other)) {
            same_width("is selected beside", a, b);
            let op = Op::Select(self.0.net, a.net, b.net);
            chosen.push(match a.net == b.net {
                true => a,
                false => made(op, a.width, a.signed),
            });
        }
        replaced(&one, chosen)
    }

    /// The same bits as a number.
    #[track_caller]
    pub fn int(self) -> Int {
        self.0.check_scope();
        make(Op::Same(self.0.net), self.width())
    }

    /// Shifted to the left by a constant, zeros behind; the width stays.
    #[track_caller]
    pub fn left(self, count: u32) -> Bits {
        if count == 0 {
            return self;
        }
        if count >= self.width() {
            return Bits::new(0, self.width());
        }
        join([self.slice(self.width() - 1 - count, 0), Bits::new(0, count)])
    }

    /// Shifted to the left by another word; the width stays.
    #[track_caller]
    pub fn left_by(self, count: Bits) -> Bits {
        shifted(Binary::Left, self, count)
    }

    /// Shifted to the right by another word, zeros in front.
    #[track_caller]
    pub fn right_by(self, count: Bits) -> Bits {
        shifted(Binary::Right, self, count)
    }
}

impl Int {
    /// A constant.
    #[track_caller]
    pub fn new(value: i64, width: u32) -> Int {
        let least = -(1i128 << (width - 1));
        if i128::from(value) < least || i128::from(value) >= -least {
            refuse!("{value} has no {width} bits");
        }
        Int::literal(value as u64 & mask(width), width)
    }

    /// The same bits as a word.
    #[track_caller]
    pub fn bits(self) -> Bits {
        as_bits(self.0)
    }

    /// 1 where it is less than 0.
    #[track_caller]
    pub fn is_negative(self) -> Bits {
        self.top()
    }

    /// Shifted to the right by a word; the sign goes on.
    #[track_caller]
    pub fn right_by(self, count: Bits) -> Int {
        shifted(Binary::Right, self, count)
    }
}

#[track_caller]
fn shifted<V: Value>(binary: Binary, value: V, count: Bits) -> V {
    let value = value.handle();
    value.check_scope();
    make(Op::Binary(binary, value.net, count.0.net), value.width)
}

#[track_caller]
fn alike<V: Value>(what: &str, operation: Binary, a: V, b: V) -> V {
    binary(what, operation, a, b, a.width())
}

#[track_caller]
fn product<V: Value>(a: V, b: V) -> V {
    let [a, b] = [a.handle(), b.handle()];
    a.check_scope();
    b.check_scope();
    make(Op::Binary(Binary::Mul, a.net, b.net), a.width + b.width)
}

macro_rules! operators {
    ($($(#[$about:meta])* $value:ident: $operator:ident $function:ident $made:ident($($given:expr),*);)*) => {$(
        $(#[$about])*
        impl $operator for $value {
            type Output = $value;

            #[track_caller]
            fn $function(self, other: $value) -> $value {
                $made($($given,)* self, other)
            }
        }
    )*};
}

operators! {
    Bits: Add add alike("is added to", Binary::Add);
    Bits: Sub sub alike("is less by", Binary::Sub);
    Bits: BitAnd bitand alike("is joined bit by bit with", Binary::And);
    Bits: BitOr bitor alike("is joined bit by bit with", Binary::Or);
    Bits: BitXor bitxor alike("is joined bit by bit with", Binary::Xor);
    /// The whole product, with the bits of both together.
    Bits: Mul mul product();
    Int: Add add alike("is added to", Binary::Add);
    Int: Sub sub alike("is less by", Binary::Sub);
    /// The whole product, with the bits of both together.
    Int: Mul mul product();
}

impl Not for Bits {
    type Output = Bits;

    #[track_caller]
    fn not(self) -> Bits {
        self.0.check_scope();
        make(Op::Not(self.0.net), self.0.width)
    }
}
