//! Words in registers of the processor: which of their bits count.

use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, Value};
use cranelift_frontend::FunctionBuilder;

/// What stands above the bits of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Above {
    Zeros,
    Signs,
    Anything,
}

impl Above {
    /// What stands above a word that is made bit by bit of two.
    pub(crate) fn and(self, other: Above) -> Above {
        match self == other {
            true => self,
            false => Above::Anything,
        }
    }
}

/// A value of so many bits. It is made clean where that is needed, and once.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Word {
    pub(crate) value: Value,
    pub(crate) above: Above,
    pub(crate) zeros: Option<Value>,
    pub(crate) signs: Option<Value>,
}

impl Word {
    pub(crate) fn new(value: Value, above: Above, width: u32) -> Word {
        let above = if width == 64 { Above::Zeros } else { above };
        Word {
            value,
            above,
            zeros: (above == Above::Zeros).then_some(value),
            signs: (above == Above::Signs || width == 64).then_some(value),
        }
    }

    /// With zeros above.
    pub(crate) fn with_zeros(&mut self, width: u32, to: &mut FunctionBuilder) -> Value {
        *self.zeros.get_or_insert_with(|| {
            let mask = constant(to, u64::MAX >> (64 - width));
            to.ins().band(self.value, mask)
        })
    }

    /// With the sign above.
    pub(crate) fn with_signs(&mut self, width: u32, to: &mut FunctionBuilder) -> Value {
        *self.signs.get_or_insert_with(|| {
            let high = shifted_left(to, self.value, 64 - width);
            let count = constant(to, u64::from(64 - width));
            to.ins().sshr(high, count)
        })
    }
}

pub(crate) fn constant(to: &mut FunctionBuilder, value: u64) -> Value {
    to.ins().iconst(I64, value as i64)
}

pub(crate) fn shifted_left(to: &mut FunctionBuilder, value: Value, count: u32) -> Value {
    if count == 0 {
        return value;
    }
    let count = constant(to, u64::from(count));
    to.ins().ishl(value, count)
}

pub(crate) fn shifted_right(to: &mut FunctionBuilder, value: Value, count: u32) -> Value {
    if count == 0 {
        return value;
    }
    let count = constant(to, u64::from(count));
    to.ins().ushr(value, count)
}

/// A comparison as a word of one bit.
pub(crate) fn compared(to: &mut FunctionBuilder, how: IntCC, a: Value, b: Value) -> Value {
    let found = to.ins().icmp(how, a, b);
    to.ins().uextend(I64, found)
}
