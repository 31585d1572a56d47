//! Where a circuit can be changed, and the operators that come in the place of others.

use imogene_hdl::{Binary, Design, Direction, Module, Net, Node, Op};
use std::sync::Arc;

/// A place in a module where something can be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Site {
    /// Module, by its place in [`Module::all`] of the top.
    pub module: usize,
    /// What can be changed.
    pub kind: SiteKind,
}

/// What can be changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SiteKind {
    /// The bits of a net.
    Bits(Net),
    /// The operator of a net, by another, of which there may be several.
    Operator(Net, usize),
    /// The enable of a register.
    Enable(usize),
    /// What a register begins with.
    Initial(usize),
}

impl Site {
    /// Is it what a register begins with?
    pub fn is_of_power_up(&self) -> bool {
        matches!(self.kind, SiteKind::Initial(_))
    }
}

/// What all registers of a design begin with.
pub fn power_up(design: &Design) -> Vec<Site> {
    let modules = design.top.all().into_iter().enumerate();
    let sites = modules.flat_map(|(module, tree)| {
        let kinds = (0..tree.registers.len()).map(SiteKind::Initial);
        kinds.map(move |kind| Site { module, kind })
    });
    sites.collect()
}

/// Every other site of a design: nets from which a way leads to an output of their module, but for those that are only
/// another name; the registers and operators among them.
pub fn sites(design: &Design) -> Vec<Site> {
    let mut found = vec![];
    for (module, tree) in design.top.all().iter().enumerate() {
        let lives = live(tree);
        let is_top = Arc::ptr_eq(tree, &design.top);
        let mut add = |kind| found.push(Site { module, kind });
        for (net, node) in tree.nets().filter(|(net, _)| lives[net.0]) {
            let is_other_name = match node.op {
                Op::Same(_) | Op::Forward(_) | Op::Output(..) => true,
                // A port carries the bits of the net around it.
                Op::Input => !is_top,
                _ => false,
            };
            if !is_other_name {
                add(SiteKind::Bits(net));
            }
            (0..exchanges(&node.op)).for_each(|which| add(SiteKind::Operator(net, which)));
        }
        for (index, register) in tree.registers.iter().enumerate() {
            if register.enable.is_some() && lives[register.net.0] {
                add(SiteKind::Enable(index));
            }
        }
    }
    found
}

/// By how many others an operator is exchanged.
fn exchanges(op: &Op) -> usize {
    match op {
        Op::Binary(Binary::Less, ..) => 2,
        Op::Binary(..) | Op::Select(..) | Op::Not(_) => 1,
        _ => 0,
    }
}

/// The nets of a module from which a way leads to one of its outputs.
fn live(module: &Module) -> Vec<bool> {
    let mut lives = vec![false; module.nodes.len()];
    let outputs = module.ports_of(Direction::Out);
    let mut open: Vec<Net> = outputs.map(|port| port.net).collect();
    while let Some(net) = open.pop() {
        if std::mem::replace(&mut lives[net.0], true) {
            continue;
        }
        let op = &module.node(net).op;
        open.extend(op.operands());
        match op {
            Op::Register(index) => {
                let register = &module.registers[*index];
                open.extend(register.next.into_iter().chain(register.enable));
            }
            Op::Read(index) => {
                let memory = &module.memories[*index];
                open.extend(memory.write.into_iter().chain([memory.address]));
            }
            Op::Output(index, _) => open.extend(&module.instances[*index].inputs),
            _ => {}
        }
    }
    lives
}

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
