//! Widths of a fitted machine as text: `depth=20,root=18,plane=30,normal=16,g1=2,g2=4,dropped=0`.

use crate::format::{FittedError, FittedWidths, Format};
use thiserror::Error;

/// Text that names no machine.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum WidthsError {
    /// Not a list of `name=number`.
    #[error(
        "'{0}' is no width; expected a list such as depth=20,root=18,plane=30,normal=16,g1=2,g2=4,dropped=0"
    )]
    Syntax(String),
    /// A name that is given twice.
    #[error("{0} is given twice")]
    Twice(String),
    /// The one that has no default.
    #[error("the depth word is missing; give depth=W, 8 to 32 bits")]
    NoDepth,
    /// A width that is out of its range.
    #[error(transparent)]
    Widths(#[from] FittedError),
}

/// The names in their order.
const NAMES: [&str; 7] = ["depth", "root", "plane", "normal", "g1", "g2", "dropped"];

/// Reads widths; what is not given is as in the catalogue: root = depth, plane = depth + 12, normal = 16, the others 0.
pub fn parse(text: &str) -> Result<FittedWidths, WidthsError> {
    let mut given: [Option<u32>; 7] = [None; 7];
    for part in text.split(',') {
        let syntax = || WidthsError::Syntax(part.to_owned());
        let (name, value) = part.split_once('=').ok_or_else(syntax)?;
        let place = NAMES.iter().position(|n| *n == name).ok_or_else(syntax)?;
        let value = value.parse().map_err(|_| syntax())?;
        if given[place].replace(value).is_some() {
            return Err(WidthsError::Twice(name.to_owned()));
        }
    }
    let [depth, root, plane, normal, g1, g2, dropped] = given;
    let depth = depth.ok_or(WidthsError::NoDepth)?;
    let widths = FittedWidths {
        depth,
        root: root.unwrap_or(depth),
        plane: plane.unwrap_or(depth.saturating_add(12)),
        normal: normal.unwrap_or(16),
        guard_linear: g1.unwrap_or(0),
        guard_quadratic: g2.unwrap_or(0),
        dropped_rows: dropped.unwrap_or(0),
    };
    Format::fitted(&widths)?;
    Ok(widths)
}

/// The text that [`parse`] reads back, with every width.
pub fn print(widths: &FittedWidths) -> String {
    let values = [
        widths.depth,
        widths.root,
        widths.plane,
        widths.normal,
        widths.guard_linear,
        widths.guard_quadratic,
        widths.dropped_rows,
    ];
    let parts = NAMES.iter().zip(values);
    let parts: Vec<String> = parts
        .map(|(name, value)| format!("{name}={value}"))
        .collect();
    parts.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_widths_are_each_other() {
        let text = "depth=20,root=18,plane=30,normal=14,g1=2,g2=4,dropped=1";
        let widths = parse(text).unwrap();
        assert_eq!((widths.root, widths.dropped_rows), (18, 1));
        assert_eq!(print(&widths), text);
        assert_eq!(parse("depth=24").unwrap(), Format::BASE.widths());
        assert_eq!(parse("g2=4,depth=16").unwrap().guard_quadratic, 4);
    }

    #[test]
    fn what_is_no_width_is_refused() {
        let refused = |text: &str| parse(text).unwrap_err().to_string();
        for text in [
            "",
            "depth",
            "depth=",
            "depth=-3",
            "depth=20;root=3",
            "width=3",
        ] {
            assert!(refused(text).contains("expected a list"), "{text}");
        }
        assert!(refused("depth=20,depth=20").contains("twice"));
        assert!(refused("root=12").contains("depth=W"));
        assert!(refused("depth=40").contains("accepted are 8 to 32"));
        assert!(refused("depth=4294967295").contains("accepted are 8 to 32"));
        assert!(refused("depth=20,dropped=9").contains("0 to 8"));
    }
}
