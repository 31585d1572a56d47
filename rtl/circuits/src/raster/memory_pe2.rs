//! Second-degree elementary processor with a coefficient memory and a microprogram.

use imogene_hdl::{Bits, Int, Value, bundle, module, net};

/// Words of the memory: the six of the polynomial, and what lines change of them as it was at the start of a field.
const WORDS: u64 = 9;

/// Where a register gets its next value from.
const HOLD: u64 = 0;
const CLEAR: u64 = 1;
const MEMORY: u64 = 2;
const SUM: u64 = 3;

/// The one port of the memory reads a word.
const fn read(word: u64) -> u64 {
    word << 6
}

/// The port takes the last register.
const fn write(word: u64) -> u64 {
    word << 6 | 1 << 10
}

/// The port does nothing that is used.
const NO_WORD: u64 = 0;

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

/// The microprogram: the sources of the three registers, and the port.
const PROGRAM: [([u64; 3], u64); 23] = [
    // Restore what lines have changed.
    ([HOLD, HOLD, MEMORY], read(6)),
    ([HOLD, HOLD, HOLD], write(3)),
    ([HOLD, HOLD, MEMORY], read(7)),
    ([HOLD, HOLD, HOLD], write(4)),
    ([HOLD, HOLD, MEMORY], read(8)),
    ([HOLD, HOLD, HOLD], write(5)),
    // Line step: the increment of the line, its value, and the first increment along it.
    ([MEMORY, HOLD, HOLD], read(1)),
    ([HOLD, MEMORY, HOLD], read(3)),
    ([HOLD, SUM, MEMORY], read(5)),
    ([HOLD, HOLD, SUM], NO_WORD),
    ([HOLD, HOLD, CLEAR], write(5)),
    ([HOLD, HOLD, SUM], NO_WORD),
    ([HOLD, HOLD, CLEAR], write(3)),
    ([MEMORY, HOLD, HOLD], read(2)),
    ([HOLD, MEMORY, HOLD], read(4)),
    ([HOLD, SUM, HOLD], NO_WORD),
    ([HOLD, HOLD, SUM], NO_WORD),
    ([HOLD, HOLD, HOLD], write(4)),
    // Entry into the line; the second register goes one step ahead.
    ([HOLD, HOLD, MEMORY], read(5)),
    ([MEMORY, HOLD, HOLD], read(0)),
    ([HOLD, SUM, HOLD], NO_WORD),
    // A pixel: both adders at once.
    ([HOLD, SUM, SUM], NO_WORD),
    ([HOLD, HOLD, HOLD], NO_WORD),
];

bundle! {
    /// What loads the memory.
    LoadWord(width) {
        valid: Bits(1), "write a word of the memory; obeyed when ready";
        address: Bits(4),
            "0 2A, 1 2B, 2 C, 3 E - B, 4 D - A, 5 F of the polynomial moved by (-1, -1); 6 to 8 the copies of 3 to 5";
        data: Int(width), "the word";
    }

    /// Commands, one at a time, obeyed where ready.
    Commands() {
        field_start: Bits(1), "command: restore words 3 to 5 from their copies and begin a field, 6 clocks";
        picture_start: Bits(1), "command: begin a progressive picture, 1 clock";
        odd_field: Bits(1), "the field has the lines 1, 3, 5, ..; read with field_start";
        line_start: Bits(1),
            "command: step to the next line; 15 clocks, 27 in a field but for the first line of the even one";
        pixel: Bits(1), "command: step to the next pixel, 1 clock";
    }

    /// What a processor with a memory gives.
    Stepped(width) {
        ready: Bits(1), "a command or a word of this clock is obeyed";
        value_valid: Bits(1), "the value is that of a pixel, stepped to one clock before";
        value: Int(width), "the polynomial, modulo its width";
    }
}

/// `a x^2 + b y^2 + c xy + d x + e y + f` with three registers, two adders and a memory of one port, as the source
/// builds it.
///
/// A pixel takes 1 clock, a line 15, a line of a field 27 (the first of the even field 15), the start of a field 6,
/// that of a picture 1. The words are 2A, 2B, C, E - B, D - A and F of the polynomial moved by (-1, -1), because the
/// adders work before a value is there; words 6 to 8 are the copies of words 3 to 5. The memory is made of registers
/// here.
///
/// Latency 1, from the command of a pixel. Chaillou 1991, IV.1.5.
pub fn memory_pe2(at: &str, load: LoadWord, commands: Commands) -> Stepped {
    let inputs = (("load", load), commands);
    module("memory_pe2", at, inputs, |(load, commands)| {
        let width = load.data.width();
        let number = |value: u64| Bits::new(value, 5);
        net! {
            let busy = Bits::register(1);
            let next_step = Bits::register(5);
            let interlaced = Bits::register(1);
            let two_steps_due = Bits::register(1);
            let second_step = Bits::register(1);
        }
        // The first instruction of a command works on the clock of the command.
        let steps = [
            (busy, next_step),
            (commands.field_start, number(RESTORE)),
            (commands.picture_start, number(IDLE)),
            (commands.line_start, number(LINE_STEP)),
            (commands.pixel, number(PIXEL)),
        ];
        let choose = |other: Bits, (holds, step): &(Bits, Bits)| holds.select(*step, other);
        net! {
            let step = steps.iter().rev().fold(number(IDLE), choose);
            let begins = !busy & (commands.field_start | commands.picture_start);
            let steps_line = !busy & !begins & commands.line_start;
            let line_steps_end = step.is(LINE_ENTRY - 1);
            let after_line_step = second_step.select(number(LINE_STEP), number(LINE_ENTRY));
            let following = line_steps_end.select(after_line_step, step + number(1));
            let ends = step.is(LINE_STEP - 1) | step.is(PIXEL - 1);
        }
        busy.load(step.less(number(PIXEL)) & !ends);
        next_step.load(following);
        interlaced.load_when(begins, commands.field_start);
        let due = begins.select(commands.field_start & commands.odd_field, interlaced);
        two_steps_due.load_when(begins | steps_line, due);
        second_step.load_when(steps_line | line_steps_end, steps_line & two_steps_due);
        let instructions = PROGRAM.iter().zip(0..);
        net! {
            let instruction = instructions.fold(Bits::new(0, 11), |other, ((registers, port), index)| {
                let sources = registers.iter().rev().fold(0, |bits, source| bits << 2 | source);
                step.is(index).select(Bits::new(sources | port, 11), other)
            });
            let word = instruction.slice(9, 6);
            let writes = instruction.bit(10);
            let r1 = Int::register(width);
            let r2 = Int::register(width);
            let r3 = Int::register(width);
        }
        let from_port = (0..WORDS).fold(Int::new(0, width), |other, index| {
            let is_loaded = load.valid & !busy & load.address.is(index);
            let is_read = word.is(index);
            let kept = is_loaded.select(load.data, r3);
            let kept = kept.reg_when(is_loaded | (is_read & writes));
            is_read.select(kept.named(&format!("words_{index}")), other)
        });
        let from_port = from_port.named("from_port");
        let load = |register: Int, index: u32, sources: &[(u64, Int)]| {
            let source = instruction.slice(2 * index + 1, 2 * index);
            let choose =
                |other: Int, (kind, next): &(u64, Int)| source.is(*kind).select(*next, other);
            register.load(sources.iter().fold(register, choose));
        };
        load(r1, 0, &[(MEMORY, from_port)]);
        load(r2, 1, &[(MEMORY, from_port), (SUM, r1 + r2)]);
        let cleared = (CLEAR, Int::new(0, width));
        load(r3, 2, &[cleared, (MEMORY, from_port), (SUM, r2 + r3)]);
        Stepped {
            ready: !busy,
            value_valid: step.is(PIXEL).reg(),
            value: r3,
        }
    })
}
