//! Circuits as machine code, made in the process in milliseconds.
//!
//! Each distinct module that stands in a design more than once becomes one function, called per instance; small ones
//! become part of what is around them. A clock is one call. What a port gives is computed when it is asked for, from
//! what the registers hold.
//!
//! The code is vectors of AVX2. Equal parts of a design share a vector of four words; a program
//! [in lanes](Program::in_lanes) is eight runs of the whole, with eight words of 32 bits in a vector, or four of 64 in
//! each of two. A processor without AVX2 interprets the same steps.
//!
//! ```
//! use imogene_compiled::{Simulation, Program};
//! use imogene_hdl::{Bits, Design, Value, module};
//! use std::sync::Arc;
//!
//! let design = Design::of(|| {
//!     module("counter", "top", ("enable", Bits::input(1)), |enable| {
//!         let count = Bits::register(4).named("count");
//!         count.load_when(enable, count + Bits::new(1, 4));
//!         ("value", count)
//!     });
//! });
//! let program = Arc::new(Program::new(&design, &[]));
//! let mut counter = Simulation::new(&program);
//! counter.set_all([1]);
//! (0..20).for_each(|_| counter.clock());
//! assert_eq!(counter.outputs(), [4]);
//! ```

mod assemble;
mod body;
mod edge;
mod functions;
mod interpret;
mod lanes;
mod layout;
mod line;
mod machine;
mod operations;
mod program;
mod registers;
mod rest;
mod size;
mod split;
mod word;
mod words;

pub use program::Program;

use functions::Task;
use interpret::Work;
use lanes::MOST_LANES;
use rest::Rest;
use std::sync::Arc;
use words::Words;

/// An instance of a design that runs clock by clock; in lanes it is as many of them.
pub struct Simulation {
    program: Arc<Program>,
    words: Words,
    spilled: Words,
    rest: Rest,
    /// Inputs that were set, those of a lane in a row.
    rows: Vec<i64>,
    /// What outputs and points give.
    given: [Vec<u64>; 2],
    /// Nothing changed since they were read.
    is_read: [bool; 2],
}

impl Simulation {
    /// An instance as it is at power-up.
    pub fn new(program: &Arc<Program>) -> Simulation {
        Simulation {
            words: program.power_up(),
            spilled: program.spilled(),
            rest: program.rest(),
            rows: vec![0; program.rows * program.inputs],
            given: program.given.map(|count| vec![0; count * program.lanes()]),
            is_read: [false; 2],
            program: program.clone(),
        }
    }

    /// How many runs it is.
    pub fn lanes(&self) -> usize {
        self.program.lanes()
    }

    /// Gives all inputs their words, in the order of the ports and in every lane; bits beyond a width count nothing.
    pub fn set_all(&mut self, words: impl IntoIterator<Item = u64>) {
        self.set_lane(0, words);
        let inputs = self.program.inputs;
        for lane in 1..self.program.rows {
            self.rows.copy_within(..inputs, lane * inputs);
        }
    }

    /// Gives all inputs of one lane their words, likewise.
    /// Panics on another lane than the first if all get the same inputs.
    pub fn set_lane(&mut self, lane: usize, words: impl IntoIterator<Item = u64>) {
        let inputs = self.program.inputs;
        let row = &mut self.rows[lane * inputs..][..inputs];
        row.iter_mut()
            .zip(words)
            .for_each(|(place, word)| *place = word as i64);
        self.is_read = [false; 2];
    }

    /// Gives a register of a lane another word, as a particle might. Registers are counted through the design: those of
    /// the instances in a module, then its own. Bits beyond its width count nothing.
    /// Panics if there is no such register.
    pub fn upset(&mut self, lane: usize, register: usize, word: u64) {
        self.program.registers[register].set(&mut self.words, lane, word);
        self.rest = self.program.rest();
        self.is_read = [false; 2];
    }

    /// Do all registers and memories hold what those of another instance of the same design hold?
    pub fn is_like(&self, other: &Simulation) -> bool {
        self.words[..] == other.words[..]
    }

    /// The words of all outputs in this clock, in the order of the ports; of each those of all lanes.
    pub fn outputs(&mut self) -> &[u64] {
        self.given(Task::Outputs)
    }

    /// The words of all points in this clock, in their order; of each those of all lanes.
    pub fn points(&mut self) -> &[u64] {
        self.given(Task::Points)
    }

    fn given(&mut self, task: Task) -> &[u64] {
        let which = usize::from(task == Task::Points);
        if !self.is_read[which] {
            self.run(&[task], None);
            self.is_read[which] = true;
        }
        &self.given[which]
    }

    /// The rising edge.
    pub fn clock(&mut self) {
        self.run(&[Task::Clock], None);
        self.is_read = [false; 2];
    }

    /// The rising edge with inputs that are read where they lie, a row for each lane; further lanes take those of the
    /// first. Gives the outputs after it, as [`Simulation::outputs`] does from then on. What was set stays as it was.
    /// Panics if a row has not as many words as there are inputs.
    pub fn step(&mut self, rows: &[&[i64]]) -> &[u64] {
        let count = self.program.rows;
        match rows.get(..count) {
            Some(rows) => self.run(&[Task::Clock, Task::Outputs], Some(rows)),
            None => {
                let row = |lane: usize| *rows.get(lane).unwrap_or(&rows[0]);
                let rows: [&[i64]; MOST_LANES] = std::array::from_fn(row);
                self.run(&[Task::Clock, Task::Outputs], Some(&rows[..count]));
            }
        }
        self.is_read = [true, false];
        &self.given[0]
    }

    /// With these inputs, or those that were set.
    fn run(&mut self, tasks: &[Task], rows: Option<&[&[i64]]>) {
        let (inputs, count) = (self.program.inputs, self.program.rows);
        let own: [&[i64]; MOST_LANES];
        let rows = match rows {
            Some(rows) => rows,
            None => {
                let row = |lane: usize| &self.rows[lane.min(count - 1) * inputs..][..inputs];
                own = std::array::from_fn(row);
                &own[..count]
            }
        };
        let are_whole = rows.iter().all(|row| row.len() == inputs);
        assert!(are_whole, "a word for each input");
        let mut work = Work {
            words: &mut self.words,
            given: &mut self.given[usize::from(tasks.contains(&Task::Points))],
            rows,
        };
        (self.program).run(tasks, &mut work, &mut self.spilled, &mut self.rest);
    }
}
