//! What is stated of a unit.

use crate::parameters::Parameter;

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
