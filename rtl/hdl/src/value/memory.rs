//! Block memories.

use super::{Bits, Value, in_scope, make};
use crate::build::with_scope;
use crate::tree::{Memory, Op};

/// A block memory of so many words, zeros at power-up: writes `data` where `write` is 1, and gives the word that was
/// at `read` one clock ago, as it was before that clock's write.
#[track_caller]
pub fn memory(name: &str, words: usize, (write, at, data): (Bits, Bits, Bits), read: Bits) -> Bits {
    [write, at, data, read]
        .iter()
        .for_each(|value| in_scope(value.0));
    let index = with_scope(|scope| scope.module.memories.len());
    let value: Bits = make(Op::Read(index), data.width());
    with_scope(|scope| {
        scope.module.memories.push(Memory {
            name: name.to_owned(),
            width: data.width(),
            words,
            write: [write, at, data].map(|value| value.0.net),
            address: read.0.net,
            net: value.0.net,
        });
    });
    value
}
