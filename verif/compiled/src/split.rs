//! The steps of eight lanes as steps of vectors: a half word is one vector, a whole word is two, that of the first four
//! lanes and that of the last four.

use crate::line::{Above, Line, Shuffle, Step, Two, Value};
use crate::size::Size;

/// Words from one vector of a whole word to the other.
const BEHIND: usize = 4;

/// `inputs` is how many there are in the row of each lane; none if all lanes get the same ones.
pub(crate) fn split(line: &Line, inputs: Option<usize>) -> Line {
    let mut split = Split {
        to: Line::default(),
        vectors: vec![],
        inputs,
        region: None,
    };
    for (index, step) in line.steps.iter().enumerate() {
        split.come_to(index);
        let vectors = split.step(*step);
        split.vectors.push(vectors);
    }
    split.come_to(line.steps.len());
    split.to
}

struct Split {
    to: Line,
    /// Of each value the vectors, twice the same of half words.
    vectors: Vec<[Value; 2]>,
    inputs: Option<usize>,
    /// Where steps that are only done if begin, and the step behind them.
    region: Option<(Value, usize)>,
}

impl Split {
    fn step(&mut self, step: Step) -> [Value; 2] {
        use Step::*;
        match step {
            Constant(..) => [self.to.once(step); 2],
            Load(Size::Half, _) | Call(..) => [self.to.add(step); 2],
            Load(size, place) => [place, place + BEHIND].map(|at| self.to.add(Load(size, at))),
            Input(size, index) => self.input(size, index),
            Widen(value, above) => self.widened(value, above),
            Narrow(value, low) => [self.narrowed(value, low); 2],
            Two(how, a, b) => self.each([a, b, b], |[a, b, _]| Two(how, a, b)),
            Left(a, count) => self.each([a; 3], |[a, ..]| Left(a, count)),
            Right(a, count) => self.each([a; 3], |[a, ..]| Right(a, count)),
            Lookup(table, a) => self.each([a; 3], |[a, ..]| Lookup(table, a)),
            Select(which, then, or) => {
                let which = self.tops(which, then.1);
                let [then, or] = [then, or].map(|value| self.of(value));
                [0, 1].map(|part| self.to.once(Select(which[part], then[part], or[part])))
            }
            Read(place, at) => {
                let at = self.of(at);
                [0, 1].map(|part| self.to.add(Read(place + BEHIND * part, at[part])))
            }
            Write(place, at, value) => {
                let (at, value) = (self.of(at), self.of(value));
                [0, 1].map(|part| {
                    self.to
                        .add(Write(place + BEHIND * part, at[part], value[part]))
                })
            }
            Store(value, place) => {
                self.put(value, |value, part| Store(value, place + BEHIND * part))
            }
            Give(value, place) => self.put(value, |value, part| Give(value, place + BEHIND * part)),
            OnlyIf(which, end) => {
                let [which, _] = self.of(which);
                let begin = self.to.add(OnlyIf(which, 0));
                self.region = Some((begin, end));
                [begin; 2]
            }
            _ => unreachable!("{step:?} in eight lanes"),
        }
    }

    /// Ends what is only done if, when its steps are over.
    fn come_to(&mut self, index: usize) {
        if let Some((begin, _)) = self.region.take_if(|(_, end)| *end == index) {
            let place = begin.0 as usize;
            let end = self.to.steps.len();
            if let Step::OnlyIf(_, unknown) = &mut self.to.steps[place] {
                *unknown = end;
            }
            self.to.forget_from(place);
        }
    }

    fn of(&self, value: Value) -> [Value; 2] {
        self.vectors[value.0 as usize]
    }

    /// A step for each vector of words of one size.
    fn each(&mut self, reads: [Value; 3], step: impl Fn([Value; 3]) -> Step) -> [Value; 2] {
        let reads = reads.map(|value| self.of(value));
        [0, 1].map(|part| self.to.once(step(reads.map(|vectors| vectors[part]))))
    }

    fn put(&mut self, value: Value, step: impl Fn(Value, usize) -> Step) -> [Value; 2] {
        let [low, high] = self.of(value);
        let first = self.to.add(step(low, 0));
        match value.1 {
            Size::Half => [first; 2],
            Size::Whole => [first, self.to.add(step(high, 1))],
        }
    }

    fn input(&mut self, size: Size, index: usize) -> [Value; 2] {
        let Some(inputs) = self.inputs else {
            return [self.to.once(Step::Input(size, index)); 2];
        };
        let first = index / 4 * 4;
        let count = (inputs - first).min(4);
        let rows: [[Value; 2]; 4] = std::array::from_fn(|lane| {
            let lanes = [lane, lane + BEHIND];
            lanes.map(|lane| self.to.once(Step::Row(lane, first, count)))
        });
        let place = index - first;
        match size {
            Size::Whole => {
                let turn = [Shuffle::Even, Shuffle::Odd][place % 2];
                [0, 1].map(|part| self.picked(rows.map(|row| row[part]), turn, place))
            }
            Size::Half => {
                let both = |[a, b]: [Value; 2]| Step::Shuffle(Shuffle::LowHalves, a, b);
                let rows = rows.map(|row| self.to.once(both(row)));
                let turn = [Shuffle::LowHalves, Shuffle::HighHalves][place % 2];
                [self.picked(rows, turn, place).read_as(size); 2]
            }
        }
    }

    /// The word at a place in each of four vectors; `turn` takes it from two of them.
    fn picked(&mut self, [a, b, c, d]: [Value; 4], turn: Shuffle, place: usize) -> Value {
        let [front, back] = [(a, b), (c, d)].map(|(a, b)| self.to.once(Step::Shuffle(turn, a, b)));
        let half = [Shuffle::Front, Shuffle::Back][place / 2];
        self.to.once(Step::Shuffle(half, front, back))
    }

    /// The half words of the last four lanes, as whole ones with zeros above.
    fn last(&mut self, vector: Value) -> Value {
        self.to
            .once(Step::Right(vector.read_as(Size::Whole), Size::Half.bits()))
    }

    fn widened(&mut self, value: Value, above: Above) -> [Value; 2] {
        let vector = self.of(value)[0];
        let both = [vector.read_as(Size::Whole), self.last(vector)];
        match above {
            Above::Anything => both,
            Above::Zeros => {
                let mask = self.to.constant(Size::Whole, u64::from(u32::MAX));
                [self.to.once(Step::Two(Two::And, both[0], mask)), both[1]]
            }
            Above::Signs => {
                let one = self.to.constant(Size::Whole, 1);
                both.map(|words| self.to.once(Step::Two(Two::SignedProduct, words, one)))
            }
        }
    }

    fn narrowed(&mut self, value: Value, low: u32) -> Value {
        let both = self.of(value);
        match low == 0 && self.to.is_mask(both[0]) && self.to.is_mask(both[1]) {
            true => self.to.once(Step::Blend(both[0], both[1])),
            false => self.joined(both, low),
        }
    }

    /// The 32 bits from one on of each of two vectors of whole words.
    fn joined(&mut self, [first, last]: [Value; 2], low: u32) -> Value {
        let half = Size::Half.bits();
        let first = match low {
            0 => first,
            _ => self.to.once(Step::Right(first, low)),
        };
        let last = match low {
            _ if low == half => last,
            _ if low > half => self.to.once(Step::Right(last, low - half)),
            _ => self.to.once(Step::Left(last, half - low)),
        };
        self.to.once(Step::Blend(first, last))
    }

    /// Top bits, as those of words of another size.
    fn tops(&mut self, which: Value, size: Size) -> [Value; 2] {
        let both = self.of(which);
        match (which.1, size) {
            (Size::Half, Size::Whole) => {
                let last = both[0].read_as(size);
                [self.to.once(Step::Left(last, Size::Half.bits())), last]
            }
            (Size::Whole, Size::Half) => [self.joined(both, Size::Half.bits()); 2],
            _ => both,
        }
    }
}
