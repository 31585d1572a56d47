//! The kernel of a module: statements of rust-hdl, one for each net.

use crate::scope::{described, refuse};
use crate::tree::{Binary, Direction, Memory, Module, Net, Op, in_order};
use rust_hdl::core::ast::{
    VerilogBlock, VerilogBlockOrConditional, VerilogConditional, VerilogExpression, VerilogOp,
    VerilogOpUnary, VerilogStatement,
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

fn constant(value: u64) -> VerilogExpression {
    VerilogExpression::Literal(value.into())
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

/// The inputs of a memory and what they are connected with.
pub(super) fn memory_pins(memory: &Memory) -> [(&'static str, Net); 4] {
    let [write, at, data] = memory.write;
    let read = memory.address;
    [("write", write), ("at", at), ("data", data), ("read", read)]
}

/// The statements of a module, none before those whose nets it reads.
///
/// # Panics
///
/// With the name of a net that depends on itself.
pub(super) fn kernel(module: &Module) -> VerilogBlock {
    let operands = |index| module.node(Net(index)).op.operands().into_iter();
    let order = in_order(module.nodes.len(), |index| operands(index).map(|net| net.0));
    let order = order.unwrap_or_else(|index| {
        refuse!("{} depends on itself", described(module, Net(index)));
    });
    let nets = order.into_iter().map(Net);
    let mut code: VerilogBlock = nets.map(|net| statement(module, net)).collect();
    let clock = |part: &str| set(format!("{part}.clock"), signal("clock"));
    let connect = |part: &str, pin: &str, net| set(format!("{part}.{pin}"), of_net(net));
    for (index, register) in module.registers.iter().enumerate() {
        let name = register_name(index);
        let next = register.next.expect("a closed module has all inputs");
        let next = connect(&name, "d", next);
        code.push(clock(&name));
        code.push(match register.enable {
            Some(enable) => choice(of_net(enable), next, connect(&name, "d", register.net)),
            None => next,
        });
    }
    for memory in &module.memories {
        code.push(clock(&memory.name));
        code.extend(memory_pins(memory).map(|(pin, net)| connect(&memory.name, pin, net)));
    }
    for instance in &module.instances {
        let name = &instance.name;
        code.extend(instance.module.is_clocked().then(|| clock(name)));
        let inputs = instance.module.ports_of(Direction::In);
        let inputs = inputs.zip(&instance.inputs);
        code.extend(inputs.map(|(port, net)| connect(name, &port.name, *net)));
    }
    let outputs = module.ports_of(Direction::Out);
    code.extend(outputs.map(|port| set(&port.name, of_net(port.net))));
    code
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
                let zero = VerilogExpression::Signed(Box::new(constant(0)));
                let sign = binary(of_net(*a), VerilogOp::Lt, zero);
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
            let [one, other] = [a, b].map(|net| set(&own, of_net(*net)));
            return choice(of_net(*which), one, other);
        }
        Op::Slice(a, low) => {
            let offset = Box::new(constant(u64::from(*low)));
            VerilogExpression::Slice(Box::new(of_net(*a)), node.width as usize, offset)
        }
        Op::Join(parts) => {
            let behind = |above, part: &Net| {
                let width = constant(u64::from(module.node(*part).width));
                let above = paren(binary(above, VerilogOp::Shl, width));
                paren(binary(above, VerilogOp::BitOr, of_net(*part)))
            };
            parts[1..].iter().fold(of_net(parts[0]), behind)
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
        Op::Forward(None) => refuse!("{} is driven by nothing", described(module, net)),
    };
    set(own, value)
}
