//! The simulator: all modules in one list of operations, in an order in which nothing is read before it is known.

mod code;
mod flat;

use crate::build::Design;
use crate::tree::{Direction, PortRecord};
use crate::value::mask;
use code::{Code, Kind, in_runs};
use flat::Flat;
use std::collections::HashMap;
use std::ops::Range;

/// A port of the design's top module, or a point inside, by its place in a simulator.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Port {
    place: u32,
    width: u32,
}

#[derive(Clone, Copy, Debug)]
struct Flop {
    output: u32,
    next: u32,
    /// A word that is 1 where there is none.
    enable: u32,
}

#[derive(Clone, Debug)]
struct Store {
    words: Vec<u64>,
    write: [u32; 3],
    address: u32,
    output: u32,
    /// What it gives from the next clock on.
    read: u64,
}

/// A design that runs, clock by clock.
pub struct Simulator {
    ports: Vec<PortRecord>,
    places: Vec<u32>,
    words: Vec<u64>,
    code: Vec<Code>,
    /// Operations of one kind that need nothing of each other.
    runs: Vec<(Kind, Range<usize>)>,
    flops: Vec<Flop>,
    taken: Vec<u64>,
    stores: Vec<Store>,
    is_settled: bool,
    points: HashMap<String, Port>,
}

/// The word that is always 1.
const ONE: u32 = 0;

impl Simulator {
    /// Sorts the operations of a design.
    ///
    /// # Panics
    ///
    /// With the name of a value in a loop without a register.
    pub fn new(design: &Design) -> Simulator {
        let mut flat = Flat::default();
        flat.word(1);
        let inputs: Vec<u32> = design
            .top
            .ports_of(Direction::In)
            .map(|_| flat.word(0))
            .collect();
        let outputs = flat.place(&design.top, "", &inputs);
        let mut places: Vec<u32> = inputs.into_iter().chain(outputs).collect();
        flat.without_copies(&mut places);
        let points = std::mem::take(&mut flat.points);
        let code = flat.sorted();
        let (code, mut words) = flat.without_constants(code);
        let (code, runs) = in_runs(code, words.len());
        words[ONE as usize] = 1;
        Simulator {
            ports: design.top.ports.clone(),
            places,
            taken: vec![0; flat.flops.len()],
            words,
            code,
            runs,
            flops: flat.flops,
            stores: flat.stores,
            is_settled: false,
            points: points.into_iter().collect(),
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
        let found = self.ports.iter().position(|port| port.name == name);
        match found {
            Some(index) => Port {
                place: self.places[index],
                width: self.ports[index].width,
            },
            None => panic!("no port `{name}`"),
        }
    }

    /// Ports in their order.
    pub fn ports(&self) -> &[PortRecord] {
        &self.ports
    }

    /// Gives an input its word; bits beyond its width count nothing.
    pub fn set(&mut self, port: Port, value: u64) {
        self.words[port.place as usize] = value & mask(port.width);
        self.is_settled = false;
    }

    /// The word of a port in this clock.
    pub fn get(&mut self, port: Port) -> u64 {
        self.settle();
        self.words[port.place as usize]
    }

    /// Operations and registers.
    pub fn size(&self) -> [usize; 2] {
        [self.code.len(), self.flops.len()]
    }

    fn settle(&mut self) {
        if self.is_settled {
            return;
        }
        self.is_settled = true;
        for (kind, range) in &self.runs {
            kind.run(&self.code[range.clone()], &mut self.words);
        }
    }

    /// The rising edge.
    pub fn clock(&mut self) {
        self.settle();
        for (taken, flop) in self.taken.iter_mut().zip(&self.flops) {
            let from = if self.words[flop.enable as usize] != 0 {
                flop.next
            } else {
                flop.output
            };
            *taken = self.words[from as usize];
        }
        for store in &mut self.stores {
            let [enable, at, data, read] = [
                store.write[0],
                store.write[1],
                store.write[2],
                store.address,
            ]
            .map(|place| self.words[place as usize]);
            store.read = store.words.get(read as usize).copied().unwrap_or(0);
            if enable != 0
                && let Some(word) = store.words.get_mut(at as usize)
            {
                *word = data;
            }
        }
        for store in &self.stores {
            self.words[store.output as usize] = store.read;
        }
        for (taken, flop) in self.taken.iter().zip(&self.flops) {
            self.words[flop.output as usize] = *taken;
        }
        self.is_settled = false;
    }
}
