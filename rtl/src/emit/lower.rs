//! From rust-hdl's expression tree to typed expressions over resolved names.
//!
//! rust-hdl prints its tree token by token, without Verilog's rules of width and precedence, so that its text and its simulation
//! can differ. Here every expression carries the width and sign Rust gave it, and where Verilog would compute a part of it with
//! another width or sign, that part gets a wire of its own type: the operands of arithmetic, comparisons and cuts are names or constants.

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

/// A statement over resolved names; loops are unrolled.
#[derive(Clone, PartialEq, Debug)]
pub enum Statement {
    Assign(String, Expression),
    If(Expression, Vec<Statement>, Vec<Statement>),
}

/// Names and statements of one module.
pub struct Lowered {
    pub names: HashMap<String, Name>,
    /// Local signals that the kernel does not name: parts of its expressions, in the order they are needed.
    pub terms: Vec<String>,
    pub statements: Vec<Statement>,
}

/// Lowers the kernel of a scope.
pub fn lower(scope: &Scope, code: &VerilogBlock) -> Result<Lowered, EmitError> {
    let mut lowering = Lowering {
        names: names(scope),
        terms: Vec::new(),
        pending: Vec::new(),
        branches: 0,
        loops: Vec::new(),
    };
    let statements = lowering.block(code)?;
    Ok(Lowered {
        names: lowering.names,
        terms: lowering.terms,
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
    terms: Vec<String>,
    /// Assignments of terms, to stand before the statement in work, outside of all branches.
    pending: Vec<Statement>,
    branches: usize,
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
            let lowered = self.statement(statement)?;
            if self.branches == 0 {
                statements.append(&mut self.pending);
            }
            statements.extend(lowered);
        }
        Ok(statements)
    }

    /// Gives a part of an expression a wire of its own.
    fn term(&mut self, value: Expression) -> Expression {
        let of = value.of;
        let free = |number: &usize| !self.names.contains_key(&format!("term_{number}"));
        let number = (self.terms.len() + 1..)
            .find(free)
            .expect("numbers do not end");
        let name = format!("term_{number}");
        let role = Role::Local;
        self.names.insert(name.clone(), Name { role, of });
        self.terms.push(name.clone());
        self.pending.push(Statement::Assign(name.clone(), value));
        Expression {
            form: Form::Name(name),
            of,
        }
    }

    /// The expression as a name or constant of its type.
    fn operand(&mut self, value: Expression) -> Expression {
        let is_plain = match &value.form {
            Form::Name(name) => self.names[name].of.signed == value.of.signed,
            Form::Literal(_) => true,
            _ => false,
        };
        if is_plain { value } else { self.term(value) }
    }

    /// The expression as a name.
    fn named(&mut self, value: Expression) -> String {
        match self.operand(value) {
            Expression {
                form: Form::Name(name),
                ..
            } => name,
            constant => match self.term(constant).form {
                Form::Name(name) => name,
                _ => unreachable!("a term is a name"),
            },
        }
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
        self.branches += 1;
        let then = self.block(&conditional.then);
        let otherwise = match &conditional.otherwise {
            VerilogBlockOrConditional::Block(block) => self.block(block),
            VerilogBlockOrConditional::Conditional(statement) => self.statement(statement),
            VerilogBlockOrConditional::None => Ok(Vec::new()),
        };
        self.branches -= 1;
        let (then, otherwise) = (then?, otherwise?);
        Ok(Statement::If(condition, then, otherwise))
    }

    fn assignment(
        &mut self,
        target: &VerilogExpression,
        value: &VerilogExpression,
    ) -> Result<Statement, EmitError> {
        let target = self.name(target)?;
        let width = self.of(&target)?.width;
        let mut value = match value {
            VerilogExpression::Signed(inner) => self.lengthened(inner, width)?,
            other => self.expression(other)?,
        };
        if self.branches > 0 && is_product(&value) {
            value = self.term(value);
        }
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

    /// Some bits of a name, a number with a sign if the name is one, as the word types have it.
    fn bits(&self, of: String, low: usize, width: usize) -> Result<Expression, EmitError> {
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
        let signed = whole.signed;
        Ok(Expression {
            form,
            of: Type { width, signed },
        })
    }

    fn cast(&mut self, of: &VerilogExpression, width: usize) -> Result<Expression, EmitError> {
        let of = self.expression(of)?;
        let name = self.named(of);
        let whole = self.of(&name)?;
        if width <= whole.width {
            return self.bits(name, 0, width);
        }
        Ok(Expression {
            form: Form::Extended(name, whole),
            of: Type {
                width,
                signed: whole.signed,
            },
        })
    }

    /// Bits read as a number, and lengthened with their sign to the width of what they are assigned to: rust-hdl's `$signed`, which
    /// states no width.
    fn lengthened(
        &mut self,
        of: &VerilogExpression,
        width: usize,
    ) -> Result<Expression, EmitError> {
        let value = read_as(self.expression(of)?, true);
        if value.of.width >= width {
            return Ok(value);
        }
        let name = self.named(value);
        let narrow = Type {
            signed: true,
            ..self.of(&name)?
        };
        Ok(Expression {
            form: Form::Extended(name, narrow),
            of: Type {
                width,
                signed: true,
            },
        })
    }

    fn expression(&mut self, expression: &VerilogExpression) -> Result<Expression, EmitError> {
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
            VerilogExpression::Slice(of, width, low) => self.cut(of, low, *width),
            VerilogExpression::Index(of, place) => Ok(read_as(self.cut(of, place, 1)?, false)),
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

    fn cut(
        &mut self,
        of: &VerilogExpression,
        low: &VerilogExpression,
        width: usize,
    ) -> Result<Expression, EmitError> {
        let low = self.index(low)?;
        let of = self.expression(of)?;
        let name = self.named(of);
        self.bits(name, low, width)
    }

    /// True for a shift by nothing, which is no operation.
    fn is_zero(&self, value: &Expression) -> bool {
        match &value.form {
            Form::Literal(0) => true,
            Form::Name(name) => matches!(self.names[name].role, Role::Constant(0)),
            _ => false,
        }
    }

    fn unary(
        &mut self,
        operation: &VerilogOpUnary,
        operand: &VerilogExpression,
    ) -> Result<Expression, EmitError> {
        let mut operand = self.expression(operand)?;
        let (operator, of) = match operation {
            VerilogOpUnary::Not => ("~", operand.of),
            VerilogOpUnary::Neg => ("-", operand.of),
            VerilogOpUnary::All => ("&", BIT),
            VerilogOpUnary::Any => ("|", BIT),
            VerilogOpUnary::Xor => ("^", BIT),
        };
        if operator == "-" || is_product(&operand) {
            operand = self.operand(operand);
        }
        Ok(Expression {
            form: Form::Unary(operator, Box::new(operand)),
            of,
        })
    }

    fn binary(
        &mut self,
        left: &VerilogExpression,
        operation: &VerilogOp,
        right: &VerilogExpression,
    ) -> Result<Expression, EmitError> {
        let mut left = self.expression(left)?;
        let mut right = self.expression(right)?;
        let operator = operator(operation);
        if matches!(operator, "<<" | ">>") && self.is_zero(&right) {
            return Ok(left);
        }
        let is_bitwise = matches!(operator, "&" | "|" | "^");
        if !is_bitwise || is_product(&left) || is_product(&right) {
            left = self.operand(left);
            right = self.operand(right);
        }
        let same_width = left.of.width == right.of.width;
        let same_type = left.of == right.of;
        let of = match operator {
            "&" | "|" | "^" if same_width => Type {
                width: left.of.width,
                signed: left.of.signed && right.of.signed,
            },
            "==" | "!=" if same_type => BIT,
            "<" | "<=" | ">" | ">=" if same_type => BIT,
            "+" | "-" if same_type => left.of,
            "<<" | ">>" if !left.of.signed => left.of,
            "*" if same_type => Type {
                width: 2 * left.of.width,
                signed: left.of.signed,
            },
            _ => return Err(EmitError::mixed(operator)),
        };
        Ok(Expression {
            form: Form::Binary(Box::new(left), operator, Box::new(right)),
            of,
        })
    }
}

/// A product takes its width from its context, so it must stand alone.
fn is_product(value: &Expression) -> bool {
    matches!(value.form, Form::Binary(_, "*", _))
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
