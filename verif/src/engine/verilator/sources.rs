//! What Verilator and the C++ compiler are given: the design in a wrapper, and the C interface.

use crate::engine::design::Source;
use crate::signal::Signal;
use std::fmt::Write;

pub(super) const WRAPPER: &str = "imogene_wrapper";
/// Class that Verilator makes of it.
pub(super) const CLASS: &str = "Vimogene";

/// Symbols of the C interface, as the loader wants them.
pub(super) const CREATE: &[u8] = b"imogene_create\0";
pub(super) const DESTROY: &[u8] = b"imogene_destroy\0";
pub(super) const CLOCK: &[u8] = b"imogene_clock\0";

/// Verilog of the design and of its wrapper, and the C++ of the interface.
pub(super) fn sources(source: &Source) -> [String; 2] {
    let (inputs, outputs) = (source.inputs, source.outputs);
    let wrapper = wrapper(source.top, inputs, outputs);
    [
        format!("{}\n{wrapper}", source.text),
        shim(inputs.len(), outputs.len()),
    ]
}

/// A module whose ports have numbers: a port of the design may be named like a word of C++.
fn wrapper(top: &str, inputs: &[Signal], outputs: &[Signal]) -> String {
    let mut ports = String::from("    input wire clock");
    let mut connections = String::from("        .clock(clock)");
    let sides = [("input", "in", inputs), ("output", "out", outputs)];
    for (direction, prefix, signals) in sides {
        for (index, signal) in signals.iter().enumerate() {
            let high = signal.width - 1;
            let _ = write!(ports, ",\n    {direction} wire [{high}:0] {prefix}{index}");
            let _ = write!(connections, ",\n        .{}({prefix}{index})", signal.name);
        }
    }
    format!("module {WRAPPER} (\n{ports}\n);\n    {top} unit (\n{connections}\n    );\nendmodule\n")
}

/// The C interface. One call is one clock: the inputs change after the falling edge, so that a register on the wrong
/// edge is seen, and settle before the rising edge, which Verilator sees to; the outputs are those after it.
fn shim(inputs: usize, outputs: usize) -> String {
    let mut set = String::new();
    for index in 0..inputs {
        let _ = writeln!(set, "    m.in{index} = inputs[{index}];");
    }
    let mut get = String::new();
    for index in 0..outputs {
        let _ = writeln!(get, "    outputs[{index}] = m.out{index};");
    }
    format!(
        "#include \"{CLASS}.h\"
#include \"verilated.h\"
#include <cstdint>

double sc_time_stamp() {{ return 0; }}

struct State {{
    VerilatedContext context;
    {CLASS} model;
    State() : context(), model(&context) {{}}
}};

#define EXPORT extern \"C\" __attribute__((visibility(\"default\")))

EXPORT void* imogene_create() {{ return new State(); }}

EXPORT void imogene_destroy(void* state) {{ delete static_cast<State*>(state); }}

EXPORT void imogene_clock(void* state, const uint64_t* inputs, uint64_t* outputs) {{
    {CLASS}& m = static_cast<State*>(state)->model;
    (void)inputs;
    m.clock = 0;
    m.eval();
{set}    m.clock = 1;
    m.eval();
{get}}}
"
    )
}
