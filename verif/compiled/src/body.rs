//! The body of a function: words of a module and of the parts that have no function of their own.
//!
//! A word is computed where it is first wanted.

use crate::layout::{Block, Layout};
use crate::word::{Above, Word, compared, constant, shifted_left, shifted_right};
use cranelift_codegen::ir::condcodes::IntCC;
use cranelift_codegen::ir::types::I64;
use cranelift_codegen::ir::{InstBuilder, MemFlagsData, Value};
use cranelift_frontend::FunctionBuilder;
use imogene_hdl::{Binary, Direction, Module, Net, Op};
use std::rc::Rc;

/// An instance in a function.
pub(crate) struct Scope<'d> {
    pub(crate) module: &'d Rc<Module>,
    pub(crate) block: &'d Block,
    /// Of its block in that of the function.
    pub(crate) place: usize,
    /// The scope around it, and which of its instances it is.
    around: Option<(usize, usize)>,
    /// The function writes its registers.
    pub(crate) is_own: bool,
    words: Vec<Known>,
    parts: Vec<Option<usize>>,
}

/// What is known of the word of a net.
#[derive(Clone, Copy)]
enum Known {
    Nothing,
    /// It is being computed: who wants it now stands in a loop.
    Open,
    Word(Word),
}

/// A net of a scope.
pub(crate) type Place = (usize, Net);

/// A body that is being written.
pub(crate) struct Body<'a, 'd> {
    pub(crate) to: FunctionBuilder<'a>,
    pub(crate) base: Value,
    pub(crate) layout: &'d Layout,
    pub(crate) scopes: Vec<Scope<'d>>,
}

impl<'a, 'd> Body<'a, 'd> {
    /// Of the function of a module; `base` is the address of its block.
    pub(crate) fn new(
        to: FunctionBuilder<'a>,
        base: Value,
        layout: &'d Layout,
        module: &'d Rc<Module>,
    ) -> Body<'a, 'd> {
        let mut body = Body {
            to,
            base,
            layout,
            scopes: vec![],
        };
        body.open(module, 0, None, true);
        body
    }

    fn open(
        &mut self,
        module: &'d Rc<Module>,
        place: usize,
        around: Option<(usize, usize)>,
        is_own: bool,
    ) -> usize {
        self.scopes.push(Scope {
            module,
            block: self.layout.block(module),
            place,
            around,
            is_own,
            words: vec![Known::Nothing; module.nodes.len()],
            parts: vec![None; module.instances.len()],
        });
        self.scopes.len() - 1
    }

    /// The scope of an instance.
    pub(crate) fn part(&mut self, scope: usize, index: usize) -> usize {
        if let Some(part) = self.scopes[scope].parts[index] {
            return part;
        }
        let around = &self.scopes[scope];
        let module = &around.module.instances[index].module;
        let is_own = around.is_own && !self.layout.block(module).is_called;
        let place = around.place + around.block.instances[index];
        let part = self.open(module, place, Some((scope, index)), is_own);
        self.scopes[scope].parts[index] = Some(part);
        part
    }

    /// Where a net that is another name gets its bits, through the ports of instances.
    pub(crate) fn origin(&mut self, (mut scope, mut net): Place) -> Place {
        loop {
            let own = &self.scopes[scope];
            let module = own.module;
            match (&module.node(net).op, own.around) {
                (Op::Same(other) | Op::Forward(Some(other)), _) => net = *other,
                (Op::Input, Some((around, index))) => {
                    let place = input_index(module, net);
                    let instance = &self.scopes[around].module.instances[index];
                    (scope, net) = (around, instance.inputs[place]);
                }
                (Op::Output(index, output), _) => {
                    let mut ports = module.instances[*index].module.ports_of(Direction::Out);
                    net = ports.nth(*output).expect("an output").net;
                    scope = self.part(scope, *index);
                }
                _ => return (scope, net),
            }
        }
    }

    fn width(&self, (scope, net): Place) -> u32 {
        self.scopes[scope].module.node(net).width
    }

    fn known(&mut self, (scope, net): Place) -> &mut Known {
        &mut self.scopes[scope].words[net.0]
    }

    fn refuse_loop(&self, (scope, net): Place) -> ! {
        let module = self.scopes[scope].module;
        let name = module.node(net).name.as_deref().unwrap_or("without a name");
        let module = &module.name;
        panic!("value `{name}` of {module} depends on itself within one clock")
    }

    pub(crate) fn word(&mut self, at: Place) -> Word {
        let at = self.origin(at);
        match self.scopes[at.0].words[at.1.0] {
            Known::Word(word) => return word,
            Known::Open => self.refuse_loop(at),
            Known::Nothing => *self.known(at) = Known::Open,
        }
        let word = self.compute(at);
        *self.known(at) = Known::Word(word);
        word
    }

    /// Made clean, once for all.
    fn clean(
        &mut self,
        at: Place,
        how: fn(&mut Word, u32, &mut FunctionBuilder<'_>) -> Value,
    ) -> Value {
        let at = self.origin(at);
        let (mut word, width) = (self.word(at), self.width(at));
        let value = how(&mut word, width, &mut self.to);
        *self.known(at) = Known::Word(word);
        value
    }

    /// With zeros above.
    pub(crate) fn zeros(&mut self, at: Place) -> Value {
        self.clean(at, Word::with_zeros)
    }

    /// With the sign above.
    fn signs(&mut self, at: Place) -> Value {
        self.clean(at, Word::with_signs)
    }

    /// With the sign of a number, or with zeros above a word.
    fn extended(&mut self, at: Place) -> Value {
        match self.scopes[at.0].module.node(at.1).signed {
            true => self.signs(at),
            false => self.zeros(at),
        }
    }

    /// As it stands in memory: one bit with zeros above, more with anything.
    pub(crate) fn kept(&mut self, at: Place) -> Value {
        match self.width(at) {
            1 => self.zeros(at),
            _ => self.word(at).value,
        }
    }

    fn load(&mut self, place: usize, width: u32) -> Word {
        let value = self.load_word(place);
        let above = if width == 1 {
            Above::Zeros
        } else {
            Above::Anything
        };
        Word::new(value, above, width)
    }

    pub(crate) fn load_word(&mut self, place: usize) -> Value {
        let flags = MemFlagsData::trusted();
        self.to.ins().load(I64, flags, self.base, 8 * place as i32)
    }

    pub(crate) fn store(&mut self, value: Value, base: Value, place: usize) {
        let flags = MemFlagsData::trusted();
        self.to.ins().store(flags, value, base, 8 * place as i32);
    }

    fn compute(&mut self, at: Place) -> Word {
        let (scope, net) = at;
        let own = &self.scopes[scope];
        let (module, block, place) = (own.module, own.block, own.place);
        let node = module.node(net);
        let width = node.width;
        let word = |value, above| Word::new(value, above, width);
        let in_scope = |net: &Net| (scope, *net);
        match &node.op {
            Op::Literal(bits) => word(constant(&mut self.to, *bits), Above::Zeros),
            Op::Input => self.load(place + input_index(module, net), width),
            Op::Register(index) => self.load(place + block.register(*index), width),
            Op::Read(index) => {
                let value = self.load_word(place + block.memories[*index]);
                word(value, Above::Zeros)
            }
            Op::Not(a) => {
                let a = self.word(in_scope(a));
                match (width, a.above) {
                    (1, Above::Zeros) => {
                        let one = constant(&mut self.to, 1);
                        word(self.to.ins().bxor(a.value, one), Above::Zeros)
                    }
                    _ => word(self.to.ins().bnot(a.value), Above::Anything),
                }
            }
            Op::Binary(binary, a, b) => self.binary(*binary, in_scope(a), in_scope(b), width),
            Op::Select(which, a, b) => {
                let which = self.zeros(in_scope(which));
                let (a, b) = (self.word(in_scope(a)), self.word(in_scope(b)));
                let above = a.above.and(b.above);
                word(self.to.ins().select(which, a.value, b.value), above)
            }
            Op::Slice(a, low) => {
                let (whole, a) = (self.width(in_scope(a)), self.word(in_scope(a)));
                let is_top = low + width == whole && a.above == Above::Zeros;
                let above = if is_top {
                    Above::Zeros
                } else {
                    Above::Anything
                };
                word(shifted_right(&mut self.to, a.value, *low), above)
            }
            Op::Join(parts) => {
                let first = self.word(in_scope(&parts[0]));
                let joined = parts[1..].iter().fold(first.value, |high, part| {
                    let high = shifted_left(&mut self.to, high, module.node(*part).width);
                    let low = self.zeros((scope, *part));
                    self.to.ins().bor(high, low)
                });
                // Bits above a first part with signs are signs of the whole.
                word(joined, first.above)
            }
            Op::Extend(a) => {
                let above = match module.node(*a).signed {
                    true => Above::Signs,
                    false => Above::Zeros,
                };
                word(self.extended(in_scope(a)), above)
            }
            op => unreachable!("{op:?} is another name"),
        }
    }

    fn binary(&mut self, binary: Binary, a: Place, b: Place, width: u32) -> Word {
        let is_signed = |body: &Self| body.scopes[a.0].module.node(a.1).signed;
        let (value, above) = match binary {
            Binary::Add | Binary::Sub => {
                let (a, b) = (self.word(a).value, self.word(b).value);
                let value = match binary {
                    Binary::Add => self.to.ins().iadd(a, b),
                    _ => self.to.ins().isub(a, b),
                };
                (value, Above::Anything)
            }
            Binary::Mul => {
                let (a, b) = (self.extended(a), self.extended(b));
                (self.to.ins().imul(a, b), Above::Anything)
            }
            Binary::And | Binary::Or | Binary::Xor => {
                let (a, b) = (self.word(a), self.word(b));
                let above = a.above.and(b.above);
                let ins = self.to.ins();
                let value = match binary {
                    Binary::And => ins.band(a.value, b.value),
                    Binary::Or => ins.bor(a.value, b.value),
                    _ => ins.bxor(a.value, b.value),
                };
                (value, above)
            }
            Binary::Left => {
                let (value, count) = (self.word(a).value, self.zeros(b));
                let most = constant(&mut self.to, 63);
                let shifted = self.to.ins().ishl(value, count);
                let zero = constant(&mut self.to, 0);
                let is_far = self.to.ins().icmp(IntCC::UnsignedGreaterThan, count, most);
                (self.to.ins().select(is_far, zero, shifted), Above::Anything)
            }
            Binary::Right => {
                let (count, most) = (self.zeros(b), constant(&mut self.to, 63));
                match is_signed(self) {
                    true => {
                        let count = self.to.ins().umin(count, most);
                        let value = self.signs(a);
                        (self.to.ins().sshr(value, count), Above::Signs)
                    }
                    false => {
                        let value = self.zeros(a);
                        let shifted = self.to.ins().ushr(value, count);
                        let zero = constant(&mut self.to, 0);
                        let is_far = self.to.ins().icmp(IntCC::UnsignedGreaterThan, count, most);
                        (self.to.ins().select(is_far, zero, shifted), Above::Zeros)
                    }
                }
            }
            Binary::Equal => (self.equal(a, b), Above::Zeros),
            Binary::Less => {
                let (how, a, b) = match is_signed(self) {
                    true => (IntCC::SignedLessThan, self.signs(a), self.signs(b)),
                    false => (IntCC::UnsignedLessThan, self.zeros(a), self.zeros(b)),
                };
                (compared(&mut self.to, how, a, b), Above::Zeros)
            }
        };
        Word::new(value, above, width)
    }

    fn equal(&mut self, a: Place, b: Place) -> Value {
        let width = self.width(a);
        let (one, other) = (self.word(a), self.word(b));
        if let (Some(a), Some(b)) = (one.zeros, other.zeros) {
            return compared(&mut self.to, IntCC::Equal, a, b);
        }
        let differs = self.to.ins().bxor(one.value, other.value);
        let differs = shifted_left(&mut self.to, differs, 64 - width);
        let zero = constant(&mut self.to, 0);
        compared(&mut self.to, IntCC::Equal, differs, zero)
    }

    /// The net of this name behind the names of the instances around it.
    pub(crate) fn find(&mut self, path: &str) -> Place {
        let mut scope = 0;
        let mut names: Vec<&str> = path.split('.').collect();
        let last = names.pop().expect("a name");
        for name in names {
            let mut instances = self.scopes[scope].module.instances.iter();
            let index = instances.position(|instance| instance.name == name);
            scope = self.part(scope, index.expect("a path that was found"));
        }
        let net = named(self.scopes[scope].module, last);
        (scope, net.expect("a path that was found"))
    }
}

fn input_index(module: &Module, net: Net) -> usize {
    let place = module
        .ports_of(Direction::In)
        .position(|port| port.net == net);
    place.expect("an input is a port")
}

/// The port of this name, or the net.
pub(crate) fn named(module: &Module, name: &str) -> Option<Net> {
    let port = module.ports.iter().find(|port| port.name == name);
    port.map(|port| port.net).or_else(|| {
        let mut nets = module.nets().rev();
        nets.find(|(_, node)| node.name.as_deref() == Some(name))
            .map(|(net, _)| net)
    })
}
