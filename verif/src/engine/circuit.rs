//! A circuit of `imogene-hdl` in its own simulator, in process.

use crate::signal::Signal;
use crate::subject::Hardware;
use imogene_hdl::{Design, Port, Simulator};

/// A circuit with ports in an order.
pub struct Circuit {
    simulator: Simulator,
    inputs: Vec<Port>,
    outputs: Vec<(Port, Signal)>,
}

impl Circuit {
    /// A fresh instance of a design.
    ///
    /// # Panics
    ///
    /// If the design has no port of one of the names.
    pub fn new(design: &Design, inputs: &[Signal], outputs: &[Signal]) -> Circuit {
        let simulator = Simulator::new(design);
        Circuit {
            inputs: inputs
                .iter()
                .map(|signal| simulator.port(&signal.name))
                .collect(),
            outputs: outputs
                .iter()
                .map(|signal| (simulator.port(&signal.name), signal.clone()))
                .collect(),
            simulator,
        }
    }
}

impl Hardware for Circuit {
    fn clock(&mut self, inputs: &[i64]) -> Vec<Option<i64>> {
        for (port, value) in self.inputs.iter().zip(inputs) {
            self.simulator.set(*port, *value as u64);
        }
        self.simulator.clock();
        let read = |(port, signal): &(Port, Signal)| Some(signal.value(self.simulator.get(*port)));
        self.outputs.iter().map(read).collect()
    }
}
