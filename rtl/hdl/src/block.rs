//! A module as a block of rust-hdl.
//!
//! Nets are its atoms, instances and registers its sub-blocks, operations the statements of its kernel, one for each
//! net. So rust-hdl's own check and its own printer run on every circuit. Its simulation would only call ours, and is
//! empty here.

mod kernel;

use crate::tree::{Direction, Module, Node};
use kernel::{kernel, memory_pins, net_name, register_name};
use rust_hdl::core::ast::{Verilog, VerilogLiteral};
use rust_hdl::core::prelude::{
    Atom, AtomKind, Logic, PinConstraint, Probe, TypeDescriptor, TypeKind, VCDValue,
};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A module, a register or a memory as a block.
pub struct Block {
    atoms: Vec<(String, Pin)>,
    parts: Vec<(String, Block)>,
    kernel: Verilog,
}

/// A net or a port.
struct Pin {
    width: u32,
    signed: bool,
    kind: AtomKind,
    id: usize,
}

impl Atom for Pin {
    fn bits(&self) -> usize {
        self.width as usize
    }

    fn connected(&self) -> bool {
        // A design has no net that is not driven.
        true
    }

    fn changed(&self) -> bool {
        false
    }

    fn kind(&self) -> AtomKind {
        self.kind
    }

    fn descriptor(&self) -> TypeDescriptor {
        let width = self.width as usize;
        let (name, kind) = match self.signed {
            true => (format!("Signed::<{width}>"), TypeKind::Signed(width)),
            false => (format!("Bits::<{width}>"), TypeKind::Bits(width)),
        };
        TypeDescriptor { name, kind }
    }

    fn vcd(&self) -> VCDValue {
        VCDValue::Vector(vec![])
    }

    fn id(&self) -> usize {
        self.id
    }

    fn verilog(&self) -> VerilogLiteral {
        0u64.into()
    }

    fn constraints(&self) -> Vec<PinConstraint> {
        vec![]
    }
}

impl Logic for Block {
    fn update(&mut self) {}

    fn hdl(&self) -> Verilog {
        self.kernel.clone()
    }
}

impl rust_hdl::core::prelude::Block for Block {
    fn connect_all(&mut self) {}

    fn update_all(&mut self) {}

    fn has_changed(&self) -> bool {
        false
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        probe.visit_start_scope(name, self);
        for (name, pin) in &self.atoms {
            probe.visit_atom(name, pin);
        }
        for (name, part) in &self.parts {
            part.accept(name, probe);
        }
        probe.visit_end_scope(name, self);
    }
}

impl Block {
    /// The block of a module.
    ///
    /// # Panics
    ///
    /// With the name of a net that depends on itself within one clock.
    pub fn of(module: &Module) -> Block {
        let mut block = Block::with(Verilog::Combinatorial(kernel(module)), module.is_clocked());
        for port in &module.ports {
            let kind = match port.direction {
                Direction::In => AtomKind::InputParameter,
                Direction::Out => AtomKind::OutputParameter,
            };
            block.pin(&port.name, port.width, port.signed, kind);
        }
        for (net, node) in module.nets() {
            let name = net_name(net);
            block.pin(&name, node.width, node.signed, AtomKind::LocalSignal);
        }
        for (index, register) in module.registers.iter().enumerate() {
            let (own, initial) = (module.node(register.net), register.initial);
            let width = own.width;
            let text =
                format!("initial q = {width}'h{initial:x};\nalways @(posedge clock) q <= d;\n");
            let part = Block::leaf(text, &[("d", own)], own);
            block.parts.push((register_name(index), part));
        }
        for memory in &module.memories {
            let (last, top) = (memory.words - 1, memory.width - 1);
            let contents = memory.contents.iter().enumerate();
            let contents: String = contents
                .map(|(place, word)| format!("words[{place}] = {word};\n"))
                .collect();
            let text = format!(
                "reg [{top}:0] words [0:{last}];\ninteger place;\n\
                 initial begin\nq = 0;\nfor (place = 0; place <= {last}; place = place + 1) words[place] = 0;\n\
                 {contents}end\nalways @(posedge clock) begin\nq <= words[read];\nif (write) words[at] <= data;\nend\n"
            );
            let inputs = memory_pins(memory).map(|(pin, net)| (pin, module.node(net)));
            let part = Block::leaf(text, &inputs, module.node(memory.net));
            block.parts.push((memory.name.clone(), part));
        }
        for instance in &module.instances {
            let part = Block::of(&instance.module);
            block.parts.push((instance.name.clone(), part));
        }
        block
    }

    fn with(kernel: Verilog, is_clocked: bool) -> Block {
        let mut block = Block {
            atoms: vec![],
            parts: vec![],
            kernel,
        };
        if is_clocked {
            block.pin("clock", 1, false, AtomKind::InputParameter);
        }
        block
    }

    /// A register or a memory: its text, its inputs, its output `q`.
    fn leaf(text: String, inputs: &[(&str, &Node)], output: &Node) -> Block {
        let mut block = Block::with(Verilog::Custom(text), true);
        for (name, input) in inputs {
            block.pin(name, input.width, input.signed, AtomKind::InputParameter);
        }
        block.pin("q", output.width, output.signed, AtomKind::OutputParameter);
        block
    }

    fn pin(&mut self, name: &str, width: u32, signed: bool, kind: AtomKind) {
        static PINS: AtomicUsize = AtomicUsize::new(0);
        let pin = Pin {
            width,
            signed,
            kind,
            id: PINS.fetch_add(1, Ordering::Relaxed),
        };
        self.atoms.push((name.to_owned(), pin));
    }
}
