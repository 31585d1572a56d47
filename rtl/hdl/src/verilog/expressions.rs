//! Values and operations as Verilog expressions.

use super::names::Names;
use super::text::{Name, literal};
use crate::tree::{Binary, Module, Net, Op};
use crate::value::mask;

/// A module with the names of its nets.
pub(super) struct Writer<'a> {
    pub(super) module: &'a Module,
    pub(super) prefix: &'a str,
    pub(super) names: Names,
    /// A port has a reset for registers that hold a state.
    pub(super) has_reset: bool,
}

impl Writer<'_> {
    /// What stands where a net is read; in parentheses if it is part of an expression and has an operator.
    pub(super) fn value(&self, net: Net, inner: bool) -> String {
        match self.names.get(net) {
            Some(name) => name.all(self.module.node(net).width),
            None => self.expression(net, inner),
        }
    }

    /// What drives a net.
    pub(super) fn expression(&self, net: Net, inner: bool) -> String {
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
                    closed(self.comparison(*a, *b, ">=", "<="))
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
                    Binary::Less => return closed(self.comparison(*a, *b, "<", ">")),
                };
                closed(format!("{} {sign} {}", value(a), value(b)))
            }
            Op::Select(which, a, b) => {
                // Choices behind choices read from the first to the last.
                let last = self.value(*b, !matches!(self.module.node(*b).op, Op::Select(..)));
                closed(format!("{} ? {} : {last}", value(which), value(a)))
            }
            Op::Slice(a, low) => {
                if let Op::Literal(bits) = self.module.node(*a).op {
                    return literal(bits >> low & mask(node.width), node.width, false);
                }
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

    /// Two values compared, a literal on the right: synthesis makes fewer carry cells of `a > 7` than of `7 < a`.
    fn comparison(&self, a: Net, b: Net, sign: &str, turned: &str) -> String {
        let (a, sign, b) = match self.module.node(a).op {
            Op::Literal(_) => (b, turned, a),
            _ => (a, sign, b),
        };
        let (width, signed) = (self.module.node(a).width, self.module.node(a).signed);
        let [one, other] = match (self.names.get(a), self.names.get(b)) {
            (Some(one), Some(other)) if signed && width > 1 => {
                // Numbers are compared as words whose signs have changed places: synthesis builds that as one chain of
                // carries, and breaks it before the sign of a number.
                let word = |sign: &Name, rest: &Name| {
                    let sign = sign.part(width - 1, width - 1, width);
                    format!("{{{sign}, {}}}", rest.part(width - 2, 0, width))
                };
                [word(other, one), word(one, other)]
            }
            _ => [a, b].map(|net| self.value(net, true)),
        };
        format!("{one} {sign} {other}")
    }
}
