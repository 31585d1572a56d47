//! How many runs of a module lie side by side.

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Lanes {
    One,
    /// Of parts of what runs in one lane.
    Four,
    /// Of a whole program: vectors of four words, two for each net of more than 32 bits and one for every other.
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

    /// Those of what is called by what has these.
    pub(crate) fn of_called(self) -> Lanes {
        match self {
            Lanes::One => Lanes::Four,
            lanes => lanes,
        }
    }
}
