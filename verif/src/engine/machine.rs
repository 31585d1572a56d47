//! A machine in any engine.

use super::Engine;
use super::circuit::Compiled;
use super::design::{Design, DesignError, Instance, Source};
use super::nets::{NetError, select};
use crate::signal::Signal;
use imogene_hdl::{self as hdl, Direction};
use imogene_rtl::emit::machine::{MachineRequest, emit_machine};

/// A compiled machine; makes any number of instances.
pub struct MachineDesign {
    design: Box<dyn Design>,
    /// Name of its top module.
    pub name: String,
    /// Input ports without the clock.
    pub inputs: Vec<Signal>,
    /// Output ports.
    pub outputs: Vec<Signal>,
    /// Nets inside that were wanted, by their paths: the last of the points.
    pub nets: Vec<Signal>,
}

impl MachineDesign {
    /// Compiles a machine, with the points inside that will be asked for; the built-in engine alone shows them. `nets`
    /// are paths of more of them, as [`select`] takes them.
    pub fn compile(
        engine: Engine,
        request: &MachineRequest,
        points: &[String],
        nets: &[String],
    ) -> Result<MachineDesign, DesignError> {
        let circuit = request.design()?;
        let [inputs, outputs] = ports(&circuit);
        let nets = select(&circuit.top, nets)?;
        let design = match engine {
            Engine::BuiltIn => {
                let nets = nets.iter().map(|net| &net.name);
                let points: Vec<String> = points.iter().chain(nets).cloned().collect();
                Box::new(Compiled::of(&circuit, &points))
            }
            Engine::Verilog(_) if !nets.is_empty() => return Err(NetError::Engine.into()),
            Engine::Verilog(simulator) => {
                let emitted = emit_machine(request)?;
                simulator.compile(&Source {
                    top: &emitted.top,
                    text: &emitted.bundle(),
                    inputs: &inputs,
                    outputs: &outputs,
                })?
            }
        };
        Ok(MachineDesign {
            design,
            name: circuit.top.name.clone(),
            inputs,
            outputs,
            nets,
        })
    }

    /// A circuit in something that runs it.
    pub fn of(circuit: &hdl::Design, design: Box<dyn Design>) -> MachineDesign {
        let [inputs, outputs] = ports(circuit);
        MachineDesign {
            design,
            name: circuit.top.name.clone(),
            inputs,
            outputs,
            nets: vec![],
        }
    }

    /// A fresh instance: registers have their initial values.
    pub fn instance(&self) -> Box<dyn Instance> {
        self.design.instance()
    }
}

/// Inputs and outputs of a circuit.
fn ports(circuit: &hdl::Design) -> [Vec<Signal>; 2] {
    [Direction::In, Direction::Out].map(|way| circuit.top.ports_of(way).map(Signal::of).collect())
}
