//! The body of a function: words of a module and of the parts that have no function of their own.
//!
//! A word is computed where it is first wanted.

use crate::layout::{Lanes, Layout};
use crate::line::{Line, Step, Two, Value};
use crate::word::Word;
use imogene_hdl::{Binary, Direction, Module, Net, Op};
use std::rc::Rc;

/// An instance in a function.
pub(crate) struct Scope<'d> {
    pub(crate) module: &'d Rc<Module>,
    /// Of its first word, from the beginning of the function's block.
    pub(crate) place: usize,
    /// In what its block lies.
    pub(crate) lanes: Lanes,
    /// The scope around it, and which of its instances it is.
    pub(crate) around: Option<(usize, usize)>,
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
pub(crate) struct Body<'d> {
    pub(crate) to: Line,
    pub(crate) layout: &'d Layout,
    pub(crate) scopes: Vec<Scope<'d>>,
    /// What was known before of the words of nets, while that will be wanted again.
    before: Option<Vec<(Place, Known)>>,
}

impl<'d> Body<'d> {
    /// Of the function of a module, in so many lanes.
    pub(crate) fn new(layout: &'d Layout, module: &'d Rc<Module>, lanes: Lanes) -> Body<'d> {
        let mut body = Body {
            to: Line::default(),
            layout,
            scopes: vec![],
            before: None,
        };
        body.open(module, 0, lanes, None, true);
        body
    }

    fn open(
        &mut self,
        module: &'d Rc<Module>,
        place: usize,
        lanes: Lanes,
        around: Option<(usize, usize)>,
        is_own: bool,
    ) -> usize {
        self.scopes.push(Scope {
            module,
            place,
            lanes,
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
        let is_own = around.is_own && !self.layout.is_called(module);
        let (place, lanes) = self
            .layout
            .part(around.module, around.place, around.lanes, index);
        let part = self.open(module, place, lanes, Some((scope, index)), is_own);
        self.scopes[scope].parts[index] = Some(part);
        part
    }

    /// The place of a word of a scope, by its number in the block.
    pub(crate) fn at(&self, scope: usize, word: usize) -> usize {
        let own = &self.scopes[scope];
        own.place + word * own.lanes.count()
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

    fn learn(&mut self, at: Place, known: Known) {
        let before = std::mem::replace(&mut self.scopes[at.0].words[at.1.0], known);
        self.before
            .iter_mut()
            .for_each(|all| all.push((at, before)));
    }

    /// Steps that are only done if the top bit of a word is 1 in some lane; what they compute is forgotten.
    pub(crate) fn only_if(&mut self, which: Value, steps: impl FnOnce(&mut Self)) {
        let begin = self.to.add(Step::OnlyIf(which, 0));
        self.before = Some(vec![]);
        steps(self);
        for ((scope, net), known) in self.before.take().into_iter().flatten().rev() {
            self.scopes[scope].words[net.0] = known;
        }
        self.to.steps[begin.0 as usize] = Step::OnlyIf(which, self.to.steps.len());
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
            Known::Nothing => self.learn(at, Known::Open),
        }
        let word = self.compute(at);
        self.learn(at, Known::Word(word));
        word
    }

    /// In one of its forms, made once for all.
    fn form(&mut self, at: Place, form: fn(&mut Word, &mut Line) -> Value) -> Value {
        let at = self.origin(at);
        let mut word = self.word(at);
        let value = form(&mut word, &mut self.to);
        self.learn(at, Known::Word(word));
        value
    }

    /// With zeros above.
    pub(crate) fn zeros(&mut self, at: Place) -> Value {
        self.form(at, Word::zeros)
    }

    /// With the sign above.
    fn signs(&mut self, at: Place) -> Value {
        self.form(at, Word::signs)
    }

    /// With its bits as the highest.
    pub(crate) fn high(&mut self, at: Place) -> Value {
        self.form(at, Word::high)
    }

    /// With the sign of a number, or with zeros above a word.
    fn extended(&mut self, at: Place) -> Value {
        match self.is_signed(at) {
            true => self.signs(at),
            false => self.zeros(at),
        }
    }

    /// As it stands in memory.
    pub(crate) fn kept(&mut self, at: Place) -> Value {
        self.form(at, Word::kept)
    }

    fn is_signed(&self, (scope, net): Place) -> bool {
        self.scopes[scope].module.node(net).signed
    }

    fn load(&mut self, place: usize, width: u32) -> Word {
        let value = self.to.add(Step::Load(place));
        match width {
            1 => Word::with_signs_above(value, 1),
            _ => Word::new(value, width),
        }
    }

    fn compute(&mut self, at: Place) -> Word {
        let (scope, net) = at;
        let module = self.scopes[scope].module;
        let block = self.layout.block(module);
        let width = module.node(net).width;
        let in_scope = |net: &Net| (scope, *net);
        match &module.node(net).op {
            Op::Literal(bits) => Word::constant(*bits, width, &mut self.to),
            Op::Input => self.load(self.at(scope, input_index(module, net)), width),
            Op::Register(index) => self.load(self.at(scope, block.register(*index)), width),
            Op::Read(index) => {
                let place = self.at(scope, block.memories[*index]);
                Word::with_zeros_above(self.to.add(Step::Load(place)), width)
            }
            Op::Not(a) => {
                if let Some(same) = self.inverse(in_scope(a)) {
                    return self.word(same);
                }
                let a = self.word(in_scope(a));
                let ones = self.to.constant(u64::MAX);
                let how = |to: &mut Line, value| to.two(Two::Xor, value, ones);
                match a.signs {
                    Some(signs) => Word::with_signs_above(how(&mut self.to, signs), width),
                    None => Word::new(how(&mut self.to, a.value), width),
                }
            }
            Op::Binary(binary, a, b) => self.binary(*binary, in_scope(a), in_scope(b), width),
            Op::Select(which, a, b) => {
                let (which, a, b) = match self.inverse(in_scope(which)) {
                    Some(inverse) => (inverse, b, a),
                    None => (in_scope(which), a, b),
                };
                let which = self.high(which);
                let (a, b) = (self.word(in_scope(a)), self.word(in_scope(b)));
                self.together(a, b, width, |to, a, b| to.add(Step::Select(which, a, b)))
            }
            Op::Slice(a, low) => self.slice(in_scope(a), *low, width),
            Op::Join(parts) => {
                let first = self.word(in_scope(&parts[0]));
                let is_signed = first.signs.is_some();
                let value = first.signs.or(first.zeros).unwrap_or(first.value);
                let joined = parts[1..].iter().fold(value, |high, part| {
                    let high = self.to.left(high, module.node(*part).width);
                    self.filled(high, (scope, *part))
                });
                // Bits above a first part with signs are signs of the whole.
                match (is_signed, first.zeros) {
                    (true, _) => Word::with_signs_above(joined, width),
                    (false, Some(_)) => Word::with_zeros_above(joined, width),
                    (false, None) => Word::new(joined, width),
                }
            }
            Op::Extend(a) => {
                let value = self.extended(in_scope(a));
                match module.node(*a).signed {
                    true => Word::with_signs_above(value, width),
                    false => Word::with_zeros_above(value, width),
                }
            }
            op => unreachable!("{op:?} is another name"),
        }
    }

    /// What a net is the inverse of.
    fn inverse(&mut self, at: Place) -> Option<Place> {
        let (scope, net) = self.origin(at);
        match self.scopes[scope].module.node(net).op {
            Op::Not(other) => Some((scope, other)),
            _ => None,
        }
    }

    /// A word whose low bits are zeros, with a net there.
    fn filled(&mut self, high: Value, low: Place) -> Value {
        let low = self.origin(low);
        if self.scopes[low.0].module.node(low.1).op == Op::Literal(0) {
            return high;
        }
        match self.word(low).signs {
            // All ones are -1.
            Some(signs) if self.width(low) == 1 => self.to.two(Two::Sub, high, signs),
            _ => {
                let low = self.zeros(low);
                self.to.two(Two::Or, high, low)
            }
        }
    }

    fn slice(&mut self, a: Place, low: u32, width: u32) -> Word {
        let (whole, from) = (self.width(a), self.word(a));
        let is_top = low + width == whole;
        let word = match (is_top, from.zeros) {
            (true, Some(zeros)) => Word::with_zeros_above(self.to.right(zeros, low), width),
            _ => Word::new(self.to.right(from.value, low), width),
        };
        match width {
            1 if is_top && from.signs.is_some() => word.with_bit_on_top(self.signs(a)),
            1 => word.with_bit_on_top(self.to.left(from.value, 63 - low)),
            _ => word,
        }
    }

    /// A word that is made bit by bit of two, in the form that both have.
    fn together(
        &mut self,
        a: Word,
        b: Word,
        width: u32,
        how: impl FnOnce(&mut Line, Value, Value) -> Value,
    ) -> Word {
        let to = &mut self.to;
        if let (Some(a), Some(b)) = (a.signs, b.signs) {
            return Word::with_signs_above(how(to, a, b), width);
        }
        if let (Some(a), Some(b)) = (a.zeros, b.zeros) {
            return Word::with_zeros_above(how(to, a, b), width);
        }
        Word::new(how(to, a.value, b.value), width)
    }

    fn binary(&mut self, binary: Binary, a: Place, b: Place, width: u32) -> Word {
        match binary {
            Binary::Add | Binary::Sub => {
                let (a, b) = (self.word(a).value, self.word(b).value);
                let how = match binary {
                    Binary::Add => Two::Add,
                    _ => Two::Sub,
                };
                Word::new(self.to.two(how, a, b), width)
            }
            Binary::Mul => Word::new(self.product(a, b), width),
            Binary::And | Binary::Or | Binary::Xor => {
                let how = match binary {
                    Binary::And => Two::And,
                    Binary::Or => Two::Or,
                    _ => Two::Xor,
                };
                let (a, b) = (self.word(a), self.word(b));
                let word = self.together(a, b, width, |to, a, b| to.two(how, a, b));
                match (how, a.zeros.or(b.zeros)) {
                    // Zeros above either are zeros above both.
                    (Two::And, Some(_)) if word.signs.is_none() => {
                        let (a, b) = (a.zeros.unwrap_or(a.value), b.zeros.unwrap_or(b.value));
                        Word::with_zeros_above(self.to.two(how, a, b), width)
                    }
                    _ => word,
                }
            }
            Binary::Left => {
                let (value, count) = (self.word(a).value, self.zeros(b));
                Word::new(self.to.two(Two::LeftBy, value, count), width)
            }
            Binary::Right => {
                let count = self.zeros(b);
                if !self.is_signed(a) {
                    let value = self.zeros(a);
                    let shifted = self.to.two(Two::RightBy, value, count);
                    return Word::with_zeros_above(shifted, width);
                }
                // Bits that equal the sign are zeros here, so that zeros are shifted in.
                let value = self.signs(a);
                let sign = self.to.sign(value);
                let magnitude = self.to.two(Two::Xor, value, sign);
                let shifted = self.to.two(Two::RightBy, magnitude, count);
                Word::with_signs_above(self.to.two(Two::Xor, shifted, sign), width)
            }
            Binary::Equal => Word::with_signs_above(self.equal(a, b), width),
            Binary::Less => Word::with_signs_above(self.less(a, b), width),
        }
    }

    /// All ones where both are equal.
    fn equal(&mut self, a: Place, b: Place) -> Value {
        let (one, other) = (self.word(a), self.word(b));
        let signed = one.is_of(true) && other.is_of(true);
        let (a, b) = match signed {
            true => (self.signs(a), self.signs(b)),
            false if one.is_of(false) || other.is_of(false) => (self.zeros(a), self.zeros(b)),
            false => {
                let differs = self.to.two(Two::Xor, one.value, other.value);
                let differs = self.to.left(differs, 64 - self.width(a));
                (differs, self.to.constant(0))
            }
        };
        self.to.two(Two::Equal, a, b)
    }

    /// All ones where the first is less.
    fn less(&mut self, a: Place, b: Place) -> Value {
        let (one, other) = (self.word(a), self.word(b));
        let width = self.width(a);
        let has_signs = width == 1 || one.is_of(true) && other.is_of(true);
        let [a, b] = match (self.is_signed(a), has_signs) {
            (true, true) => [a, b].map(|place| self.signs(place)),
            (true, false) => [a, b].map(|place| self.high(place)),
            (false, _) if width < 64 => [a, b].map(|place| self.zeros(place)),
            // Moved so that the least word is the least number.
            (false, _) => [a, b].map(|place| {
                let (value, top) = (self.zeros(place), self.to.constant(1 << 63));
                self.to.two(Two::Xor, value, top)
            }),
        };
        self.to.two(Two::Greater, b, a)
    }

    fn product(&mut self, a: Place, b: Place) -> Value {
        let signed = self.is_signed(a);
        let is_short = self.width(a) <= 32 && self.width(b) <= 32;
        let (a, b) = (self.extended(a), self.extended(b));
        let to = &mut self.to;
        if is_short {
            let how = if signed {
                Two::SignedProduct
            } else {
                Two::Product
            };
            return to.two(how, a, b);
        }
        // The high halves count in the high half of the product alone.
        let low = to.two(Two::Product, a, b);
        let (high_a, high_b) = (to.right(a, 32), to.right(b, 32));
        let (one, other) = (
            to.two(Two::Product, high_a, b),
            to.two(Two::Product, a, high_b),
        );
        let high = to.two(Two::Add, one, other);
        let high = to.left(high, 32);
        to.two(Two::Add, low, high)
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
