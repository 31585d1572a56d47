//! From rust-hdl's expression tree to typed expressions over resolved names.
//!
//! rust-hdl prints its tree token by token, without Verilog's rules of width and precedence, so that its text and its simulation
//! can differ. Here every expression carries the width and sign Rust gave it, and a form in which Verilog would compute with
//! another width is refused: the operands of an arithmetic operation or comparison must be names or constants.

use super::EmitError;
use super::collect::Scope;
use super::names::{literal, resolve};
use rust_hdl::core::ast::{
    VerilogBlock, VerilogBlockOrConditional, VerilogConditional, VerilogExpression, VerilogLoop,
    VerilogOp, VerilogOpUnary, VerilogStatement,
};
use rust_hdl::core::prelude::AtomKind;
use std::collections::HashMap;

/// Width and sign.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Type {
    pub width: usize,
    pub signed: bool,
}

/// Part a name plays in its module.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Role {
    Input,
    Output,
    Local,
    Constant(u64),
    /// Input of sub-block number n.
    ChildInput(usize),
    /// Output of sub-block number n.
    ChildOutput(usize),
}

/// A name of a module.
pub struct Name {
    pub role: Role,
    pub of: Type,
}

/// An expression without its type.
#[derive(Clone, PartialEq, Debug)]
pub enum Form {
    Name(String),
    Literal(u64),
    Binary(Box<Expression>, &'static str, Box<Expression>),
    Unary(&'static str, Box<Expression>),
    Bits { of: String, high: usize, low: usize },
    Extended(String, Type),
    Choice(Box<Expression>, Box<Expression>, Box<Expression>),
}

/// A typed expression.
#[derive(Clone, PartialEq, Debug)]
pub struct Expression {
    pub form: Form,
    pub of: Type,
}

impl Expression {
    fn is_operand(&self) -> bool {
        matches!(self.form, Form::Name(_) | Form::Literal(_))
    }
}

/// A statement over resolved names; loops are unrolled.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    Assign(String, Expression),
    If(Expression, Vec<Statement>, Vec<Statement>),
}

/// Names and statements of one module.
pub struct Lowered {
    pub names: HashMap<String, Name>,
    pub statements: Vec<Statement>,
}

/// Lowers the kernel of a scope.
pub fn lower(scope: &Scope, code: &VerilogBlock) -> Result<Lowered, EmitError> {
    let mut lowering = Lowering {
        names: names(scope),
        loops: Vec::new(),
    };
    let statements = lowering.block(code)?;
    Ok(Lowered {
        names: lowering.names,
        statements,
    })
}

fn names(scope: &Scope) -> HashMap<String, Name> {
    let mut names = HashMap::new();
    for net in &scope.nets {
        let role = match net.kind {
            AtomKind::InputParameter => Role::Input,
            AtomKind::Constant => Role::Constant(net.value),
            AtomKind::LocalSignal => Role::Local,
            _ => Role::Output,
        };
        let of = Type {
            width: net.width,
            signed: net.signed,
        };
        names.insert(net.name.clone(), Name { role, of });
    }
    for (number, child) in scope.children.iter().enumerate() {
        for net in &child.nets {
            let role = match net.kind {
                AtomKind::InputParameter => Role::ChildInput(number),
                AtomKind::OutputParameter => Role::ChildOutput(number),
                _ => continue,
            };
            let of = Type {
                width: net.width,
                signed: net.signed,
            };
            names.insert(
                format!("{}${}", child.instance, net.name),
                Name { role, of },
            );
        }
    }
    names
}

struct Lowering {
    names: HashMap<String, Name>,
    loops: Vec<(String, u64)>,
}

const BIT: Type = Type {
    width: 1,
    signed: false,
};

impl Lowering {
    fn block(&mut self, code: &VerilogBlock) -> Result<Vec<Statement>, EmitError> {
        let mut statements = Vec::new();
        for statement in code {
            statements.extend(self.statement(statement)?);
        }
        Ok(statements)
    }

    fn statement(&mut self, statement: &VerilogStatement) -> Result<Vec<Statement>, EmitError> {
        match statement {
            VerilogStatement::Assignment(target, value) => {
                Ok(vec![self.assignment(target, value)?])
            }
            VerilogStatement::If(conditional) => Ok(vec![self.conditional(conditional)?]),
            VerilogStatement::Loop(repeated) => self.unrolled(repeated),
            VerilogStatement::Macro(block) => self.block(block),
            VerilogStatement::Comment(_) => Ok(Vec::new()),
            other => Err(EmitError::block(
                &format!("{other:?}"),
                "is a statement the emitter does not take",
            )),
        }
    }

    fn unrolled(&mut self, repeated: &VerilogLoop) -> Result<Vec<Statement>, EmitError> {
        let mut statements = Vec::new();
        for value in repeated.from.as_usize()..repeated.to.as_usize() {
            self.loops.push((repeated.index.clone(), value as u64));
            let turn = self.block(&repeated.block);
            self.loops.pop();
            statements.extend(turn?);
        }
        Ok(statements)
    }

    fn conditional(&mut self, conditional: &VerilogConditional) -> Result<Statement, EmitError> {
        let condition = self.expression(&conditional.test)?;
        let then = self.block(&conditional.then)?;
        let otherwise = match &conditional.otherwise {
            VerilogBlockOrConditional::Block(block) => self.block(block)?,
            VerilogBlockOrConditional::Conditional(statement) => self.statement(statement)?,
            VerilogBlockOrConditional::None => Vec::new(),
        };
        Ok(Statement::If(condition, then, otherwise))
    }

    fn assignment(
        &self,
        target: &VerilogExpression,
        value: &VerilogExpression,
    ) -> Result<Statement, EmitError> {
        let target = self.name(target)?;
        let value = self.expression(value)?;
        let width = self.of(&target)?.width;
        if value.of.width != width {
            return Err(EmitError::block(
                &target,
                &format!("has {width} bits and gets {}", value.of.width),
            ));
        }
        Ok(Statement::Assign(target, value))
    }

    fn lookup(&self, name: &str) -> Option<u64> {
        if let Some((_, value)) = self.loops.iter().rev().find(|(index, _)| index == name) {
            return Some(*value);
        }
        let name = self.resolved(name).ok()?;
        match self.names.get(&name)?.role {
            Role::Constant(value) => Some(value),
            _ => None,
        }
    }

    fn resolved(&self, path: &str) -> Result<String, EmitError> {
        resolve(path, &|name| self.lookup(name))
    }

    fn name(&self, expression: &VerilogExpression) -> Result<String, EmitError> {
        match expression {
            VerilogExpression::Signal(path) => self.resolved(path),
            VerilogExpression::Paren(inner) => self.name(inner),
            other => Err(EmitError::block(
                &format!("{other:?}"),
                "stands where only a name may stand",
            )),
        }
    }

    fn of(&self, name: &str) -> Result<Type, EmitError> {
        self.names
            .get(name)
            .map(|name| name.of)
            .ok_or_else(|| EmitError::block(name, "is not declared"))
    }

    fn index(&self, expression: &VerilogExpression) -> Result<usize, EmitError> {
        if let VerilogExpression::Literal(value) = expression {
            return Ok(literal(value).1 as usize);
        }
        let name = self.name(expression)?;
        let value = self
            .lookup(&name)
            .ok_or_else(|| EmitError::block(&name, "is no constant index"))?;
        Ok(value as usize)
    }

    fn bits(
        &self,
        of: &VerilogExpression,
        low: usize,
        width: usize,
    ) -> Result<Expression, EmitError> {
        let of = self.name(of)?;
        let whole = self.of(&of)?;
        if low + width > whole.width {
            return Err(EmitError::block(&of, "is cut beyond its width"));
        }
        let form = if width == whole.width {
            Form::Name(of)
        } else {
            Form::Bits {
                of,
                high: low + width - 1,
                low,
            }
        };
        Ok(Expression {
            form,
            of: Type {
                width,
                signed: false,
            },
        })
    }

    fn cast(&self, of: &VerilogExpression, width: usize) -> Result<Expression, EmitError> {
        let name = self.name(of)?;
        let whole = self.of(&name)?;
        if width <= whole.width {
            return self.bits(of, 0, width);
        }
        Ok(Expression {
            form: Form::Extended(name, whole),
            of: Type {
                width,
                signed: whole.signed,
            },
        })
    }

    fn expression(&self, expression: &VerilogExpression) -> Result<Expression, EmitError> {
        match expression {
            VerilogExpression::Signal(path) => {
                let name = self.resolved(path)?;
                let of = self.of(&name)?;
                Ok(Expression {
                    form: Form::Name(name),
                    of,
                })
            }
            VerilogExpression::Literal(value) => {
                let (width, value) = literal(value);
                Ok(Expression {
                    form: Form::Literal(value),
                    of: Type {
                        width,
                        signed: false,
                    },
                })
            }
            VerilogExpression::Paren(inner) => self.expression(inner),
            VerilogExpression::Signed(inner) => Ok(read_as(self.expression(inner)?, true)),
            VerilogExpression::Unsigned(inner) => Ok(read_as(self.expression(inner)?, false)),
            VerilogExpression::Cast(inner, width) => self.cast(inner, *width),
            VerilogExpression::Slice(of, width, low) => self.bits(of, self.index(low)?, *width),
            VerilogExpression::Index(of, place) => self.bits(of, self.index(place)?, 1),
            VerilogExpression::Unary(operation, operand) => self.unary(operation, operand),
            VerilogExpression::Binary(left, operation, right) => {
                self.binary(left, operation, right)
            }
            other => Err(EmitError::block(
                &format!("{other:?}"),
                "is an expression the emitter does not take",
            )),
        }
    }

    fn unary(
        &self,
        operation: &VerilogOpUnary,
        operand: &VerilogExpression,
    ) -> Result<Expression, EmitError> {
        let operand = self.expression(operand)?;
        let (operator, of) = match operation {
            VerilogOpUnary::Not => ("~", operand.of),
            VerilogOpUnary::Neg => ("-", operand.of),
            VerilogOpUnary::All => ("&", BIT),
            VerilogOpUnary::Any => ("|", BIT),
            VerilogOpUnary::Xor => ("^", BIT),
        };
        if operator == "-" && !operand.is_operand() {
            return Err(EmitError::nested(operator));
        }
        Ok(Expression {
            form: Form::Unary(operator, Box::new(operand)),
            of,
        })
    }

    fn binary(
        &self,
        left: &VerilogExpression,
        operation: &VerilogOp,
        right: &VerilogExpression,
    ) -> Result<Expression, EmitError> {
        let left = self.expression(left)?;
        let right = self.expression(right)?;
        let operator = operator(operation);
        let same_width = left.of.width == right.of.width;
        let operands = left.is_operand() && right.is_operand();
        let same_type = left.of == right.of;
        let of = match operator {
            "&" | "|" | "^" if same_width => Type {
                width: left.of.width,
                signed: left.of.signed && right.of.signed,
            },
            "==" | "!=" if operands && same_width => BIT,
            "<" | "<=" | ">" | ">=" if operands && same_type => BIT,
            "+" | "-" if operands && same_type => left.of,
            "<<" | ">>" if operands && !left.of.signed => left.of,
            "*" if operands && same_type => Type {
                width: 2 * left.of.width,
                signed: left.of.signed,
            },
            _ => return Err(EmitError::nested(operator)),
        };
        Ok(Expression {
            form: Form::Binary(Box::new(left), operator, Box::new(right)),
            of,
        })
    }
}

fn read_as(expression: Expression, signed: bool) -> Expression {
    let width = expression.of.width;
    Expression {
        form: expression.form,
        of: Type { width, signed },
    }
}

fn operator(operation: &VerilogOp) -> &'static str {
    match operation {
        VerilogOp::Add => "+",
        VerilogOp::Sub => "-",
        VerilogOp::Mul => "*",
        VerilogOp::LogicalAnd | VerilogOp::BitAnd => "&",
        VerilogOp::LogicalOr | VerilogOp::BitOr => "|",
        VerilogOp::BitXor => "^",
        VerilogOp::Shl => "<<",
        VerilogOp::Shr => ">>",
        VerilogOp::Eq => "==",
        VerilogOp::Ne => "!=",
        VerilogOp::Lt => "<",
        VerilogOp::Le => "<=",
        VerilogOp::Ge => ">=",
        VerilogOp::Gt => ">",
    }
}
