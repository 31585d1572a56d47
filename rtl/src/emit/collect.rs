//! From a block to a tree of scopes: names, widths, signs and kernels, as rust-hdl shows them to a probe.

use super::EmitError;
use super::names::literal;
use crate::kernel::BLOCK_MEMORY;
use rust_hdl::core::ast::{Verilog, VerilogBlock, VerilogStatement};
use rust_hdl::core::prelude::{Atom, AtomKind, Block, Probe, TypeKind, check_all};

/// One signal or constant of a scope.
pub struct Net {
    pub name: String,
    pub kind: AtomKind,
    pub width: usize,
    pub signed: bool,
    pub value: u64,
}

/// What a block does.
pub enum Kernel {
    /// A kernel of statements, in a module of this name.
    Statements { unit: String, code: VerilogBlock },
    /// A register: `q` takes `d` at the rising edge of `clock`.
    Register,
    /// A block memory with so many bits of address, in a module of its own.
    Memory(usize),
}

/// A block with its signals and sub-blocks.
pub struct Scope {
    pub instance: String,
    pub nets: Vec<Net>,
    pub children: Vec<Scope>,
    pub kernel: Result<Kernel, EmitError>,
}

impl Scope {
    /// The block is a register.
    pub fn is_register(&self) -> bool {
        matches!(self.kernel, Ok(Kernel::Register))
    }

    /// The module that it is an instance of, if it is not a register.
    pub fn unit(&self) -> Option<&str> {
        match &self.kernel {
            Ok(Kernel::Statements { unit, .. }) => Some(unit),
            Ok(Kernel::Memory(_)) => Some(MEMORY_UNIT),
            _ => None,
        }
    }

    /// A signal by name.
    pub fn net(&self, name: &str) -> Option<&Net> {
        self.nets.iter().find(|net| net.name == name)
    }
}

#[derive(Default)]
struct Collector {
    open: Vec<Scope>,
    done: Option<Scope>,
}

impl Probe for Collector {
    fn visit_start_scope(&mut self, name: &str, block: &dyn Block) {
        self.open.push(Scope {
            instance: name.to_owned(),
            nets: Vec::new(),
            children: Vec::new(),
            kernel: kernel(name, block.hdl()),
        });
    }

    fn visit_atom(&mut self, name: &str, signal: &dyn Atom) {
        let scope = self.open.last_mut().expect("a signal lies in a block");
        scope.nets.push(Net {
            name: name.to_owned(),
            kind: signal.kind(),
            width: signal.bits(),
            signed: matches!(signal.descriptor().kind, TypeKind::Signed(_)),
            value: literal(&signal.verilog()).1,
        });
    }

    fn visit_end_scope(&mut self, _name: &str, _block: &dyn Block) {
        let scope = self.open.pop().expect("a scope that ends was open");
        match self.open.last_mut() {
            Some(parent) => parent.children.push(scope),
            None => self.done = Some(scope),
        }
    }
}

/// The text rust-hdl prints for its register, around the initial value.
const REGISTER: [&str; 2] = [
    "initial begin\n   q = ",
    "always @(posedge clock) begin\n   q <= d;\nend",
];

/// The unit whose modules are block memories.
pub const MEMORY_UNIT: &str = "block_memory";

fn kernel(name: &str, code: Verilog) -> Result<Kernel, EmitError> {
    match code {
        Verilog::Combinatorial(code) => {
            let unit = code
                .iter()
                .find_map(module_name)
                .ok_or_else(|| EmitError::block(name, "names no module"))?;
            Ok(Kernel::Statements { unit, code })
        }
        Verilog::Custom(text) if REGISTER.iter().all(|part| text.contains(part)) => {
            Ok(Kernel::Register)
        }
        Verilog::Custom(text) if text.starts_with(BLOCK_MEMORY) => {
            let bits = text[BLOCK_MEMORY.len()..].parse();
            bits.map(Kernel::Memory)
                .map_err(|_| EmitError::block(name, "is a memory of unknown size"))
        }
        _ => Err(EmitError::block(
            name,
            "is neither a kernel nor a register nor a memory",
        )),
    }
}

fn module_name(statement: &VerilogStatement) -> Option<String> {
    match statement {
        VerilogStatement::Comment(text) => Some(text.split('"').nth(1).unwrap_or(text).to_owned()),
        _ => None,
    }
}

/// Connects a block, lets rust-hdl check it (undriven signals, loops, writes to inputs) and collects it.
pub fn collect<B: Block>(mut block: B) -> Result<Scope, EmitError> {
    block.connect_all();
    check_all(&block)
        .map_err(|error| EmitError::block("top", &format!("fails rust-hdl's checks: {error:?}")))?;
    let mut collector = Collector::default();
    block.accept("top", &mut collector);
    Ok(collector.done.expect("a block is one scope"))
}
