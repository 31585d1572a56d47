//! Expressions, statements, ports and numbers as Verilog text.

use super::super::collect::Net;
use super::super::lower::{Expression, Form, Statement, Type};
use super::super::names::signal;
use super::Module;
use rust_hdl::core::prelude::AtomKind;
use std::fmt::Write;

impl Module<'_> {
    pub(super) fn print_statements(
        &self,
        statements: &[Statement],
        depth: usize,
        text: &mut String,
    ) {
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
    pub(super) fn print_choice(&self, value: &Expression, depth: usize) -> String {
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

    pub(super) fn print(&self, value: &Expression) -> String {
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

pub fn port(net: &Net) -> String {
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
pub fn shape(of: Type) -> String {
    let signed = if of.signed { "signed " } else { "" };
    match of.width {
        1 if !of.signed => String::new(),
        width => format!("{signed}[{}:0] ", width - 1),
    }
}

/// A sized number. The most negative one has no positive counterpart and is written in hexadecimal.
pub fn number(value: u64, of: Type) -> String {
    let width = of.width;
    let sign = 1_u64 << (width - 1);
    match (of.signed, value & sign != 0) {
        (false, _) => format!("{width}'d{value}"),
        (true, false) => format!("{width}'sd{value}"),
        (true, true) if value == sign => format!("{width}'sh{value:x}"),
        (true, true) => format!("-{width}'sd{}", (sign - 1) - (value & (sign - 1)) + 1),
    }
}

pub fn section(text: &mut String, lines: &[String]) {
    if lines.is_empty() {
        return;
    }
    text.push('\n');
    for line in lines {
        let _ = writeln!(text, "    {line}");
    }
}
