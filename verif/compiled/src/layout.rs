//! Where the state of a design lies: a block of words for each instance, the blocks of its parts within it.
//!
//! The inputs of the whole lie elsewhere, those of each lane in a row. In four lanes each word lies as often, side by
//! side; in eight lanes too, or in pairs of half words. Equal parts of what runs in one lane lie so, as many as there
//! are, but for four at most: they run together. So do the small ones that stand in one module, as the rows of a root
//! do: word by word those of all rows, so that what each row takes from the one before lies side by side too.

use crate::lanes::Lanes;
use crate::size::{Size, blended};
use crate::word::kept;
use imogene_hdl::{Design, Direction, Module};
use std::collections::HashMap;
use std::sync::Arc;

/// Modules with fewer nets, all parts counted, become part of what is around them: a call would cost more.
const SMALL: usize = 60;

/// The block of a module, in vectors from its beginning.
pub(crate) struct Block {
    /// Inputs lie in front, in their order, and registers behind them.
    inputs: Vec<usize>,
    registers: Vec<usize>,
    /// Of each memory the word that is read; its words lie behind, then one that is always 0 and one for writes that
    /// count nothing.
    pub(crate) memories: Vec<usize>,
    /// Of the block of each instance, in one lane and in more; in one lane those with functions lie in groups instead.
    parts: [Vec<usize>; 2],
    /// All words, likewise.
    sizes: [usize; 2],
    /// It has a function of its own.
    is_called: bool,
    nets: usize,
}

impl Block {
    pub(crate) fn input(&self, index: usize) -> usize {
        self.inputs[index]
    }

    pub(crate) fn register(&self, index: usize) -> usize {
        self.registers[index]
    }
}

/// Equal parts of what runs in one lane, four at most.
pub(crate) struct Group {
    pub(crate) module: Arc<Module>,
    pub(crate) place: usize,
    pub(crate) parts: usize,
}

/// Where the words of an instance lie: the first, and how far it is to the next.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    pub(crate) place: usize,
    pub(crate) stride: usize,
}

/// The blocks of all modules, and the groups of a design in one lane.
pub(crate) struct Layout {
    /// The inputs of this module lie elsewhere.
    top: *const Module,
    blocks: HashMap<*const Module, Block>,
    pub(crate) groups: Vec<Group>,
    /// Parts that lie among equal ones, by the place of what is around them, and their numbers there.
    grouped: HashMap<(usize, usize), Spot>,
    /// Of the parts in the module at a place those that run together, four at a time.
    rows: HashMap<usize, Vec<[usize; 4]>>,
    /// All words.
    pub(crate) size: usize,
}

impl Layout {
    pub(crate) fn of(design: &Design, lanes: Lanes) -> Layout {
        let modules = design.top.all();
        let count = instances(&design.top, &modules);
        let mut layout = Layout {
            top: Arc::as_ptr(&design.top),
            blocks: HashMap::new(),
            groups: vec![],
            grouped: HashMap::new(),
            rows: HashMap::new(),
            size: 0,
        };
        for module in &modules {
            let is_shared = count[&Arc::as_ptr(module)] > 1;
            let block = layout.new_block(module, is_shared, lanes);
            layout.blocks.insert(Arc::as_ptr(module), block);
        }
        let sizes = layout.block(&design.top).sizes;
        layout.size = sizes[usize::from(lanes != Lanes::One)] * lanes.in_vector();
        if lanes == Lanes::One {
            layout.group(&design.top, 0);
            // Rows are read four at a time, perhaps with words behind them.
            layout.size += 3;
        }
        layout
    }

    fn new_block(&self, module: &Module, is_shared: bool, lanes: Lanes) -> Block {
        let mut size = 0;
        let take = |size: &mut usize, vectors: usize| {
            *size += vectors;
            *size - vectors
        };
        let inputs = module.ports_of(Direction::In);
        let inputs = inputs.map(|port| take(&mut size, Size::of(port.width, lanes).vectors(lanes)));
        let inputs = inputs.collect();
        let registers = module.registers.iter();
        let widths = registers.map(|register| module.node(register.net).width);
        let registers = widths.map(|width| take(&mut size, Size::of(width, lanes).vectors(lanes)));
        let registers = registers.collect();
        // Never empty: no two parts are at one place.
        size = size.max(1);
        let of_word = Size::Whole.vectors(lanes);
        let memories = module.memories.iter();
        let memories = memories.map(|memory| take(&mut size, (memory.words + 3) * of_word));
        let memories = memories.collect();
        let (mut sizes, mut nets) = ([size; 2], module.nodes.len());
        let mut parts = [vec![], vec![]];
        for instance in &module.instances {
            let part = self.block(&instance.module);
            let in_one = if part.is_called { 0 } else { part.sizes[0] };
            parts[0].push(take(&mut sizes[0], in_one));
            parts[1].push(take(&mut sizes[1], part.sizes[1]));
            nets += part.nets;
        }
        Block {
            inputs,
            registers,
            memories,
            parts,
            sizes,
            is_called: is_shared && nets >= SMALL && module.is_clocked(),
            nets,
        }
    }

    /// Gives a lane to each part with a function that is in a block, and to small parts that stand side by side.
    fn group(&mut self, module: &Arc<Module>, place: usize) {
        self.group_rows(module, place);
        for (index, instance) in module.instances.iter().enumerate() {
            let part = &instance.module;
            if self.grouped.contains_key(&(place, index)) {
                continue;
            }
            if !self.is_called(part) {
                let place = place + self.block(module).parts[0][index];
                self.group(part, place);
                continue;
            }
            let is_open = |group: &&mut Group| Arc::ptr_eq(&group.module, part) && group.parts < 4;
            let group = match self.groups.iter_mut().find(is_open) {
                Some(group) => group,
                None => {
                    // Of four lanes, none of which is in two lines of a cache.
                    let begin = self.size.next_multiple_of(4);
                    self.size = begin + 4 * self.block(part).sizes[1];
                    self.groups.push(Group {
                        module: part.clone(),
                        place: begin,
                        parts: 0,
                    });
                    self.groups.last_mut().expect("a group")
                }
            };
            let spot = Spot {
                place: group.place + group.parts,
                stride: 4,
            };
            self.grouped.insert((place, index), spot);
            group.parts += 1;
        }
    }

    fn group_rows(&mut self, module: &Arc<Module>, place: usize) {
        let mut equal: Vec<(&Arc<Module>, Vec<usize>)> = vec![];
        for (index, instance) in module.instances.iter().enumerate() {
            let part = &instance.module;
            match equal.iter_mut().find(|(known, _)| Arc::ptr_eq(known, part)) {
                Some((_, indices)) => indices.push(index),
                None if part.is_clocked() && !self.is_called(part) && runs_alike(part) => {
                    equal.push((part, vec![index]));
                }
                None => {}
            }
        }
        for (part, indices) in equal {
            let rows: Vec<[usize; 4]> = indices.chunks(4).filter_map(four).collect();
            let stride = 4 * rows.len();
            for (lane, index) in rows.as_flattened().iter().enumerate() {
                let row = Spot {
                    place: self.size + lane,
                    stride,
                };
                self.grouped.entry((place, *index)).or_insert(row);
            }
            self.size += stride * self.block(part).sizes[1];
            self.rows.entry(place).or_default().extend(rows);
        }
    }

    /// Parts of the module at a place that run together.
    pub(crate) fn rows(&self, place: usize) -> &[[usize; 4]] {
        self.rows.get(&place).map_or(&[], Vec::as_slice)
    }

    pub(crate) fn block(&self, module: &Arc<Module>) -> &Block {
        &self.blocks[&Arc::as_ptr(module)]
    }

    pub(crate) fn is_top(&self, module: &Arc<Module>) -> bool {
        self.top == Arc::as_ptr(module)
    }

    pub(crate) fn is_called(&self, module: &Arc<Module>) -> bool {
        self.block(module).is_called
    }

    /// Where an instance in a module lies, by where the module does.
    pub(crate) fn part(&self, around: &Arc<Module>, spot: Spot, index: usize) -> Spot {
        let among_others = self.grouped.get(&(spot.place, index));
        if let Some(grouped) = among_others.filter(|_| spot.stride == 1) {
            return *grouped;
        }
        let parts = &self.block(around).parts[usize::from(spot.stride > 1)];
        let place = spot.place + parts[index] * spot.stride;
        Spot { place, ..spot }
    }

    /// The places, widths and first words of all registers, those of instances before those of the module around them.
    pub(crate) fn registers(&self, top: &Arc<Module>, lanes: Lanes) -> Vec<Register> {
        let mut found = vec![];
        self.visit(top, whole(lanes), &mut |module, spot| {
            let block = self.block(module);
            let registers = module.registers.iter().enumerate();
            found.extend(registers.map(|(index, register)| {
                let width = module.node(register.net).width;
                Register {
                    place: spot.place + block.register(index) * spot.stride,
                    size: Size::of(width, lanes),
                    width,
                    initial: kept(register.initial, width),
                }
            }));
        });
        found
    }

    /// The places of the words that memories hold at power-up, beside zeros, each with its word.
    pub(crate) fn contents(&self, top: &Arc<Module>, lanes: Lanes) -> Vec<(usize, u64)> {
        let mut found = vec![];
        self.visit(top, whole(lanes), &mut |module, spot| {
            for (memory, place) in module.memories.iter().zip(&self.block(module).memories) {
                // What was read last stands before the words.
                let of_word = Size::Whole.vectors(lanes);
                let places = (place + of_word..).step_by(of_word);
                let words = memory.contents.iter().zip(places);
                found.extend(words.map(|(word, place)| (spot.place + place * spot.stride, *word)));
            }
        });
        found
    }

    /// Every instance and where it lies, those in a module before it.
    fn visit(&self, module: &Arc<Module>, spot: Spot, tell: &mut impl FnMut(&Arc<Module>, Spot)) {
        for (index, instance) in module.instances.iter().enumerate() {
            self.visit(&instance.module, self.part(module, spot, index), tell);
        }
        tell(module, spot);
    }
}

/// Where the whole lies.
pub(crate) fn whole(lanes: Lanes) -> Spot {
    let stride = lanes.in_vector();
    Spot { place: 0, stride }
}

/// A register in the words of a design, in its first lane.
pub(crate) struct Register {
    pub(crate) place: usize,
    pub(crate) size: Size,
    pub(crate) width: u32,
    pub(crate) initial: u64,
}

impl Register {
    /// Gives it another word in a lane, of which the low bits count.
    pub(crate) fn set(&self, words: &mut [u64], lane: usize, word: u64) {
        let (place, word) = (self.place, kept(word, self.width));
        match self.size {
            Size::Whole => words[place + lane] = word,
            Size::Half => {
                let words = &mut words[place + lane % 4];
                *words = match lane < 4 {
                    true => blended(word, *words),
                    false => blended(*words, word << 32),
                };
            }
        }
    }
}

/// Parts for four lanes, the last of three in two of them: fewer are no faster so.
fn four(parts: &[usize]) -> Option<[usize; 4]> {
    match *parts {
        [a, b, c] => Some([a, b, c, c]),
        _ => parts.try_into().ok(),
    }
}

/// A module without memories: equal ones can run side by side, each in its lane.
fn runs_alike(module: &Module) -> bool {
    let mut parts = module.instances.iter();
    module.memories.is_empty() && parts.all(|instance| runs_alike(&instance.module))
}

/// How often each module stands in a design.
fn instances(top: &Arc<Module>, modules: &[Arc<Module>]) -> HashMap<*const Module, usize> {
    let mut found: HashMap<*const Module, usize> = HashMap::from([(Arc::as_ptr(top), 1)]);
    // A module stands behind those in it.
    for module in modules.iter().rev() {
        let around = found[&Arc::as_ptr(module)];
        for instance in &module.instances {
            *found.entry(Arc::as_ptr(&instance.module)).or_default() += around;
        }
    }
    found
}
