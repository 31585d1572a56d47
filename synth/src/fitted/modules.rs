//! The modules of an emitted machine: how often each stands in it, what it holds, its ports.

use crate::cache::digest;
use imogene_rtl::emit::{Direction, Emitted, Port};
use std::collections::{BTreeMap, BTreeSet};

/// A module of a machine.
#[derive(Clone, Debug)]
pub(super) struct Module {
    pub name: String,
    /// Of its text, in which the names and widths of its ports and of those below it stand.
    pub digest: String,
    /// Instances in the whole machine.
    pub instances: u64,
    /// Instances of each module below.
    pub children: BTreeMap<String, u64>,
}

/// The modules of a machine, the top first.
pub(super) fn modules(machine: &Emitted) -> Vec<Module> {
    let names: BTreeSet<&str> = machine.modules.iter().map(|(name, _)| &**name).collect();
    let mut list: Vec<Module> = machine
        .modules
        .iter()
        .rev()
        .map(|(name, text)| Module {
            name: name.clone(),
            digest: digest(text),
            instances: u64::from(*name == machine.top),
            children: children(text, &names),
        })
        .collect();
    // Leaves stand first in the text, so every module comes before those below it here.
    for index in 0..list.len() {
        let (times, children) = (list[index].instances, list[index].children.clone());
        for module in &mut list[index + 1..] {
            module.instances += times * children.get(&module.name).copied().unwrap_or(0);
        }
    }
    list
}

/// Instances in a text: lines of the form `module instance (`.
fn children(text: &str, names: &BTreeSet<&str>) -> BTreeMap<String, u64> {
    let mut children = BTreeMap::new();
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        if let [module, _, "("] = words[..]
            && names.contains(module)
        {
            *children.entry(module.to_owned()).or_insert(0) += 1;
        }
    }
    children
}

/// A module and all below it.
pub(super) fn closure(machine: &Emitted, name: &str) -> BTreeSet<String> {
    let mut needed = BTreeSet::from([name.to_owned()]);
    for module in modules(machine) {
        if needed.contains(&module.name) {
            needed.extend(module.children.into_keys());
        }
    }
    needed
}

/// The ports that a module declares, one a line.
pub(super) fn ports(text: &str) -> Vec<Port> {
    text.lines().filter_map(port).collect()
}

fn port(line: &str) -> Option<Port> {
    let words: Vec<&str> = line
        .trim()
        .trim_end_matches(',')
        .split_whitespace()
        .collect();
    let direction = match words.first()? {
        &"input" => Direction::Input,
        &"output" => Direction::Output,
        _ => return None,
    };
    let high = words.iter().find_map(|word| word.strip_prefix('['));
    let high = high.and_then(|range| range.split(':').next()?.parse::<usize>().ok());
    Some(Port {
        name: (*words.last()?).to_owned(),
        direction,
        width: high.map_or(1, |high| high + 1),
        signed: words.contains(&"signed"),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_rtl::catalogue::Unit;
    use imogene_rtl::emit::{EmitRequest, emit};

    #[test]
    fn instances_are_counted_through_the_hierarchy() {
        let beam = emit(&EmitRequest {
            depth_word: 16,
            planes: 2,
            objects: 3,
            ..EmitRequest::new(Unit::Beam)
        })
        .expect("a machine");
        let all = modules(&beam);
        let of = |name: &str| all.iter().find(|m| m.name == name).map(|m| m.instances);
        assert_eq!(of("beam"), Some(1));
        assert_eq!(of("quadric_processor"), Some(3));
        // Two planes, each with both halves, in three processors.
        assert_eq!((of("plane_depth"), of("cut_plane")), (Some(6), Some(12)));
        assert_eq!(of("visibility_node"), Some(2));
        // A pe1 for the depth, and one for each plane.
        assert_eq!((of("pe1_w18"), of("pe1_w28")), (Some(3), Some(6)));
        assert!(closure(&beam, "plane_depth").contains("pe1_w28"));
        assert!(!closure(&beam, "plane_depth").contains("pe2"));
    }

    #[test]
    fn ports_are_those_of_the_emitter() {
        let unit = emit(&EmitRequest::new(Unit::CutPlane)).expect("a unit");
        let (_, text) = unit.modules.last().expect("the unit itself");
        assert_eq!(ports(text), unit.ports);
    }
}
