//! The modules of an emitted machine: how often each stands in it, what it holds, its ports.

use crate::cache::digest;
use imogene_rtl::emit::{Direction, Emitted, Port};
use std::collections::{BTreeMap, BTreeSet};

/// How finely machines are divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parts {
    /// The deciding part with all that is below it is one part: nearest to the flat machine, for few machines.
    Cores,
    /// Every unit is a part of its own: for many machines, which share most of their units.
    Units,
}

impl Parts {
    /// Modules that hold parts; what they hold is synthesised apart. Every other module is synthesised with all that is
    /// below it, since constants that pass from one to the next take much of it away, as in the triangle of a root
    /// network.
    fn composites(self) -> &'static [&'static str] {
        match self {
            Parts::Cores => &[],
            Parts::Units => &[
                "beam_core",
                "zone_core",
                "object_array",
                "decider",
                "quadric_processor",
                "patch_processor",
                "quadric_pe",
            ],
        }
    }
}

/// A module of a machine that is synthesised apart.
#[derive(Clone, Debug)]
pub struct Module {
    /// Name.
    pub name: String,
    /// Of its text, in which the names and widths of its ports and of those below it stand; of a unit, of all texts
    /// below it too.
    pub digest: String,
    /// Bits that the same texts declare.
    pub bits: u64,
    /// Instances in the whole machine.
    pub instances: u64,
    /// Instances of each module below that is synthesised apart.
    pub children: BTreeMap<String, u64>,
}

/// True if a module is one of this kind.
pub fn is_of(name: &str, kind: &str) -> bool {
    kind_of(name) == kind
}

/// The kind of a module: variants have their widths or a number behind the name, as in `normal_unit_w12_v2` and
/// `patch_processor_3`.
pub(super) fn kind_of(name: &str) -> &str {
    let is_mark = |part: &str| {
        let digits = part.trim_start_matches(['w', 'v', 'x']);
        !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit())
    };
    match name.rsplit_once('_') {
        Some((kind, mark)) if is_mark(mark) => kind_of(kind),
        _ => name,
    }
}

/// The modules of a machine that are synthesised apart, the top first.
pub fn modules(machine: &Emitted, parts: Parts) -> Vec<Module> {
    let composites = parts.composites();
    let module = |(name, text): &(String, String)| {
        let is_top = *name == machine.top;
        let (own, children) = match is_top || composites.iter().any(|kind| is_of(name, kind)) {
            true => (text.clone(), children(text, machine)),
            false => {
                let texts = below(machine, name).map(|(_, text)| &**text);
                (texts.collect(), BTreeMap::new())
            }
        };
        Module {
            name: name.clone(),
            digest: digest(&own),
            bits: declared_bits(&own),
            instances: u64::from(is_top),
            children,
        }
    };
    let mut list: Vec<Module> = machine.modules.iter().rev().map(module).collect();
    // Leaves stand first in the text, so every module comes before those below it here.
    for index in 0..list.len() {
        let (times, children) = (list[index].instances, list[index].children.clone());
        for module in &mut list[index + 1..] {
            module.instances += times * children.get(&module.name).copied().unwrap_or(0);
        }
    }
    list.retain(|module| module.instances > 0);
    list
}

/// A module and all below it, with their texts, in the order of the machine.
pub(super) fn below<'a>(
    machine: &'a Emitted,
    name: &str,
) -> impl Iterator<Item = &'a (String, String)> + use<'a> {
    let needed = closure(machine, name);
    let modules = machine.modules.iter();
    modules.filter(move |(name, _)| needed.contains(name))
}

/// Bits that a text declares: of ports, wires and registers, with every element of an array.
pub fn declared_bits(text: &str) -> u64 {
    let (mut bits, mut width) = (0, None);
    for piece in text.split_inclusive([',', ';', '(']) {
        let (body, end) = piece.split_at(piece.len() - 1);
        let body = body.trim();
        let is_declaration = ["input", "output", "wire", "reg"]
            .iter()
            .any(|word| body.starts_with(word));
        let (before, ranges) = body.split_once('[').unwrap_or((body, ""));
        let mut ranges = ranges.split('[').filter_map(span);
        if is_declaration {
            let is_array = before.split_whitespace().count() > 2 && !before.contains("signed");
            let own = (!is_array).then(|| ranges.next()).flatten();
            width = Some(own.unwrap_or(1));
        }
        if let Some(width) = width {
            bits += width * ranges.next().unwrap_or(1);
        }
        if end != "," {
            width = None;
        }
    }
    bits
}

/// The numbers of a range, of which the brackets are gone: `15:0] name`.
fn span(range: &str) -> Option<u64> {
    let (first, last) = range.split_once(']')?.0.split_once(':')?;
    let [first, last] = [first, last].map(|number| number.trim().parse::<u64>().ok());
    Some(first?.abs_diff(last?) + 1)
}

/// Instances in a text: lines of the form `module instance (`, as often as the loop around them runs.
fn children(text: &str, machine: &Emitted) -> BTreeMap<String, u64> {
    let mut children = BTreeMap::new();
    let mut times = 1;
    for line in text.lines() {
        if let Some((_, bound)) = line.split_once("for (k = 0; k < ") {
            let bound = bound.split(';').next().unwrap_or_default();
            times = bound.parse().unwrap_or(1);
        } else if line.trim() == "end" {
            times = 1;
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        if let [module, _, "("] = words[..]
            && machine.modules.iter().any(|(name, _)| name == module)
        {
            *children.entry(module.to_owned()).or_insert(0) += times;
        }
    }
    children
}

/// A module and all below it.
pub fn closure(machine: &Emitted, name: &str) -> BTreeSet<String> {
    let mut needed = BTreeSet::from([name.to_owned()]);
    // A module stands behind those below it.
    for (module, text) in machine.modules.iter().rev() {
        if needed.contains(module) {
            needed.extend(children(text, machine).into_keys());
        }
    }
    needed
}

/// The ports that a module declares; several of a kind stand behind one declaration.
pub fn ports(text: &str) -> Vec<Port> {
    let head = text.split_once("(\n").map_or("", |(_, rest)| rest);
    let (head, _) = head.split_once("\n);").unwrap_or((head, ""));
    let mut list: Vec<Port> = vec![];
    for declaration in head.split(',') {
        // A register has its initial value behind its name.
        let (declaration, _) = declaration.split_once(" = ").unwrap_or((declaration, ""));
        let words: Vec<&str> = declaration.split_whitespace().collect();
        let Some((name, kind)) = words.split_last() else {
            continue;
        };
        let mut port = match (kind, list.last()) {
            ([], Some(before)) => before.clone(),
            _ => port(kind),
        };
        port.name = (*name).to_owned();
        list.push(port);
    }
    list
}

/// A port of a kind: direction, sign, range.
fn port(kind: &[&str]) -> Port {
    let high = kind.iter().find_map(|word| word.strip_prefix('['));
    let high = high.and_then(|range| range.split(':').next()?.parse::<usize>().ok());
    Port {
        name: String::new(),
        meaning: String::new(),
        direction: match kind.first() {
            Some(&"input") => Direction::In,
            _ => Direction::Out,
        },
        width: high.map_or(1, |high| high + 1),
        signed: kind.contains(&"signed"),
    }
}
