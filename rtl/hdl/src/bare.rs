//! Ports without their names.

use crate::bundle::Bundle;
use crate::value::{Bits, Int};

/// Values that are ports of a module. The names and meanings around a bundle are for its ports alone: what builds the
/// module, and who uses it, have the bare values.
pub trait Ports: Bundle {
    /// The values.
    type Bare;

    /// The values without what stands around them.
    fn bare(self) -> Self::Bare;
}

/// A bundle with nothing around it.
pub trait Plain: Bundle {}

impl<B: Plain> Ports for B {
    type Bare = B;

    fn bare(self) -> B {
        self
    }
}

impl Plain for Bits {}
impl Plain for Int {}
impl Plain for () {}
impl<B: Plain> Plain for Option<B> {}
impl<B: Plain> Plain for Vec<B> {}

impl<B: Ports> Ports for (&'static str, B) {
    type Bare = B::Bare;

    fn bare(self) -> B::Bare {
        self.1.bare()
    }
}

impl<B: Ports> Ports for (&'static str, B, &'static str) {
    type Bare = B::Bare;

    fn bare(self) -> B::Bare {
        self.1.bare()
    }
}

/// Ports under the names of the variables that hold their values: `ports!(a, b)` is `(("a", a), ("b", b))`.
#[macro_export]
macro_rules! ports {
    ($($name:ident),+) => {
        ($((stringify!($name), $name)),+)
    };
}
