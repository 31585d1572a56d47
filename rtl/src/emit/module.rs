//! From lowered statements to the text of one module.
//!
//! Signals become `assign`s whose value is worked out over all branches, so that nothing depends on when a simulator wakes a
//! block; registers become `reg`s in one clocked block with the branches of the kernel.

use super::EmitError;
use super::collect::{Kernel, Net, Scope};
use super::lower::{Expression, Form, Lowered, Role, Statement, Type, lower};
use super::names::{check_identifier, instance, signal};
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
    used: HashSet<String>,
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
            used: HashSet::new(),
        };
        module.check_clocks()?;
        module.find_aliases();
        module.find_used();
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

    fn find_used(&mut self) {
        let mut used = HashSet::new();
        for value in self.values.values() {
            read(value, &mut |name| {
                used.insert(self.source(name).to_owned());
            });
        }
        read_statements(&self.clocked, &mut |name| {
            used.insert(self.source(name).to_owned());
        });
        self.used = used;
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
            Role::ChildOutput(child) => {
                !self.scope.children[child].is_register() && self.used.contains(name)
            }
            Role::Local => !self.aliases.contains_key(name),
            Role::Input | Role::Output => true,
        }
    }

    /// A constant printed by name.
    fn is_parameter(&self, name: &str) -> bool {
        self.used.contains(name)
            && !name.contains('$')
            && matches!(self.lowered.names[name].role, Role::Constant(_))
    }

    /// An input of a sub-block that is more than a name.
    fn needs_wire(&self, name: &str) -> bool {
        let simple = |value: &Expression| matches!(value.form, Form::Name(_) | Form::Literal(_));
        self.values.get(name).is_some_and(|value| !simple(value))
    }

    fn identifier(&self, name: &str) -> String {
        let name = self.source(name);
        match self.lowered.names[name].role {
            Role::ChildInput(child) | Role::ChildOutput(child) => {
                let child = &self.scope.children[child];
                let prefix = instance(&child.instance);
                if child.is_register() {
                    prefix
                } else {
                    format!("{prefix}_{}", signal(&name[child.instance.len() + 1..]))
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
            _ if self.used.contains(&name) => self.identifier(&name),
            _ => String::new(),
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
        let mut assigned: Vec<_> = own.map(|net| net.name.clone()).collect();
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

    fn clocked_block(&self, text: &mut String) {
        if self.clocked.is_empty() {
            return;
        }
        text.push_str("\n    always @(posedge clock) begin\n");
        self.print_statements(&self.clocked, 2, text);
        text.push_str("    end\n");
    }

    fn print_statements(&self, statements: &[Statement], depth: usize, text: &mut String) {
        let indent = "    ".repeat(depth);
        for statement in statements {
            match statement {
                Statement::Assign(target, value) => {
                    let _ = writeln!(
                        text,
                        "{indent}{} <= {};",
                        self.identifier(target),
                        self.print(value)
                    );
                }
                Statement::If(condition, then, otherwise) => {
                    text.push_str(&indent);
                    self.print_if(condition, then, otherwise, depth, text);
                }
            }
        }
    }

    fn print_if(
        &self,
        condition: &Expression,
        then: &[Statement],
        otherwise: &[Statement],
        depth: usize,
        text: &mut String,
    ) {
        let indent = "    ".repeat(depth);
        let _ = writeln!(text, "if ({}) begin", self.print(condition));
        self.print_statements(then, depth + 1, text);
        match otherwise {
            [] => {
                let _ = writeln!(text, "{indent}end");
            }
            [Statement::If(condition, then, otherwise)] => {
                let _ = write!(text, "{indent}end else ");
                self.print_if(condition, then, otherwise, depth, text);
            }
            _ => {
                let _ = writeln!(text, "{indent}end else begin");
                self.print_statements(otherwise, depth + 1, text);
                let _ = writeln!(text, "{indent}end");
            }
        }
    }

    /// A choice over several lines, anything else on one.
    fn print_choice(&self, value: &Expression, depth: usize) -> String {
        let Form::Choice(condition, then, otherwise) = &value.form else {
            return self.print(value);
        };
        let indent = "    ".repeat(depth + 1);
        let then = match then.form {
            Form::Choice(..) => format!("({})", self.print_choice(then, depth + 1)),
            _ => self.print(then),
        };
        let space = match otherwise.form {
            Form::Choice(..) => format!("\n{indent}"),
            _ => " ".to_owned(),
        };
        format!(
            "{} ? {then} :{space}{}",
            self.print_operand(condition),
            self.print_choice(otherwise, depth)
        )
    }

    fn print(&self, value: &Expression) -> String {
        match &value.form {
            Form::Name(name) => self.identifier(name),
            Form::Literal(literal) => number(*literal, value.of),
            Form::Binary(left, operator, right) => {
                format!(
                    "{} {operator} {}",
                    self.print_operand(left),
                    self.print_operand(right)
                )
            }
            Form::Unary(operator, operand) => format!("{operator}{}", self.print_operand(operand)),
            Form::Bits { of, high, low } if high == low => {
                format!("{}[{low}]", self.identifier(of))
            }
            Form::Bits { of, high, low } => format!("{}[{high}:{low}]", self.identifier(of)),
            Form::Extended(name, from) => {
                let name = self.identifier(name);
                let added = value.of.width - from.width;
                if from.signed {
                    format!("{{{{{added}{{{name}[{}]}}}}, {name}}}", from.width - 1)
                } else {
                    format!(
                        "{{{}, {name}}}",
                        number(
                            0,
                            Type {
                                width: added,
                                signed: false
                            }
                        )
                    )
                }
            }
            Form::Choice(..) => self.print_choice(value, 1),
        }
    }

    fn print_operand(&self, value: &Expression) -> String {
        match value.form {
            Form::Binary(..) | Form::Choice(..) => format!("({})", self.print(value)),
            _ => self.print(value),
        }
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

/// The statements that assign a wanted target, in their branches.
fn filtered(
    statements: &[Statement],
    wanted: &dyn Fn(&str, &Expression) -> bool,
) -> Vec<Statement> {
    let mut kept = Vec::new();
    for statement in statements {
        match statement {
            Statement::Assign(target, value) if wanted(target, value) => {
                kept.push(statement.clone())
            }
            Statement::Assign(..) => {}
            Statement::If(condition, then, otherwise) => {
                let then = filtered(then, wanted);
                let otherwise = filtered(otherwise, wanted);
                match (then.is_empty(), otherwise.is_empty()) {
                    (true, true) => {}
                    (true, false) => kept.push(Statement::If(opposite(condition), otherwise, then)),
                    (false, _) => kept.push(Statement::If(condition.clone(), then, otherwise)),
                }
            }
        }
    }
    kept
}

/// Drops the assignments of a register to itself that come before any other: a `reg` holds by nature.
fn drop_holds(statements: &mut Vec<Statement>) {
    let mut assigned = HashSet::new();
    statements.retain(|statement| {
        let is_hold = match statement {
            Statement::Assign(target, value) => {
                let register = target.strip_suffix("$d");
                let is_own = |name: &String| name.strip_suffix("$q") == register;
                matches!(&value.form, Form::Name(name) if is_own(name))
                    && !assigned.contains(target)
            }
            Statement::If(..) => false,
        };
        if !is_hold {
            targets(statement, &mut assigned);
        }
        !is_hold
    });
}

fn targets(statement: &Statement, found: &mut HashSet<String>) {
    match statement {
        Statement::Assign(target, _) => {
            found.insert(target.clone());
        }
        Statement::If(_, then, otherwise) => {
            then.iter()
                .chain(otherwise)
                .for_each(|statement| targets(statement, found));
        }
    }
}

/// Drops assignments that a later one replaces in any case.
fn drop_replaced(statements: &mut Vec<Statement>) {
    let mut last = HashMap::new();
    for (place, statement) in statements.iter().enumerate() {
        if let Statement::Assign(target, _) = statement {
            last.insert(target.clone(), place);
        }
    }
    let mut place = 0;
    statements.retain(|statement| {
        place += 1;
        !matches!(statement, Statement::Assign(target, _) if last[target] >= place)
    });
}

fn opposite(condition: &Expression) -> Expression {
    Expression {
        form: Form::Unary("~", Box::new(condition.clone())),
        of: condition.of,
    }
}

/// Works out the value every target has in the end; a later assignment replaces an earlier one.
fn execute(
    statements: &[Statement],
    values: &mut BTreeMap<String, Expression>,
) -> Result<(), EmitError> {
    for statement in statements {
        match statement {
            Statement::Assign(target, value) => {
                values.insert(target.clone(), value.clone());
            }
            Statement::If(condition, then, otherwise) => {
                let mut then_values = values.clone();
                execute(then, &mut then_values)?;
                let mut other_values = values.clone();
                execute(otherwise, &mut other_values)?;
                *values = joined(condition, then_values, other_values)?;
            }
        }
    }
    Ok(())
}

/// Refuses a local signal that is assigned after it was read: the reader in the simulation saw a value that no wire has.
fn check_order(
    statements: &[Statement],
    lowered: &Lowered,
    seen: &mut HashSet<String>,
) -> Result<(), EmitError> {
    for statement in statements {
        match statement {
            Statement::Assign(target, value) => {
                read(value, &mut |name| {
                    seen.insert(name.to_owned());
                });
                if lowered.names[target].role == Role::Local && seen.contains(target) {
                    return Err(EmitError::block(target, "is assigned after it was read"));
                }
            }
            Statement::If(condition, then, otherwise) => {
                read(condition, &mut |name| {
                    seen.insert(name.to_owned());
                });
                check_order(then, lowered, seen)?;
                check_order(otherwise, lowered, seen)?;
            }
        }
    }
    Ok(())
}

fn joined(
    condition: &Expression,
    then: BTreeMap<String, Expression>,
    mut otherwise: BTreeMap<String, Expression>,
) -> Result<BTreeMap<String, Expression>, EmitError> {
    let mut values = BTreeMap::new();
    for (target, value) in then {
        let other = otherwise
            .remove(&target)
            .ok_or_else(|| EmitError::block(&target, "is a latch"))?;
        let value = if value == other {
            value
        } else {
            if multiplies(&value) || multiplies(&other) {
                return Err(EmitError::nested("*"));
            }
            let of = value.of;
            let form = Form::Choice(
                Box::new(condition.clone()),
                Box::new(value),
                Box::new(other),
            );
            Expression { form, of }
        };
        values.insert(target, value);
    }
    match otherwise.into_keys().next() {
        Some(target) => Err(EmitError::block(&target, "is a latch")),
        None => Ok(values),
    }
}

/// A product takes its width from its context, so it must stand alone.
fn multiplies(value: &Expression) -> bool {
    matches!(value.form, Form::Binary(_, "*", _))
}

fn read(value: &Expression, found: &mut dyn FnMut(&str)) {
    match &value.form {
        Form::Name(name) | Form::Bits { of: name, .. } | Form::Extended(name, _) => found(name),
        Form::Literal(_) => {}
        Form::Unary(_, operand) => read(operand, found),
        Form::Binary(left, _, right) => {
            read(left, found);
            read(right, found);
        }
        Form::Choice(condition, then, otherwise) => {
            read(condition, found);
            read(then, found);
            read(otherwise, found);
        }
    }
}

fn read_statements(statements: &[Statement], found: &mut dyn FnMut(&str)) {
    for statement in statements {
        match statement {
            Statement::Assign(_, value) => read(value, found),
            Statement::If(condition, then, otherwise) => {
                read(condition, found);
                read_statements(then, found);
                read_statements(otherwise, found);
            }
        }
    }
}

/// The signal is a port of its block.
pub fn is_port(net: &Net) -> bool {
    matches!(
        net.kind,
        AtomKind::InputParameter | AtomKind::OutputParameter
    )
}

fn port(net: &Net) -> String {
    let direction = if net.kind == AtomKind::InputParameter {
        "input "
    } else {
        "output"
    };
    let of = Type {
        width: net.width,
        signed: net.signed,
    };
    format!("{direction} wire {}{}", shape(of), signal(&net.name))
}

/// Sign and range before a name, with a space behind.
fn shape(of: Type) -> String {
    let signed = if of.signed { "signed " } else { "" };
    match of.width {
        1 if !of.signed => String::new(),
        width => format!("{signed}[{}:0] ", width - 1),
    }
}

/// A sized number. The most negative one has no positive counterpart and is written in hexadecimal.
fn number(value: u64, of: Type) -> String {
    let width = of.width;
    let sign = 1_u64 << (width - 1);
    match (of.signed, value & sign != 0) {
        (false, _) => format!("{width}'d{value}"),
        (true, false) => format!("{width}'sd{value}"),
        (true, true) if value == sign => format!("{width}'sh{value:x}"),
        (true, true) => format!("-{width}'sd{}", (sign - 1) - (value & (sign - 1)) + 1),
    }
}

fn section(text: &mut String, lines: &[String]) {
    if lines.is_empty() {
        return;
    }
    text.push('\n');
    for line in lines {
        let _ = writeln!(text, "    {line}");
    }
}
