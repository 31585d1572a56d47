//! Named signals and their values, the common language of engines, scoreboard and traces.

use imogene_hdl::PortRecord;

/// A port or an internal point of a design.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Signal {
    /// Name, as in the Verilog.
    pub name: String,
    /// Bits, 1 to 64.
    pub width: u32,
    /// True for two's complement.
    pub signed: bool,
}

impl Signal {
    /// A signal of so many bits, in two's complement or without sign.
    pub fn new(name: impl Into<String>, width: u32, signed: bool) -> Signal {
        Signal {
            name: name.into(),
            width,
            signed,
        }
    }

    /// A port of a circuit.
    pub fn of(port: &PortRecord) -> Signal {
        Signal::new(&port.name, port.width, port.signed)
    }

    /// The bits of a value as they stand on the wires.
    pub fn bits(&self, value: i64) -> u64 {
        value as u64 & (u64::MAX >> (64 - self.width))
    }

    /// The value that bits on the wires stand for.
    pub fn value(&self, bits: u64) -> i64 {
        let unused = 64 - self.width;
        if self.signed {
            ((bits << unused) as i64) >> unused
        } else {
            ((bits << unused) >> unused) as i64
        }
    }
}

/// A delay line: what goes in comes out `clocks` pushes later.
#[derive(Clone, Debug)]
pub struct Delay<T> {
    held: std::collections::VecDeque<T>,
    clocks: usize,
}

impl<T> Delay<T> {
    /// A delay of a number of clocks, which may be 0.
    pub fn new(clocks: usize) -> Delay<T> {
        Delay {
            held: std::collections::VecDeque::with_capacity(clocks + 1),
            clocks,
        }
    }

    /// Puts a value in and takes out the one put in `clocks` pushes ago, if there was one.
    pub fn push(&mut self, value: T) -> Option<T> {
        self.held.push_back(value);
        let is_full = self.held.len() > self.clocks;
        is_full.then(|| self.held.pop_front())?
    }
}
