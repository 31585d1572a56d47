//! A machine in any engine, seen through its ports.

use crate::engine::design::Instance;
use crate::engine::machine::MachineDesign;
use crate::engine::nets::values;
use crate::signal::Signal;
use imogene_golden::machine::zone::beat::Beat;

/// One running machine. Inputs keep their values until set again.
pub struct Machine {
    running: Box<dyn Instance>,
    /// What it is made of.
    pub design: MachineDesign,
    given: Vec<u64>,
    found: Vec<Option<u64>>,
    /// Clocks given.
    pub clocks: u64,
}

impl Machine {
    /// An instance of a design.
    pub fn of(design: MachineDesign) -> Machine {
        let (inputs, outputs) = (&design.inputs, &design.outputs);
        Machine {
            running: design.instance(),
            given: vec![0; inputs.len()],
            found: vec![Some(0); outputs.len()],
            design,
            clocks: 0,
        }
    }

    /// Sets an input. Panics when there is no such port.
    pub fn set(&mut self, port: &str, value: i64) {
        let place = place(&self.design.inputs, port);
        self.given[place] = self.design.inputs[place].bits(value);
    }

    /// Puts a beat on its command stream, or none.
    pub fn offer(&mut self, beat: Option<&Beat>) {
        self.set("s_tvalid", i64::from(beat.is_some()));
        if let Some(beat) = beat {
            self.set("s_tdest", beat.kind.into());
            let user = i64::from(beat.unit) << 16 | i64::from(beat.address);
            self.set("s_tuser", user);
            self.set("s_tdata", beat.data as i64);
        }
    }

    /// Place of an output, for [`Machine::at`]. Panics when there is no such port.
    pub fn output(&self, port: &str) -> usize {
        place(&self.design.outputs, port)
    }

    /// The output at a place after the last clock; `None` where the engine shows an undefined bit.
    pub fn at(&self, place: usize) -> Option<i64> {
        self.found[place].map(|bits| self.design.outputs[place].value(bits))
    }

    /// An output by its name. Panics when there is no such port.
    pub fn get(&self, port: &str) -> Option<i64> {
        self.at(self.output(port))
    }

    /// True if an output of one bit is 1.
    pub fn is_set(&self, port: &str) -> bool {
        self.get(port) == Some(1)
    }

    /// The inputs that are set for the next clock, in the order of the ports.
    pub fn inputs(&self) -> Vec<i64> {
        let given = self.design.inputs.iter().zip(&self.given);
        given.map(|(port, bits)| port.value(*bits)).collect()
    }

    /// The nets inside that were asked for, before the next clock.
    pub fn nets(&mut self) -> Vec<Option<i64>> {
        match self.design.nets.as_slice() {
            [] => vec![],
            nets => values(nets, self.running.points(&self.given)),
        }
    }

    /// One clock.
    pub fn clock(&mut self) {
        self.running.clock(&self.given, &mut self.found);
        self.clocks += 1;
    }
}

/// There are a few ports, so that no table is faster.
fn place(ports: &[Signal], port: &str) -> usize {
    let place = ports.iter().position(|signal| signal.name == port);
    place.unwrap_or_else(|| panic!("no port `{port}`"))
}
