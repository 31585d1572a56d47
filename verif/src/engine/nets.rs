//! Nets inside a machine, by their paths.

use crate::signal::Signal;
use imogene_hdl::Module;
use std::collections::HashSet;
use thiserror::Error;

/// The path of everything.
const ALL: &str = "all";

/// Why a net cannot be shown.
#[derive(Debug, Error)]
pub enum NetError {
    /// There is none: its path, the module that has it not, and what that has.
    #[error(
        "there is no net or instance '{path}': {module} has {accepted}, and '{ALL}' is every net"
    )]
    Unknown {
        /// What was asked for.
        path: String,
        /// The last instance of the path that is there, or the machine.
        module: String,
        /// Its instances and nets.
        accepted: String,
    },
    /// A simulator of Verilog was to show one.
    #[error("nets inside a machine are shown by the built-in engine alone")]
    Engine,
}

/// The nets that have these paths, and all nets in the instances that have them, each under its path: the names of the
/// instances around it and its own, parted by dots. Ports are nets as well.
pub fn select(top: &Module, paths: &[String]) -> Result<Vec<Signal>, NetError> {
    let mut walk = Walk {
        paths,
        met: HashSet::new(),
        found: vec![],
    };
    let is_all = walk.is_wanted(ALL);
    walk.visit(top, "", is_all);
    match paths.iter().find(|path| !walk.met.contains(path.as_str())) {
        Some(path) => Err(unknown(top, path)),
        None => Ok(walk.found),
    }
}

struct Walk<'a> {
    paths: &'a [String],
    /// Those that are there.
    met: HashSet<&'a str>,
    found: Vec<Signal>,
}

impl Walk<'_> {
    fn is_wanted(&mut self, path: &str) -> bool {
        let wanted = self.paths.iter().find(|wanted| *wanted == path);
        self.met.extend(wanted.map(String::as_str));
        wanted.is_some()
    }

    /// A module whose path, with the dot behind it, is `around`.
    fn visit(&mut self, module: &Module, around: &str, is_chosen: bool) {
        for net in nets(module) {
            let name = format!("{around}{}", net.name);
            if self.is_wanted(&name) || is_chosen {
                self.found.push(Signal { name, ..net });
            }
        }
        for instance in &module.instances {
            let path = format!("{around}{}", instance.name);
            let is_chosen = self.is_wanted(&path) || is_chosen;
            self.visit(&instance.module, &(path + "."), is_chosen);
        }
    }
}

/// Ports of a module, and its nets that have names.
fn nets(module: &Module) -> Vec<Signal> {
    let named = module
        .nets()
        .filter_map(|(_, node)| Some(Signal::new(node.name.as_ref()?, node.width, node.signed)));
    let mut list: Vec<Signal> = module.ports.iter().map(Signal::of).chain(named).collect();
    let mut known = HashSet::new();
    list.retain(|net| known.insert(net.name.clone()));
    list
}

fn unknown(top: &Module, path: &str) -> NetError {
    let (mut module, mut name) = (top, top.name.as_str());
    for ((at, _), part) in path.match_indices('.').zip(path.split('.')) {
        let mut parts = module.instances.iter();
        let Some(found) = parts.find(|instance| instance.name == part) else {
            break;
        };
        (module, name) = (&found.module, &path[..at]);
    }
    let instances = module.instances.iter().map(|one| one.name.clone());
    let nets = nets(module).into_iter().map(|net| net.name);
    NetError::Unknown {
        path: path.to_owned(),
        module: name.to_owned(),
        accepted: instances.chain(nets).collect::<Vec<_>>().join(", "),
    }
}
