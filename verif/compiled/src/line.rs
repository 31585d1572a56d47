//! Straight-line code over words: what a function does, in the order in which it is done.
//!
//! Every lane does the same. A value is the number of the step that computes it.

use crate::size::{Size, blended};
use std::collections::{HashMap, HashSet};

const ONES: u64 = u64::MAX;

/// The word that a step computes, in each lane.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) struct Value(pub(crate) u32, pub(crate) Size);

impl Value {
    /// The same vector with words of another size in it.
    pub(crate) fn read_as(self, size: Size) -> Value {
        Value(self.0, size)
    }
}

/// An operation on two words of one size.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Two {
    Add,
    Sub,
    And,
    /// The bits of the second that the first does not have.
    AndNot,
    Or,
    Xor,
    /// All ones where they are equal, else zero.
    Equal,
    /// All ones where the first is greater as a number, else zero.
    Greater,
    /// By a count that may be anything; zero where nothing stays.
    LeftBy,
    /// As above, with zeros from the left.
    RightBy,
    /// Of the low 32 bits of each; of half words half a product.
    Product,
    /// The same as numbers.
    SignedProduct,
}

impl Two {
    pub(crate) fn of(self, size: Size, a: u64, b: u64) -> u64 {
        size.apply([a, b], |words| match self {
            Two::Greater => self.of_words(words.map(|word| size.signed(word))),
            _ => self.of_words(words),
        })
    }

    fn of_words(self, [a, b]: [u64; 2]) -> u64 {
        let mask = |is_so: bool| if is_so { ONES } else { 0 };
        let by = |count: u64| u32::try_from(count).unwrap_or(u32::MAX);
        match self {
            Two::Add => a.wrapping_add(b),
            Two::Sub => a.wrapping_sub(b),
            Two::And => a & b,
            Two::AndNot => !a & b,
            Two::Or => a | b,
            Two::Xor => a ^ b,
            Two::Equal => mask(a == b),
            Two::Greater => mask(a as i64 > b as i64),
            Two::LeftBy => a.checked_shl(by(b)).unwrap_or(0),
            Two::RightBy => a.checked_shr(by(b)).unwrap_or(0),
            Two::Product => u64::from(a as u32) * u64::from(b as u32),
            Two::SignedProduct => (i64::from(a as i32) * i64::from(b as i32)) as u64,
        }
    }

    /// It is the same of both in the other order.
    pub(crate) fn commutes(self) -> bool {
        use Two::*;
        !matches!(self, Sub | AndNot | Greater | LeftBy | RightBy)
    }
}

/// Words of two vectors in one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Shuffle {
    /// The first and the third of each, in turn.
    Even,
    /// The others, likewise.
    Odd,
    /// The first two of each.
    Front,
    /// The last two of each.
    Back,
    /// Of each pair of words their low half words, two of each vector in turn.
    LowHalves,
    /// Their high ones, likewise.
    HighHalves,
}

impl Shuffle {
    pub(crate) fn of(self, a: [u64; 4], b: [u64; 4]) -> [u64; 4] {
        match self {
            Shuffle::Even => [a[0], b[0], a[2], b[2]],
            Shuffle::Odd => [a[1], b[1], a[3], b[3]],
            Shuffle::Front => [a[0], a[1], b[0], b[1]],
            Shuffle::Back => [a[2], a[3], b[2], b[3]],
            Shuffle::LowHalves => [[a[0], a[1]], [b[0], b[1]], [a[2], a[3]], [b[2], b[3]]]
                .map(|[low, high]| blended(low, high << 32)),
            Shuffle::HighHalves => {
                Shuffle::LowHalves.of(a.map(|word| word >> 32), b.map(|word| word >> 32))
            }
        }
    }
}

/// What stands above a half word where it becomes a whole one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Above {
    Anything,
    Zeros,
    Signs,
}

/// A step. Places are counted in words of 64 bits from the beginning of a block, of memories by their first word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Step {
    /// A word for each lane.
    Constant(Size, [u64; 4]),
    Load(Size, usize),
    /// An input of the whole, the same in each lane.
    Input(Size, usize),
    /// In the row of a lane four inputs from one on, or as many as there are.
    Row(usize, usize, usize),
    /// Four words that lie side by side, where everything else has one lane.
    LoadFour(usize),
    /// Words of one lane side by side.
    Gather([Value; 4]),
    /// Four words, the first lane of which is another word of one lane.
    Patch(Value, Value),
    /// A half word as a whole one.
    Widen(Value, Above),
    /// The 32 bits of a whole word from one on.
    Narrow(Value, u32),
    /// The low half words of one vector, the high ones of another.
    Blend(Value, Value),
    Shuffle(Shuffle, Value, Value),
    Two(Two, Value, Value),
    Left(Value, u32),
    Right(Value, u32),
    /// The second where the top bit of the first is 1, else the third.
    Select(Value, Value, Value),
    /// For each half word that of eight which its low three bits say; whole words are two.
    Lookup([u64; 4], Value),
    /// The word of a memory at an index.
    Read(usize, Value),
    Store(Value, usize),
    /// To a memory: index and word.
    Write(usize, Value, Value),
    /// To the words that are given to the caller, at this one.
    Give(Value, usize),
    /// The steps before this one are done only if the top bit of a word is 1 in some lane. Of what they compute only
    /// constants are read behind them.
    OnlyIf(Value, usize),
    /// A function, by its number, of the block that begins at this place. Nothing but calls follows.
    Call(usize, usize),
}

impl Step {
    pub(crate) fn reads(&self) -> impl Iterator<Item = Value> {
        use Step::*;
        let reads = match *self {
            Constant(..) | Load(..) | LoadFour(_) | Input(..) | Row(..) | Call(..) => [None; 4],
            Left(a, _) | Right(a, _) | Read(_, a) | Lookup(_, a) => [Some(a), None, None, None],
            Widen(a, _) | Narrow(a, _) => [Some(a), None, None, None],
            Store(a, _) | Give(a, _) | OnlyIf(a, _) => [Some(a), None, None, None],
            Two(_, a, b) | Write(_, a, b) => [Some(a), Some(b), None, None],
            Patch(a, b) | Blend(a, b) | Shuffle(_, a, b) => [Some(a), Some(b), None, None],
            Select(a, b, c) => [Some(a), Some(b), Some(c), None],
            Gather(lanes) => lanes.map(Some),
        };
        reads.into_iter().flatten()
    }

    /// Of what it computes.
    pub(crate) fn size(&self) -> Size {
        use Step::*;
        match self {
            Constant(size, _) | Load(size, _) | Input(size, ..) => *size,
            Two(_, a, _) | Left(a, _) | Right(a, _) | Select(_, a, _) | Lookup(_, a) => a.1,
            Narrow(..) | Blend(..) => Size::Half,
            _ => Size::Whole,
        }
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

/// Code that is being written. Equal steps are one, and simple ones are folded.
#[derive(Default)]
pub(crate) struct Line {
    pub(crate) steps: Vec<Step>,
    known: HashMap<Step, Value>,
    /// Values that are all ones or zero.
    masks: HashSet<Value>,
}

impl Line {
    pub(crate) fn add(&mut self, step: Step) -> Value {
        self.steps.push(step);
        Value(self.steps.len() as u32 - 1, step.size())
    }

    /// A step that follows from what it reads alone.
    pub(crate) fn once(&mut self, step: Step) -> Value {
        if let Some(known) = self.known.get(&step) {
            return *known;
        }
        let is_mask = match step {
            Step::Constant(_, words) => words.iter().all(|word| matches!(*word, 0 | ONES)),
            Step::Widen(a, Above::Signs) | Step::Narrow(a, 0) => self.is_mask(a),
            Step::Gather(lanes) => lanes.iter().all(|lane| self.is_mask(*lane)),
            Step::Patch(a, b) => self.is_mask(a) && self.is_mask(b),
            Step::Two(how, a, b) => match how {
                Two::Equal | Two::Greater => true,
                Two::And | Two::AndNot | Two::Or | Two::Xor => self.is_mask(a) && self.is_mask(b),
                _ => false,
            },
            Step::Select(_, a, b) => self.is_mask(a) && self.is_mask(b),
            _ => false,
        };
        let value = self.add(step);
        self.known.insert(step, value);
        if is_mask {
            self.masks.insert(value);
        }
        value
    }

    pub(crate) fn is_mask(&self, value: Value) -> bool {
        self.masks.contains(&value)
    }

    /// Steps from this one on may not have been done: only constants among them may be read.
    pub(crate) fn forget_from(&mut self, begin: usize) {
        let is_kept = |step: &Step, value: &Value| {
            matches!(step, Step::Constant(..)) || (value.0 as usize) < begin
        };
        self.known.retain(|step, value| is_kept(step, value));
    }

    pub(crate) fn step(&self, value: Value) -> Step {
        self.steps[value.0 as usize]
    }

    fn as_constants(&self, value: Value) -> Option<[u64; 4]> {
        match self.step(value) {
            Step::Constant(_, words) => Some(words),
            _ => None,
        }
    }

    /// A constant that is the same in every lane.
    pub(crate) fn as_constant(&self, value: Value) -> Option<u64> {
        let words = self.as_constants(value)?;
        (words == [words[0]; 4]).then_some(words[0])
    }

    fn constants(&mut self, size: Size, words: [u64; 4]) -> Value {
        self.once(Step::Constant(size, words))
    }

    pub(crate) fn constant(&mut self, size: Size, word: u64) -> Value {
        self.constants(size, [size.in_each(word); 4])
    }

    /// A half word as a whole one, or a whole one as it is.
    pub(crate) fn widened(&mut self, value: Value, above: Above) -> Value {
        match value.1 {
            Size::Half => self.once(Step::Widen(value, above)),
            Size::Whole => value,
        }
    }

    /// The 32 bits of a whole word from one on.
    pub(crate) fn narrowed(&mut self, value: Value, low: u32) -> Value {
        self.once(Step::Narrow(value, low))
    }

    /// Words of the block that are all ones or zero.
    pub(crate) fn load_mask(&mut self, load: Step) -> Value {
        let value = self.add(load);
        self.masks.insert(value);
        value
    }

    /// Four words of one lane side by side.
    pub(crate) fn gather(&mut self, lanes: [Value; 4]) -> Value {
        let constants = lanes.map(|lane| self.as_constant(lane));
        match constants {
            [Some(a), Some(b), Some(c), Some(d)] => self.constants(Size::Whole, [a, b, c, d]),
            _ => self.once(Step::Gather(lanes)),
        }
    }

    /// A value of rows that run together, which may be a constant.
    pub(crate) fn in_four(&mut self, value: Value) -> Value {
        match self.as_constant(value) {
            Some(_) => self.once(Step::Gather([value; 4])),
            None => value,
        }
    }

    /// Words side by side with another in front.
    pub(crate) fn patch(&mut self, first: Value, others: Value) -> Value {
        self.once(Step::Patch(first, others))
    }

    pub(crate) fn reads_inputs(&self) -> bool {
        let is_input = |step: &Step| matches!(step, Step::Input(..) | Step::Row(..));
        self.steps.iter().any(is_input)
    }

    /// What is of four lanes where all else is of one.
    pub(crate) fn of_four(&self) -> Vec<bool> {
        let mut found: Vec<bool> = vec![];
        for step in &self.steps {
            found.push(match step {
                Step::LoadFour(_) | Step::Gather(_) | Step::Patch(..) => true,
                Step::Constant(_, words) => *words != [words[0]; 4],
                _ => step.reads().any(|value| found[value.0 as usize]),
            });
        }
        found
    }

    /// What a value is the inverse of.
    fn inverse(&self, value: Value) -> Option<Value> {
        match self.step(value) {
            Step::Two(Two::Xor, a, b) if self.as_constant(b) == Some(ONES) => Some(a),
            _ => None,
        }
    }

    pub(crate) fn two(&mut self, how: Two, a: Value, b: Value) -> Value {
        let size = a.1;
        assert_eq!(size, b.1, "words of one size");
        // A constant stands second.
        let (a, b) = match self.as_constant(a) {
            Some(_) if how.commutes() => (b, a),
            _ => (a, b),
        };
        if let (Some(a), Some(b)) = (self.as_constants(a), self.as_constants(b)) {
            return self.constants(
                size,
                [0, 1, 2, 3].map(|lane| how.of(size, a[lane], b[lane])),
            );
        }
        match (self.as_constant(a), self.as_constant(b)) {
            (_, Some(0)) => match how {
                Two::Add | Two::Sub | Two::Or | Two::Xor | Two::LeftBy | Two::RightBy => return a,
                Two::And | Two::AndNot | Two::Product | Two::SignedProduct => return b,
                _ => {}
            },
            (_, Some(ONES)) if how == Two::And => return a,
            (_, Some(ONES)) if how == Two::Or => return b,
            (_, Some(ONES)) if how == Two::Xor => {
                if let Some(inverse) = self.inverse(a) {
                    return inverse;
                }
            }
            (_, Some(mask)) if how == Two::And => {
                if let Step::Two(Two::And, a, inner) = self.step(a)
                    && let Some(inner) = self.as_constant(inner)
                {
                    let mask = self.constants(size, [mask & inner; 4]);
                    return self.two(Two::And, a, mask);
                }
            }
            _ => {}
        }
        if how == Two::Equal
            && self.as_constant(b) == Some(0)
            && let Some(top) = self.on_top(a)
        {
            let ones = self.constant(size, ONES);
            return self.two(Two::Greater, top, ones);
        }
        if how == Two::And {
            for (a, b) in [(a, b), (b, a)] {
                if let Some(inverse) = self.inverse(a) {
                    return self.once(Step::Two(Two::AndNot, inverse, b));
                }
            }
        }
        self.once(Step::Two(how, a, b))
    }

    pub(crate) fn left(&mut self, value: Value, count: u32) -> Value {
        let size = value.1;
        let shifted = |word: u64| size.left(word, count);
        match self.step(value) {
            _ if count == 0 => value,
            Step::Constant(_, words) => self.constants(size, words.map(shifted)),
            Step::Left(inner, more) if count + more < size.bits() => self.left(inner, count + more),
            // A mask of bits that are shifted out.
            Step::Two(Two::And, inner, mask)
                if self
                    .as_constant(mask)
                    .is_some_and(|mask| shifted(mask) == shifted(ONES)) =>
            {
                self.left(inner, count)
            }
            _ => self.once(Step::Left(value, count)),
        }
    }

    /// By a count of each lane.
    fn left_each(&mut self, value: Value, counts: [u32; 4]) -> Value {
        if counts == [counts[0]; 4] {
            return self.left(value, counts[0]);
        }
        let counts = self.constants(value.1, counts.map(u64::from));
        self.two(Two::LeftBy, value, counts)
    }

    /// What is zero but for one bit of a word, with this bit as the highest one.
    fn on_top(&mut self, value: Value) -> Option<Value> {
        let Step::Two(Two::And, word, bit) = self.step(value) else {
            return None;
        };
        let bits = self.as_constants(bit)?.map(|bit| word.1.first(bit));
        let top = word.1.bits() - 1;
        let is_one = bits.iter().all(|bit| bit.is_power_of_two());
        is_one.then(|| self.left_each(word, bits.map(|bit| top - bit.ilog2())))
    }

    pub(crate) fn right(&mut self, value: Value, count: u32) -> Value {
        let size = value.1;
        match self.step(value) {
            _ if count == 0 => value,
            Step::Constant(_, words) => {
                self.constants(size, words.map(|word| size.right(word, count)))
            }
            Step::Right(inner, more) if count + more < size.bits() => {
                self.right(inner, count + more)
            }
            _ => self.once(Step::Right(value, count)),
        }
    }

    /// One of two words, by the top bit of another.
    pub(crate) fn select(&mut self, which: Value, then: Value, or: Value) -> Value {
        if then == or {
            return then;
        }
        if let Some(inverse) = self.inverse(which) {
            return self.select(inverse, or, then);
        }
        match self.step(which) {
            Step::Constant(_, words) if words.iter().all(|word| word >> 63 == 1) => return then,
            Step::Constant(_, words) if words.iter().all(|word| word >> 63 == 0) => return or,
            // The sign of a number is its top bit.
            Step::Two(Two::Greater, zero, number) if self.as_constant(zero) == Some(0) => {
                return self.select(number, then, or);
            }
            Step::Two(Two::Greater, number, ones) if self.as_constant(ones) == Some(ONES) => {
                return self.select(number, or, then);
            }
            _ => {}
        }
        let [zero, ones] =
            [0, ONES].map(|word| [then, or].map(|v| self.as_constant(v) == Some(word)));
        match (self.is_mask(which) && which.1 == then.1, zero, ones) {
            (true, [_, true], _) => self.two(Two::And, which, then),
            (true, [true, _], _) => self.two(Two::AndNot, which, or),
            (true, _, [true, _]) => self.two(Two::Or, which, or),
            _ => self.once(Step::Select(which, then, or)),
        }
    }

    /// One of eight constants of 32 bits, by the low bits of a word, with anything above in a whole word.
    pub(crate) fn lookup(&mut self, table: [u64; 8], index: Value) -> Value {
        let pair = |at: usize| blended(table[at], table[at + 1] << 32);
        self.once(Step::Lookup([0, 2, 4, 6].map(pair), index))
    }

    /// All ones where the number is negative, else zero.
    pub(crate) fn sign(&mut self, value: Value) -> Value {
        let zero = self.constant(value.1, 0);
        self.two(Two::Greater, zero, value)
    }
}
