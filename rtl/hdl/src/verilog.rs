//! Plain Verilog-2005 of a module.
//!
//! Named values are wires, registers one `always` block in which those with the same enable stand together. A value
//! without a name is written where it is read, unless it is read twice or Verilog needs a name there: then it is
//! called after its reader.

mod names;
mod reads;
mod rows;

use crate::tree::{Binary, Direction, Module, Net, Op, PortRecord, Register};
use crate::value::mask;
use names::{Name, Names};
use std::fmt::Write;

/// The text of one module, without those it instantiates; `prefix` stands before the names of modules.
pub fn write(module: &Module, prefix: &str) -> String {
    let names = Names::of(module);
    let writer = Writer {
        module,
        prefix,
        names,
    };
    let parts = [
        writer.ports(),
        writer.declarations(),
        writer.instances(),
        writer.assignments(),
        writer.clocked(),
    ];
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join("\n") + "\nendmodule\n"
}

struct Writer<'a> {
    module: &'a Module,
    prefix: &'a str,
    names: Names,
}

impl Writer<'_> {
    fn ports(&self) -> String {
        let mut lines = vec![];
        if self.module.is_clocked() {
            lines.push("    input  wire clock".to_owned());
        }
        for port in &self.module.ports {
            let PortRecord {
                name,
                width,
                signed,
                ..
            } = port;
            let node = self.module.node(port.net);
            let initial = match &node.op {
                Op::Register(register) => Some(self.module.registers[*register].initial),
                Op::Read(_) => Some(0),
                _ => None,
            };
            let initial = initial.filter(|_| self.names.ports.contains(name));
            let (way, initial) = match (port.direction, initial) {
                (Direction::In, _) => ("input  wire", String::new()),
                (_, Some(initial)) => {
                    let initial = literal(initial, *width, *signed);
                    ("output reg ", format!(" = {initial}"))
                }
                _ => ("output wire", String::new()),
            };
            lines.push(format!(
                "    {way} {}{name}{initial}",
                range(*width, *signed)
            ));
        }
        let ports = lines.join(",\n");
        format!(
            "module {}{} (\n{ports}\n);\n",
            self.prefix, self.module.name
        )
    }

    fn declarations(&self) -> String {
        let mut text = String::new();
        for (index, node) in self.module.nodes.iter().enumerate() {
            let net = Net(index as u32);
            let is_port = self.module.ports.iter().any(|port| {
                let is_own =
                    port.direction == Direction::In || self.names.ports.contains(&port.name);
                port.net == net && is_own
            });
            let Some(Name {
                text: name,
                offset: None,
            }) = self.names.get(net).filter(|_| !is_port)
            else {
                continue;
            };
            let range = range(node.width, node.signed);
            match node.op {
                Op::Register(register) => {
                    let initial = self.module.registers[register].initial;
                    let initial = literal(initial, node.width, node.signed);
                    writeln!(text, "    reg {range}{name} = {initial};").unwrap();
                }
                Op::Read(_) => {
                    let zero = literal(0, node.width, node.signed);
                    writeln!(text, "    reg {range}{name} = {zero};").unwrap();
                }
                _ => writeln!(text, "    wire {range}{name};").unwrap(),
            }
        }
        if !self.names.rows.is_empty() {
            text += "    genvar k;\n";
        }
        for row in &self.names.rows {
            for (name, width) in row.vectors(self.module) {
                writeln!(text, "    wire {}{name};", range(width, false)).unwrap();
            }
        }
        for (memory, name) in self.module.memories.iter().zip(&self.names.memories) {
            let (range, last) = (range(memory.width, false), memory.words - 1);
            writeln!(text, "    reg {range}{name} [0:{last}];").unwrap();
        }
        text + &self.zeros()
    }

    /// Block RAM begins with zeros; synthesis need not work through a loop for it.
    fn zeros(&self) -> String {
        let loops = self.module.memories.iter().zip(&self.names.memories);
        let loops = loops.map(|(memory, name)| {
            let (last, zero) = (memory.words - 1, literal(0, memory.width, false));
            format!("        for (place = 0; place <= {last}; place = place + 1) {name}[place] = {zero};\n")
        });
        let loops: String = loops.collect();
        match loops.as_str() {
            "" => loops,
            _ => format!(
                "`ifndef SYNTHESIS\n    integer place;\n    initial begin\n{loops}    end\n`endif\n"
            ),
        }
    }

    fn instances(&self) -> String {
        let mut texts = vec![];
        for (index, instance) in self.module.instances.iter().enumerate() {
            let mut rows = self.names.rows.iter();
            if let Some(row) = rows.find(|row| row.instances.contains(&index)) {
                if row.instances.start == index {
                    texts.push(
                        row.written(self.module, self.prefix, &self.names.rows, &|net| {
                            self.value(net, false)
                        }),
                    );
                }
                continue;
            }
            let module = &instance.module;
            let mut lines = vec![];
            if module.is_clocked() {
                lines.push("        .clock(clock)".to_owned());
            }
            let nets = instance.inputs.iter().chain(&instance.outputs);
            let ports = [Direction::In, Direction::Out];
            let ports = ports.into_iter().flat_map(|way| module.ports_of(way));
            for (port, net) in ports.zip(nets) {
                let value = self.value(*net, false);
                lines.push(format!("        .{}({value})", port.name));
            }
            let lines = lines.join(",\n");
            texts.push(format!(
                "    {}{} {} (\n{lines}\n    );\n",
                self.prefix, module.name, instance.name
            ));
        }
        texts.join("\n")
    }

    fn assignments(&self) -> String {
        let mut text = String::new();
        for (index, node) in self.module.nodes.iter().enumerate() {
            let net = Net(index as u32);
            let is_driven_elsewhere = matches!(
                node.op,
                Op::Input | Op::Register(_) | Op::Read(_) | Op::Output(..)
            );
            if let (Some(name), false) = (self.names.get(net), is_driven_elsewhere) {
                let name = &name.text;
                writeln!(text, "    assign {name} = {};", self.expression(net, false)).unwrap();
            }
        }
        let copies = self.module.ports_of(Direction::Out);
        for port in copies.filter(|port| !self.names.ports.contains(&port.name)) {
            writeln!(
                text,
                "    assign {} = {};",
                port.name,
                self.value(port.net, false)
            )
            .unwrap();
        }
        if !self.names.unread.is_empty() {
            let parts = self.names.unread.iter().map(|(net, high, low)| {
                let name = self.names.get(*net).expect("it is declared");
                name.part(*high, *low, self.module.node(*net).width)
            });
            let parts: Vec<String> = parts.collect();
            writeln!(text, "    wire unused = &{{1'b0, {}}};", parts.join(", ")).unwrap();
        }
        text
    }

    fn clocked(&self) -> String {
        let read = |register: &&Register| self.names.get(register.net).is_some();
        let registers: Vec<&Register> = self.module.registers.iter().filter(read).collect();
        if registers.is_empty() && self.module.memories.is_empty() {
            return String::new();
        }
        let mut text = "    always @(posedge clock) begin\n".to_owned();
        let paths: Vec<(Vec<Net>, &Register)> = registers
            .iter()
            .map(|register| {
                let mut path = vec![];
                if let Some(enable) = register.enable {
                    self.conditions(enable, &mut path);
                }
                (path, *register)
            })
            .collect();
        self.enabled(&paths, 0, &mut text);
        for (memory, name) in self.module.memories.iter().zip(&self.names.memories) {
            let [enable, at, data] = memory.write.map(|net| self.value(net, true));
            writeln!(text, "        if ({enable}) {name}[{at}] <= {data};").unwrap();
            if let Some(Name { text: read, .. }) = self.names.get(memory.net) {
                let address = self.value(memory.address, true);
                writeln!(text, "        {read} <= {name}[{address}];").unwrap();
            }
        }
        text + "    end\n"
    }

    /// An enable as conditions one within the other.
    fn conditions(&self, enable: Net, path: &mut Vec<Net>) {
        match (self.names.get(enable), &self.module.node(enable).op) {
            (None, Op::Binary(Binary::And, a, b)) => {
                self.conditions(*a, path);
                self.conditions(*b, path);
            }
            _ => path.push(enable),
        }
    }

    /// The registers behind so many conditions that they have in common: those without another first, each other
    /// condition once.
    fn enabled(&self, registers: &[(Vec<Net>, &Register)], depth: usize, text: &mut String) {
        let indent = " ".repeat(8 + 4 * depth);
        let mut conditions: Vec<Net> = vec![];
        for (path, register) in registers {
            match path.get(depth) {
                None => {
                    let next = register.next.expect("a closed module has all inputs");
                    let name = &self.names.get(register.net).expect("it is read").text;
                    writeln!(text, "{indent}{name} <= {};", self.value(next, false)).unwrap();
                }
                Some(condition) if !conditions.contains(condition) => conditions.push(*condition),
                Some(_) => {}
            }
        }
        for condition in conditions {
            let inner = registers
                .iter()
                .filter(|(path, _)| path.get(depth) == Some(&condition));
            let inner: Vec<(Vec<Net>, &Register)> = inner.cloned().collect();
            writeln!(text, "{indent}if ({}) begin", self.value(condition, false)).unwrap();
            self.enabled(&inner, depth + 1, text);
            writeln!(text, "{indent}end").unwrap();
        }
    }

    /// What stands where a net is read; in parentheses if it is part of an expression and has an operator.
    fn value(&self, net: Net, inner: bool) -> String {
        match self.names.get(net) {
            Some(name) => name.all(self.module.node(net).width),
            None => self.expression(net, inner),
        }
    }

    /// What drives a net.
    fn expression(&self, net: Net, inner: bool) -> String {
        let node = self.module.node(net);
        let value = |net: &Net| self.value(*net, true);
        let closed = |text: String| if inner { format!("({text})") } else { text };
        match &node.op {
            Op::Literal(bits) => literal(*bits, node.width, node.signed),
            Op::Not(a) => match (self.names.get(*a), &self.module.node(*a).op) {
                (None, Op::Binary(Binary::Equal, a, b)) => {
                    closed(format!("{} != {}", value(a), value(b)))
                }
                (None, Op::Binary(Binary::Less, a, b)) => {
                    closed(format!("{} >= {}", value(a), value(b)))
                }
                _ => format!("~{}", value(a)),
            },
            Op::Binary(binary, a, b) => {
                let sign = match binary {
                    Binary::Add => "+",
                    Binary::Sub => "-",
                    Binary::Mul => "*",
                    Binary::And => "&",
                    Binary::Or => "|",
                    Binary::Xor => "^",
                    Binary::Left => "<<",
                    Binary::Right if node.signed => ">>>",
                    Binary::Right => ">>",
                    Binary::Equal => "==",
                    Binary::Less => "<",
                };
                closed(format!("{} {sign} {}", value(a), value(b)))
            }
            Op::Select(which, a, b) => {
                // Choices behind choices read from the first to the last.
                let last = self.value(*b, !matches!(self.module.node(*b).op, Op::Select(..)));
                closed(format!("{} ? {} : {last}", value(which), value(a)))
            }
            Op::Slice(a, low) => {
                let name = self.names.get(*a).expect("what is sliced has a name");
                name.part(low + node.width - 1, *low, self.module.node(*a).width)
            }
            Op::Join(parts) => {
                let parts: Vec<String> = parts.iter().map(|net| self.value(*net, false)).collect();
                format!("{{{}}}", parts.join(", "))
            }
            Op::Extend(a) => {
                let own = self.module.node(*a);
                let more = node.width - own.width;
                match own.signed {
                    true => {
                        let name = self.names.get(*a).expect("what is extended has a name");
                        let sign = name.part(own.width - 1, own.width - 1, own.width);
                        format!("{{{{{more}{{{sign}}}}}, {}}}", name.all(own.width))
                    }
                    false => format!("{{{more}'d0, {}}}", self.value(*a, false)),
                }
            }
            Op::Same(a) | Op::Forward(Some(a)) => self.value(*a, inner),
            op => unreachable!("{op:?} is declared"),
        }
    }
}

fn range(width: u32, signed: bool) -> String {
    let sign = if signed { "signed " } else { "" };
    match width {
        1 if !signed => String::new(),
        _ => format!("{sign}[{}:0] ", width - 1),
    }
}

fn literal(bits: u64, width: u32, signed: bool) -> String {
    let sign = 1 << (width - 1);
    match signed {
        true if bits == sign => format!("{width}'sh{bits:x}"),
        true if bits & sign != 0 => format!("-{width}'sd{}", (!bits & mask(width)) + 1),
        true => format!("{width}'sd{bits}"),
        false if bits > 0xffff => format!("{width}'h{bits:x}"),
        false => format!("{width}'d{bits}"),
    }
}
