//! Circuits as machine code, made in the process in milliseconds.
//!
//! Each distinct module that stands in a design more than once becomes one function, called per instance; small ones
//! become part of what is around them. A clock is one call. What a port gives is computed when it is asked for, from
//! what the registers hold.
//!
//! ```
//! use imogene_compiled::{Lanes, Program};
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
//! let mut counters = Lanes::new(&program, 2);
//! counters.set(1, enable, 1);
//! (0..20).for_each(|_| counters.clock());
//! assert_eq!(counters.get(0, value), 0);
//! assert_eq!(counters.get(1, value), 4);
//! ```
#![warn(missing_docs)]

mod body;
mod code;
mod layout;
mod program;
mod word;

pub use program::{Port, Program};

use program::{Given, Place};
use std::sync::Arc;

/// Instances of a design, each with words of its own, that run side by side, clock by clock.
pub struct Lanes {
    program: Arc<Program>,
    lanes: Vec<Lane>,
}

#[derive(Clone)]
struct Lane {
    words: Vec<u64>,
    /// What outputs and points give.
    given: [Vec<u64>; 2],
    /// Nothing changed since they were read.
    is_read: [bool; 2],
}

impl Lanes {
    /// So many instances, as they are at power-up.
    pub fn new(program: &Arc<Program>, lanes: usize) -> Lanes {
        let lane = Lane {
            words: program.power_up().to_vec(),
            given: program.given().map(|count| vec![0; count]),
            is_read: [false; 2],
        };
        Lanes {
            program: program.clone(),
            lanes: vec![lane; lanes],
        }
    }

    /// Gives an input its word in one lane; bits beyond its width count nothing.
    ///
    /// # Panics
    ///
    /// If it is no input.
    pub fn set(&mut self, lane: usize, port: Port, value: u64) {
        let Place::Input(place) = port.place else {
            panic!("{port:?} is no input");
        };
        let lane = &mut self.lanes[lane];
        let value = value & (u64::MAX >> (64 - port.width));
        if lane.words[place] != value {
            lane.words[place] = value;
            lane.is_read = [false; 2];
        }
    }

    /// The word of a port in this clock in one lane.
    pub fn get(&mut self, lane: usize, port: Port) -> u64 {
        let lane = &mut self.lanes[lane];
        let (given, index) = match port.place {
            Place::Input(place) => return lane.words[place],
            Place::Output(index) => (Given::Outputs, index),
            Place::Point(index) => (Given::Points, index),
        };
        let which = given as usize;
        if !lane.is_read[which] {
            self.program
                .read(given, &lane.words, &mut lane.given[which]);
            lane.is_read[which] = true;
        }
        lane.given[which][index]
    }

    /// The rising edge, in all lanes.
    pub fn clock(&mut self) {
        for lane in &mut self.lanes {
            self.program.clock(&mut lane.words);
            lane.is_read = [false; 2];
        }
    }
}
