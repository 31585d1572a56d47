//! How many runs of a module lie side by side.

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Lanes {
    One,
    /// Of parts of what runs in one lane.
    Four,
    /// Of parts likewise, or of a whole program: vectors of four words, two for each net of more than 32 bits and one
    /// for every other.
    Eight,
}

pub(crate) const MOST_LANES: usize = Lanes::Eight.count();

impl Lanes {
    pub(crate) const fn count(self) -> usize {
        match self {
            Lanes::One => 1,
            Lanes::Four => 4,
            Lanes::Eight => 8,
        }
    }

    /// How many words of 64 bits a vector has.
    pub(crate) const fn in_vector(self) -> usize {
        match self {
            Lanes::One => 1,
            Lanes::Four | Lanes::Eight => 4,
        }
    }

    /// All lanes of the parts of a program with these, its own in front.
    pub(crate) fn with_those_of_parts(self) -> &'static [Lanes] {
        match self {
            Lanes::One => &[Lanes::One, Lanes::Four, Lanes::Eight],
            Lanes::Four => &[Lanes::Four],
            Lanes::Eight => &[Lanes::Eight],
        }
    }
}
