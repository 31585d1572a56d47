//! What each operation of a circuit is in steps.

use crate::body::{Body, Place, input_index};
use crate::lanes::Lanes;
use crate::layout::Spot;
use crate::line::{Above, Line, Step, Two, Value};
use crate::size::Size;
use crate::word::Word;
use imogene_hdl::{Binary, Net, Node, Op};

impl Body<'_> {
    fn load(&mut self, scope: usize, word: usize, width: u32) -> Word {
        let own = &self.scopes[scope];
        let (place, spot) = (self.at(scope, word), own.spot);
        match own.rows {
            Some(_) => self.loaded(Step::LoadFour(place), width),
            None if self.lanes == Lanes::One && Size::of(width, spot.lanes) == Size::Half => {
                self.load_half(spot, word, width)
            }
            None => self.loaded(Step::Load(self.size(width), place), width),
        }
    }

    /// A half word of one lane of eight.
    fn load_half(&mut self, spot: Spot, word: usize, width: u32) -> Word {
        let half = Size::Half.bits();
        let place = spot.place + word * spot.stride + spot.lane % 4;
        let load = self.to.add(Step::Load(Size::Whole, place));
        let (value, high) = match spot.lane < 4 {
            true => (load, self.to.left(load, half)),
            false => (self.to.right(load, half), load),
        };
        match width {
            1 => Word::new(value, 1).with_bit_on_top(high),
            _ => Word::new(value, width),
        }
    }

    /// The place of a whole word of one lane.
    pub(crate) fn whole_word(&self, scope: usize, word: usize, width: u32) -> Option<usize> {
        let spot = self.scopes[scope].spot;
        (Size::of(width, spot.lanes) == Size::Whole).then(|| self.at(scope, word))
    }

    /// The place of the words of a net that eight parts of one group have, where these are the nets, in their order;
    /// from the number of those that count on they may be any.
    pub(crate) fn in_eight(&mut self, nets: &[Place; 8], count: usize) -> Option<usize> {
        let origins = nets.map(|net| self.origin(net));
        let mut places = origins
            .iter()
            .take(count)
            .enumerate()
            .map(|(lane, (scope, net))| {
                let own = &self.scopes[*scope];
                let Op::Register(index) = own.module.node(*net).op else {
                    return None;
                };
                let is_there = own.spot.lanes == Lanes::Eight && own.spot.lane == lane;
                is_there.then(|| self.at(*scope, self.block(*scope).register(index)) - lane)
            });
        let first = places.next()??;
        places.all(|place| place == Some(first)).then_some(first)
    }

    fn loaded(&mut self, load: Step, width: u32) -> Word {
        match width {
            1 => Word::as_kept(self.to.load_mask(load), 1),
            _ => Word::as_kept(self.to.add(load), width),
        }
    }

    /// Nets of one lane side by side, of which the first so many count: what lies so is read so, perhaps but for the
    /// first one.
    pub(crate) fn side_by_side(&mut self, nets: [Place; 4], count: usize, width: u32) -> Word {
        let origins = nets.map(|net| self.origin(net));
        if count == 1 {
            return Word::as_kept(self.kept(origins[0]), width);
        }
        let places = origins.map(
            |(scope, net)| match self.scopes[scope].module.node(net).op {
                Op::Register(index) => {
                    self.whole_word(scope, self.block(scope).register(index), width)
                }
                _ => None,
            },
        );
        let follows = |lane: usize| {
            let before = places[lane - 1];
            lane >= count || before.is_some_and(|before| places[lane] == Some(before + 1))
        };
        let first = places[1].and_then(|second| second.checked_sub(1));
        if let (Some(first), true, true) = (first, follows(2), follows(3)) {
            let others = self.loaded(Step::LoadFour(first), width);
            if follows(1) {
                return others;
            }
            let first = self.kept(origins[0]);
            let all = self.to.patch(first, others.value);
            return Word::as_kept(all, width);
        }
        let lanes = origins.map(|origin| self.kept(origin));
        Word::as_kept(self.to.gather(lanes), width)
    }

    pub(crate) fn compute(&mut self, at: Place) -> Word {
        let (scope, net) = at;
        let module = self.scopes[scope].module;
        let block = self.block(scope);
        let width = module.node(net).width;
        let in_scope = |net: &Net| (scope, *net);
        match &module.node(net).op {
            Op::Literal(bits) => Word::constant(*bits, width, self.size(width), &mut self.to),
            Op::Input => match self.scopes[scope].rows {
                Some(rows) => {
                    // The last lane may be the third part again.
                    let count = if rows[3] == rows[2] { 3 } else { 4 };
                    self.side_by_side(rows.map(|row| (row, net)), count, width)
                }
                None if self.layout.is_top(module) => {
                    // As it was handed over: with anything above.
                    let input = Step::Input(self.size(width), input_index(module, net));
                    Word::new(self.to.add(input), width)
                }
                None => self.load(scope, block.input(input_index(module, net)), width),
            },
            Op::Register(index) => self.load(scope, block.register(*index), width),
            Op::Read(index) => {
                let place = self.at(scope, block.memories[*index]);
                let read = self.to.add(Step::Load(Size::Whole, place));
                Word::with_zeros_above(self.low(read, self.size(width)), width)
            }
            Op::Not(a) => {
                if let Some(same) = self.inverse(in_scope(a)) {
                    return self.word(same);
                }
                let a = self.word(in_scope(a));
                let ones = self.to.constant(a.size(), u64::MAX);
                let how = |to: &mut Line, value| to.two(Two::Xor, value, ones);
                match a.signs {
                    Some(signs) => Word::with_signs_above(how(&mut self.to, signs), width),
                    None => Word::new(how(&mut self.to, a.value), width),
                }
            }
            Op::Binary(binary, a, b) => self.binary(*binary, in_scope(a), in_scope(b), width),
            Op::Select(which, a, b) => {
                if let Some(word) = self.looked_up(at, (scope, *which)) {
                    return word;
                }
                let (which, a, b) = match self.inverse(in_scope(which)) {
                    Some(inverse) => (inverse, b, a),
                    None => (in_scope(which), a, b),
                };
                let which = self.high(which);
                let (a, b) = (self.word(in_scope(a)), self.word(in_scope(b)));
                self.together(a, b, width, |to, a, b| to.select(which, a, b))
            }
            Op::Slice(a, low) => self.slice(in_scope(a), *low, width),
            Op::Join(parts) => {
                let first = self.word(in_scope(&parts[0]));
                let is_signed = first.signs.is_some();
                let value = first.signs.or(first.zeros).unwrap_or(first.value);
                let above = match (is_signed, first.zeros) {
                    (true, _) => Above::Signs,
                    (false, Some(_)) => Above::Zeros,
                    (false, None) => Above::Anything,
                };
                let mut wide = module.node(parts[0]).width;
                let joined = parts[1..].iter().fold(value, |mut high, part| {
                    let more = module.node(*part).width;
                    wide += more;
                    if self.size(wide) == Size::Whole {
                        high = self.to.widened(high, above);
                    }
                    let high = self.to.left(high, more);
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
                let value = self.extended_to(in_scope(a), self.size(width));
                match module.node(*a).signed {
                    true => Word::with_signs_above(value, width),
                    false => Word::with_zeros_above(value, width),
                }
            }
            op => unreachable!("{op:?} is another name"),
        }
    }

    /// Constants that are chosen by three bits of a word, the highest of which is this one.
    fn looked_up(&mut self, chosen: Place, which: Place) -> Option<Word> {
        let width = self.width(chosen);
        let (index, top) = self.as_bit(which)?;
        let low = top.checked_sub(2).filter(|_| width <= Size::Half.bits())?;
        let mut table = [0; 8];
        for (entry, place) in table.iter_mut().zip(0..) {
            *entry = self.constant_at(chosen, (index, low), place)?;
        }
        let (from, size) = (self.word(index).value, self.size(width));
        let index = match from.1 == size {
            true => self.to.right(from, low),
            false => self.to.narrowed(from, low),
        };
        Some(Word::new(self.to.lookup(table, index), width))
    }

    /// Which bit of another net a net is.
    fn as_bit(&mut self, at: Place) -> Option<(Place, u32)> {
        let (scope, net) = self.origin(at);
        match self.scopes[scope].module.node(net) {
            Node {
                op: Op::Slice(a, low),
                width: 1,
                ..
            } => Some((self.origin((scope, *a)), *low)),
            _ => None,
        }
    }

    /// What a net is where three bits of another, from one on, are those of a number; nothing else may choose.
    fn constant_at(&mut self, at: Place, index: (Place, u32), bits: u32) -> Option<u64> {
        let (scope, net) = self.origin(at);
        match self.scopes[scope].module.node(net).op {
            Op::Literal(word) => Some(word),
            Op::Select(which, a, b) => {
                let (chooses, bit) = self.as_bit((scope, which))?;
                let bit = bit
                    .checked_sub(index.1)
                    .filter(|bit| *bit < 3 && chooses == index.0)?;
                let chosen = if bits >> bit & 1 == 1 { a } else { b };
                self.constant_at((scope, chosen), index, bits)
            }
            _ => None,
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

    /// Of a net with so many bits.
    pub(crate) fn size(&self, width: u32) -> Size {
        Size::of(width, self.lanes)
    }

    /// The low bits of a word in a size that is no greater.
    fn low(&mut self, value: Value, size: Size) -> Value {
        match value.1 == size {
            true => value,
            false => self.to.narrowed(value, 0),
        }
    }

    /// With the sign of a number, or with zeros above a word, in a size that is no less.
    pub(crate) fn extended_to(&mut self, at: Place, size: Size) -> Value {
        let value = self.extended(at);
        match (size, self.is_signed(at)) {
            (Size::Half, _) => value,
            (Size::Whole, true) => self.to.widened(value, Above::Signs),
            (Size::Whole, false) => self.to.widened(value, Above::Zeros),
        }
    }

    /// With zeros above, in a size that is no less.
    pub(crate) fn zeros_to(&mut self, at: Place, size: Size) -> Value {
        let value = self.zeros(at);
        match size {
            Size::Half => value,
            Size::Whole => self.to.widened(value, Above::Zeros),
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
            Some(signs) if self.width(low) == 1 && signs.1 == high.1 => {
                self.to.two(Two::Sub, high, signs)
            }
            _ => {
                let low = self.zeros_to(low, high.1);
                self.to.two(Two::Or, high, low)
            }
        }
    }

    fn slice(&mut self, a: Place, low: u32, width: u32) -> Word {
        let (whole, from) = (self.width(a), self.word(a));
        let is_top = low + width == whole;
        if from.size() != self.size(width) {
            return self.half(from, low, is_top, width);
        }
        let word = match (is_top, from.zeros) {
            (true, Some(zeros)) => Word::with_zeros_above(self.to.right(zeros, low), width),
            _ => Word::new(self.to.right(from.value, low), width),
        };
        match width {
            1 if is_top && from.signs.is_some() => word.with_bit_on_top(self.signs(a)),
            1 => {
                let above = from.size().bits() - 1 - low;
                word.with_bit_on_top(self.to.left(from.value, above))
            }
            _ => word,
        }
    }

    /// Bits of a whole word in a half one.
    fn half(&mut self, from: Word, low: u32, is_top: bool, width: u32) -> Word {
        let word = match (is_top, from.zeros) {
            (true, Some(zeros)) => Word::with_zeros_above(self.to.narrowed(zeros, low), width),
            _ => Word::new(self.to.narrowed(from.value, low), width),
        };
        match low.checked_sub(Size::Half.bits() - 1) {
            Some(low) if width == 1 => word.with_bit_on_top(self.to.narrowed(from.value, low)),
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
            Binary::Add => self.sum(Two::Add, a, b, width),
            Binary::Sub => self.sum(Two::Sub, a, b, width),
            Binary::Mul => Word::new(self.product(a, b), width),
            Binary::And => self.bit_by_bit(Two::And, a, b, width),
            Binary::Or => self.bit_by_bit(Two::Or, a, b, width),
            Binary::Xor => self.bit_by_bit(Two::Xor, a, b, width),
            Binary::Left => {
                let size = self.size_of_both(a, b);
                let (value, count) = (self.word(a).value, self.zeros_to(b, size));
                let value = match size {
                    Size::Half => value,
                    Size::Whole => self.to.widened(value, Above::Anything),
                };
                let shifted = self.to.two(Two::LeftBy, value, count);
                Word::new(self.low(shifted, self.size(width)), width)
            }
            Binary::Right => {
                let size = self.size_of_both(a, b);
                let (value, count) = (self.extended_to(a, size), self.zeros_to(b, size));
                if !self.is_signed(a) {
                    let shifted = self.to.two(Two::RightBy, value, count);
                    return Word::with_zeros_above(self.low(shifted, self.size(width)), width);
                }
                // Bits that equal the sign are zeros here, so that zeros are shifted in.
                let sign = self.to.sign(value);
                let magnitude = self.to.two(Two::Xor, value, sign);
                let shifted = self.to.two(Two::RightBy, magnitude, count);
                let shifted = self.to.two(Two::Xor, shifted, sign);
                Word::with_signs_above(self.low(shifted, self.size(width)), width)
            }
            Binary::Equal => {
                let equal = self.equal(a, b);
                Word::with_signs_above(self.low(equal, self.size(1)), width)
            }
            Binary::Less => {
                let less = self.less(a, b);
                Word::with_signs_above(self.low(less, self.size(1)), width)
            }
        }
    }

    /// The greater of the sizes of two nets.
    fn size_of_both(&self, a: Place, b: Place) -> Size {
        self.size(self.width(a).max(self.width(b)))
    }

    fn sum(&mut self, how: Two, a: Place, b: Place, width: u32) -> Word {
        let (a, b) = (self.word(a).value, self.word(b).value);
        Word::new(self.to.two(how, a, b), width)
    }

    fn bit_by_bit(&mut self, how: Two, a: Place, b: Place, width: u32) -> Word {
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

    /// All ones where both are equal.
    fn equal(&mut self, a: Place, b: Place) -> Value {
        let (one, other) = (self.word(a), self.word(b));
        let signed = one.is_of(true) && other.is_of(true);
        let (a, b) = match signed {
            true => (self.signs(a), self.signs(b)),
            false if one.is_of(false) || other.is_of(false) => (self.zeros(a), self.zeros(b)),
            false => {
                let differs = self.to.two(Two::Xor, one.value, other.value);
                let differs = self.to.left(differs, one.size().bits() - self.width(a));
                (differs, self.to.constant(one.size(), 0))
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
            (false, _) if width < one.size().bits() => [a, b].map(|place| self.zeros(place)),
            // Moved so that the least word is the least number.
            (false, _) => [a, b].map(|place| {
                let top = self.to.constant(one.size(), 1 << (width - 1));
                let value = self.zeros(place);
                self.to.two(Two::Xor, value, top)
            }),
        };
        self.to.two(Two::Greater, b, a)
    }

    fn product(&mut self, a: Place, b: Place) -> Value {
        let signed = self.is_signed(a);
        let is_short = self.width(a) <= 32 && self.width(b) <= 32;
        let size = self.size(self.width(a) + self.width(b));
        if is_short {
            let how = match signed {
                true => Two::SignedProduct,
                false => Two::Product,
            };
            let factors = [a, b].map(|place| {
                let factor = self.extended(place);
                match size {
                    Size::Half => factor,
                    Size::Whole => self.to.widened(factor, Above::Anything),
                }
            });
            return self.to.two(how, factors[0], factors[1]);
        }
        let [a, b] = [a, b].map(|place| self.extended_to(place, Size::Whole));
        let to = &mut self.to;
        // The high halves count in the high half of the product alone.
        let low = to.two(Two::Product, a, b);
        let (high_a, high_b) = (to.right(a, 32), to.right(b, 32));
        let one = to.two(Two::Product, high_a, b);
        let other = to.two(Two::Product, a, high_b);
        let high = to.two(Two::Add, one, other);
        let high = to.left(high, 32);
        to.two(Two::Add, low, high)
    }
}
