//! Parts that are alike.

/// Each item with the name of its instance in a row: that of the row and a number.
pub(crate) fn numbered<I: IntoIterator>(
    row: &str,
    items: I,
) -> impl Iterator<Item = (String, I::Item)> + use<I> {
    let row = row.to_owned();
    let items = items.into_iter().enumerate();
    items.map(move |(index, item)| (format!("{row}_{index}"), item))
}

/// For bundles whose members are alike: to make one of them, and to take it apart.
macro_rules! alike {
    ($($group:ident: [$kind:ident; $count:literal] { $($name:ident)* })*) => {$(
        impl $group {
            /// One of its members, in their order.
            pub fn of([$($name),*]: [$kind; $count]) -> $group {
                $group { $($name),* }
            }

            /// Its members, in their order.
            pub fn parts(self) -> [$kind; $count] {
                [$(self.$name),*]
            }

            /// What becomes of each member.
            pub fn map(self, change: impl FnMut($kind) -> $kind) -> $group {
                $group::of(self.parts().map(change))
            }
        }
    )*};
}

pub(crate) use alike;
