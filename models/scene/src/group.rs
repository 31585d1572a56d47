//! Groups and what belongs to them: objects, lights, cameras and other groups, placed together.

use super::keys::{is_yes, yes};
use super::step::Step;
use serde::{Deserialize, Serialize};

/// A group: its members are placed in its frame, and the group in that of the group it belongs to (source: animator,
/// ObjetC). A member names its group, so that nothing belongs to two.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Group {
    /// Unique among objects, groups, lights and cameras.
    pub name: String,
    /// Name of the group it belongs to.
    pub group: Option<String>,
    /// Whether its members are seen, as far as they are visible themselves.
    #[serde(default = "yes", skip_serializing_if = "is_yes")]
    pub visible: bool,
    /// Steps from its own frame to that of its group, or to the scene; they follow those of its members.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub place: Vec<Step>,
}

/// What a light or a camera has beside its kind: a name to be spoken of, a group, and a place.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Node {
    /// Unique among objects, groups, lights and cameras.
    pub name: Option<String>,
    /// Name of the group it belongs to.
    pub group: Option<String>,
    /// Whether a light shines; a camera is always visible.
    #[serde(skip_serializing_if = "is_yes")]
    pub visible: bool,
    /// Steps applied to its points and directions, the first applied first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub place: Vec<Step>,
}

impl Default for Node {
    /// Without a name, in no group, where its numbers say.
    fn default() -> Self {
        Self {
            name: None,
            group: None,
            visible: true,
            place: vec![],
        }
    }
}
