//! Words and numbers, and what is done with them.

pub(crate) mod memory;
mod operators;

use crate::scope::{Handle, add, is_unregistered, refuse, with_scope};
use crate::tree::{Binary, Op, Register, WIDEST};
use std::mem::replace;
use std::panic::Location;

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
        self.handle().edit(|node| {
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
        let driven = Op::Forward(Some(other.net));
        if own.edit(|node| replace(&mut node.op, driven)) != Op::Forward(None) {
            refuse!("{own} is driven twice, or is no forward value");
        }
    }

    /// A register, 0 at power-up, that [`Value::load`] or [`Value::load_when`] gives an input.
    #[track_caller]
    fn register(width: u32) -> Self {
        let state = register(width, Self::SIGNED);
        edit_register(state, |register| register.is_state = true);
        Self::of(state)
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
        load(self.handle(), Some(enable), next.handle());
    }

    /// One clock later.
    #[track_caller]
    fn reg(self) -> Self {
        Self::of(later(self.handle(), None))
    }

    /// One clock later, taken where `enable` is 1.
    #[track_caller]
    fn reg_when(self, enable: Bits) -> Self {
        Self::of(later(self.handle(), Some(enable)))
    }

    /// So many clocks later.
    #[track_caller]
    fn delay(self, clocks: u32) -> Self {
        Self::of(delayed(self.handle(), None, clocks))
    }

    /// The same through registers with a name.
    #[track_caller]
    fn delayed_as(self, name: &str, clocks: u32) -> Self {
        Self::of(delayed(self.handle(), Some(name), clocks))
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
            refuse!("{handle} has no bits {high} to {low}");
        }
        if high - low + 1 == handle.width {
            return as_bits(handle);
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
            refuse!("{handle} has more than {width} bits already");
        }
        if width == handle.width {
            return self;
        }
        make(Op::Extend(handle.net), width)
    }

    /// 1 where both are equal.
    #[track_caller]
    fn equals(self, other: Self) -> Bits {
        binary("is compared with", Binary::Equal, self, other, 1)
    }

    /// 1 where it is this constant.
    #[track_caller]
    fn is(self, value: u64) -> Bits {
        self.equals(Self::literal(value, self.width()))
    }

    /// 1 where it is less.
    #[track_caller]
    fn less(self, other: Self) -> Bits {
        binary("is compared with", Binary::Less, self, other, 1)
    }
}

macro_rules! values {
    ($($value:ident: $signed:literal;)*) => {$(
        impl Value for $value {
            const SIGNED: bool = $signed;

            fn handle(self) -> Handle {
                self.0
            }

            fn of(handle: Handle) -> $value {
                let signed = $signed;
                $value(Handle { signed, ..handle })
            }
        }
    )*};
}

values! {
    Bits: false;
    Int: true;
}

/// One word behind the other, the highest first.
#[track_caller]
pub fn join<const N: usize>(parts: [Bits; N]) -> Bits {
    parts.iter().for_each(|part| part.0.check_scope());
    let width = parts.iter().map(|part| part.width()).sum();
    make(Op::Join(parts.map(|part| part.0.net).to_vec()), width)
}

/// All ones in so many bits.
pub(crate) fn mask(width: u32) -> u64 {
    u64::MAX >> (WIDEST - width)
}

#[track_caller]
fn make<V: Value>(op: Op, width: u32) -> V {
    V::of(made(op, width, V::SIGNED))
}

#[track_caller]
fn made(op: Op, width: u32, signed: bool) -> Handle {
    if !(1..=WIDEST).contains(&width) {
        refuse!("{width} bits: a value has 1 to {WIDEST}");
    }
    if let Op::Literal(value) = op {
        fits(value, width);
    }
    add(op, width, signed, Location::caller())
}

#[track_caller]
fn fits(value: u64, width: u32) {
    if value & !mask(width) != 0 {
        refuse!("{value} has no {width} bits");
    }
}

#[track_caller]
fn as_bits(value: Handle) -> Bits {
    if !value.signed {
        return Bits(value);
    }
    value.check_scope();
    make(Op::Same(value.net), value.width)
}

#[track_caller]
fn part<V: Value>(value: V, width: u32, low: u32) -> V {
    if width == value.width() {
        return value;
    }
    let part = value.slice(low + width - 1, low).0;
    match V::SIGNED {
        true => make(Op::Same(part.net), width),
        false => V::of(part),
    }
}

/// An operation on two values of the same width.
#[track_caller]
fn binary<V: Value, R: Value>(what: &str, binary: Binary, a: V, b: V, width: u32) -> R {
    let [a, b] = [a.handle(), b.handle()];
    same_width(what, a, b);
    make(Op::Binary(binary, a.net, b.net), width)
}

#[track_caller]
fn same_width(what: &str, a: Handle, b: Handle) {
    a.check_scope();
    b.check_scope();
    if a.width != b.width {
        refuse!("{a} {what} {b}");
    }
}

#[track_caller]
fn single_bit(value: Bits, what: &str) {
    value.0.check_scope();
    if value.width() != 1 {
        refuse!("{} {what}, but is no single bit", value.0);
    }
}

#[track_caller]
fn register(width: u32, signed: bool) -> Handle {
    let index = with_scope(|scope| scope.module.registers.len());
    let value = made(Op::Register(index), width, signed);
    let register = Register {
        net: value.net,
        next: None,
        enable: None,
        initial: 0,
        is_state: false,
    };
    with_scope(|scope| scope.module.registers.push(register));
    value
}

#[track_caller]
fn edit_register<T>(handle: Handle, edit: impl FnOnce(&mut Register) -> T) -> T {
    handle.check_scope();
    let edited = with_scope(|scope| match scope.module.node(handle.net).op {
        Op::Register(index) => Some(edit(&mut scope.module.registers[index])),
        _ => None,
    });
    edited.unwrap_or_else(|| refuse!("{handle} is no register"))
}

#[track_caller]
fn load(register: Handle, enable: Option<Bits>, next: Handle) {
    same_width("is loaded with", register, next);
    if let Some(enable) = enable {
        single_bit(enable, "enables");
    }
    let before = edit_register(register, |own| {
        own.enable = enable.map(|enable| enable.0.net);
        own.next.replace(next.net)
    });
    if before.is_some() {
        refuse!("{register} is loaded twice");
    }
}

/// One clock later, taken where the enable is 1.
#[track_caller]
pub(crate) fn later(value: Handle, enable: Option<Bits>) -> Handle {
    if enable.is_none() && is_unregistered() {
        return value;
    }
    let register = register(value.width, value.signed);
    load(register, enable, value);
    register
}

/// A single bit passes through one register of as many bits, any other value through one register after the other.
#[track_caller]
pub(crate) fn delayed(value: Handle, name: Option<&str>, clocks: u32) -> Handle {
    if value.width > 1 || !(2..=WIDEST).contains(&clocks) || is_unregistered() {
        return (1..=clocks).fold(value, |value, clock| {
            let value = later(value, None);
            let name = name.map(|name| format!("{name}_{clock}"));
            name.map_or(value, |name| Bits(value).named(&name).0)
        });
    }
    let line = Bits(register(clocks, false));
    name.map(|name| line.named(name));
    line.load(join([line.slice(clocks - 2, 0), as_bits(value)]));
    line.top().0
}

/// Values under the names of the variables that hold them.
///
/// ```
/// # use imogene_hdl::{Bits, Design, Value, net};
/// # Design::of(|| imogene_hdl::module("sum", "top", ("a", Bits::input(8)), |a| {
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
