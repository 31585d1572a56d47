//! A mutant of a netlist.

use crate::signal::Signal;
use std::fmt;

/// A unit's emitted Verilog.
#[derive(Clone, Copy, Debug)]
pub struct Design<'a> {
    /// Name of the module.
    pub top: &'a str,
    /// Text.
    pub text: &'a str,
    /// Clocks from an input to its result.
    pub latency: usize,
}

/// The input that selects a mutant; 0 selects none.
pub(super) fn selector(mutants: usize) -> Signal {
    Signal::unsigned("mutant_select", (mutants as u64).ilog2() + 1)
}

/// One small change of a netlist.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mutant {
    /// Number, from 1.
    pub number: usize,
    /// `inv` inverts a bit, `const0` and `const1` hold it, `cnot0` and `cnot1` invert it when another bit of the same
    /// port is 0 or 1.
    pub mode: String,
    /// Cell of the netlist.
    pub cell: String,
    /// Port of the cell.
    pub port: String,
    /// Bit of the port.
    pub bit: u32,
    /// The other bit of `cnot0` and `cnot1`.
    pub control_bit: Option<u32>,
    /// Signal on the bit, if it has a name.
    pub signal: Option<String>,
    /// Line of the Verilog that the cell comes from, if it is known.
    pub line: Option<usize>,
    /// That line's text.
    pub source: String,
    /// Options of Yosys that make it, without module and control.
    pub(super) command: String,
}

impl fmt::Display for Mutant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}[{}]", self.mode, self.port, self.bit)?;
        if let Some(bit) = self.control_bit {
            write!(f, " by [{bit}]")?;
        }
        if let Some(signal) = &self.signal {
            write!(f, " ({signal})")?;
        }
        write!(f, " at {}", self.cell)?;
        match self.line {
            Some(line) => write!(f, ", line {line}: {}", self.source),
            None => Ok(()),
        }
    }
}
