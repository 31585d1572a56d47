//! A line of the evaluation: what the source prints, what we count, and why they differ.

use serde::Serialize;

/// What the source prints.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Printed {
    /// As it stands there.
    pub text: String,
    /// The number to compare with; none if the print is a range, a limit or nothing.
    pub value: Option<f64>,
}

impl From<f64> for Printed {
    fn from(value: f64) -> Printed {
        // As many digits as are printed.
        let text = if value == value.round() {
            number(value)
        } else {
            value.to_string()
        };
        Printed {
            text,
            value: Some(value),
        }
    }
}

impl From<&str> for Printed {
    fn from(text: &str) -> Printed {
        Printed {
            text: text.into(),
            value: None,
        }
    }
}

/// One line; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// What is counted.
    pub name: String,
    /// Section or table of the source.
    pub section: &'static str,
    /// What the source prints.
    pub printed: Printed,
    /// What it should print: its own sum or formula done again. None if the print is right, or cannot be done again.
    pub corrected: Option<f64>,
    /// What we count.
    pub ours: f64,
    /// Unit of all of them.
    pub unit: &'static str,
    /// Ours less the corrected, else the printed value.
    pub difference: Option<f64>,
    /// The same in percent of that value.
    pub percent: Option<f64>,
    /// Why they differ, or how ours is counted.
    pub why: String,
}

impl Row {
    /// A row without a correction.
    pub fn new(
        name: impl Into<String>,
        section: &'static str,
        printed: impl Into<Printed>,
        ours: f64,
        unit: &'static str,
    ) -> Row {
        let row = Row {
            name: name.into(),
            section,
            printed: printed.into(),
            corrected: None,
            ours,
            unit,
            difference: None,
            percent: None,
            why: String::new(),
        };
        row.compared()
    }

    /// What the source should print.
    pub fn corrected(mut self, value: f64) -> Row {
        self.corrected = Some(value);
        self.compared()
    }

    /// Why ours differs, or how it is counted.
    pub fn why(mut self, why: impl Into<String>) -> Row {
        self.why = why.into();
        self
    }

    /// The number that ours is compared with.
    pub fn reference(&self) -> Option<f64> {
        self.corrected.or(self.printed.value)
    }

    fn compared(mut self) -> Row {
        self.difference = self.reference().map(|value| self.ours - value);
        self.percent = self
            .reference()
            .filter(|&value| value != 0.0)
            .map(|value| 100.0 * (self.ours / value - 1.0));
        self
    }
}

/// Rows of one subject; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Group {
    /// Short name.
    pub name: &'static str,
    /// Heading.
    pub title: &'static str,
    /// How the figures are counted.
    pub about: String,
    /// Its rows.
    pub rows: Vec<Row>,
}

/// Something the source prints that is not counted again; the keys are stable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Omitted {
    /// What.
    pub name: &'static str,
    /// Section or table of the source.
    pub section: &'static str,
    /// What it prints.
    pub printed: &'static str,
    /// Why it is not counted.
    pub why: &'static str,
}

/// A number for a person: whole ones with spaces between thousands, others with four significant digits at least.
pub fn number(value: f64) -> String {
    let size = value.abs();
    let text = if value == value.round() || size >= 1000.0 {
        format!("{size:.0}")
    } else if size >= 100.0 {
        format!("{size:.1}")
    } else if size >= 10.0 {
        format!("{size:.2}")
    } else {
        format!("{size:.3}")
    };
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, ""));
    let digits = whole.len();
    let mut grouped = String::new();
    for (index, digit) in whole.chars().enumerate() {
        if index > 0 && digits > 4 && (digits - index).is_multiple_of(3) {
            grouped.push(' ');
        }
        grouped.push(digit);
    }
    let sign = if value < 0.0 { "-" } else { "" };
    if fraction.is_empty() {
        format!("{sign}{grouped}")
    } else {
        format!("{sign}{grouped}.{fraction}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_readable() {
        let values = [
            0.0,
            4116.0,
            225_732.0,
            -1_600_000_000.0,
            2.640625,
            145.5,
            14.625,
            57_600.4,
        ];
        let expected = [
            "0",
            "4116",
            "225 732",
            "-1 600 000 000",
            "2.641",
            "145.5",
            "14.62",
            "57 600",
        ];
        assert_eq!(values.map(number), expected);
    }

    #[test]
    fn a_correction_is_what_ours_is_compared_with() {
        let row = Row::new("x", "5.1", 600.0, 480.0, "operations");
        assert_eq!(
            (row.difference, row.percent),
            (Some(-120.0), Some(100.0 * (0.8 - 1.0)))
        );
        let row = row.corrected(400.0);
        assert_eq!(row.difference, Some(80.0));
        assert_eq!(
            Row::new("x", "5.1", "more than 100", 3.0, "").difference,
            None
        );
    }
}
