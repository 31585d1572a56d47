//! How often and where nets are read.

use crate::tree::{Binary, Direction, Module, Net, Op};
use crate::value::mask;
use std::collections::HashSet;

/// How a net is read.
#[derive(Clone, Default)]
pub(super) struct Reads {
    /// How often.
    pub(super) count: usize,
    /// The bits that are.
    pub(super) bits: u64,
    /// Verilog needs a name there.
    pub(super) by_name: bool,
    /// The first reader: what it is called, and by what operation.
    pub(super) reader: Option<Reader>,
}

#[derive(Clone)]
pub(super) enum Reader {
    Net(Net),
    Named(String),
}

/// The nets on which an output, a memory or an instance depends, through registers too.
fn live(module: &Module) -> Vec<bool> {
    let outputs = module.ports_of(Direction::Out).map(|port| port.net);
    let memories = module.memories.iter();
    let memories = memories.flat_map(|memory| memory.write.into_iter().chain([memory.address]));
    let instances = module.instances.iter();
    let instances = instances.flat_map(|i| i.inputs.iter().copied());
    let mut open: Vec<Net> = outputs.chain(memories).chain(instances).collect();
    let mut live = vec![false; module.nodes.len()];
    while let Some(net) = open.pop() {
        if std::mem::replace(&mut live[net.0], true) {
            continue;
        }
        let op = &module.node(net).op;
        open.extend(op.operands());
        if let Op::Register(index) = op {
            let register = &module.registers[*index];
            open.extend(register.next.into_iter().chain(register.enable));
        }
    }
    live
}

/// How each net is read.
pub(super) fn reads(module: &Module) -> Vec<Reads> {
    let mut nets = Nets {
        module,
        reads: vec![Reads::default(); module.nodes.len()],
    };
    nets.outside();
    // What nobody reads, reads nothing. A forward value reads what stands behind it: that has another turn.
    let count = module.nodes.len();
    let mut is_done = vec![false; count];
    let mut end = count;
    loop {
        let is_next = |index: &usize| nets.reads[*index].count > 0 && !is_done[*index];
        let next = (0..end).rev().find(is_next);
        let Some(index) = next.or_else(|| (0..count).rev().find(is_next)) else {
            return nets.reads;
        };
        is_done[index] = true;
        nets.operands(Net(index));
        end = index;
    }
}

struct Nets<'a> {
    module: &'a Module,
    reads: Vec<Reads>,
}

impl Nets<'_> {
    /// What outputs, registers, memories and instances read.
    fn outside(&mut self) {
        let module = self.module;
        for port in module.ports_of(Direction::Out) {
            self.whole(port.net, Reader::Named(port.name.clone()));
        }
        let live = live(module);
        let mut enables = HashSet::new();
        let registers = module.registers.iter();
        for register in registers.filter(|register| live[register.net.0]) {
            let next = register.next.expect("a closed module has all inputs");
            // Registers with the same enable stand behind one `if`.
            let enable = register.enable.filter(|enable| enables.insert(*enable));
            for net in [Some(next), enable].into_iter().flatten() {
                self.whole(net, Reader::Net(register.net));
            }
        }
        for memory in &module.memories {
            for net in memory.write.into_iter().chain([memory.address]) {
                self.whole(net, Reader::Named(memory.name.clone()));
                self.reads[net.0].by_name = true;
            }
        }
        for instance in &module.instances {
            let ports = instance.module.ports_of(Direction::In);
            for (net, port) in instance.inputs.iter().zip(ports) {
                let reader = format!("{}_{}", instance.name, port.name);
                self.whole(*net, Reader::Named(reader));
            }
        }
    }

    fn whole(&mut self, net: Net, reader: Reader) {
        self.part(net, mask(self.module.node(net).width), reader);
    }

    fn part(&mut self, net: Net, bits: u64, reader: Reader) {
        let own = &mut self.reads[net.0];
        own.count += 1;
        own.bits |= bits;
        own.reader.get_or_insert(reader);
    }

    fn operands(&mut self, net: Net) {
        let node = self.module.node(net);
        let reader = Reader::Net(net);
        if let Op::Slice(a, low) = &node.op {
            self.part(*a, mask(node.width) << low, reader);
            self.reads[a.0].by_name = true;
            return;
        }
        for operand in node.op.operands() {
            self.whole(operand, reader.clone());
        }
        // Verilog takes the sign of a number here from its name.
        let is_exact = matches!(
            node.op,
            Op::Extend(_) | Op::Binary(Binary::Less | Binary::Right | Binary::Mul, ..)
        );
        for operand in node.op.operands().into_iter().filter(|_| is_exact) {
            self.reads[operand.0].by_name |= self.module.node(operand).signed;
        }
    }
}
