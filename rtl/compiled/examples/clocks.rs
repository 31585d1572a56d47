//! Clocks a second of a unit, compiled and in the simulator: `cargo run --release -p imogene-compiled --example clocks`.

use imogene_compiled::Compiled;
use imogene_contract::{Request, Unit};
use imogene_hdl::{Direction, Simulator};
use imogene_rtl::emit::design;
use std::time::Instant;

fn main() {
    for unit in [Unit::QuadricPe, Unit::QuadricProcessor, Unit::Beam] {
        let design = design(&Request::new(unit)).expect("a unit of the base format");
        let begin = Instant::now();
        let mut compiled = Compiled::new(&design);
        let build = begin.elapsed();
        let mut simulator = Simulator::new(&design);
        for port in design.top.ports_of(Direction::In) {
            let word = 0x1234_5678_9abc_def1u64.rotate_left(port.name.len() as u32);
            compiled.set(compiled.port(&port.name), word);
            simulator.set(simulator.port(&port.name), word);
        }
        let (many, few) = (300_000, 10_000);
        let begin = Instant::now();
        (0..many).for_each(|_| compiled.clock());
        let fast = f64::from(many) / begin.elapsed().as_secs_f64() / 1e6;
        let begin = Instant::now();
        (0..few).for_each(|_| simulator.clock());
        let slow = f64::from(few) / begin.elapsed().as_secs_f64() / 1e6;
        println!(
            "{}: built in {build:?}, {fast:.3} M clocks/s compiled, {slow:.4} levelised",
            unit.name()
        );
    }
}
