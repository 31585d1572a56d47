//! How often and where nets are read.

use crate::tree::{Binary, Direction, Module, Net, Op};
use crate::value::mask;
use std::collections::HashSet;

/// How nets are read.
pub(super) struct Reads {
    /// How often.
    pub(super) counts: Vec<usize>,
    /// The bits that are.
    pub(super) bits: Vec<u64>,
    /// Verilog needs a name there.
    pub(super) by_name: Vec<bool>,
    /// The first reader: what it is called, and by what operation.
    pub(super) readers: Vec<Option<Reader>>,
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
    let instances = module
        .instances
        .iter()
        .flat_map(|i| i.inputs.iter().copied());
    let mut open: Vec<Net> = outputs.chain(memories).chain(instances).collect();
    let mut live = vec![false; module.nodes.len()];
    while let Some(net) = open.pop() {
        if std::mem::replace(&mut live[net.0 as usize], true) {
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

impl Reads {
    pub(super) fn of(module: &Module) -> Reads {
        let count = module.nodes.len();
        let mut reads = Reads {
            counts: vec![0; count],
            bits: vec![0; count],
            by_name: vec![false; count],
            readers: vec![None; count],
        };
        for port in module.ports_of(Direction::Out) {
            reads.whole(module, port.net, Reader::Named(port.name.clone()));
        }
        let live = live(module);
        let mut enables = HashSet::new();
        let registers = module.registers.iter();
        for register in registers.filter(|register| live[register.net.0 as usize]) {
            let next = register.next.expect("a closed module has all inputs");
            // Registers with the same enable stand behind one `if`.
            let enable = register.enable.filter(|enable| enables.insert(*enable));
            for net in [Some(next), enable].into_iter().flatten() {
                reads.whole(module, net, Reader::Net(register.net));
            }
        }
        for memory in &module.memories {
            for net in memory.write.into_iter().chain([memory.address]) {
                reads.whole(module, net, Reader::Named(memory.name.clone()));
                reads.by_name[net.0 as usize] = true;
            }
        }
        for instance in &module.instances {
            let ports = instance.module.ports_of(Direction::In);
            for (net, port) in instance.inputs.iter().zip(ports) {
                let reader = format!("{}_{}", instance.name, port.name);
                reads.whole(module, *net, Reader::Named(reader));
            }
        }
        // What nobody reads, reads nothing. A forward value reads what stands behind it: that has another turn.
        let mut is_done = vec![false; count];
        let next = |reads: &Reads, is_done: &[bool], end: usize| {
            (0..end)
                .rev()
                .find(|index| reads.counts[*index] > 0 && !is_done[*index])
        };
        let mut end = count;
        while let Some(index) =
            next(&reads, &is_done, end).or_else(|| next(&reads, &is_done, count))
        {
            is_done[index] = true;
            reads.operands(module, Net(index as u32));
            end = index;
        }
        reads
    }

    fn whole(&mut self, module: &Module, net: Net, reader: Reader) {
        self.part(net, mask(module.node(net).width), reader);
    }

    fn part(&mut self, net: Net, bits: u64, reader: Reader) {
        let index = net.0 as usize;
        self.counts[index] += 1;
        self.bits[index] |= bits;
        self.readers[index].get_or_insert(reader);
    }

    fn operands(&mut self, module: &Module, net: Net) {
        let node = module.node(net);
        let reader = Reader::Net(net);
        if let Op::Slice(a, low) = &node.op {
            self.part(*a, mask(node.width) << low, reader);
            self.by_name[a.0 as usize] = true;
            return;
        }
        for operand in node.op.operands() {
            self.whole(module, operand, reader.clone());
        }
        let by_name: &[Net] = match &node.op {
            Op::Extend(a) => &[*a],
            Op::Binary(Binary::Less | Binary::Right | Binary::Mul, a, b) => &[*a, *b],
            _ => &[],
        };
        for operand in by_name
            .iter()
            .filter(|operand| module.node(**operand).signed)
        {
            self.by_name[operand.0 as usize] = true;
        }
    }
}
