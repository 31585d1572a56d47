//! A rough count of the logic cells of a machine, to try the cheap ones first. Costs that are reported come from
//! synthesis.

use imogene_contract::MachineWords;
use imogene_contract::slots::FittedSlot;

/// Logic cells of ECP5, from the costs of the units at 24 bits and how they grow with their words: adders and registers
/// in proportion, the root network with the square of its rows.
pub fn of_slot(widths: &MachineWords, slot: &FittedSlot) -> f64 {
    let widths = slot.words(widths);
    let [depth, root, plane, normal] =
        [widths.depth, widths.root, widths.plane, widths.normal].map(f64::from);
    let guards = [widths.guard_linear, widths.guard_quadratic].map(f64::from);
    let rows = root - f64::from(widths.dropped_rows);
    let halves = if slot.two_volumes { 2.0 } else { 1.0 };
    let linear = 5.0 * (depth + 2.0 + guards[0]);
    let quadratic = 11.0 * (2.0 * root + guards[1]);
    let network = 1.4 * rows * rows;
    let interval = 15.0 * depth + 10.0 * depth * (halves - 1.0);
    let planes = f64::from(slot.planes) * (6.0 * plane + 11.0 * depth * halves);
    let normals = 3.0 * (8.0 * (normal + 8.0) + 4.0 * normal);
    linear + quadratic + network + interval + planes + normals
}

#[cfg(test)]
mod tests {
    use super::*;
    use imogene_golden::format::Format;

    /// Within a quarter of what synthesis says of quadric processors at 24 bits (`docs/resources.md`): 2693 cells
    /// without planes, 4992 with three, 11783 with twelve.
    #[test]
    fn the_base_processor_is_about_as_large_as_synthesis_says() {
        for (planes, synthesised) in [(0, 2693.0), (3, 4992.0), (12, 11_783.0)] {
            let slot = FittedSlot::full(planes);
            let ratio = of_slot(&Format::BASE.widths(), &slot) / synthesised;
            assert!((0.75..1.25).contains(&ratio), "{planes} planes: {ratio}");
        }
    }
}
