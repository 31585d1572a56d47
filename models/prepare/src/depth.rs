//! The depth of a quadric in words: each expression is rounded once for all widths that do not tell it apart.

use super::context::Context;
use super::error::{PrepareError, too_large};
use super::forms::{LinearForm, QuadraticForm, greater, sum};
use super::memo::Few;
use super::perspective::ScreenQuadric;
use super::prepared::{ExactForms, NeededWidths, RoundingBounds};
use super::rounding::{
    Anchor, linear_error, quadratic_error, round_contour, round_linear, round_quadratic,
    signed_bits,
};
use imogene_algebra::rational::{integer, power_of_two, to_f64_up};
use imogene_golden::format::word_max;
use imogene_golden::object::quadric::ScreenBox;
use imogene_golden::unit::depth_interval::Class;
use imogene_golden::unit::pe1::Linear;
use imogene_golden::unit::pe2::Quadratic;
use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{Signed, Zero};
use std::cell::OnceCell;
use std::sync::Arc;

/// The words of f1 and f2 of a quadric at one place of the screen.
#[derive(Default)]
pub(super) struct Depth {
    f1: Few<Unit, Rounded<Linear>>,
    f2: Few<Unit, Rounded<Quadratic>>,
}

/// For what the words are.
pub(super) struct Asked<'a> {
    pub quadric: &'a ScreenQuadric,
    pub class: Class,
    /// The box that they are proven on, and one around it that they are rounded and scaled for: those of the place.
    pub at: (&'a ScreenBox, &'a ScreenBox),
    /// Last digits of the depth word that there are not.
    pub shift: u8,
    pub context: &'a Context,
    pub exact: Exact,
}

/// The expressions in depth words, found when first asked for.
#[derive(Default)]
pub(super) struct Exact {
    f1: OnceCell<LinearForm>,
    f2: OnceCell<QuadraticForm>,
}

/// What an expression is rounded to.
#[derive(Clone, Copy, PartialEq)]
struct Unit {
    /// The depth word; of a contour, whose scale is free, the word that it fills.
    word: u32,
    shift: u8,
    guards: u32,
    anchor: Anchor,
}

/// An expression in words, or a coefficient that no word holds.
type Rounded<W> = Result<Arc<InWords<W>>, BigRational>;

struct InWords<W> {
    words: W,
    /// Greatest distance from the exact expression on the box.
    error: f64,
    /// Least and greatest value on the box, without guard bits.
    range: (BigRational, BigRational),
}

/// The words of the quadric itself, without planes and normals; proven on a box.
pub(super) struct DepthWords {
    pub f1: Linear,
    pub f2: Quadratic,
    pub bounds: RoundingBounds,
    pub needed: NeededWidths,
    /// Greatest root that the network finds.
    pub root_max: BigInt,
}

impl Asked<'_> {
    fn depth_scale(&self) -> BigRational {
        &self.context.depth_scale / power_of_two(self.shift.into())
    }

    /// Of a prism there is f2 alone.
    fn f1(&self) -> &LinearForm {
        self.exact.f1.get_or_init(|| match self.class {
            Class::Prism => LinearForm::zero(),
            _ => {
                let f1 = self.context.to_pixels_linear(&self.quadric.f1());
                f1.scaled(&self.depth_scale())
            }
        })
    }

    fn f2(&self) -> &QuadraticForm {
        self.exact.f2.get_or_init(|| match self.class {
            Class::Prism => {
                let contour = self.quadric.depth_free_part();
                let contour = self.context.to_pixels_quadratic(&contour);
                let width = self.context.format.quadratic;
                contour_scaled(contour.scaled(&integer(-1)), self.at.1, width)
            }
            _ => {
                let f2 = self.context.to_pixels_quadratic(&self.quadric.f2());
                let scale = self.depth_scale();
                f2.scaled(&(&scale * &scale))
            }
        })
    }

    /// The exact expressions.
    pub fn into_exact(self) -> ExactForms {
        self.f1();
        self.f2();
        let Exact { f1, f2 } = self.exact;
        ExactForms {
            f1: f1.into_inner().expect("found"),
            f2: f2.into_inner().expect("found"),
            planes: vec![],
        }
    }

    fn unit(&self, guards: u32) -> Unit {
        Unit {
            word: self.context.format.depth,
            shift: self.shift,
            guards,
            anchor: self.context.anchor_of(self.at.1),
        }
    }
}

impl Depth {
    fn f1(&self, asked: &Asked) -> Rounded<Linear> {
        let (guards, window) = (asked.context.format.guard_linear, asked.at.0);
        let unit = asked.unit(guards);
        self.f1.get(unit, || {
            let (exact, power) = (asked.f1(), power_of_two(guards));
            let words = round_linear(&exact.scaled(&power), unit.anchor);
            let words = words.map_err(|value| value.abs() / &power)?;
            let rounded = LinearForm::of_words(&words).scaled(&power.recip());
            Ok(Arc::new(InWords {
                error: to_f64_up(&linear_error(&words, exact, guards, window)),
                range: rounded.range_on(window),
                words,
            }))
        })
    }

    fn f2(&self, asked: &Asked) -> Rounded<Quadratic> {
        let format = &asked.context.format;
        let (guards, window) = (format.guard_quadratic, asked.at.0);
        let (unit, round): (Unit, fn(&QuadraticForm, Anchor) -> _) = match asked.class {
            Class::Prism => {
                let word = format.quadratic;
                let unit = Unit {
                    word,
                    ..asked.unit(guards)
                };
                (unit, round_contour)
            }
            _ => (asked.unit(guards), round_quadratic),
        };
        self.f2.get(unit, || {
            let (exact, power) = (asked.f2(), power_of_two(guards));
            let words = round(&exact.scaled(&power), unit.anchor);
            let words = words.map_err(|value| value.abs() / &power)?;
            let rounded = QuadraticForm::of_words(&words).scaled(&power.recip());
            Ok(Arc::new(InWords {
                error: to_f64_up(&quadratic_error(&words, exact, guards, window)),
                range: rounded.range_on(window),
                words,
            }))
        })
    }

    /// Rounds f1 and f2 to words with the format's guard bits, and proves on the rounded integers that f2, and f1 -+ r,
    /// stay within their words on the box.
    ///
    /// The values are those with guard bits. Dropping them downwards adds less than one to a magnitude, which rounding
    /// the magnitude up to an integer covers; and if that integer fits `S` or `F` bits, the value with its guard bits
    /// fits the processor.
    pub fn words(&self, name: &str, asked: &Asked) -> Result<DepthWords, PrepareError> {
        let format = &asked.context.format;
        let refusal = |word: &str, magnitude: &BigRational, available: u32| {
            too_large(name, word, magnitude, available, asked.at.0)
        };
        let f1 = self.f1(asked);
        let f1 = f1.map_err(|value| refusal("f1", &value, format.sum))?;
        let f2 = self.f2(asked);
        let f2 = f2.map_err(|value| refusal("f2", &value, format.quadratic))?;
        let mut needed = NeededWidths::default();
        let magnitude = most(&f2.range);
        needed.quadratic = signed_bits(&magnitude);
        if needed.quadratic > format.quadratic {
            return Err(refusal("f2", &magnitude, format.quadratic));
        }
        let greatest = f2.range.1.ceil().to_integer().max(BigInt::zero());
        let root_max: BigInt = greatest.sqrt() + 1;
        let bounds = RoundingBounds {
            f1: f1.error,
            f2: f2.error,
            greatest_root: to_f64_up(&root_max.clone().into()),
            ..RoundingBounds::of_format(format)
        };
        let above = match format.root_form.is_exact() {
            // It is rounded down.
            true => 0,
            false => bounds.root_error(bounds.greatest_root).ceil() as i64,
        };
        let root_max = root_max + above;
        let sum = sum(&most(&f1.range), &root_max.clone().into());
        needed.sum = signed_bits(&sum);
        if needed.sum > format.sum {
            return Err(refusal("f1 + sqrt(f2)", &sum, format.sum));
        }
        Ok(DepthWords {
            f1: f1.words,
            f2: f2.words,
            bounds,
            needed,
            root_max,
        })
    }
}

fn most((least, greatest): &(BigRational, BigRational)) -> BigRational {
    greater(least.abs(), greatest.abs())
}

/// The greatest magnitude fills half the word.
fn contour_scaled(form: QuadraticForm, window: &ScreenBox, width: u32) -> QuadraticForm {
    let magnitude = form.max_abs_on(window);
    if magnitude.is_zero() {
        return form;
    }
    let scale = BigRational::from_integer(BigInt::from(word_max(width))) / (magnitude * integer(2));
    form.scaled(&scale)
}
