//! A module without those inside it.

use crate::controls::walk;
use crate::frame::Begin;
use crate::gates::{Gates, NO};
use crate::idle::Idle;
use crate::known::Contract;
use imogene_hdl::{Design, Direction, Instance, Levels, Module, Net, Op, PortRecord};
use std::collections::HashMap;
use std::sync::Arc;

/// A module as a design of its own: what an instance inside gives becomes an input, and what it takes an output.
///
/// Its nets and registers keep their numbers. A change of the module that makes no difference here makes none in any
/// design: every instance is given the same, and so gives the same.
pub fn alone(module: &Module) -> Design {
    let mut own = module.clone();
    let (mut inputs, mut outputs) = (vec![], vec![]);
    for Instance {
        name,
        module: inner,
        inputs: taken,
        outputs: given,
    } in std::mem::take(&mut own.instances)
    {
        let port = |port: &PortRecord, net: Net, direction| PortRecord {
            name: format!("{name}.{}", port.name),
            direction,
            net,
            ..port.clone()
        };
        let ports = inner.ports_of(Direction::In).zip(taken);
        outputs.extend(ports.map(|(from, net)| port(from, net, Direction::Out)));
        let ports = inner.ports_of(Direction::Out).zip(given);
        inputs.extend(ports.map(|(from, net)| {
            own.nodes[net.0].op = Op::Input;
            port(from, net, Direction::In)
        }));
    }
    inputs.append(&mut own.ports);
    inputs.append(&mut outputs);
    inputs.sort_by_key(|port| port.direction == Direction::Out);
    own.ports = inputs;
    Design { top: Arc::new(own) }
}

/// What is known of every place in a design whatever its inputs are.
pub struct Around<'a> {
    design: &'a Design,
    /// Bits that are always 0, by the path of a port or a net.
    zeros: HashMap<String, u64>,
}

impl Around<'_> {
    /// Of a design from power-up on.
    pub fn of(design: &Design) -> Around<'_> {
        let levels = Arc::new(Levels::of(design));
        let registers: Vec<usize> = (0..levels.flops.len()).collect();
        let mut gates = Gates::new();
        let any = Begin::any(&levels, &mut gates);
        let begin = Idle::of(&levels, &[], &[]).begin(any, &registers);
        let frame = begin.clock(&mut gates);
        let zeros = levels.points.iter().map(|(path, point)| {
            let word = frame.at(point.place).iter().enumerate();
            let others = word.filter(|(_, bit)| **bit != NO);
            let others = others.fold(0, |bits, (index, _)| bits | 1 << index);
            (path.clone(), !others)
        });
        Around {
            design,
            zeros: zeros.collect(),
        }
    }

    /// What a module of it may rely on [`alone`], in every instance.
    pub fn contract(&self, module: &Arc<Module>) -> Contract {
        let mut paths = vec![];
        walk(&self.design.top, "", &mut 0, &mut |instance, path, _| {
            if Arc::ptr_eq(instance, module) {
                paths.push(path.to_owned());
            }
        });
        let own = alone(module);
        let zeros = own.top.ports_of(Direction::In).flat_map(|port| {
            let at = |path| self.zeros.get(&format!("{path}{}", port.name)).copied();
            let zeros = paths.iter().map(at);
            let zeros = zeros.fold(u64::MAX, |all, bits| all & bits.unwrap_or(0));
            let bits = (0..port.width).filter(move |bit| zeros >> bit & 1 == 1);
            bits.map(|bit| (port.name.clone(), bit))
        });
        Contract {
            zeros: zeros.collect(),
            ..Contract::default()
        }
    }
}
