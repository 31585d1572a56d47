//! From lowered statements to the text of one module.
//!
//! Signals become `assign`s whose value is worked out over all branches, so that nothing depends on when a simulator wakes a
//! block; registers become `reg`s in one clocked block with the branches of the kernel.

mod flow;
mod print;

use super::EmitError;
use super::collect::{Kernel, Net, Scope};
use super::lower::{Expression, Form, Lowered, Role, Statement, Type, lower};
use super::names::{check_identifier, instance, signal};
use flow::{
    check_order, drop_holds, drop_replaced, execute, filtered, ones, read, read_statements,
};
use print::{number, section};
pub use print::{port, shape};
use rust_hdl::core::prelude::AtomKind;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::fmt::Write;

/// Writes the body of a module, from the port list on. `child_module` names the module of sub-block n.
pub fn body(scope: &Scope, child_module: &dyn Fn(usize) -> String) -> Result<String, EmitError> {
    let Ok(Kernel::Statements { code, .. }) = &scope.kernel else {
        return Err(EmitError::block(&scope.instance, "has no kernel"));
    };
    let lowered = lower(scope, code)?;
    Module::new(scope, &lowered)?.text(child_module)
}

struct Module<'a> {
    scope: &'a Scope,
    lowered: &'a Lowered,
    /// Final values of everything but registers.
    values: BTreeMap<String, Expression>,
    /// Names that another name stands for.
    aliases: HashMap<String, String>,
    clocked: Vec<Statement>,
    /// Names that are read, with ones at the bits that are.
    used: HashMap<String, u64>,
}

impl<'a> Module<'a> {
    fn new(scope: &'a Scope, lowered: &'a Lowered) -> Result<Self, EmitError> {
        let is_clocked = |target: &str| register_part(scope, lowered, target) == Some("d");
        let mut clocked = filtered(&lowered.statements, &|target, _| is_clocked(target));
        drop_holds(&mut clocked);
        drop_replaced(&mut clocked);
        let free = filtered(&lowered.statements, &|target, _| !is_clocked(target));
        let mut values = BTreeMap::new();
        execute(&free, &mut values)?;
        check_order(&free, lowered, &mut HashSet::new())?;
        let mut module = Self {
            scope,
            lowered,
            values,
            aliases: HashMap::new(),
            clocked,
            used: HashMap::new(),
        };
        module.check_clocks()?;
        module.find_aliases();
        module.drop_unread();
        module.check_identifiers()?;
        Ok(module)
    }

    /// Every register is clocked by the module's own clock, so that one clocked block can hold them all.
    fn check_clocks(&mut self) -> Result<(), EmitError> {
        for child in self
            .scope
            .children
            .iter()
            .filter(|child| child.is_register())
        {
            let clock = self.values.remove(&format!("{}$clock", child.instance));
            match clock.map(|value| value.form) {
                Some(Form::Name(name)) if name == "clock" => {}
                _ => {
                    return Err(EmitError::block(
                        &child.instance,
                        "is not clocked by `clock`",
                    ));
                }
            }
        }
        Ok(())
    }

    /// A local signal that only repeats another name is left out.
    fn find_aliases(&mut self) {
        for (name, value) in &self.values {
            let local = &self.lowered.names[name];
            if let (Role::Local, Form::Name(source)) = (local.role, &value.form)
                && self.lowered.names[source].of == local.of
            {
                self.aliases.insert(name.clone(), source.clone());
            }
        }
        for name in self.aliases.keys() {
            self.values.remove(name);
        }
    }

    fn source<'n>(&'n self, name: &'n str) -> &'n str {
        self.aliases
            .get(name)
            .map_or(name, |source| self.source(source))
    }

    /// Leaves out local signals that nothing reads, and what only they read.
    fn drop_unread(&mut self) {
        loop {
            self.used = self.find_used();
            let unread = |name: &String| {
                self.lowered.names[name].role == Role::Local && !self.used.contains_key(name)
            };
            let Some(name) = self.values.keys().find(|name| unread(name)).cloned() else {
                return;
            };
            self.values.remove(&name);
        }
    }

    fn find_used(&self) -> HashMap<String, u64> {
        let mut used = HashMap::new();
        let mut note = |name: &str, bits: u64| {
            *used.entry(self.source(name).to_owned()).or_default() |= bits;
        };
        for value in self.values.values() {
            read(value, &mut note);
        }
        read_statements(&self.clocked, &mut note);
        if !self.clocked.is_empty() {
            note("clock", 1);
        }
        used
    }

    fn check_identifiers(&self) -> Result<(), EmitError> {
        let mut seen = BTreeSet::new();
        let instances = self
            .scope
            .children
            .iter()
            .map(|child| instance(&child.instance));
        let signals = self
            .lowered
            .names
            .keys()
            .filter(|name| self.is_declared(name))
            .map(|name| self.identifier(name));
        for identifier in instances.chain(signals) {
            check_identifier(&identifier)?;
            if !seen.insert(identifier.clone()) {
                return Err(EmitError::block(&identifier, "names two things"));
            }
        }
        Ok(())
    }

    /// A name that gets an identifier of its own: not an element of a constant array, an alias, or a port of a register.
    fn is_declared(&self, name: &str) -> bool {
        match self.lowered.names[name].role {
            Role::Constant(_) => self.is_parameter(name),
            Role::ChildInput(_) => self.needs_wire(name),
            Role::ChildOutput(child) => !self.scope.children[child].is_register(),
            Role::Local => self.values.contains_key(name),
            Role::Input | Role::Output => true,
        }
    }

    /// A constant printed by name.
    fn is_parameter(&self, name: &str) -> bool {
        self.used.contains_key(name)
            && !name.contains('$')
            && matches!(self.lowered.names[name].role, Role::Constant(_))
    }

    /// An input of a sub-block that is more than a name.
    fn needs_wire(&self, name: &str) -> bool {
        let simple = |value: &Expression| matches!(value.form, Form::Name(_) | Form::Literal(_));
        self.values.get(name).is_some_and(|value| !simple(value))
    }

    /// An output of a sub-block that nothing reads; linters let a wire be unread whose name says so.
    fn is_left_open(&self, name: &str) -> bool {
        let is_output = matches!(self.lowered.names[name].role, Role::ChildOutput(_));
        is_output && !self.used.contains_key(name)
    }

    fn identifier(&self, name: &str) -> String {
        let name = self.source(name);
        match self.lowered.names[name].role {
            Role::ChildInput(child) | Role::ChildOutput(child) => {
                let child = &self.scope.children[child];
                let prefix = instance(&child.instance);
                let port = &name[child.instance.len() + 1..];
                if child.is_register() {
                    prefix
                } else if self.is_left_open(name) {
                    format!("unused_{prefix}_{}", signal(port))
                } else {
                    format!("{prefix}_{}", signal(port))
                }
            }
            Role::Constant(value) if name.contains('$') => {
                number(value, self.lowered.names[name].of)
            }
            _ => signal(name),
        }
    }

    fn text(&self, child_module: &dyn Fn(usize) -> String) -> Result<String, EmitError> {
        let mut text = String::new();
        self.ports(&mut text);
        self.declarations(&mut text);
        self.instances(&mut text, child_module)?;
        self.assignments(&mut text)?;
        self.unused_bits(&mut text);
        self.clocked_block(&mut text);
        Ok(text)
    }

    fn ports(&self, text: &mut String) {
        let ports = self.scope.nets.iter().filter(|net| is_port(net));
        let lines: Vec<_> = ports.map(|net| format!("    {}", port(net))).collect();
        let _ = write!(text, " (\n{}\n);\n", lines.join(",\n"));
    }

    fn declarations(&self, text: &mut String) {
        let mut lines = Vec::new();
        for net in self
            .scope
            .nets
            .iter()
            .filter(|net| self.is_parameter(&net.name))
        {
            let of = Type {
                width: net.width,
                signed: net.signed,
            };
            lines.push(format!(
                "localparam {}{} = {};",
                shape(of),
                net.name,
                number(net.value, of)
            ));
        }
        for net in self
            .scope
            .nets
            .iter()
            .filter(|net| net.kind == AtomKind::LocalSignal)
        {
            if self.is_declared(&net.name) {
                lines.push(self.wire(&net.name));
            }
        }
        for name in self
            .lowered
            .terms
            .iter()
            .filter(|name| self.is_declared(name))
        {
            lines.push(self.wire(name));
        }
        for child in &self.scope.children {
            for net in child
                .nets
                .iter()
                .map(|net| format!("{}${}", child.instance, net.name))
            {
                if self.lowered.names.contains_key(&net) && self.is_declared(&net) {
                    lines.push(self.wire(&net));
                }
            }
        }
        for child in self
            .scope
            .children
            .iter()
            .filter(|child| child.is_register())
        {
            if let Some(q) = child.net("q") {
                let of = Type {
                    width: q.width,
                    signed: q.signed,
                };
                lines.push(format!(
                    "reg {}{} = {};",
                    shape(of),
                    instance(&child.instance),
                    number(0, of)
                ));
            }
        }
        section(text, &lines);
    }

    fn wire(&self, name: &str) -> String {
        format!(
            "wire {}{};",
            shape(self.lowered.names[name].of),
            self.identifier(name)
        )
    }

    fn instances(
        &self,
        text: &mut String,
        child_module: &dyn Fn(usize) -> String,
    ) -> Result<(), EmitError> {
        for (number, child) in self
            .scope
            .children
            .iter()
            .enumerate()
            .filter(|(_, child)| !child.is_register())
        {
            let ports = child.nets.iter().filter(|net| is_port(net));
            let connections = ports
                .map(|net| self.connection(child, net))
                .collect::<Result<Vec<_>, _>>()?;
            let _ = write!(
                text,
                "\n    {} {} (\n{}\n    );\n",
                child_module(number),
                instance(&child.instance),
                connections.join(",\n")
            );
        }
        Ok(())
    }

    fn connection(&self, child: &Scope, net: &Net) -> Result<String, EmitError> {
        let name = format!("{}${}", child.instance, net.name);
        let value = match net.kind {
            AtomKind::InputParameter if self.needs_wire(&name) => self.identifier(&name),
            AtomKind::InputParameter => {
                let value = self
                    .values
                    .get(&name)
                    .ok_or_else(|| EmitError::block(&name, "is not driven"))?;
                self.print(value)
            }
            _ => self.identifier(&name),
        };
        Ok(format!("        .{}({value})", signal(&net.name)))
    }

    fn assignments(&self, text: &mut String) -> Result<(), EmitError> {
        let mut lines = Vec::new();
        for name in self.assigned() {
            let value = self
                .values
                .get(&name)
                .ok_or_else(|| EmitError::block(&name, "is not driven"))?;
            lines.push(format!(
                "assign {} = {};",
                self.identifier(&name),
                self.print_choice(value, 1)
            ));
        }
        section(text, &lines);
        Ok(())
    }

    /// The names that get an `assign`, in the order of the block's fields.
    fn assigned(&self) -> Vec<String> {
        let own = self.scope.nets.iter().filter(|net| {
            matches!(
                self.lowered.names[&net.name].role,
                Role::Local | Role::Output
            ) && self.is_declared(&net.name)
        });
        let terms = self
            .lowered
            .terms
            .iter()
            .filter(|name| self.is_declared(name));
        let mut assigned: Vec<_> = terms.cloned().collect();
        assigned.extend(own.map(|net| net.name.clone()));
        for child in &self.scope.children {
            let inputs = child
                .nets
                .iter()
                .map(|net| format!("{}${}", child.instance, net.name));
            assigned.extend(inputs.filter(|name| self.needs_wire(name)));
        }
        assigned.sort_by_key(|name| self.lowered.names[name].role == Role::Output);
        assigned
    }

    /// Names the bits that nothing reads, so that a linter knows that this is meant.
    fn unused_bits(&self, text: &mut String) {
        let own = self.scope.nets.iter().filter(|net| {
            matches!(
                self.lowered.names[&net.name].role,
                Role::Input | Role::Local
            )
        });
        let mut names: Vec<_> = own.map(|net| net.name.clone()).collect();
        names.extend(self.lowered.terms.iter().cloned());
        for child in &self.scope.children {
            let ports = child
                .nets
                .iter()
                .map(|net| format!("{}${}", child.instance, net.name));
            names.extend(ports.filter(|name| {
                self.lowered
                    .names
                    .get(name)
                    .is_some_and(|n| matches!(n.role, Role::ChildOutput(_)))
            }));
        }
        let mut parts = Vec::new();
        for name in names {
            if !self.is_declared(&name) && register_part(self.scope, self.lowered, &name).is_none()
            {
                continue;
            }
            if self.is_left_open(&name) {
                continue;
            }
            let width = self.lowered.names[&name].of.width;
            let unread = ones(width) & !self.used.get(&name).copied().unwrap_or(0);
            parts.extend(ranges(unread).map(|(high, low)| self.slice(&name, high, low)));
        }
        if !parts.is_empty() {
            section(
                text,
                &[format!(
                    "wire unused_bits = &{{1'b0, {}}};",
                    parts.join(", ")
                )],
            );
        }
    }

    fn slice(&self, name: &str, high: usize, low: usize) -> String {
        let identifier = self.identifier(name);
        match (self.lowered.names[name].of.width, high == low) {
            (width, _) if high - low + 1 == width => identifier,
            (_, true) => format!("{identifier}[{low}]"),
            (_, false) => format!("{identifier}[{high}:{low}]"),
        }
    }

    fn clocked_block(&self, text: &mut String) {
        if self.clocked.is_empty() {
            return;
        }
        text.push_str("\n    always @(posedge clock) begin\n");
        self.print_statements(&self.clocked, 2, text);
        text.push_str("    end\n");
    }
}

/// The part (`d`, `q`, `clock`) a name plays in a register, if it belongs to one.
fn register_part<'n>(scope: &Scope, lowered: &Lowered, name: &'n str) -> Option<&'n str> {
    match lowered.names.get(name)?.role {
        Role::ChildInput(child) | Role::ChildOutput(child)
            if scope.children[child].is_register() =>
        {
            name.rsplit('$').next()
        }
        _ => None,
    }
}

/// The runs of ones in a word, each as its highest and lowest bit, from the top.
fn ranges(mut bits: u64) -> impl Iterator<Item = (usize, usize)> {
    std::iter::from_fn(move || {
        let high = (bits != 0).then(|| 63 - bits.leading_zeros() as usize)?;
        let run = (bits << (63 - high)).leading_ones() as usize;
        let low = high + 1 - run;
        bits &= !(ones(run) << low);
        Some((high, low))
    })
}

/// The signal is a port of its block.
pub fn is_port(net: &Net) -> bool {
    matches!(
        net.kind,
        AtomKind::InputParameter | AtomKind::OutputParameter
    )
}
