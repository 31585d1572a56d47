//! Forms of the square root in an object processor.

use crate::parameters::CORRECTIONS;
use crate::unit::Unit;
use crate::words::{MOST_DEPTH, WordRange};
use serde::{Deserialize, Serialize};
use std::fmt;
use std::str::FromStr;
use thiserror::Error;

/// A form of the root: `restoring`, `non-restoring`, `iterative`, `linear2`, `quadratic1`, `leading8`. All but the
/// iterative one take a root every clock.
#[derive(
    Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize,
)]
#[serde(try_from = "String", into = "String")]
pub enum RootForm {
    /// The exact root by restoring rows.
    #[default]
    Restoring,
    /// The exact root by non-restoring rows.
    NonRestoring,
    /// The exact root by one restoring row, a clock for each digit.
    Iterative,
    /// Straight lines, and so many corrections.
    Linear(u32),
    /// Parabolas, and so many corrections.
    Quadratic(u32),
    /// So many leading digits of the exact root.
    Leading(u32),
}

/// A form without its number: name, unit, least and greatest number behind the name if it has one, and the form.
type Row = (&'static str, Unit, Option<[u32; 2]>, fn(u32) -> RootForm);

const COUNTS: Option<[u32; 2]> = Some([0, CORRECTIONS.most.expect("a number")]);

const ROWS: [Row; 6] = [
    ("restoring", Unit::SquareRoot, None, |_| RootForm::Restoring),
    ("non-restoring", Unit::SquareRootNonRestoring, None, |_| {
        RootForm::NonRestoring
    }),
    ("iterative", Unit::SquareRootIterative, None, |_| {
        RootForm::Iterative
    }),
    ("linear", Unit::SquareRootLinear, COUNTS, RootForm::Linear),
    (
        "quadratic",
        Unit::SquareRootQuadratic,
        COUNTS,
        RootForm::Quadratic,
    ),
    (
        "leading",
        Unit::SquareRootLeading,
        Some([1, MOST_DEPTH]),
        RootForm::Leading,
    ),
];

/// Text that names no form of a machine's root.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum RootFormError {
    /// No form is called so.
    #[error("'{0}' is no form of the root; accepted: {FORMS}")]
    Unknown(String),
    /// A number that the form does not have.
    #[error("'{0}': a {1} root takes {2} to {3} {4}")]
    Range(String, String, u32, u32, &'static str),
    /// The first rows, which have a word of their own.
    #[error("'{0}': rows are left out by `dropped` of the widths; accepted: {FORMS}")]
    Rows(String),
}

/// What messages say of the forms.
const FORMS: &str = "restoring, non-restoring, iterative, linear0 to linear2 and quadratic0 to quadratic2 by their corrections, leading1 to leading32 by the digits that are kept";

impl FromStr for RootForm {
    type Err = RootFormError;

    fn from_str(text: &str) -> Result<RootForm, RootFormError> {
        let name = text.trim_end_matches(|letter: char| letter.is_ascii_digit());
        let number = &text[name.len()..];
        let Some(&(_, unit, numbers, of)) = ROWS.iter().find(|row| row.0 == name) else {
            return Err(match name {
                "rows" => RootFormError::Rows(text.into()),
                _ => RootFormError::Unknown(text.into()),
            });
        };
        let Some([least, most]) = numbers else {
            let is_whole = number.is_empty().then(|| of(0));
            return is_whole.ok_or_else(|| RootFormError::Unknown(text.into()));
        };
        let number = number.parse().ok();
        let number = number.filter(|number| (least..=most).contains(number));
        number.map(of).ok_or_else(|| {
            let counted = match unit {
                Unit::SquareRootLeading => "digits",
                _ => "corrections",
            };
            RootFormError::Range(text.into(), name.into(), least, most, counted)
        })
    }
}

impl fmt::Display for RootForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (&(name, _, numbers, _), number) = self.row();
        match numbers {
            Some(_) => write!(f, "{name}{number}"),
            None => f.write_str(name),
        }
    }
}

impl TryFrom<String> for RootForm {
    type Error = RootFormError;

    fn try_from(text: String) -> Result<RootForm, RootFormError> {
        text.parse()
    }
}

impl From<RootForm> for String {
    fn from(form: RootForm) -> String {
        form.to_string()
    }
}

impl RootForm {
    pub(crate) fn row(self) -> (&'static Row, u32) {
        match self {
            RootForm::Restoring => (&ROWS[0], 0),
            RootForm::NonRestoring => (&ROWS[1], 0),
            RootForm::Iterative => (&ROWS[2], 0),
            RootForm::Linear(corrections) => (&ROWS[3], corrections),
            RootForm::Quadratic(corrections) => (&ROWS[4], corrections),
            RootForm::Leading(digits) => (&ROWS[5], digits),
        }
    }

    /// True for the form that all machines have that name none.
    pub fn is_usual(&self) -> bool {
        *self == RootForm::default()
    }

    /// True if it gives every computed digit of the true root, rounded down.
    pub const fn is_exact(self) -> bool {
        use RootForm::{Iterative, NonRestoring, Restoring};
        matches!(self, Restoring | NonRestoring | Iterative)
    }

    /// Clocks from one root of so many computed digits to the next.
    pub const fn clocks(self, digits: u32) -> u32 {
        match self {
            RootForm::Iterative => digits,
            _ => 1,
        }
    }

    /// The unit that takes the root.
    pub fn unit(self) -> Unit {
        self.row().0.1
    }

    /// The greatest distance from the true root: this part of it, and so many units of the last digit that is computed.
    ///
    /// The parts of the approximations are those of their records, rounded up. Each floor takes at most a unit, and a
    /// correction makes no error greater: one of the radicand where digits are left out, two of the estimate, one of
    /// each correction.
    pub fn error(self) -> (f64, f64) {
        const LINEAR: [f64; 3] = [0.060_67, 0.016_48, 0.004_74];
        const QUADRATIC: [f64; 3] = [0.013_46, 0.005_33, 0.002_20];
        let approximate =
            |parts: [f64; 3], count: u32| (parts[count.min(2) as usize], f64::from(3 + count));
        match self {
            RootForm::Restoring | RootForm::NonRestoring | RootForm::Iterative => (0.0, 1.0),
            RootForm::Linear(corrections) => approximate(LINEAR, corrections),
            RootForm::Quadratic(corrections) => approximate(QUADRATIC, corrections),
            RootForm::Leading(digits) => (f64::exp2(1.0 - f64::from(digits)), 1.0),
        }
    }

    /// The greatest distance in units of the root, without so many of its last digits, where the true root is `root`.
    pub fn error_at(self, root: f64, dropped_digits: u32) -> f64 {
        let (part, units) = self.error();
        part * root + units * f64::exp2(f64::from(dropped_digits))
    }

    /// Fewest digits of which it can be the root.
    pub fn least_digits(self) -> u32 {
        match self {
            RootForm::Restoring | RootForm::NonRestoring => 1,
            RootForm::Iterative => 2,
            RootForm::Linear(_) | RootForm::Quadratic(_) => self.unit().least_word(),
            RootForm::Leading(digits) => digits,
        }
    }

    /// What of a root of so many computed digits is out of its range for this form: what it has, and the least and the
    /// greatest it may have.
    pub(crate) fn refused(self, digits: u32) -> Option<WordRange> {
        let least = self.least_digits();
        let word = match self {
            RootForm::Restoring | RootForm::NonRestoring => return None,
            RootForm::Iterative => (
                "computed part of an iterative root",
                digits,
                least,
                MOST_DEPTH,
            ),
            RootForm::Linear(_) => ("computed part of a linear root", digits, least, MOST_DEPTH),
            RootForm::Quadratic(_) => (
                "computed part of a quadratic root",
                digits,
                least,
                MOST_DEPTH,
            ),
            RootForm::Leading(kept) => ("kept part of a leading root", kept, 1, digits),
        };
        let (_, bits, least, most) = word;
        (!(least..=most).contains(&bits)).then_some(word)
    }
}
