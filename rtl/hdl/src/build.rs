//! What is being built: one scope for each module that is open.

use crate::bare::Ports;
use crate::bundle::{Label, members};
use crate::tree::{Direction, Instance, Module, Net, Node, Op, PortRecord};
use crate::value::Handle;
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::fmt::{Display, Formatter, Result};
use std::panic::Location;
use std::rc::Rc;

/// Words that Verilog, SystemVerilog or VHDL reserve.
const RESERVED: &str = include_str!("reserved_words.txt");

/// May nothing be called so?
pub(crate) fn is_reserved(name: &str) -> bool {
    RESERVED.split_whitespace().any(|word| word == name)
}

/// Ends the building: the circuit is none.
macro_rules! refuse {
    ($($problem:tt)*) => {{
        let problem = format!($($problem)*);
        panic!("circuit refused: {problem}")
    }};
}
pub(crate) use refuse;

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
    /// Each with the name that was asked for, those inside before those around them.
    closed: Vec<(String, Rc<Module>)>,
}

thread_local! {
    static BUILDER: RefCell<Builder> = RefCell::default();
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
        if BUILDER.with_borrow(|builder| !builder.open.is_empty()) {
            refuse!("a design is being built already");
        }
        // What was open is dropped if building it ends in a panic.
        struct Closing;
        impl Drop for Closing {
            fn drop(&mut self) {
                BUILDER.take();
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
    let (labels, outside): (Vec<Label>, Vec<Handle>) = members(&inputs).into_iter().unzip();
    let mut labels = labels.into_iter();
    let inside = inputs.rebuilt(&mut |outside| {
        let label = labels.next().expect("as many labels as members");
        let inside = add(Op::Input, outside.width, outside.signed, place);
        inside.edit(|node| node.name = Some(label.name.clone()));
        declare(label, Direction::In, inside);
        inside
    });
    let outputs = body(inside.bare());
    for (label, driver) in members(&outputs) {
        declare(label, Direction::Out, driver);
    }
    let module = share(close());
    let mut nets = vec![];
    let result = outputs.rebuilt(&mut |inside| {
        let op = Op::Output(index, nets.len());
        let output = add(op, inside.width, inside.signed, place);
        nets.push(output.net);
        output
    });
    with_scope(|around| {
        around.module.instances.push(Instance {
            name: at.to_owned(),
            module,
            inputs: outside.iter().map(|value| value.net).collect(),
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

/// The module that is equal to this one, or this one; another of the same name makes it take a number.
fn share(mut module: Module) -> Rc<Module> {
    BUILDER.with_borrow_mut(|Builder { closed, .. }| {
        let wanted = module.name.clone();
        for number in 2.. {
            match closed.iter().find(|(_, other)| other.name == module.name) {
                Some((_, other)) if **other == module => return other.clone(),
                Some(_) => module.name = format!("{wanted}_{number}"),
                None => break,
            }
        }
        let module = Rc::new(module);
        closed.push((wanted, module.clone()));
        module
    })
}

/// The same tree, in which modules that were to be called alike are called after the width of the first port in which
/// all of them differ, as `pe1_w24` and `pe1_w36`; where there is none, they keep their numbers.
fn told_apart(top: &Rc<Module>) -> Rc<Module> {
    let closed = BUILDER.take().closed;
    let mut renamed: HashMap<*const Module, Rc<Module>> = HashMap::new();
    for (wanted, module) in &closed {
        let alike = closed.iter().filter(|(other, _)| other == wanted);
        let alike: Vec<&Module> = alike.map(|(_, other)| &**other).collect();
        let mut own = Module::clone(module);
        if let Some(width) = own_width(module, &alike) {
            own.name = format!("{wanted}_w{width}");
        }
        for instance in &mut own.instances {
            instance.module = renamed[&Rc::as_ptr(&instance.module)].clone();
        }
        renamed.insert(Rc::as_ptr(module), Rc::new(own));
    }
    renamed[&Rc::as_ptr(top)].clone()
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

fn open(name: &str) {
    BUILDER.with_borrow_mut(|builder| {
        builder.scopes += 1;
        let mut scope = Scope {
            number: builder.scopes,
            ..Scope::default()
        };
        scope.module.name = name.to_owned();
        builder.open.push(scope);
    });
}

#[track_caller]
fn close() -> Module {
    let scope = BUILDER.with_borrow_mut(|builder| builder.open.pop());
    let module = scope.expect("a module is open").module;
    let own = &module.name;
    let mut names = HashSet::new();
    for PortRecord { name, .. } in &module.ports {
        if is_reserved(name) || name == "clock" {
            refuse!("port `{name}` of module `{own}`: languages reserve this word");
        }
        if !names.insert(name) {
            refuse!("module `{own}` has two ports `{name}`");
        }
    }
    if let Some(register) = module.registers.iter().find(|r| r.next.is_none()) {
        refuse!("{} has no input", described(&module, register.net));
    }
    let is_free = |(_, node): &(Net, &Node)| node.op == Op::Forward(None);
    if let Some((net, _)) = module.nets().find(is_free) {
        refuse!("{} is driven by nothing", described(&module, net));
    }
    module
}

pub(crate) fn with_scope<T>(edit: impl FnOnce(&mut Scope) -> T) -> T {
    BUILDER.with_borrow_mut(|builder| {
        let scope = builder.open.last_mut();
        edit(scope.expect("values are made while a design is being built"))
    })
}

/// The value of an operation.
pub(crate) fn add(op: Op, width: u32, signed: bool, place: &'static Location<'static>) -> Handle {
    with_scope(
        |Scope {
             module,
             number,
             known,
         }| {
            let new = Net(module.nodes.len());
            let net = match op.is_pure() {
                true => *known.entry((op.clone(), width, signed)).or_insert(new),
                false => new,
            };
            if net == new {
                module.nodes.push(Node {
                    op,
                    width,
                    signed,
                    name: None,
                    place,
                });
            }
            Handle {
                net,
                scope: *number,
                width,
                signed,
            }
        },
    )
}

impl Handle {
    /// Changes its net.
    pub(crate) fn edit<T>(self, edit: impl FnOnce(&mut Node) -> T) -> T {
        with_scope(|scope| edit(&mut scope.module.nodes[self.net.0]))
    }

    /// Refuses a value of another module than the one that is being built.
    #[track_caller]
    pub(crate) fn check_scope(self) {
        if self.scope != with_scope(|scope| scope.number) {
            refuse!("{self} belongs to another module than the one that is being built");
        }
    }
}

/// A value for a message: its name or what makes it, its width and its line.
impl Display for Handle {
    fn fmt(&self, text: &mut Formatter) -> Result {
        BUILDER.with_borrow(|builder| {
            let mut open = builder.open.iter();
            match open.find(|scope| scope.number == self.scope) {
                Some(scope) => text.write_str(&described(&scope.module, self.net)),
                None => write!(
                    text,
                    "a value of {} bits of a module that is closed",
                    self.width
                ),
            }
        })
    }
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
    let (width, place, module) = (node.width, node.place, &module.name);
    format!("{name} ({kind} of {width} bits, {place}) of module `{module}`")
}
