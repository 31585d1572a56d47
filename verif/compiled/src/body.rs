//! The body of a function: words of a module and of the parts that have no function of their own.
//!
//! A word is computed where it is first wanted.

use crate::lanes::Lanes;
use crate::layout::{Apart, Block, Layout, Spot, whole};
use crate::line::{Line, Step, Value};
use crate::word::Word;
use imogene_hdl::{Direction, Module, Net, Op};
use std::sync::Arc;

/// An instance in a function.
pub(crate) struct Scope<'d> {
    pub(crate) module: &'d Arc<Module>,
    /// Where its words lie, from the beginning of the function's block.
    pub(crate) spot: Spot,
    /// It is four equal instances in a function of one lane, or in them: the scopes of these alone.
    pub(crate) rows: Option<[usize; 4]>,
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
    pub(crate) lanes: Lanes,
    /// What was known before of the words of nets, while that will be wanted again.
    before: Option<Vec<(Place, Known)>>,
}

impl<'d> Body<'d> {
    /// Of the function of a module, in so many lanes.
    pub(crate) fn new(layout: &'d Layout, module: &'d Arc<Module>, lanes: Lanes) -> Body<'d> {
        let mut body = Body {
            to: Line::default(),
            layout,
            scopes: vec![],
            lanes,
            before: None,
        };
        body.open(module, whole(lanes), None, true);
        body
    }

    /// Of a part that runs apart.
    pub(crate) fn apart(layout: &'d Layout, apart: &'d Apart) -> Body<'d> {
        let mut body = Body::new(layout, &apart.module, Lanes::One);
        body.scopes[0].spot.place = apart.place;
        body
    }

    fn open(
        &mut self,
        module: &'d Arc<Module>,
        spot: Spot,
        around: Option<(usize, usize)>,
        is_own: bool,
    ) -> usize {
        self.scopes.push(Scope {
            module,
            spot,
            rows: None,
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
        let spot = self.layout.part(around.module, around.spot, index);
        let rows = around.rows;
        // Rows that run together are no part of what runs alone.
        let is_own = around.is_own
            && !self.layout.is_called(module)
            && self.layout.apart(spot).is_none()
            && (rows.is_some() || around.spot.stride == spot.stride);
        let part = self.open(module, spot, Some((scope, index)), is_own);
        self.scopes[scope].parts[index] = Some(part);
        self.scopes[part].rows = rows;
        part
    }

    /// The scope of four equal instances that run together.
    pub(crate) fn rows(&mut self, around: usize, indices: [usize; 4]) -> usize {
        let rows = indices.map(|index| self.part(around, index));
        let first = &self.scopes[rows[0]];
        let together = self.open(first.module, first.spot, None, true);
        self.scopes[together].rows = Some(rows);
        together
    }

    pub(crate) fn block(&self, scope: usize) -> &'d Block {
        let own = &self.scopes[scope];
        self.layout.block(own.module, own.spot.lanes)
    }

    /// The place of a word of a scope, by its number in the block.
    pub(crate) fn at(&self, scope: usize, word: usize) -> usize {
        self.scopes[scope].spot.word(word)
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

    pub(crate) fn width(&self, (scope, net): Place) -> u32 {
        self.scopes[scope].module.node(net).width
    }

    fn learn(&mut self, at: Place, known: Known) {
        let before = std::mem::replace(&mut self.scopes[at.0].words[at.1.0], known);
        if let Some(all) = &mut self.before {
            all.push((at, before));
        }
    }

    /// Steps that are only done if the top bit of a word is 1 in some lane; what they compute is forgotten.
    pub(crate) fn only_if(&mut self, which: Value, steps: impl FnOnce(&mut Self)) {
        let begin = self.to.add(Step::OnlyIf(which, 0));
        self.before = Some(vec![]);
        steps(self);
        for ((scope, net), known) in self.before.take().into_iter().flatten().rev() {
            self.scopes[scope].words[net.0] = known;
        }
        self.to.forget_from(begin.0 as usize);
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
    pub(crate) fn signs(&mut self, at: Place) -> Value {
        self.form(at, Word::signs)
    }

    /// With its bits as the highest.
    pub(crate) fn high(&mut self, at: Place) -> Value {
        self.form(at, Word::high)
    }

    /// With the sign of a number, or with zeros above a word.
    pub(crate) fn extended(&mut self, at: Place) -> Value {
        match self.is_signed(at) {
            true => self.signs(at),
            false => self.zeros(at),
        }
    }

    /// As it stands in memory.
    pub(crate) fn kept(&mut self, at: Place) -> Value {
        self.form(at, Word::kept)
    }

    pub(crate) fn is_signed(&self, (scope, net): Place) -> bool {
        self.scopes[scope].module.node(net).signed
    }

    /// The net of this name behind the names of the instances around it.
    pub(crate) fn find(&mut self, path: &str) -> Option<Place> {
        let mut scope = 0;
        let mut names: Vec<&str> = path.split('.').collect();
        let last = names.pop()?;
        for name in names {
            let mut instances = self.scopes[scope].module.instances.iter();
            let index = instances.position(|instance| instance.name == name)?;
            scope = self.part(scope, index);
        }
        Some((scope, named(self.scopes[scope].module, last)?))
    }
}

pub(crate) fn input_index(module: &Module, net: Net) -> usize {
    let mut inputs = module.ports_of(Direction::In);
    let place = inputs.position(|port| port.net == net);
    place.expect("an input is a port")
}

/// The port of this name, or the net.
fn named(module: &Module, name: &str) -> Option<Net> {
    let port = module.ports.iter().find(|port| port.name == name);
    port.map(|port| port.net).or_else(|| {
        let mut nets = module.nets().rev();
        nets.find(|(_, node)| node.name.as_deref() == Some(name))
            .map(|(net, _)| net)
    })
}
