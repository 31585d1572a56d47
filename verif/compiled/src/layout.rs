//! Where the state of a design lies: a block of words for each instance, the blocks of its parts within it.

use imogene_hdl::{Design, Direction, Module};
use std::collections::HashMap;
use std::rc::Rc;

/// Modules with fewer nets, all parts counted, become part of what is around them: a call would cost more.
const SMALL: usize = 60;

/// The block of a module. All places are words from its beginning.
pub(crate) struct Block {
    /// Inputs lie in front, in their order.
    pub(crate) inputs: usize,
    /// Of each memory the word that is read; its words lie behind, then one that is always 0 and one for writes that
    /// count nothing.
    pub(crate) memories: Vec<usize>,
    /// Of the block of each instance.
    pub(crate) instances: Vec<usize>,
    /// All words.
    pub(crate) size: usize,
    /// It has a function of its own.
    pub(crate) is_called: bool,
    nets: usize,
}

impl Block {
    /// Of a register.
    pub(crate) fn register(&self, index: usize) -> usize {
        self.inputs + index
    }
}

/// The blocks of all modules.
pub(crate) struct Layout {
    blocks: HashMap<*const Module, Block>,
}

impl Layout {
    pub(crate) fn of(design: &Design) -> Layout {
        let mut blocks: HashMap<*const Module, Block> = HashMap::new();
        let modules = design.top.all();
        for module in &modules {
            let block = block(module, &blocks);
            blocks.insert(Rc::as_ptr(module), block);
        }
        let mut instances: HashMap<*const Module, usize> = HashMap::new();
        // A module stands behind those in it.
        for module in modules.iter().rev() {
            let around = instances.get(&Rc::as_ptr(module)).copied().unwrap_or(1);
            for instance in &module.instances {
                *instances.entry(Rc::as_ptr(&instance.module)).or_default() += around;
            }
        }
        for module in &modules {
            let block = blocks.get_mut(&Rc::as_ptr(module)).expect("a block");
            let is_top = Rc::ptr_eq(module, &design.top);
            let is_shared = instances
                .get(&Rc::as_ptr(module))
                .is_some_and(|count| *count > 1);
            block.is_called = is_top || is_shared && block.nets >= SMALL && module.is_clocked();
        }
        Layout { blocks }
    }

    pub(crate) fn block(&self, module: &Rc<Module>) -> &Block {
        &self.blocks[&Rc::as_ptr(module)]
    }

    /// Adds the place of every register, those of instances before those of the module around them, for a block that
    /// begins at `from`.
    pub(crate) fn registers(&self, module: &Rc<Module>, from: usize, places: &mut Vec<usize>) {
        let block = self.block(module);
        for (instance, place) in module.instances.iter().zip(&block.instances) {
            self.registers(&instance.module, from + place, places);
        }
        places.extend((0..module.registers.len()).map(|index| from + block.register(index)));
    }

    /// Writes what registers hold at power-up into the block of a module.
    pub(crate) fn power_up(&self, module: &Rc<Module>, words: &mut [u64]) {
        let block = self.block(module);
        for (index, register) in module.registers.iter().enumerate() {
            words[block.register(index)] = register.initial;
        }
        for (instance, place) in module.instances.iter().zip(&block.instances) {
            self.power_up(&instance.module, &mut words[*place..]);
        }
    }
}

fn block(module: &Module, blocks: &HashMap<*const Module, Block>) -> Block {
    let inputs = module.ports_of(Direction::In).count();
    let mut size = inputs + module.registers.len();
    let mut nets = module.nodes.len();
    let mut take = |words: usize| {
        size += words;
        size - words
    };
    let memories = module
        .memories
        .iter()
        .map(|memory| take(memory.words + 3))
        .collect();
    let mut instances = vec![];
    for instance in &module.instances {
        let part = &blocks[&Rc::as_ptr(&instance.module)];
        instances.push(take(part.size));
        nets += part.nets;
    }
    Block {
        inputs,
        memories,
        instances,
        size,
        is_called: false,
        nets,
    }
}
