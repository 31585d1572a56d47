//! Instructions of x86-64 with AVX2, as bytes: Intel's manual, volume 2, sections 2.3 (VEX) and 2.1 (memory operands).
//!
//! A selection is one instruction less, and its condition is found once for many, where the processor has the masks of
//! AVX-512 (section 2.7, EVEX).

use crate::lanes::Lanes;
use crate::line::{Shuffle, Two};
use crate::size::Size;

/// Vector registers.
pub(crate) const REGISTERS: usize = 16;

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
#[derive(Clone, Copy)]
pub(crate) struct Code(u8, u8, u8, u8);

const LOAD: Code = Code(1, 2, 0, 0x6f);
const STORE: Code = Code(1, 2, 0, 0x7f);
const LOAD_WORD: Code = Code(1, 2, 0, 0x7e);
/// The words for which those of another vector are all ones.
pub(crate) const LOAD_WHERE: Code = Code(2, 1, 1, 0x8c);
const STORE_WORD: Code = Code(1, 1, 0, 0xd6);
/// By the size of words.
const SHIFT: [Code; 2] = [Code(1, 1, 0, 0x72), Code(1, 1, 0, 0x73)];
/// Of eight half words those that the low bits of each half word say.
pub(crate) const LOOKUP: Code = Code(2, 1, 0, 0x36);
/// The way of a shift.
pub(crate) const LEFT: u8 = 6;
pub(crate) const RIGHT: u8 = 2;
/// The top bit of each lane, in a general register (rax).
const TOP_BITS: [Code; 2] = [Code(1, 0, 0, 0x50), Code(1, 1, 0, 0x50)];
const SELECT: [Code; 2] = [Code(3, 1, 0, 0x4a), Code(3, 1, 0, 0x4b)];
/// A word in every lane.
const SPREAD: [Code; 2] = [Code(2, 1, 0, 0x58), Code(2, 1, 0, 0x59)];
/// Two words side by side.
pub(crate) const PAIR: Code = Code(1, 1, 0, 0x6c);
const ODD: Code = Code(1, 1, 0, 0x6d);
/// Two half words of each of two pairs of words, which a byte behind it names.
const FROM_PAIRS: Code = Code(1, 0, 0, 0xc6);
/// Two halves of two vectors, which a byte behind it names.
const FROM_HALVES: Code = Code(3, 1, 0, 0x46);
const HALVES: Code = Code(3, 1, 0, 0x38);
/// The words of a vector with those of another in the halves of lanes that a byte behind it names.
const BLEND: Code = Code(3, 1, 0, 0x02);
/// The top bits of a vector in a mask.
pub(crate) const TO_MASK: Code = Code(2, 2, 1, 0x39);
/// The second operand where the mask has a one, else the first.
pub(crate) const SELECT_BY_MASK: Code = Code(2, 1, 1, 0x64);

/// What puts registers of the caller on the stack (r12 to r15, the rows of the last lanes).
const KEPT: [u8; 4] = [0x54, 0x55, 0x56, 0x57];

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

fn code(how: Two, size: Size) -> Code {
    if size == Size::Half {
        return match how {
            Two::Add => Code(1, 1, 0, 0xfe),
            Two::Sub => Code(1, 1, 0, 0xfa),
            Two::Equal => Code(1, 1, 0, 0x76),
            Two::Greater => Code(1, 1, 0, 0x66),
            Two::LeftBy => Code(2, 1, 0, 0x47),
            Two::RightBy => Code(2, 1, 0, 0x45),
            Two::Product | Two::SignedProduct => Code(2, 1, 0, 0x40),
            bit_by_bit => code(bit_by_bit, Size::Whole),
        };
    }
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
    /// Of inputs: one for each lane, or one for all; none where no input is read.
    pub(crate) rows: usize,
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
                self.address(0x40, reg, base);
                self.bytes.push(bytes as u8);
            }
            _ => self.operand(reg, second),
        }
    }

    fn operand(&mut self, reg: u8, second: Operand) {
        match second {
            Operand::Register(register) => self.bytes.push(0xc0 | (reg & 7) << 3 | register & 7),
            Operand::Memory(base, bytes) => {
                self.address(0x80, reg, base);
                self.bytes.extend(bytes.to_le_bytes());
            }
        }
    }

    /// So many bytes, as the mode says, behind an address.
    fn address(&mut self, mode: u8, reg: u8, base: Base) {
        self.bytes.push(mode | (reg & 7) << 3 | base & 7);
        if base & 7 == 4 {
            // Without an index.
            self.bytes.push(0x24);
        }
    }

    /// Of words of 64 bits.
    pub(crate) fn evex(&mut self, code: Code, reg: u8, first: u8, second: Operand, mask: u8) {
        let Code(table, prefix, _, byte) = code;
        let lacks = |register: u8| (!register >> 3) & 1;
        let beyond = match second {
            Operand::Register(register) | Operand::Memory(register, _) => lacks(register),
        };
        // Registers from 16 on would need the other two bits.
        let registers = lacks(reg) << 7 | 1 << 6 | beyond << 5 | 1 << 4 | table;
        let middle = 1 << 7 | (!first & 15) << 3 | 1 << 2 | prefix;
        let last = (self.lanes as u8) << 5 | 1 << 3 | mask;
        self.bytes.extend([0x62, registers, middle, last, byte]);
        self.operand(reg, second);
    }

    fn vector(&mut self, code: Code, reg: u8, first: u8, second: Operand) {
        self.vex(code, self.lanes == Lanes::Four, reg, first, second);
    }

    pub(crate) fn two(&mut self, how: Two, size: Size, to: u8, a: u8, b: Operand) {
        self.vector(code(how, size), to, a, b);
    }

    pub(crate) fn shift(&mut self, way: u8, size: Size, to: u8, a: u8, count: u32) {
        self.vector(SHIFT[size as usize], way, to, Operand::Register(a));
        self.bytes.push(count as u8);
    }

    /// The first operand where the top bit of `which` is 1, else `or`.
    pub(crate) fn select(&mut self, size: Size, to: u8, which: u8, then: Operand, or: u8) {
        self.vector(SELECT[size as usize], to, or, then);
        self.bytes.push(which << 4);
    }

    /// Words of two vectors.
    pub(crate) fn shuffle(&mut self, how: Shuffle, to: u8, a: u8, b: Operand) {
        let (code, halves) = match how {
            Shuffle::Even => (PAIR, None),
            Shuffle::Odd => (ODD, None),
            Shuffle::Front => (FROM_HALVES, Some(0x20)),
            Shuffle::Back => (FROM_HALVES, Some(0x31)),
            Shuffle::LowHalves => (FROM_PAIRS, Some(0x88)),
            Shuffle::HighHalves => (FROM_PAIRS, Some(0xdd)),
        };
        self.vex(code, true, to, a, b);
        self.bytes.extend(halves);
    }

    /// Two pairs side by side.
    pub(crate) fn halves(&mut self, to: u8, low: u8, high: u8) {
        self.vex(HALVES, true, to, low, Operand::Register(high));
        self.bytes.push(1);
    }

    /// A whole vector.
    pub(crate) fn load(&mut self, to: u8, from: Operand) {
        self.vex(LOAD, true, to, 0, from);
    }

    /// A whole vector.
    pub(crate) fn store(&mut self, from: u8, to: Operand) {
        self.vex(STORE, true, from, 0, to);
    }

    /// One word in every lane.
    pub(crate) fn spread(&mut self, size: Size, to: u8, from: Operand) {
        self.vex(SPREAD[size as usize], true, to, 0, from);
    }

    /// The words of a vector, but for the halves of lanes that a byte names.
    pub(crate) fn blend(&mut self, to: u8, from: u8, others: Operand, halves: u8) {
        self.vex(BLEND, true, to, from, others);
        self.bytes.push(halves);
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
    pub(crate) fn jump_unless(&mut self, size: Size, which: u8) -> usize {
        self.vector(TOP_BITS[size as usize], 0, 0, Operand::Register(which));
        let lanes = match size {
            Size::Half => u8::MAX,
            Size::Whole => (1 << self.lanes.count()) - 1,
        };
        self.bytes.extend([0xa8, lanes]);
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
        if self.rows > 1 {
            self.bytes
                .extend(KEPT.map(|push| [0x41, push]).as_flattened());
        }
        for lane in (0..self.rows as u8).rev() {
            self.bytes.extend([0x4d, 0x8b, 0x40 | lane << 3, 8 * lane]);
        }
    }

    /// The end; a function that is not called by others leaves no upper halves to whoever does not know of them.
    pub(crate) fn end(&mut self, is_outer: bool) {
        if is_outer {
            self.bytes.extend([0xc5, 0xf8, 0x77]);
        }
        if self.rows > 1 {
            let pops = KEPT.map(|push| push + 8);
            self.bytes
                .extend(pops.iter().rev().flat_map(|pop| [0x41, *pop]));
        }
        self.bytes.push(0xc3);
    }
}
