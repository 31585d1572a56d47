//! One module for all equal sub-blocks, under a readable name.

use super::EmitError;
use super::collect::{Kernel, MEMORY_UNIT, Scope};
use super::memory;
use super::module::{body, is_port};
use super::names::check_identifier;
use rust_hdl::core::prelude::AtomKind;
use std::collections::{BTreeMap, HashMap, HashSet};

/// A distinct module. In its text `{n}` between control characters stands for the name of module n.
struct Distinct {
    unit: String,
    text: String,
    width: usize,
    signed: bool,
    count: usize,
}

#[derive(Default)]
struct Merger {
    modules: Vec<Distinct>,
    known: HashMap<(String, String), usize>,
}

const MARK: char = '\u{1}';

impl Merger {
    /// Number of the module of a scope; its sub-blocks come first.
    fn module(&mut self, scope: &Scope) -> Result<usize, EmitError> {
        let unit = match &scope.kernel {
            Ok(Kernel::Statements { unit, .. }) => {
                check_identifier(unit)?;
                unit.clone()
            }
            Ok(Kernel::Memory(_)) => MEMORY_UNIT.to_owned(),
            Ok(Kernel::Register) => {
                return Err(EmitError::block(&scope.instance, "is a bare register"));
            }
            Err(error) => return Err(error.clone()),
        };
        let mut children = Vec::new();
        for child in &scope.children {
            children.push(if child.is_register() {
                0
            } else {
                self.module(child)?
            });
        }
        let text = match scope.kernel {
            Ok(Kernel::Memory(bits)) => memory::body(scope, bits),
            _ => body(scope, &|child| format!("{MARK}{}{MARK}", children[child]))?,
        };
        let key = (unit, text);
        if let Some(number) = self.known.get(&key) {
            return Ok(*number);
        }
        let number = self.modules.len();
        self.modules.push(distinct(scope, &key));
        self.known.insert(key, number);
        Ok(number)
    }

    /// Names of all modules. Equal units of different shape get the shape behind the name.
    fn names(&self, top: usize) -> Vec<String> {
        let mut groups: BTreeMap<&str, Vec<usize>> = BTreeMap::new();
        for (number, module) in self
            .modules
            .iter()
            .enumerate()
            .filter(|(number, _)| *number != top)
        {
            groups.entry(&module.unit).or_default().push(number);
        }
        let mut names = vec![self.modules[top].unit.clone(); self.modules.len()];
        for (unit, numbers) in groups {
            let suffix = self.suffix(&numbers);
            for (place, number) in numbers.iter().enumerate() {
                names[*number] = format!("{unit}{}", suffix(&self.modules[*number], place));
            }
        }
        names
    }

    /// The shortest suffix that tells the modules of a group apart.
    fn suffix(&self, numbers: &[usize]) -> fn(&Distinct, usize) -> String {
        let suffixes: [fn(&Distinct, usize) -> String; 5] = [
            |_, _| String::new(),
            |module, _| format!("_w{}", module.width),
            |module, _| format!("_x{}", module.count),
            |module, _| {
                let sign = if module.signed { "s" } else { "" };
                format!("_w{}{sign}_x{}", module.width, module.count)
            },
            |module, place| format!("_w{}_v{}", module.width, place + 1),
        ];
        let distinguishes = |suffix: &fn(&Distinct, usize) -> String| {
            let mut seen = HashSet::new();
            numbers
                .iter()
                .enumerate()
                .all(|(place, number)| seen.insert(suffix(&self.modules[*number], place)))
        };
        suffixes
            .into_iter()
            .find(distinguishes)
            .expect("the last suffix counts the modules")
    }
}

/// The shape of a module: width of its first output, and how many sub-blocks, or else registers, it holds; of a memory, bits of its address.
fn distinct(scope: &Scope, key: &(String, String)) -> Distinct {
    let output = scope
        .nets
        .iter()
        .filter(|net| is_port(net))
        .find(|net| net.kind == AtomKind::OutputParameter);
    let blocks = scope
        .children
        .iter()
        .filter(|child| !child.is_register())
        .count();
    Distinct {
        unit: key.0.clone(),
        text: key.1.clone(),
        width: output.map_or(0, |net| net.width),
        signed: output.is_some_and(|net| net.signed),
        count: match &scope.kernel {
            Ok(Kernel::Memory(bits)) => *bits,
            _ if blocks == 0 => scope.children.len(),
            _ => blocks,
        },
    }
}

/// The modules of a block, leaves first, the block itself last under the name of its unit; every name has the prefix.
pub fn modules(scope: &Scope, prefix: &str) -> Result<Vec<(String, String)>, EmitError> {
    let mut merger = Merger::default();
    let top = merger.module(scope)?;
    let names: Vec<String> = merger
        .names(top)
        .iter()
        .map(|name| format!("{prefix}{name}"))
        .collect();
    names.iter().try_for_each(|name| check_identifier(name))?;
    let named = |text: &str| -> String {
        let parts = text.split(MARK).enumerate();
        parts
            .map(|(place, part)| match part.parse::<usize>() {
                Ok(number) if place % 2 == 1 => names[number].as_str(),
                _ => part,
            })
            .collect()
    };
    Ok(merger
        .modules
        .iter()
        .zip(&names)
        .map(|(module, name)| (name.clone(), named(&module.text)))
        .collect())
}
