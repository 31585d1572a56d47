//! The clock of a machine, estimated from the words of its slowest units.

use imogene_contract::RootForm;
use imogene_plan::description::MachineDescription;

/// Nanoseconds of a unit placed and routed alone: so many, and for each bit of its word or each light.
struct Delay {
    fixed: f64,
    bit: f64,
}

/// One row of the root network, beside the registers; of `fixed` for each.
const ROOT_ROW: Delay = Delay {
    fixed: 2.9,
    bit: 0.035,
};
/// Registers around the rows of a stage.
const REGISTERS: f64 = 1.2;
/// A root of lines or parabolas, and about as much the shift before one of leading digits: `square_root_linear` of 16
/// and of 24 digits, 66.6 and 56.5 MHz.
const POLYNOMIAL: Delay = Delay {
    fixed: 9.6,
    bit: 0.335,
};
const NORMAL: Delay = Delay {
    fixed: 7.5,
    bit: 0.2,
};
/// Cut planes and intervals, which compare depths.
const COMPARED: Delay = Delay {
    fixed: 6.0,
    bit: 0.15,
};
/// The shading processor, whose words follow from no other: for each of its lights, placed and routed with one and two.
const SHADING: Delay = Delay {
    fixed: 14.64,
    bit: 2.95,
};

impl Delay {
    fn of(&self, bits: u32) -> f64 {
        self.fixed + self.bit * f64::from(bits)
    }
}

/// The clock of a machine in MHz on ECP5, speed grade 6; none for other devices.
pub fn estimate(machine: &MachineDescription, target: &str) -> Option<f64> {
    let words = machine.words();
    let rows = f64::from(machine.rows_per_stage);
    let rows_of_stage = REGISTERS + rows * ROOT_ROW.of(words.root);
    let polynomial = POLYNOMIAL.of(words.root);
    let root = match words.root_form {
        RootForm::Restoring | RootForm::NonRestoring => rows_of_stage,
        RootForm::Linear(_) | RootForm::Quadratic(_) => polynomial,
        RootForm::Leading(_) => rows_of_stage.max(polynomial),
    };
    let delays = [
        root,
        NORMAL.of(words.normal),
        COMPARED.of(words.depth),
        SHADING.of(machine.lights as u32),
    ];
    let slowest = delays.into_iter().fold(0.0, f64::max);
    target.starts_with("ecp5").then_some(1000.0 / slowest)
}
