//! Rounding of one processor's words with the proof of each width, for processors that have no bounds of their own.

use super::context::Context;
use super::error::{PrepareError, too_large};
use super::forms::{LinearForm, QuadraticForm};
use super::prepared::{NeededWord, PreparedParts};
use super::rounding::{Anchor, quadratic_error, round_quadratic, signed_bits};
use imogene_algebra::rational::{fraction, integer, power_of_two};
use imogene_golden::format::word_max;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::object::slot::ProcessorWords;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, ToPrimitive};

/// Scales tried for an expression of which only the sign counts, when its exact integers do not fit.
const SCALES: i64 = 12;

/// Least and greatest value of an expression where its value counts.
pub(super) type Range<'a> = &'a dyn Fn(&QuadraticForm) -> (BigRational, BigRational);

/// The words of one object so far; they are handed out as the registers of the processor hold them, whose sums are
/// modulo its width.
pub(super) struct Ledger<'a> {
    object: &'a str,
    window: ScreenBox,
    anchor: Anchor,
    /// What was proven.
    pub needed: Vec<NeededWord>,
    /// Pixels of the box at which a rounded sign is not the exact one.
    pub wrong_signs: u64,
}

/// The first-degree words of an expression without second-degree terms.
fn linear(words: &Quadratic) -> Linear {
    Linear::new(words.d, words.e, words.f)
}

impl<'a> Ledger<'a> {
    pub fn new(object: &'a str, window: ScreenBox, context: &Context) -> Ledger<'a> {
        Ledger {
            object,
            window,
            anchor: context.anchor_of(&window),
            needed: vec![],
            wrong_signs: 0,
        }
    }

    /// The range over the whole box.
    pub fn on_box(&self) -> impl Fn(&QuadraticForm) -> (BigRational, BigRational) + use<> {
        let window = self.window;
        move |form| form.range_on(&window)
    }

    /// An expression whose value counts, in units of `2^-guard`, half a unit of the result added so that dropping the
    /// guard bits rounds to nearest.
    pub fn value(
        &mut self,
        word: &str,
        exact: &QuadraticForm,
        guard: u32,
        width: u32,
        range: Range,
    ) -> Result<Quadratic, PrepareError> {
        let half = integer(1 << guard >> 1);
        let scaled = exact.scaled(&power_of_two(guard)).raised(&half);
        let rounded = round_quadratic(&scaled, self.anchor)
            .map_err(|value| self.refusal(word, &value.abs(), width))?;
        let (least, greatest) = range(&scaled);
        let off = quadratic_error(&rounded, &scaled, 0, &self.window);
        self.prove(word, &(least.abs().max(greatest.abs()) + off), width)?;
        Ok(rounded.wrapped(width))
    }

    /// The same for a first-degree expression.
    pub fn linear_value(
        &mut self,
        word: &str,
        exact: &LinearForm,
        guard: u32,
        width: u32,
        range: Range,
    ) -> Result<Linear, PrepareError> {
        let form = QuadraticForm::of_linear(exact);
        Ok(linear(&self.value(word, &form, guard, width, range)?))
    }

    /// An expression whose sign alone counts, on the whole box: its exact integers if they fit, else the best of a few
    /// scales.
    pub fn sign(
        &mut self,
        word: &str,
        exact: &QuadraticForm,
        width: u32,
    ) -> Result<Quadratic, PrepareError> {
        let limit = BigRational::from_integer(BigInt::from(word_max(width)));
        let whole = exact.primitive();
        let greatest = whole.max_abs_on(&self.window);
        if greatest <= limit
            && let Ok(words) = round_quadratic(&whole, self.anchor)
        {
            self.prove(word, &greatest, width)?;
            return Ok(words.wrapped(width));
        }
        let mut best: Option<(u64, Quadratic)> = None;
        for k in 1..=SCALES {
            let scale = &limit / &greatest * fraction(64 - k, 64);
            let scaled = whole.scaled(&scale);
            let words = round_quadratic(&scaled, self.anchor)
                .map_err(|value| self.refusal(word, &value.abs(), width))?;
            let off = quadratic_error(&words, &scaled, 0, &self.window);
            if scaled.max_abs_on(&self.window) + &off > limit {
                continue;
            }
            let wrong = self.wrong(&words, &whole, &off);
            if best.as_ref().is_none_or(|(least, _)| wrong < *least) {
                best = Some((wrong, words));
            }
            if wrong == 0 {
                break;
            }
        }
        // Rounding alone fills the word: the box is too large for it.
        let Some((wrong, words)) = best else {
            return Err(self.refusal(word, &greatest, width));
        };
        self.prove(
            word,
            &QuadraticForm::of_words(&words).max_abs_on(&self.window),
            width,
        )?;
        self.wrong_signs += wrong;
        Ok(words.wrapped(width))
    }

    /// The same for a first-degree expression.
    pub fn linear_sign(
        &mut self,
        word: &str,
        exact: &LinearForm,
        width: u32,
    ) -> Result<Linear, PrepareError> {
        let form = QuadraticForm::of_linear(exact);
        Ok(linear(&self.sign(word, &form, width)?))
    }

    /// The object with the words of its processor.
    pub fn finish(self, words: ProcessorWords) -> PreparedParts {
        // What a person should know of an outline that its word does not hold exactly.
        let wrong = self.wrong_signs;
        let note = format!(
            "its outline does not fit the word exactly and is another one at {wrong} pixels"
        );
        PreparedParts {
            depth_bound: None,
            name: self.object.to_owned(),
            words: vec![words],
            screen_box: self.window,
            notes: (wrong > 0).then_some(note).into_iter().collect(),
            needed: most(self.needed),
        }
    }

    /// The refusal of an object one of whose values leaves its word.
    pub fn refusal(&self, word: &str, magnitude: &BigRational, width: u32) -> PrepareError {
        too_large(self.object, word, magnitude, width, &self.window)
    }

    /// Records what a value needs, or refuses the object.
    pub fn prove(
        &mut self,
        word: &str,
        magnitude: &BigRational,
        width: u32,
    ) -> Result<(), PrepareError> {
        let needed = signed_bits(magnitude);
        if needed > width {
            return Err(self.refusal(word, magnitude, width));
        }
        self.need(word, needed, width);
        Ok(())
    }

    /// Records the bits of a word that was proven.
    pub fn need(&mut self, word: &str, needed: u32, available: u32) {
        self.needed.push(NeededWord {
            word: word.to_owned(),
            needed,
            available,
        });
    }

    /// Pixels of the box at which the words, off by at most `off`, have another sign than the exact expression. Zero
    /// counts as positive.
    fn wrong(&self, words: &Quadratic, exact: &QuadraticForm, off: &BigRational) -> u64 {
        let near = off.ceil().to_integer().to_i128().unwrap_or(i128::MAX);
        let is_wrong = |&(x, y): &(i64, i64)| {
            let value = words.wrapped_at(x, y, 127);
            let is_near = value.abs() <= near;
            is_near && (value >= 0) == exact.at(&integer(x), &integer(y)).is_negative()
        };
        self.window.each().filter(is_wrong).count() as u64
    }
}

/// The most that each word needs, in the order in which the words first come.
pub(super) fn most(all: impl IntoIterator<Item = NeededWord>) -> Vec<NeededWord> {
    let mut list: Vec<NeededWord> = vec![];
    for one in all {
        match list.iter_mut().find(|known| known.word == one.word) {
            Some(known) => known.needed = known.needed.max(one.needed),
            None => list.push(one),
        }
    }
    list
}
