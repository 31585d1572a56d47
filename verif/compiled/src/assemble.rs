//! Instructions of x86-64 with AVX2, as bytes: Intel's manual, volume 2, sections 2.3 (VEX) and 2.1 (memory operands).
//!
//! A selection is one instruction less, and its condition is found once for many, where the processor has the masks of
//! AVX-512 (section 2.7, EVEX). In eight lanes all vectors are its own, of 512 bits, in twice as many registers.

use crate::layout::Lanes;
use crate::line::Two;

/// Vector registers of AVX-512; AVX2 has half as many.
pub(crate) const REGISTERS: usize = 32;

/// A general register that holds an address; these are in the order in which a function takes them.
pub(crate) type Base = u8;
pub(crate) const BLOCK: Base = 7;
pub(crate) const SPILLED: Base = 6;
pub(crate) const GIVEN: Base = 2;
pub(crate) const CONSTANTS: Base = 1;
/// The inputs of the first lane, or of all; those of the others are in the registers behind it.
pub(crate) const ROWS: Base = 8;

/// Where a word is read: a vector register, or so many bytes behind an address.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Operand {
    Register(u8),
    Memory(Base, i32),
}

/// An instruction: its table of codes, the prefix that it implies, the wide form of its operands (W), its code.
pub(crate) struct Code(u8, u8, u8, u8);

const LOAD: Code = Code(1, 2, 0, 0x6f);
const STORE: Code = Code(1, 2, 0, 0x7f);
const LOAD_WORD: Code = Code(1, 2, 0, 0x7e);
/// A word beside the one that is there.
pub(crate) const LOAD_HIGH: Code = Code(1, 1, 0, 0x16);
const STORE_WORD: Code = Code(1, 1, 0, 0xd6);
const SHIFT: Code = Code(1, 1, 0, 0x73);
/// The way of a shift.
pub(crate) const LEFT: u8 = 6;
pub(crate) const RIGHT: u8 = 2;
/// The top bit of each lane, in a general register (rax).
const TOP_BITS: Code = Code(1, 1, 0, 0x50);
const SELECT: Code = Code(3, 1, 0, 0x4b);
/// A word in every lane.
const SPREAD: Code = Code(2, 1, 0, 0x59);
/// Two words side by side.
pub(crate) const PAIR: Code = Code(1, 1, 0, 0x6c);
const HALVES: Code = Code(3, 1, 0, 0x38);
/// A mask as a vector, all ones in each of its lanes.
const FROM_MASK: Code = Code(2, 2, 1, 0x38);
/// The words of a vector with another in the lanes that a byte behind it names by its pairs of bits.
pub(crate) const BLEND: Code = Code(3, 1, 0, 0x02);
/// The top bits of a vector in a mask.
pub(crate) const TO_MASK: Code = Code(2, 2, 1, 0x39);
/// The second operand where the mask has a one, else the first.
pub(crate) const SELECT_BY_MASK: Code = Code(2, 1, 1, 0x64);

/// An index of a memory (rax), from the spilled words.
pub(crate) const LOAD_INDEX: [u8; 3] = [0x48, 0x8b, 0x86];
/// A word of the spilled words (rdx, for an edge gives nothing), from there and to there.
pub(crate) const LOAD_SCALAR: [u8; 3] = [0x48, 0x8b, 0x96];
pub(crate) const STORE_SCALAR: [u8; 3] = [0x48, 0x89, 0x96];
/// The word of the block at the index, from there and to there.
pub(crate) const READ: [u8; 4] = [0x48, 0x8b, 0x94, 0xc7];
pub(crate) const WRITE: [u8; 4] = [0x48, 0x89, 0x94, 0xc7];

/// Masks of AVX-512 but for the first, which means none.
pub(crate) const MASKS: usize = 7;

fn code(how: Two) -> Code {
    match how {
        Two::Add => Code(1, 1, 0, 0xd4),
        Two::Sub => Code(1, 1, 0, 0xfb),
        Two::And => Code(1, 1, 0, 0xdb),
        Two::AndNot => Code(1, 1, 0, 0xdf),
        Two::Or => Code(1, 1, 0, 0xeb),
        Two::Xor => Code(1, 1, 0, 0xef),
        Two::Equal => Code(2, 1, 0, 0x29),
        Two::Greater => Code(2, 1, 0, 0x37),
        Two::LeftBy => Code(2, 1, 1, 0x47),
        Two::RightBy => Code(2, 1, 1, 0x45),
        Two::Product => Code(1, 1, 0, 0xf4),
        Two::SignedProduct => Code(2, 1, 0, 0x28),
    }
}

/// Instructions that are being written, in so many lanes: those of one lane leave the other words of a register as
/// they come.
pub(crate) struct Assembler {
    pub(crate) bytes: Vec<u8>,
    pub(crate) lanes: Lanes,
    pub(crate) has_masks: bool,
    /// All lanes get the inputs of the first.
    pub(crate) shares_inputs: bool,
}

impl Assembler {
    pub(crate) fn vex(&mut self, code: Code, is_wide: bool, reg: u8, first: u8, second: Operand) {
        let Code(table, prefix, w, code) = code;
        let beyond = |register: u8| (!register >> 3) & 1;
        let beyond_second = match second {
            Operand::Register(register) => beyond(register),
            Operand::Memory(base, _) => beyond(base),
        };
        let last = w << 7 | (!first & 15) << 3 | u8::from(is_wide) << 2 | prefix;
        match beyond_second == 1 && table == 1 && w == 0 {
            true => self.bytes.extend([0xc5, beyond(reg) << 7 | last, code]),
            false => {
                let middle = beyond(reg) << 7 | 1 << 6 | beyond_second << 5 | table;
                self.bytes.extend([0xc4, middle, last, code]);
            }
        }
        match second {
            Operand::Memory(base, bytes) if i8::try_from(bytes).is_ok() => {
                let reg = (reg & 7) << 3;
                self.bytes.extend([0x40 | reg | base & 7, bytes as u8]);
            }
            _ => self.operand(reg, second),
        }
    }

    fn operand(&mut self, reg: u8, second: Operand) {
        let reg = (reg & 7) << 3;
        match second {
            Operand::Register(register) => self.bytes.push(0xc0 | reg | register & 7),
            Operand::Memory(base, bytes) => {
                self.bytes.push(0x80 | reg | base & 7);
                self.bytes.extend(bytes.to_le_bytes());
            }
        }
    }

    /// Of words of 64 bits.
    pub(crate) fn evex(&mut self, code: Code, reg: u8, first: u8, second: Operand, mask: u8) {
        let Code(table, prefix, _, byte) = code;
        let lacks = |register: u8, bit: u32| (!register >> bit) & 1;
        let [more, beyond] = match second {
            Operand::Register(register) => [4, 3].map(|bit| lacks(register, bit)),
            Operand::Memory(base, _) => [1, lacks(base, 3)],
        };
        let registers = lacks(reg, 3) << 7 | more << 6 | beyond << 5 | lacks(reg, 4) << 4 | table;
        let middle = 1 << 7 | (!first & 15) << 3 | 1 << 2 | prefix;
        let is_wide = self.lanes == Lanes::Eight;
        // A constant or an input lies once, and is read into every lane.
        let is_word = is_wide && matches!(second, Operand::Memory(CONSTANTS | ROWS, _));
        let is_spread = is_word && byte != SPREAD.3;
        let last = (self.lanes as u8) << 5 | u8::from(is_spread) << 4 | lacks(first, 4) << 3 | mask;
        self.bytes.extend([0x62, registers, middle, last, byte]);
        // There a distance of one byte counts words or vectors.
        let unit = if is_word { 8 } else { 64 };
        match second {
            Operand::Memory(base, bytes)
                if is_wide && bytes % unit == 0 && i8::try_from(bytes / unit).is_ok() =>
            {
                let reg = (reg & 7) << 3;
                self.bytes
                    .extend([0x40 | reg | base & 7, (bytes / unit) as u8]);
            }
            _ => self.operand(reg, second),
        }
    }

    fn vector(&mut self, code: Code, reg: u8, first: u8, second: Operand) {
        match self.lanes {
            Lanes::Eight => self.evex(code, reg, first, second, 0),
            lanes => self.vex(code, lanes == Lanes::Four, reg, first, second),
        }
    }

    /// How many vector registers there are.
    pub(crate) fn registers(&self) -> usize {
        match self.lanes {
            Lanes::Eight => REGISTERS,
            _ => REGISTERS / 2,
        }
    }

    pub(crate) fn two(&mut self, how: Two, to: u8, a: u8, b: Operand) {
        match (how, self.lanes) {
            (Two::Equal | Two::Greater, Lanes::Eight) => {
                self.vector(code(how), 0, a, b);
                self.vector(FROM_MASK, to, 0, Operand::Register(0));
            }
            _ => self.vector(code(how), to, a, b),
        }
    }

    pub(crate) fn shift(&mut self, way: u8, to: u8, a: u8, count: u32) {
        self.vector(SHIFT, way, to, Operand::Register(a));
        self.bytes.push(count as u8);
    }

    /// The first operand where the top bit of `which` is 1, else `or`.
    pub(crate) fn select(&mut self, to: u8, which: u8, then: Operand, or: u8) {
        self.vector(SELECT, to, or, then);
        self.bytes.push(which << 4);
    }

    /// Two pairs side by side.
    pub(crate) fn halves(&mut self, to: u8, low: u8, high: u8) {
        self.vex(HALVES, true, to, low, Operand::Register(high));
        self.bytes.push(1);
    }

    /// A whole vector.
    pub(crate) fn load(&mut self, to: u8, from: Operand) {
        match (self.lanes, from) {
            (Lanes::Eight, Operand::Memory(CONSTANTS, _)) => self.spread(to, from),
            _ => self.whole(LOAD, to, from),
        }
    }

    /// A whole vector.
    pub(crate) fn store(&mut self, from: u8, to: Operand) {
        self.whole(STORE, from, to);
    }

    /// One word in every lane.
    pub(crate) fn spread(&mut self, to: u8, from: Operand) {
        self.whole(SPREAD, to, from);
    }

    fn whole(&mut self, code: Code, register: u8, place: Operand) {
        match self.lanes {
            Lanes::Eight => self.evex(code, register, 0, place, 0),
            _ => self.vex(code, true, register, 0, place),
        }
    }

    /// The words of the lanes alone.
    pub(crate) fn load_words(&mut self, lanes: Lanes, to: u8, from: Operand) {
        match lanes {
            Lanes::One => self.vex(LOAD_WORD, false, to, 0, from),
            _ => self.load(to, from),
        }
    }

    /// The words of the lanes alone.
    pub(crate) fn store_words(&mut self, lanes: Lanes, from: u8, to: Operand) {
        match lanes {
            Lanes::One => self.vex(STORE_WORD, false, from, 0, to),
            _ => self.store(from, to),
        }
    }

    /// An instruction of general registers, with so many bytes behind an address.
    pub(crate) fn general<const N: usize>(&mut self, code: [u8; N], bytes: i32) {
        self.bytes.extend(code);
        self.bytes.extend(bytes.to_le_bytes());
    }

    /// A function that begins at this byte, for the block so many bytes further.
    pub(crate) fn call(&mut self, begin: usize, block: i32) {
        self.general([0x48, 0x81, 0xc7], block);
        let behind = self.bytes.len() as i32 + 5;
        self.general([0xe8], begin as i32 - behind);
        self.general([0x48, 0x81, 0xc7], -block);
    }

    /// Jumps if the top bit is 0 in every lane; gives the byte behind the jump.
    pub(crate) fn jump_unless(&mut self, which: u8) -> usize {
        if self.lanes == Lanes::Eight {
            self.evex(TO_MASK, 0, 0, Operand::Register(which), 0);
            // Whether that mask is zero.
            self.bytes.extend([0xc5, 0xf9, 0x98, 0xc0]);
        } else {
            self.vector(TOP_BITS, 0, 0, Operand::Register(which));
            let lanes = (1u8 << self.lanes.count()) - 1;
            self.bytes.extend([0xa8, lanes]);
        }
        self.general([0x0f, 0x84], 0);
        self.bytes.len()
    }

    /// The jump with this byte behind it goes to here.
    pub(crate) fn land(&mut self, jump: usize) {
        let distance = (self.bytes.len() - jump) as i32;
        self.bytes[jump - 4..jump].copy_from_slice(&distance.to_le_bytes());
    }

    /// The addresses of the rows, from where they lie side by side (r8): the first comes last in its place.
    pub(crate) fn begin(&mut self) {
        let rows = if self.shares_inputs {
            1
        } else {
            self.lanes.count()
        };
        for lane in (0..rows as u8).rev() {
            self.bytes.extend([0x4d, 0x8b, 0x40 | lane << 3, 8 * lane]);
        }
    }

    /// The end; a function that is not called by others leaves no upper halves to whoever does not know of them.
    pub(crate) fn end(&mut self, is_outer: bool) {
        if is_outer {
            self.bytes.extend([0xc5, 0xf8, 0x77]);
        }
        self.bytes.push(0xc3);
    }
}
