//! The rising edge: what registers and memories take.
//!
//! What a register held is read before it is written, so the order of the registers is free; it decides how long words
//! live.

use crate::body::{Body, Place};
use crate::word::{constant, shifted_left};
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{FuncRef, InstBuilder, MemFlagsData, Value};
use cranelift_frontend::FunctionBuilder;
use imogene_hdl::{Module, Net, Op};
use std::collections::HashSet;
use std::rc::Rc;

impl Body<'_, '_> {
    /// All that a rising edge does: calls of instances with functions of their own come last, for what they held is
    /// read before.
    pub(crate) fn update(
        &mut self,
        function: &mut dyn FnMut(&Rc<Module>, &mut FunctionBuilder<'_>) -> FuncRef,
    ) {
        let (mut owned, mut called) = (vec![0], vec![]);
        let mut next = 0;
        while let Some(&scope) = owned.get(next) {
            next += 1;
            for (index, instance) in self.scopes[scope].module.instances.iter().enumerate() {
                if self.layout.block(&instance.module).is_called {
                    called.push((scope, index));
                } else if instance.module.is_clocked() {
                    owned.push(self.part(scope, index));
                }
            }
        }
        for &(scope, index) in &called {
            self.hand_inputs(scope, index);
        }
        for &scope in &owned {
            for index in 0..self.scopes[scope].module.memories.len() {
                self.memory(scope, index);
            }
        }
        for (scope, index) in self.ordered(&owned) {
            self.register(scope, index);
        }
        for (scope, index) in called {
            let own = &self.scopes[scope];
            let (module, place) = (own.module, own.place + own.block.instances[index]);
            let function = function(&module.instances[index].module, &mut self.to);
            let distance = constant(&mut self.to, 8 * place as u64);
            let block = self.to.ins().iadd(self.base, distance);
            self.to.ins().call(function, &[block]);
        }
    }

    fn hand_inputs(&mut self, scope: usize, index: usize) {
        let own = &self.scopes[scope];
        let place = own.place + own.block.instances[index];
        let module = own.module;
        for (input, net) in module.instances[index].inputs.iter().enumerate() {
            let value = self.kept((scope, *net));
            self.store(value, self.base, place + input);
        }
    }

    fn register(&mut self, scope: usize, index: usize) {
        let own = &self.scopes[scope];
        let (module, place) = (own.module, own.place + own.block.register(index));
        let register = &module.registers[index];
        // It holds what it began with: nothing to store.
        let never = |net: Net| module.node(net).op == Op::Literal(0);
        if register.enable.is_some_and(never) {
            return;
        }
        let held = self.kept((scope, register.net));
        let next = register.next.expect("a closed module has all inputs");
        let mut next = self.kept((scope, next));
        if let Some(enable) = register.enable {
            let enable = self.zeros((scope, enable));
            next = self.to.ins().select(enable, next, held);
        }
        self.store(next, self.base, place);
    }

    /// A memory reads before it writes.
    fn memory(&mut self, scope: usize, index: usize) {
        let own = &self.scopes[scope];
        let (module, place) = (own.module, own.place + own.block.memories[index]);
        let memory = &module.memories[index];
        // What was read before is wanted later.
        self.word((scope, memory.net));
        let [enable, at, data] = memory.write.map(|net| self.zeros((scope, net)));
        let address = self.zeros((scope, memory.address));
        let words = constant(&mut self.to, memory.words as u64);
        let read_at = self.to.ins().umin(address, words);
        let read_at = self.address(read_at, place + 1);
        let read = self.to.ins().load(I64, MemFlagsData::trusted(), read_at, 0);
        let nowhere = constant(&mut self.to, memory.words as u64 + 1);
        let is_there = self.to.ins().icmp(IntCC::UnsignedLessThan, at, words);
        let at = self.to.ins().select(is_there, at, nowhere);
        let at = self.to.ins().select(enable, at, nowhere);
        let write_at = self.address(at, place + 1);
        self.store(data, write_at, 0);
        self.store(read, self.base, place);
    }

    fn address(&mut self, index: Value, place: usize) -> Value {
        let distance = shifted_left(&mut self.to, index, 3);
        let start = constant(&mut self.to, 8 * place as u64);
        let start = self.to.ins().iadd(self.base, start);
        self.to.ins().iadd(start, distance)
    }

    /// The registers of these scopes, those that read before those that are read, as far as they go in no ring.
    fn ordered(&mut self, scopes: &[usize]) -> Vec<(usize, usize)> {
        let mut seen: HashSet<Place> = HashSet::new();
        let mut order = vec![];
        for &scope in scopes {
            for register in &self.scopes[scope].module.registers {
                let mut open = vec![((scope, register.net), false)];
                while let Some((at, is_done)) = open.pop() {
                    let at = self.origin(at);
                    let own = &self.scopes[at.0];
                    let op = &own.module.node(at.1).op;
                    let register = match op {
                        Op::Register(index) if own.is_own => Some(*index),
                        _ => None,
                    };
                    if is_done {
                        order.extend(register.map(|index| (at.0, index)));
                    } else if seen.insert(at) {
                        open.push((at, true));
                        let reads = match register.map(|index| &own.module.registers[index]) {
                            Some(register) => {
                                register.next.into_iter().chain(register.enable).collect()
                            }
                            None => op.operands(),
                        };
                        open.extend(reads.into_iter().map(|net| ((at.0, net), false)));
                    }
                }
            }
        }
        order.reverse();
        order
    }
}
