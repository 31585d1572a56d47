//! What is emitted of a circuit of functions.

use super::Port;
use imogene_hdl::{Design, Direction, verilog};

/// Names and texts of the modules, leaves first.
pub(super) fn modules(design: &Design, prefix: &str) -> Vec<(String, String)> {
    let modules = design.top.all();
    let text = modules.iter().map(|module| {
        let name = format!("{prefix}{}", module.name);
        (name, verilog::write(module, prefix))
    });
    text.collect()
}

/// The ports of the top module, the clock before all others.
pub(super) fn ports(design: &Design) -> Vec<Port> {
    let clock = Port {
        name: "clock".to_owned(),
        meaning: "rising edge".to_owned(),
        direction: Direction::In,
        width: 1,
        signed: false,
    };
    let others = design.top.ports.iter().map(|port| Port {
        name: port.name.clone(),
        meaning: port.meaning.clone(),
        direction: port.direction,
        width: port.width as usize,
        signed: port.signed,
    });
    let clock = design.top.is_clocked().then_some(clock);
    clock.into_iter().chain(others).collect()
}
