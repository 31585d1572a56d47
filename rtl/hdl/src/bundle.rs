//! Groups of values that are ports together.

use crate::scope::Handle;
use crate::value::{Bits, Value, delayed, later};

/// What stands before the names and meanings of the members of a bundle, or of one member.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Label {
    /// Name.
    pub name: String,
    /// What it carries.
    pub meaning: String,
}

impl Label {
    /// The label of a member, behind this one. A name that begins with an underscore stands behind that of a member.
    pub fn member(&self, name: &str, meaning: &str) -> Label {
        let name = match (self.name.as_str(), name) {
            ("", name) => name.to_owned(),
            (group, "") => group.to_owned(),
            (group, name) if group.starts_with('_') => format!("{name}{group}"),
            (group, name) => format!("{group}_{name}"),
        };
        let meaning = match (self.meaning.as_str(), meaning) {
            ("", meaning) => meaning.to_owned(),
            (group, "") => group.to_owned(),
            (group, meaning) => format!("{group}: {meaning}"),
        };
        Label { name, meaning }
    }

    /// The label of a member with a number, which stands for `#` in the meaning.
    fn numbered(&self, index: usize) -> Label {
        let mut label = self.member(&index.to_string(), "");
        label.meaning = label.meaning.replace('#', &index.to_string());
        label
    }
}

/// Values with names, in an order.
pub trait Bundle: Sized {
    /// The same bundle of other values, of the same widths: calls back with each label, behind that of the group, and
    /// value.
    #[doc(hidden)]
    fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self;

    /// The same values, each called after this group and its member.
    fn called(self, group: &str) -> Self {
        let group = Label::default().member(group, "");
        self.walked(&group, &mut |label, value| Bits(value).named(&label.name).0)
    }

    /// All values one clock later.
    #[track_caller]
    fn registered(&self) -> Self {
        all_later(self, None)
    }

    /// All values one clock later, taken where `enable` is 1.
    #[track_caller]
    fn registered_when(&self, enable: Bits) -> Self {
        all_later(self, Some(enable))
    }

    /// All values so many clocks later, through registers that are called after them.
    #[track_caller]
    fn delayed(&self, clocks: u32) -> Self {
        let mut values = vec![];
        for (label, value) in members(self) {
            values.push(delayed(
                value,
                Some(&format!("{}_late", label.name)),
                clocks,
            ));
        }
        replaced(self, values)
    }
}

#[track_caller]
fn all_later<B: Bundle>(bundle: &B, enable: Option<Bits>) -> B {
    let mut values = vec![];
    for (_, value) in members(bundle) {
        values.push(later(value, enable));
    }
    replaced(bundle, values)
}

/// All members with their labels.
pub(crate) fn members(bundle: &impl Bundle) -> Vec<(Label, Handle)> {
    let mut found = vec![];
    bundle.walked(&Label::default(), &mut |label, value| {
        found.push((label, value));
        value
    });
    found
}

/// The same bundle of these values, in the order of its members.
pub(crate) fn replaced<B: Bundle>(bundle: &B, values: Vec<Handle>) -> B {
    let mut values = values.into_iter();
    bundle.walked(&Label::default(), &mut |_, _| {
        values.next().expect("as many values as members")
    })
}

/// A value is a bundle of one.
impl<V: Value> Bundle for V {
    fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {
        V::of(other(group.clone(), self.handle()))
    }
}

impl Bundle for () {
    fn walked(&self, _: &Label, _: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {}
}

/// A bundle under a name.
impl<B: Bundle> Bundle for (&'static str, B) {
    fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {
        (self.0, self.1.walked(&group.member(self.0, ""), other))
    }
}

/// A bundle under a name, with its meaning.
impl<B: Bundle> Bundle for (&'static str, B, &'static str) {
    fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {
        let value = self.1.walked(&group.member(self.0, self.2), other);
        (self.0, value, self.2)
    }
}

/// A member that may be missing.
impl<B: Bundle> Bundle for Option<B> {
    fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {
        self.as_ref().map(|one| one.walked(group, other))
    }
}

/// Members with numbers.
impl<B: Bundle> Bundle for Vec<B> {
    fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {
        let each = self.iter().enumerate();
        each.map(|(index, one)| one.walked(&group.numbered(index), other))
            .collect()
    }
}

/// Declares groups of ports: a structure of values, each with its kind, its width as a formula of the group's
/// parameters, and its meaning.
///
/// ```
/// use imogene_hdl::{Bundle, Design, Value, bundle, module};
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
/// let design = Design::of(|| module("hold", "top", Linear::input(26), |words| ("held", words.registered())));
/// let port = &design.top.ports[1];
/// assert_eq!((&*port.name, port.width, &*port.meaning), ("b", 26, "increment from line to line"));
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
            /// Values from outside of the design.
            #[allow(unused_variables)]
            pub fn input($($width: u32),*) -> $group {
                $group {
                    $($name: <$crate::$kind as $crate::Value>::input($bits),)*
                }
            }
        }

        $crate::bundle_of_fields! { $group { $($name stringify!($name), $meaning;)* } }
    )*};
}

/// Declares a structure of bundles, each with the name and the meaning that stand before those of its members. An empty
/// name stands before none; without a meaning the members have their own alone, and a comment documents the field.
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
///
/// With parameters, each field has its width or the parameters of its bundle, and the structure has an `input`.
///
/// ```
/// use imogene_hdl::{Bits, Bundle, Design, bundle, bundles, module};
/// bundle! {
///     /// A place on the screen.
///     Place(width) {
///         x: Bits(width), "column";
///         y: Bits(width), "line";
///     }
/// }
/// bundles! {
///     /// So many places, and the last one.
///     Way(places: u32) {
///         places: [Place(12); places] as "at", "place #";
///         last: Place(10) as "last", "last place";
///     }
/// }
/// let design = Design::of(|| module("hold", "top", Way::input(2), |way| ("held", way.registered())));
/// let port = &design.top.ports[3];
/// assert_eq!((&*port.name, port.width, &*port.meaning), ("at_1_y", 12, "place 1: line"));
/// ```
#[macro_export]
macro_rules! bundles {
    ($($(#[$about:meta])* $group:ident($($parameter:ident: $given:ty),*) {
        $($(#[$silent:meta])* $name:ident: $kind:tt $(($($width:expr),*))? as $prefix:literal $(, $meaning:literal)?;)*
    })*) => {
        $crate::bundles! {$(
            $(#[$about])*
            $group {
                $($(#[$silent])* $name: $crate::member_type!($kind) as $prefix $(, $meaning)?;)*
            }
        )*}

        $(impl $group {
            /// Values from outside of the design.
            pub fn input($($parameter: $given),*) -> $group {
                $group {
                    $($name: $crate::member_input!($kind $(($($width),*))?),)*
                }
            }
        })*
    };
    ($($(#[$about:meta])* $group:ident {
        $($(#[$silent:meta])* $name:ident: $kind:ty as $prefix:literal $(, $meaning:literal)?;)*
    })*) => {$(
        $(#[$about])*
        #[derive(Clone, Debug)]
        pub struct $group {
            $($(#[$silent])* $(#[doc = $meaning])? pub $name: $kind,)*
        }

        $crate::bundle_of_fields! { $group { $($name $prefix, concat!($($meaning)?);)* } }
    )*};
}

/// A structure as a bundle of its fields, each behind a name and a meaning.
#[doc(hidden)]
#[macro_export]
macro_rules! bundle_of_fields {
    ($group:ident { $($field:ident $name:expr, $meaning:expr;)* }) => {
        impl $crate::Plain for $group {}

        impl $crate::Bundle for $group {
            fn walked(
                &self,
                group: &$crate::Label,
                other: &mut dyn FnMut($crate::Label, $crate::Handle) -> $crate::Handle,
            ) -> Self {
                $group {
                    $($field: $crate::Bundle::walked(&self.$field, &group.member($name, $meaning), other),)*
                }
            }
        }
    };
}

/// The type of a field with its width or count.
#[doc(hidden)]
#[macro_export]
macro_rules! member_type {
    ([$kind:ident $widths:tt; $count:expr]) => { Vec<$kind> };
    ($kind:ident) => { $kind };
}

/// The input of a field with its width or count.
#[doc(hidden)]
#[macro_export]
macro_rules! member_input {
    ([$kind:ident $widths:tt; $count:expr]) => {
        (0..$count).map(|_| $crate::member_input!($kind $widths)).collect()
    };
    ($kind:ident($($width:expr),*)) => {{
        #[allow(unused_imports, reason = "words and numbers need it, bundles do not")]
        use $crate::Value as _;
        $kind::input($($width),*)
    }};
}
