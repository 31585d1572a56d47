//! A named case: what is run, and what must come of it.

use super::pictures::Pictures;
use crate::subject::{Inputs, Subject};
use imogene_contract::Unit;

/// What a picture must show.
pub type Claim = fn(&Pictures) -> Result<(), String>;

/// What is run, and what must come of it.
pub(super) enum Case {
    /// A scene that is drawn, and what its picture must show.
    Drawn(&'static str, Claim),
    /// A scene that the golden machine draws by a processor without hardware, and what its picture must show.
    Modelled(&'static str, Claim),
    /// A scene that is drawn, but of which the check says that its silhouette has no bound.
    Flagged(&'static str),
    /// A stimulus of a unit.
    Unit(Unit, fn(&Subject) -> Vec<Inputs>),
}

/// A named case.
pub struct Extreme {
    /// Name, without `extremes/`.
    pub name: &'static str,
    /// Item of the list of extremes: of section 17, or 13.8.
    pub item: &'static str,
    /// What happens, and why that is right.
    pub outcome: &'static str,
    pub(super) case: Case,
}

pub(super) const fn driven(
    item: &'static str,
    name: &'static str,
    unit: Unit,
    stimulus: fn(&Subject) -> Vec<Inputs>,
    outcome: &'static str,
) -> Extreme {
    Extreme {
        name,
        item,
        outcome,
        case: Case::Unit(unit, stimulus),
    }
}
