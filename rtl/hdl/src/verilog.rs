//! Plain Verilog-2005 of a module.
//!
//! Named values are wires, registers one `always` block in which those with the same enable stand together. A value
//! without a name is written where it is read, unless it is read twice or Verilog needs a name there: then it is
//! called after its reader.

mod expressions;
mod loops;
mod names;
mod reads;
mod rows;
mod text;

use crate::tree::{Binary, Direction, Module, Net, Op, Register};
use expressions::Writer;
use names::Names;
use std::fmt::Write;
use text::{Name, filled, literal, range};

/// The text of one module, without those it instantiates; `prefix` stands before the names of modules.
pub fn write(module: &Module, prefix: &str) -> String {
    text(module, prefix, false)
}

/// The same for a chip, where registers have no value at power-up: those that hold a state get it from a port `reset`.
pub fn write_for_chip(module: &Module, prefix: &str) -> String {
    text(module, prefix, true)
}

fn text(module: &Module, prefix: &str, has_reset: bool) -> String {
    let names = Names::of(module);
    let writer = Writer {
        module,
        prefix,
        names,
        has_reset,
    };
    let parts = [
        writer.ports(),
        writer.declarations(),
        writer.instances(),
        writer.assignments(),
        writer.clocked(),
    ];
    let parts: Vec<String> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    parts.join("\n") + "endmodule\n"
}

impl Writer<'_> {
    fn ports(&self) -> String {
        let wire = |name: &str| ("input  wire ".to_owned(), name.to_owned());
        let mut all = Vec::from_iter(self.module.is_clocked().then(|| wire("clock")));
        all.extend((self.has_reset && self.module.has_state()).then(|| wire("reset")));
        for port in &self.module.ports {
            let (kind, name) = match self.names.ports.contains(&port.name) {
                true => self.declared(port.net, &port.name),
                false => ("wire", port.name.clone()),
            };
            let range = range(port.width, port.signed);
            let way = port.direction.keyword();
            all.push((format!("{way:<6} {kind:<4} {range}"), name));
        }
        // Icarus takes one port with an initial value to a declaration.
        let groups = all.chunk_by(|one, next| one.0 == next.0 && !one.0.contains("reg"));
        let groups = groups.map(|alike| {
            let names: Vec<String> = alike.iter().map(|(_, name)| name.clone()).collect();
            filled(&format!("    {}", alike[0].0), &names, 8)
        });
        let (prefix, name) = (self.prefix, &self.module.name);
        let ports = groups.collect::<Vec<String>>().join(",\n");
        format!("module {prefix}{name} (\n{ports}\n);\n")
    }

    /// How a net is declared: what it is, and its name with the value at power-up.
    fn declared(&self, net: Net, name: &str) -> (&'static str, String) {
        let node = self.module.node(net);
        let initial = match node.op {
            Op::Register(register) => self.module.registers[register].initial,
            Op::Read(_) => 0,
            _ => return ("wire", name.to_owned()),
        };
        if self.has_reset {
            return ("reg", name.to_owned());
        }
        let initial = literal(initial, node.width, node.signed);
        ("reg", format!("{name} = {initial}"))
    }

    fn declarations(&self) -> String {
        let mut kinds: Vec<(String, Vec<String>)> = vec![];
        let mut add = |kind: String, name| match kinds.iter_mut().find(|(own, _)| *own == kind) {
            Some((_, names)) => names.push(name),
            None => kinds.push((kind, vec![name])),
        };
        for (net, node) in self.module.nets() {
            if let Some(Name {
                text,
                element: None,
            }) = self.names.get(net)
                && !self.names.ports.contains(text)
            {
                let (kind, name) = self.declared(net, text);
                add(format!("{kind} {}", range(node.width, node.signed)), name);
            }
        }
        let rows = self.names.rows.iter();
        for (name, width) in rows.flat_map(|row| row.vectors(self.module)) {
            add(format!("wire {}", range(width, false)), name);
        }
        let mut text = String::new();
        for (kind, names) in kinds {
            text += &format!("{};\n", filled(&format!("    {kind}"), &names, 8));
        }
        if !self.names.rows.is_empty() {
            text += "    genvar k;\n";
        }
        for (memory, name) in self.module.memories.iter().zip(&self.names.memories) {
            let (range, last) = (range(memory.width, false), memory.words - 1);
            // Nothing depends on what is read of a word while it is written.
            writeln!(text, "    (* no_rw_check *) reg {range}{name} [0:{last}];").unwrap();
        }
        text + &self.zeros() + &self.contents()
    }

    /// Block RAM begins with zeros; synthesis need not work through a loop for it.
    fn zeros(&self) -> String {
        let loops = self.module.memories.iter().zip(&self.names.memories);
        let loops = loops.filter(|(memory, _)| memory.contents.is_empty()).map(|(memory, name)| {
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

    /// What memories hold that are never written.
    fn contents(&self) -> String {
        let memories = self.module.memories.iter().zip(&self.names.memories);
        let words = memories.flat_map(|(memory, name)| {
            let words = memory.contents.iter().enumerate();
            words.map(move |(place, word)| {
                let word = literal(*word, memory.width, false);
                format!("        {name}[{place}] = {word};\n")
            })
        });
        let words: String = words.collect();
        match words.as_str() {
            "" => words,
            _ => format!("    initial begin\n{words}    end\n"),
        }
    }

    fn instances(&self) -> String {
        let mut texts = vec![];
        for (index, instance) in self.module.instances.iter().enumerate() {
            let mut rows = self.names.rows.iter();
            if let Some(row) = rows.find(|row| row.instances.contains(&index)) {
                if row.instances.start == index {
                    texts.push(self.row(row));
                }
                continue;
            }
            let nets = instance.inputs.iter().chain(&instance.outputs);
            let values = nets.map(|net| self.value(*net, false));
            texts.push(self.instance(&instance.module, &instance.name, values, 4));
        }
        texts.join("\n")
    }

    /// An instance of a module whose ports are connected with these values.
    fn instance(
        &self,
        module: &Module,
        name: &str,
        values: impl Iterator<Item = String>,
        indent: usize,
    ) -> String {
        let clock = module.is_clocked().then(|| ".clock(clock)".to_owned());
        let has_reset = self.has_reset && module.has_state();
        let reset = has_reset.then(|| ".reset(reset)".to_owned());
        let ports = module.ports.iter().zip(values);
        let ports = ports.map(|(port, value)| format!(".{}({value})", port.name));
        let all: Vec<String> = clock.into_iter().chain(reset).chain(ports).collect();
        let (margin, inner) = (" ".repeat(indent), " ".repeat(indent + 4));
        let lines = filled(&inner, &all, indent + 4);
        let module = format!("{}{}", self.prefix, module.name);
        format!("{margin}{module} {name} (\n{lines});\n")
    }

    fn assignments(&self) -> String {
        let mut text = String::new();
        for (net, node) in self.module.nets() {
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
            let value = self.value(port.net, false);
            writeln!(text, "    assign {} = {value};", port.name).unwrap();
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
        text += &self.reset(&registers);
        for (memory, name) in self.module.memories.iter().zip(&self.names.memories) {
            if memory.contents.is_empty() {
                let [enable, at, data] = memory.write.map(|net| self.value(net, true));
                writeln!(text, "        if ({enable}) {name}[{at}] <= {data};").unwrap();
            }
            if let Some(Name { text: read, .. }) = self.names.get(memory.net) {
                let address = self.value(memory.address, true);
                writeln!(text, "        {read} <= {name}[{address}];").unwrap();
            }
        }
        text + "    end\n"
    }

    /// What a reset puts into registers that hold a state.
    fn reset(&self, registers: &[&Register]) -> String {
        let states = registers.iter().filter(|register| register.is_state);
        let value = |register: &&Register| {
            let node = self.module.node(register.net);
            let name = &self.names.get(register.net).expect("it is read").text;
            let initial = literal(register.initial, node.width, node.signed);
            format!("            {name} <= {initial};\n")
        };
        let values: String = states.map(value).collect();
        match self.has_reset && !values.is_empty() {
            true => format!("        if (reset) begin\n{values}        end\n"),
            false => String::new(),
        }
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
            let mut inner = registers.to_vec();
            inner.retain(|(path, _)| path.get(depth) == Some(&condition));
            let condition = self.value(condition, false);
            let mut body = String::new();
            self.enabled(&inner, depth + 1, &mut body);
            let lines: Vec<&str> = body.lines().map(str::trim).collect();
            let inside = match lines.as_slice() {
                [only] if !only.starts_with("if") => (*only).to_owned(),
                [one, other] if !other.starts_with("if") => format!("begin {one} {other} end"),
                _ => format!("begin\n{body}{indent}end"),
            };
            writeln!(text, "{indent}if ({condition}) {inside}").unwrap();
        }
    }
}
