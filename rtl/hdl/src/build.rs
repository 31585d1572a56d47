//! Modules and designs.

use crate::bare::Ports;
use crate::bundle::{Label, members};
use crate::scope::{
    Closed, Handle, add, clear, close, is_building, open, refuse, share, with_scope,
};
use crate::tree::{Direction, Instance, Module, Op, PortRecord};
use std::collections::{HashMap, HashSet};
use std::panic::Location;
use std::sync::Arc;

/// A module with all modules in it.
#[derive(Clone, Debug)]
pub struct Design {
    /// The module at the top.
    pub top: Arc<Module>,
}

impl Design {
    /// The one module that a function builds from values of [`Value::input`](crate::Value::input).
    ///
    /// # Panics
    ///
    /// With the names of the values and the line, where the circuit is none.
    #[track_caller]
    pub fn of<T>(build: impl FnOnce() -> T) -> Design {
        if is_building() {
            refuse!("a design is being built already");
        }
        // What was open is dropped if building it ends in a panic.
        struct Closing;
        impl Drop for Closing {
            fn drop(&mut self) {
                clear();
            }
        }
        let _closing = Closing;
        open("design");
        build();
        let outer = close();
        match &outer.instances[..] {
            [only] => Design {
                top: told_apart(&only.module, &clear()),
            },
            others => refuse!("a design is one module, not {}", others.len()),
        }
    }
}

/// A circuit as a module with ports: `at` is the name of this instance. Ports are called as the members of `inputs`
/// and of what the function returns, and the names around them are for the ports alone: the function takes and the
/// caller gets the bare values. Modules that are equal in all are one.
#[track_caller]
pub fn module<I: Ports, O: Ports>(
    name: &str,
    at: &str,
    inputs: I,
    body: impl FnOnce(I::Bare) -> O,
) -> O::Bare {
    let place = Location::caller();
    let index = with_scope(|around| around.module.instances.len());
    open(name);
    let mut connected = vec![];
    let inside = inputs.walked(&Label::default(), &mut |label, outside| {
        connected.push(outside.net);
        let inside = add(Op::Input, outside.width, outside.signed, place);
        inside.edit(|node| node.name = Some(label.name.clone()));
        declare(label, Direction::In, inside);
        inside
    });
    let outputs = body(inside.bare());
    for (label, driver) in members(&outputs) {
        if label.name.is_empty() {
            refuse!("an output of {name} without a name");
        }
        declare(label, Direction::Out, driver);
    }
    let module = share(close());
    let mut nets = vec![];
    let result = outputs.walked(&Label::default(), &mut |_, inside| {
        let op = Op::Output(index, nets.len());
        let output = add(op, inside.width, inside.signed, place);
        nets.push(output.net);
        output
    });
    with_scope(|around| {
        around.module.instances.push(Instance {
            name: at.to_owned(),
            module,
            inputs: connected,
            outputs: nets,
        });
    });
    result.bare()
}

fn declare(label: Label, direction: Direction, value: Handle) {
    let port = PortRecord {
        name: label.name,
        meaning: label.meaning,
        direction,
        net: value.net,
        width: value.width,
        signed: value.signed,
    };
    with_scope(|scope| scope.module.ports.push(port));
}

/// The same tree, in which modules that were to be called alike are called after the width of the first port in which
/// all of them differ, as `pe1_w24` and `pe1_w36`; where there is none, they keep their numbers.
fn told_apart(top: &Arc<Module>, closed: &Closed) -> Arc<Module> {
    let mut renamed: HashMap<*const Module, Arc<Module>> = HashMap::new();
    for (wanted, module) in closed {
        let alike = closed.iter().filter(|(other, _)| other == wanted);
        let alike: Vec<&Module> = alike.map(|(_, other)| &**other).collect();
        let mut own = Module::clone(module);
        if let Some(width) = own_width(module, &alike) {
            own.name = format!("{wanted}_w{width}");
        }
        for instance in &mut own.instances {
            instance.module = renamed[&Arc::as_ptr(&instance.module)].clone();
        }
        renamed.insert(Arc::as_ptr(module), Arc::new(own));
    }
    renamed[&Arc::as_ptr(top)].clone()
}

/// The width of the first port that has another in each of some modules.
fn own_width(module: &Module, alike: &[&Module]) -> Option<u32> {
    let width = |module: &Module, name: &str| {
        let found = module.ports.iter().find(|port| port.name == name);
        found.map(|port| port.width)
    };
    let is_distinct = |port: &&PortRecord| {
        let widths = alike.iter().filter_map(|other| width(other, &port.name));
        alike.len() > 1 && widths.collect::<HashSet<u32>>().len() == alike.len()
    };
    let port = alike[0].ports.iter().find(is_distinct)?;
    width(module, &port.name)
}
