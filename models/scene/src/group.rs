//! Groups and what belongs to them: objects, lights, cameras and other groups, placed together.

use super::keys::{is_yes, yes};
use super::step::Step;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

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

/// The groups of a scene by their names.
pub(super) struct Groups<'a>(HashMap<&'a str, &'a Group>);

impl<'a> Groups<'a> {
    pub fn of(groups: &'a [Group]) -> Groups<'a> {
        Groups(groups.iter().map(|g| (g.name.as_str(), g)).collect())
    }

    /// The group of a name and all above it, innermost first. Checked scenes have no circles.
    pub fn chain(&self, name: Option<&'a str>) -> impl Iterator<Item = &'a Group> {
        let named = |name: &'a str| self.0.get(name).copied();
        std::iter::successors(name.and_then(named), move |group| {
            group.group.as_deref().and_then(named)
        })
    }

    /// Whether nothing above a member is hidden.
    pub fn shows(&self, group: Option<&'a str>) -> bool {
        self.chain(group).all(|group| group.visible)
    }

    /// A placement followed by those of the groups above.
    pub fn whole(&self, place: &[Step], group: Option<&'a str>) -> Vec<Step> {
        let above = self.chain(group).flat_map(|group| &group.place);
        place.iter().chain(above).cloned().collect()
    }

    pub fn flatten(&self, node: &mut Node, group: Option<&'a str>) {
        node.place = self.whole(&node.place, group);
        node.group = None;
    }
}
