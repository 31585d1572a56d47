//! Formulas of records: sums and products of numbers and symbols, as they are printed.
//!
//! `ceil(W / R) + N + 7`, `2 C` (a product), `G (J + 1)`, `ceil(log2 M)`, `max(1, ceil(log8 M))`. A quotient stands in
//! `ceil` or is whole.

use std::iter::Peekable;
use std::str::Chars;

/// The value of a formula; `value` gives those of its symbols.
///
/// # Panics
///
/// Where the text is no formula: it is one of a record.
pub fn evaluate(text: &str, value: &dyn Fn(&str) -> i64) -> i64 {
    let mut reader = Reader {
        rest: text.chars().peekable(),
        value,
    };
    let found = reader.sum();
    assert_eq!(reader.next(), None, "'{text}' is read to its end");
    found
}

struct Reader<'a> {
    rest: Peekable<Chars<'a>>,
    value: &'a dyn Fn(&str) -> i64,
}

impl Reader<'_> {
    /// The next character that is no space.
    fn next(&mut self) -> Option<char> {
        while self.rest.next_if_eq(&' ').is_some() {}
        self.rest.peek().copied()
    }

    fn take(&mut self, wanted: char) -> bool {
        self.next() == Some(wanted) && self.rest.next().is_some()
    }

    fn sum(&mut self) -> i64 {
        let mut total = self.product();
        loop {
            if self.take('+') {
                total += self.product();
            } else if self.take('-') {
                total -= self.product();
            } else {
                return total;
            }
        }
    }

    /// Factors one behind the other; a divisor rounds upwards.
    fn product(&mut self) -> i64 {
        let mut total = self.factor();
        loop {
            if self.take('/') {
                total = -(-total).div_euclid(self.factor());
            } else if matches!(self.next(), Some(c) if c.is_alphanumeric() || c == '(') {
                total *= self.factor();
            } else {
                return total;
            }
        }
    }

    fn factor(&mut self) -> i64 {
        if self.take('(') {
            return self.closed(Self::sum);
        }
        self.next();
        let mut word = String::new();
        while let Some(c) = self.rest.next_if(|c| c.is_alphanumeric()) {
            word.push(c);
        }
        match word.as_str() {
            // The quotient in it rounds upwards by itself.
            "ceil" if self.take('(') => self.closed(Self::sum),
            "max" if self.take('(') => self.closed(Self::greatest),
            "log2" => logarithm(2, self.factor()),
            "log8" => logarithm(8, self.factor()),
            word => word.parse().unwrap_or_else(|_| (self.value)(word)),
        }
    }

    fn greatest(&mut self) -> i64 {
        let first = self.sum();
        assert!(self.take(','), "max takes two values");
        first.max(self.sum())
    }

    fn closed(&mut self, inner: fn(&mut Self) -> i64) -> i64 {
        let value = inner(self);
        assert!(self.take(')'), "a bracket is closed");
        value
    }
}

/// The least exponent whose power is not less than a number.
fn logarithm(base: i64, number: i64) -> i64 {
    let powers = std::iter::successors(Some(1), |power| Some(power * base));
    powers.take_while(|power| *power < number).count() as i64
}
