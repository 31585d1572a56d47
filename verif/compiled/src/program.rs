//! A design as machine code.

use crate::functions::{Function, TASKS, Task, functions};
use crate::interpret::{self, Work};
use crate::lanes::Lanes;
use crate::layout::{Layout, Register};
use crate::machine::Machine;
use crate::rest::{Part, Rest, Turn};
use crate::words::Words;
use imogene_hdl::{Design, Direction};

/// A design as machine code. Its instances share it, on any thread.
pub struct Program {
    functions: Vec<Function>,
    /// If the processor has AVX2.
    machine: Option<Machine>,
    lanes: Lanes,
    /// How many rows of inputs there are.
    pub(crate) rows: usize,
    size: usize,
    /// What may rest while the remainder runs; its functions stand in front of those of the tasks.
    parts: Vec<Part>,
    /// By their numbers in the design.
    pub(crate) registers: Vec<Register>,
    /// Words of memories at power-up, beside zeros.
    contents: Vec<(usize, u64)>,
    /// How many inputs each lane has.
    pub(crate) inputs: usize,
    /// How many outputs and points there are.
    pub(crate) given: [usize; 2],
}

impl Program {
    /// Compiles a design. Points are what is read inside: a port of an instance, or a net with a name, behind the names
    /// of the instances around it, as in `processors_0.quadric.near_sum`.
    ///
    /// Without AVX2 the steps of the code are interpreted.
    /// Panics with the name of a value in a loop without a register, or with a point that the design does not have.
    pub fn new(design: &Design, points: &[String]) -> Program {
        Program::of(design, points, Lanes::One, false)
    }

    /// As [`Program::new`], for eight runs side by side.
    pub fn in_lanes(design: &Design, points: &[String]) -> Program {
        Program::of(design, points, Lanes::Eight, false)
    }

    /// The same for runs that all get the same inputs.
    pub fn on_one_stimulus(design: &Design, points: &[String]) -> Program {
        Program::of(design, points, Lanes::Eight, true)
    }

    fn of(design: &Design, points: &[String], lanes: Lanes, shares_inputs: bool) -> Program {
        let layout = Layout::of(design, lanes);
        let outputs = design.top.ports_of(Direction::Out);
        let outputs: Vec<String> = outputs.map(|port| port.name.clone()).collect();
        let functions = functions(design, &layout, lanes, shares_inputs, [&outputs, points]);
        let rows = if shares_inputs { 1 } else { lanes.count() };
        let parts = layout.resting();
        let outer = functions.len() - TASKS - parts.len();
        Program {
            inputs: design.top.ports_of(Direction::In).count(),
            given: [outputs.len(), points.len()],
            machine: Machine::of(&functions, outer, rows),
            rows,
            functions,
            lanes,
            parts,
            size: layout.size,
            registers: layout.registers(&design.top, lanes),
            contents: layout.contents(&design.top, lanes),
        }
    }

    /// The same program without machine code: its steps are interpreted, one by one.
    pub fn interpreted(mut self) -> Program {
        self.machine = None;
        self
    }

    /// The machine code, for a disassembler; none without AVX2.
    pub fn machine_code(&self) -> Option<&[u8]> {
        self.machine.as_ref().map(|machine| &machine.code[..])
    }

    /// How many runs lie side by side: 1 or 8.
    pub fn lanes(&self) -> usize {
        self.lanes.count()
    }

    /// All words as they are at power-up.
    pub(crate) fn power_up(&self) -> Words {
        let mut words = Words::new(self.size);
        for register in &self.registers {
            for lane in 0..self.lanes() {
                register.set(&mut words, lane, register.initial);
            }
        }
        for &(place, word) in &self.contents {
            words[place..place + self.lanes()].fill(word);
        }
        words
    }

    /// Room for what does not fit into registers.
    pub(crate) fn spilled(&self) -> Words {
        let machine = self.machine.as_ref();
        Words::new(4 * machine.map_or(0, |machine| machine.spilled))
    }

    /// What is known of the parts of an instance at power-up.
    pub(crate) fn rest(&self) -> Rest {
        Rest::of(&self.parts)
    }

    /// Does tasks with the words of an instance, one after the other; only others than the clock give words.
    pub(crate) fn run(
        &self,
        tasks: &[Task],
        work: &mut Work<'_>,
        spilled: &mut [u64],
        rest: &mut Rest,
    ) {
        let first = self.functions.len() - TASKS;
        for task in tasks {
            self.call(first + *task as usize, work, spilled);
            if *task != Task::Clock {
                continue;
            }
            for (index, part) in self.parts.iter().enumerate() {
                let turn = rest.turn(index, part, work.words);
                if turn != Turn::Rest {
                    self.call(first - self.parts.len() + index, work, spilled);
                }
                if turn == Turn::RunAndLook {
                    rest.look(index, part, work.words);
                }
            }
        }
    }

    fn call(&self, function: usize, work: &mut Work<'_>, spilled: &mut [u64]) {
        match &self.machine {
            Some(machine) => machine.run(function, work, spilled),
            None => interpret::run(&self.functions, function, 0, work),
        }
    }
}
