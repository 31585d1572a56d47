//! A register harness around a unit, so that timing is about registers and needs four pins.
//!
//! Every input of the unit comes from a register and every output goes to one, as in a pipeline; the registers are shifted in and
//! out serially. The input registers shift only while `shift` is high: registers without that enable would be equal to the first
//! delay registers of the unit, and synthesis would merge the two.

use imogene_rtl::emit::{Direction, Emitted, Port};
use std::fmt::Write;

/// Name of the harness module.
pub const TOP: &str = "register_harness";

/// Name of the clock port of the units.
const CLOCK: &str = "clock";

/// Verilog of the harness of a unit; the unit itself is not in the text.
pub fn verilog(unit: &Emitted) -> String {
    let inputs = bits(unit, Direction::Input);
    let outputs = bits(unit, Direction::Output);
    let mut text = format!(
        "module {TOP} (
    input  wire clock,
    input  wire shift,
    input  wire scan_in,
    output wire scan_out
);

    reg  [{i}:0] inputs = {inputs}'d0;
    reg  [{o}:0] outputs = {outputs}'d0;
    wire [{o}:0] results;

    assign scan_out = outputs[{o}];

    always @(posedge clock) begin
        if (shift) begin
            inputs <= (inputs << 1) | {{{{{inputs}{{1'b0}}}}, scan_in}};
            outputs <= (outputs << 1) | {{{{{outputs}{{1'b0}}}}, inputs[{i}]}};
        end else begin
            outputs <= results;
        end
    end

    {unit_name} unit (\n",
        i = inputs - 1,
        o = outputs - 1,
        unit_name = unit.top,
    );
    text += &connections(unit);
    text += "    );\n\nendmodule\n";
    text
}

/// Bits of all ports of a direction, without the clock.
fn bits(unit: &Emitted, direction: Direction) -> usize {
    let ports = data_ports(unit).filter(|port| port.direction == direction);
    ports.map(|port| port.width).sum()
}

fn data_ports(unit: &Emitted) -> impl Iterator<Item = &Port> {
    unit.ports.iter().filter(|port| port.name != CLOCK)
}

fn connections(unit: &Emitted) -> String {
    let mut used = [0, 0];
    let mut text = String::new();
    if unit.ports.iter().any(|port| port.name == CLOCK) {
        let _ = write!(text, "        .{CLOCK}({CLOCK})");
    }
    for port in data_ports(unit) {
        let (vector, used) = match port.direction {
            Direction::Input => ("inputs", &mut used[0]),
            Direction::Output => ("results", &mut used[1]),
        };
        let separator = if text.is_empty() { "" } else { ",\n" };
        let _ = write!(
            text,
            "{separator}        .{}({vector}[{}:{}])",
            port.name,
            *used + port.width - 1,
            *used
        );
        *used += port.width;
    }
    text + "\n"
}
