//! What follows from the record of a unit.

pub use crate::catalogue::Unit;
use crate::words::LEAST_DEPTH;

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

    /// Has it a parameter of this option?
    pub fn has(self, option: &str) -> bool {
        let mut parameters = self.record().parameters.iter();
        parameters.any(|parameter| parameter.option == option)
    }
}
