//! A design in which registers that never load decide what is changed.

use crate::sites::{Site, SiteKind, add, exchange_name, exchanged, operation};
use imogene_hdl::{Binary, Design, Module, Net, Node, Op, Register};
use std::collections::HashMap;
use std::fmt;
use std::sync::Arc;

/// A register with another value at power-up: its place among all of the design, those of the instances in a module
/// before its own, and the value.
pub type Upset = (usize, u64);

/// What a mutant changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Change {
    /// A bit is 0.
    StuckAt0,
    /// A bit is 1.
    StuckAt1,
    /// A bit is inverted.
    Inverted,
    /// An operator is another.
    Exchanged,
    /// A bit of a register begins with its inverse.
    Initial,
}

impl fmt::Display for Change {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Change::StuckAt0 => "stuck at 0",
            Change::StuckAt1 => "stuck at 1",
            Change::Inverted => "inverted",
            Change::Exchanged => "exchanged",
            Change::Initial => "inverted at power-up",
        })
    }
}

/// One change of a circuit.
#[derive(Clone, Debug)]
pub struct Mutant {
    /// What is changed.
    pub change: Change,
    /// What makes it of the design with controls.
    pub upsets: Vec<Upset>,
    /// The bit of a net or a register, 0 of an operator.
    pub bit: u32,
    /// Of the control that does it.
    control: usize,
}

/// A mutant of a design, the same under any controls that make it.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Key {
    /// Where it is.
    pub site: Site,
    path: String,
    bit: u32,
    change: Change,
}

/// A control in an instance.
struct Control {
    /// Names of the instances around it.
    path: String,
    module: Arc<Module>,
    site: Site,
    /// Its first register, among all of the design; that which begins otherwise needs no more.
    register: usize,
}

/// A design with a control for each of some sites, in each instance.
pub struct Controls {
    /// The design; without an upset it is what it was.
    pub design: Design,
    controls: Vec<Control>,
}

impl Controls {
    /// Gives these sites of a design controls.
    pub fn new(design: &Design, sites: &[Site]) -> Controls {
        let mut made: HashMap<*const Module, Arc<Module>> = HashMap::new();
        let mut added = HashMap::new();
        for (index, module) in design.top.all().iter().enumerate() {
            let mut own = Module::clone(module);
            for instance in &mut own.instances {
                instance.module = made[&Arc::as_ptr(&instance.module)].clone();
            }
            let of_module = sites.iter().filter(|site| site.module == index);
            let of_module = of_module.map(|site| {
                let register = control(&mut own, module, site.kind);
                (*site, register)
            });
            let of_module: Vec<(Site, usize)> = of_module.collect();
            let own = Arc::new(own);
            added.insert(Arc::as_ptr(&own), (module.clone(), of_module));
            made.insert(Arc::as_ptr(module), own);
        }
        let top = made[&Arc::as_ptr(&design.top)].clone();
        let mut controls = vec![];
        walk(&top, "", &mut 0, &mut |instance, path, first| {
            let (module, of_module) = &added[&Arc::as_ptr(instance)];
            controls.extend(of_module.iter().map(|(site, register)| Control {
                path: path.to_owned(),
                module: module.clone(),
                site: *site,
                register: first + register,
            }));
        });
        Controls {
            design: Design { top },
            controls,
        }
    }

    /// The registers that were added, by their places among all.
    pub(crate) fn registers(&self) -> impl Iterator<Item = usize> {
        self.controls.iter().flat_map(|control| {
            let count = match control.site.kind {
                SiteKind::Initial(_) => 0,
                SiteKind::Operator(..) => 1,
                _ => 2,
            };
            control.register..control.register + count
        })
    }

    /// Every mutant that the controls make, bit by bit.
    pub fn mutants(&self) -> Vec<Mutant> {
        let controls = self.controls.iter().enumerate();
        let mutants = controls.flat_map(|(index, control)| {
            let (width, changes) = control.changes();
            let pairs = (0..width).flat_map(move |bit| changes.iter().map(move |c| (bit, *c)));
            pairs.map(move |(bit, change)| Mutant {
                change,
                upsets: control.upsets(change, bit),
                control: index,
                bit,
            })
        });
        mutants.collect()
    }

    /// Where a mutant is, and what it changes.
    pub fn key(&self, mutant: &Mutant) -> Key {
        let Control { path, site, .. } = &self.controls[mutant.control];
        Key {
            site: *site,
            path: path.clone(),
            bit: mutant.bit,
            change: mutant.change,
        }
    }

    /// What a mutant changes, as `f2.kept_b[3] stuck at 1 (pe2.rs:40)`.
    pub fn describe(&self, mutant: &Mutant) -> String {
        let control = &self.controls[mutant.control];
        let (path, module, site) = (&control.path, &control.module, control.site);
        let register = |index: usize| module.registers[index].net;
        let (net, what) = match site.kind {
            SiteKind::Bits(net) => (net, format!("[{}]", mutant.bit)),
            SiteKind::Operator(net, which) => {
                let other = exchange_name(&module.node(net).op, which);
                (net, format!(" by {other}"))
            }
            SiteKind::Enable(index) => (register(index), " enable".to_owned()),
            SiteKind::Initial(index) => (register(index), format!("[{}]", mutant.bit)),
        };
        let node = module.node(net);
        let name = node.name.clone();
        let name = name.unwrap_or_else(|| operation(&node.op).to_owned());
        let file = node.place.file();
        let file = file.rsplit('/').next().unwrap_or(file);
        let (change, line) = (mutant.change, node.place.line());
        match change {
            Change::Exchanged => format!("{path}{name} {change}{what} ({file}:{line})"),
            _ => format!("{path}{name}{what} {change} ({file}:{line})"),
        }
    }
}

impl Control {
    fn node(&self, net: Net) -> &Node {
        self.module.node(net)
    }

    /// The bits that it can change, and how.
    fn changes(&self) -> (u32, &'static [Change]) {
        use Change::{Exchanged, Initial, Inverted, StuckAt0, StuckAt1};
        let changes: &[Change] = match self.site.kind {
            // Its other value is its inverse.
            SiteKind::Bits(net) if matches!(self.node(net).op, Op::Literal(_)) => &[Inverted],
            SiteKind::Bits(_) | SiteKind::Enable(_) => &[StuckAt0, StuckAt1, Inverted],
            SiteKind::Operator(..) => &[Exchanged],
            SiteKind::Initial(_) => &[Initial],
        };
        (self.width(), changes)
    }

    /// The registers that make a change: what stays of the bits, and what is inverted then.
    fn upsets(&self, change: Change, bit: u32) -> Vec<Upset> {
        let (stay, invert) = (self.register, self.register + 1);
        let stays = |width: u32| u64::MAX >> (64 - width) & !(1 << bit);
        match (self.site.kind, change) {
            (SiteKind::Initial(index), _) => {
                let initial = self.module.registers[index].initial;
                vec![(self.register, initial ^ 1 << bit)]
            }
            (_, Change::Exchanged) => vec![(self.register, 1)],
            (_, Change::Inverted) => vec![(invert, 1 << bit)],
            (_, Change::StuckAt0) => vec![(stay, stays(self.width()))],
            (_, _) => vec![(stay, stays(self.width())), (invert, 1 << bit)],
        }
    }

    fn width(&self) -> u32 {
        match self.site.kind {
            SiteKind::Bits(net) => self.node(net).width,
            SiteKind::Initial(index) => self.node(self.module.registers[index].net).width,
            _ => 1,
        }
    }
}

/// Every instance with its path and the number of its first register among all.
pub(crate) fn walk(
    module: &Arc<Module>,
    path: &str,
    registers: &mut usize,
    visit: &mut impl FnMut(&Arc<Module>, &str, usize),
) {
    for instance in &module.instances {
        let path = format!("{path}{}.", instance.name);
        walk(&instance.module, &path, registers, visit);
    }
    visit(module, path, *registers);
    *registers += module.registers.len();
}

/// Adds a control to a module, which was `original`, and gives the number of its first register, which for what a
/// register begins with is that register.
fn control(module: &mut Module, original: &Module, kind: SiteKind) -> usize {
    let first = module.registers.len();
    match kind {
        SiteKind::Bits(net) => {
            let inner = moved(module, net);
            let changed = masked(module, inner);
            module.nodes[net.0].op = Op::Forward(Some(changed));
        }
        SiteKind::Operator(net, which) => {
            let inner = moved(module, net);
            let node = original.node(net);
            let other = exchanged(module, node, inner, which);
            let is_exchanged = constant(module, 0, 1, inner);
            let op = Op::Select(is_exchanged, other, inner);
            let changed = add(module, op, (node.width, node.signed), inner);
            module.nodes[net.0].op = Op::Forward(Some(changed));
        }
        SiteKind::Enable(index) => {
            let enable = module.registers[index].enable;
            let changed = masked(module, enable.expect("a site with an enable"));
            module.registers[index].enable = Some(changed);
        }
        SiteKind::Initial(index) => return index,
    }
    first
}

/// Another net with what drives a net.
fn moved(module: &mut Module, net: Net) -> Net {
    let Node { width, signed, .. } = *module.node(net);
    let op = module.node(net).op.clone();
    let inner = add(module, op.clone(), (width, signed), net);
    match op {
        Op::Register(index) => module.registers[index].net = inner,
        Op::Read(index) => module.memories[index].net = inner,
        Op::Input => {
            let mut ports = module.ports.iter_mut();
            let port = ports.find(|port| port.net == net);
            port.expect("an input is a port").net = inner;
        }
        _ => {}
    }
    inner
}

/// What stays of a net and is inverted then, by two registers.
fn masked(module: &mut Module, net: Net) -> Net {
    let Node { width, signed, .. } = *module.node(net);
    let stay = constant(module, u64::MAX >> (64 - width), width, net);
    let invert = constant(module, 0, width, net);
    let kept = Op::Binary(Binary::And, net, stay);
    let kept = add(module, kept, (width, signed), net);
    let changed = Op::Binary(Binary::Xor, kept, invert);
    add(module, changed, (width, signed), net)
}

/// A register that never loads.
fn constant(module: &mut Module, initial: u64, width: u32, beside: Net) -> Net {
    let index = module.registers.len();
    let net = add(module, Op::Register(index), (width, false), beside);
    let never = add(module, Op::Literal(0), (1, false), beside);
    module.registers.push(Register {
        net,
        next: Some(net),
        enable: Some(never),
        initial,
        is_state: true,
    });
    net
}
