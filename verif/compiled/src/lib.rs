//! Circuits as machine code, made in the process in milliseconds.
//!
//! Each distinct module that stands in a design more than once becomes one function, called per instance; small ones
//! become part of what is around them. A clock is one call. What a port gives is computed when it is asked for, from
//! what the registers hold.
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
//! let (enable, value) = (program.port("enable"), program.port("value"));
//! let mut counter = Simulation::new(&program);
//! counter.set(enable, 1);
//! (0..20).for_each(|_| counter.clock());
//! assert_eq!(counter.get(value), 4);
//! ```

mod body;
mod code;
mod edge;
mod layout;
mod program;
mod word;

pub use program::{Port, Program};

use program::{Given, Place};
use std::sync::Arc;

/// An instance of a design that runs clock by clock.
pub struct Simulation {
    program: Arc<Program>,
    words: Vec<u64>,
    /// What outputs and points give.
    given: [Vec<u64>; 2],
    /// Nothing changed since they were read.
    is_read: [bool; 2],
}

impl Simulation {
    /// An instance as it is at power-up.
    pub fn new(program: &Arc<Program>) -> Simulation {
        Simulation {
            words: program.power_up().to_vec(),
            given: program.given().map(|count| vec![0; count]),
            is_read: [false; 2],
            program: program.clone(),
        }
    }

    /// Gives an input its word; bits beyond its width count nothing.
    ///
    /// # Panics
    ///
    /// If it is no input.
    pub fn set(&mut self, port: Port, value: u64) {
        let Place::Input(place) = port.place else {
            panic!("{port:?} is no input");
        };
        let value = value & (u64::MAX >> (64 - port.width));
        if self.words[place] != value {
            self.words[place] = value;
            self.is_read = [false; 2];
        }
    }

    /// Gives all inputs their words, in the order of the ports; bits beyond a width count nothing.
    pub fn set_all(&mut self, words: impl IntoIterator<Item = u64>) {
        let places = self.words.iter_mut().zip(self.program.input_masks());
        for ((place, mask), word) in places.zip(words) {
            *place = word & mask;
        }
        self.is_read = [false; 2];
    }

    /// Gives a register another word, as a particle might. Registers are counted through the design: those of the
    /// instances in a module, then its own. The word has no bits beyond the width of the register.
    ///
    /// # Panics
    ///
    /// If there is no such register.
    pub fn upset(&mut self, register: usize, word: u64) {
        self.words[self.program.registers()[register]] = word;
        self.is_read = [false; 2];
    }

    /// The words of all outputs in this clock, in the order of the ports.
    pub fn outputs(&mut self) -> &[u64] {
        self.given(Given::Outputs)
    }

    /// The word of a port in this clock.
    pub fn get(&mut self, port: Port) -> u64 {
        let (given, index) = match port.place {
            Place::Input(place) => return self.words[place],
            Place::Output(index) => (Given::Outputs, index),
            Place::Point(index) => (Given::Points, index),
        };
        self.given(given)[index]
    }

    fn given(&mut self, given: Given) -> &[u64] {
        let which = given as usize;
        let found = &mut self.given[which];
        if !self.is_read[which] {
            self.program.read(given, &self.words, found);
            self.is_read[which] = true;
        }
        found
    }

    /// The rising edge.
    pub fn clock(&mut self) {
        self.program.clock(&mut self.words);
        self.is_read = [false; 2];
    }
}
