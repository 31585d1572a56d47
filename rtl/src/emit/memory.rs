//! The module of a block memory: the form that synthesis tools map to block memory.

use super::collect::{Net, Scope};
use super::lower::Type;
use super::module::{is_port, port, shape};
use std::fmt::Write;

/// The body of the module, from the port list on.
pub fn body(scope: &Scope, bits: usize) -> String {
    let ports = scope.nets.iter().filter(|net| is_port(net));
    let lines: Vec<_> = ports
        .map(|net: &Net| format!("    {}", port(net)))
        .collect();
    let width = scope.net("read_data").map_or(0, |net| net.width);
    let last = (1u64 << bits) - 1;
    let ports = scope.net("read_address").map_or(bits, |net| net.width);
    let low = |address: &str| match ports == bits {
        true => address.to_owned(),
        false => format!("{address}[{}:0]", bits - 1),
    };
    let (read, written) = (low("read_address"), low("write_address"));
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
    // Block RAM begins with zeros; synthesis need not work through a loop for it.
`ifndef SYNTHESIS
    integer place;
    initial begin
        for (place = 0; place <= {last}; place = place + 1) words[place] = {width}'d0;
    end
`endif

    assign read_data = kept_read_data;

    always @(posedge clock) begin
        kept_read_data <= words[{read}];
        if (write) words[{written}] <= write_data;
    end
"
    );
    if ports > bits {
        let high = format!("{}:{bits}", ports - 1);
        let _ = writeln!(
            text,
            "\n    wire unused_bits = &{{1'b0, write_address[{high}], read_address[{high}]}};"
        );
    }
    text
}
