//! The simulator: all modules in one list of operations, in an order in which nothing is read before it is known.

mod code;
mod flat;

use crate::build::Design;
use crate::tree::{Direction, PortRecord};
use crate::value::mask;
use code::{Code, Run, in_runs, run};
pub use flat::Port;
use flat::{Flat, Flop, Store};
use std::array::from_fn;
use std::collections::HashMap;

/// A design that runs, clock by clock: as many instances as there are lanes, each with words of its own, in lock-step.
///
/// An operation is read once for all lanes: a clock of eight takes less than three times that of one.
pub struct Simulator<const LANES: usize = 1> {
    ports: Vec<PortRecord>,
    words: Vec<[u64; LANES]>,
    code: Vec<Code>,
    runs: Vec<Run>,
    /// So many of them, the first, need nothing but inputs.
    quiet: usize,
    flops: Vec<Flop>,
    stores: Vec<Store>,
    memories: Vec<Vec<[u64; LANES]>>,
    /// What flops and stores give from the next clock on.
    taken: Vec<[u64; LANES]>,
    is_settled: bool,
    /// No input has changed since all was settled.
    is_quiet: bool,
    points: HashMap<String, Port>,
}

/// The first word of a flop; those of the others and of the stores lie behind it.
const STATE: usize = 1;

impl Simulator {
    /// One instance of a design.
    ///
    /// # Panics
    ///
    /// With the name of a value in a loop without a register.
    pub fn new(design: &Design) -> Simulator {
        Simulator::in_lanes(design)
    }

    /// Gives an input its word; bits beyond its width count nothing.
    pub fn set(&mut self, port: Port, value: u64) {
        self.set_lane(0, port, value);
    }

    /// The word of a port in this clock.
    pub fn get(&mut self, port: Port) -> u64 {
        self.get_lane(0, port)
    }
}

impl<const LANES: usize> Simulator<LANES> {
    /// Sorts the operations of a design, for an instance in every lane.
    ///
    /// # Panics
    ///
    /// With the name of a value in a loop without a register.
    pub fn in_lanes(design: &Design) -> Simulator<LANES> {
        let mut flat = Flat::default();
        flat.word(1);
        let inputs = design.top.ports_of(Direction::In);
        let inputs: Vec<u32> = inputs.map(|_| flat.word(0)).collect();
        let outputs = flat.place(&design.top, "", &inputs);
        flat.call_ports(&design.top.ports, "", inputs.iter().chain(&outputs));
        flat.without_copies();
        flat.sort();
        let words = flat.without_constants();
        let state: Vec<u32> = flat.state().collect();
        let (runs, quiet) = in_runs(&mut flat.code, &state, words.len());
        let words = flat.ordered(words);
        let memory = |store: &Store| vec![[0; LANES]; store.words];
        Simulator {
            ports: design.top.ports.clone(),
            words: words.into_iter().map(|[word]| [word; LANES]).collect(),
            code: flat.code,
            runs,
            quiet,
            memories: flat.stores.iter().map(memory).collect(),
            taken: vec![[0; LANES]; flat.flops.len() + flat.stores.len()],
            flops: flat.flops,
            stores: flat.stores,
            is_settled: false,
            is_quiet: false,
            points: flat.points.into_iter().collect(),
        }
    }

    /// A point inside the design: a port of an instance, or a net with a name, behind the names of the instances around
    /// it, as in `processors_0.quadric.near_sum`. It may be read, not set.
    pub fn point(&self, path: &str) -> Option<Port> {
        self.points.get(path).copied()
    }

    /// The port of this name.
    ///
    /// # Panics
    ///
    /// If there is none.
    pub fn port(&self, name: &str) -> Port {
        let is_port = self.ports.iter().any(|port| port.name == name);
        let found = self.point(name).filter(|_| is_port);
        found.unwrap_or_else(|| panic!("no port `{name}`"))
    }

    /// Ports in their order.
    pub fn ports(&self) -> &[PortRecord] {
        &self.ports
    }

    /// Gives an input its word in one lane; bits beyond its width count nothing.
    pub fn set_lane(&mut self, lane: usize, port: Port, value: u64) {
        let word = &mut self.words[port.place as usize][lane];
        let value = value & mask(port.width);
        if *word != value {
            *word = value;
            (self.is_settled, self.is_quiet) = (false, false);
        }
    }

    /// The word of a port in this clock in one lane.
    pub fn get_lane(&mut self, lane: usize, port: Port) -> u64 {
        self.settle();
        self.words[port.place as usize][lane]
    }

    fn settle(&mut self) {
        if self.is_settled {
            return;
        }
        let first = if self.is_quiet { self.quiet } else { 0 };
        run(&self.runs[first..], &self.code, &mut self.words);
        (self.is_settled, self.is_quiet) = (true, true);
    }

    /// The rising edge.
    pub fn clock(&mut self) {
        self.settle();
        let words = &mut self.words;
        let (flops, read) = self.taken.split_at_mut(self.flops.len());
        for (taken, flop) in flops.iter_mut().zip(&self.flops) {
            let [enable, next, output] =
                [flop.enable, flop.next, flop.output].map(|place| words[place as usize]);
            *taken = from_fn(|lane| match enable[lane] {
                0 => output[lane],
                _ => next[lane],
            });
        }
        for ((store, memory), read) in self.stores.iter().zip(&mut self.memories).zip(read) {
            let [enable, at, data] = store.write.map(|place| words[place as usize]);
            let address = words[store.address as usize];
            for lane in 0..LANES {
                read[lane] = memory
                    .get(address[lane] as usize)
                    .map_or(0, |word| word[lane]);
                if enable[lane] != 0
                    && let Some(word) = memory.get_mut(at[lane] as usize)
                {
                    word[lane] = data[lane];
                }
            }
        }
        words[STATE..][..self.taken.len()].copy_from_slice(&self.taken);
        self.is_settled = false;
    }
}
