//! Any unit or machine in simulation, behind one interface: plain words in the order of its ports.

use crate::emit::display::DisplayRequest;
use crate::emit::{EmitError, EmitRequest, design};
use imogene_hdl::{Design, Direction, Port, Simulator};

/// A unit or a machine, driven by words in the order of its ports. Outputs are those visible after the clock edge.
pub trait UnitSimulator: Send {
    /// Gives one clock. `inputs` holds a word for each input port but the clock, of which the low bits count; the answer
    /// holds a word for each output port.
    fn clock(&mut self, inputs: &[u64]) -> Vec<u64>;
}

/// A circuit in its own simulator.
struct Circuit {
    simulator: Simulator,
    inputs: Vec<Port>,
    outputs: Vec<Port>,
}

impl Circuit {
    fn new(design: &Design) -> Circuit {
        let simulator = Simulator::new(design);
        let ports = |way: Direction| {
            let ports = design.top.ports_of(way);
            ports.map(|port| simulator.port(&port.name)).collect()
        };
        Circuit {
            inputs: ports(Direction::In),
            outputs: ports(Direction::Out),
            simulator,
        }
    }
}

impl UnitSimulator for Circuit {
    fn clock(&mut self, inputs: &[u64]) -> Vec<u64> {
        for (port, word) in self.inputs.iter().zip(inputs) {
            self.simulator.set(*port, *word);
        }
        self.simulator.clock();
        let outputs = self.outputs.iter();
        outputs.map(|port| self.simulator.get(*port)).collect()
    }
}

/// The unit that [`emit`](crate::emit::emit) gives for the same request; the order of the words is that of
/// [`Emitted::ports`](crate::emit::Emitted::ports).
///
/// # Errors
///
/// When a parameter is out of its legal range.
pub fn unit_simulator(request: &EmitRequest) -> Result<Box<dyn UnitSimulator>, EmitError> {
    Ok(Box::new(Circuit::new(&design(request)?)))
}

/// The machine that [`emit_display`](crate::emit::display::emit_display) gives for the same request.
///
/// # Errors
///
/// When a number is out of its legal range.
pub fn display_simulator(request: &DisplayRequest) -> Result<Box<dyn UnitSimulator>, EmitError> {
    Ok(Box::new(Circuit::new(&request.design()?)))
}
