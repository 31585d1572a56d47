//! The clock of a machine, estimated from the words of its slowest units.

use imogene_contract::RootForm;
use imogene_contract::words::quadratic;
use imogene_plan::description::MachineDescription;

/// Nanoseconds of a unit placed and routed alone: so many, and for each bit of its word or each light.
type Delay = [f64; 2];

/// One row of the root network, beside the registers; the first number for each.
const ROOT_ROW: Delay = [2.9, 0.035];
/// Registers around the rows of a stage.
const REGISTERS: f64 = 1.2;
/// A root of lines or parabolas, and about as much the shift before one of leading digits: `square_root_linear` of 16
/// and of 24 digits, 66.6 and 56.5 MHz.
const POLYNOMIAL: Delay = [9.6, 0.335];
/// Sums of the polynomials of second degree: PE2 of accumulators of 24, 32, 48 and 64 bits, 4.77 to 6.15 ns.
const QUADRATIC: Delay = [3.95, 0.0345];
/// The normal, and what compares depths: `normal_unit`, `plane_depth` and `decider` of 16 and of 24 bits, 5.1 to 6 ns.
const COMPARED: Delay = [4.9, 0.045];
/// The shading processor for each of its lights: placed and routed with one, 150.3 MHz, and with two, 101.6 MHz.
const SHADING: Delay = [3.45, 3.2];
/// Lit-sphere shading.
const LIT_SPHERE: f64 = 6.0;

fn delay([fixed, bit]: Delay, bits: u32) -> f64 {
    fixed + bit * f64::from(bits)
}

/// The clock of a machine in MHz on ECP5, speed grade 6; none for other devices.
pub fn estimate(machine: &MachineDescription, target: &str) -> Option<f64> {
    let words = machine.words();
    let rows = f64::from(machine.rows_per_stage);
    let rows_of_stage = REGISTERS + rows * delay(ROOT_ROW, words.root);
    let polynomial = delay(POLYNOMIAL, words.root);
    let root = match words.root_form {
        RootForm::Restoring | RootForm::NonRestoring | RootForm::Iterative => rows_of_stage,
        RootForm::Linear(_) | RootForm::Quadratic(_) => polynomial,
        RootForm::Leading(_) => rows_of_stage.max(polynomial),
    };
    let shading = match (machine.lights, machine.lit_sphere) {
        (0, None) => 0.0,
        (0, Some(_)) => LIT_SPHERE,
        (lights, _) => delay(SHADING, lights as u32),
    };
    let delays = [
        root,
        delay(QUADRATIC, quadratic(words.root) + words.guard_quadratic),
        delay(COMPARED, words.depth),
        shading,
    ];
    let slowest = delays.into_iter().fold(0.0, f64::max);
    target.starts_with("ecp5").then_some(1000.0 / slowest)
}
