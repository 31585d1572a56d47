//! Tuples as bundles and as ports.

use crate::bare::Ports;
use crate::bundle::{Bundle, Label};
use crate::scope::Handle;

macro_rules! tuples {
    ($(($($letter:ident $index:tt),*))*) => {$(
        impl<$($letter: Bundle),*> Bundle for ($($letter,)*) {
            fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {
                ($(self.$index.walked(group, other),)*)
            }
        }

        impl<$($letter: Ports),*> Ports for ($($letter,)*) {
            type Bare = ($($letter::Bare,)*);

            fn bare(self) -> Self::Bare {
                ($(self.$index.bare(),)*)
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
