//! A register harness around a unit, so that timing is about registers and needs four pins.
//!
//! Every input of the unit comes from a register and every output goes to one, as in a pipeline; the registers are
//! shifted in and out serially. The input registers shift only while `shift` is high: registers without that enable
//! would be equal to the first delay registers of the unit, and synthesis would merge the two.

use imogene_rtl::emit::{Direction, Emitted, Port};

/// Name of the harness module.
pub const TOP: &str = "register_harness";

/// Name of the clock port of the units and of the harness.
const CLOCK: &str = "clock";

/// Verilog of the harness of a unit; the unit itself is not in the text.
pub fn verilog(unit: &Emitted) -> String {
    let has_clock = unit.ports.iter().any(|port| port.name == CLOCK);
    around(&unit.top, &unit.ports, has_clock.then_some(CLOCK))
}

/// Verilog of the harness of any module, whose clock port may have any name; at least one bit goes in and one comes
/// out.
pub fn around(top: &str, ports: &[Port], clock: Option<&str>) -> String {
    let is_data = |port: &&Port| Some(port.name.as_str()) != clock;
    let data: Vec<&Port> = ports.iter().filter(is_data).collect();
    let inputs = bits(&data, Direction::In);
    let outputs = bits(&data, Direction::Out);
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
        unit_name = identifier(top),
    );
    text += &connections(&data, clock);
    text += "    );\n\nendmodule\n";
    text
}

/// Bits of all ports of a direction.
pub(crate) fn bits(ports: &[&Port], direction: Direction) -> usize {
    let ports = ports.iter().filter(|port| port.direction == direction);
    ports.map(|port| port.width).sum()
}

fn connections(ports: &[&Port], clock: Option<&str>) -> String {
    let mut used = [0, 0];
    let clock = clock.map(|clock| format!("        .{}({CLOCK})", identifier(clock)));
    let mut lines = Vec::from_iter(clock);
    for port in ports {
        let (vector, used) = match port.direction {
            Direction::In => ("inputs", &mut used[0]),
            Direction::Out => ("results", &mut used[1]),
        };
        let (name, first) = (identifier(&port.name), *used);
        *used += port.width;
        lines.push(format!("        .{name}({vector}[{}:{first}])", *used - 1));
    }
    lines.join(",\n") + "\n"
}

/// A name as Verilog takes it: escaped unless it is plain.
fn identifier(name: &str) -> String {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
    let is_start = |c: char| c.is_ascii_alphabetic() || c == '_';
    if name.starts_with(is_start) && name.chars().all(is_word) {
        name.to_owned()
    } else {
        format!("\\{name} ")
    }
}
