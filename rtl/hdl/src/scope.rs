//! What is being built: one scope for each module that is open.

use crate::tree::{Module, Net, Node, Op, PortRecord};
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};
use std::fmt::{Display, Formatter, Result};
use std::panic::Location;
use std::sync::Arc;
use std::sync::LazyLock;

/// Words that Verilog, SystemVerilog or VHDL reserve.
const RESERVED: &str = include_str!("reserved_words.txt");

/// May nothing be called so?
pub(crate) fn is_reserved(name: &str) -> bool {
    static WORDS: LazyLock<HashSet<&str>> = LazyLock::new(|| RESERVED.split_whitespace().collect());
    WORDS.contains(name)
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

/// Modules that are built, each with the name that was asked for, those inside before those around them.
pub(crate) type Closed = Vec<(String, Arc<Module>)>;

#[derive(Default)]
struct Builder {
    open: Vec<Scope>,
    /// Every scope has another number, so that a value of one is known in another.
    scopes: u64,
    closed: Closed,
    /// Values take no register on their way.
    is_unregistered: bool,
}

thread_local! {
    static BUILDER: RefCell<Builder> = RefCell::default();
}

/// A net in the module that is being built.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Handle {
    pub(crate) net: Net,
    pub(crate) scope: u64,
    pub(crate) width: u32,
    pub(crate) signed: bool,
}

/// Builds what is inside without the registers of its pipelines, [`reg`](crate::Value::reg), `delay` and what is made
/// of them: all of it works within the clock, and no value is late to another. Registers that hold a state stay.
pub fn unregistered<T>(build: impl FnOnce() -> T) -> T {
    let set = |value| {
        BUILDER.with_borrow_mut(|builder| std::mem::replace(&mut builder.is_unregistered, value))
    };
    let before = set(true);
    let built = build();
    set(before);
    built
}

/// Do values take no register on their way?
pub(crate) fn is_unregistered() -> bool {
    BUILDER.with_borrow(|builder| builder.is_unregistered)
}

/// Is a module open?
pub(crate) fn is_building() -> bool {
    BUILDER.with_borrow(|builder| !builder.open.is_empty())
}

/// Drops what is open, and hands over what is closed.
pub(crate) fn clear() -> Closed {
    BUILDER.take().closed
}

/// The module that is equal to this one, or this one; another of the same name makes it take a number.
pub(crate) fn share(mut module: Module) -> Arc<Module> {
    BUILDER.with_borrow_mut(|Builder { closed, .. }| {
        let wanted = module.name.clone();
        for number in 2.. {
            match closed.iter().find(|(_, other)| other.name == module.name) {
                Some((_, other)) if **other == module => return other.clone(),
                Some(_) => module.name = format!("{wanted}_{number}"),
                None => break,
            }
        }
        let module = Arc::new(module);
        closed.push((wanted, module.clone()));
        module
    })
}

pub(crate) fn open(name: &str) {
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
pub(crate) fn close() -> Module {
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
                None => {
                    let width = self.width;
                    write!(text, "a value of {width} bits of a module that is closed")
                }
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
