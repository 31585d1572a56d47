//! Where the state of a design lies: a block of words for each instance, the blocks of its parts within it.
//!
//! The inputs of the whole lie elsewhere, those of each lane in a row. In four lanes each word lies as often, side by
//! side; in eight lanes too, or in pairs of half words. Equal parts of what runs in one lane lie so, in groups of eight
//! and of four: they run together. So do the small ones that stand in one module, as the rows of a root do: word by
//! word those of all rows, so that what each row takes from the one before lies side by side too.
//!
//! Large parts of what runs in one lane have functions of their own too, for the words where they lie.

use crate::lanes::Lanes;
use crate::rest::Part;
use crate::size::{Size, blended};
use crate::word::kept;
use imogene_hdl::{Design, Direction, Module};
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::sync::Arc;

/// Modules with fewer nets, all parts counted, become part of what is around them: a call would cost more.
const SMALL: usize = 60;

/// Fewer equal parts are no faster in eight lanes than in four.
const FOR_EIGHT: usize = 5;

/// Parts with so many nets that are not in functions run apart, so that they may rest while the remainder runs.
const APART: usize = 200;

/// Words that tell whether an input is new.
const NEWS: usize = 4;

/// The block of a module, in vectors from its beginning.
pub(crate) struct Block {
    /// Inputs lie in front, in their order, and registers behind them.
    inputs: Vec<usize>,
    registers: Vec<usize>,
    /// Of each memory the word that is read; its words lie behind, then one that is always 0 and one for writes that
    /// count nothing.
    pub(crate) memories: Vec<usize>,
    /// Of the block of each instance; in one lane those with functions lie in groups instead.
    parts: Vec<usize>,
    /// All words.
    size: usize,
}

impl Block {
    pub(crate) fn input(&self, index: usize) -> usize {
        self.inputs[index]
    }

    pub(crate) fn register(&self, index: usize) -> usize {
        self.registers[index]
    }
}

/// A module, and where it stands: by the place of what is around it, and its number there.
type Equal = (Arc<Module>, Vec<(usize, usize)>);

/// Equal parts of what runs in one lane, no more than there are lanes.
pub(crate) struct Group {
    pub(crate) module: Arc<Module>,
    pub(crate) lanes: Lanes,
    pub(crate) place: usize,
    /// Its words.
    words: Range<usize>,
    /// Not all 0 in a clock in which some input is new.
    pub(crate) news: usize,
    /// The places of what is around each of them.
    around: Vec<usize>,
    /// The place of the part apart in which all of them are, or of the whole.
    pub(crate) owner: usize,
}

/// A large part of what runs in one lane.
pub(crate) struct Apart {
    pub(crate) module: Arc<Module>,
    pub(crate) place: usize,
    /// The words of its block.
    words: Range<usize>,
    /// Not 0 in a clock in which some input is new.
    pub(crate) news: usize,
}

/// Where the words of an instance lie: the first, how far it is to the next, and which lane of its block it is.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot {
    pub(crate) place: usize,
    pub(crate) stride: usize,
    pub(crate) lanes: Lanes,
    pub(crate) lane: usize,
}

impl Spot {
    /// The place of a whole word.
    pub(crate) fn word(&self, index: usize) -> usize {
        self.place + index * self.stride + self.lane
    }
}

/// The blocks of all modules, and the groups of a design in one lane.
pub(crate) struct Layout {
    /// The inputs of this module lie elsewhere.
    top: *const Module,
    /// Modules with functions of their own.
    called: HashSet<*const Module>,
    blocks: HashMap<(*const Module, Lanes), Block>,
    pub(crate) groups: Vec<Group>,
    pub(crate) apart: Vec<Apart>,
    /// Parts that lie among equal ones, by the place of what is around them, and their numbers there.
    grouped: HashMap<(usize, usize), Spot>,
    /// Of the parts in the module at a place those that run together, four at a time.
    rows: HashMap<usize, Vec<[usize; 4]>>,
    /// Their words, by that place.
    words_of_rows: Vec<(usize, Range<usize>)>,
    /// All words.
    pub(crate) size: usize,
}

impl Layout {
    pub(crate) fn of(design: &Design, lanes: Lanes) -> Layout {
        let modules = design.top.all();
        let mut layout = Layout {
            top: Arc::as_ptr(&design.top),
            called: called(&design.top, &modules),
            blocks: HashMap::new(),
            groups: vec![],
            apart: vec![],
            grouped: HashMap::new(),
            rows: HashMap::new(),
            words_of_rows: vec![],
            size: 0,
        };
        for &lanes in lanes.with_those_of_parts() {
            for module in &modules {
                let block = layout.new_block(module, lanes);
                layout.blocks.insert((Arc::as_ptr(module), lanes), block);
            }
        }
        layout.size = layout.block(&design.top, lanes).size * lanes.in_vector();
        if lanes == Lanes::One {
            let most = layout.own_nets(&design.top) * 3 / 4;
            layout.find_apart(&design.top, 0, most);
            let mut found = vec![];
            layout.find_called(&design.top, 0, &mut found);
            for (module, parts) in &found {
                layout.group(module, parts);
            }
            // Rows are read four at a time, perhaps with words behind them.
            layout.size += 3;
        }
        layout
    }

    fn new_block(&self, module: &Module, lanes: Lanes) -> Block {
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
        let parts = module.instances.iter().map(|instance| {
            let is_elsewhere = lanes == Lanes::One && self.is_called(&instance.module);
            let part = self.block(&instance.module, lanes);
            take(&mut size, if is_elsewhere { 0 } else { part.size })
        });
        let parts = parts.collect();
        Block {
            inputs,
            registers,
            memories,
            parts,
            size,
        }
    }

    /// The nets of a module that are in no function of their own.
    fn own_nets(&self, module: &Module) -> usize {
        let parts = module.instances.iter().map(|instance| &instance.module);
        let parts = parts.filter(|part| !self.is_called(part));
        module.nodes.len() + parts.map(|part| self.own_nets(part)).sum::<usize>()
    }

    /// The large parts that are in a block of one lane: none of more nets than that, and none in another.
    fn find_apart(&mut self, module: &Arc<Module>, place: usize, most: usize) {
        for (index, instance) in module.instances.iter().enumerate() {
            let part = &instance.module;
            let nets = self.own_nets(part);
            if self.is_called(part) || nets < APART {
                continue;
            }
            let block = self.block(module, Lanes::One).parts[index];
            let place = place + block;
            if nets > most {
                self.find_apart(part, place, most);
                continue;
            }
            let news = self.size;
            self.size += NEWS;
            self.apart.push(Apart {
                module: part.clone(),
                place,
                words: place..place + self.block(part, Lanes::One).size,
                news,
            });
        }
    }

    /// The parts with functions that are in a block of one lane, by their modules; small parts that stand side by side
    /// get their places.
    fn find_called(&mut self, module: &Arc<Module>, place: usize, found: &mut Vec<Equal>) {
        self.group_rows(module, place);
        for (index, instance) in module.instances.iter().enumerate() {
            let part = &instance.module;
            if self.grouped.contains_key(&(place, index)) {
                continue;
            }
            if !self.is_called(part) {
                let place = place + self.block(module, Lanes::One).parts[index];
                self.find_called(part, place, found);
                continue;
            }
            match found.iter_mut().find(|(known, _)| Arc::ptr_eq(known, part)) {
                Some((_, parts)) => parts.push((place, index)),
                None => found.push((part.clone(), vec![(place, index)])),
            }
        }
    }

    /// Gives equal parts lanes, by the places of what is around them and their numbers there.
    fn group(&mut self, module: &Arc<Module>, mut parts: &[(usize, usize)]) {
        while !parts.is_empty() {
            let lanes = if parts.len() < FOR_EIGHT {
                Lanes::Four
            } else {
                Lanes::Eight
            };
            let (together, others) = parts.split_at(parts.len().min(lanes.count()));
            parts = others;
            // No vector is in two lines of a cache.
            let place = self.size.next_multiple_of(4);
            let news = place + 4 * self.block(module, lanes).size;
            self.size = news + NEWS;
            let around: Vec<usize> = together.iter().map(|(place, _)| *place).collect();
            let is_in = |apart: &&Apart| around.iter().all(|place| apart.words.contains(place));
            let owner = self.apart.iter().find(is_in).map_or(0, |apart| apart.place);
            for (lane, part) in together.iter().enumerate() {
                let spot = Spot {
                    place,
                    stride: 4,
                    lanes,
                    lane,
                };
                self.grouped.insert(*part, spot);
            }
            self.groups.push(Group {
                module: module.clone(),
                lanes,
                place,
                words: place..news,
                news,
                owner,
                around,
            });
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
                    place: self.size,
                    stride,
                    lanes: Lanes::One,
                    lane,
                };
                self.grouped.entry((place, *index)).or_insert(row);
            }
            let begin = self.size;
            self.size += stride * self.block(part, Lanes::One).size;
            self.words_of_rows.push((place, begin..self.size));
            self.rows.entry(place).or_default().extend(rows);
        }
    }

    /// Parts of the module at a place that run together.
    pub(crate) fn rows(&self, place: usize) -> &[[usize; 4]] {
        self.rows.get(&place).map_or(&[], Vec::as_slice)
    }

    /// What may rest: the parts apart, then the groups.
    pub(crate) fn resting(&self) -> Vec<Part> {
        let apart = self.apart.iter().map(|apart| {
            let holds = |place: &usize| apart.words.contains(place);
            let rows = self.words_of_rows.iter().filter(|(place, _)| holds(place));
            let rows = rows.map(|(_, words)| words.clone());
            let groups = self.groups.iter().zip(self.apart.len()..);
            let inner = groups.filter(|(group, _)| group.around.iter().any(holds));
            Part {
                words: [apart.words.clone()].into_iter().chain(rows).collect(),
                news: news(apart.news),
                inner: inner.map(|(_, number)| number).collect(),
            }
        });
        let groups = self.groups.iter().map(|group| Part {
            words: vec![group.words.clone()],
            news: news(group.news),
            inner: vec![],
        });
        apart.chain(groups).collect()
    }

    /// The groups that the part apart at a place holds, or those of no such part, at 0.
    pub(crate) fn groups_of(&self, owner: usize) -> impl Iterator<Item = &Group> {
        let groups = self.groups.iter();
        groups.filter(move |group| group.owner == owner)
    }

    /// The part apart at this spot, if it is one.
    pub(crate) fn apart(&self, spot: Spot) -> Option<&Apart> {
        let mut all = self.apart.iter();
        all.find(|apart| spot.stride == 1 && apart.place == spot.place)
    }

    pub(crate) fn block(&self, module: &Arc<Module>, lanes: Lanes) -> &Block {
        &self.blocks[&(Arc::as_ptr(module), lanes)]
    }

    pub(crate) fn is_top(&self, module: &Arc<Module>) -> bool {
        self.top == Arc::as_ptr(module)
    }

    pub(crate) fn is_called(&self, module: &Arc<Module>) -> bool {
        self.called.contains(&Arc::as_ptr(module))
    }

    /// Where an instance in a module lies, by where the module does.
    pub(crate) fn part(&self, around: &Arc<Module>, spot: Spot, index: usize) -> Spot {
        let among_others = self.grouped.get(&(spot.place, index));
        if let Some(grouped) = among_others.filter(|_| spot.stride == 1) {
            return *grouped;
        }
        let parts = &self.block(around, spot.lanes).parts;
        let place = spot.place + parts[index] * spot.stride;
        Spot { place, ..spot }
    }

    /// The places, widths and first words of all registers, those of instances before those of the module around them.
    pub(crate) fn registers(&self, top: &Arc<Module>, lanes: Lanes) -> Vec<Register> {
        let mut found = vec![];
        self.visit(top, whole(lanes), &mut |module, spot| {
            let block = self.block(module, spot.lanes);
            let registers = module.registers.iter().enumerate();
            found.extend(registers.map(|(index, register)| {
                let width = module.node(register.net).width;
                Register {
                    place: spot.place + block.register(index) * spot.stride,
                    lane: spot.lane,
                    size: Size::of(width, spot.lanes),
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
            let places = &self.block(module, spot.lanes).memories;
            for (memory, place) in module.memories.iter().zip(places) {
                // What was read last stands before the words.
                let of_word = Size::Whole.vectors(spot.lanes);
                let places = (place + of_word..).step_by(of_word);
                let words = memory.contents.iter().zip(places);
                found.extend(words.map(|(word, place)| (spot.word(place), *word)));
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

fn news(place: usize) -> Range<usize> {
    place..place + NEWS
}

/// Where the whole lies.
pub(crate) fn whole(lanes: Lanes) -> Spot {
    Spot {
        place: 0,
        stride: lanes.in_vector(),
        lanes,
        lane: 0,
    }
}

/// A register in the words of a design, in its first lane.
pub(crate) struct Register {
    /// Of the first lane of its block, and which one it is.
    pub(crate) place: usize,
    lane: usize,
    pub(crate) size: Size,
    pub(crate) width: u32,
    pub(crate) initial: u64,
}

impl Register {
    /// Gives it another word in a lane, of which the low bits count.
    pub(crate) fn set(&self, words: &mut [u64], lane: usize, word: u64) {
        let (place, word) = (self.place, kept(word, self.width));
        let lane = self.lane + lane;
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

/// The modules that stand more than once in a design and are not small.
fn called(top: &Arc<Module>, modules: &[Arc<Module>]) -> HashSet<*const Module> {
    let mut count: HashMap<*const Module, usize> = HashMap::from([(Arc::as_ptr(top), 1)]);
    // A module stands behind those in it.
    for module in modules.iter().rev() {
        let around = count[&Arc::as_ptr(module)];
        for instance in &module.instances {
            *count.entry(Arc::as_ptr(&instance.module)).or_default() += around;
        }
    }
    let mut nets: HashMap<*const Module, usize> = HashMap::new();
    let called = modules.iter().filter(|module| {
        let parts = module.instances.iter();
        let parts = parts.map(|instance| nets[&Arc::as_ptr(&instance.module)]);
        let all = module.nodes.len() + parts.sum::<usize>();
        nets.insert(Arc::as_ptr(module), all);
        count[&Arc::as_ptr(module)] > 1 && all >= SMALL && module.is_clocked()
    });
    called.map(Arc::as_ptr).collect()
}
