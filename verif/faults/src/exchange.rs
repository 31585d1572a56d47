//! Operators in the place of others.

use imogene_hdl::{Binary, Module, Net, Node, Op};

/// Another operator in the place of that of a node.
pub(crate) fn exchanged(module: &mut Module, node: &Node, beside: Net, which: usize) -> Net {
    let mut add = |op| add(module, op, (node.width, node.signed), beside);
    match node.op.clone() {
        Op::Binary(Binary::Mul, a, b) => {
            let (a, b) = (add(Op::Extend(a)), add(Op::Extend(b)));
            add(Op::Binary(Binary::Add, a, b))
        }
        Op::Binary(Binary::Less, a, b) => {
            let turned = add(Op::Binary(Binary::Less, b, a));
            match which {
                0 => turned,
                _ => add(Op::Not(turned)),
            }
        }
        Op::Binary(binary, a, b) => add(Op::Binary(exchange(binary), a, b)),
        Op::Select(which, a, b) => add(Op::Select(which, b, a)),
        Op::Not(a) => add(Op::Same(a)),
        op => unreachable!("{op:?} has no exchange"),
    }
}

/// The operator in whose place another comes that has operands and result of the same widths.
fn exchange(binary: Binary) -> Binary {
    match binary {
        Binary::Sub | Binary::Mul => Binary::Add,
        Binary::Add => Binary::Sub,
        Binary::And | Binary::Xor => Binary::Or,
        Binary::Or => Binary::And,
        Binary::Left => Binary::Right,
        Binary::Right => Binary::Left,
        Binary::Equal | Binary::Less => Binary::Less,
    }
}

pub(crate) fn exchange_name(op: &Op, which: usize) -> &'static str {
    match (op, which) {
        (Op::Binary(Binary::Less, ..), 0) => "greater",
        (Op::Binary(Binary::Less, ..), _) => "not greater",
        (Op::Binary(binary, ..), _) => binary_name(exchange(*binary)),
        (Op::Select(..), _) => "the other choice",
        _ => "its operand",
    }
}

fn binary_name(binary: Binary) -> &'static str {
    match binary {
        Binary::Add => "sum",
        Binary::Sub => "difference",
        Binary::Mul => "product",
        Binary::And => "and",
        Binary::Or => "or",
        Binary::Xor => "exclusive or",
        Binary::Left => "left shift",
        Binary::Right => "right shift",
        Binary::Equal => "equal",
        Binary::Less => "less",
    }
}

/// What a net without a name is called.
pub(crate) fn operation(op: &Op) -> &'static str {
    match op {
        Op::Binary(binary, ..) => binary_name(*binary),
        Op::Literal(_) => "constant",
        Op::Not(_) => "inverse",
        Op::Select(..) => "choice",
        Op::Slice(..) => "slice",
        Op::Join(_) => "join",
        Op::Extend(_) => "extension",
        Op::Register(_) => "register",
        Op::Read(_) => "memory",
        _ => "net",
    }
}

/// Another net of a module, of this width and sign, that stands beside one.
pub(crate) fn add(module: &mut Module, op: Op, (width, signed): (u32, bool), beside: Net) -> Net {
    let place = module.node(beside).place;
    module.nodes.push(Node {
        op,
        width,
        signed,
        name: None,
        place,
    });
    Net(module.nodes.len() - 1)
}
