//! Parts that are alike.

use imogene_hdl::{Bundle, Handle, Label, Ports};

/// Each item with the name of its instance in a row: that of the row and a number.
pub(crate) fn numbered<I: IntoIterator>(
    row: &str,
    items: I,
) -> impl Iterator<Item = (String, I::Item)> + use<I> {
    let row = row.to_owned();
    let items = items.into_iter().enumerate();
    items.map(move |(index, item)| (format!("{row}_{index}"), item))
}

/// One of each lane in which pixels are drawn at once. Ports have the number of their lane where there are several.
#[derive(Clone, Debug)]
pub struct PerLane<T>(pub Vec<T>);

impl<T> PerLane<T> {
    /// One for each of so many lanes.
    pub(crate) fn of(lanes: u32, one: impl FnMut(u32) -> T) -> PerLane<T> {
        PerLane((0..lanes).map(one).collect())
    }

    /// What becomes of each.
    pub(crate) fn map<U>(self, change: impl FnMut(T) -> U) -> PerLane<U> {
        PerLane(self.0.into_iter().map(change).collect())
    }

    /// That of a machine of one lane.
    pub(crate) fn alone(mut self) -> T {
        assert_eq!(self.0.len(), 1, "a machine of one lane");
        self.0.remove(0)
    }
}

impl<B: Bundle> Bundle for PerLane<B> {
    fn walked(&self, group: &Label, other: &mut dyn FnMut(Label, Handle) -> Handle) -> Self {
        if let [alone] = self.0.as_slice() {
            return PerLane(vec![alone.walked(group, other)]);
        }
        let lane = if group.name.is_empty() { "lane" } else { "" };
        PerLane(self.0.walked(&group.member(lane, ""), other))
    }
}

impl<B: Ports> Ports for PerLane<B> {
    type Bare = PerLane<B::Bare>;

    fn bare(self) -> Self::Bare {
        self.map(B::bare)
    }
}

/// The name of a part of a lane, where there are several.
pub(crate) fn in_lane(name: &str, lane: u32, lanes: u32) -> String {
    match lanes {
        1 => name.to_owned(),
        _ => format!("{name}_lane_{lane}"),
    }
}

/// Declares groups of ports whose members are alike: a bundle, what makes one of its members and what takes it apart.
macro_rules! alike {
    ($($(#[$about:meta])* $group:ident($($width:ident),*): [$kind:ident($bits:expr); $count:literal] {
        $($name:ident, $meaning:literal;)*
    })*) => {
        imogene_hdl::bundle! {$(
            $(#[$about])*
            $group($($width),*) { $($name: $kind($bits), $meaning;)* }
        )*}

        $(impl $group {
            /// One of its members, in their order.
            pub fn of([$($name),*]: [imogene_hdl::$kind; $count]) -> $group {
                $group { $($name),* }
            }

            /// Its members, in their order.
            pub fn parts(self) -> [imogene_hdl::$kind; $count] {
                [$(self.$name),*]
            }

            /// What becomes of each member.
            pub fn map(self, change: impl FnMut(imogene_hdl::$kind) -> imogene_hdl::$kind) -> $group {
                $group::of(self.parts().map(change))
            }
        })*
    };
}

pub(crate) use alike;
