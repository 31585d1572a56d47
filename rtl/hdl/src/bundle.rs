//! Groups of values that are ports together.

use crate::value::{Bits, Handle, Int, Value, delayed};

/// A value of a bundle.
#[derive(Clone, Copy, Debug)]
pub struct Member {
    pub(crate) handle: Handle,
    /// A two's complement number.
    pub signed: bool,
}

/// Values with names, in an order.
pub trait Bundle {
    /// Calls back with each name, behind that of the group, and value.
    fn each(&self, group: &str, found: &mut dyn FnMut(String, Member));

    /// The same bundle of other values, of the same widths.
    #[doc(hidden)]
    fn rebuilt(&self, other: &mut dyn FnMut(Member) -> Handle) -> Self;

    /// The same values, each called after this group and its member.
    fn called(self, group: &str) -> Self
    where
        Self: Sized,
    {
        self.each(group, &mut |name, member| {
            Bits(member.handle).named(&name);
        });
        self
    }

    /// All values one clock later.
    #[track_caller]
    fn registered(&self) -> Self
    where
        Self: Sized,
    {
        later(self, |_| None, 1)
    }

    /// All values one clock later, taken where `enable` is 1.
    #[track_caller]
    fn registered_when(&self, enable: Bits) -> Self
    where
        Self: Sized,
    {
        let mut values = vec![];
        for (_, Member { handle, signed }) in members(self) {
            values.push(match signed {
                true => Int(handle).reg_when(enable).0,
                false => Bits(handle).reg_when(enable).0,
            });
        }
        replaced(self, values)
    }

    /// All values so many clocks later, through registers that are called after them.
    #[track_caller]
    fn delayed(&self, clocks: u32) -> Self
    where
        Self: Sized,
    {
        later(self, |name| Some(format!("{name}_late")), clocks)
    }
}

#[track_caller]
fn later<B: Bundle>(bundle: &B, name: fn(String) -> Option<String>, clocks: u32) -> B {
    let mut values = vec![];
    for (member, Member { handle, signed }) in members(bundle) {
        let name = name(member);
        values.push(match signed {
            true => delayed(Int(handle), name.as_deref(), clocks).0,
            false => delayed(Bits(handle), name.as_deref(), clocks).0,
        });
    }
    replaced(bundle, values)
}

/// All members with their names.
pub(crate) fn members(bundle: &impl Bundle) -> Vec<(String, Member)> {
    let mut found = vec![];
    bundle.each("", &mut |name, member| found.push((name, member)));
    found
}

/// The same bundle of these values, in the order of its members.
pub(crate) fn replaced<B: Bundle>(bundle: &B, values: Vec<Handle>) -> B {
    let mut values = values.into_iter();
    bundle.rebuilt(&mut |_| values.next().expect("as many values as members"))
}

/// What a bundle says of a port.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Meaning {
    /// Name within its group.
    pub name: &'static str,
    /// Bits.
    pub width: u32,
    /// A two's complement number.
    pub signed: bool,
    /// What it carries.
    pub meaning: &'static str,
}

/// The name of a member of a group; one that begins with an underscore stands behind the name.
#[doc(hidden)]
pub fn member_name(group: &str, name: &str) -> String {
    match (group, name) {
        ("", name) => name.to_owned(),
        (group, "") => group.to_owned(),
        (group, name) if group.starts_with('_') => format!("{name}{group}"),
        _ => format!("{group}_{name}"),
    }
}

fn member<V: Value>(value: &V) -> Member {
    Member {
        handle: value.handle(),
        signed: V::SIGNED,
    }
}

macro_rules! bundle_of_one {
    ($($value:ident)*) => {$(
        impl Bundle for $value {
            fn each(&self, group: &str, found: &mut dyn FnMut(String, Member)) {
                found(group.to_owned(), member(self));
            }

            fn rebuilt(&self, other: &mut dyn FnMut(Member) -> Handle) -> Self {
                $value(other(member(self)))
            }
        }
    )*};
}

bundle_of_one! { Bits Int }

impl Bundle for () {
    fn each(&self, _: &str, _: &mut dyn FnMut(String, Member)) {}

    fn rebuilt(&self, _: &mut dyn FnMut(Member) -> Handle) -> Self {}
}

/// A bundle under a name.
impl<B: Bundle> Bundle for (&'static str, B) {
    fn each(&self, group: &str, found: &mut dyn FnMut(String, Member)) {
        self.1.each(&member_name(group, self.0), found);
    }

    fn rebuilt(&self, other: &mut dyn FnMut(Member) -> Handle) -> Self {
        (self.0, self.1.rebuilt(other))
    }
}

/// Members with numbers.
impl<B: Bundle> Bundle for Vec<B> {
    fn each(&self, group: &str, found: &mut dyn FnMut(String, Member)) {
        for (index, one) in self.iter().enumerate() {
            one.each(&member_name(group, &index.to_string()), found);
        }
    }

    fn rebuilt(&self, other: &mut dyn FnMut(Member) -> Handle) -> Self {
        self.iter().map(|one| one.rebuilt(other)).collect()
    }
}

macro_rules! tuples {
    ($(($($letter:ident $index:tt),*))*) => {$(
        impl<$($letter: Bundle),*> Bundle for ($($letter,)*) {
            fn each(&self, group: &str, found: &mut dyn FnMut(String, Member)) {
                $(self.$index.each(group, found);)*
            }

            fn rebuilt(&self, other: &mut dyn FnMut(Member) -> Handle) -> Self {
                ($(self.$index.rebuilt(other),)*)
            }
        }
    )*};
}

tuples! {
    (A 0, B 1)
    (A 0, B 1, C 2)
    (A 0, B 1, C 2, D 3)
    (A 0, B 1, C 2, D 3, E 4)
}

/// Declares groups of ports: a structure of values, each with its kind, its width as a formula of the group's
/// parameters, and its meaning.
///
/// ```
/// use imogene_hdl::{Value, bundle};
///
/// bundle! {
///     /// Words of `a x + b y + c`.
///     Linear(width) {
///         a: Int(width), "increment along the line";
///         b: Int(width), "increment from line to line";
///         c: Int(width), "value of the first pixel";
///     }
/// }
///
/// let ports = Linear::ports(26);
/// assert_eq!((ports[1].name, ports[1].width, ports[1].meaning), ("b", 26, "increment from line to line"));
/// ```
#[macro_export]
macro_rules! bundle {
    ($($(#[$about:meta])* $group:ident($($width:ident),*) {
        $($name:ident: $kind:ident($bits:expr), $meaning:literal;)*
    })*) => {$(
        $(#[$about])*
        #[derive(Clone, Copy, Debug)]
        pub struct $group {
            $(#[doc = $meaning] pub $name: $crate::$kind,)*
        }

        impl $group {
            /// Its members in order.
            #[allow(unused_variables)]
            pub fn ports($($width: u32),*) -> Vec<$crate::Meaning> {
                vec![$($crate::Meaning {
                    name: stringify!($name),
                    width: $bits,
                    signed: <$crate::$kind as $crate::Value>::SIGNED,
                    meaning: $meaning,
                }),*]
            }

            /// Values from outside of the design.
            #[allow(unused_variables)]
            pub fn input($($width: u32),*) -> $group {
                $group {
                    $($name: <$crate::$kind as $crate::Value>::input($bits),)*
                }
            }
        }

        impl $crate::Bundle for $group {
            fn each(&self, group: &str, found: &mut dyn FnMut(String, $crate::Member)) {
                $($crate::Bundle::each(
                    &self.$name,
                    &$crate::member_name(group, stringify!($name)),
                    found,
                );)*
            }

            fn rebuilt(&self, other: &mut dyn FnMut($crate::Member) -> $crate::Handle) -> Self {
                $group {
                    $($name: $crate::Bundle::rebuilt(&self.$name, other),)*
                }
            }
        }
    )*};
}

/// Declares a structure of bundles, each with the name that stands before those of its members; an empty one stands
/// before none.
///
/// ```
/// use imogene_hdl::{bundle, bundles};
/// bundle! {
///     /// A place on the screen.
///     Place() {
///         x: Bits(12), "column";
///         y: Bits(12), "line";
///     }
/// }
/// bundles! {
///     /// Two corners: ports `first_x`, `first_y`, `last_x`, `last_y`.
///     Window {
///         first: Place as "first", "upper left";
///         last: Place as "last", "lower right";
///     }
/// }
/// ```
#[macro_export]
macro_rules! bundles {
    ($($(#[$about:meta])* $group:ident {
        $($name:ident: $kind:ty as $prefix:literal, $meaning:literal;)*
    })*) => {$(
        $(#[$about])*
        #[derive(Clone, Debug)]
        pub struct $group {
            $(#[doc = $meaning] pub $name: $kind,)*
        }

        impl $crate::Bundle for $group {
            fn each(&self, group: &str, found: &mut dyn FnMut(String, $crate::Member)) {
                $($crate::Bundle::each(&self.$name, &$crate::member_name(group, $prefix), found);)*
            }

            fn rebuilt(&self, other: &mut dyn FnMut($crate::Member) -> $crate::Handle) -> Self {
                $group {
                    $($name: $crate::Bundle::rebuilt(&self.$name, other),)*
                }
            }
        }
    )*};
}
