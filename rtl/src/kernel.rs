//! What every kernel file uses: rust-hdl's block language, the word types and a few shorthands.

pub(crate) use crate::word::{
    Doubled, Int, Word, bit_cast, signed_bit_cast, signed_cast, unsigned_cast,
};
pub(crate) use rust_hdl::core::prelude::{
    Bit, Block, Clock, Constant, In, Local, Logic, Out, Probe, Signal, Synth, Verilog, ast, clock,
    hdl_gen, logic,
};
pub(crate) use rust_hdl::widgets::dff_setup;
pub(crate) use rust_hdl::widgets::prelude::DFF;

/// Names the Verilog module of a kernel. rust-hdl passes the text on as a comment, which the emitter reads.
macro_rules! comment {
    ($name:literal) => {};
}

/// Implements [`Clocked`](crate::step::Clocked) for a block with a `clock` port.
macro_rules! clocked {
    ($block:ident $(< $(const $width:ident : usize),* >)?) => {
        impl $(< $(const $width: usize),* >)? crate::step::Clocked for $block $(< $($width),* >)? {
            fn clock_port(&mut self) -> &mut Signal<In, Clock> {
                &mut self.clock
            }
        }
    };
}

/// Implements `Block` for a struct: its input ports, its other signals and sub-blocks, its plain data.
///
/// It takes the place of `derive(LogicBlock)`, which passes a change down one level of the hierarchy in each pass and visits
/// everything in every pass. Here the inputs are taken over first, so that the clock reaches all registers in one pass, and
/// a block at rest is skipped until an input changes. The result after settling is the same: a register still copies the
/// value its input had before the pass of the edge. A field left out is refused by the compiler.
macro_rules! block {
    (
        [$($generics:tt)*] $block:ident [$($arguments:tt)*]
        inputs { $($input:ident),* }
        parts { $($part:ident),* }
        data { $($data:ident),* }
    ) => {
        impl<$($generics)*> rust_hdl::core::prelude::Block for $block<$($arguments)*> {
            fn connect_all(&mut self) {
                self.connect();
                let Self { $($input,)* $($part,)* $($data: _,)* _asleep: _ } = self;
                $($input.connect_all();)*
                $($part.connect_all();)*
            }

            fn update_all(&mut self) {
                if self._asleep && !($(crate::kernel::Pending::pending(&self.$input))||*) {
                    return;
                }
                $(self.$input.update_all();)*
                self.update();
                $(self.$part.update_all();)*
                self._asleep = !($(self.$input.has_changed() ||)* $(self.$part.has_changed())||*);
            }

            fn has_changed(&self) -> bool {
                !self._asleep
            }

            fn accept(&self, name: &str, probe: &mut dyn rust_hdl::core::prelude::Probe) {
                probe.visit_start_scope(name, self);
                $(self.$input.accept(stringify!($input), probe);)*
                $(self.$part.accept(stringify!($part), probe);)*
                probe.visit_end_scope(name, self);
            }
        }

        impl<$($generics)*> crate::kernel::Part for $block<$($arguments)*> {}

        impl<$($generics)*> crate::kernel::Ports for $block<$($arguments)*> {
            fn set_inputs(&mut self, words: &mut dyn Iterator<Item = u64>) {
                $(crate::kernel::InputPort::set(&mut self.$input, words);)*
            }

            fn outputs(&self) -> Vec<u64> {
                let mut words = Vec::new();
                $(crate::kernel::Part::push_output(&self.$part, &mut words);)*
                words
            }
        }
    };
}

/// A block, from the names of the fields that begin at their defaults and the values of the others.
macro_rules! fields {
    ([$($plain:ident),*] $($field:ident: $value:expr,)*) => {
        Self {
            $($plain: Default::default(),)*
            $($field: $value,)*
            _asleep: false,
        }
    };
}

pub(crate) use {block, clocked, comment, fields};

/// An input that has a new value to take over.
pub(crate) trait Pending {
    fn pending(&self) -> bool;
}

impl<T: Synth> Pending for Signal<In, T> {
    #[inline(always)]
    fn pending(&self) -> bool {
        self.next != self.val()
    }
}

impl<P: Pending> Pending for Vec<P> {
    fn pending(&self) -> bool {
        self.iter().any(P::pending)
    }
}

/// What a block memory gives in the place of a kernel, before the bits of its address; the emitter knows it by this text.
pub(crate) const BLOCK_MEMORY: &str = "block memory of address bits ";

/// A constant of the width the context asks for.
pub(crate) fn constant<const N: usize>(value: u64) -> Constant<Word<N>> {
    Constant::new(Word::new(value))
}

/// A signed constant of the width the context asks for.
pub(crate) fn signed_constant<const N: usize>(value: i64) -> Constant<Int<N>> {
    Constant::new(Int::new(value))
}

/// A row of equal sub-blocks.
pub(crate) fn repeat<T>(count: usize, block: impl Fn() -> T) -> Vec<T> {
    (0..count).map(|_| block()).collect()
}

/// A sub-block that one configuration of a block has and another lacks. Absent it is not in the hierarchy, and the kernel must not speak of it.
pub struct Optional<B> {
    block: B,
    is_present: bool,
}

impl<B> Optional<B> {
    pub(crate) fn new(block: B, is_present: bool) -> Self {
        Self { block, is_present }
    }
}

impl<B> std::ops::Deref for Optional<B> {
    type Target = B;

    fn deref(&self) -> &B {
        &self.block
    }
}

impl<B> std::ops::DerefMut for Optional<B> {
    fn deref_mut(&mut self) -> &mut B {
        &mut self.block
    }
}

impl<B: Block> Logic for Optional<B> {
    fn update(&mut self) {}

    fn hdl(&self) -> Verilog {
        Verilog::Empty
    }
}

impl<B: Block> Block for Optional<B> {
    fn connect_all(&mut self) {
        if self.is_present {
            self.block.connect_all();
        }
    }

    fn update_all(&mut self) {
        if self.is_present {
            self.block.update_all();
        }
    }

    fn has_changed(&self) -> bool {
        self.is_present && self.block.has_changed()
    }

    fn accept(&self, name: &str, probe: &mut dyn Probe) {
        if self.is_present {
            self.block.accept(name, probe);
        }
    }
}

impl<B> Part for Optional<B> {}

/// A value on a port.
pub trait PortValue: Synth {
    /// The value of the next word; none for a clock, which takes no word.
    fn take(words: &mut dyn Iterator<Item = u64>) -> Option<Self>;
    /// The value as a word.
    fn word(self) -> u64;
}

impl<const N: usize> PortValue for Word<N> {
    fn take(words: &mut dyn Iterator<Item = u64>) -> Option<Self> {
        words.next().map(Self::new)
    }

    fn word(self) -> u64 {
        self.get()
    }
}

impl<const N: usize> PortValue for Int<N> {
    fn take(words: &mut dyn Iterator<Item = u64>) -> Option<Self> {
        words.next().map(|word| Self::new(word as i64))
    }

    fn word(self) -> u64 {
        unsigned_cast(self).get()
    }
}

impl<const N: usize> PortValue for Doubled<N> {
    fn take(words: &mut dyn Iterator<Item = u64>) -> Option<Self> {
        words.next().map(|word| Self::new(word as i64))
    }

    fn word(self) -> u64 {
        self.get() as u64 & (u64::MAX >> (64 - Self::BITS))
    }
}

impl PortValue for Bit {
    fn take(words: &mut dyn Iterator<Item = u64>) -> Option<Self> {
        words.next().map(|word| word & 1 == 1)
    }

    fn word(self) -> u64 {
        self.into()
    }
}

impl PortValue for Clock {
    fn take(_words: &mut dyn Iterator<Item = u64>) -> Option<Self> {
        None
    }

    fn word(self) -> u64 {
        self.clk.into()
    }
}

/// An input port or an array of them.
pub(crate) trait InputPort {
    fn set(&mut self, words: &mut dyn Iterator<Item = u64>);
}

impl<T: PortValue> InputPort for Signal<In, T> {
    fn set(&mut self, words: &mut dyn Iterator<Item = u64>) {
        if let Some(value) = T::take(words) {
            self.next = value;
        }
    }
}

impl<P: InputPort> InputPort for Vec<P> {
    fn set(&mut self, words: &mut dyn Iterator<Item = u64>) {
        self.iter_mut().for_each(|port| port.set(words));
    }
}

/// A part of a block; output ports have a word to show.
pub(crate) trait Part {
    fn push_output(&self, _words: &mut Vec<u64>) {}
}

impl<T: PortValue> Part for Signal<Out, T> {
    fn push_output(&self, words: &mut Vec<u64>) {
        words.push(self.val().word());
    }
}

impl<T: Synth> Part for Signal<Local, T> {}
impl<T: Synth> Part for DFF<T> {}
impl<T: Synth> Part for Constant<T> {}

impl<P: Part> Part for Vec<P> {
    fn push_output(&self, words: &mut Vec<u64>) {
        self.iter().for_each(|part| part.push_output(words));
    }
}

/// All ports of a block at once, in their order, without the clock.
pub(crate) trait Ports {
    fn set_inputs(&mut self, words: &mut dyn Iterator<Item = u64>);
    fn outputs(&self) -> Vec<u64>;
}
