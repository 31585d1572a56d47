//! Words and numbers, and what is done with them.

mod memory;
mod operators;

pub use memory::memory;

use crate::build::{add, node_of, refuse, scope_of, with_scope};
use crate::tree::{Binary, Net, Op, Register, WIDEST};
use std::panic::Location;

/// A net in the module that is being built.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Handle {
    pub(crate) net: Net,
    pub(crate) scope: u64,
    pub(crate) width: u32,
}

/// An unsigned word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bits(pub(crate) Handle);

/// A two's complement number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Int(pub(crate) Handle);

/// What words and numbers have in common.
pub trait Value: Copy {
    /// A two's complement number.
    const SIGNED: bool;

    #[doc(hidden)]
    fn handle(self) -> Handle;

    #[doc(hidden)]
    fn of(handle: Handle) -> Self;

    /// Bits.
    fn width(self) -> u32 {
        self.handle().width
    }

    /// The same value under a name; a value that has one keeps it.
    #[track_caller]
    fn named(self, name: &str) -> Self {
        let handle = self.handle();
        with_scope(|scope| {
            let node = &mut scope.module.nodes[handle.net.0 as usize];
            if node.name.is_none() && node.op != Op::Input {
                node.name = Some(name.to_owned());
            }
        });
        self
    }

    /// A port of the module that is being built.
    #[track_caller]
    fn input(width: u32) -> Self {
        make(Op::Input, width)
    }

    /// A constant.
    #[track_caller]
    fn literal(value: u64, width: u32) -> Self {
        make(Op::Literal(value), width)
    }

    /// A value that is driven later, by [`Value::drive`].
    #[track_caller]
    fn forward(width: u32) -> Self {
        make(Op::Forward(None), width)
    }

    /// Says what a forward value is.
    #[track_caller]
    fn drive(self, value: Self) {
        let [own, other] = [self.handle(), value.handle()];
        same_width("is driven by", own, other);
        let is_free = with_scope(|scope| {
            let op = &mut scope.module.nodes[own.net.0 as usize].op;
            let is_free = *op == Op::Forward(None);
            *op = Op::Forward(Some(other.net));
            is_free
        });
        if !is_free {
            refuse(format!(
                "{} is driven twice, or is no forward value",
                node_of(own)
            ));
        }
    }

    /// A register, 0 at power-up, that [`Value::load`] or [`Value::load_when`] gives an input.
    #[track_caller]
    fn register(width: u32) -> Self {
        let index = with_scope(|scope| scope.module.registers.len());
        let value: Self = make(Op::Register(index), width);
        with_scope(|scope| {
            scope.module.registers.push(Register {
                net: value.handle().net,
                next: None,
                enable: None,
                initial: 0,
            });
        });
        value
    }

    /// The value of this register at power-up.
    #[track_caller]
    fn initially(self, value: u64) -> Self {
        fits(value, self.width());
        edit_register(self.handle(), |register| register.initial = value);
        self
    }

    /// The input of this register.
    #[track_caller]
    fn load(self, next: Self) {
        load(self.handle(), None, next.handle());
    }

    /// The input of this register, taken where `enable` is 1.
    #[track_caller]
    fn load_when(self, enable: Bits, next: Self) {
        load(self.handle(), Some(enable.0), next.handle());
    }

    /// One clock later.
    #[track_caller]
    fn reg(self) -> Self {
        let register = Self::register(self.width());
        register.load(self);
        register
    }

    /// One clock later, taken where `enable` is 1.
    #[track_caller]
    fn reg_when(self, enable: Bits) -> Self {
        let register = Self::register(self.width());
        register.load_when(enable, self);
        register
    }

    /// So many clocks later.
    #[track_caller]
    fn delay(self, clocks: u32) -> Self {
        delayed(self, None, clocks)
    }

    /// The same through registers with a name.
    #[track_caller]
    fn delayed_as(self, name: &str, clocks: u32) -> Self {
        delayed(self, Some(name), clocks)
    }

    /// The low bits.
    #[track_caller]
    fn low(self, width: u32) -> Self {
        part(self, width, 0)
    }

    /// The high bits.
    #[track_caller]
    fn high(self, width: u32) -> Self {
        part(self, width, self.width().saturating_sub(width))
    }

    /// Bits `high` down to `low`.
    #[track_caller]
    fn slice(self, high: u32, low: u32) -> Bits {
        let handle = self.handle();
        if high < low || high >= handle.width {
            refuse(format!("{} has no bits {high} to {low}", node_of(handle)));
        }
        if high - low + 1 == handle.width {
            return as_bits(self);
        }
        make(Op::Slice(handle.net, low), high - low + 1)
    }

    /// One bit.
    #[track_caller]
    fn bit(self, index: u32) -> Bits {
        self.slice(index, index)
    }

    /// The highest bit.
    #[track_caller]
    fn top(self) -> Bits {
        self.bit(self.width() - 1)
    }

    /// As many bits as said: the sign of a number, else zeros in front.
    #[track_caller]
    fn extend(self, width: u32) -> Self {
        let handle = self.handle();
        if width < handle.width {
            refuse(format!(
                "{} has more than {width} bits already",
                node_of(handle)
            ));
        }
        if width == handle.width {
            return self;
        }
        make(Op::Extend(handle.net), width)
    }

    /// 1 where both are equal.
    #[track_caller]
    fn equals(self, other: Self) -> Bits {
        compare(Binary::Equal, self, other)
    }

    /// 1 where it is this constant.
    #[track_caller]
    fn is(self, value: u64) -> Bits {
        self.equals(Self::literal(value, self.width()))
    }

    /// 1 where it is less.
    #[track_caller]
    fn less(self, other: Self) -> Bits {
        compare(Binary::Less, self, other)
    }
}

impl Value for Bits {
    const SIGNED: bool = false;

    fn handle(self) -> Handle {
        self.0
    }

    fn of(handle: Handle) -> Bits {
        Bits(handle)
    }
}

impl Value for Int {
    const SIGNED: bool = true;

    fn handle(self) -> Handle {
        self.0
    }

    fn of(handle: Handle) -> Int {
        Int(handle)
    }
}

/// One word behind the other, the highest first.
#[track_caller]
pub fn join<const N: usize>(parts: [Bits; N]) -> Bits {
    parts.iter().for_each(|part| in_scope(part.0));
    let width = parts.iter().map(|part| part.width()).sum();
    make(
        Op::Join(parts.iter().map(|part| part.0.net).collect()),
        width,
    )
}

/// All ones in so many bits.
pub(crate) fn mask(width: u32) -> u64 {
    u64::MAX >> (WIDEST - width)
}

/// A single bit passes through one register of as many bits, any other value through one register after the other.
#[track_caller]
pub(crate) fn delayed<V: Value>(value: V, name: Option<&str>, clocks: u32) -> V {
    let named = |value: Bits| name.map_or(value, |name| value.named(name));
    if value.width() > 1 || !(2..=WIDEST).contains(&clocks) {
        return (1..=clocks).fold(value, |value, clock| {
            let value = value.reg();
            name.map_or(value, |name| value.named(&format!("{name}_{clock}")))
        });
    }
    let line = named(Bits::register(clocks));
    line.load(join([line.slice(clocks - 2, 0), value.bit(0)]));
    V::of(line.top().0)
}

#[track_caller]
fn part<V: Value>(value: V, width: u32, low: u32) -> V {
    if width == value.width() {
        return value;
    }
    let part = value.slice(low + width - 1, low);
    V::of(match V::SIGNED {
        true => part.int().0,
        false => part.0,
    })
}

#[track_caller]
fn as_bits<V: Value>(value: V) -> Bits {
    let handle = value.handle();
    if !V::SIGNED {
        return Bits(handle);
    }
    in_scope(handle);
    make(Op::Same(handle.net), handle.width)
}

#[track_caller]
fn make<V: Value>(op: Op, width: u32) -> V {
    if !(1..=WIDEST).contains(&width) {
        refuse(format!("{width} bits: a value has 1 to {WIDEST}"));
    }
    if let Op::Literal(value) = op {
        fits(value, width);
    }
    let (net, scope) = add(op, width, V::SIGNED, Location::caller());
    V::of(Handle { net, scope, width })
}

#[track_caller]
fn fits(value: u64, width: u32) {
    if value & !mask(width) != 0 {
        refuse(format!("{value} has no {width} bits"));
    }
}

#[track_caller]
fn in_scope(handle: Handle) {
    if handle.scope != scope_of() {
        refuse(format!(
            "{} belongs to another module than the one that is being built",
            node_of(handle)
        ));
    }
}

#[track_caller]
fn same_width(what: &str, a: Handle, b: Handle) {
    in_scope(a);
    in_scope(b);
    if a.width != b.width {
        refuse(format!("{} {what} {}", node_of(a), node_of(b)));
    }
}

#[track_caller]
fn compare<V: Value>(binary: Binary, a: V, b: V) -> Bits {
    let [a, b] = [a.handle(), b.handle()];
    same_width("is compared with", a, b);
    make(Op::Binary(binary, a.net, b.net), 1)
}

#[track_caller]
fn load(register: Handle, enable: Option<Handle>, next: Handle) {
    same_width("is loaded with", register, next);
    if let Some(enable) = enable {
        in_scope(enable);
        if enable.width != 1 {
            refuse(format!("{} enables, but is no single bit", node_of(enable)));
        }
    }
    let mut was_free = true;
    edit_register(register, |own| {
        was_free = own.next.is_none();
        own.next = Some(next.net);
        own.enable = enable.map(|enable| enable.net);
    });
    if !was_free {
        refuse(format!("{} is loaded twice", node_of(register)));
    }
}

#[track_caller]
fn edit_register(handle: Handle, edit: impl FnOnce(&mut Register)) {
    in_scope(handle);
    let found = with_scope(|scope| match scope.module.nodes[handle.net.0 as usize].op {
        Op::Register(index) => {
            edit(&mut scope.module.registers[index]);
            true
        }
        _ => false,
    });
    if !found {
        refuse(format!("{} is no register", node_of(handle)));
    }
}

/// Values under the names of the variables that hold them.
///
/// ```
/// # use imogene_hdl::{Bits, Design, Value, net};
/// # Design::of(|| imogene_hdl::module("sum", "top", ("a", Bits::input(8)), |(_, a)| {
/// net! {
///     let twice = a + a;
///     let rest = !twice;
/// }
/// # ("rest", rest) }));
/// ```
#[macro_export]
macro_rules! net {
    ($(let $name:ident = $value:expr;)*) => {
        $(let $name = $crate::Value::named($value, stringify!($name));)*
    };
}
