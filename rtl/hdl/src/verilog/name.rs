//! One name of a net.

/// A name, or a part of a vector from this bit upwards.
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
