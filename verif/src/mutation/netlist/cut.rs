//! The netlist with its registers cut: each register becomes an input, its value, and two outputs, its next value and
//! its clock.

use std::fmt::Write as _;

/// Port numbers of the cut registers begin here, beyond those of any unit.
const FIRST_PORT: usize = 10_000;

struct Register<'a> {
    cell: &'a str,
    width: &'a str,
    value: &'a str,
    next: &'a str,
    clock: &'a str,
}

/// The register that begins at a line; takes its other lines.
fn register<'a>(line: &'a str, rest: &mut impl Iterator<Item = &'a str>) -> Option<Register<'a>> {
    let cell = line.trim_start().strip_prefix("cell $dff ")?;
    let body = rest.by_ref().map(str::trim);
    let body: Vec<&str> = body.take_while(|line| *line != "end").collect();
    let after = |prefix: &str| body.iter().find_map(|line| line.strip_prefix(prefix));
    Some(Register {
        cell,
        width: after("parameter \\WIDTH ").unwrap_or("1"),
        value: after("connect \\Q ").unwrap_or_default(),
        next: after("connect \\D ").unwrap_or_default(),
        clock: after("connect \\CLK ").unwrap_or_default(),
    })
}

/// The text of a netlist without registers. Register n of the netlist has the ports `cut_q_n`, `cut_d_n` and `cut_c_n`.
/// Its cell `NAME` leaves two buffers, `NAME$q` behind its value and `NAME$d` before its next value, where mutants of
/// its ports can be made.
pub fn cut(netlist: &str) -> String {
    let mut text = String::new();
    let mut lines = netlist.lines();
    let mut count = 0;
    while let Some(line) = lines.next() {
        // An initial value belongs to no input.
        if line.trim_start().starts_with("attribute \\init ") {
            continue;
        }
        if let Some(register) = register(line, &mut lines) {
            register.write(count, &mut text);
            count += 1;
        } else {
            text += line;
            text.push('\n');
        }
    }
    text
}

impl Register<'_> {
    fn write(&self, number: usize, text: &mut String) {
        let Register {
            cell, width, clock, ..
        } = self;
        let port = FIRST_PORT + 3 * number;
        let _ = write!(
            text,
            "  wire width {width} input {port} \\cut_q_{number}\n  wire width {width} output {} \\cut_d_{number}\n  \
             wire output {} \\cut_c_{number}\n  connect \\cut_c_{number} {clock}\n",
            port + 1,
            port + 2
        );
        let buffers = [
            ("q", format!("\\cut_q_{number}"), self.value.to_owned()),
            ("d", self.next.to_owned(), format!("\\cut_d_{number}")),
        ];
        for (suffix, from, to) in buffers {
            let _ = write!(
                text,
                "  cell $pos {cell}${suffix}\n    parameter \\A_SIGNED 0\n    parameter \\A_WIDTH {width}\n    parameter \\Y_WIDTH {width}\n    \
                 connect \\A {from}\n    connect \\Y {to}\n  end\n"
            );
        }
    }
}

/// The options of a mutant, for the netlist with cut registers.
pub fn cut_command(command: &str, cell: &str, netlist: &str) -> String {
    let is_it = |line: &str| line.trim_start().strip_prefix("cell $dff ") == Some(cell);
    if !netlist.lines().any(is_it) {
        return command.to_owned();
    }
    let place = |port: &str| format!("-cell {cell} -port {port} ");
    let command = command.replace(&place("Q"), &format!("-cell {cell}$q -port Y "));
    command.replace(&place("D"), &format!("-cell {cell}$d -port A "))
}
