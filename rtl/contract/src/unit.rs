//! What is stated of a unit, and what follows from it.

pub use crate::catalogue::Unit;
use crate::parameters::Parameter;
use crate::request::RequestError;
use crate::words::LEAST_DEPTH;

/// What is stated of a unit besides its ports, which its circuit declares.
#[derive(Clone, Copy, Debug)]
pub struct Record {
    /// Name of the unit, its file and its Verilog module.
    pub name: &'static str,
    /// What it computes, in one sentence.
    pub computes: &'static str,
    /// Where it comes from.
    pub source: &'static str,
    /// Its parameters besides the format.
    pub parameters: &'static [Parameter],
    /// Clocks from an input to its result: a formula in the symbols of its parameters, `W` the depth word.
    pub latency: &'static str,
    /// Results per clock.
    pub throughput: &'static str,
    /// What happens at equality.
    pub ties: &'static str,
    /// How far results are from what it computes: exact, a bound, or a measured maximum. `{W - D}` stands for the value
    /// of a formula, `{C: 6, 1}` for the first or second of the list as `C` is 0 or 1.
    pub error: &'static str,
}

impl Unit {
    /// Name of the unit, its file and its Verilog module.
    pub const fn name(self) -> &'static str {
        self.record().name
    }

    /// The unit of a name.
    ///
    /// # Errors
    ///
    /// When there is none; the error lists the names.
    pub fn from_name(name: &str) -> Result<Unit, RequestError> {
        let found = Unit::ALL.into_iter().find(|unit| unit.name() == name);
        found.ok_or_else(|| RequestError::Unit {
            name: name.to_owned(),
        })
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
