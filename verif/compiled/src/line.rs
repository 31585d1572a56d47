//! Straight-line code over words: what a function does, in the order in which it is done.
//!
//! Every lane does the same. A value is the number of the step that computes it.

use std::collections::HashMap;

/// The word that a step computes, in each lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Value(pub(crate) u32);

/// An operation on two words of 64 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Two {
    Add,
    Sub,
    And,
    Or,
    Xor,
    /// All ones where they are equal, else zero.
    Equal,
    /// All ones where the first is greater as a number, else zero.
    Greater,
    /// By a count that may be anything; zero from 64 on.
    LeftBy,
    /// As above, with zeros from the left.
    RightBy,
    /// Of the low 32 bits of each.
    Product,
    /// Of the low 32 bits of each, as numbers.
    SignedProduct,
}

impl Two {
    /// It is the same of both in the other order.
    pub(crate) fn commutes(self) -> bool {
        !matches!(self, Two::Sub | Two::Greater | Two::LeftBy | Two::RightBy)
    }
}

/// A step. Places are counted in words from the beginning of a block, of memories by their first word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Step {
    Constant(u64),
    Load(usize),
    Two(Two, Value, Value),
    Left(Value, u32),
    Right(Value, u32),
    /// The second where the top bit of the first is 1, else the third.
    Select(Value, Value, Value),
    /// The word of a memory at an index.
    Read(usize, Value),
    Store(Value, usize),
    /// To a memory: index and word.
    Write(usize, Value, Value),
    /// To the words that are given to the caller.
    Give(Value, usize),
    /// The steps before this one are done only if the top bit of a word is 1 in some lane. Of what they compute only
    /// constants are read behind them.
    OnlyIf(Value, usize),
    /// A function, by its number, of the block that begins at this place. Nothing but calls follows.
    Call(usize, usize),
}

impl Step {
    /// The values that it reads.
    pub(crate) fn reads(&self) -> impl Iterator<Item = Value> {
        let [a, b, c] = match *self {
            Step::Constant(_) | Step::Load(_) | Step::Call(..) => [None; 3],
            Step::Left(a, _) | Step::Right(a, _) | Step::Read(_, a) => [Some(a), None, None],
            Step::Store(a, _) | Step::Give(a, _) | Step::OnlyIf(a, _) => [Some(a), None, None],
            Step::Two(_, a, b) | Step::Write(_, a, b) => [Some(a), Some(b), None],
            Step::Select(a, b, c) => [Some(a), Some(b), Some(c)],
        };
        [a, b, c].into_iter().flatten()
    }

    /// It is there for its value alone.
    pub(crate) fn is_pure(&self) -> bool {
        use Step::*;
        !matches!(
            self,
            Store(..) | Write(..) | Give(..) | OnlyIf(..) | Call(..)
        )
    }
}

/// Code that is being written.
#[derive(Default)]
pub(crate) struct Line {
    pub(crate) steps: Vec<Step>,
    constants: HashMap<u64, Value>,
}

impl Line {
    pub(crate) fn add(&mut self, step: Step) -> Value {
        self.steps.push(step);
        Value(self.steps.len() as u32 - 1)
    }

    pub(crate) fn constant(&mut self, word: u64) -> Value {
        if let Some(known) = self.constants.get(&word) {
            return *known;
        }
        let value = self.add(Step::Constant(word));
        self.constants.insert(word, value);
        value
    }

    pub(crate) fn two(&mut self, how: Two, a: Value, b: Value) -> Value {
        self.add(Step::Two(how, a, b))
    }

    pub(crate) fn left(&mut self, value: Value, count: u32) -> Value {
        match count {
            0 => value,
            _ => self.add(Step::Left(value, count)),
        }
    }

    pub(crate) fn right(&mut self, value: Value, count: u32) -> Value {
        match count {
            0 => value,
            _ => self.add(Step::Right(value, count)),
        }
    }

    /// All ones where the number is negative, else zero.
    pub(crate) fn sign(&mut self, value: Value) -> Value {
        let zero = self.constant(0);
        self.two(Two::Greater, zero, value)
    }
}
