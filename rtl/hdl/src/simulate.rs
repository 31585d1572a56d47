//! The simulator: all modules in one list of operations, in an order in which nothing is read before it is known.

mod code;
mod flat;

use crate::build::Design;
use crate::tree::PortRecord;
use crate::value::mask;
pub use code::{Code, Kind};
pub use flat::{Flop, Levels, Port, Store};
use std::collections::HashMap;

/// A design that runs, clock by clock: the check of what is compiled of it.
pub struct Simulator {
    ports: Vec<PortRecord>,
    levels: Levels,
    /// What is read of a word while it is written comes out inverted.
    upsets_collisions: bool,
    is_settled: bool,
    points: HashMap<String, Port>,
}

impl Simulator {
    /// A design at power-up.
    ///
    /// # Panics
    ///
    /// With the name of a value in a loop without a register.
    pub fn new(design: &Design) -> Simulator {
        let levels = Levels::of(design);
        Simulator {
            ports: design.top.ports.clone(),
            points: levels.points.iter().cloned().collect(),
            levels,
            upsets_collisions: false,
            is_settled: false,
        }
    }

    /// Inverts what a memory reads of a word while it is written, on which no circuit may depend ([`memory`]).
    ///
    /// [`memory`]: crate::memory
    pub fn with_upset_collisions(self) -> Simulator {
        Simulator {
            upsets_collisions: true,
            ..self
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

    /// Gives an input its word; bits beyond its width count nothing.
    pub fn set(&mut self, port: Port, value: u64) {
        self.levels.words[port.place as usize] = value & mask(port.width);
        self.is_settled = false;
    }

    /// The word of a port in this clock.
    pub fn get(&mut self, port: Port) -> u64 {
        self.settle();
        self.levels.words[port.place as usize]
    }

    /// What each register holds, in the order of [`Levels::flops`].
    pub fn registers(&self) -> impl Iterator<Item = u64> {
        let flops = self.levels.flops.iter();
        flops.map(|flop| self.levels.words[flop.output as usize])
    }

    fn settle(&mut self) {
        if !self.is_settled {
            let Levels { code, words, .. } = &mut self.levels;
            code.iter().for_each(|code| code.run(words));
            self.is_settled = true;
        }
    }

    /// The rising edge: all that is taken is read before any of it is written.
    pub fn clock(&mut self) {
        self.settle();
        let words = &mut self.levels.words;
        let taken = self.levels.flops.iter().map(|flop| {
            let is_held = words[flop.enable as usize] == 0;
            let from = if is_held { flop.output } else { flop.next };
            (flop.output, words[from as usize])
        });
        let read = self.levels.stores.iter_mut().map(|store| {
            let memory = &mut store.words;
            let [enable, at, data] = store.write.map(|place| words[place as usize]);
            let address = words[store.address as usize];
            let mut read = memory.get(address as usize).copied().unwrap_or(0);
            if self.upsets_collisions && enable != 0 && at == address {
                read ^= mask(store.width);
            }
            if enable != 0
                && let Some(word) = memory.get_mut(at as usize)
            {
                *word = data;
            }
            (store.output, read)
        });
        let taken: Vec<(u32, u64)> = taken.chain(read).collect();
        for (place, word) in taken {
            words[place as usize] = word;
        }
        self.is_settled = false;
    }
}
