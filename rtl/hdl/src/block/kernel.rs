//! The kernel of a module: statements of rust-hdl, one for each net.

use crate::build::{described, refuse};
use crate::tree::{Binary, Direction, Module, Net, Op};
use rust_hdl::core::ast::{
    VerilogBlock, VerilogBlockOrConditional, VerilogConditional, VerilogExpression, VerilogLiteral,
    VerilogOp, VerilogOpUnary, VerilogStatement,
};

pub(super) fn net_name(net: Net) -> String {
    format!("net_{}", net.0)
}

pub(super) fn register_name(index: usize) -> String {
    format!("register_{index}")
}

fn signal(name: impl Into<String>) -> VerilogExpression {
    VerilogExpression::Signal(name.into())
}

fn of_net(net: Net) -> VerilogExpression {
    signal(net_name(net))
}

fn set(name: impl Into<String>, value: VerilogExpression) -> VerilogStatement {
    VerilogStatement::Assignment(signal(name), value)
}

pub(super) fn literal(value: u64) -> VerilogLiteral {
    VerilogLiteral::from(value)
}

fn constant(value: u64) -> VerilogExpression {
    VerilogExpression::Literal(literal(value))
}

fn binary(a: VerilogExpression, op: VerilogOp, b: VerilogExpression) -> VerilogExpression {
    VerilogExpression::Binary(Box::new(a), op, Box::new(b))
}

fn not(a: VerilogExpression) -> VerilogExpression {
    VerilogExpression::Unary(VerilogOpUnary::Not, Box::new(a))
}

fn paren(a: VerilogExpression) -> VerilogExpression {
    VerilogExpression::Paren(Box::new(a))
}

fn choice(
    test: VerilogExpression,
    one: VerilogStatement,
    other: VerilogStatement,
) -> VerilogStatement {
    VerilogStatement::If(VerilogConditional {
        test,
        then: vec![one],
        otherwise: VerilogBlockOrConditional::Block(vec![other]),
    })
}

/// The statements of a module, none before those whose nets it reads.
pub(super) fn kernel(module: &Module) -> VerilogBlock {
    let mut code = vec![];
    for net in sorted(module) {
        code.push(statement(module, net));
    }
    for (index, register) in module.registers.iter().enumerate() {
        let name = register_name(index);
        let next = of_net(register.next.expect("a closed module has all inputs"));
        let d = format!("{name}.d");
        code.push(set(format!("{name}.clock"), signal("clock")));
        code.push(match register.enable {
            Some(enable) => choice(
                of_net(enable),
                set(d.clone(), next),
                set(d, of_net(register.net)),
            ),
            None => set(d, next),
        });
    }
    for memory in &module.memories {
        let name = &memory.name;
        code.push(set(format!("{name}.clock"), signal("clock")));
        let inputs = ["write", "at", "data"].into_iter().zip(memory.write);
        for (pin, net) in inputs.chain([("read", memory.address)]) {
            code.push(set(format!("{name}.{pin}"), of_net(net)));
        }
    }
    for instance in &module.instances {
        let name = &instance.name;
        if instance.module.is_clocked() {
            code.push(set(format!("{name}.clock"), signal("clock")));
        }
        for (port, net) in instance
            .module
            .ports_of(Direction::In)
            .zip(&instance.inputs)
        {
            code.push(set(format!("{name}.{}", port.name), of_net(*net)));
        }
    }
    for port in module.ports_of(Direction::Out) {
        code.push(set(&port.name, of_net(port.net)));
    }
    code
}

/// Nets behind those that they are computed from.
fn sorted(module: &Module) -> Vec<Net> {
    let mut order = vec![];
    let mut is_open = vec![false; module.nodes.len()];
    let mut is_done = vec![false; module.nodes.len()];
    for start in 0..module.nodes.len() {
        let mut open = vec![Net(start as u32)];
        while let Some(&net) = open.last() {
            let index = net.0 as usize;
            if is_done[index] {
                open.pop();
            } else if is_open[index] {
                open.pop();
                is_done[index] = true;
                order.push(net);
            } else {
                is_open[index] = true;
                for operand in module.node(net).op.operands() {
                    let operand_index = operand.0 as usize;
                    if !is_done[operand_index] {
                        if is_open[operand_index] {
                            refuse(format!("{} depends on itself", described(module, operand)));
                        }
                        open.push(operand);
                    }
                }
            }
        }
    }
    order
}

fn statement(module: &Module, net: Net) -> VerilogStatement {
    let node = module.node(net);
    let own = net_name(net);
    let value = match &node.op {
        Op::Input => {
            let port = module.ports.iter().find(|port| port.net == net);
            signal(&port.expect("an input is a port").name)
        }
        Op::Literal(value) => constant(*value),
        Op::Not(a) => not(of_net(*a)),
        Op::Binary(operation, a, b) => {
            let is_signed = module.node(*a).signed;
            if *operation == Binary::Right && is_signed {
                // rust-hdl has no arithmetic shift: a negative number is inverted before and after.
                let shifted = binary(of_net(*a), VerilogOp::Shr, of_net(*b));
                let inverse = paren(not(of_net(*a)));
                let negative = not(paren(binary(inverse, VerilogOp::Shr, of_net(*b))));
                let sign = binary(of_net(*a), VerilogOp::Lt, constant_signed());
                return choice(sign, set(own.clone(), negative), set(own, shifted));
            }
            let op = match operation {
                Binary::Add => VerilogOp::Add,
                Binary::Sub => VerilogOp::Sub,
                Binary::Mul => VerilogOp::Mul,
                Binary::And => VerilogOp::BitAnd,
                Binary::Or => VerilogOp::BitOr,
                Binary::Xor => VerilogOp::BitXor,
                Binary::Left => VerilogOp::Shl,
                Binary::Right => VerilogOp::Shr,
                Binary::Equal => VerilogOp::Eq,
                Binary::Less => VerilogOp::Lt,
            };
            binary(of_net(*a), op, of_net(*b))
        }
        Op::Select(which, a, b) => {
            return choice(
                of_net(*which),
                set(own.clone(), of_net(*a)),
                set(own, of_net(*b)),
            );
        }
        Op::Slice(a, low) => {
            let offset = Box::new(constant(u64::from(*low)));
            VerilogExpression::Slice(Box::new(of_net(*a)), node.width as usize, offset)
        }
        Op::Join(parts) => {
            let mut joined: Option<VerilogExpression> = None;
            for part in parts {
                let width = constant(u64::from(module.node(*part).width));
                joined = Some(match joined {
                    None => of_net(*part),
                    Some(above) => paren(binary(
                        paren(binary(above, VerilogOp::Shl, width)),
                        VerilogOp::BitOr,
                        of_net(*part),
                    )),
                });
            }
            joined.expect("a join has parts")
        }
        Op::Extend(a) | Op::Same(a) | Op::Forward(Some(a)) => of_net(*a),
        Op::Register(index) => signal(format!("{}.q", register_name(*index))),
        Op::Output(instance, output) => {
            let instance = &module.instances[*instance];
            let port = instance.module.ports_of(Direction::Out).nth(*output);
            let port = &port.expect("an output of the instance").name;
            signal(format!("{}.{port}", instance.name))
        }
        Op::Read(memory) => signal(format!("{}.q", module.memories[*memory].name)),
        Op::Forward(None) => refuse(format!("{} is driven by nothing", described(module, net))),
    };
    set(own, value)
}

/// A zero that leaves a comparison signed.
fn constant_signed() -> VerilogExpression {
    VerilogExpression::Signed(Box::new(constant(0)))
}
