//! What is being built: one scope for each module that is open.

use crate::bundle::{Bundle, Label};
use crate::tree::{Direction, Instance, Module, Net, Node, Op, PortRecord};
use crate::value::Handle;
use std::cell::RefCell;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::panic::Location;
use std::rc::Rc;

/// Words that Verilog, SystemVerilog or VHDL reserve.
const RESERVED: &str = include_str!("reserved_words.txt");

/// May nothing be called so?
pub(crate) fn is_reserved(name: &str) -> bool {
    RESERVED.split_whitespace().any(|word| word == name)
}

/// A module that is being built.
#[derive(Default)]
pub(crate) struct Scope {
    pub module: Module,
    number: u64,
    /// The net of each operation: what is computed twice is one net.
    known: HashMap<(Op, u32, bool), Net>,
}

#[derive(Default)]
struct Builder {
    open: Vec<Scope>,
    /// Every scope has another number, so that a value of one is known in another.
    scopes: u64,
    /// Each with the name that was asked for.
    closed: Vec<(String, Rc<Module>)>,
}

thread_local! {
    static BUILDER: RefCell<Option<Builder>> = const { RefCell::new(None) };
}

/// A module with all modules in it.
#[derive(Clone, Debug)]
pub struct Design {
    /// The module at the top.
    pub top: Rc<Module>,
}

impl Design {
    /// The one module that a function builds from values of [`Value::input`](crate::Value::input).
    ///
    /// # Panics
    ///
    /// With the names of the values and the line, where the circuit is none.
    #[track_caller]
    pub fn of<T>(build: impl FnOnce() -> T) -> Design {
        let before = BUILDER.with(|builder| builder.borrow_mut().replace(Builder::default()));
        if before.is_some() {
            refuse("a design is being built already".to_owned());
        }
        // What was open is dropped if building it ends in a panic.
        struct Closing;
        impl Drop for Closing {
            fn drop(&mut self) {
                BUILDER.with(|builder| *builder.borrow_mut() = None);
            }
        }
        let _closing = Closing;
        open("design");
        build();
        let outer = close();
        match &outer.instances[..] {
            [only] => Design {
                top: told_apart(&only.module),
            },
            others => refuse(format!("a design is one module, not {}", others.len())),
        }
    }
}

/// A circuit as a module with ports: `at` is the name of this instance. Ports are called as the members of `inputs`
/// and of what the function returns; modules that are equal in all are one.
#[track_caller]
pub fn module<I: Bundle, O: Bundle>(
    name: &str,
    at: &str,
    inputs: I,
    body: impl FnOnce(I) -> O,
) -> O {
    let mut outside = vec![];
    let own = Label::default();
    inputs.each(&own, &mut |_, member| outside.push(member.handle.net));
    let place = Location::caller();
    open(name);
    let mut labels = vec![];
    inputs.each(&own, &mut |label, _| labels.push(label));
    let mut labels = labels.into_iter();
    let inside = inputs.rebuilt(&mut |member| {
        let port = labels.next().expect("as many labels as members");
        let (net, scope) = add(Op::Input, member.handle.width, member.signed, place);
        with_scope(|open| {
            open.module.nodes[net.0 as usize].name = Some(port.name.clone());
            open.module.ports.push(PortRecord {
                name: port.name,
                meaning: port.meaning,
                direction: Direction::In,
                net,
                width: member.handle.width,
                signed: member.signed,
            });
        });
        Handle {
            net,
            scope,
            width: member.handle.width,
        }
    });
    let outputs = body(inside);
    outputs.each(&own, &mut |label, member| {
        with_scope(|open| {
            open.module.ports.push(PortRecord {
                name: label.name,
                meaning: label.meaning,
                direction: Direction::Out,
                net: member.handle.net,
                width: member.handle.width,
                signed: member.signed,
            });
        });
    });
    let module = share(close());
    let index = with_scope(|scope| scope.module.instances.len());
    let mut nets = vec![];
    let result = outputs.rebuilt(&mut |member| {
        let op = Op::Output(index, nets.len());
        let (net, scope) = add(op, member.handle.width, member.signed, place);
        nets.push(net);
        Handle {
            net,
            scope,
            width: member.handle.width,
        }
    });
    with_scope(|scope| {
        scope.module.instances.push(Instance {
            name: at.to_owned(),
            module,
            inputs: outside,
            outputs: nets,
        });
    });
    result
}

/// The module that is equal to this one, or this one; another of the same name makes it take a number.
fn share(mut module: Module) -> Rc<Module> {
    BUILDER.with(|builder| {
        let mut builder = builder.borrow_mut();
        let closed = &mut builder.as_mut().expect("a design is open").closed;
        let wanted = module.name.clone();
        let mut number = 1;
        loop {
            match closed.iter().find(|(_, other)| other.name == module.name) {
                Some((_, other)) if **other == module => return other.clone(),
                Some(_) => {
                    number += 1;
                    module.name = format!("{wanted}_{number}");
                }
                None => break,
            }
        }
        let module = Rc::new(module);
        closed.push((wanted, module.clone()));
        module
    })
}

/// Modules that were to be called alike are called after the width of the first port in which all of them differ, as
/// `pe1_w24` and `pe1_w36`; where there is none, they keep their numbers.
fn told_apart(top: &Rc<Module>) -> Rc<Module> {
    let mut groups: BTreeMap<String, Vec<Rc<Module>>> = BTreeMap::new();
    BUILDER.with(|builder| {
        let builder = builder.borrow();
        for (wanted, module) in builder.iter().flat_map(|builder| &builder.closed) {
            groups
                .entry(wanted.clone())
                .or_default()
                .push(module.clone());
        }
    });
    let mut names = HashMap::new();
    for (wanted, modules) in groups.iter().filter(|(_, modules)| modules.len() > 1) {
        for (module, width) in modules.iter().zip(distinct_widths(modules)) {
            names.insert(Rc::as_ptr(module), format!("{wanted}_w{width}"));
        }
    }
    renamed(top, &names, &mut HashMap::new())
}

/// The widths of the first port that has another in each of the modules; none if no port has.
fn distinct_widths(modules: &[Rc<Module>]) -> Vec<u32> {
    let widths = |port: &PortRecord| -> Vec<u32> {
        let same = |module: &Rc<Module>| {
            let found = module.ports.iter().find(|other| other.name == port.name);
            found.map(|port| port.width)
        };
        modules.iter().filter_map(same).collect()
    };
    let all = modules[0].ports.iter().map(widths);
    let is_distinct = |widths: &Vec<u32>| HashSet::<&u32>::from_iter(widths).len() == modules.len();
    all.into_iter().find(is_distinct).unwrap_or_default()
}

/// The same tree with other names of modules.
fn renamed(
    module: &Rc<Module>,
    names: &HashMap<*const Module, String>,
    done: &mut HashMap<*const Module, Rc<Module>>,
) -> Rc<Module> {
    if let Some(module) = done.get(&Rc::as_ptr(module)) {
        return module.clone();
    }
    let mut own = Module::clone(module);
    if let Some(name) = names.get(&Rc::as_ptr(module)) {
        own.name.clone_from(name);
    }
    for instance in &mut own.instances {
        instance.module = renamed(&instance.module, names, done);
    }
    let own = Rc::new(own);
    done.insert(Rc::as_ptr(module), own.clone());
    own
}

fn open(name: &str) {
    BUILDER.with(|builder| {
        let mut builder = builder.borrow_mut();
        let Some(builder) = builder.as_mut() else {
            drop(builder);
            refuse("no design is being built".to_owned());
        };
        builder.scopes += 1;
        builder.open.push(Scope {
            module: Module {
                name: name.to_owned(),
                ..Module::default()
            },
            number: builder.scopes,
            known: HashMap::new(),
        });
    });
}

#[track_caller]
fn close() -> Module {
    let scope = BUILDER.with(|builder| {
        let mut builder = builder.borrow_mut();
        let builder = builder.as_mut().expect("a design is open");
        builder.open.pop().expect("a module is open")
    });
    let module = scope.module;
    let mut names = HashSet::new();
    for PortRecord { name, .. } in &module.ports {
        if is_reserved(name) || name == "clock" {
            refuse(format!(
                "port `{name}` of module `{}`: languages reserve this word",
                module.name
            ));
        }
        if !names.insert(name) {
            refuse(format!("module `{}` has two ports `{name}`", module.name));
        }
    }
    if let Some(register) = module.registers.iter().find(|r| r.next.is_none()) {
        refuse(format!("{} has no input", described(&module, register.net)));
    }
    let is_free = |node: &Node| node.op == Op::Forward(None);
    if let Some(index) = module.nodes.iter().position(is_free) {
        refuse(format!(
            "{} is driven by nothing",
            described(&module, Net(index as u32))
        ));
    }
    module
}

pub(crate) fn with_scope<T>(edit: impl FnOnce(&mut Scope) -> T) -> T {
    BUILDER.with(|builder| {
        let mut builder = builder.borrow_mut();
        let scope = builder.as_mut().and_then(|builder| builder.open.last_mut());
        edit(scope.expect("values are made while a design is being built"))
    })
}

pub(crate) fn scope_of() -> u64 {
    with_scope(|scope| scope.number)
}

/// The net of an operation, and the number of its scope.
pub(crate) fn add(
    op: Op,
    width: u32,
    signed: bool,
    place: &'static Location<'static>,
) -> (Net, u64) {
    with_scope(|scope| {
        let net = Net(scope.module.nodes.len() as u32);
        if op.is_pure() {
            let known = *scope
                .known
                .entry((op.clone(), width, signed))
                .or_insert(net);
            if known != net {
                return (known, scope.number);
            }
        }
        scope.module.nodes.push(Node {
            op,
            width,
            signed,
            name: None,
            place,
        });
        (net, scope.number)
    })
}

/// A value for a message: its name or what makes it, its width and its line.
pub(crate) fn node_of(handle: Handle) -> String {
    BUILDER.with(|builder| {
        let builder = builder.borrow();
        let mut open = builder.iter().flat_map(|builder| &builder.open);
        match open.find(|scope| scope.number == handle.scope) {
            Some(scope) => described(&scope.module, handle.net),
            None => format!(
                "a value of {} bits of a module that is closed",
                handle.width
            ),
        }
    })
}

/// The same of a net of a module.
pub(crate) fn described(module: &Module, net: Net) -> String {
    let node = module.node(net);
    let name = match (&node.name, &node.op) {
        (Some(name), _) => format!("`{name}`"),
        (None, Op::Literal(value)) => format!("the literal {value}"),
        (None, Op::Register(_)) => "a register without a name".to_owned(),
        (None, _) => "a value without a name".to_owned(),
    };
    let kind = if node.signed { "number" } else { "word" };
    format!(
        "{name} ({kind} of {} bits, {}) of module `{}`",
        node.width, node.place, module.name
    )
}

/// The circuit is none.
#[track_caller]
pub(crate) fn refuse(problem: String) -> ! {
    panic!("circuit refused: {problem}")
}
