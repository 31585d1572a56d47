//! A line of the evaluation: what the source prints, what we count, and why they differ.

use serde::{Deserialize, Serialize};

/// All that is counted; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Evaluation {
    /// By subject.
    pub groups: Vec<Group>,
    /// What is not counted.
    pub omitted: Vec<Omitted>,
}

impl Evaluation {
    /// A row by the names of its group and itself.
    pub fn row(&self, group: &str, name: &str) -> Option<&Row> {
        let group = self.groups.iter().find(|g| g.name == group)?;
        group.rows.iter().find(|row| row.name == name)
    }
}

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
        let is_whole = value == value.round();
        Printed {
            text: if is_whole {
                number(value)
            } else {
                value.to_string()
            },
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
    pub section: String,
    /// What the source prints.
    pub printed: Printed,
    /// What it should print: its own sum or formula done again. None if the print is right, or cannot be done again.
    pub corrected: Option<f64>,
    /// What we count.
    pub ours: f64,
    /// Unit of all of them.
    pub unit: String,
    /// Ours less the corrected, else the printed value.
    pub difference: Option<f64>,
    /// The same in percent of that value.
    pub percent: Option<f64>,
    /// Why they differ, or how ours is counted.
    pub why: String,
}

impl Row {
    /// A row with our count, and with what the source should print if that is something else.
    pub fn new(
        [name, section, unit]: [&str; 3],
        printed: impl Into<Printed>,
        ours: f64,
        corrected: Option<f64>,
    ) -> Row {
        let printed = printed.into();
        let reference = corrected.or(printed.value);
        let of_some = reference.filter(|&value| value != 0.0);
        Row {
            name: name.into(),
            section: section.into(),
            printed,
            corrected,
            ours,
            unit: unit.into(),
            difference: reference.map(|value| ours - value),
            percent: of_some.map(|value| 100.0 * (ours / value - 1.0)),
            why: String::new(),
        }
    }

    /// The number that ours is compared with.
    pub fn reference(&self) -> Option<f64> {
        self.corrected.or(self.printed.value)
    }
}

/// Rows of one subject; the keys are stable.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Group {
    /// Short name.
    pub name: String,
    /// Heading.
    pub title: String,
    /// How the figures are counted.
    pub about: String,
    /// Its rows.
    pub rows: Vec<Row>,
}

/// Something the source prints that is not counted again; the keys are stable.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Omitted {
    /// What.
    pub name: String,
    /// Section or table of the source.
    pub section: String,
    /// What it prints.
    pub printed: String,
    /// Why it is not counted.
    pub why: String,
}

/// A number for a person: whole ones with spaces between thousands, others with four significant digits at least.
pub fn number(value: f64) -> String {
    let size = value.abs();
    let decimals = match size {
        _ if value == value.round() || size >= 1000.0 => 0,
        _ if size >= 100.0 => 1,
        _ if size >= 10.0 => 2,
        _ => 3,
    };
    let text = format!("{size:.decimals$}");
    let whole = text.find('.').unwrap_or(text.len());
    let mut grouped = String::from(if value < 0.0 { "-" } else { "" });
    for (index, digit) in text.char_indices() {
        if whole > 4 && (1..whole).contains(&index) && (whole - index).is_multiple_of(3) {
            grouped.push(' ');
        }
        grouped.push(digit);
    }
    grouped
}
