//! Names, lists, widths and constants as text.

use crate::value::mask;

/// Columns of a line at most.
const COLUMNS: usize = 118;

/// Items with commas between them on as many lines as they need; the later ones begin at a column.
pub(super) fn filled(first: &str, items: &[String], indent: usize) -> String {
    let mut text = first.to_owned();
    let mut column = first.len();
    for (place, item) in items.iter().enumerate() {
        if place > 0 && column + 2 + item.len() >= COLUMNS {
            text += &format!(",\n{}", " ".repeat(indent));
            column = indent;
        } else if place > 0 {
            text += ", ";
            column += 2;
        }
        text += item;
        column += item.len();
    }
    text
}

/// The width of a declaration, and what says that it is a number with a sign.
pub(super) fn range(width: u32, signed: bool) -> String {
    let sign = if signed { "signed " } else { "" };
    match width {
        1 if !signed => String::new(),
        _ => format!("{sign}[{}:0] ", width - 1),
    }
}

/// A constant with its width.
pub(super) fn literal(bits: u64, width: u32, signed: bool) -> String {
    let sign = 1 << (width - 1);
    match signed {
        true if bits == sign => format!("{width}'sh{bits:x}"),
        true if bits & sign != 0 => format!("-{width}'sd{}", (!bits & mask(width)) + 1),
        true => format!("{width}'sd{bits}"),
        false if bits > 0xffff => format!("{width}'h{bits:x}"),
        false => format!("{width}'d{bits}"),
    }
}

/// A name of a net, or a part of a vector from this bit upwards.
#[derive(Clone, Debug)]
pub(super) struct Name {
    pub(super) text: String,
    pub(super) element: Option<u32>,
}

impl Name {
    pub(super) fn whole(text: String) -> Name {
        Name {
            text,
            element: None,
        }
    }

    /// Bits of a net of this name and width.
    pub(super) fn part(&self, high: u32, low: u32, width: u32) -> String {
        let text = match self.element {
            Some(element) => format!("{}[{element}]", self.text),
            None => self.text.clone(),
        };
        match high - low + 1 {
            all if all == width => text,
            1 => format!("{text}[{low}]"),
            _ => format!("{text}[{high}:{low}]"),
        }
    }

    pub(super) fn all(&self, width: u32) -> String {
        self.part(width - 1, 0, width)
    }
}
