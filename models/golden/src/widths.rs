//! Widths of a fitted machine as text: `depth=20,root=18,plane=30,normal=16,g1=2,g2=4,dropped=0`, with the form of its
//! root behind them where it is not the usual one: `root_form=linear2`.

use crate::format::{FittedError, Format};
use imogene_contract::{MachineWords, RootForm, RootFormError};
use serde::{Deserialize, Serialize};
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
    /// No form of the root.
    #[error(transparent)]
    RootForm(#[from] RootFormError),
}

/// Widths that do not follow from the depth word, by the names of the text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, expecting = "a table")]
pub struct OwnWidths {
    /// Root bits.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub root: Option<u32>,
    /// Plane word.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub plane: Option<u32>,
    /// Normal component.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub normal: Option<u32>,
    /// Guard bits of f1.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub g1: Option<u32>,
    /// Guard bits of f2.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub g2: Option<u32>,
    /// Last digits of the root that are not computed.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dropped: Option<u32>,
}

impl OwnWidths {
    /// None: all widths follow from the depth word.
    pub fn is_none(&self) -> bool {
        *self == Self::default()
    }

    /// Those of a machine that do not follow from its depth word.
    pub fn of(widths: &MachineWords) -> OwnWidths {
        let usual = MachineWords::of(widths.depth);
        let own = |width: u32, usual: u32| (width != usual).then_some(width);
        OwnWidths {
            root: own(widths.root, usual.root),
            plane: own(widths.plane, usual.plane),
            normal: own(widths.normal, usual.normal),
            g1: own(widths.guard_linear, usual.guard_linear),
            g2: own(widths.guard_quadratic, usual.guard_quadratic),
            dropped: own(widths.dropped_rows, usual.dropped_rows),
        }
    }

    /// All widths, and the usual form of the root: root = depth, plane = depth + 12, normal = 16, the others 0 where
    /// they are not given.
    pub fn beside(&self, depth: u32) -> MachineWords {
        let own = MachineWords::of(depth);
        MachineWords {
            depth,
            root: self.root.unwrap_or(own.root),
            plane: self.plane.unwrap_or(own.plane),
            normal: self.normal.unwrap_or(own.normal),
            guard_linear: self.g1.unwrap_or(own.guard_linear),
            guard_quadratic: self.g2.unwrap_or(own.guard_quadratic),
            dropped_rows: self.dropped.unwrap_or(own.dropped_rows),
            ..own
        }
    }
}

/// The name of the form of the root, which is no number.
const FORM: &str = "root_form";
/// The other names in their order.
const NAMES: [&str; 7] = ["depth", "root", "plane", "normal", "g1", "g2", "dropped"];

/// The widths of these names.
fn each(widths: &mut MachineWords) -> [&mut u32; 7] {
    [
        &mut widths.depth,
        &mut widths.root,
        &mut widths.plane,
        &mut widths.normal,
        &mut widths.guard_linear,
        &mut widths.guard_quadratic,
        &mut widths.dropped_rows,
    ]
}

/// Reads widths; what is not given follows from the depth word, [`OwnWidths::beside`].
pub fn parse(text: &str) -> Result<MachineWords, WidthsError> {
    let mut given: [Option<u32>; 7] = [None; 7];
    let mut form: Option<RootForm> = None;
    for part in text.split(',') {
        let syntax = || WidthsError::Syntax(part.to_owned());
        let (name, value) = part.split_once('=').ok_or_else(syntax)?;
        let is_twice = if name == FORM {
            form.replace(value.parse()?).is_some()
        } else {
            let place = NAMES.iter().position(|n| *n == name).ok_or_else(syntax)?;
            let value = value.parse().map_err(|_| syntax())?;
            given[place].replace(value).is_some()
        };
        if is_twice {
            return Err(WidthsError::Twice(name.to_owned()));
        }
    }
    let mut widths = MachineWords {
        root_form: form.unwrap_or_default(),
        ..MachineWords::of(given[0].ok_or(WidthsError::NoDepth)?)
    };
    for (width, given) in each(&mut widths).into_iter().zip(given) {
        *width = given.unwrap_or(*width);
    }
    Format::fitted(&widths)?;
    Ok(widths)
}

/// The text that [`parse`] reads back, with every width.
pub fn print(widths: &MachineWords) -> String {
    let mut own = *widths;
    let parts = NAMES.iter().zip(each(&mut own));
    let parts = parts.map(|(name, value)| format!("{name}={value}"));
    let form = widths.root_form;
    let form = (!form.is_usual()).then(|| format!("{FORM}={form}"));
    parts.chain(form).collect::<Vec<_>>().join(",")
}
