//! What nets are called.

use super::reads::{Reader, Reads, reads};
use super::rows::{self, Row};
use super::text::Name;
use crate::scope::is_reserved;
use crate::tree::{Binary, Direction, Module, Net, Node, Op};
use std::collections::HashSet;

/// What each net is called where it is declared.
pub(super) struct Names {
    pub(super) names: Vec<Option<Name>>,
    pub(super) unread: Vec<(Net, u32, u32)>,
    pub(super) rows: Vec<Row>,
    /// Of each memory.
    pub(super) memories: Vec<String>,
    /// Inputs, and outputs that are nets, not copies of others.
    pub(super) ports: HashSet<String>,
}

impl Names {
    pub(super) fn of(module: &Module) -> Names {
        let reads = reads(module);
        let mut taken = HashSet::from(["clock", "k", "place", "unused"].map(str::to_owned));
        let mut names: Vec<Option<Name>> = vec![None; module.nodes.len()];
        let mut own = |wanted: &str| {
            let mut name = wanted.to_owned();
            let mut number = 1;
            while is_reserved(&name) || !taken.insert(name.clone()) {
                number += 1;
                name = format!("{wanted}_{number}");
            }
            name
        };
        let mut ports = HashSet::new();
        for port in &module.ports {
            own(&port.name);
            if port.direction == Direction::In {
                names[port.net.0] = Some(Name::whole(port.name.clone()));
                ports.insert(port.name.clone());
            }
        }
        let rows = rows::of(module);
        for instance in &module.instances {
            own(&instance.name);
        }
        let memories = module.memories.iter().map(|memory| own(&memory.name));
        let memories = memories.collect();
        for row in &rows {
            own(&row.base);
            row.name_outputs(module, &mut names);
        }
        // What has no name and drives a port is called as the port.
        for port in module.ports_of(Direction::Out) {
            let own = &mut names[port.net.0];
            if own.is_none() && may_be_port(module.node(port.net)) {
                *own = Some(Name::whole(port.name.clone()));
                ports.insert(port.name.clone());
            }
        }
        for (net, node) in module.nets() {
            let is_wanted = reads[net.0].count > 0 && names[net.0].is_none();
            if let (true, Some(name)) = (is_wanted, &node.name) {
                names[net.0] = Some(Name::whole(own(name)));
            }
        }
        for instance in &module.instances {
            let ports = instance.module.ports_of(Direction::Out);
            for (net, port) in instance.outputs.iter().zip(ports) {
                let is_read = reads[net.0].count > 0;
                let unused = if is_read { "" } else { "unused_" };
                names[net.0].get_or_insert_with(|| {
                    let name = format!("{unused}{}_{}", instance.name, port.name);
                    Name::whole(own(&name))
                });
            }
        }
        // Readers have larger numbers than what they read, but for registers and forward values.
        for (net, node) in module.nets().rev() {
            let reads = &reads[net.0];
            if names[net.0].is_none() && needs_name(&node.op, reads) {
                let reader = match reads.reader.as_ref() {
                    Some(Reader::Net(reader)) => names[reader.0].as_ref().map(|name| &name.text),
                    Some(Reader::Named(name)) => Some(name),
                    None => None,
                };
                let word = word_of(&node.op);
                let name = reader.map_or(word.to_owned(), |reader| format!("{reader}_{word}"));
                names[net.0] = Some(Name::whole(own(&name)));
            }
        }
        Names {
            unread: unread(module, &reads, &names),
            names,
            rows,
            memories,
            ports,
        }
    }

    pub(super) fn get(&self, net: Net) -> Option<&Name> {
        self.names[net.0].as_ref()
    }
}

/// The bits of declared nets that nobody reads.
fn unread(module: &Module, reads: &[Reads], names: &[Option<Name>]) -> Vec<(Net, u32, u32)> {
    let mut found = vec![];
    for (net, node) in module.nets() {
        let name = names[net.0].as_ref();
        let is_declared = name.is_some_and(|name| !name.text.starts_with("unused_"));
        let mut bit = 0;
        while is_declared && bit < node.width {
            let is_read = |bit: u32| reads[net.0].bits >> bit & 1 == 1;
            let end = (bit..node.width).find(|next| is_read(*next) != is_read(bit));
            let end = end.unwrap_or(node.width);
            if !is_read(bit) {
                found.push((net, end - 1, bit));
            }
            bit = end;
        }
    }
    found
}

/// Is the net of an output the port itself, not a copy of a value with another name?
fn may_be_port(node: &Node) -> bool {
    let is_other = matches!(
        node.op,
        Op::Input | Op::Literal(_) | Op::Slice(..) | Op::Same(_)
    );
    node.name.is_none() && !is_other
}

fn needs_name(op: &Op, reads: &Reads) -> bool {
    match op {
        _ if reads.count == 0 => false,
        // A product has the width of what it is assigned to.
        Op::Register(_) | Op::Read(_) | Op::Binary(Binary::Mul, ..) => true,
        Op::Literal(_) => false,
        // Other names of a value cost nothing to repeat.
        Op::Slice(..) | Op::Same(_) => reads.by_name,
        _ => reads.by_name || reads.count > 1,
    }
}

fn word_of(op: &Op) -> &'static str {
    match op {
        Op::Binary(Binary::Add, ..) => "sum",
        Op::Binary(Binary::Sub, ..) => "difference",
        Op::Binary(Binary::Mul, ..) => "product",
        Op::Binary(Binary::Left | Binary::Right, ..) => "shifted",
        Op::Binary(Binary::Equal | Binary::Less, ..) => "test",
        Op::Binary(..) => "bits",
        Op::Not(_) => "inverse",
        Op::Select(..) => "choice",
        Op::Slice(..) => "part",
        Op::Join(_) => "joined",
        Op::Extend(_) => "wide",
        Op::Same(_) => "word",
        Op::Register(_) => "kept",
        Op::Read(_) => "read",
        _ => "value",
    }
}
