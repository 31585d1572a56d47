//! The module of a block memory: the form that synthesis tools map to block memory.

use super::collect::{Net, Scope};
use super::lower::Type;
use super::module::{is_port, port, shape};
use std::fmt::Write;

/// Bits of the address.
pub fn address_width(scope: &Scope) -> usize {
    scope.net("read_address").map_or(0, |net| net.width)
}

/// The body of the module, from the port list on.
pub fn body(scope: &Scope) -> String {
    let ports = scope.nets.iter().filter(|net| is_port(net));
    let lines: Vec<_> = ports
        .map(|net: &Net| format!("    {}", port(net)))
        .collect();
    let width = scope.net("read_data").map_or(0, |net| net.width);
    let last = (1u64 << address_width(scope)) - 1;
    let of = Type {
        width,
        signed: false,
    };
    let mut text = format!(" (\n{}\n);\n", lines.join(",\n"));
    let word = shape(of);
    let _ = write!(
        text,
        "
    reg {word}words [0:{last}];
    reg {word}kept_read_data = {width}'d0;
    integer place;
    initial begin
        for (place = 0; place <= {last}; place = place + 1) words[place] = {width}'d0;
    end

    assign read_data = kept_read_data;

    always @(posedge clock) begin
        kept_read_data <= words[read_address];
        if (write) words[write_address] <= write_data;
    end
"
    );
    text
}
