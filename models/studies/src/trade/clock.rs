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
/// What compares depths, the slowest that takes one: `decider` of 16 and of 24 bits, 5.13 and 5.5 ns.
const COMPARED: Delay = [4.4, 0.046];
/// The shading processor for each of its lights: placed and routed with one, 155.0 MHz, and with two, 153.0 MHz.
const SHADING: Delay = [6.36, 0.09];
/// Lit-sphere shading between entries and by the nearest one, 180.0 and 164.5 MHz.
const BETWEEN: f64 = 5.56;
const NEAREST: f64 = 6.08;

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
        (0, Some(form)) if form.nearest => NEAREST,
        (0, Some(_)) => BETWEEN,
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
