//! What follows from the record of a unit.

pub use crate::catalogue::Unit;
use crate::words::LEAST_DEPTH;

/// The root of an object in the latencies of records; another form of it takes its place. A latency that
/// ends with its rows has none.
pub(crate) const OBJECT_ROOT: &str = "ceil(W / R) +";

impl Unit {
    /// Name of the unit, its file and its Verilog module.
    pub const fn name(self) -> &'static str {
        self.record().name
    }

    /// The least depth word that it is built for.
    pub const fn least_word(self) -> u32 {
        match self {
            // Its parabolas read a bit of the square by its place.
            Unit::SquareRootQuadratic => 12,
            _ => LEAST_DEPTH,
        }
    }

    /// Does it take the root of an object, which has several forms?
    pub fn has_object_root(self) -> bool {
        self.record().latency.contains(OBJECT_ROOT)
    }

    /// Has it a parameter of this option?
    pub fn has(self, option: &str) -> bool {
        let mut parameters = self.record().parameters.iter();
        parameters.any(|parameter| parameter.option == option)
    }
}
