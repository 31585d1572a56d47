//! One clock of a design as gates.

use crate::controls::Upset;
use crate::gates::{Bit, Gates, NO, YES};
use imogene_hdl::{Code, Flop, Kind, Levels, Store};
use std::sync::Arc;

/// Bits of a word, the lowest first; those beyond are 0.
pub(crate) type Word = Vec<Bit>;

/// Bits, at most, of a register that holds control, not data: a flag, a state, a count of steps.
pub(crate) const CONTROL: u32 = 6;

/// The words that one clock begins with: inputs, and what registers and memories hold.
#[derive(Clone)]
pub(crate) struct Begin {
    pub(crate) levels: Arc<Levels>,
    words: Vec<Word>,
}

/// What one clock comes to.
#[derive(Clone)]
pub(crate) struct End {
    /// What can be seen.
    pub(crate) outputs: Vec<Bit>,
    /// What each register holds after the clock.
    pub(crate) registers: Vec<Word>,
    /// What each memory takes: enable, then address and word if it is written, and the address that is read.
    pub(crate) memories: Vec<Word>,
}

/// A clock that begins in any of the states to which a circuit comes.
pub(crate) struct Reached {
    pub(crate) gates: Gates,
    pub(crate) begin: Begin,
    pub(crate) clock: Frame,
    /// Bits that are 1.
    pub(crate) assumed: Vec<Bit>,
    /// Those that are no controls.
    pub(crate) registers: Vec<usize>,
}

pub(crate) fn constant(value: u64) -> Word {
    let width = 64 - value.leading_zeros();
    let bits = (0..width).map(|bit| Bit::of(value >> bit & 1 == 1));
    bits.collect()
}

impl Begin {
    /// Any inputs and any state.
    pub(crate) fn any(levels: &Arc<Levels>, gates: &mut Gates) -> Begin {
        let mut begin = Begin::initial(levels);
        for flop in &levels.flops {
            begin.words[flop.output as usize] = free(flop.width, gates);
        }
        begin.with_inputs(gates);
        begin
    }

    /// The state at power-up.
    pub(crate) fn initial(levels: &Arc<Levels>) -> Begin {
        let words = levels.words.iter().map(|word| constant(*word));
        Begin {
            words: words.collect(),
            levels: levels.clone(),
        }
    }

    /// The same with any inputs, and all words in full width.
    pub(crate) fn at_power_up(levels: &Arc<Levels>, gates: &mut Gates) -> Begin {
        let mut begin = Begin::initial(levels);
        for flop in &levels.flops {
            begin.words[flop.output as usize].resize(flop.width as usize, NO);
        }
        begin.with_inputs(gates);
        begin
    }

    /// Any inputs, and any words from the memories.
    fn with_inputs(&mut self, gates: &mut Gates) {
        let inputs = self.levels.inputs().iter();
        let inputs = inputs.map(|port| (port.place, port.width));
        let stores = self.levels.stores.iter();
        let stores = stores.map(|store| (store.output, store.width));
        for (place, width) in inputs.chain(stores) {
            self.words[place as usize] = free(width, gates);
        }
    }

    /// What follows a clock, with any inputs.
    pub(crate) fn after(mut self, end: &End, gates: &mut Gates) -> Begin {
        for (flop, word) in self.levels.flops.iter().zip(&end.registers) {
            self.words[flop.output as usize] = word.clone();
        }
        self.with_inputs(gates);
        self
    }

    pub(crate) fn at(&self, place: u32) -> &Word {
        &self.words[place as usize]
    }

    pub(crate) fn register(&self, index: usize) -> &Word {
        self.at(self.levels.flops[index].output)
    }

    pub(crate) fn register_mut(&mut self, index: usize) -> &mut Word {
        &mut self.words[self.levels.flops[index].output as usize]
    }

    pub(crate) fn input(&self, index: usize) -> &Word {
        self.at(self.levels.inputs()[index].place)
    }

    pub(crate) fn input_mut(&mut self, index: usize) -> &mut Word {
        &mut self.words[self.levels.inputs()[index].place as usize]
    }

    pub(crate) fn clock(&self, gates: &mut Gates) -> Frame {
        let levels = &self.levels;
        let mut words = self.words.clone();
        for code in &levels.code {
            let from = code.from.map(|place| &words[place as usize]);
            words[code.to as usize] = value(code, from, gates);
        }
        let word = |place: u32| &words[place as usize];
        let registers = levels.flops.iter();
        let registers = registers.map(|flop| next(flop, &word, gates)).collect();
        let stores = levels.stores.iter();
        let memories = stores.map(|store| taken(store, &word, gates)).collect();
        let end = End {
            outputs: outputs(levels, &word),
            registers,
            memories,
        };
        Frame {
            levels: levels.clone(),
            words,
            end,
        }
    }
}

/// All words of a clock.
pub(crate) struct Frame {
    levels: Arc<Levels>,
    words: Vec<Word>,
    /// What it comes to.
    pub(crate) end: End,
}

impl Frame {
    pub(crate) fn at(&self, place: u32) -> &Word {
        &self.words[place as usize]
    }

    /// The address that each memory reads.
    pub(crate) fn read(&self) -> impl Iterator<Item = &Word> {
        let stores = self.levels.stores.iter();
        stores.map(|store| self.at(store.address))
    }

    /// What memories take to write.
    pub(crate) fn written(&self) -> impl Iterator<Item = &Bit> {
        let stores = self.end.memories.iter().zip(self.read());
        stores.flat_map(|(taken, read)| &taken[..taken.len() - read.len()])
    }

    /// The same clock with these upsets, and where these places begin with other words.
    pub(crate) fn with(
        &self,
        upsets: &[Upset],
        others: impl IntoIterator<Item = (u32, Word)>,
        gates: &mut Gates,
    ) -> End {
        let levels = &self.levels;
        let mut changed: Vec<Option<Word>> = vec![None; self.words.len()];
        for (place, word) in others {
            changed[place as usize] = Some(word);
        }
        for (register, value) in upsets {
            changed[levels.flops[*register].output as usize] = Some(constant(*value));
        }
        for code in &levels.code {
            let mut places = code.from.iter();
            if places.any(|place| changed[*place as usize].is_some()) {
                let from = code.from.map(|place| self.or(&changed, place));
                let word = value(code, from, gates);
                if word != self.words[code.to as usize] {
                    changed[code.to as usize] = Some(word);
                }
            }
        }
        let is_changed = |place: u32| changed[place as usize].is_some();
        let word = |place: u32| self.or(&changed, place);
        let mut end = self.end.clone();
        end.outputs = outputs(levels, &word);
        for (flop, held) in levels.flops.iter().zip(&mut end.registers) {
            let mut places = [flop.enable, flop.next, flop.output].into_iter();
            if places.any(is_changed) {
                *held = next(flop, &word, gates);
            }
        }
        for (store, held) in levels.stores.iter().zip(&mut end.memories) {
            let mut places = store.write.into_iter().chain([store.address]);
            if places.any(is_changed) {
                *held = taken(store, &word, gates);
            }
        }
        end
    }

    /// Does nothing that is seen, and no other register, depend on what a register begins with?
    pub(crate) fn is_dead(&self, begin: &Begin, gates: &Gates, register: usize) -> bool {
        let depends = gates.depending_on(begin.register(register));
        let others = self.end.registers.iter().enumerate();
        let others = others.filter(|(index, _)| *index != register);
        let mut seen = others.flat_map(|(_, word)| word).chain(&self.end.outputs);
        !seen.any(|bit| depends[bit.gate()])
    }

    fn or<'a>(&'a self, changed: &'a [Option<Word>], place: u32) -> &'a Word {
        let place = place as usize;
        changed[place].as_ref().unwrap_or(&self.words[place])
    }
}

/// Bits that are 1 where these bits of inputs are 0.
pub(crate) fn zero_inputs(zeros: &[(usize, u32)], begin: &Begin) -> impl Iterator<Item = Bit> {
    let zeros = zeros.iter();
    zeros.map(|(index, bit)| !bit_of(begin.input(*index), *bit))
}

/// What some registers hold after a clock.
pub(crate) fn state_pairs<'a>(
    registers: &'a [usize],
    good: &'a End,
    bad: &'a End,
) -> impl Iterator<Item = (Bit, Bit)> + 'a {
    let registers = registers.iter();
    registers.flat_map(|index| zip(&good.registers[*index], &bad.registers[*index]))
}

/// Bits of the same places.
pub(crate) fn zip(good: &Word, bad: &Word) -> Vec<(Bit, Bit)> {
    let length = good.len().max(bad.len());
    let at = |word: &Word, index: usize| word.get(index).copied().unwrap_or(NO);
    (0..length)
        .map(|index| (at(good, index), at(bad, index)))
        .collect()
}

fn outputs<'a>(levels: &Levels, word: &impl Fn(u32) -> &'a Word) -> Vec<Bit> {
    let ports = levels.outputs().iter();
    ports
        .flat_map(|port| (0..port.width).map(|index| bit_of(word(port.place), index)))
        .collect()
}

/// What a register holds after a clock.
fn next<'a>(flop: &Flop, word: &impl Fn(u32) -> &'a Word, gates: &mut Gates) -> Word {
    let enable = bit_of(word(flop.enable), 0);
    let bits = (0..flop.width).map(|index| {
        let [next, held] = [flop.next, flop.output].map(|place| bit_of(word(place), index));
        gates.select(enable, next, held)
    });
    bits.collect()
}

/// What a memory takes in a clock.
fn taken<'a>(store: &Store, word: &impl Fn(u32) -> &'a Word, gates: &mut Gates) -> Word {
    let [enable, address, data] = store.write.map(word);
    let enable = bit_of(enable, 0);
    let written = address.iter().chain(data);
    let written: Word = written.map(|bit| gates.and(enable, *bit)).collect();
    let read = word(store.address).iter().copied();
    [enable].into_iter().chain(written).chain(read).collect()
}

/// Bits of which nothing is known.
pub(crate) fn free(width: u32, gates: &mut Gates) -> Word {
    (0..width).map(|_| gates.input()).collect()
}

pub(crate) fn bit_of(word: &Word, index: u32) -> Bit {
    word.get(index as usize).copied().unwrap_or(NO)
}

fn value(code: &Code, [x, y, z]: [&Word; 3], gates: &mut Gates) -> Word {
    let width = 64 - code.mask.leading_zeros();
    let count = code.count;
    let longest = x.len().max(y.len()) as u32;
    let mut each = |of: &mut dyn FnMut(&mut Gates, u32) -> Bit| -> Word {
        (0..width).map(|index| of(gates, index)).collect()
    };
    match code.kind {
        Kind::And => each(&mut |g, i| g.and(bit_of(x, i), bit_of(y, i))),
        Kind::Or => each(&mut |g, i| g.or(bit_of(x, i), bit_of(y, i))),
        Kind::Xor => each(&mut |g, i| g.xor(bit_of(x, i), bit_of(y, i))),
        Kind::Not => each(&mut |_, i| !bit_of(x, i)),
        Kind::Select => each(&mut |g, i| g.select(bit_of(x, 0), bit_of(y, i), bit_of(z, i))),
        Kind::Slice => each(&mut |_, i| bit_of(x, i + count)),
        Kind::Above => each(&mut |_, i| match i < count {
            true => bit_of(y, i),
            false => bit_of(x, i - count),
        }),
        Kind::Sign => each(&mut |_, i| bit_of(x, i.min(63 - count))),
        Kind::Add => sum(gates, x, y, NO, width),
        Kind::Sub => {
            let y: Word = (0..width).map(|index| !bit_of(y, index)).collect();
            sum(gates, x, &y, YES, width)
        }
        Kind::Mul => product(gates, x, y, width),
        Kind::Equal => vec![!differ(gates, x, y)],
        Kind::Less => vec![less(gates, x, y, longest)],
        Kind::LessSigned => {
            let turned = |word: &Word| -> Word {
                let sign = |index| (index == count, bit_of(word, index));
                let bits = (0..=count).map(sign);
                bits.map(|(is_sign, bit)| if is_sign { !bit } else { bit })
                    .collect()
            };
            vec![less(gates, &turned(x), &turned(y), count + 1)]
        }
        Kind::Left => shifted(gates, x, y, width, NO, |index, by| index.checked_sub(by)),
        Kind::Right => shifted(gates, x, y, 64, NO, |index, by| Some(index + by)),
        Kind::RightSigned => {
            let top = 63 - count;
            let sign = bit_of(x, top);
            let x: Word = (0..64).map(|index| bit_of(x, index.min(top))).collect();
            let mut shifted = shifted(gates, &x, y, 64, sign, |index, by| Some(index + by));
            shifted.truncate(width as usize);
            shifted
        }
    }
}

pub(crate) fn sum(gates: &mut Gates, x: &Word, y: &Word, mut carry: Bit, width: u32) -> Word {
    let bits = (0..width).map(|index| {
        let (sum, over) = gates.full_add(bit_of(x, index), bit_of(y, index), carry);
        carry = over;
        sum
    });
    bits.collect()
}

fn product(gates: &mut Gates, x: &Word, y: &Word, width: u32) -> Word {
    let mut all: Word = vec![];
    for (shift, bit) in y.iter().enumerate().take(width as usize) {
        let row = x.iter().map(|x| gates.and(*x, *bit));
        let row: Word = std::iter::repeat_n(NO, shift).chain(row).collect();
        all = sum(gates, &all, &row, NO, width);
    }
    all
}

pub(crate) fn less(gates: &mut Gates, x: &Word, y: &Word, width: u32) -> Bit {
    (0..width).fold(NO, |borrow, index| {
        let (x, y) = (bit_of(x, index), bit_of(y, index));
        let differ = gates.xor(x, y);
        gates.select(differ, y, borrow)
    })
}

pub(crate) fn differ(gates: &mut Gates, a: &Word, b: &Word) -> Bit {
    let width = a.len().max(b.len()) as u32;
    (0..width).fold(NO, |any, index| {
        let differs = gates.xor(bit_of(a, index), bit_of(b, index));
        gates.or(any, differs)
    })
}

/// A shift by a word; what comes in from beyond is `fill`.
fn shifted(
    gates: &mut Gates,
    x: &Word,
    by: &Word,
    width: u32,
    fill: Bit,
    from: impl Fn(u32, u32) -> Option<u32>,
) -> Word {
    let mut now: Word = (0..width).map(|index| bit_of(x, index)).collect();
    for (place, bit) in by.iter().enumerate() {
        let distance = if place < 6 { 1 << place } else { 64 };
        let moved = |index: u32| {
            let from = from(index, distance);
            from.and_then(|from| now.get(from as usize).copied())
                .unwrap_or(fill)
        };
        let next = (0..width).map(|index| gates.select(*bit, moved(index), now[index as usize]));
        now = next.collect();
    }
    now
}
