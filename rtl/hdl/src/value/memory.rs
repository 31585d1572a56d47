//! Block memories.

use super::{Bits, Value, make};
use crate::scope::with_scope;
use crate::tree::{Memory, Op};

/// A block memory of so many words, zeros at power-up: writes `data` where `write` is 1, and gives the word that was
/// at `read` one clock ago, as it was before that clock's write.
///
/// Parts give something else for a word that is read while it is written, or take cells to give the one before. So no
/// circuit may use such a word, and synthesis is told so.
#[track_caller]
pub fn memory(name: &str, words: usize, write: (Bits, Bits, Bits), read: Bits) -> Bits {
    block(name, words, vec![], write, read)
}

/// A block memory that is never written: gives the word that stands at `read` one clock later, zero at power-up.
#[track_caller]
pub fn read_only_memory(name: &str, width: u32, contents: Vec<u64>, read: Bits) -> Bits {
    let never = (
        Bits::new(0, 1),
        Bits::new(0, read.width()),
        Bits::new(0, width),
    );
    block(name, contents.len(), contents, never, read)
}

#[track_caller]
fn block(
    name: &str,
    words: usize,
    contents: Vec<u64>,
    (write, at, data): (Bits, Bits, Bits),
    read: Bits,
) -> Bits {
    let values = [write, at, data, read].map(|value| value.0);
    values.iter().for_each(|value| value.check_scope());
    let [write, at, data, address] = values.map(|value| value.net);
    let width = values[2].width;
    let index = with_scope(|scope| scope.module.memories.len());
    let value: Bits = make(Op::Read(index), width);
    let memory = Memory {
        name: name.to_owned(),
        width,
        words,
        contents,
        write: [write, at, data],
        address,
        net: value.0.net,
    };
    with_scope(|scope| scope.module.memories.push(memory));
    value
}
