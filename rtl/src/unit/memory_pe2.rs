//! Second-degree elementary processor with a coefficient memory and a microprogram.

use crate::kernel::*;

/// Words of the memory: the six of the polynomial, and what lines change of them as it was at the start of a field.
const WORDS: usize = 9;

/// Where a register gets its next value from.
#[derive(Clone, Copy)]
enum Next {
    Hold = 0,
    Clear = 1,
    Memory = 2,
    Sum = 3,
}

/// What the one port of the memory does in a clock.
#[derive(Clone, Copy)]
enum Port {
    Idle,
    Read(u64),
    /// Takes the last register.
    Write(u64),
}

/// A microinstruction: the sources of the three registers, and the port.
type Instruction = ([Next; 3], Port);

/// First instruction of the restoring of a field.
const RESTORE: u64 = 0;
/// First instruction of a line step.
const LINE_STEP: u64 = 6;
/// First instruction of the entry into a line.
const LINE_ENTRY: u64 = 18;
/// The instruction of a pixel.
const PIXEL: u64 = 21;
/// The instruction of a clock without work.
const IDLE: u64 = 22;

/// The microprogram.
fn program() -> Vec<Instruction> {
    use Next::{Clear, Hold, Memory, Sum};
    use Port::{Idle, Read, Write};
    vec![
        // Restore what lines have changed.
        ([Hold, Hold, Memory], Read(6)),
        ([Hold, Hold, Hold], Write(3)),
        ([Hold, Hold, Memory], Read(7)),
        ([Hold, Hold, Hold], Write(4)),
        ([Hold, Hold, Memory], Read(8)),
        ([Hold, Hold, Hold], Write(5)),
        // Line step: the increment of the line, its value, and the first increment along it.
        ([Memory, Hold, Hold], Read(1)),
        ([Hold, Memory, Hold], Read(3)),
        ([Hold, Sum, Memory], Read(5)),
        ([Hold, Hold, Sum], Idle),
        ([Hold, Hold, Clear], Write(5)),
        ([Hold, Hold, Sum], Idle),
        ([Hold, Hold, Clear], Write(3)),
        ([Memory, Hold, Hold], Read(2)),
        ([Hold, Memory, Hold], Read(4)),
        ([Hold, Sum, Hold], Idle),
        ([Hold, Hold, Sum], Idle),
        ([Hold, Hold, Hold], Write(4)),
        // Entry into the line; the second register goes one step ahead.
        ([Hold, Hold, Memory], Read(5)),
        ([Memory, Hold, Hold], Read(0)),
        ([Hold, Sum, Hold], Idle),
        // A pixel: both adders at once.
        ([Hold, Sum, Sum], Idle),
        ([Hold, Hold, Hold], Idle),
    ]
}

/// The bits of an instruction: sources of the registers in 1..0, 3..2, 5..4, word in 9..6, write in 10.
fn encoded(([first, second, third], port): Instruction) -> u64 {
    let (word, write) = match port {
        Port::Idle => (0, 0),
        Port::Read(word) => (word, 0),
        Port::Write(word) => (word, 1),
    };
    first as u64 | (second as u64) << 2 | (third as u64) << 4 | word << 6 | write << 10
}

/// Evaluates `a x^2 + b y^2 + c xy + d x + e y + f` with three registers, two adders and a memory of one port, as the source builds it.
///
/// | port | direction | format |
/// |---|---|---|
/// | `clock` | in | rising edge |
/// | `load_valid`, `load_address`, `load_data` | in | writes a word (4 bits of address, `F` bits of data) on a clock that is not busy |
/// | `field_start` | in | command: restore the words that lines change from their copies, and begin a field |
/// | `picture_start` | in | command: begin a progressive picture with the words as they were loaded |
/// | `odd_field` | in | the field has the lines 1, 3, 5, ..; read with `field_start` |
/// | `line_start` | in | command: step to the next line of the picture or field, the first one too |
/// | `pixel` | in | command: step to the next pixel of the line, the first one too |
/// | `ready` | out | a command is obeyed on this clock |
/// | `value_valid` | out | a pixel was stepped to on the clock before |
/// | `value` | out | `F` bits |
///
/// One command at a time, obeyed where `ready`; a pixel takes 1 clock, a line 15, a line of a field 27 (the first of the even field 15),
/// the start of a field 6, that of a picture 1. The words are 2A, 2B, C, E - B, D - A and F of the polynomial moved by (-1, -1), because the
/// adders work before a value is there; words 6 to 8 are the copies of words 3 to 5. The memory is made of registers here. Chaillou 1991, IV.1.5.
pub struct MemoryPe2<const F: usize> {
    /// Rising edge.
    pub clock: Signal<In, Clock>,
    /// Write a word.
    pub load_valid: Signal<In, Bit>,
    /// Which word.
    pub load_address: Signal<In, Word<4>>,
    /// The word.
    pub load_data: Signal<In, Int<F>>,
    /// Begin a field.
    pub field_start: Signal<In, Bit>,
    /// Begin a progressive picture.
    pub picture_start: Signal<In, Bit>,
    /// The field has the odd lines.
    pub odd_field: Signal<In, Bit>,
    /// Step to the next line.
    pub line_start: Signal<In, Bit>,
    /// Step to the next pixel.
    pub pixel: Signal<In, Bit>,
    /// A command is obeyed.
    pub ready: Signal<Out, Bit>,
    /// A pixel was stepped to.
    pub value_valid: Signal<Out, Bit>,
    /// The polynomial.
    pub value: Signal<Out, Int<F>>,
    busy: DFF<Bit>,
    /// The instruction of the next clock, if busy.
    pub next_step: DFF<Word<5>>,
    step: Signal<Local, Word<5>>,
    following: Signal<Local, Word<5>>,
    goes_on: Signal<Local, Bit>,
    interlaced: DFF<Bit>,
    two_steps_due: DFF<Bit>,
    second_step: DFF<Bit>,
    instruction: Signal<Local, Word<11>>,
    word: Signal<Local, Word<4>>,
    writes: Signal<Local, Bit>,
    from_port: Signal<Local, Int<F>>,
    r1_next: Signal<Local, Word<2>>,
    r2_next: Signal<Local, Word<2>>,
    r3_next: Signal<Local, Word<2>>,
    r1: DFF<Int<F>>,
    r2: DFF<Int<F>>,
    r3: DFF<Int<F>>,
    kept_valid: DFF<Bit>,
    words: Vec<DFF<Int<F>>>,
    word_number: Vec<Constant<Word<4>>>,
    microprogram: Vec<Constant<Word<11>>>,
    step_number: Vec<Constant<Word<5>>>,
    restore: Constant<Word<5>>,
    restore_end: Constant<Word<5>>,
    line_step: Constant<Word<5>>,
    line_step_end: Constant<Word<5>>,
    line_entry: Constant<Word<5>>,
    line_entry_end: Constant<Word<5>>,
    pixel_step: Constant<Word<5>>,
    idle: Constant<Word<5>>,
    one: Constant<Word<5>>,
    clear: Constant<Word<2>>,
    memory: Constant<Word<2>>,
    sum: Constant<Word<2>>,
    zero: Constant<Int<F>>,
    no_instruction: Constant<Word<11>>,
    _words: usize,
    _instructions: usize,
    _asleep: bool,
}

block! {
    [const F: usize] MemoryPe2 [F]
    inputs { clock, load_valid, load_address, load_data, field_start, picture_start, odd_field,
        line_start, pixel }
    parts { ready, value_valid, value, busy, next_step, step, following, goes_on, interlaced,
        two_steps_due, second_step, instruction, word, writes, from_port, r1_next, r2_next,
        r3_next, r1, r2, r3, kept_valid, words, word_number, microprogram, step_number, restore,
        restore_end, line_step, line_step_end, line_entry, line_entry_end, pixel_step, idle, one,
        clear, memory, sum, zero, no_instruction }
    data { _words, _instructions }
}

impl<const F: usize> MemoryPe2<F> {
    /// A processor of `F` bits.
    pub fn new() -> Self {
        let program = program();
        fields! {
            [clock, load_valid, load_address, load_data, field_start, picture_start, odd_field,
                line_start, pixel, ready, value_valid, value, busy, next_step, step, following,
                goes_on, interlaced, two_steps_due, second_step, instruction, word, writes,
                from_port, r1_next, r2_next, r3_next, r1, r2, r3, kept_valid]
            words: repeat(WORDS, Default::default),
            word_number: (0..WORDS as u64).map(constant).collect(),
            microprogram: program.iter().map(|i| constant(encoded(*i))).collect(),
            step_number: (0..program.len() as u64).map(constant).collect(),
            restore: constant(RESTORE),
            restore_end: constant(LINE_STEP - 1),
            line_step: constant(LINE_STEP),
            line_step_end: constant(LINE_ENTRY - 1),
            line_entry: constant(LINE_ENTRY),
            line_entry_end: constant(PIXEL - 1),
            pixel_step: constant(PIXEL),
            idle: constant(IDLE),
            one: constant(1),
            clear: constant(Next::Clear as u64),
            memory: constant(Next::Memory as u64),
            sum: constant(Next::Sum as u64),
            zero: signed_constant(0),
            no_instruction: constant(encoded(program[IDLE as usize])),
            _words: WORDS,
            _instructions: program.len(),
        }
    }

    /// Clocks from the command of a pixel to its value.
    pub const fn latency() -> usize {
        1
    }
}

impl<const F: usize> Default for MemoryPe2<F> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const F: usize> Logic for MemoryPe2<F> {
    #[hdl_gen]
    fn update(&mut self) {
        comment!("memory_pe2");
        dff_setup!(
            self,
            clock,
            busy,
            next_step,
            interlaced,
            two_steps_due,
            second_step,
            r1,
            r2,
            r3,
            kept_valid
        );
        // The first instruction of a command works on the clock of the command.
        self.step.next = self.idle.val();
        if self.busy.q.val() {
            self.step.next = self.next_step.q.val();
        } else if self.field_start.val() {
            self.step.next = self.restore.val();
            self.interlaced.d.next = true;
            self.two_steps_due.d.next = self.odd_field.val();
        } else if self.picture_start.val() {
            self.interlaced.d.next = false;
            self.two_steps_due.d.next = false;
        } else if self.line_start.val() {
            self.step.next = self.line_step.val();
            self.second_step.d.next = self.two_steps_due.q.val();
            self.two_steps_due.d.next = self.interlaced.q.val();
        } else if self.pixel.val() {
            self.step.next = self.pixel_step.val();
        }
        self.following.next = self.step.val() + self.one.val();
        self.goes_on.next = self.step.val() < self.pixel_step.val();
        if (self.step.val() == self.restore_end.val())
            | (self.step.val() == self.line_entry_end.val())
        {
            self.goes_on.next = false;
        }
        if self.step.val() == self.line_step_end.val() {
            self.following.next = self.line_entry.val();
            if self.second_step.q.val() {
                self.following.next = self.line_step.val();
                self.second_step.d.next = false;
            }
        }
        self.busy.d.next = self.goes_on.val();
        self.next_step.d.next = self.following.val();
        self.instruction.next = self.no_instruction.val();
        for i in 0..self._instructions {
            if self.step.val() == self.step_number[i].val() {
                self.instruction.next = self.microprogram[i].val();
            }
        }
        self.r1_next.next = self.instruction.val().get_bits::<2>(0);
        self.r2_next.next = self.instruction.val().get_bits::<2>(2);
        self.r3_next.next = self.instruction.val().get_bits::<2>(4);
        self.word.next = self.instruction.val().get_bits::<4>(6);
        self.writes.next = self.instruction.val().get_bit(10);
        self.from_port.next = self.zero.val();
        for i in 0..self._words {
            self.words[i].clock.next = self.clock.val();
            self.words[i].d.next = self.words[i].q.val();
            if self.word.val() == self.word_number[i].val() {
                self.from_port.next = self.words[i].q.val();
                if self.writes.val() {
                    self.words[i].d.next = self.r3.q.val();
                }
            }
            if self.load_valid.val()
                & !self.busy.q.val()
                & (self.load_address.val() == self.word_number[i].val())
            {
                self.words[i].d.next = self.load_data.val();
            }
        }
        if self.r1_next.val() == self.memory.val() {
            self.r1.d.next = self.from_port.val();
        }
        if self.r2_next.val() == self.memory.val() {
            self.r2.d.next = self.from_port.val();
        }
        if self.r2_next.val() == self.sum.val() {
            self.r2.d.next = self.r1.q.val() + self.r2.q.val();
        }
        if self.r3_next.val() == self.clear.val() {
            self.r3.d.next = self.zero.val();
        }
        if self.r3_next.val() == self.memory.val() {
            self.r3.d.next = self.from_port.val();
        }
        if self.r3_next.val() == self.sum.val() {
            self.r3.d.next = self.r2.q.val() + self.r3.q.val();
        }
        self.kept_valid.d.next = self.step.val() == self.pixel_step.val();
        self.ready.next = !self.busy.q.val();
        self.value_valid.next = self.kept_valid.q.val();
        self.value.next = self.r3.q.val();
    }
}

clocked!(MemoryPe2<const F: usize>);
